//! What a program is told for a frame: matrices, lights, the material, the moment, and what the user sets.
//!
//! Names say what a uniform stands for ([`Role`]); what stands for nothing keeps the value of the source, or 0.

mod attributes;
mod lights;
mod material;
mod matrices;
mod pictures;

use glanz_scene::UniformValue;
use glanz_shader::{Program, Role, Uniform, UniformValues};

use crate::prepare::{Prepared, PreparedObject, PreparedProgram, program_values};
use crate::view::camera::ViewCamera;
use crate::view::{Moment, View};
pub use attributes::MeshAttributes;
use lights::ProgramLights;
pub use matrices::DepthRange;
use matrices::Matrices;
pub use pictures::{EnvironmentPicture, ProgramPicture};
pub(crate) use pictures::{has_picture, is_cube, is_flat};

/// Everything about a frame that uniforms can stand for: for a back end to ask what each object's program is given.
///
/// ```
/// use glanz_render::view::program::FrameUniforms;
/// use glanz_render::{Moment, Shot};
/// use glanz_scene::{Mesh, Program, ProgramText, Scene, library};
///
/// let text = "uniform float exposure; uniform float time; out vec4 c; void main() { c = vec4(exposure * time); }";
/// let program = Program::of_fragment(ProgramText::new("own.frag", text)).with_uniform("exposure", &[2.0]);
/// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(8, 8);
/// scene.programs.push(program);
/// scene.program = Some(0);
///
/// let shot = Shot::new(&scene)?;
/// let moment = Moment { time: 3.0, ..Moment::default() };
/// let frame = FrameUniforms::new(shot.prepared(), shot.view(), moment);
/// let values = frame.of(&shot.prepared().objects[0]).expect("the scene's program draws it");
/// assert_eq!(values.fragment.get("exposure"), Some(vec![2.0]));
/// assert_eq!(values.fragment.get("time"), Some(vec![3.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct FrameUniforms<'a> {
    prepared: &'a Prepared,
    view: &'a View,
    moment: Moment,
    /// The planes between which clip space lies.
    pub range: DepthRange,
    lights: ProgramLights,
}

/// The values of both stages of an object's program.
pub struct StageValues<'a> {
    /// Uniforms of the vertex shader.
    pub vertex: UniformValues,
    /// Uniforms of the fragment shader.
    pub fragment: UniformValues,
    /// Of each texture of the vertex shader; none is opaque black.
    pub vertex_textures: Vec<Option<ProgramPicture<'a>>>,
    /// The same of the fragment shader.
    pub fragment_textures: Vec<Option<ProgramPicture<'a>>>,
}

impl<'a> FrameUniforms<'a> {
    /// For a frame of this view at this moment.
    pub fn new(prepared: &'a Prepared, view: &'a View, moment: Moment) -> Self {
        let range = DepthRange::new(view, ViewCamera::new(prepared, view).range);
        let lights = ProgramLights::new(prepared, view);
        Self { prepared, view, moment, range, lights }
    }

    /// What the program of an object is given, if it has one.
    pub fn of(&self, object: &PreparedObject) -> Option<StageValues<'a>> {
        Some(self.values(object, self.prepared.programs.get(object.program?)?))
    }

    /// What a program is given for an object.
    pub(crate) fn values(&self, object: &PreparedObject, program: &PreparedProgram) -> StageValues<'a> {
        let matrices = Matrices::new(self.view, &self.range, object);
        let stage = |stage: &Program| self.of_stage(stage, program, object, &matrices);
        let material = &self.prepared.materials[object.material];
        let textures = |stage: &Program| {
            pictures::of_stage(&stage.interface().textures, program, self.prepared, material, self.view)
        };
        let pair = &program.pair;
        StageValues {
            vertex: stage(&pair.vertex),
            fragment: stage(&pair.fragment),
            vertex_textures: textures(&pair.vertex),
            fragment_textures: textures(&pair.fragment),
        }
    }

    fn of_stage(
        &self,
        stage: &Program,
        program: &PreparedProgram,
        object: &PreparedObject,
        matrices: &Matrices,
    ) -> UniformValues {
        let mut values = stage.uniforms();
        for uniform in &stage.interface().uniforms {
            // A value of the source's own counts, but for matrices, which nobody knows beforehand.
            let given = values.get(&uniform.name).unwrap_or_default();
            if uniform.ty.columns == 1 && given.iter().any(|value| *value != 0.0) {
                continue;
            }
            let Some(role) = uniform.role else { continue };
            if let Some(numbers) = self.numbers(role, uniform, program, object, matrices) {
                let fitted = fitted(&numbers, uniform);
                values.set(&uniform.name, &fitted).expect("it has as many numbers as its type");
            }
        }
        for (name, value) in &program.source.uniforms {
            if let UniformValue::Numbers(numbers) = value {
                // The other stage may be the one that has it; that one of them does was checked.
                let _ = program_values::set(&mut values, stage, name, numbers);
            }
        }
        values
    }

    /// What a uniform of this role is, as four numbers, or 16 of a matrix.
    fn numbers(
        &self,
        role: Role,
        uniform: &Uniform,
        program: &PreparedProgram,
        object: &PreparedObject,
        matrices: &Matrices,
    ) -> Option<Vec<f64>> {
        let space = glanz_shader::Space::of_name(&uniform.name).unwrap_or(program.pair.space);
        let View { width, height, .. } = *self.view;
        let Moment { time, delta, frame, mouse } = self.moment;
        Some(match role {
            Role::Time => vec![f64::from(time)],
            Role::TimeDelta => vec![f64::from(delta)],
            Role::Frame => vec![f64::from(frame)],
            Role::Resolution => vec![f64::from(width), f64::from(height), 1.0, 0.0],
            // Where and how large: the course's, which has the size of the window behind the place.
            Role::Mouse if mouse[2] == 0.0 => {
                vec![f64::from(mouse[0]), f64::from(mouse[1]), f64::from(width), f64::from(height)]
            }
            Role::Mouse => mouse.map(f64::from).to_vec(),
            Role::EyePosition => matrices.eye(space).to_vec(),
            _ => {
                let own = || matrices.of(role, program.pair.space).map(|m| m.to_vec());
                let light = || self.lights.of(role, &uniform.name, space, matrices);
                own().or_else(light).or_else(|| material::of(role, &uniform.name, self.prepared, object))?
            }
        })
    }
}

/// As many numbers as the type has: of matrices the upper left part, of vectors the first ones, a fourth being 1.
fn fitted(numbers: &[f64], uniform: &Uniform) -> Vec<f32> {
    let (columns, rows) = (uniform.ty.columns, uniform.ty.rows);
    let at = |i: usize| match numbers.get(i) {
        Some(number) => *number as f32,
        None if i == 3 => 1.0,
        None => 0.0,
    };
    if columns > 1 {
        return (0..columns).flat_map(|c| (0..rows).map(move |r| at(4 * c + r))).collect();
    }
    (0..rows).map(at).collect()
}
