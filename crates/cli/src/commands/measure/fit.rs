//! `glanz measure fit`: models to readings.

use std::io::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_measure::{Fit, FitError, FitOptions, FittedLobe, Metric, Readings, fit_observed};
use glanz_picture::output::{OutputError, write_atomically};

pub(crate) use super::fit_facts::Document;
use super::fit_facts::{Candidate, text};
use super::fit_rank::RankBy;
use super::fitted_material::material;
use super::{ReadArgs, fit_rank, fit_report, read};
use crate::args::{check_apart, check_beside};
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure fit readings.csv --report fit.svg
  glanz measure fit paint.bsdf --models ggx+lambert,ggx*2+lambert,cook-torrance+oren-nayar -o fit.toml
  glanz measure fit gold.binary --models ggx*2 --metric log --format json
  glanz measure fit paint.bsdf --metric rendered --rank-by balls
  glanz measure fit brushed.csv --models ggx:aniso:schlick+diffuse -o brushed.toml

Candidates stand between commas, their lobes between +, and *2 is two of one model. Of each lobe one parameter is
searched (alpha, m, shininess, nu, n, sigma_deg, roughness or k, whichever its model has), others stay at their
defaults; tints follow in closed form and are not negative. Behind colons stands more: ggx:schlick has a tint at
normal and one at grazing incidence, in Schlick's form, and ggx:aniso two widths and the direction of the grain,
which all such lobes share. Where light came from three azimuths or more, both are tried for every model that has
two widths, and kept if they lower the error by a tenth; ggx:iso forbids it. diffuse stands for whichever diffuse
model fits best. A column called weight in a table of readings says how much each counts. Candidates are ranked by
the metric's root mean square, over readings whose light and detector are within --most-theta of the normal, or by
--rank-by. Behind a parameter stands its standard error, in percent; a parameter at the end of its range is told,
since such a fit is seldom what it seems. dE00 is CIEDE2000 between readings and fit as points of a sphere under
one lamp, exposed so that a perfect diffuser that faces it is white (D65), which --metric rendered makes small. The
file that is written holds the best one as a material for scenes: readings in RGB as linear sRGB, in wavelengths
as tables.";

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
    /// roots (cube-root), of the lightness L* of each channel (lightness) or of the colours on a sphere under one lamp,
    /// CIEDE2000 (rendered)
    #[arg(long, value_name = "METRIC", value_parser = metric, default_value = "cube-root")]
    metric: Metric,

    /// What candidates are ranked by: the metric's error (metric), the mean CIEDE2000 of readings (rendered) or of balls
    /// in a studio (balls), which are drawn of the data and of each fit
    #[arg(long, value_enum, value_name = "WHAT", default_value_t)]
    rank_by: RankBy,

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
    Metric::named(text).ok_or_else(|| "expected l2, log, cube-root, lightness or rendered".to_owned())
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
            check_beside("-o", output)?;
        }
        let report = fit_report::target(self.report.as_deref())?;
        check_apart([("-o", self.output.as_deref()), ("--report", self.report.as_deref())])?;
        let measured = read(&self.file, &self.read)?;
        let readings = measured.readings();
        let options = FitOptions {
            metric: self.metric,
            most_theta_deg: self.most_theta,
            most_readings: self.most_readings,
        };
        let mut fits = self.fits(&candidates, &readings, &options)?;
        fit_rank::rank(&mut fits, self.rank_by, &measured, &self.file)?;
        let mut notes = measured.notes.clone();
        notes.extend(remarks(&fits));
        let file = self.write(&readings, &fits[0].fit)?;
        if let Some(report) = report {
            let Candidate { models, fit, .. } = &fits[0];
            report.save(&mut fit_report::chart(models, &readings, fit)?)?;
        }
        let document =
            Document::new([self.metric.name(), self.rank_by.name()], &readings, &fits, file, notes);
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text(&document))
    }

    /// A fit of each candidate.
    fn fits(
        &self,
        candidates: &[(String, Vec<String>)],
        readings: &Readings,
        options: &FitOptions,
    ) -> Result<Vec<Candidate>, Failure> {
        let mut progress = Progress::new(candidates.len(), "fits");
        let mut fits = Vec::new();
        for (name, lobes) in candidates {
            let lobes: Vec<&str> = lobes.iter().map(String::as_str).collect();
            match fit_observed(readings, &lobes, options, &mut |part| progress.within(part)) {
                Ok(found) => fits.push(Candidate::new(name, found, readings, options)),
                Err(FitError::Model(message)) => {
                    return Err(Failure::Usage(format!("--models {name}: {message}")));
                }
                Err(error) => return Err(Report::new(error).file(&self.file).into()),
            }
            progress.step();
        }
        Ok(fits)
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
fn remarks(fits: &[Candidate]) -> Vec<String> {
    let mut notes = Vec::new();
    let Candidate { models: name, fit: best, .. } = &fits[0];
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
    if let Some(simpler) = fits.iter().find(|other| other.fit.lobes.len() < best.lobes.len())
        && simpler.fit.error < 1.05 * best.error
    {
        let percent = 100.0 * (simpler.fit.error / best.error - 1.0);
        let models = &simpler.models;
        notes.push(format!("{models} has fewer lobes and is {percent:.1} % worse: no better than that"));
    }
    notes
}
