//! `glanz lesson ward`: Ward's regression.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use glanz_bsdf::{DirectionPair, Shape};
use glanz_measure::{Channels, Noise, Readings, WardFit, fit_ward, spiral_about_mirror};
use glanz_plot::figure::ward;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::BesidePlotArgs;
use crate::commands::measure::{ReadArgs, read};
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz lesson ward --plot ward.png
  glanz lesson ward --alpha 0.04 --alpha-y 0.11 --noise 0.05
  glanz lesson ward --readings readings.csv --plot own.svg

G. J. Ward 1992 fitted his model to the readings of a goniometer. With the matte part taken away, and times 4 pi
and the root of both cosines, the logarithm of a reading falls on a straight line over the square of the tangent
of delta, the angle of the facet that mirrors light into the detector; its slope is -1/alpha^2, and where it begins
is the logarithm of rho_s/alpha^2. With two widths the squares of both slopes of the facet count by themselves.
Linear regression finds them, with weights that are the squares of the readings; rho_d follows from what the
highlight leaves, and a few rounds of both suffice.

The readings are those of a model of these widths, with noise, and the true values stand beside the recovered
ones; --readings takes one's own in place of them.";

/// Options of `glanz lesson ward`.
#[derive(Args, Debug)]
pub(crate) struct WardArgs {
    /// The width of the highlight along x
    #[arg(long, value_name = "WIDTH", default_value_t = 0.1)]
    alpha: f64,

    /// The width along y [default: that along x]
    #[arg(long, value_name = "WIDTH")]
    alpha_y: Option<f64>,

    /// The albedo of the highlight
    #[arg(long, value_name = "ALBEDO", default_value_t = 0.1)]
    rho_s: f64,

    /// The albedo of the matte part
    #[arg(long, value_name = "ALBEDO", default_value_t = 0.3)]
    rho_d: f64,

    /// The standard deviation of the noise, as a part of each reading
    #[arg(long, value_name = "PART", default_value_t = 0.03)]
    noise: f64,

    /// Which noise
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Readings of one's own, in place of those of the model: a file of measured reflectance
    #[arg(
        long,
        value_name = "FILE",
        value_hint = ValueHint::FilePath,
        conflicts_with_all = ["alpha", "alpha_y", "rho_s", "rho_d", "noise", "seed"]
    )]
    readings: Option<PathBuf>,

    /// Look for a width along x and one along y in --readings
    #[arg(long, requires = "readings")]
    anisotropic: bool,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    plot: BesidePlotArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// What the regression found.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The file of the readings; null for those of the model
    file: Option<String>,
    /// The channel of the readings
    channel: String,
    /// How many readings there are
    readings: usize,
    /// How many of them count: within 80° of the normal, and well above the matte part
    used: usize,
    found: Values,
    /// The model that was measured; null for readings of one's own
    truth: Option<Values>,
    /// Where the line begins: ln(ρs/(αx αy))
    intercept: f64,
    /// The slope of the line: −1/αx²
    slope: f64,
    /// The part of the weighted variance that the line explains
    r_squared: f64,
}

/// The numbers of Ward's model.
#[derive(Debug, Serialize, JsonSchema)]
struct Values {
    alpha_x: f64,
    alpha_y: f64,
    rho_s: f64,
    rho_d: f64,
}

impl WardArgs {
    /// Fits, and draws.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.check()?;
        let plot = self.plot.target()?;
        let readings = match &self.readings {
            Some(file) => read(file, &self.read)?.readings(),
            None => self.measured()?,
        };
        let channel = middle(readings.channels());
        let alpha_y = self.alpha_y.unwrap_or(self.alpha);
        let anisotropic = self.anisotropic || (self.readings.is_none() && alpha_y != self.alpha);
        let fit = fit_ward(&readings, channel, anisotropic).map_err(|error| {
            let report = Report::new(error);
            Failure::from(report.file(self.readings.as_deref().unwrap_or(Path::new("the model"))))
        })?;
        let truth = self.readings.is_none().then_some((self.rho_s, [self.alpha, alpha_y]));
        if let Some(plot) = plot {
            plot.save(&mut ward(&fit, truth, plot.lang()))?;
        }
        let document = self.document(&readings, channel, &fit, truth);
        match self.format.is_json() {
            true => print::json(&document),
            false => print::text(&text(&document)),
        }
    }

    fn check(&self) -> Result<(), Failure> {
        for (name, value, least, most) in [
            ("--alpha", self.alpha, 0.01, 0.5),
            ("--alpha-y", self.alpha_y.unwrap_or(self.alpha), 0.01, 0.5),
            ("--rho-s", self.rho_s, 0.001, 1.0),
            ("--rho-d", self.rho_d, 0.0, 1.0),
            ("--noise", self.noise, 0.0, 0.3),
        ] {
            if !(least..=most).contains(&value) {
                return Err(Failure::Usage(format!("{name} is {value}, but must be from {least} to {most}")));
            }
        }
        Ok(())
    }

    /// The model, measured with noise.
    fn measured(&self) -> Result<Readings, Failure> {
        let widths = [("alpha", self.alpha), ("alpha_y", self.alpha_y.unwrap_or(self.alpha))];
        let shape = Shape::named("ward", &widths).map_err(|error| Failure::Usage(error.to_string()))?;
        let (mut readings, mut noise) = (Readings::new(Channels::Luminance), Noise::new(self.seed));
        for [wi, wo] in spiral_about_mirror() {
            let highlight = self.rho_s * shape.f_cos(&DirectionPair::new(wo, wi)) / wi.z;
            let f = self.rho_d * core::f64::consts::FRAC_1_PI + highlight;
            readings.push(wi, wo, &[(f * (1.0 + self.noise * noise.normal()).max(0.0)) as f32]);
        }
        Ok(readings)
    }

    fn document(
        &self,
        readings: &Readings,
        channel: usize,
        fit: &WardFit,
        truth: Option<(f64, [f64; 2])>,
    ) -> Document {
        let truth =
            truth.map(|(rho_s, [alpha_x, alpha_y])| Values { alpha_x, alpha_y, rho_s, rho_d: self.rho_d });
        let [alpha_x, alpha_y] = fit.alpha;
        Document {
            file: self.readings.as_ref().map(|file| file.display().to_string()),
            channel: readings.channels().names().swap_remove(channel),
            readings: readings.len(),
            used: fit.points.iter().filter(|point| point.weight > 0.0).count(),
            found: Values { alpha_x, alpha_y, rho_s: fit.rho_s, rho_d: fit.rho_d },
            truth,
            intercept: fit.intercept(),
            slope: -1.0 / (alpha_x * alpha_x),
            r_squared: fit.r_squared,
        }
    }
}

/// The channel in the middle: green, Y, or the middle wavelength.
fn middle(channels: &Channels) -> usize {
    channels.count() / 2
}

/// For people.
fn text(facts: &Document) -> String {
    let mut text = String::new();
    let mut line = |line: String| writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
    let of = facts
        .file
        .as_deref()
        .map_or("a model".to_owned(), |file| format!("{file}, channel {}", facts.channel));
    line(format!("{} readings of {of}, {} of which count", facts.readings, facts.used));
    let truth = facts.truth.as_ref();
    line(format!("{:<10}{:>10}{:>10}", "", "found", truth.map_or("", |_| "true")));
    let row = |name: &str, found: f64, truth: Option<f64>| {
        let truth = truth.map_or(String::new(), |value| format!("{value:>10.4}"));
        format!("{name:<10}{found:>10.4}{truth}")
    };
    line(row("alpha x", facts.found.alpha_x, truth.map(|values| values.alpha_x)));
    line(row("alpha y", facts.found.alpha_y, truth.map(|values| values.alpha_y)));
    line(row("rho s", facts.found.rho_s, truth.map(|values| values.rho_s)));
    line(row("rho d", facts.found.rho_d, truth.map(|values| values.rho_d)));
    let (slope, intercept, part) = (facts.slope, facts.intercept, 100.0 * facts.r_squared);
    line(format!("line: {intercept:.3} {slope:+.2} tan²δ; it explains {part:.2} % of the weighted variance"));
    text
}
