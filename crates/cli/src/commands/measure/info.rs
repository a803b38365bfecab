//! `glanz measure info`: what a file holds.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_measure::{Facts, Measured};
use schemars::JsonSchema;
use serde::Serialize;

use super::{ReadArgs, read};
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure info paint.bsdf
  glanz measure info gold.binary --format json
  glanz measure info tile.csv --quantity reflectance-factor

Formats, told by the content: CSV with named columns (theta_i_deg, phi_i_deg, theta_o_deg, phi_o_deg, or
wi_x to wo_z, then r, g, b, or X, Y, Z, or wavelengths such as 550nm, or Y; '# quantity brdf' says what
the numbers are), MERL's .binary, RGL's .bsdf (RGB and spectral), ASTM E1392, the .bsdf of Zemax and
LightTools, Radiance's and WINDOW's .xml (matrices over Klems' patches, tensor trees), the text of pab's
goniometers and of ALTA, UTIA's .bin, MIT CSAIL's anisotropic tables, and .ssdd. Values are BRDF in 1/sr.
The albedo is the part of the light that a surface reflects, of all that falls in at an angle; reciprocity
is how far f(a, b) and f(b, a) are apart, as parts of their mean. Both are told of tables; readings alone
have none between them.";

/// Options of `glanz measure info`.
#[derive(Args, Debug)]
pub(crate) struct InfoArgs {
    /// A file of measured reflectance
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// What a file of measured reflectance holds.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    file: String,
    /// csv, merl, rgl or astm
    format: &'static str,
    description: String,
    /// What the numbers in the file are: brdf, brdf_cos or reflectance_factor
    quantity: &'static str,
    /// What they probably are instead; null where nothing speaks against that
    probably: Option<&'static str>,
    /// Names of the channels: r, g, b, or X, Y, Z, or wavelengths, or Y
    channels: Vec<String>,
    /// How many readings, or nodes of a table above the horizon
    readings: usize,
    /// How many different directions of the light
    lights: usize,
    /// Least and greatest angle of the light from the normal
    theta_i_deg: [f64; 2],
    /// Least and greatest angle of the detector from the normal
    theta_o_deg: [f64; 2],
    /// Values that are missing
    missing: usize,
    /// Values below 0
    negative: usize,
    /// Least and greatest value of the BRDF, in 1/sr
    range: [f64; 2],
    /// Of tables: the part of the light that is reflected
    albedos: Vec<AlbedoFacts>,
    /// Of tables: the median difference of f(a, b) and f(b, a), as a part of their mean
    reciprocity_median: Option<f64>,
    /// The difference that 95 of 100 pairs stay below
    reciprocity_95: Option<f64>,
    /// What is odd, and what was dropped
    notes: Vec<String>,
}

/// The albedo for an angle of the light.
#[derive(Debug, Serialize, JsonSchema)]
struct AlbedoFacts {
    theta_i_deg: f64,
    /// One per channel
    values: Vec<f64>,
    /// The part of the hemisphere, by its cosine, for which there are data
    known: f64,
}

impl InfoArgs {
    /// Tells it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let measured = read(&self.file, &self.read)?;
        let facts = Facts::of(&measured);
        let document = self.document(&measured, &facts);
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text(&document, &measured))
    }

    fn document(&self, measured: &Measured, facts: &Facts) -> Document {
        let mut notes = measured.notes.clone();
        if let Some((quantity, why)) = &facts.guess {
            notes.push(format!("{why}: probably they are {}, which --quantity tells", quantity.name()));
        }
        let albedo = |own: &glanz_measure::Albedo| AlbedoFacts {
            theta_i_deg: own.theta_i_deg,
            values: own.values.clone(),
            known: own.known,
        };
        Document {
            file: self.file.display().to_string(),
            format: measured.format.name(),
            description: measured.description.clone(),
            quantity: measured.quantity.name(),
            probably: facts.guess.as_ref().map(|(quantity, _)| quantity.name()),
            channels: measured.channels().names(),
            readings: facts.readings,
            lights: facts.lights,
            theta_i_deg: facts.theta_i_deg,
            theta_o_deg: facts.theta_o_deg,
            missing: facts.missing,
            negative: facts.negative,
            range: facts.range,
            albedos: facts.albedos.iter().map(albedo).collect(),
            reciprocity_median: facts.reciprocity.map(|own| own.median),
            reciprocity_95: facts.reciprocity.map(|own| own.most),
            notes,
        }
    }
}

/// For people.
fn text(facts: &Document, measured: &Measured) -> String {
    let mut text = String::new();
    let mut line = |name: &str, words: String| {
        writeln!(text, "{name:<13}{words}").expect("a string takes everything");
    };
    let degrees = |[low, high]: [f64; 2]| format!("{low:.1}° to {high:.1}°");
    line("format", facts.format.to_owned());
    if !facts.description.is_empty() {
        line("description", facts.description.clone());
    }
    line("quantity", facts.quantity.to_owned());
    line("channels", measured.channels().to_string());
    let lights = format!(", of {} directions of the light", facts.lights);
    // A table in half angles has another one for each.
    let lights = if facts.lights * 2 > facts.readings { String::new() } else { lights };
    line("readings", format!("{}{lights}", facts.readings));
    line("light", degrees(facts.theta_i_deg));
    line("detector", degrees(facts.theta_o_deg));
    let [low, high] = facts.range.map(number);
    line("BRDF", format!("{low} to {high} 1/sr; {} missing, {} below 0", facts.missing, facts.negative));
    for albedo in &facts.albedos {
        line("albedo", format!("{:>2}°  {}", albedo.theta_i_deg, of_channels(albedo)));
    }
    if let (Some(median), Some(most)) = (facts.reciprocity_median, facts.reciprocity_95) {
        let percent = |x: f64| format!("{:.1} %", 100.0 * x);
        line("reciprocity", format!("off by {} (median), {} (95 of 100)", percent(median), percent(most)));
    }
    facts.notes.iter().for_each(|note| line("note", note.clone()));
    text
}

/// The channels of an albedo, the least and greatest where there are many.
fn of_channels(albedo: &AlbedoFacts) -> String {
    let of = |x: &f64| format!("{x:.3}");
    let mut words = match albedo.values.as_slice() {
        few if few.len() <= 3 => few.iter().map(of).collect::<Vec<_>>().join("  "),
        many => {
            let (low, high) =
                many.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
            format!("{low:.3} to {high:.3}")
        }
    };
    if albedo.known < 0.999 {
        words += &format!("  of {:.0} % of the hemisphere", 100.0 * albedo.known);
    }
    words
}
