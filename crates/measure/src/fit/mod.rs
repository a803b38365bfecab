//! Fits of models to readings.
//!
//! Only the widths of the lobes are searched; the tints follow from them in closed form, as least squares that are not
//! negative, all channels at once. So the search has one number per lobe, whatever the number of channels.

mod search;
mod tints;

use glanz_bsdf::{DirectionPair, ParamError, Shape, Side};

use crate::Readings;

/// What is made as small as possible: the squares of differences of g(f cosθi).
///
/// ```
/// use glanz_measure::Metric;
///
/// assert_eq!(Metric::named("log"), Some(Metric::Log));
/// assert_eq!(Metric::default().name(), "cube-root");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Metric {
    /// g(x) = x: the peaks of highlights count most.
    L2,
    /// g(x) = ln(1 + x).
    Log,
    /// g(x) = ∛x, which is nearest to what people see (A. Fores and others 2012).
    #[default]
    CubeRoot,
}

impl Metric {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::L2 => "l2",
            Self::Log => "log",
            Self::CubeRoot => "cube-root",
        }
    }

    /// The one of this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::L2, Self::Log, Self::CubeRoot].into_iter().find(|metric| metric.name() == name)
    }

    fn of(self, x: f64) -> f64 {
        let x = x.max(0.0);
        match self {
            Self::L2 => x,
            Self::Log => libm::log1p(x),
            Self::CubeRoot => libm::cbrt(x),
        }
    }

    fn slope(self, x: f64) -> f64 {
        match self {
            Self::L2 => 1.0,
            Self::Log => 1.0 / (1.0 + x),
            Self::CubeRoot => 1.0 / (3.0 * libm::cbrt(x * x)),
        }
    }

    /// The weight by which the square of m − y becomes that of g(m) − g(y). `least` stands for numbers near 0.
    fn weight(self, m: f64, y: f64, least: f64) -> f64 {
        let (m, y) = (m.max(least), y.max(least));
        let slope =
            if (m - y).abs() > 1e-6 * y { (self.of(m) - self.of(y)) / (m - y) } else { self.slope(y) };
        slope * slope
    }
}

/// How a fit is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// What is made small.
    pub metric: Metric,
    /// Readings count up to this angle of light and detector from the normal, in degrees.
    pub most_theta_deg: f64,
    /// Of more readings every n-th counts.
    pub most_readings: usize,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { metric: Metric::CubeRoot, most_theta_deg: 80.0, most_readings: 20_000 }
    }
}

/// Why nothing was fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A model is not there, or cannot be one of a fit.
    #[error("{0}")]
    Model(String),
    /// There are too few readings for so many numbers.
    #[error("{readings} readings up to {most_theta_deg}° are too few for {numbers} numbers")]
    TooFew {
        /// How many there are.
        readings: usize,
        /// Up to which angle.
        most_theta_deg: f64,
        /// How many numbers are to be found.
        numbers: usize,
    },
    /// No two lobes can be told apart, or there is no light at all.
    #[error("the readings tell nothing of these lobes: {0}")]
    Nothing(String),
}

/// A lobe that was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedLobe {
    /// The shape, with its parameters.
    pub shape: Shape,
    /// The parameter that was searched, if the model has one.
    pub parameter: Option<&'static str>,
    /// The standard error of the logarithm of that parameter, the other lobes' parameters being free, too; none where it
    /// cannot be told.
    pub log_error: Option<f64>,
    /// Whether the parameter is at an end of its range, where a fit is seldom what it seems.
    pub at_bound: bool,
    /// The tint of each channel.
    pub tint: Vec<f64>,
}

/// What was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The lobes.
    pub lobes: Vec<FittedLobe>,
    /// The root of the mean of the squares of the metric's differences.
    pub error: f64,
    /// The same as a part of that of the readings themselves.
    pub relative: f64,
    /// How many readings counted.
    pub readings: usize,
    /// How often shapes were evaluated at all readings.
    pub evaluations: usize,
}

/// Parameters that are widths, with the range that is searched.
const WIDTHS: [(&str, [f64; 2]); 8] = [
    ("alpha", [0.005, 1.0]),
    ("m", [0.005, 1.0]),
    ("shininess", [1.0, 20_000.0]),
    ("nu", [1.0, 20_000.0]),
    ("n", [1.0, 1000.0]),
    ("sigma_deg", [1.0, 80.0]),
    ("roughness", [0.01, 1.0]),
    ("k", [0.05, 4.0]),
];

/// A lobe that is fitted.
struct Lobe {
    shape: Shape,
    width: Option<(&'static str, [f64; 2])>,
}

impl Lobe {
    fn named(name: &str) -> Result<Self, FitError> {
        let shape = Shape::named(name, &[]).map_err(|error| FitError::Model(error.to_string()))?;
        Self::of(shape)
    }

    fn of(shape: Shape) -> Result<Self, FitError> {
        let info = shape.info();
        if info.delta || info.side == Side::Transmission {
            let message = format!("{} has no values of reflection that could be fitted", info.name);
            return Err(FitError::Model(message));
        }
        let width = info.params.iter().find_map(|param| {
            let (_, [low, high]) = WIDTHS.iter().find(|(name, _)| *name == param.name)?;
            Some((param.name, [low.max(param.min), high.min(param.max)]))
        });
        Ok(Self { shape, width })
    }

    /// With its width.
    fn with(&self, value: f64) -> Result<Shape, ParamError> {
        match self.width {
            Some((name, _)) => self.shape.with(name, value),
            None => Ok(self.shape.clone()),
        }
    }
}

/// Readings as a fit needs them.
struct Samples {
    pairs: Vec<DirectionPair<f64>>,
    /// f cosθi of all channels, reading by reading.
    values: Vec<f64>,
    channels: usize,
    /// Their means over the channels.
    means: Vec<f64>,
    /// What stands for numbers near 0.
    least: f64,
}

impl Samples {
    fn of(readings: &Readings, options: &FitOptions) -> Self {
        let least_cosine = libm::cos(options.most_theta_deg.to_radians());
        let counts = |index: &usize| {
            let [wi, wo] = readings.pair(*index);
            wi.z >= least_cosine
                && wo.z >= least_cosine
                && readings.values(*index).iter().all(|x| x.is_finite())
        };
        let all: Vec<usize> = (0..readings.len()).filter(counts).collect();
        let step = all.len().div_ceil(options.most_readings.max(1)).max(1);
        let channels = readings.channels().count();
        let mut samples =
            Self { pairs: Vec::new(), values: Vec::new(), channels, means: Vec::new(), least: 0.0 };
        for index in all.into_iter().step_by(step) {
            let [wi, wo] = readings.pair(index);
            samples.pairs.push(DirectionPair::new(wo, wi));
            let values = readings.values(index).iter().map(|value| f64::from(*value) * wi.z);
            samples.values.extend(values.clone());
            samples.means.push(values.sum::<f64>() / channels as f64);
        }
        let mean = samples.means.iter().map(|y| y.max(0.0)).sum::<f64>() / samples.means.len().max(1) as f64;
        samples.least = 1e-4 * mean;
        samples
    }

    fn len(&self) -> usize {
        self.pairs.len()
    }

    /// The same with at most three channels, the means of thirds: widths are those of all channels together.
    fn grouped(&self) -> Self {
        let groups = self.channels.min(3);
        let ends: Vec<usize> = (0..=groups).map(|g| g * self.channels / groups).collect();
        let of_reading = |values: &[f64]| -> Vec<f64> {
            ends.windows(2).map(|w| values[w[0]..w[1]].iter().sum::<f64>() / (w[1] - w[0]) as f64).collect()
        };
        Self {
            pairs: self.pairs.clone(),
            values: self.values.chunks_exact(self.channels).flat_map(of_reading).collect(),
            channels: groups,
            means: self.means.clone(),
            least: self.least,
        }
    }

    /// f cosθi of a shape at all of them.
    fn column(&self, shape: &Shape) -> Vec<f64> {
        self.pairs.iter().map(|pair| shape.f_cos(pair)).collect()
    }
}

/// Fits a sum of lobes, by the names of their models.
///
/// ```
/// use glanz_bsdf::{DirectionPair, Shape};
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, FitOptions, Readings, fit};
///
/// // A glossy paint, measured at 30° and 60° in the plane of the light.
/// let (gloss, matte) = (Shape::named("ggx", &[("alpha", 0.2)])?, Shape::named("lambert", &[])?);
/// let mut readings = Readings::new(Channels::Luminance);
/// for theta_i in [30.0_f64, 60.0] {
///     for theta_o in -75..=75 {
///         let wi = Vec3::from_angles(theta_i.to_radians(), std::f64::consts::PI);
///         let wo = Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0);
///         let pair = DirectionPair::new(wo, wi);
///         readings.push(wi, wo, &[((0.1 * gloss.f_cos(&pair) + 0.4 * matte.f_cos(&pair)) / wi.z) as f32]);
///     }
/// }
/// let found = fit(&readings, &["ggx", "lambert"], &FitOptions::default())?;
/// assert!((found.lobes[0].shape.params()[0] - 0.2).abs() < 1e-3);
/// assert!((found.lobes[1].tint[0] - 0.4).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit(readings: &Readings, models: &[&str], options: &FitOptions) -> Result<Fit, FitError> {
    let lobes = models.iter().map(|name| Lobe::named(name)).collect::<Result<Vec<_>, _>>()?;
    fit_lobes(readings, &lobes, options)
}

/// The same for shapes, one's own among them; their width is searched, other parameters stay.
pub fn fit_shapes(readings: &Readings, shapes: Vec<Shape>, options: &FitOptions) -> Result<Fit, FitError> {
    let lobes = shapes.into_iter().map(Lobe::of).collect::<Result<Vec<_>, _>>()?;
    fit_lobes(readings, &lobes, options)
}

fn fit_lobes(readings: &Readings, lobes: &[Lobe], options: &FitOptions) -> Result<Fit, FitError> {
    if lobes.is_empty() || lobes.len() > tints::MOST {
        return Err(FitError::Model(format!("a fit has 1 to {} lobes", tints::MOST)));
    }
    let samples = Samples::of(readings, options);
    let numbers = lobes.len() + lobes.iter().filter(|lobe| lobe.width.is_some()).count();
    if samples.len() < 2 * numbers {
        let (readings, most_theta_deg) = (samples.len(), options.most_theta_deg);
        return Err(FitError::TooFew { readings, most_theta_deg, numbers });
    }
    let grouped = samples.grouped();
    let mut problem = search::Problem::new(&grouped, lobes, options.metric);
    let widths = problem.search()?;
    let errors = problem.errors(&widths)?;
    let evaluations = problem.evaluations();
    let found = search::Problem::new(&samples, lobes, options.metric).fit_at(&widths, &errors)?;
    Ok(Fit { evaluations: found.evaluations + evaluations, ..found })
}
