//! Models that are known for 16 pairs of directions at a time in single precision: programs of users.

use core::fmt;
use std::sync::Arc;

use glanz_math::{Lanes, SimdLevel, Vec3, at_level};
use serde::{Deserialize, Serialize};

use crate::custom::{Asked, CustomModel, Erased, NUMBERS, numbers, pair};
use crate::{DirectionPair, LightTerm, ModelInfo, Shape};

/// A model that is computed for 16 pairs of directions at a time, in single precision only: what an interpreter of programs
/// gives. [`Shape::from_lanes`] makes a shape of it, whose values in double precision are these.
///
/// ```
/// use std::sync::Arc;
///
/// use glanz_bsdf::models::lambert::Lambert;
/// use glanz_bsdf::{DirectionPair, LaneModel, Model, ModelInfo, Shape, albedo};
/// use glanz_math::SimdLevel;
///
/// static INFO: ModelInfo = ModelInfo { name: "gray", params: &[], ..Lambert::INFO };
///
/// #[derive(Debug)]
/// struct Gray;
///
/// impl LaneModel for Gray {
///     fn info(&self) -> &'static ModelInfo {
///         &INFO
///     }
///     fn params(&self) -> Vec<f64> {
///         Vec::new()
///     }
///     fn with_values(&self, _: &[f64]) -> Arc<dyn LaneModel> {
///         Arc::new(Self)
///     }
///     fn f_cos(&self, _: SimdLevel, pair: &DirectionPair<[f32; 16]>) -> [f32; 16] {
///         pair.cos_i.map(|cosine| 0.5 * cosine.max(0.0) * std::f32::consts::FRAC_1_PI)
///     }
/// }
///
/// let shape = Shape::from_lanes(Arc::new(Gray));
/// assert!((albedo(&shape, 0.7) - 0.5).abs() < 1e-5);
/// ```
pub trait LaneModel: fmt::Debug + Send + Sync {
    /// What it tells about itself.
    fn info(&self) -> &'static ModelInfo;

    /// Its parameters, in the order of `info().params`.
    fn params(&self) -> Vec<f64>;

    /// The same model with other parameters, each in its range.
    fn with_values(&self, values: &[f64]) -> Arc<dyn LaneModel>;

    /// The BSDF times the incident cosine, in 1/sr, of 16 pairs. The same bits at every level; a lane's value follows from
    /// its pair alone.
    fn f_cos(&self, level: SimdLevel, pair: &DirectionPair<[f32; 16]>) -> [f32; 16];

    /// The text that it was made from. Models of one text with the same parameters are equal; a model without one is equal
    /// to its copies alone.
    fn source(&self) -> Option<&ModelSource> {
        None
    }
}

/// The text that a model was made from, by which it is compared and written into files.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModelSource {
    /// The name of its file, without folders.
    pub file: String,
    /// The text, with those that it includes in their places.
    pub text: String,
    /// Whether its light is that of [`LightTerm::Diffuse`] rather than [`LightTerm::Specular`].
    pub diffuse: bool,
}

impl ModelSource {
    /// Which of a light's colours it answers to.
    pub fn term(&self) -> LightTerm {
        if self.diffuse { LightTerm::Diffuse } else { LightTerm::Specular }
    }
}

impl Shape {
    /// A model that is known for 16 pairs at a time as a shape. See [`LaneModel`].
    pub fn from_lanes(model: Arc<dyn LaneModel>) -> Self {
        Self::Custom(CustomModel::new(Arc::new(InLanes(model))))
    }

    /// The text that the model was made from, if it is a user's program.
    pub fn source(&self) -> Option<&ModelSource> {
        match self {
            Self::Custom(model) => model.source(),
            _ => None,
        }
    }

    /// Whether it is known in single precision only: its values in `f64` are those in `f32`.
    pub(crate) fn is_single(&self) -> bool {
        matches!(self, Self::Custom(model) if model.is_single())
    }

    /// [`Shape::f_cos`] of many pairs, 16 at a time where the model is known so.
    ///
    /// ```
    /// use glanz_bsdf::{DirectionPair, Shape};
    ///
    /// let lambert = Shape::named("lambert", &[])?;
    /// let pairs = [1.0, 0.5].map(|cosine| DirectionPair::isotropic(cosine, 0.5, 0.5));
    /// assert_eq!(lambert.values(&pairs), pairs.map(|pair| lambert.f_cos(&pair)));
    /// # Ok::<(), glanz_bsdf::ParamError>(())
    /// ```
    pub fn values(&self, pairs: &[DirectionPair<f64>]) -> Vec<f64> {
        match self {
            Self::Custom(model) if model.is_single() => sixteen_by_sixteen(model, pairs),
            _ => pairs.iter().map(|pair| self.f_cos(pair)).collect(),
        }
    }
}

fn sixteen_by_sixteen(model: &CustomModel, pairs: &[DirectionPair<f64>]) -> Vec<f64> {
    let level = SimdLevel::best();
    let mut values = Vec::with_capacity(pairs.len());
    for chunk in pairs.chunks(16) {
        let rows = chunk.iter().map(|pair| numbers(pair).map(|number| number as f32));
        let mut columns = [[0.0_f32; 16]; NUMBERS];
        for (lane, row) in rows.enumerate() {
            for (column, number) in columns.iter_mut().zip(row) {
                column[lane] = number;
            }
        }
        let lanes = model.in_lanes(level, &columns);
        values.extend(lanes.iter().take(chunk.len()).map(|value| f64::from(*value)));
    }
    values
}

fn tint_cosines(level: SimdLevel, columns: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
    let mut values = [0.0; 16];
    at_level!(level, simd => {
        let pair = pair(columns.map(#[inline(always)] |row| Lanes::load(simd, &row)));
        pair.cos_view_half().store(&mut values);
    });
    values
}

/// A [`LaneModel`] as one of a program's own.
#[derive(Debug)]
struct InLanes(Arc<dyn LaneModel>);

impl InLanes {
    fn in_columns(&self, level: SimdLevel, columns: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
        let [cos_o, cos_i, cos_io, half2, ox, oy, ix, iy, alpha_scale] = *columns;
        let (tangent_o, tangent_i) = ((ox, oy), (ix, iy));
        self.0.f_cos(level, &DirectionPair { cos_o, cos_i, cos_io, half2, tangent_o, tangent_i, alpha_scale })
    }
}

impl Erased for InLanes {
    fn info(&self) -> &'static ModelInfo {
        self.0.info()
    }

    fn params(&self) -> Vec<f64> {
        self.0.params()
    }

    fn with_values(&self, values: &[f64]) -> Arc<dyn Erased> {
        Arc::new(Self(self.0.with_values(values)))
    }

    fn in_f64(&self, asked: Asked, pair: &DirectionPair<f64>) -> f64 {
        match asked {
            Asked::Value => {
                let numbers = numbers(pair).map(|number| number as f32);
                f64::from(self.in_f32(asked, &self::pair(numbers)))
            }
            Asked::TintCosine => pair.cos_view_half(),
        }
    }

    fn in_f32(&self, asked: Asked, pair: &DirectionPair<f32>) -> f32 {
        match asked {
            Asked::Value => {
                let columns = numbers(pair).map(|number| [number; 16]);
                self.in_columns(SimdLevel::best(), &columns)[0]
            }
            Asked::TintCosine => pair.cos_view_half(),
        }
    }

    fn in_lanes(&self, asked: Asked, level: SimdLevel, columns: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
        match asked {
            Asked::Value => self.in_columns(level, columns),
            Asked::TintCosine => tint_cosines(level, columns),
        }
    }

    fn eta(&self) -> f64 {
        1.0
    }

    fn is_anisotropic(&self) -> bool {
        self.info().anisotropic
    }

    fn distribution(&self, _: Vec3<f64>) -> Option<f64> {
        None
    }

    fn shadowing(&self, _: &DirectionPair<f64>) -> Option<f64> {
        None
    }

    fn source(&self) -> Option<&ModelSource> {
        self.0.source()
    }

    fn is_single(&self) -> bool {
        true
    }
}
