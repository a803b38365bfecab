//! BRDFs of users, as shapes that everything takes.
//!
//! A BRDF is one function of directions: a `.brdf` file of BRDF Explorer, one function in GLSL or WGSL, or an expression.
//! [`BrdfSource`] is its text, [`Brdf`] the compiled function, [`Brdf::shape`] the [`Shape`] for pictures, plots, sheets and
//! certificates.
//!
//! The function returns f, the BRDF without the cosine, as BRDF Explorer has it; a shape is f · cosθi. It may take, by
//! name, the directions to the light (`L`, `light`, `wi`) and to the viewer (`V`, `view`, `wo`), the normal (`N`), tangent and
//! bitangent (`X`, `Y`) and the half vector (`H`), all of unit length. Uniforms, and the parameters of a `.brdf`, are the
//! model's parameters; a colour is three of them. A shape knows no colour: of a `vec3` whose channels are equal it is one of
//! them, else their mean, which a remark tells.

mod directions;
mod expression;
mod info;
mod inputs;
mod model;
mod parameters;
mod source;

use std::sync::Arc;

use glanz_bsdf::{ModelInfo, Shape};
use glanz_math::{SimdLevel, Vec3};

use self::inputs::Inputs;
use self::model::{Code, ProgramModel};
pub use self::source::BrdfSource;
use crate::{Machine, NoTextures, Program, Row, ShaderError, Trace, Warning};

/// A user's BRDF.
///
/// ```
/// use glanz_bsdf::albedo;
/// use glanz_shader::BrdfSource;
///
/// let brdf = BrdfSource::word("n = 20 in 1..100; (n + 2) / (2 * pi) * pow(max(dot(reflect(-L, N), V), 0), n)")?.compile()?;
/// let shape = brdf.shape().with("n", 50.0)?;
/// // Phong's highlight, normalised: all light comes back along the normal.
/// assert!((albedo(&shape, 1.0) - 1.0).abs() < 1e-4);
/// assert_eq!(brdf.info().params[0].max, 100.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Brdf {
    model: Arc<ProgramModel>,
    traced: Program,
    remarks: Vec<Warning>,
}

impl Brdf {
    fn new(code: Code, traced: Program) -> Result<Self, ShaderError> {
        // A shape is not asked for light from behind.
        let from_behind = |warning: &&Warning| warning.message.contains("behind the surface");
        let warnings = code.program.warnings().iter();
        let mut remarks: Vec<_> = warnings.filter(|warning| !from_behind(warning)).cloned().collect();
        let model = Arc::new(ProgramModel::new(Arc::new(code)));
        if model.probe()? {
            let message = "red, green and blue differ; a shape knows no colour and is their mean: the tint of its lobe \
                           carries the colour";
            remarks.push(Warning { place: None, message: message.to_owned() });
        }
        Ok(Self { model, traced, remarks })
    }

    /// What it tells about itself: its parameters with their ranges and defaults.
    pub fn info(&self) -> &'static ModelInfo {
        self.model.code().info
    }

    /// The shape, with the defaults of its parameters.
    pub fn shape(&self) -> Shape {
        Shape::from_lanes(self.model.clone())
    }

    /// The compiled function.
    pub fn program(&self) -> &Program {
        &self.model.code().program
    }

    /// What is right but probably not meant, with its place, and what the shape does with colours, without.
    pub fn remarks(&self) -> &[Warning] {
        &self.remarks
    }

    /// Every named value of a run for these unit vectors in the local frame, with its line; the same in all lanes. `params`
    /// are the values of all parameters, in the order of [`Brdf::info`].
    pub fn trace(&self, params: &[f64], wo: Vec3<f64>, wi: Vec3<f64>) -> Trace {
        let code = self.model.code();
        let uniforms = code.uniforms(params);
        let mut machine = Machine::<1>::new(&self.traced, &uniforms, &NoTextures, SimdLevel::best());
        machine.set_fuel(model::FUEL);
        let single = |w: Vec3<f64>| [w.x as f32, w.y as f32, w.z as f32];
        let vectors = Inputs::vectors(single(wi), single(wo));
        for (input, name) in code.inputs.in_order().enumerate() {
            for (component, value) in vectors[name as usize].into_iter().enumerate() {
                machine.input(input, component)[0] = Row::splat(value);
            }
        }
        machine.trace()
    }
}
