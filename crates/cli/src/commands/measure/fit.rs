//! `glanz measure fit`: models to readings.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_measure::{Fit, FitError, FitOptions, FittedLobe, FittedParameter, Metric, Readings, fit};
use glanz_picture::output::{OutputError, write_atomically};
use schemars::JsonSchema;
use serde::Serialize;

use super::fitted_material::material;
use super::{ReadArgs, fit_report, read};
use crate::args::check_folder;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs, number};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure fit readings.csv --report fit.svg
  glanz measure fit paint.bsdf --models ggx+lambert,ggx*2+lambert,cook-torrance+oren-nayar -o fit.toml
  glanz measure fit gold.binary --models ggx*2 --metric log --format json
  glanz measure fit brushed.csv --models ggx:aniso:schlick+diffuse -o brushed.toml

Candidates stand between commas, their lobes between +, and *2 is two of one model. Of each lobe one parameter is
searched (alpha, m, shininess, nu, n, sigma_deg, roughness or k, whichever its model has), others stay at their
defaults; tints follow in closed form and are not negative. Behind colons stands more: ggx:schlick has a tint at
normal and one at grazing incidence, in Schlick's form, and ggx:aniso two widths and the direction of the grain,
which all such lobes share. diffuse stands for whichever diffuse model fits best. A column called weight in a
table of readings says how much each counts. Candidates are ranked by the metric's root mean square, over readings
whose light and detector are within --most-theta of the normal. Behind a parameter stands its standard error, in
percent; a parameter at the end of its range is told, since such a fit is seldom what it seems. The file that is
written holds the best one as a material for scenes: readings in RGB as linear sRGB, in wavelengths as tables.";

/// What is tried where nothing is said.
const CANDIDATES: &str = "ward+lambert,cook-torrance+lambert,ggx+lambert,phong-normalized+lambert";

/// Options of `glanz measure fit`.
#[derive(Args, Debug)]
pub(crate) struct FitArgs {
    /// A file of measured reflectance
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    file: PathBuf,

    /// Candidates, such as ggx+lambert,ggx*2+lambert
    #[arg(long, value_name = "LOBES[,LOBES…]", default_value = CANDIDATES)]
    models: String,

    /// What is made small: the differences of the numbers themselves (l2), of their logarithms (log), of their cube
    /// roots (cube-root) or of the lightness L* of each channel (lightness)
    #[arg(long, value_name = "METRIC", value_parser = metric, default_value = "cube-root")]
    metric: Metric,

    /// Readings count up to this angle of light and detector from the normal
    #[arg(long, value_name = "DEGREES", default_value_t = 80.0)]
    most_theta: f64,

    /// Of more readings every n-th counts
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    most_readings: usize,

    /// The scene file with the best one as a material
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// A plot of the best one: readings in the plane of incidence as points, the fit as lines; .svg, .png, .pdf, .csv or
    /// .json
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    report: Option<PathBuf>,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    format: FormatArgs,
}

fn metric(text: &str) -> Result<Metric, String> {
    Metric::named(text).ok_or_else(|| "expected l2, log, cube-root or lightness".to_owned())
}

/// Fits, the best first.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// l2, log, cube-root or lightness
    metric: &'static str,
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
    /// The same as a part of the readings' own
    relative: f64,
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

impl FitArgs {
    /// Fits.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if !(self.most_theta > 5.0 && self.most_theta < 90.0) {
            let message = format!("--most-theta is {}, but must be above 5 and below 90", self.most_theta);
            return Err(Failure::Usage(message));
        }
        let candidates = candidates(&self.models)?;
        if let Some(output) = &self.output {
            check_folder(output)?;
        }
        let report = fit_report::target(self.report.as_deref())?;
        let measured = read(&self.file, &self.read)?;
        let readings = measured.readings();
        let options = FitOptions {
            metric: self.metric,
            most_theta_deg: self.most_theta,
            most_readings: self.most_readings,
        };
        let mut fits = Vec::new();
        for (name, lobes) in &candidates {
            let lobes: Vec<&str> = lobes.iter().map(String::as_str).collect();
            match fit(&readings, &lobes, &options) {
                Ok(found) => fits.push((name.clone(), found)),
                Err(FitError::Model(message)) => {
                    return Err(Failure::Usage(format!("--models {name}: {message}")));
                }
                Err(error) => return Err(Report::new(error).file(&self.file).into()),
            }
        }
        fits.sort_by(|a, b| a.1.error.total_cmp(&b.1.error));
        let mut notes = measured.notes.clone();
        notes.extend(remarks(&fits));
        let file = self.write(&readings, &fits[0].1)?;
        if let Some(report) = report {
            let (name, best) = &fits[0];
            report.save(&mut fit_report::chart(name, &readings, best)?)?;
        }
        let document = self.document(&readings, &fits, file, notes);
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text(&document))
    }

    /// Writes the best one.
    fn write(&self, readings: &Readings, best: &Fit) -> Result<Option<String>, Failure> {
        let Some(output) = &self.output else { return Ok(None) };
        let Some(text) = material(readings.channels(), best) else {
            let report = Report::new("readings in XYZ are no colours of a material");
            return Err(report
                .file(&self.file)
                .help("leave -o out, or give readings in RGB or wavelengths")
                .into());
        };
        write_atomically(output, |out| out.write_all(text.as_bytes()).map_err(OutputError::Stream))?;
        print::note(format_args!("wrote {}", output.display()));
        Ok(Some(output.display().to_string()))
    }

    fn document(
        &self,
        readings: &Readings,
        fits: &[(String, Fit)],
        file: Option<String>,
        notes: Vec<String>,
    ) -> Document {
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
        let of = |(models, fit): &(String, Fit)| FitFacts {
            models: models.clone(),
            error: fit.error,
            relative: fit.relative,
            readings: fit.readings,
            aniso_deg: fit.aniso_deg,
            lobes: fit.lobes.iter().map(lobe).collect(),
        };
        Document {
            metric: self.metric.name(),
            channels: readings.channels().names(),
            fits: fits.iter().map(of).collect(),
            file,
            notes,
        }
    }
}

/// `ggx*2+lambert,ward`: each with the names of its lobes.
fn candidates(text: &str) -> Result<Vec<(String, Vec<String>)>, Failure> {
    let mut all = Vec::new();
    for candidate in text.split(',').map(str::trim).filter(|candidate| !candidate.is_empty()) {
        let mut lobes = Vec::new();
        for part in candidate.split('+').map(str::trim) {
            let (name, times) = part.split_once('*').unwrap_or((part, "1"));
            let times: usize =
                times.trim().parse().ok().filter(|n| (1..=3).contains(n)).ok_or_else(|| {
                    Failure::Usage(format!(
                        "--models {candidate}: '{part}' is no lobe, or more than three of one"
                    ))
                })?;
            lobes.extend(std::iter::repeat_n(name.trim().to_owned(), times));
        }
        all.push((candidate.to_owned(), lobes));
    }
    match all.is_empty() {
        true => Err(Failure::Usage("--models names no candidate".to_owned())),
        false => Ok(all),
    }
}

/// Noise takes a tint at grazing incidence this far, but no farther.
const BRIGHTEST_GRAZING: f64 = 1.1;

/// What a reader of the fits should know.
fn remarks(fits: &[(String, Fit)]) -> Vec<String> {
    let mut notes = Vec::new();
    let (name, best) = &fits[0];
    for lobe in &best.lobes {
        for parameter in lobe.parameters.iter().filter(|parameter| parameter.at_bound) {
            let model = lobe.shape.info().name;
            notes.push(format!("{name}: {} of {model} is at the end of its range", parameter.name));
        }
    }
    let is_absent = |lobe: &FittedLobe| lobe.tints().flatten().all(|tint| *tint == 0.0);
    if best.lobes.iter().any(is_absent) {
        notes.push(format!("{name}: one of its lobes is not there; fewer say the same"));
    }
    let too_bright = |tint: &Vec<f64>| tint.iter().any(|tint| *tint > BRIGHTEST_GRAZING);
    for lobe in best.lobes.iter().filter(|lobe| lobe.tint_at_grazing.as_ref().is_some_and(too_bright)) {
        let model = lobe.shape.info().name;
        notes.push(format!(
            "{name}: the tint of {model} at grazing incidence is above 1: its masking does not fit"
        ));
    }
    if let Some((simpler, fit)) = fits.iter().find(|(_, fit)| fit.lobes.len() < best.lobes.len())
        && fit.error < 1.05 * best.error
    {
        let percent = 100.0 * (fit.error / best.error - 1.0);
        notes.push(format!("{simpler} has fewer lobes and is {percent:.1} % worse: no better than that"));
    }
    notes
}

/// For people.
fn text(facts: &Document) -> String {
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
        if let Some(degrees) = fit.aniso_deg {
            writeln!(text, "   grain at {degrees:.1}°").expect("a string takes everything");
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
