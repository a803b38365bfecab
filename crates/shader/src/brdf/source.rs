//! The text of a BRDF.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use glanz_bsdf::{ModelInfo, ModelSource, Side};

use super::inputs::Inputs;
use super::model::Code;
use super::{Brdf, expression, info, parameters};
use crate::intake::{Include, included_path};
use crate::machine::Code as OpCode;
use crate::{Program, Scalar, Shader, ShaderError};

/// The longest name of an expression.
const LONGEST_NAME: usize = 48;

/// The text of a BRDF that is to become a [`Brdf`].
///
/// ```
/// use glanz_shader::BrdfSource;
///
/// let text = "::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n  return vec3(0.3 * m);\n}\n::end shader\n";
/// let error = BrdfSource::new("matte.brdf", text).compile().unwrap_err();
/// assert_eq!(error.to_string(), "matte.brdf:3:21: 'm' is not declared");
/// ```
#[derive(Clone)]
pub struct BrdfSource<'a> {
    name: String,
    file: String,
    text: String,
    diffuse: bool,
    /// The user's text, where it is an expression.
    expression: Option<String>,
    include: Option<Include<'a>>,
}

impl<'a> BrdfSource<'a> {
    /// The text of a file; its name tells the language, as for a [`Shader`], and is the model's, without folders.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let name = name.into();
        let file = name.rsplit(['/', '\\']).next().unwrap_or("").to_owned();
        Self { name, file, text: text.into(), diffuse: false, expression: None, include: None }
    }

    /// A BRDF in a word of a command line: a function in GLSL, `float f(vec3 L, vec3 V, vec3 N) { … }`, or an expression over
    /// `L`, `V`, `N`, `H`, `X`, `Y` and `pi` behind its parameters, `n = 20 in 1..100; pow(max(dot(N, H), 0), n)`. Without a
    /// range a parameter goes from 0 to 1000 times its value.
    ///
    /// # Errors
    ///
    /// [`ShaderError`] where a parameter is none. The expression itself is looked at by [`BrdfSource::compile`].
    pub fn word(text: &str) -> Result<Self, ShaderError> {
        let short: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let short = match short.char_indices().nth(LONGEST_NAME) {
            Some((at, _)) => format!("{}…", &short[..at]),
            None => short,
        };
        let source = match text.contains('{') {
            true => Self::new("function", text),
            false => {
                let file = Self::new(expression::NAME, expression::file(text)?);
                Self { expression: Some(text.to_owned()), ..file }
            }
        };
        Ok(Self { file: short, ..source })
    }

    /// The name of the model, for one whose text is not from the file of that name.
    #[must_use]
    pub fn named(mut self, model: impl Into<String>) -> Self {
        self.file = model.into();
        self
    }

    /// Its light is the diffuse one: textures multiply its tint, and no highlight is looked for. Without this it is a
    /// highlight.
    #[must_use]
    pub fn diffuse(mut self) -> Self {
        self.diffuse = true;
        self
    }

    /// Where `#include` takes its files from, as [`Shader::include`].
    #[must_use]
    pub fn include(mut self, resolve: &'a (dyn Fn(&str, &str) -> Option<String> + Sync)) -> Self {
        self.include = Some(resolve);
        self
    }

    /// Compiles the function, and runs it all over the hemisphere once.
    ///
    /// # Errors
    ///
    /// [`ShaderError`] where the text is no function of directions, with the place in it.
    pub fn compile(&self) -> Result<Brdf, ShaderError> {
        self.compiled().map_err(|mut error| {
            let (ShaderError::Invalid { place, .. } | ShaderError::Unsupported { place, .. }) = &mut error
            else {
                return error;
            };
            if let (Some(text), Some(place)) = (&self.expression, place) {
                *place = expression::place(text, place);
            }
            error
        })
    }

    fn compiled(&self) -> Result<Brdf, ShaderError> {
        let included = Mutex::new(BTreeMap::new());
        let include = |path: &str, from: &str| {
            let text = self.include.and_then(|include| include(path, from))?;
            let mut included = included.lock().unwrap_or_else(PoisonError::into_inner);
            included.insert(path.to_owned(), text.clone());
            Some(text)
        };
        let shader = Shader::fragment(self.text.clone()).named(&self.name).include(&include);
        let program = shader.compile()?;
        let inputs = Inputs::of(&program, &self.text)?;
        check(&program)?;
        let (params, parameters) = parameters::of(&program)?;
        let info = info::info(ModelInfo {
            params: info::params(params),
            anisotropic: inputs.anisotropic,
            ..self.info(program.size().0)
        });
        let traced = shader.traced().compile()?;
        let text =
            with_includes(&self.text, &included.into_inner().unwrap_or_else(PoisonError::into_inner), &[]);
        let source = ModelSource { file: self.file.clone(), text, diffuse: self.diffuse };
        Brdf::new(Code { program, info, inputs, parameters, source }, traced)
    }

    /// What is known before the text is read.
    fn info(&self, instructions: usize) -> ModelInfo {
        let name = info::text(&self.file);
        let source = ModelSource { file: String::new(), text: String::new(), diffuse: self.diffuse };
        ModelInfo {
            name,
            title: info::text(&format!("The user's BRDF {name}")),
            formula: "the function's value times cosθi",
            source: name,
            params: &[],
            term: source.term(),
            side: Side::Reflection,
            anisotropic: false,
            delta: false,
            operations: instructions as u32,
            exempt: &[],
        }
    }
}

/// That the program is a function of its inputs with one value.
fn check(program: &Program) -> Result<(), ShaderError> {
    let invalid =
        |message: &str| ShaderError::Invalid { message: message.to_owned(), place: None, hints: Vec::new() };
    let interface = program.interface();
    let [output] = &interface.outputs[..] else {
        return Err(invalid("a BRDF gives one value, a float or a vec3"));
    };
    let rows = output.ty.rows;
    if output.ty.scalar != Scalar::Float || output.ty.columns != 1 || !matches!(rows, 1 | 3 | 4) {
        return Err(invalid(&format!(
            "a BRDF gives a float or a vec3, but this function gives a {}",
            output.ty
        )));
    }
    if !interface.textures.is_empty() {
        return Err(invalid("a BRDF has no textures"));
    }
    let derives = program.lowered.placed.ops.iter().any(|op| matches!(op.code, OpCode::DdX | OpCode::DdY));
    match derives || program.discards() {
        true => Err(invalid("a BRDF has neither derivatives nor 'discard': it knows no pixels")),
        false => Ok(()),
    }
}

/// The text with those that it includes in the place of `#include`. `within`: the paths around.
fn with_includes(text: &str, included: &BTreeMap<String, String>, within: &[String]) -> String {
    if included.is_empty() || within.len() > 16 {
        return text.to_owned();
    }
    let from = within.last().map_or("", String::as_str);
    let line = |line: &str| {
        let path =
            line.trim_start().strip_prefix('#').and_then(|rest| rest.trim_start().strip_prefix("include"));
        let path = path.map_or("", |path| path.trim().trim_matches(['"', '\'', '<', '>']));
        let paths = [included_path(from, path), included_path("", path)];
        match paths.into_iter().flatten().find_map(|path| Some((included.get(&path)?, path))) {
            Some((text, path)) => with_includes(text, included, &[within, &[path]].concat()) + "\n",
            None => line.to_owned(),
        }
    };
    text.split_inclusive('\n').map(line).collect()
}
