//! `glanz measure compare`: how far two reflectances are apart, in numbers and in pictures.

use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use glanz_color::difference::ciede2000;
use glanz_color::models::{Lab, Xyz};
use glanz_math::Vec3;
use glanz_measure::{Metric, spiral_about_mirror};
use glanz_picture::compare::Spread;
use glanz_plot::{Figure, PlotData, PlotFormat};
use glanz_render::MaterialResponse;
use glanz_scene::LightColor;
use schemars::JsonSchema;
use serde::Serialize;

use super::ReadArgs;
use super::balls::{Balls, Drawn};
use super::sheet::Pair;
use super::surface::Surface;
use crate::args::{MachineArgs, PlotTarget, TargetArgs, size};
use crate::encode;
use crate::input::spectra::{light_source, observer_source};
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure compare paint.bsdf readings.csv
  glanz measure compare paint.bsdf fit.toml -o compared.png
  glanz measure compare paint.bsdf readings.csv --sheet -o compared.png
  glanz measure compare paint.bsdf readings.csv --sheet -o slices.csv
  glanz measure compare gold.binary gold --light A --format json

Each is a file of measured reflectance, a scene file with one material, such as glanz measure fit -o writes, a
material of glanz material list, or a model of glanz bsdf list. Numbers are of pairs of directions: those of the
readings, where either is a file of them, else pairs dense about the mirror direction, all within 80 degrees of
the normal. Differences of colour are of radiance factors; metrics are root mean squares of the luminance factor
times the cosine of the light, of its logarithm and of its cube root, as parts of those of the first. Pictures
are balls under two lamps, and under them in a studio, with a map of their differences. --sheet adds slices of Y
over the angle of the detector and polar cuts, both in the plane of incidence, with the readings as points; as .csv
and .json, and in --format json, their numbers come out.";

/// More pairs than this are thinned.
const MOST_PAIRS: usize = 5000;

/// The least cosine of light and detector.
const LEAST_COSINE: f64 = 0.1736;

/// Options of `glanz measure compare`.
#[derive(Args, Debug)]
pub(crate) struct CompareArgs {
    /// What the other is compared with: a file, or the name of a material or a model
    #[arg(value_name = "REFERENCE")]
    reference: String,

    /// What is compared with it
    #[arg(value_name = "OTHER")]
    other: String,

    /// A PNG with balls of both and maps of their differences; of a sheet also .svg or .pdf, or .csv or .json with the
    /// numbers of its plots
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Output")]
    output: Option<PathBuf>,

    /// Make it a sheet with slices and polar cuts, too
    #[arg(long, help_heading = "Output")]
    sheet: bool,

    /// Width and height of each ball, in pixels
    #[arg(long, value_name = "WxH", default_value = "320x320", value_parser = size)]
    size: (u32, u32),

    /// The light of colours and balls: a name or a file
    #[arg(long, value_name = "LIGHT", default_value = "D65")]
    light: String,

    /// The observer of the colours of pairs, who must have X, Y and Z
    #[arg(long, value_name = "OBSERVER", default_value = "cie1931")]
    observer: String,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// How far two reflectances are apart.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    reference: String,
    other: String,
    /// How many pairs of directions
    pairs: usize,
    /// CIEDE2000 of the radiance factors of pairs
    delta_e: SpreadFacts,
    /// Root mean squares of differences, as parts of those of the reference
    metrics: Vec<MetricFacts>,
    /// CIEDE2000 of the pixels of balls
    balls: Vec<BallFacts>,
    /// The file that was written
    file: Option<String>,
    /// Slices and polar cuts, with --sheet
    plots: Option<PlotData>,
    notes: Vec<String>,
}

/// How values are spread.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct SpreadFacts {
    pub(super) mean: f64,
    pub(super) median: f64,
    /// What 95 of 100 stay below
    pub(super) p95: f64,
    pub(super) max: f64,
}

#[derive(Debug, Serialize, JsonSchema)]
struct MetricFacts {
    /// l2, log or cube-root
    metric: &'static str,
    relative: f64,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct BallFacts {
    /// lamps or studio
    pub(super) stage: &'static str,
    pub(super) delta_e: SpreadFacts,
}

impl SpreadFacts {
    pub(super) fn of(Spread { mean, median, p95, max }: Spread) -> Self {
        Self { mean, median, p95, max }
    }
}

impl BallFacts {
    fn of((stage, spread): (&'static str, Spread)) -> Self {
        Self { stage, delta_e: SpreadFacts::of(spread) }
    }
}

impl CompareArgs {
    /// Compares.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let target = self.target()?;
        let light = light_source(&self.light)?;
        let observer = observer_source(&self.observer)?;
        let words = [&self.reference, &self.other];
        // Data are fitted and smoothed before they are drawn, which takes as long as a picture or longer.
        let mut progress = Progress::new(2 + 2 * Drawn::PICTURES, "steps");
        let [a, b] = words.map(|word| {
            let surface = Surface::of(word, &self.read);
            progress.step();
            surface
        });
        let surfaces = [a?, b?];
        let response =
            |surface: &Surface| MaterialResponse::new(&surface.material, &light.spectrum, &observer);
        let responses =
            [response(&surfaces[0]).map_err(Failure::new)?, response(&surfaces[1]).map_err(Failure::new)?];
        let pairs = pairs(&surfaces);
        let (delta_e, metrics) = of_pairs(&pairs, &responses);
        let lamp = LightColor::unit(&light.spectrum)
            .ok_or_else(|| Failure::new(format_args!("--light '{}' sends no light", self.light)))?;
        let mut draw = |surface: &Surface| Drawn::of(&surface.material, &lamp, self.size, &mut progress);
        let balls = Balls::of([draw(&surfaces[0])?, draw(&surfaces[1])?], self.size)?;
        let spreads = balls.spreads();
        let names = words.map(|word| file_name(word));
        let (light, observer) = (&light, &observer);
        let pair = Pair { names, surfaces: &surfaces, responses: &responses, light, observer };
        let plots = target.deliver(balls, &pair)?;
        let document = Document {
            reference: self.reference.clone(),
            other: self.other.clone(),
            pairs: pairs.len(),
            delta_e: SpreadFacts::of(delta_e),
            metrics,
            balls: spreads.map(BallFacts::of).into(),
            file: self.output.as_ref().map(|path| path.display().to_string()),
            plots,
            notes: notes(surfaces, &responses, names),
        };
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text(&document))
    }

    fn target(&self) -> Result<Target, Failure> {
        match (&self.output, self.sheet) {
            (None, true) if !self.format.is_json() => {
                let message = "--sheet is drawn into a file; name it with -o, such as -o compared.png";
                Err(Failure::Usage(message.to_owned()))
            }
            (path, true) => path.as_deref().map(PlotTarget::of_file).transpose().map(Target::Sheet),
            (None, false) => Ok(Target::None),
            (Some(path), false) => {
                let is_sheet = |format: PlotFormat| format != PlotFormat::Png;
                if PlotFormat::from_path(path).is_ok_and(is_sheet) {
                    let path = path.display();
                    let message = format!("balls are written as .png; '{path}' may be a sheet, by --sheet");
                    return Err(Failure::Usage(message));
                }
                let target = TargetArgs { output: Some(path.clone()), force: false }.resolve(path, "")?;
                encode::expect_png(&target, "a comparison without --sheet")?;
                self.format.check_beside(&target)?;
                Ok(Target::Balls(target))
            }
        }
    }
}

/// What is drawn, checked before any work is done.
enum Target {
    /// Balls, into a PNG.
    Balls(crate::args::Target),
    /// A sheet; into no file where its numbers alone are asked for.
    Sheet(Option<PlotTarget>),
    /// Nothing.
    None,
}

impl Target {
    /// Draws it; gives the numbers of a sheet's plots.
    fn deliver(self, balls: Balls, pair: &Pair<'_>) -> Result<Option<PlotData>, Failure> {
        match self {
            Self::Balls(target) => {
                encode::deliver(balls.sheet(pair.names)?.into(), &target, &encode::metadata(0))?;
                Ok(None)
            }
            Self::Sheet(file) => {
                let mut sheet = pair.sheet(balls);
                file.map_or(Ok(()), |file| file.save(&mut sheet))?;
                Ok(Some(sheet.data()))
            }
            Self::None => Ok(None),
        }
    }
}

/// A word, or the name of a file without its folders.
fn file_name(word: &str) -> &str {
    Path::new(word).file_name().and_then(std::ffi::OsStr::to_str).unwrap_or(word)
}

/// Pairs of directions above the horizon: those of readings where there are some.
fn pairs(surfaces: &[Surface; 2]) -> Vec<[Vec3<f64>; 2]> {
    let all = surfaces.iter().find_map(Surface::pairs).unwrap_or_else(spiral_about_mirror);
    let is_above = |[wi, wo]: &[Vec3<f64>; 2]| wi.z > LEAST_COSINE && wo.z > LEAST_COSINE;
    let above: Vec<_> = all.into_iter().filter(is_above).collect();
    let step = above.len().div_ceil(MOST_PAIRS).max(1);
    above.into_iter().step_by(step).collect()
}

/// Differences of colour, and the metrics.
fn of_pairs(
    pairs: &[[Vec3<f64>; 2]],
    [reference, other]: &[MaterialResponse; 2],
) -> (Spread, Vec<MetricFacts>) {
    let white = Xyz(reference.white());
    let lab =
        |xyz: [f64; 3]| Lab::for_white(Xyz(xyz.map(|value| (value * core::f64::consts::PI).max(0.0))), white);
    let mut differences = Vec::with_capacity(pairs.len());
    let names = [Metric::L2, Metric::Log, Metric::CubeRoot];
    let mut squares = [[0.0; 2]; 3];
    for [wi, wo] in pairs {
        let (a, b) = (reference.brdf(*wi, *wo), other.brdf(*wi, *wo));
        differences.push(ciede2000(lab(a), lab(b)) as f32);
        for (metric, sums) in names.iter().zip(&mut squares) {
            let [a, b] = [a, b].map(|xyz| metric.of(xyz[1] * wi.z));
            sums[0] += (a - b) * (a - b);
            sums[1] += a * a;
        }
    }
    let facts = |(metric, [off, own]): (&Metric, [f64; 2])| MetricFacts {
        metric: metric.name(),
        relative: (off / own.max(f64::MIN_POSITIVE)).sqrt(),
    };
    (Spread::of(&differences), names.iter().zip(squares).map(facts).collect())
}

/// What readers of the numbers should know.
fn notes(surfaces: [Surface; 2], responses: &[MaterialResponse; 2], names: [&str; 2]) -> Vec<String> {
    let mut notes: Vec<String> = surfaces.into_iter().flat_map(|surface| surface.notes).collect();
    for (_, name) in responses.iter().zip(names).filter(|(response, _)| response.has_mirror()) {
        notes.push(format!("{name} has a perfect mirror, which balls show and numbers of pairs do not"));
    }
    notes
}

fn text(facts: &Document) -> String {
    let spread = |name: &str, own: &SpreadFacts| {
        let [mean, median, p95, max] = [own.mean, own.median, own.p95, own.max].map(number);
        format!("{name:<10} ΔE00 mean {mean}, median {median}, 95 of 100 below {p95}, greatest {max}\n")
    };
    let mut text = spread("pairs", &facts.delta_e);
    for ball in &facts.balls {
        text += &spread(ball.stage, &ball.delta_e);
    }
    for MetricFacts { metric, relative } in &facts.metrics {
        text += &format!("{metric:<10} {:.1} %, of {} pairs\n", 100.0 * relative, facts.pairs);
    }
    for note in &facts.notes {
        text += &format!("note: {note}\n");
    }
    text
}
