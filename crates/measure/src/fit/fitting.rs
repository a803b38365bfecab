//! From readings and lobes to a fit.

use glanz_bsdf::DirectionPair;
use glanz_math::Vec3;

use super::errors::ErrorEstimate;
use super::lobe::{self, FitLobe, FittedLobe};
use super::metric::Metric;
use super::problem::{Problem, has_grain};
use super::samples::{Samples, schlick_layers};
use super::{refine, rendered, search, tints};
use crate::Readings;

/// How a fit is made.
///
/// ```
/// use glanz_measure::{FitOptions, Metric};
///
/// // Peaks of highlights count most, and every reading up to 60° from the normal.
/// let options =
///     FitOptions { metric: Metric::L2, most_theta_deg: 60.0, most_readings: usize::MAX };
/// assert_eq!((options.metric.name(), FitOptions::default().metric), ("l2", Metric::CubeRoot));
/// ```
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

/// What was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The lobes.
    pub lobes: Vec<FittedLobe>,
    /// The azimuth of the x axis of anisotropic shapes, in degrees, 0 … 180: the `aniso_deg` of a material. None where all
    /// lobes are isotropic.
    pub aniso_deg: Option<f64>,
    /// The error with equal widths, where two widths were not asked for and are clearly better.
    pub isotropic_error: Option<f64>,
    /// How the standard errors of parameters were found.
    pub error_estimate: ErrorEstimate,
    /// The root of the mean of the squares of the metric's differences.
    pub error: f64,
    /// The same as a part of that of the readings themselves.
    pub relative: f64,
    /// How many readings counted.
    pub readings: usize,
    /// How often shapes were evaluated at all readings.
    pub evaluations: usize,
}

impl Fit {
    /// The BRDF that was fitted, in 1/sr, for directions to the light and to the viewer above the surface: one value per
    /// channel, for plots, spheres and virtual instruments.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, FitOptions, Readings, fit};
    ///
    /// let mut readings = Readings::new(Channels::Luminance);
    /// let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
    /// (0..60).for_each(|theta_o| readings.push(wi, Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0), &[0.2]));
    /// let found = fit(&readings, &["lambert"], &FitOptions::default())?;
    /// assert!((found.brdf(wi, wi)[0] - 0.2).abs() < 1e-6);
    /// # Ok::<(), glanz_measure::FitError>(())
    /// ```
    pub fn brdf(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
        let (sin, cos) = libm::sincos(self.aniso_deg.unwrap_or(0.0).to_radians());
        let turn = |w: Vec3<f64>| Vec3::new(cos * w.x + sin * w.y, cos * w.y - sin * w.x, w.z);
        let pair = DirectionPair::new(turn(wo), turn(wi));
        let mut sum = vec![0.0; self.lobes.first().map_or(0, |lobe| lobe.tint.len())];
        for lobe in &self.lobes {
            let value = lobe.shape.f_cos(&pair) / wi.z;
            let parts = match lobe.tint_at_grazing {
                None => [value, 0.0],
                Some(_) => schlick_layers().map(|layer| layer.factor(&pair) * value),
            };
            for (tint, part) in lobe.tints().zip(parts) {
                sum.iter_mut().zip(tint).for_each(|(sum, tint)| *sum += tint * part);
            }
        }
        sum
    }
}

/// Fits a sum of lobes, by the names of their models. `:schlick` and `:aniso` may stand behind a name, as for [`FitLobe::named`];
/// `diffuse` is whichever diffuse model fits best, where one with a parameter more must lower the error by 1 %. If light came
/// from three azimuths or more, two widths and the direction of the grain are tried for all lobes that have them, and kept if
/// they lower the error by a tenth, which [`Fit::isotropic_error`] tells; `:iso` forbids it, and so does one `:aniso`.
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
///
/// # Errors
///
/// [`FitError::Model`] for models that are not there, and for none or too many of them; [`FitError::TooFew`] and
/// [`FitError::Nothing`] for readings that cannot tell.
pub fn fit(readings: &Readings, models: &[&str], options: &FitOptions) -> Result<Fit, FitError> {
    let mut progress = |_: f64| {};
    fit_observed(readings, models, options, &mut progress)
}

/// The same as [`fit()`], and tells as it goes which part of it is done, 0 to 1.
///
/// # Errors
///
/// As of [`fit()`].
pub fn fit_observed(
    readings: &Readings,
    models: &[&str],
    options: &FitOptions,
    progress: &mut dyn FnMut(f64),
) -> Result<Fit, FitError> {
    let choices = lobe::choices(models)?;
    let is_free = choices.first().is_some_and(|lobes| !has_grain(lobes)) && readings.have_turns();
    let count = choices.len() + usize::from(is_free);
    let mut best: Option<(Vec<FitLobe>, Fit)> = None;
    for (done, lobes) in choices.into_iter().enumerate() {
        let from = done as f64 / count as f64;
        let found = observed(readings, &lobes, options, &mut |part| progress(from + part / count as f64))?;
        let parameters = |fit: &Fit| fit.lobes.iter().map(|lobe| lobe.parameters.len()).sum::<usize>();
        let is_better = |(_, before): &(_, Fit)| {
            let has_more = parameters(&found) > parameters(before);
            found.error < before.error * if has_more { 1.0 - WORTH_A_PARAMETER } else { 1.0 }
        };
        if best.as_ref().is_none_or(is_better) {
            best = Some((lobes, found));
        }
    }
    let (lobes, found) = best.ok_or_else(|| FitError::Model("a fit has lobes".to_owned()))?;
    let from = (count - usize::from(is_free)) as f64 / count as f64;
    let mut rest = |part: f64| progress(from + part * (1.0 - from));
    let found = if is_free { with_two_widths(readings, &lobes, found, options, &mut rest) } else { found };
    progress(1.0);
    Ok(found)
}

/// The fit with two widths where that is clearly better.
fn with_two_widths(
    readings: &Readings,
    lobes: &[FitLobe],
    equal: Fit,
    options: &FitOptions,
    progress: &mut dyn FnMut(f64),
) -> Fit {
    let stretched: Vec<FitLobe> = lobes.iter().map(FitLobe::stretched).collect();
    if !has_grain(&stretched) {
        return equal;
    }
    // Too few readings for more parameters are no reason to have none.
    match observed(readings, &stretched, options, progress) {
        Ok(found) if found.error < (1.0 - WORTH_TWO_WIDTHS) * equal.error => {
            Fit { isotropic_error: Some(equal.error), ..found }
        }
        _ => equal,
    }
}

/// Two widths, and an azimuth, are taken if they lower the error by this part: more than noise, and than the misfit of a model to
/// an isotropic surface at azimuths that are read unevenly.
const WORTH_TWO_WIDTHS: f64 = 0.1;

/// Of two diffuse shapes the one with more parameters is taken if it lowers the error by this part.
const WORTH_A_PARAMETER: f64 = 0.01;

/// Readings with which the search begins.
const FIRST_READINGS: usize = 4000;
/// Readings with which it goes on if there are many more.
const SECOND_READINGS: usize = 40_000;

/// Fits a sum of lobes: with shapes, one's own among them, parameters and ranges as they are wanted.
///
/// ```
/// use glanz_bsdf::{DirectionPair, Shape};
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, FitLobe, FitOptions, Readings, fit_lobes};
///
/// let mut readings = Readings::new(Channels::Luminance);
/// let paint = Shape::named("beckmann", &[("alpha", 0.3), ("multiscatter", 0.0)])?;
/// for theta_o in -60..=60 {
///     let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
///     let wo = Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0);
///     readings.push(wi, wo, &[(0.2 * paint.f_cos(&DirectionPair::new(wo, wi)) / wi.z) as f32]);
/// }
/// // Single reflections only, and a width of which something is known.
/// let single = Shape::named("beckmann", &[("multiscatter", 0.0)])?;
/// let lobe = FitLobe::of(single)?.searching("alpha", [0.1, 0.5])?;
/// let found = fit_lobes(&readings, &[lobe], &FitOptions::default())?;
/// assert!((found.lobes[0].parameters[0].value - 0.3).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// As of [`fit()`].
pub fn fit_lobes(readings: &Readings, lobes: &[FitLobe], options: &FitOptions) -> Result<Fit, FitError> {
    observed(readings, lobes, options, &mut |_| {})
}

/// The same, and tells as it goes which part of it is done.
fn observed(
    readings: &Readings,
    lobes: &[FitLobe],
    options: &FitOptions,
    progress: &mut dyn FnMut(f64),
) -> Result<Fit, FitError> {
    progress(0.0);
    let columns: usize = lobes.iter().map(FitLobe::columns).sum();
    let searched = lobes.iter().map(|lobe| lobe.parameters().count()).sum::<usize>();
    let parameters = searched + usize::from(has_grain(lobes));
    if columns == 0 || columns > tints::MOST || parameters > refine::MOST_PARAMETERS {
        let (tints, parameters) = (tints::MOST, refine::MOST_PARAMETERS);
        let message = format!("a fit has lobes with 1 to {tints} tints and up to {parameters} parameters");
        return Err(FitError::Model(message));
    }
    let samples = Samples::of(readings, options);
    let numbers = columns + parameters;
    if samples.len() < 2 * numbers {
        let (readings, most_theta_deg) = (samples.len(), options.most_theta_deg);
        return Err(FitError::TooFew { readings, most_theta_deg, numbers });
    }
    match options.metric {
        Metric::Rendered => rendered::fit_samples(&samples, readings.channels(), lobes, progress),
        metric => fit_samples(&samples, lobes, metric, progress),
    }
}

/// Parts of the time that the search and the steps with fewer readings take, about.
const SEARCHED: f64 = 0.3;
const STEPPED: f64 = 0.4;

/// From few readings and up to three channels to all of them.
pub(super) fn fit_samples(
    samples: &Samples,
    lobes: &[FitLobe],
    metric: Metric,
    progress: &mut dyn FnMut(f64),
) -> Result<Fit, FitError> {
    let groups = samples.grouped();
    let grouped = groups.as_ref().unwrap_or(samples);
    let found = search::search(&grouped.thinned(FIRST_READINGS), lobes, metric)?;
    progress(SEARCHED);
    let (mut ends, mut evaluations) = (found.ends, found.evaluations);
    let mut tints = None;
    if grouped.len() > 2 * SECOND_READINGS {
        let fewer = grouped.thinned(SECOND_READINGS);
        let mut problem = Problem::new(&fewer, lobes, metric);
        let refined = problem.refine_best(&ends, None, &mut |_| {})?;
        progress(STEPPED);
        (ends, tints) = (vec![refined.point], Some(refined.tints));
        evaluations += problem.evaluations();
    }
    let mut problem = Problem::new(grouped, lobes, metric);
    let mut rest = |part: f64| progress(STEPPED + part * (1.0 - STEPPED));
    let refined = problem.refine_best(&ends, tints.as_deref(), &mut rest)?;
    tints = Some(refined.tints);
    if groups.is_some() {
        evaluations += problem.evaluations();
        problem = Problem::new(samples, lobes, metric);
        tints = None;
    }
    let found = problem.fit_at(&refined.point, &refined.errors, tints.as_deref())?;
    Ok(Fit { evaluations: found.evaluations + evaluations, ..found })
}
