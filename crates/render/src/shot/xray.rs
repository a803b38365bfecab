//! Programs taken apart: every value of every line at a pixel or vertex, and any value as a picture.

use std::collections::BTreeMap;

use glanz_picture::Frame;
use glanz_scene::Program;
use glanz_shader::{Pair, ShaderError, Source, Stage, Trace, ValueType};

use super::{Shot, ShotError};
use crate::cpu::Renderer;
use crate::cpu::inspect::{Findings, Wanted};
use crate::prepare::{PrepareError, ProgramError, compiled_program, traced_pair};
use crate::view::program::FrameUniforms;
use crate::view::{DrawOptions, Samples};

/// What a value's picture has where the program did not come to its line.
pub const NOT_REACHED: f32 = crate::cpu::inspect::NOT_REACHED;

/// All that happened at a pixel or a vertex.
#[derive(Clone, Debug)]
pub struct Xray {
    /// The number of the object.
    pub object: usize,
    /// Which stage ran.
    pub stage: Stage,
    /// Where the text of that stage is from.
    pub source: Source,
    /// Which of the trace's lanes is the pixel or vertex.
    pub lane: usize,
    /// What happened.
    pub trace: Trace,
}

/// What a uniform is.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Mesh, Program, ProgramText, Scene, library};
///
/// let scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(8, 8);
/// let text = "uniform float time; uniform float wear; out vec4 c; void main() { c = vec4(time + wear); }";
/// let program = Program::of_fragment(ProgramText::new("own.frag", text));
/// let fills = Shot::new(&scene)?.uniforms_of(&program, 0)?;
/// let is_filled = |name: &str| fills.iter().any(|fill| fill.name == name && fill.filled);
/// assert!(is_filled("time") && !is_filled("wear"), "nothing stands for wear: the user sets it");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct UniformFill {
    /// As the source names it.
    pub name: String,
    /// Its type.
    pub ty: ValueType,
    /// Its numbers, column by column.
    pub values: Vec<f32>,
    /// Whether its name stands for something or the user sets it; if not it has the source's value, or 0.
    pub filled: bool,
}

/// A value of a program at all pixels.
///
/// ```
/// use glanz_render::Shot;
/// use glanz_scene::{Mesh, Program, ProgramText, Scene, library};
///
/// let text = "in vec3 normal; out vec4 color; void main() { float up = normal.y; color = vec4(up); }";
/// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(9, 9);
/// scene.set_program(Program::of_fragment(ProgramText::new("up.frag", text)));
/// let up = Shot::new(&scene)?.value_frame("up", None)?;
/// assert!(up.frame.pixel(4, 4)[0].abs() < 0.5, "the middle of the ball looks at the camera");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ValueFrame {
    /// Its numbers in place of red, green and blue, one number three times; [`NOT_REACHED`] where the program did not come to
    /// it, alpha 0 where there is no program.
    pub frame: Frame,
    /// All values that were met: line and name, and how many numbers each has.
    pub met: BTreeMap<(u32, String), usize>,
}

impl Shot {
    /// All that the fragment shader did in the middle of a pixel; none where nothing is that a program draws.
    ///
    /// ```
    /// use glanz_render::Shot;
    /// use glanz_scene::{Mesh, Program, ProgramText, Scene, library};
    ///
    /// let text = "in vec3 normal; out vec4 color; void main() { float up = normal.y; color = vec4(up); }";
    /// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(33, 33);
    /// scene.set_program(Program::of_fragment(ProgramText::new("up.frag", text)));
    /// let xray = Shot::new(&scene)?.xray(16, 16)?.expect("the sphere is in the middle");
    /// let up = xray.trace.of_lane(xray.lane).find(|record| record.name == "up").expect("it has a value");
    /// assert!(up.values(xray.lane)[0].abs() < 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ShotError::Pixel`] for a pixel that the picture does not have, [`ShotError::NoProgram`] for a scene without programs.
    pub fn xray(&mut self, x: u32, y: u32) -> Result<Option<Xray>, ShotError> {
        let (width, height) = (self.sight.view.width, self.sight.view.height);
        if x >= width || y >= height {
            return Err(ShotError::Pixel { x, y, width, height });
        }
        let (_, findings) = self.inspected(Wanted::Pixel([x, y]))?;
        Ok(findings.pixel.map(|found| Xray {
            object: found.object,
            stage: Stage::Fragment,
            source: self.source_of(found.object, Stage::Fragment),
            lane: found.lane,
            trace: found.trace,
        }))
    }

    /// All that the vertex shader did for a vertex of an object's mesh; none where that has no such vertex.
    ///
    /// # Errors
    /// [`ShotError::NoProgram`] where no program draws the object.
    pub fn xray_vertex(&mut self, object: usize, vertex: u32) -> Result<Option<Xray>, ShotError> {
        let pairs = self.traced_pairs()?;
        let found = Renderer::new().vertex_trace(
            &self.prepared,
            &self.sight.view,
            &self.sight.draw,
            &pairs,
            (object, vertex),
        );
        let Some(found) = found else { return Err(ShotError::NoProgram) };
        Ok(found.map(|(lane, trace)| Xray {
            object,
            stage: Stage::Vertex,
            source: self.source_of(object, Stage::Vertex),
            lane,
            trace,
        }))
    }

    /// A value of the fragment shaders at all pixels, by its name and its line; where no line is given, the last one.
    ///
    /// # Errors
    /// [`ShotError::NoProgram`] for a scene without programs.
    pub fn value_frame(&mut self, name: &str, line: Option<u32>) -> Result<ValueFrame, ShotError> {
        let (frame, findings) = self.inspected(Wanted::Value { name: name.to_owned(), line })?;
        Ok(ValueFrame { frame, met: findings.met })
    }

    /// What the uniforms of a program would be for an object of the scene before its camera: of both stages, by name, with
    /// whether anything stands for them.
    ///
    /// # Errors
    /// If the program does not compile, or there is no such object.
    pub fn uniforms_of(&self, program: &Program, object: usize) -> Result<Vec<UniformFill>, ShotError> {
        let own = self.prepared.objects.get(object).ok_or(ShotError::NoProgram)?;
        let sizes = self.prepared.textures.iter().map(|own| [own.levels[0].width, own.levels[0].height]);
        let sizes: Vec<_> = sizes.map(|size| size.map(|side| side as u32)).collect();
        let compiled = compiled_program(program, &sizes)?;
        let told = FrameUniforms::new(&self.prepared, &self.sight.view, self.sight.draw.moment);
        let values = told.values(own, &compiled);
        let pair = &compiled.pair;
        let stages = [(&pair.vertex, &values.vertex), (&pair.fragment, &values.fragment)];
        let mut all: Vec<UniformFill> = Vec::new();
        for (stage, values) in stages {
            for uniform in &stage.interface().uniforms {
                if all.iter().any(|known| known.name == uniform.name) {
                    continue;
                }
                let numbers = values.get(&uniform.name).unwrap_or_default();
                let filled = uniform.role.is_some() || program.uniforms.contains_key(&uniform.name);
                all.push(UniformFill { name: uniform.name.clone(), ty: uniform.ty, values: numbers, filled });
            }
        }
        Ok(all)
    }

    fn inspected(&mut self, wanted: Wanted) -> Result<(Frame, Findings), ShotError> {
        let pairs = self.traced_pairs()?;
        let background = glanz_scene::Background::Transparent;
        let options =
            DrawOptions { samples: Samples::One, supersample: false, background, ..self.sight.draw };
        let mut renderer = Renderer::new();
        Ok(renderer.inspect(&self.prepared, &self.sight.view, &options, wanted, &pairs))
    }

    fn traced_pairs(&self) -> Result<Vec<Pair>, ShotError> {
        if self.prepared.objects.iter().all(|object| object.program.is_none()) {
            return Err(ShotError::NoProgram);
        }
        let programs = self.prepared.programs.iter();
        let traced = programs.map(|program| traced_pair(&program.source)).collect::<Result<Vec<_>, _>>();
        traced.map_err(|error: ShaderError| {
            let error = ProgramError { error, texts: BTreeMap::new() };
            PrepareError::from(Box::new(error)).into()
        })
    }

    fn source_of(&self, object: usize, stage: Stage) -> Source {
        let program = self.prepared.objects.get(object).and_then(|own| own.program);
        let pair = program.and_then(|own| self.prepared.programs.get(own)).map(|own| &own.pair);
        match (pair, stage) {
            (Some(pair), Stage::Vertex) => pair.vertex_source,
            (Some(pair), Stage::Fragment) => pair.fragment_source,
            (None, _) => Source::StandIn,
        }
    }
}
