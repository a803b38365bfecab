//! What laws judge: a shape, or any function of two directions with a description.

use glanz_math::{Lanes, SimdLevel, Vec3, at_level};

use crate::{DirectionPair, LightTerm, ModelInfo, Shape, Side};

/// Why laws of directional light do not apply to ambient light and emission.
pub(super) const NO_DIRECTION: &str = "it answers to no light from a direction";
/// Why laws of values do not apply to perfect mirrors and refraction.
pub(super) const SINGLE_DIRECTION: &str = "it sends light into a single direction";
/// Why laws of single precision do not apply to some lobes.
pub(super) const ONLY_F64: &str = "it is known in f64 only";

/// Why laws of double precision do not apply to programs of users.
pub(super) const ONLY_F32: &str = "it is computed in f32 only";

/// Something that laws can judge.
pub trait Subject {
    /// What it tells about itself.
    fn info(&self) -> &ModelInfo;

    /// Its parameters, in the order of `info().params`.
    fn params(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The same model with other parameters, each in its range. None if it has but the ones it was made with.
    fn with_params(&self, _params: &[f64]) -> Option<Box<dyn Subject + '_>> {
        None
    }

    /// The BSDF times the incident cosine, in 1/sr.
    fn value(&self, pair: &DirectionPair<f64>) -> f64;

    /// The same in single precision. None if it is known in `f64` only.
    fn value_f32(&self, _pair: &DirectionPair<f32>) -> Option<f32> {
        None
    }

    /// The same for 16 pairs at once, compiled for the SIMD level of this name. None if it is known in `f64` only or the
    /// machine lacks the level.
    fn value_lanes(&self, _level: &str, _pairs: &[DirectionPair<f32>; 16]) -> Option<[f32; 16]> {
        None
    }

    /// Whether it is computed in single precision only: its values in `f64` are then those in `f32`, and
    /// [`Subject::values`] is the fast way to them.
    fn is_single(&self) -> bool {
        false
    }

    /// The values of many pairs.
    fn values(&self, pairs: &[DirectionPair<f64>]) -> Vec<f64> {
        pairs.iter().map(|pair| self.value(pair)).collect()
    }

    /// The index of refraction below the surface over that above it; see [`Model::eta`](crate::Model::eta).
    fn eta(&self) -> f64 {
        1.0
    }

    /// The distribution D of microfacet normals, if it has one; see [`Model::distribution`](crate::Model::distribution).
    fn distribution(&self, _half: Vec3<f64>) -> Option<f64> {
        None
    }
}

impl dyn Subject + '_ {
    /// Whether the lobe lets light pass.
    pub(super) fn transmits(&self) -> bool {
        self.info().side == Side::Transmission
    }

    /// Whether it answers to light from a direction.
    pub(super) fn is_directional(&self) -> bool {
        !matches!(self.info().term, LightTerm::Ambient | LightTerm::Emission)
    }

    /// Why the laws of directional light do not apply, if they do not.
    pub(super) fn no_directional_light(&self) -> Option<&'static str> {
        match self.is_directional() {
            false => Some(NO_DIRECTION),
            true => self.no_values(),
        }
    }

    /// Why laws of values do not apply, if they do not: those of a delta lobe are all 0.
    pub(super) fn no_values(&self) -> Option<&'static str> {
        self.info().delta.then_some(SINGLE_DIRECTION)
    }
}

impl Subject for Shape {
    fn info(&self) -> &ModelInfo {
        Self::info(self)
    }

    fn params(&self) -> Vec<f64> {
        Self::params(self)
    }

    fn with_params(&self, params: &[f64]) -> Option<Box<dyn Subject + '_>> {
        Some(Box::new(self.with_values(params)))
    }

    fn value(&self, pair: &DirectionPair<f64>) -> f64 {
        self.f_cos(pair)
    }

    fn value_f32(&self, pair: &DirectionPair<f32>) -> Option<f32> {
        Some(self.f_cos(pair))
    }

    fn value_lanes(&self, level: &str, pairs: &[DirectionPair<f32>; 16]) -> Option<[f32; 16]> {
        let level = SimdLevel::named(level).ok()?;
        let column =
            |get: fn(&DirectionPair<f32>) -> f32| -> [f32; 16] { core::array::from_fn(|i| get(&pairs[i])) };
        let cosines = [column(|p| p.cos_o), column(|p| p.cos_i), column(|p| p.cos_io), column(|p| p.half2)];
        let tangents = [
            column(|p| p.tangent_o.0),
            column(|p| p.tangent_o.1),
            column(|p| p.tangent_i.0),
            column(|p| p.tangent_i.1),
        ];
        let mut values = [0.0; 16];
        at_level!(level, simd => {
            let [cos_o, cos_i, cos_io, half2] = cosines.map(|c| Lanes::load(simd, &c));
            let [ox, oy, ix, iy] = tangents.map(|t| Lanes::load(simd, &t));
            let pair = DirectionPair {
                half2,
                tangent_o: (ox, oy),
                tangent_i: (ix, iy),
                ..DirectionPair::isotropic(cos_o, cos_i, cos_io)
            };
            self.f_cos(&pair).store(&mut values);
        });
        Some(values)
    }

    fn is_single(&self) -> bool {
        Self::is_single(self)
    }

    fn values(&self, pairs: &[DirectionPair<f64>]) -> Vec<f64> {
        Self::values(self, pairs)
    }

    fn eta(&self) -> f64 {
        Self::eta(self)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Self::distribution(self, half)
    }
}

/// Any function of two directions as a [`Subject`], in `f64` and with no parameters that laws could vary.
///
/// ```
/// use glanz_bsdf::laws::{Function, Law, Verdict, judge};
/// use glanz_bsdf::{DirectionPair, Model, ModelInfo, models::lambert::Lambert};
///
/// let info = ModelInfo { name: "too-bright", ..Lambert::INFO };
/// let lobe = Function::new(info, |pair: &DirectionPair<f64>| pair.cos_i.max(0.0) * 0.4);
/// assert_eq!(judge(Law::Energy, &lobe).verdict, Verdict::Broken { known: None });
/// assert_eq!(judge(Law::Reciprocity, &lobe).verdict, Verdict::Holds);
/// ```
pub struct Function<F> {
    info: ModelInfo,
    f_cos: F,
}

impl<F: Fn(&DirectionPair<f64>) -> f64> Function<F> {
    /// The lobe `f_cos`, the BSDF times the incident cosine in 1/sr, of which `info` says to which light it answers and from
    /// which laws it is exempt.
    pub fn new(info: ModelInfo, f_cos: F) -> Self {
        Self { info: ModelInfo { params: &[], ..info }, f_cos }
    }
}

impl<F: Fn(&DirectionPair<f64>) -> f64> Subject for Function<F> {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn value(&self, pair: &DirectionPair<f64>) -> f64 {
        (self.f_cos)(pair)
    }
}
