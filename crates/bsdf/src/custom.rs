//! Models of a program's own, as shapes beside those of the list.

use core::fmt;
use std::sync::Arc;

use glanz_math::{Lanes, Real, RealFunction, SimdLevel, Vec3, at_level};

use crate::lane_model::ModelSource;
use crate::{DirectionPair, Model, ModelInfo, ParamError, Shape};

/// Models of one's own.
impl Shape {
    /// A model of one's own as a shape. It is written as the models of the list are, and everything that takes a shape takes
    /// it: pictures, plots, certificates, scenes in code. It is compiled for every SIMD level, and called once for 16 pixels.
    ///
    /// Only the program knows it: a scene with it cannot be written into a file.
    ///
    /// ```
    /// use glanz_bsdf::laws::certify;
    /// use glanz_bsdf::models::lambert::Lambert;
    /// use glanz_bsdf::{DirectionPair, Model, ModelInfo, ParamInfo, Shape};
    /// use glanz_math::{PI, Real};
    ///
    /// /// A matte lobe that darkens towards its edge: (e+2)/(2π) · cosᵉθo · cosᵉθi · cosθi, with e = `edge`.
    /// #[derive(Clone, Debug)]
    /// struct Velvet {
    ///     edge: f64,
    /// }
    ///
    /// impl Model for Velvet {
    ///     const INFO: ModelInfo = ModelInfo {
    ///         name: "velvet",
    ///         params: &[ParamInfo {
    ///             name: "edge",
    ///             symbol: "e",
    ///             doc: "how fast it darkens",
    ///             min: 0.0,
    ///             max: 10.0,
    ///             default: 1.0,
    ///         }],
    ///         ..Lambert::INFO
    ///     };
    ///     fn from_params(values: &[f64]) -> Self {
    ///         Self { edge: values[0] }
    ///     }
    ///     fn params(&self) -> Vec<f64> {
    ///         vec![self.edge]
    ///     }
    ///     fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
    ///         let (cos_o, cos_i) = (pair.cos_o.clamp(0.0, 1.0), pair.cos_i.clamp(0.0, 1.0));
    ///         let edge = cos_i.lit(self.edge);
    ///         (cos_o * cos_i).pow(edge) * cos_i * cos_i.lit((self.edge + 2.0) / (2.0 * PI))
    ///     }
    /// }
    ///
    /// let shape = Shape::custom(Velvet { edge: 2.0 });
    /// assert_eq!(shape.info().name, "velvet");
    /// assert_eq!(shape.with("edge", 3.0)?.get("edge"), Some(3.0));
    /// assert!(certify(&shape).is_healthy());
    /// # Ok::<(), glanz_bsdf::ParamError>(())
    /// ```
    pub fn custom<M: Model + fmt::Debug + Send + Sync + 'static>(model: M) -> Self {
        Self::Custom(CustomModel(Arc::new(Compiled(model))))
    }

    /// A function of one's own as a shape: f_cos, the BSDF times the incident cosine in 1/sr, from the values of the
    /// parameters in the order of `info.params` and the two directions. It is for what is no formula, such as
    /// a table that has been measured; it is called for one pixel after the other, so a formula is
    /// better off as [`Shape::custom`].
    ///
    /// ```
    /// use glanz_bsdf::models::lambert::Lambert;
    /// use glanz_bsdf::{DirectionPair, Model, ModelInfo, Shape, albedo};
    ///
    /// static MEASURED: ModelInfo = ModelInfo { name: "measured", params: &[], ..Lambert::INFO };
    /// /// f at an angle of incidence of 0°, 10°, 20° …, for all angles of view.
    /// const TABLE: [f64; 10] = [0.30, 0.30, 0.29, 0.28, 0.27, 0.25, 0.22, 0.18, 0.12, 0.0];
    ///
    /// let shape = Shape::from_function(&MEASURED, &[], |_, pair| {
    ///     let cos_i = pair.cos_i.max(0.0);
    ///     let place = cos_i.min(1.0).acos().to_degrees() / 10.0;
    ///     let (row, rest) = ((place as usize).min(8), place.fract());
    ///     (TABLE[row] * (1.0 - rest) + TABLE[row + 1] * rest) * cos_i
    /// })?;
    /// assert!((albedo(&shape, 0.8) - 0.7644).abs() < 1e-3);
    /// # Ok::<(), glanz_bsdf::ParamError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ParamError`] where `set` names a parameter that `info` does not, or has a value out of its range.
    pub fn from_function<F>(
        info: &'static ModelInfo,
        set: &[(&str, f64)],
        f_cos: F,
    ) -> Result<Self, ParamError>
    where
        F: Fn(&[f64], &DirectionPair<f64>) -> f64 + Send + Sync + 'static,
    {
        let params = info.values(set)?;
        Ok(Self::Custom(CustomModel(Arc::new(Function { info, params, f_cos: Arc::new(f_cos) }))))
    }
}

/// A model of a program's own; made by [`Shape::custom`] and [`Shape::from_function`].
///
/// Two are equal where one is a copy of the other, since their formulas cannot be compared, or where both are made of the same
/// text ([`LaneModel::source`](crate::LaneModel::source)) with the same parameters.
#[derive(Clone)]
pub struct CustomModel(Arc<dyn Erased>);

impl CustomModel {
    pub(crate) fn new(model: Arc<dyn Erased>) -> Self {
        Self(model)
    }

    pub(crate) fn source(&self) -> Option<&ModelSource> {
        self.0.source()
    }

    pub(crate) fn is_single(&self) -> bool {
        self.0.is_single()
    }

    /// The values of 16 pairs whose numbers are given column by column.
    pub(crate) fn in_lanes(&self, level: SimdLevel, columns: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
        self.0.in_lanes(Asked::Value, level, columns)
    }

    pub(crate) fn info(&self) -> &'static ModelInfo {
        self.0.info()
    }

    /// The same model with other values of its parameters, each within its range.
    pub(crate) fn with_values(&self, values: &[f64]) -> Self {
        Self(self.0.with_values(values))
    }
}

impl fmt::Debug for CustomModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl PartialEq for CustomModel {
    fn eq(&self, other: &Self) -> bool {
        let same_text = || self.source().is_some() && self.source() == other.source();
        Arc::ptr_eq(&self.0, &other.0) || same_text() && self.0.params() == other.0.params()
    }
}

impl Model for CustomModel {
    /// What all of them share; [`Shape::info`] has that of each.
    const INFO: ModelInfo = ModelInfo {
        name: "custom",
        title: "A model of the program's own",
        formula: "f_cos",
        source: "the program",
        params: &[],
        term: crate::LightTerm::Specular,
        side: crate::Side::Reflection,
        anisotropic: true,
        delta: false,
        operations: u32::MAX,
        exempt: &[],
    };

    /// A lobe that is black: what a model is made of is known to its program only.
    fn from_params(_: &[f64]) -> Self {
        let black = |_: &[f64], _: &DirectionPair<f64>| 0.0;
        Self(Arc::new(Function { info: &Self::INFO, params: Vec::new(), f_cos: Arc::new(black) }))
    }

    fn params(&self) -> Vec<f64> {
        self.0.params()
    }

    fn get(&self, name: &str) -> Option<f64> {
        let index = self.info().params.iter().position(|param| param.name == name)?;
        self.params().get(index).copied()
    }

    fn with(&self, name: &str, value: f64) -> Result<Self, ParamError> {
        let mut values = self.params();
        values[self.info().place(name, value)?] = value;
        Ok(self.with_values(&values))
    }

    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_o.apply(&Quantity { model: &*self.0, asked: Asked::Value }, numbers(pair))
    }

    fn eta(&self) -> f64 {
        self.0.eta()
    }

    fn is_anisotropic(&self) -> bool {
        self.0.is_anisotropic()
    }

    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_o.apply(&Quantity { model: &*self.0, asked: Asked::TintCosine }, numbers(pair))
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        self.0.distribution(half)
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        self.0.shadowing(pair)
    }
}

/// How many numbers a pair of directions is.
pub(crate) const NUMBERS: usize = 9;

/// A pair as a row of numbers.
pub(crate) fn numbers<R: Real>(pair: &DirectionPair<R>) -> [R; NUMBERS] {
    let DirectionPair { cos_o, cos_i, cos_io, half2, tangent_o, tangent_i, alpha_scale } = *pair;
    [cos_o, cos_i, cos_io, half2, tangent_o.0, tangent_o.1, tangent_i.0, tangent_i.1, alpha_scale]
}

/// A pair from a row of numbers.
#[inline(always)]
pub(crate) fn pair<R: Real>(
    [cos_o, cos_i, cos_io, half2, ox, oy, ix, iy, alpha_scale]: [R; NUMBERS],
) -> DirectionPair<R> {
    DirectionPair { cos_o, cos_i, cos_io, half2, tangent_o: (ox, oy), tangent_i: (ix, iy), alpha_scale }
}

/// What is asked of a model for a pair.
#[derive(Clone, Copy)]
pub(crate) enum Asked {
    /// [`Model::f_cos`].
    Value,
    /// [`Model::tint_cosine`].
    TintCosine,
}

impl Asked {
    #[inline(always)]
    fn of<R: Real>(self, model: &impl Model, pair: &DirectionPair<R>) -> R {
        match self {
            Self::Value => model.f_cos(pair),
            Self::TintCosine => model.tint_cosine(pair),
        }
    }
}

/// A [`Model`] behind a trait object: one method for each kind of number.
pub(crate) trait Erased: fmt::Debug + Send + Sync {
    fn info(&self) -> &'static ModelInfo;
    fn params(&self) -> Vec<f64>;
    fn with_values(&self, values: &[f64]) -> Arc<dyn Erased>;
    fn in_f64(&self, asked: Asked, pair: &DirectionPair<f64>) -> f64;
    fn in_f32(&self, asked: Asked, pair: &DirectionPair<f32>) -> f32;
    fn in_lanes(&self, asked: Asked, level: SimdLevel, numbers: &[[f32; 16]; NUMBERS]) -> [f32; 16];
    fn eta(&self) -> f64;
    fn is_anisotropic(&self) -> bool;
    fn distribution(&self, half: Vec3<f64>) -> Option<f64>;
    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64>;

    /// See [`LaneModel::source`](crate::LaneModel::source).
    fn source(&self) -> Option<&ModelSource> {
        None
    }

    /// Whether it is known in single precision only.
    fn is_single(&self) -> bool {
        false
    }
}

/// What is asked of a model, as a function of the numbers of a pair.
struct Quantity<'m> {
    model: &'m dyn Erased,
    asked: Asked,
}

impl RealFunction<NUMBERS> for Quantity<'_> {
    fn in_f64(&self, numbers: [f64; NUMBERS]) -> f64 {
        self.model.in_f64(self.asked, &pair(numbers))
    }

    fn in_f32(&self, numbers: [f32; NUMBERS]) -> f32 {
        self.model.in_f32(self.asked, &pair(numbers))
    }

    fn in_lanes(&self, level: SimdLevel, numbers: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
        self.model.in_lanes(self.asked, level, numbers)
    }
}

/// A model of one's own that is generic over numbers.
#[derive(Debug)]
struct Compiled<M>(M);

impl<M: Model + fmt::Debug + Send + Sync + 'static> Erased for Compiled<M> {
    fn info(&self) -> &'static ModelInfo {
        &const { M::INFO }
    }

    fn params(&self) -> Vec<f64> {
        self.0.params()
    }

    fn with_values(&self, values: &[f64]) -> Arc<dyn Erased> {
        Arc::new(Self(M::from_params(values)))
    }

    fn in_f64(&self, asked: Asked, pair: &DirectionPair<f64>) -> f64 {
        asked.of(&self.0, pair)
    }

    fn in_f32(&self, asked: Asked, pair: &DirectionPair<f32>) -> f32 {
        asked.of(&self.0, pair)
    }

    fn in_lanes(&self, asked: Asked, level: SimdLevel, numbers: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
        let mut values = [0.0; 16];
        at_level!(level, simd => {
            let pair = pair(numbers.map(#[inline(always)] |row| Lanes::load(simd, &row)));
            asked.of(&self.0, &pair).store(&mut values);
        });
        values
    }

    fn eta(&self) -> f64 {
        self.0.eta()
    }

    fn is_anisotropic(&self) -> bool {
        self.0.is_anisotropic()
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        self.0.distribution(half)
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        self.0.shadowing(pair)
    }
}

/// A function of one's own, in double precision.
struct Function<F> {
    info: &'static ModelInfo,
    params: Vec<f64>,
    f_cos: Arc<F>,
}

impl<F> fmt::Debug for Function<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct(self.info.name).field("params", &self.params).finish_non_exhaustive()
    }
}

impl<F: Fn(&[f64], &DirectionPair<f64>) -> f64 + Send + Sync + 'static> Erased for Function<F> {
    fn info(&self) -> &'static ModelInfo {
        self.info
    }

    fn params(&self) -> Vec<f64> {
        self.params.clone()
    }

    fn with_values(&self, values: &[f64]) -> Arc<dyn Erased> {
        Arc::new(Self { info: self.info, params: values.to_vec(), f_cos: Arc::clone(&self.f_cos) })
    }

    fn in_f64(&self, asked: Asked, pair: &DirectionPair<f64>) -> f64 {
        match asked {
            Asked::Value => (self.f_cos)(&self.params, pair),
            Asked::TintCosine => pair.cos_view_half(),
        }
    }

    fn in_f32(&self, asked: Asked, pair: &DirectionPair<f32>) -> f32 {
        let numbers = numbers(pair).map(f64::from);
        self.in_f64(asked, &self::pair(numbers)) as f32
    }

    fn in_lanes(&self, asked: Asked, _: SimdLevel, numbers: &[[f32; 16]; NUMBERS]) -> [f32; 16] {
        core::array::from_fn(|lane| self.in_f32(asked, &pair(core::array::from_fn(|i| numbers[i][lane]))))
    }

    fn eta(&self) -> f64 {
        1.0
    }

    fn is_anisotropic(&self) -> bool {
        self.info.anisotropic
    }

    fn distribution(&self, _: Vec3<f64>) -> Option<f64> {
        None
    }

    fn shadowing(&self, _: &DirectionPair<f64>) -> Option<f64> {
        None
    }
}
