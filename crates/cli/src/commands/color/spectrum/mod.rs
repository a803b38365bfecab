//! `glanz color spectrum`: the colour numbers of a light or a surface.

mod document;
mod light;
mod surface;

use std::fmt::Write;

use clap::Args;
use glanz_color::chromaticity::Chromaticity;
use glanz_color::colorimetry::{DisplayColor, dominant_wavelength, lab};
use glanz_color::models::Lab;
use glanz_color::{FineSpectrum, Observer, Sampled, SpectrumKind};
use glanz_plot::{NamedSpectrum, WavelengthChart, Word, spectra};
use serde_json::{Map, Value, json};

use crate::args::{BesidePlotArgs, PlotTarget, check_apart, check_beside};
use crate::input::resolution::{Coarse, CoarseTable};
use crate::input::spectra::{Source, TableArgs, light_source_with, observer_source, source};
use crate::print::failure::Failure;
use crate::print::files::save_csv;
use crate::print::{self, FormatArgs, decimals, finite, fixed, number, wavelength};

pub(crate) use document::Document;

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color spectrum D65
  glanz color spectrum gold --light A
  glanz color spectrum sample.csv --observer cie1964 --plot sample.svg
  glanz color spectrum 'blackbody(2700)' --csv lamp.csv --format json

XYZ are relative: a light, and the perfect diffuser under --light, have Y = 100. Lab of a surface
is relative to the light, that of a light to D65. sRGB of a surface is adapted from the light to
D65 by Bradford; that of a light is as bright as a screen can be. Dominant wavelength, purity and
colour temperature are those of the CIE 1931 observer, as they are defined; the white is the light
for a surface, equal energy for a light. Files: CSV and other text tables, .spdx (IES TM-27),
CGATS, CxF3. FILE:COLUMN chooses one of several spectra, by name or number from 1.

Numbers are summed by 1 nm: of finer tables with the observer between its wavelengths, of tables
up to 5 nm by Sprague's interpolation (CIE 167:2005), of coarser ones by lines unless
--interpolation sprague. 'drawn by 5 nm' tells how far the colour of a picture is from them, whose
grid has steps of 5 nm.";

/// The scale of X, Y, Z that are printed: Y of the white.
const WHITE_Y: f64 = 100.0;

/// Options of `glanz color spectrum`.
#[derive(Args, Debug)]
pub(crate) struct SpectrumArgs {
    /// A light, a reflectance, a metal or a medium from `glanz color list`, or a file
    #[arg(value_name = "NAME|FILE")]
    spectrum: String,

    /// The light that falls on a surface: a name or a file
    #[arg(long, alias = "under", value_name = "LIGHT", default_value = "D65")]
    light: String,

    /// The observer: a name, or a file with a column for each channel of a sensor
    #[arg(long, value_name = "OBSERVER", default_value = "cie1931")]
    observer: String,

    #[command(flatten)]
    table: TableArgs,

    /// What joins the values of a table that are more than 5 nm apart: lines unless said
    #[arg(long, value_enum, value_name = "CURVE", help_heading = "Files of spectra")]
    interpolation: Option<CoarseTable>,

    #[command(flatten)]
    plot: BesidePlotArgs,

    /// Write the spectrum from 300 to 780 nm by 5 nm, as it is used
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    csv: Option<std::path::PathBuf>,

    #[command(flatten)]
    format: FormatArgs,
}

/// What is told: a line each for people, a value each for programs.
#[derive(Default)]
struct Facts {
    lines: Vec<(&'static str, String)>,
    json: Map<String, Value>,
}

impl Facts {
    fn line(&mut self, label: &'static str, text: impl Into<String>) {
        self.lines.push((label, text.into()));
    }

    fn value(&mut self, key: &str, value: impl Into<Value>) {
        self.json.insert(key.to_owned(), value.into());
    }
}

impl SpectrumArgs {
    /// Tells the numbers, and draws and writes what is asked for.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let plot = self.plot.target()?;
        self.csv.as_deref().map_or(Ok(()), |file| check_beside("--csv", file))?;
        check_apart([("--csv", self.csv.as_deref()), ("--plot", plot.as_ref().and_then(PlotTarget::path))])?;
        let source = source(&self.spectrum, None, &self.table)?.interpolated(self.interpolation);
        if self.table.kind.is_some_and(|kind| kind.spectrum_kind() != source.kind) {
            let message = "is known by its name; --as tells what a file's spectrum is of";
            return Err(Failure::Usage(format!("'{}' {message}", self.spectrum)));
        }
        let observer = observer_source(&self.observer)?;
        let mut facts = Facts::default();
        facts.value("name", source.name.as_str());
        facts.value("title", source.title.as_str());
        facts.value("observer", observer.name.as_str());
        facts.line("observer", format!("{}, {}", observer.name, observer.title));
        match source.kind {
            SpectrumKind::Light => light::light_facts(&mut facts, &source, &observer),
            SpectrumKind::Surface => {
                let light = light_source_with(&self.light, &self.table)?.interpolated(self.interpolation);
                surface::surface_facts(&mut facts, &source, &light, &observer);
            }
        }
        facts.value("nm", source.spectrum.points().map(|(nm, _)| nm).collect::<Vec<_>>());
        facts.value("values", source.spectrum.0.map(finite).to_vec());
        self.write_files(&source, plot.as_ref())?;
        if self.format.is_json() {
            return print::json(&Document(facts.json));
        }
        let mut text = format!("{}: {}\n", source.name, source.title);
        for (label, line) in facts.lines {
            writeln!(text, "  {label:<14} {line}").expect("a string takes everything");
        }
        print::text(&text)
    }

    fn write_files(&self, source: &Source, plot: Option<&PlotTarget>) -> Result<(), Failure> {
        if let Some(path) = &self.csv {
            save_csv(path, &[(&source.name, &source.spectrum)])?;
        }
        let Some(plot) = plot else { return Ok(()) };
        let lang = plot.lang();
        let label = match source.kind {
            SpectrumKind::Light if source.unit.is_empty() => lang.say(Word::RelativePower, &[]),
            SpectrumKind::Light => source.unit.clone(),
            SpectrumKind::Surface => lang.say(Word::Reflectance, &[]),
        };
        let curve = NamedSpectrum { name: source.name.clone(), spectrum: source.spectrum };
        let chart = spectra(&source.name, &source.title, &label, &[curve]);
        plot.save(&mut WavelengthChart { lang, ..chart })
    }
}

/// X, Y, Z and what follows from them; `white` is on the same scale.
fn color_facts(facts: &mut Facts, xyz: [f64; 3], white: [f64; 3]) {
    let Lab(lab) = lab(xyz, white);
    facts.value("xyz", xyz.map(|v| v * WHITE_Y).to_vec());
    facts.line("XYZ", decimals(&xyz.map(|v| v * WHITE_Y), 3));
    if let Some(xy) = Chromaticity::of_xyz(xyz) {
        let [u, v] = xy.uv1976();
        facts.value("xy", vec![xy.x, xy.y]);
        facts.value("uv1976", vec![u, v]);
        facts.line("xy", decimals(&[xy.x, xy.y], 5));
        facts.line("u'v'", decimals(&[u, v], 5));
    }
    facts.value("lab", lab.to_vec());
    facts.line("L*a*b*", decimals(&lab, 2));
}

fn screen_facts(facts: &mut Facts, screen: DisplayColor, how: &str) {
    let (srgb, inside) = (screen.srgb, screen.is_in_gamut());
    let clipped = if inside { "" } else { ", outside of its gamut, code clipped" };
    facts.value("srgb", json!({ "values": srgb, "code": screen.hex(), "in_gamut": inside }));
    facts.line("sRGB", format!("{}  {} ({how}{clipped})", decimals(&srgb, 4), screen.hex()));
}

fn hue_facts(facts: &mut Facts, color: &FineSpectrum, white: Chromaticity, name: &str) {
    let Some((dominant, complement)) = dominant_wavelength(color, white) else {
        facts.value("dominant_nm", Value::Null);
        let why = match Chromaticity::of_light(color) {
            Some(_) => format!("none, it has the chromaticity of {name}"),
            None => "none, it is not seen".to_owned(),
        };
        facts.line("dominant", why);
        return;
    };
    facts.value("dominant_nm", dominant.nm);
    facts.value("purity", dominant.purity);
    facts.line("dominant", format!("{} against {name}", wavelength(&dominant)));
    facts.line("purity", fixed(dominant.purity, 4));
    if let Some(complement) = complement {
        facts.value("complementary_nm", complement.nm);
        if !complement.is_purple() {
            facts.line("complementary", wavelength(&complement));
        }
    }
}

/// The responses of an observer that has no X, Y, Z.
fn response_facts(
    facts: &mut Facts,
    light: &FineSpectrum,
    white: Option<&FineSpectrum>,
    observer: &Observer,
) {
    let responses = light.responses(observer);
    let whites = white.map(|white| white.responses(observer));
    for (index, (channel, response)) in observer.channels.iter().zip(&responses).enumerate() {
        let relative = whites.as_ref().map_or(*response, |whites| response / whites[index]);
        facts.value(&format!("response_{}", channel.name), finite(relative));
    }
    let values = responses.iter().enumerate().map(|(index, response)| {
        number(whites.as_ref().map_or(*response, |whites| response / whites[index]))
    });
    let named =
        observer.channels.iter().zip(values).map(|(channel, value)| format!("{} {value}", channel.name));
    let named = named.collect::<Vec<_>>().join(", ");
    let relative = if white.is_some() { " (of the perfect diffuser's)" } else { "" };
    facts.line("responses", format!("{named}{relative}"));
}

/// How far the colour would be off if the values of a coarse table were joined by smooth curves.
fn coarse_facts(facts: &mut Facts, coarse: &Coarse, de2000: f64) {
    let step = number(coarse.step_nm);
    facts.value("interpolation", json!({ "step_nm": coarse.step_nm, "sprague_de2000": de2000 }));
    let choose = format!("--interpolation sprague: ΔE00 {de2000:.2} from this");
    facts.line("interpolation", format!("lines between values {step} nm apart; {choose}"));
}
