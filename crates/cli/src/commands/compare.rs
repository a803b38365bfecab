//! `glanz compare`: how far two picture files are apart.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use glanz_math::MemoryBudget;
use glanz_picture::compare::{
    CompareError, DEFAULT_PPD, Measurement, Metric, MetricOptions, PPD_RANGE, Pair, Picture as PictureFile,
    Scale, read_picture_within,
};
use glanz_picture::output::Metadata;
use glanz_plot::heat_map_sheet;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::{MachineArgs, Target, TargetArgs};
use crate::encode;
use crate::input::thresholds::{BoundFacts, Statistic, Threshold, is_spread};
use crate::print::failure::{ErrorFacts, Failure, Report, without_number};
use crate::print::{self, Format, FormatArgs, finite, number};
use crate::progress::Progress;

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz compare a.png b.png
  glanz compare reference.exr b.exr -o errors.png --metric de2000,flip
  glanz compare golden.png new.png --fail-above de2000=0.5,flip.max=0.2 --fail-below ssim=0.99

Two OpenEXR files are compared as linear light without bounds: rmse and psnr are those of
light, ssim is left out, flip looks at several exposures (HDR-FLIP). A PNG holds sRGB codes;
beside one, and with --as-shown, light is clipped to what a screen shows, and rmse, psnr and
ssim are those of sRGB codes from 0 to 1. The peak of psnr is 1. Pictures are laid over black.

The value of de2000, flip and ssim is the mean; de2000, flip and rmse also have .mean, .median,
.p95 and .max over the pixels. The exit code is 1 when a bound is broken, 3 when the pictures cannot
be read or compared.";

/// Options of `glanz compare`.
#[derive(Args, Debug)]
pub(crate) struct CompareArgs {
    /// The picture that the other is compared with (.png, .exr)
    #[arg(value_name = "REFERENCE", value_hint = ValueHint::FilePath)]
    reference: PathBuf,

    /// The other picture, of the same size (.png, .exr)
    #[arg(value_name = "PICTURE", value_hint = ValueHint::FilePath)]
    test: PathBuf,

    /// What is measured, separated by commas [default: all that apply]
    #[arg(long, value_name = "METRICS", value_delimiter = ',', value_parser = metric())]
    metric: Vec<Metric>,

    /// Pixels per degree of the field of view, for flip
    #[arg(long, value_name = "PIXELS", default_value_t = DEFAULT_PPD, value_parser = pixels_per_degree)]
    ppd: f64,

    /// Compare light as a screen shows it too: clipped, as sRGB codes
    #[arg(long)]
    as_shown: bool,

    /// Fail above this: METRIC=LIMIT or METRIC.STATISTIC=LIMIT, separated by commas; may be repeated
    #[arg(long, value_name = "BOUNDS", value_delimiter = ',', value_parser = Threshold::above)]
    fail_above: Vec<Threshold>,

    /// Fail below this, for psnr and ssim; may be repeated
    #[arg(long, value_name = "BOUNDS", value_delimiter = ',', value_parser = Threshold::below)]
    fail_below: Vec<Threshold>,

    /// How much memory the comparison may take, in B, kB, MB, GB or GiB: more is refused beforehand
    #[arg(long, value_name = "SIZE", default_value_t, help_heading = "Machine")]
    memory: MemoryBudget,

    /// A PNG with both pictures and a map of errors for every metric; - for stdout
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Output")]
    output: Option<PathBuf>,

    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl CompareArgs {
    /// Measures.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let target = self.target()?;
        let mut memory = self.memory;
        let pair = self.pair(&mut memory)?;
        let measured = self.measure(&pair, memory)?;
        if let Some(target) = &target {
            let sheet = heat_map_sheet(&pair, self.titles(), &measured)?;
            encode::deliver(sheet.into(), target, &Metadata::default())?;
        }
        let broken: Vec<_> = self.bounds().filter_map(|bound| bound.broken_by(&measured)).collect();
        let error = (!broken.is_empty())
            .then(|| Report::new(format_args!("the pictures differ too much: {}", broken.join("; "))));
        let told = self.tell(target.as_ref(), &pair, &measured, error.as_ref());
        Report::of_judged(error, told)
    }

    fn bounds(&self) -> impl Iterator<Item = &Threshold> {
        self.fail_above.iter().chain(&self.fail_below)
    }

    /// Where the sheet goes, checked before any work is done.
    fn target(&self) -> Result<Option<Target>, Failure> {
        let Some(path) = &self.output else {
            return Ok(None);
        };
        let target = TargetArgs { output: Some(path.clone()), force: false }.resolve(path, "")?;
        encode::expect_png(&target, "a map of errors")?;
        self.format.check_beside(&target)?;
        let real = |path: &Path| std::fs::canonicalize(path).ok();
        for input in [&self.reference, &self.test] {
            if real(path).is_some_and(|path| real(input) == Some(path)) {
                let message =
                    format!("the map of errors would replace '{}', which is compared", input.display());
                return Err(Failure::Usage(message));
            }
        }
        Ok(Some(target))
    }

    fn pair(&self, memory: &mut MemoryBudget) -> Result<Pair, Failure> {
        let mut read = |path: &Path| -> Result<PictureFile, Failure> {
            let picture = read_picture_within(path, memory)
                .map_err(|error| Failure::from(Report::new(without_number(&error.to_string())).file(path)))?;
            for note in &picture.notes {
                print::note(format_args!("note: {}: {note}", path.display()));
            }
            Ok(picture)
        };
        let (reference, test) = (read(&self.reference)?, read(&self.test)?);
        Pair::new(reference, test, self.as_shown).map_err(Failure::new)
    }

    /// The metrics that were asked for and those that have a bound, else all that apply, in one order.
    fn measure(&self, pair: &Pair, mut memory: MemoryBudget) -> Result<Vec<Measurement>, Failure> {
        let mut asked: Vec<Metric> =
            if self.metric.is_empty() { pair.metrics().collect() } else { self.metric.clone() };
        asked.extend(self.bounds().map(|bound| bound.metric));
        let metrics: Vec<_> = Metric::ALL.into_iter().filter(|metric| asked.contains(metric)).collect();
        let mut progress = Progress::new(metrics.len(), "metrics");
        let mut measured = Vec::with_capacity(metrics.len());
        for metric in metrics {
            let options = MetricOptions { ppd: self.ppd, memory };
            let one = pair.measure(metric, &options).map_err(|error| self.failure(metric, error))?;
            let map = size_of_val(&one.map[..]) as u64;
            memory.take(format_args!("the map of {}", metric.name()), map).map_err(Failure::new)?;
            measured.push(one);
            progress.step();
        }
        Ok(measured)
    }

    fn failure(&self, metric: Metric, error: CompareError) -> Failure {
        match error {
            CompareError::CodesOnly { .. } => {
                let help = format_args!("leave out {}, or add --as-shown", metric.name());
                Report::new(&error).help(help).into()
            }
            error => Failure::new(error),
        }
    }

    /// The names of the pictures on the sheet.
    fn titles(&self) -> [String; 2] {
        [&self.reference, &self.test].map(|path| {
            path.file_name()
                .map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
        })
    }

    fn tell(
        &self,
        target: Option<&Target>,
        pair: &Pair,
        measured: &[Measurement],
        error: Option<&Report>,
    ) -> Result<(), Failure> {
        match target {
            Some(Target::Stdout) => {
                print::note(self.table(pair, measured).trim_end());
                return Ok(());
            }
            Some(Target::File(path)) => print::note(format_args!("wrote {}", path.display())),
            None => {}
        }
        match self.format.format {
            Format::Text => print::text(&self.table(pair, measured)),
            Format::Json => print::json(&self.document(target, pair, measured, error)),
        }
    }

    /// The numbers for people.
    fn table(&self, pair: &Pair, measured: &[Measurement]) -> String {
        let (width, height) = pair.size();
        let scale = match pair.scale() {
            Scale::Codes => "as sRGB codes",
            Scale::Light => "as linear light",
        };
        let (reference, test) = (self.reference.display(), self.test.display());
        let mut text = format!("{test} against {reference}: {width}×{height} pixels, {scale}\n");
        text += "             value     median       95 %        max\n";
        for one in measured {
            let spread = match is_spread(one.metric) {
                true => [one.spread.median, one.spread.p95, one.spread.max].map(number),
                false => Default::default(),
            };
            let [median, p95, max] = spread;
            let (name, value) = (one.metric.name(), number(one.value));
            let line =
                format!("{name:<8}{value:>10} {median:>10} {p95:>10} {max:>10}   {}", self.remark(pair, one));
            writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
        }
        text
    }

    /// What a value is.
    fn remark(&self, pair: &Pair, one: &Measurement) -> String {
        let values = match pair.scale() {
            Scale::Codes => "codes",
            Scale::Light => "light",
        };
        match (one.metric, one.exposures) {
            (Metric::De2000, _) => "mean".to_owned(),
            (Metric::Flip, None) => format!("mean, {} pixels per degree", number(self.ppd)),
            (Metric::Flip, Some(exposures)) => format!(
                "mean, {} pixels per degree, exposures {} to {} stops, {} in all",
                number(self.ppd),
                number(exposures.start),
                number(exposures.stop),
                exposures.count
            ),
            (Metric::Rmse, _) => format!("of {values}"),
            (Metric::Psnr, _) => format!("dB, peak 1, of {values}"),
            (Metric::Ssim, _) => "mean, luma of codes".to_owned(),
        }
    }

    /// The numbers for programs.
    fn document(
        &self,
        target: Option<&Target>,
        pair: &Pair,
        measured: &[Measurement],
        error: Option<&Report>,
    ) -> Document {
        let (width, height) = pair.size();
        Document {
            reference: self.reference.display().to_string(),
            picture: self.test.display().to_string(),
            width,
            height,
            values: match pair.scale() {
                Scale::Codes => Values::SrgbCodes,
                Scale::Light => Values::LinearLight,
            },
            metrics: measured.iter().map(|one| (one.metric.name(), self.numbers(one))).collect(),
            file: target.and_then(Target::file),
            bounds: self.bounds().map(|bound| bound.facts(measured)).collect(),
            error: error.map(Report::facts),
        }
    }

    fn numbers(&self, one: &Measurement) -> Numbers {
        let of = |statistic: Statistic| is_spread(one.metric).then(|| statistic.of(one));
        Numbers {
            value: finite(one.value),
            mean: of(Statistic::Mean),
            median: of(Statistic::Median),
            p95: of(Statistic::P95),
            max: of(Statistic::Max),
            ppd: (one.metric == Metric::Flip).then_some(self.ppd),
            exposures: one.exposures.map(|found| ExposuresFacts {
                start: found.start,
                stop: found.stop,
                count: found.count,
            }),
        }
    }
}

/// How far two pictures are apart.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Document {
    /// The picture that the other is compared with
    reference: String,
    /// The other picture
    picture: String,
    /// Width of both in pixels
    width: usize,
    /// Height of both in pixels
    height: usize,
    /// What rmse, psnr and ssim are of
    values: Values,
    /// What was measured, by the name of the metric
    metrics: BTreeMap<&'static str, Numbers>,
    /// The file with both pictures and the maps of errors
    file: Option<String>,
    /// The bounds that were asked for
    bounds: Vec<BoundFacts>,
    /// Why the command fails, where a bound is broken
    error: Option<ErrorFacts>,
}

/// What is compared.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Values {
    SrgbCodes,
    LinearLight,
}

/// The numbers of a metric.
#[derive(Debug, Serialize, JsonSchema)]
struct Numbers {
    /// The one number that stands for the metric; null where it is infinite
    value: Option<f64>,
    /// The mean over the pixels
    #[serde(skip_serializing_if = "Option::is_none")]
    mean: Option<f64>,
    /// The median over the pixels
    #[serde(skip_serializing_if = "Option::is_none")]
    median: Option<f64>,
    /// What 95 % of the pixels do not exceed
    #[serde(skip_serializing_if = "Option::is_none")]
    p95: Option<f64>,
    /// The greatest of all pixels
    #[serde(skip_serializing_if = "Option::is_none")]
    max: Option<f64>,
    /// Pixels per degree of the field of view
    #[serde(skip_serializing_if = "Option::is_none")]
    ppd: Option<f64>,
    /// The exposures that were looked at
    #[serde(skip_serializing_if = "Option::is_none")]
    exposures: Option<ExposuresFacts>,
}

/// The exposures of HDR-FLIP, in stops.
#[derive(Debug, Serialize, JsonSchema)]
struct ExposuresFacts {
    start: f64,
    stop: f64,
    count: usize,
}

/// Parses the name of a metric.
fn metric() -> impl TypedValueParser<Value = Metric> {
    let help = |metric| match metric {
        Metric::De2000 => "colour difference CIEDE2000 per pixel, white D65",
        Metric::Flip => "what an eye sees that looks at both in turn, 0 to 1 (Andersson et al. 2020, 2021)",
        Metric::Rmse => "root of the mean square over red, green and blue",
        Metric::Psnr => "the same as signal to noise in dB",
        Metric::Ssim => "structural similarity (Wang et al. 2004)",
    };
    let names = Metric::ALL.map(|metric| PossibleValue::new(metric.name()).help(help(metric)));
    PossibleValuesParser::new(names).map(|name| {
        let known = Metric::ALL.into_iter().find(|metric| metric.name() == name);
        known.expect("the parser lets only known names through")
    })
}

/// Parses a number of pixels per degree.
fn pixels_per_degree(text: &str) -> Result<f64, String> {
    let (least, most) = PPD_RANGE;
    let ppd = text.parse::<f64>().ok().filter(|ppd| (least..=most).contains(ppd));
    ppd.ok_or_else(|| format!("expected {least} to {most} pixels per degree"))
}
