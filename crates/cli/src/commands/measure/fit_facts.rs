//! What `glanz measure fit` tells of fits.

use std::fmt::Write as _;

use glanz_measure::{Fit, FitOptions, FittedLobe, FittedParameter, Readings};
use glanz_picture::compare::Spread;
use schemars::JsonSchema;
use serde::Serialize;

use super::compare::{BallFacts, SpreadFacts};
use crate::print::number;

/// A candidate that was fitted.
pub(super) struct Candidate {
    /// As it was asked for.
    pub(super) models: String,
    pub(super) fit: Fit,
    /// CIEDE2000 of readings as they are rendered.
    pub(super) delta_e: Spread,
    /// CIEDE2000 of balls, by the names of their stages.
    pub(super) balls: Vec<(&'static str, Spread)>,
}

impl Candidate {
    /// With differences of readings, and of no balls yet.
    pub(super) fn new(models: &str, fit: Fit, readings: &Readings, options: &FitOptions) -> Self {
        let differences: Vec<f32> =
            fit.delta_e(readings, options).into_iter().map(|delta_e| delta_e as f32).collect();
        Self { models: models.to_owned(), fit, delta_e: Spread::of(&differences), balls: Vec::new() }
    }
}

/// Fits, the best first.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// l2, log, cube-root, lightness or rendered
    metric: &'static str,
    /// What the fits are ranked by: metric, rendered or balls
    ranked_by: &'static str,
    /// Names of the channels
    channels: Vec<String>,
    fits: Vec<FitFacts>,
    /// The file that was written
    file: Option<String>,
    notes: Vec<String>,
}

/// One candidate.
#[derive(Debug, Serialize, JsonSchema)]
struct FitFacts {
    /// As it was asked for
    models: String,
    /// Root mean square of the metric's differences
    error: f64,
    /// The same with equal widths, where two were tried and are clearly better; else null
    isotropic_error: Option<f64>,
    /// The same as a part of the readings' own
    relative: f64,
    /// How standard errors were found: profile, all differences having one variance, or sandwich, from each as it is, where they
    /// grow with the value
    error_estimate: &'static str,
    /// CIEDE2000 between readings and fit, as points of a sphere under one lamp
    delta_e: SpreadFacts,
    /// CIEDE2000 of the pixels of balls of data and fit; none unless they are ranked by it
    balls: Vec<BallFacts>,
    /// Readings that counted
    readings: usize,
    /// The azimuth of the x axis of anisotropic lobes, in degrees; null where there are none
    aniso_deg: Option<f64>,
    lobes: Vec<LobeFacts>,
}

/// A lobe.
#[derive(Debug, Serialize, JsonSchema)]
struct LobeFacts {
    model: &'static str,
    /// The parameters that were searched
    parameters: Vec<ParameterFacts>,
    /// Per channel; in Schlick's form at normal incidence
    tint: Vec<f64>,
    /// In Schlick's form the tint at grazing incidence, per channel; null for others
    tint_at_grazing: Option<Vec<f64>>,
}

/// A parameter that was searched.
#[derive(Debug, Serialize, JsonSchema)]
struct ParameterFacts {
    name: &'static str,
    value: f64,
    /// Its standard error, as a part of it; null where it cannot be told
    standard_error: Option<f64>,
    /// Whether it is at the end of its range
    at_bound: bool,
}

impl Document {
    /// Of fits by a metric, ranked by something.
    pub(super) fn new(
        [metric, ranked_by]: [&'static str; 2],
        readings: &Readings,
        fits: &[Candidate],
        file: Option<String>,
        notes: Vec<String>,
    ) -> Self {
        let channels = readings.channels().names();
        Self { metric, ranked_by, channels, fits: fits.iter().map(FitFacts::of).collect(), file, notes }
    }
}

impl FitFacts {
    fn of(Candidate { models, fit, delta_e, balls }: &Candidate) -> Self {
        let parameter = |parameter: &FittedParameter| ParameterFacts {
            name: parameter.name,
            value: parameter.value,
            standard_error: parameter.log_error,
            at_bound: parameter.at_bound,
        };
        let lobe = |lobe: &FittedLobe| LobeFacts {
            model: lobe.shape.info().name,
            parameters: lobe.parameters.iter().map(parameter).collect(),
            tint: lobe.tint.clone(),
            tint_at_grazing: lobe.tint_at_grazing.clone(),
        };
        let ball =
            |(stage, spread): &(&'static str, Spread)| BallFacts { stage, delta_e: SpreadFacts::of(*spread) };
        Self {
            models: models.clone(),
            error: fit.error,
            isotropic_error: fit.isotropic_error,
            relative: fit.relative,
            error_estimate: fit.error_estimate.name(),
            delta_e: SpreadFacts::of(*delta_e),
            balls: balls.iter().map(ball).collect(),
            readings: fit.readings,
            aniso_deg: fit.aniso_deg,
            lobes: fit.lobes.iter().map(lobe).collect(),
        }
    }
}

/// For people.
pub(super) fn text(facts: &Document) -> String {
    let mut text = String::new();
    for (rank, fit) in facts.fits.iter().enumerate() {
        let (error, relative) = (number(fit.error), 100.0 * fit.relative);
        writeln!(
            text,
            "{}. {}: error {error} ({relative:.1} %), {} readings",
            rank + 1,
            fit.models,
            fit.readings
        )
        .expect("a string takes everything");
        let SpreadFacts { median, p95, .. } = &fit.delta_e;
        writeln!(
            text,
            "   readings as rendered: ΔE00 median {}, 95 of 100 below {}",
            number(*median),
            number(*p95)
        )
        .expect("a string takes everything");
        for BallFacts { stage, delta_e: SpreadFacts { mean, median, p95, .. } } in &fit.balls {
            let [mean, median, p95] = [*mean, *median, *p95].map(number);
            writeln!(text, "   ball, {stage}: ΔE00 mean {mean}, median {median}, 95 of 100 below {p95}")
                .expect("a string takes everything");
        }
        if let Some(degrees) = fit.aniso_deg {
            let equal = fit.isotropic_error.map(|equal| {
                format!("two widths, grain at {degrees:.1}°: error {error} rather than {}", number(equal))
            });
            let told = equal.unwrap_or_else(|| format!("grain at {degrees:.1}°"));
            writeln!(text, "   {told}").expect("a string takes everything");
        }
        if fit.lobes.iter().flat_map(|lobe| &lobe.parameters).any(|own| own.standard_error.is_some()) {
            writeln!(text, "   standard errors by the {}", fit.error_estimate)
                .expect("a string takes everything");
        }
        for lobe in &fit.lobes {
            let parameters: String = lobe.parameters.iter().map(parameter_text).collect();
            let grazing = lobe.tint_at_grazing.as_ref();
            let grazing = grazing.map(|tint| format!(", {} at grazing", tint_text(tint))).unwrap_or_default();
            writeln!(text, "   {}{parameters} tint {}{grazing}", lobe.model, tint_text(&lobe.tint))
                .expect("a string takes everything");
        }
    }
    for note in &facts.notes {
        writeln!(text, "note: {note}").expect("a string takes everything");
    }
    text
}

/// ` alpha = 0.2 ± 0.1 %,`
fn parameter_text(parameter: &ParameterFacts) -> String {
    let error = parameter.standard_error.map(|x| format!(" ± {:.1} %", 100.0 * x)).unwrap_or_default();
    let bound = if parameter.at_bound { ", at the end of its range" } else { "" };
    format!(" {} = {}{error}{bound},", parameter.name, number(parameter.value))
}

/// The first six channels.
fn tint_text(tint: &[f64]) -> String {
    let few: Vec<String> = tint.iter().take(6).map(|x| format!("{x:.3}")).collect();
    let more = if tint.len() > few.len() { " …" } else { "" };
    format!("{}{more}", few.join(" "))
}
