//! `glanz measure`: measured reflectance.

pub(super) mod appearance;
mod balls;
pub(super) mod compare;
pub(super) mod convert;
pub(super) mod fit;
mod fit_facts;
mod fit_rank;
mod fit_report;
mod fitted_material;
pub(super) mod info;
pub(super) mod sample;
mod sheet;
pub(super) mod smooth;
mod surface;
mod tristimulus;
mod written;

use std::path::Path;

use clap::{Args, Subcommand};
use glanz_measure::{Measured, Quantity, ReadError, ReadOptions};

use crate::input::whole_file::{MOST_BYTES, read_whole};
use crate::print::failure::{Failure, Report, without_number};

/// What to do with measured reflectance.
#[derive(Subcommand, Debug)]
pub(crate) enum MeasureCommand {
    /// Tell what a file of measured reflectance holds, and what its numbers are
    #[command(after_help = info::EXAMPLES)]
    Info(info::InfoArgs),
    /// Write measured reflectance in another format
    #[command(after_help = convert::EXAMPLES)]
    Convert(convert::ConvertArgs),
    /// Fit models to readings, and rank them
    #[command(after_help = fit::EXAMPLES)]
    Fit(fit::FitArgs),
    /// Tell gloss, haze, colours, flop, whiteness and yellowness
    #[command(after_help = appearance::EXAMPLES)]
    Appearance(Box<appearance::AppearanceArgs>),
    /// Tell how far two reflectances are apart, in numbers and balls
    #[command(after_help = compare::EXAMPLES)]
    Compare(compare::CompareArgs),
    /// Measure a model as a goniometer would
    #[command(after_help = sample::EXAMPLES)]
    Sample(sample::SampleArgs),
    /// Smooth readings by Gaussians, and fill their holes
    #[command(after_help = smooth::EXAMPLES)]
    Smooth(smooth::SmoothArgs),
}

impl MeasureCommand {
    /// The subcommand's name.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Info(_) => "info",
            Self::Convert(_) => "convert",
            Self::Fit(_) => "fit",
            Self::Appearance(_) => "appearance",
            Self::Compare(_) => "compare",
            Self::Sample(_) => "sample",
            Self::Smooth(_) => "smooth",
        }
    }

    /// Does it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Info(args) => args.run(),
            Self::Convert(args) => args.run(),
            Self::Fit(args) => args.run(),
            Self::Appearance(args) => args.run(),
            Self::Compare(args) => args.run(),
            Self::Sample(args) => args.run(),
            Self::Smooth(args) => args.run(),
        }
    }
}

/// How names of files of measured reflectance end, beside those that others share.
const ENDINGS: [&str; 8] = ["csv", "binary", "bsdf", "astm", "xml", "bin", "ssdd", "alta"];

/// Whether a file is one of measured reflectance, by its ending.
pub(crate) fn is_measured(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
}

/// How files are read.
#[derive(Args, Debug, Default)]
pub(crate) struct ReadArgs {
    /// What the numbers are, whatever the file says: brdf (1/sr), brdf-cos (times the cosine of the detector) or
    /// reflectance-factor (pi times the BRDF)
    #[arg(long, value_name = "QUANTITY", value_parser = quantity)]
    quantity: Option<Quantity>,

    /// A factor of the numbers of UTIA's and CSAIL's files, on whose scale their readers disagree
    #[arg(long, value_name = "FACTOR", value_parser = positive)]
    scale: Option<f64>,

    /// The number that stands for 1 in a UTIA file whose numbers are encoded as sRGB; they are decoded, then scaled
    #[arg(long, value_name = "NUMBER", value_parser = positive)]
    srgb_white: Option<f64>,
}

/// A number above 0.
fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "expected a number above 0".to_owned())
}

/// A quantity by its name.
pub(super) fn quantity(text: &str) -> Result<Quantity, String> {
    Quantity::named(text).ok_or_else(|| "expected brdf, brdf-cos or reflectance-factor".to_owned())
}

/// Reads a file.
pub(crate) fn read(file: &Path, args: &ReadArgs) -> Result<Measured, Failure> {
    let name = file.display().to_string();
    let could_not =
        |why: &str| Failure::from(Report::new(format_args!("cannot read '{name}': {why}")).file(file));
    let io = |error: std::io::Error| could_not(&without_number(&error.to_string()));
    let bytes = read_whole(file, MOST_BYTES).map_err(io)?;
    let options = ReadOptions { quantity: args.quantity, scale: args.scale, srgb_white: args.srgb_white };
    Measured::read(&bytes, &name, &options).map_err(|error| failure(&error, file, &bytes))
}

/// An error with the line that it is in.
fn failure(error: &ReadError, file: &Path, bytes: &[u8]) -> Failure {
    let report = Report::new(error).file(file);
    let Some((line, text)) = error.line().zip(std::str::from_utf8(bytes).ok()) else { return report.into() };
    let before = text.split_inclusive('\n').take(line as usize - 1).map(str::len).sum::<usize>();
    let length = text[before..].lines().next().map_or(0, str::len);
    let report = report.place(line.into(), 1);
    report.source(&file.display().to_string(), text.to_owned(), before..before + length).into()
}
