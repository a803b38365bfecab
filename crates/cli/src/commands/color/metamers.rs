//! `glanz color metamers`: pairs that match under one light and part under another.

use std::fmt::Write;

use clap::Args;
use glanz_color::colorimetry::{DisplayColor, PairDifference, metamerism_index, relative_xyz};
use glanz_color::{Observer, ObserverKind, SpectrumKind};
use glanz_plot::{NamedSpectrum, WavelengthChart, Word, spectra};
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::{BesidePlotArgs, light_words};
use crate::input::resolution::CoarseTable;
use crate::input::spectra::{Source, TableArgs, light_source_with, observer_source, source};
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color metamers a.csv b.csv --light D65,A,FL11
  glanz color metamers pairs.csv:1 pairs.csv:2 --observer cie1964 --format json

The index is the special metamerism index, change of illuminant, of CIE 15: the first light is the
reference, and the index of another light is the ΔE*ab (CIE 1976) of the pair under it. If the
pair does not match under the reference, X, Y and Z of the second surface under the other light
are first multiplied by X1/X2, Y1/Y2 and Z1/Z2 of the reference, so that nothing but the change
counts. The same with ΔE00 stands beside it. Sums are by 1 nm, as for 'glanz color spectrum'.";

/// Options of `glanz color metamers`.
#[derive(Args, Debug)]
pub(crate) struct MetamersArgs {
    /// The first surface: a name from `glanz color list`, or a file
    #[arg(value_name = "FIRST")]
    first: String,

    /// The second surface
    #[arg(value_name = "SECOND")]
    second: String,

    /// Lights between commas, the reference first: names or files
    #[arg(long, alias = "under", value_name = "LIGHT,…", default_value = "D65,A,FL11")]
    light: Vec<String>,

    /// The observer, which must have X, Y and Z
    #[arg(long, value_name = "OBSERVER", default_value = "cie1931")]
    observer: String,

    #[command(flatten)]
    table: TableArgs,

    /// What joins the values of a table that are more than 5 nm apart
    #[arg(
        long,
        value_enum,
        value_name = "CURVE",
        default_value = "lines",
        help_heading = "Files of spectra"
    )]
    interpolation: CoarseTable,

    #[command(flatten)]
    plot: BesidePlotArgs,

    #[command(flatten)]
    format: FormatArgs,
}

/// The pair under one light.
struct Row {
    light: String,
    xyz: [[f64; 3]; 2],
    codes: [String; 2],
    difference: PairDifference,
    index: Option<PairDifference>,
}

impl MetamersArgs {
    /// A surface by name or file.
    fn surface(&self, word: &str) -> Result<Source, Failure> {
        let source = source(word, Some(SpectrumKind::Surface), &self.table)?;
        match source.kind {
            SpectrumKind::Surface => Ok(source.interpolated(Some(self.interpolation))),
            SpectrumKind::Light => {
                Err(Failure::Usage(format!("'{word}' is a light; a pair of surfaces is compared")))
            }
        }
    }

    /// Compares the pair under each light.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let plot = self.plot.target()?;
        let lights = light_words(&self.light)?;
        let mut pair = [self.surface(&self.first)?, self.surface(&self.second)?];
        if pair[0].name == pair[1].name || pair.iter().any(|surface| is_generic(&surface.name)) {
            pair[0].name = self.first.clone();
            pair[1].name = self.second.clone();
        }
        let observer = observer_source(&self.observer)?;
        if observer.kind != ObserverKind::Xyz {
            let name = &observer.name;
            return Err(Failure::Usage(format!("'{name}' has no X, Y, Z, which differences are made of")));
        }
        let mut rows: Vec<Row> = Vec::new();
        for word in &lights {
            let light = light_source_with(word, &self.table)?.interpolated(Some(self.interpolation));
            let reference = rows.first().map(|row| row.xyz);
            rows.push(row(&pair, &light, &observer, reference)?);
        }
        if let Some(plot) = &plot {
            let lang = plot.lang();
            let curves =
                pair.each_ref().map(|s| NamedSpectrum { name: s.name.clone(), spectrum: s.spectrum });
            let subtitle = lang.say(Word::And, &[&pair[0].name, &pair[1].name]);
            let [title, label] = [Word::TwoSurfaces, Word::Reflectance].map(|word| lang.say(word, &[]));
            plot.save(&mut WavelengthChart { lang, ..spectra(&title, &subtitle, &label, &curves) })?;
        }
        match self.format.is_json() {
            true => print::json(&document(&pair, &observer, &rows)),
            false => print::text(&table(&pair, &rows)),
        }
    }
}

/// How different two surfaces look under each of several lights.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The name of the first surface
    first: String,
    /// The name of the second surface
    second: String,
    observer: String,
    /// The light that the indices of metamerism are relative to
    reference: String,
    /// The pair under each light
    lights: Vec<PairFacts>,
}

/// A pair of surfaces under a light.
#[derive(Debug, Serialize, JsonSchema)]
struct PairFacts {
    light: String,
    /// X, Y, Z of both; Y of the perfect diffuser is 100
    xyz: [[f64; 3]; 2],
    /// Both as sRGB codes, adapted to D65; empty where there are none
    srgb: [String; 2],
    /// CIEDE2000
    de2000: f64,
    /// ΔE*ab of 1976
    de76: f64,
    /// The special metamerism index, change of illuminant; null for the reference
    metamerism_index: Option<f64>,
    /// The same with CIEDE2000
    metamerism_index_de2000: Option<f64>,
}

fn document(pair: &[Source; 2], observer: &Observer, rows: &[Row]) -> Document {
    let facts = |row: &Row| PairFacts {
        light: row.light.clone(),
        xyz: row.xyz.map(|xyz| xyz.map(|v| 100.0 * v)),
        srgb: row.codes.clone(),
        de2000: row.difference.de2000,
        de76: row.difference.de76,
        metamerism_index: row.index.map(|index| index.de76),
        metamerism_index_de2000: row.index.map(|index| index.de2000),
    };
    Document {
        first: pair[0].name.clone(),
        second: pair[1].name.clone(),
        observer: observer.name.clone(),
        reference: rows[0].light.clone(),
        lights: rows.iter().map(facts).collect(),
    }
}

/// Whether a name, as a column of a table has it, says nothing of which surface it is.
fn is_generic(name: &str) -> bool {
    const WORDS: [&str; 9] =
        ["spectral", "reflectance", "transmittance", "factor", "value", "values", "r", "sample", "data"];
    let name = name.to_lowercase();
    name.split(|c: char| !c.is_alphanumeric()).all(|word| word.is_empty() || WORDS.contains(&word))
}

fn row(
    pair: &[Source; 2],
    light: &Source,
    observer: &Observer,
    reference: Option<[[f64; 3]; 2]>,
) -> Result<Row, Failure> {
    let unseen = || Failure::Usage(format!("the observer does not see the light '{}'", light.name));
    let relative = |s: &Source| relative_xyz(&(&s.fine * &light.fine), &light.fine, observer);
    let white = relative_xyz(&light.fine, &light.fine, observer).ok_or_else(unseen)?;
    let first = relative(&pair[0]).ok_or_else(unseen)?;
    let second = relative(&pair[1]).ok_or_else(unseen)?;
    let code = |xyz| DisplayColor::adapted(xyz, white).map_or(String::new(), DisplayColor::hex);
    Ok(Row {
        light: light.name.clone(),
        xyz: [first, second],
        codes: [code(first), code(second)],
        difference: PairDifference::between([first, second], white),
        index: reference.and_then(|reference| metamerism_index([first, second], white, reference)),
    })
}

fn table(pair: &[Source; 2], rows: &[Row]) -> String {
    let width = rows.iter().map(|row| row.light.chars().count()).max().unwrap_or(0).max(5);
    let mut text = format!("{} and {}\n", pair[0].name, pair[1].name);
    let mut line = |line: String| writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
    line(format!(
        "{:<width$}  first    second   {:>7}  {:>7}  {:>7}  {:>11}",
        "light", "ΔE00", "ΔE*ab", "index", "index ΔE00"
    ));
    for row in rows {
        let index = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.3}"));
        line(format!(
            "{:<width$}  {:<7}  {:<7}  {:>7.3}  {:>7.3}  {:>7}  {:>11}",
            row.light,
            row.codes[0],
            row.codes[1],
            row.difference.de2000,
            row.difference.de76,
            index(row.index.map(|index| index.de76)),
            index(row.index.map(|index| index.de2000))
        ));
    }
    text
}
