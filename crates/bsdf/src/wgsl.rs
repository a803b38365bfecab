//! The twins of models: the same functions in WGSL, for shaders that light as this crate does.
//!
//! A twin is the file `model.wgsl` beside a model's `mod.rs`. It has the same names and the same operations in the same
//! order, so that an interpreter with the numbers of [`Real`](glanz_math::Real) gives the same bits: a test of
//! `glanz-shader` holds every twin to that. A GPU rounds as it likes. Twins share parts, such as that of
//! [`DirectionPair`](crate::DirectionPair); [`text`] puts together what a set of them needs.
//!
//! A twin's function takes a pair and the place where the numbers of its instance begin, which are those of
//! [`Shape::numbers`](crate::Shape::numbers). It reads them by `number(at: u32) -> f32`, a function that whoever uses the
//! text adds: the numbers may be in a buffer, in an array or in a texture.
//!
//! ```
//! use glanz_bsdf::{Shape, wgsl};
//!
//! let shapes = [Shape::named("phong", &[("shininess", 8.0)])?, Shape::named("lambert", &[])?];
//! // Where the numbers of each begin.
//! let (mut numbers, mut places) = (Vec::new(), Vec::new());
//! for shape in &shapes {
//!     places.push(numbers.len());
//!     numbers.extend(shape.numbers());
//! }
//! let twins: Vec<_> = shapes.iter().filter_map(|shape| shape.twin()).collect();
//! assert_eq!((twins[0].function, places[1]), ("phong_f_cos", 3));
//! let shader = wgsl::text(twins)
//!     + "@group(0) @binding(0) var<storage, read> numbers: array<f32>;
//!     fn number(at: u32) -> f32 { return numbers[at]; }
//!     fn both(wo: vec3<f32>, wi: vec3<f32>) -> f32 {
//!         let pair = pair_new(wo, wi);
//!         return phong_f_cos(pair, 0u) + lambert_f_cos(pair, 3u);
//!     }";
//! // What both need is there once.
//! assert_eq!(shader.matches("struct DirectionPair {").count(), 1);
//! # Ok::<(), glanz_bsdf::ParamError>(())
//! ```

use crate::models::TWINS;

/// A model's twin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Twin {
    /// The model's name, as [`ModelInfo::name`](crate::ModelInfo::name) has it.
    pub model: &'static str,
    /// The name of its function `(pair: DirectionPair, at: u32) -> f32`.
    pub function: &'static str,
    /// Its text.
    pub part: Part,
}

/// A text that stands in a file of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// The file, below `crates`.
    pub file: &'static str,
    /// What it declares. No two parts declare the same name.
    pub text: &'static str,
    /// The parts that it needs to stand with.
    pub needs: &'static [&'static Part],
}

macro_rules! part {
    ($file:literal, [$($need:ident),*]) => {
        Part { file: concat!("bsdf/src/", $file), text: include_str!($file), needs: &[$(&$need),*] }
    };
}

pub(crate) const REAL: Part = Part { file: "math/src/real.wgsl", text: glanz_math::wgsl::REAL, needs: &[] };
pub(crate) const EXPONENT: Part =
    Part { file: "math/src/exponent.wgsl", text: glanz_math::wgsl::EXPONENT, needs: &[&REAL] };
pub(crate) const DIRECTION_PAIR: Part = part!("direction_pair.wgsl", []);
pub(crate) const EXP2_OR_ZERO: Part = part!("terms/exp2_or_zero.wgsl", [REAL]);
pub(crate) const EXP_OF_MINUS: Part = part!("terms/exp_of_minus.wgsl", []);
pub(crate) const WARD: Part = part!("terms/ward.wgsl", [DIRECTION_PAIR, REAL, EXP2_OR_ZERO]);
pub(crate) const HALF_VECTOR: Part = part!("microfacet/half_vector.wgsl", [DIRECTION_PAIR, REAL]);
pub(crate) const GGX_DISTRIBUTION: Part = part!("microfacet/ggx_distribution.wgsl", [HALF_VECTOR]);
pub(crate) const COMPENSATION: Part = part!("microfacet/compensation.wgsl", [DIRECTION_PAIR, REAL]);

/// All twins, in the order of [`MODELS`](crate::MODELS).
///
/// ```
/// use glanz_bsdf::{MODELS, wgsl};
///
/// let without = MODELS.iter().filter(|info| wgsl::twin(info.name).is_none());
/// assert_eq!(without.count() + wgsl::twins().len(), MODELS.len());
/// ```
pub fn twins() -> &'static [Twin] {
    TWINS
}

/// The twin of the model called `model`, if it has one.
///
/// ```
/// use glanz_bsdf::wgsl;
///
/// let twin = wgsl::twin("blinn-phong").expect("it has one");
/// assert_eq!(twin.function, "blinn_phong_f_cos");
/// assert!(wgsl::twin("charlie").is_none());
/// ```
pub fn twin(model: &str) -> Option<&'static Twin> {
    TWINS.iter().find(|twin| twin.model == model)
}

/// The text of these twins with all parts that they need, each once and behind those that it needs itself. What is left to
/// add is the function `number`.
///
/// ```
/// use glanz_bsdf::wgsl;
///
/// let text = wgsl::text(wgsl::twins());
/// assert!(text.find("fn sqr(").expect("it is needed") < text.find("fn ward_f_cos(").expect("it is asked for"));
/// assert!(!text.contains("fn number("));
/// ```
pub fn text<'a>(twins: impl IntoIterator<Item = &'a Twin>) -> String {
    let mut parts = Vec::new();
    twins.into_iter().for_each(|twin| add(&mut parts, &twin.part));
    parts.iter().map(|part| part.text).collect::<Vec<_>>().join("\n")
}

/// Adds the part behind those that it needs, if it is not there.
fn add<'a>(parts: &mut Vec<&'a Part>, part: &'a Part) {
    if !parts.iter().any(|known| known.file == part.file) {
        part.needs.iter().for_each(|need| add(parts, need));
        parts.push(part);
    }
}
