//! From the texts of programs to programs.

use std::collections::BTreeMap;
use std::sync::Arc;

use glanz_scene::{ColorMode, Program, ProgramText, Scene, UniformValue};
use glanz_shader::{Pair, Place, Scalar, Shader, ShaderError, Stage, UniformError};

use crate::prepare::color::observation::Observation;
use crate::prepare::{PrepareError, PreparedProgram};

/// A program of the scene that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{error}")]
pub struct ProgramError {
    /// What is wrong, and where.
    pub error: ShaderError,
    /// The texts of the program, by the names that places have.
    pub texts: BTreeMap<String, String>,
}

/// All programs of a scene, compiled; those that are known already are taken as they are.
pub(crate) fn programs(
    scene: &Scene,
    observation: &Observation,
    known: &[Arc<PreparedProgram>],
) -> Result<Vec<Arc<PreparedProgram>>, PrepareError> {
    let index = scene.objects.iter().map(|object| object.program).chain([scene.program]).flatten();
    if let Some(missing) = index.into_iter().find(|index| *index >= scene.programs.len()) {
        return Err(PrepareError::Scene { what: format!("program {missing} is not there") });
    }
    if !scene.programs.is_empty() && observation.mode() == ColorMode::Reference {
        let what = "a program gives colours and no spectra, which mode 'reference' adds up; choose 'rgb' or 'spectral'";
        return Err(PrepareError::Scene { what: what.to_owned() });
    }
    let sizes: Vec<_> = scene.textures.iter().map(|own| [own.width, own.height]).collect();
    let of = |program: &Program| match known.iter().find(|own| own.source == *program) {
        Some(own) => Ok(Arc::clone(own)),
        None => compiled(program, &sizes),
    };
    scene.programs.iter().map(of).collect()
}

/// A program with its stages compiled and its uniforms checked. `textures`: how large those of the scene are.
pub(crate) fn compiled(
    program: &Program,
    textures: &[[u32; 2]],
) -> Result<Arc<PreparedProgram>, PrepareError> {
    let wrong =
        |error: ShaderError| PrepareError::from(Box::new(ProgramError { error, texts: texts(program) }));
    let pair = pair(program, false).map_err(wrong)?;
    for (name, value) in &program.uniforms {
        check(&pair, name, value, textures).map_err(wrong)?;
    }
    let color = color_output(&pair);
    if color.is_none() {
        let message = "the fragment shader writes no colour: it needs 'out vec4 …'".to_owned();
        return Err(wrong(ShaderError::Invalid { message, place: None, hints: vec![] }));
    }
    Ok(Arc::new(PreparedProgram { source: program.clone(), pair, color }))
}

/// Both stages, compiled for traces.
pub(crate) fn traced_pair(program: &Program) -> Result<Pair, ShaderError> {
    pair(program, true)
}

/// Compiles both stages.
pub(crate) fn pair(program: &Program, traced: bool) -> Result<Pair, ShaderError> {
    type Include<'a> = Box<dyn Fn(&str, &str) -> Option<String> + Sync + 'a>;
    let stage = |stage: Stage, text: &ProgramText| {
        let shader = Shader::new(stage, text.text.clone()).named(&text.name);
        if traced { shader.traced() } else { shader }
    };
    let includes = |text: Option<&ProgramText>| -> Include<'_> {
        let files = text.map(|text| text.includes.clone()).unwrap_or_default();
        Box::new(move |path: &str, _: &str| files.get(path).cloned())
    };
    let (of_vertex, of_fragment) = (includes(program.vertex.as_ref()), includes(program.fragment.as_ref()));
    let vertex = program.vertex.as_ref().map(|text| stage(Stage::Vertex, text).include(&*of_vertex));
    let fragment = program.fragment.as_ref().map(|text| stage(Stage::Fragment, text).include(&*of_fragment));
    Pair::new(vertex.as_ref(), fragment.as_ref())
}

/// The output at location 0, else the first of three or four numbers.
fn color_output(pair: &Pair) -> Option<usize> {
    let outputs = &pair.fragment.interface().outputs;
    let could_be = |port: &glanz_shader::Port| {
        !port.builtin && port.ty.scalar == Scalar::Float && port.ty.columns == 1 && port.ty.rows >= 3
    };
    let first = outputs.iter().position(|port| could_be(port) && port.location == Some(0));
    first.or_else(|| outputs.iter().position(could_be))
}

/// All texts by name.
fn texts(program: &Program) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for text in [&program.vertex, &program.fragment].into_iter().flatten() {
        all.extend(text.includes.clone());
        all.insert(text.name.clone(), text.text.clone());
    }
    all
}

/// That a value can be given to a uniform of the program.
fn check(pair: &Pair, name: &str, value: &UniformValue, textures: &[[u32; 2]]) -> Result<(), ShaderError> {
    let stages = [&pair.vertex, &pair.fragment];
    let invalid =
        |message: String, place: Option<Place>| ShaderError::Invalid { message, place, hints: vec![] };
    match value {
        UniformValue::Texture(_) | UniformValue::Cube(_) => {
            check_pictures(&stages, name, value, textures).map_err(|message| invalid(message, None))
        }
        UniformValue::Numbers(numbers) => {
            let mut error = None;
            for stage in stages {
                match super::super::program_values::set(&mut stage.uniforms(), stage, name, numbers) {
                    Ok(()) => return Ok(()),
                    Err(other @ UniformError::Count { .. }) => error = Some(other),
                    Err(UniformError::Unknown { .. }) => {}
                }
            }
            let Some(error) = error else {
                let own = |stage: &&glanz_shader::Program| stage.interface().uniforms.clone();
                let names: Vec<String> = stages.iter().flat_map(own).map(|uniform| uniform.name).collect();
                let hint = glanz_math::names::did_you_mean(name, names.iter().map(String::as_str));
                return Err(invalid(format!("there is no uniform '{name}' in the program{hint}"), None));
            };
            let place = stages.iter().find_map(|own| own.interface().uniform(name)?.place.clone());
            Err(invalid(error.to_string(), place))
        }
    }
}

/// That a sampler of this name can look into the pictures.
fn check_pictures(
    stages: &[&glanz_shader::Program],
    name: &str,
    value: &UniformValue,
    textures: &[[u32; 2]],
) -> Result<(), String> {
    let indices = value.textures();
    if indices.iter().any(|index| *index >= textures.len()) {
        return Err(format!("the texture of '{name}' is not there"));
    }
    let samplers = || stages.iter().flat_map(|own| &own.interface().textures);
    let Some(sampler) = samplers().find(|own| own.name == name) else {
        let hint = glanz_math::names::did_you_mean(name, samplers().map(|own| own.name.as_str()));
        return Err(format!("there is no sampler '{name}' in the program{hint}"));
    };
    let is_cube = matches!(value, UniformValue::Cube(_));
    let is_known = matches!((sampler.dimension, sampler.compared), ("2d", _) | ("cube", false));
    if sampler.layered || !is_known {
        return Err(format!(
            "the sampler '{name}' takes no picture: only sampler2D, sampler2DShadow and samplerCube do"
        ));
    }
    if is_cube && sampler.dimension != "cube" {
        return Err(format!("the sampler '{name}' takes one picture: six are the faces of a samplerCube"));
    }
    let size = |index: &usize| textures[*index];
    let is_odd = |[width, height]: &[u32; 2]| width != height || [*width, *height] != size(&indices[0]);
    match indices.iter().map(size).find(is_odd) {
        Some([width, height]) if is_cube => Err(format!(
            "the faces of the cube map '{name}' must be squares of one size: one has {width}×{height} texels"
        )),
        _ => Ok(()),
    }
}
