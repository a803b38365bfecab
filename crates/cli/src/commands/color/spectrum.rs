//! `glanz color spectrum`: the colour numbers of a light or a surface.

use std::borrow::Cow;
use std::fmt::Write;

use clap::Args;
use glanz_color::chromaticity::Chromaticity;
use glanz_color::colorimetry::{DisplayColor, dominant_wavelength, lab, relative_xyz};
use glanz_color::cri::color_rendering;
use glanz_color::models::Lab;
use glanz_color::photometry::{Adapted, efficacy_lm_per_w, luminous};
use glanz_color::temperature::{MOST_DUV, color_temperature};
use glanz_color::difference::ciede2000;
use glanz_color::{FineSpectrum, Observer, ObserverKind, Sampled, SpectrumKind, fine_light};
use glanz_plot::{NamedSpectrum, PlotFile, spectra};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::args::check_folder;
use crate::input::spectra::{Coarse, CoarseTable, Source, TableArgs, light_source_with, observer_source, source};
use crate::print::failure::Failure;
use crate::print::files::{check_plot, save_csv, save_plot};
use crate::print::{self, FormatArgs, decimals, finite, fixed, number, wavelength};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color spectrum D65
  glanz color spectrum gold --under A
  glanz color spectrum sample.csv --observer cie1964 --plot sample.svg
  glanz color spectrum 'blackbody(2700)' --csv lamp.csv --format json

XYZ are relative: a light, and the perfect diffuser under --under, have Y = 100. Lab of a surface
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
    #[arg(long, value_name = "LIGHT", default_value = "D65")]
    under: String,

    /// The observer: a name, or a file with a column for each channel of a sensor
    #[arg(long, value_name = "OBSERVER", default_value = "cie1931")]
    observer: String,

    #[command(flatten)]
    table: TableArgs,

    /// What joins the values of a table that are more than 5 nm apart: lines unless said
    #[arg(long, value_enum, value_name = "CURVE", help_heading = "Files of spectra")]
    interpolation: Option<CoarseTable>,

    /// Draw the spectrum; .svg or .png
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    plot: Option<PlotFile>,

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

/// The colour numbers of a light or a surface.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub(crate) struct Document(Map<String, Value>);

/// The keys follow from what the spectrum is of and who sees it, so the schema is written here.
impl JsonSchema for Document {
    fn schema_name() -> Cow<'static, str> {
        "Spectrum".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let number = json!({ "type": "number" });
        let nullable = json!({ "type": ["number", "null"] });
        let text = json!({ "type": "string" });
        let numbers = |count: usize| json!({ "type": "array", "items": { "type": "number" }, "minItems": count, "maxItems": count });
        json_schema!({
            "description": "The colour numbers of a light or a surface",
            "type": "object",
            "required": ["name", "title", "observer", "kind", "nm", "values"],
            "properties": {
                "name": text, "title": text, "observer": text, "kind": { "enum": ["light", "surface"] },
                "nm": { "type": "array", "items": { "type": "number" } },
                "values": { "type": "array", "items": { "type": ["number", "null"] } },
                "under": text, "xyz": numbers(3), "xy": numbers(2), "uv1976": numbers(2), "lab": numbers(3),
                "srgb": {
                    "type": "object",
                    "required": ["values", "code", "in_gamut"],
                    "properties": { "values": numbers(3), "code": text, "in_gamut": { "type": "boolean" } },
                    "additionalProperties": false,
                },
                "dominant_nm": nullable, "purity": number, "complementary_nm": number, "cct_k": nullable,
                "duv": number, "cct_is_meaningful": { "type": "boolean" }, "ra": number,
                "r": { "type": "array", "items": { "type": "number" } }, "efficacy_lm_per_w": nullable,
                "sp_ratio": nullable, "unit": text, "luminous": nullable, "scotopic": nullable,
                "luminous_unit": text,
                "interpolation": {
                    "description": "Of a table with coarse steps, whose values are joined by lines: how far Sprague's polynomials would be",
                    "type": "object",
                    "required": ["step_nm", "sprague_de2000"],
                    "properties": { "step_nm": number, "sprague_de2000": number },
                    "additionalProperties": false,
                },
                "drawn_by_5_nm": {
                    "description": "How far the colour of a picture, whose grid has steps of 5 nm, is from these numbers",
                    "type": "object",
                    "required": ["de2000"],
                    "properties": { "de2000": number, "cct_shift_k": nullable },
                    "additionalProperties": false,
                },
            },
            "patternProperties": { "^response_": { "type": ["number", "null"] } },
            "additionalProperties": false,
        })
    }
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
        check_plot(self.plot.as_ref())?;
        self.csv.as_deref().map_or(Ok(()), check_folder)?;
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
            SpectrumKind::Light => light_facts(&mut facts, &source, &observer),
            SpectrumKind::Surface => {
                let light = light_source_with(&self.under, &self.table)?.interpolated(self.interpolation);
                surface_facts(&mut facts, &source, &light, &observer);
            }
        }
        facts.value("nm", source.spectrum.points().map(|(nm, _)| nm).collect::<Vec<_>>());
        facts.value("values", source.spectrum.0.map(finite).to_vec());
        self.write_files(&source)?;
        if self.format.is_json() {
            return print::json(&Document(facts.json));
        }
        let mut text = format!("{}: {}\n", source.name, source.title);
        for (label, line) in facts.lines {
            writeln!(text, "  {label:<14} {line}").expect("a string takes everything");
        }
        print::text(&text)
    }

    fn write_files(&self, source: &Source) -> Result<(), Failure> {
        if let Some(path) = &self.csv {
            save_csv(path, &[(&source.name, &source.spectrum)])?;
        }
        let Some(file) = &self.plot else { return Ok(()) };
        let label = match source.kind {
            SpectrumKind::Light if source.unit.is_empty() => "relative power per nm".to_owned(),
            SpectrumKind::Light => source.unit.clone(),
            SpectrumKind::Surface => "reflectance".to_owned(),
        };
        let curve = NamedSpectrum { name: source.name.clone(), spectrum: source.spectrum };
        save_plot(file, &spectra(&source.name, &source.title, &label, &[curve]))
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

fn light_facts(facts: &mut Facts, source: &Source, observer: &Observer) {
    let light = &source.fine;
    facts.value("kind", "light");
    if observer.kind != ObserverKind::Xyz {
        response_facts(facts, light, None, observer);
    }
    let d65 = fine_light("D65").expect("D65 comes with the library");
    if let (Some(xyz), Some(white)) =
        (relative_xyz(light, light, observer), relative_xyz(&d65, &d65, observer))
    {
        color_facts(facts, xyz, white);
        screen_facts(facts, DisplayColor::of_light(xyz), "as bright as it can be");
    } else if observer.kind == ObserverKind::Xyz {
        facts.line("XYZ", "none: the observer does not see this light");
    }
    hue_facts(facts, light, Chromaticity::E, "equal energy");
    temperature_facts(facts, light);
    power_facts(facts, source);
    drawn_light_facts(facts, source, &d65, observer);
}

/// What drawing a light by 5 nm costs.
fn drawn_light_facts(facts: &mut Facts, source: &Source, white: &FineSpectrum, observer: &Observer) {
    let (told, drawn) = (&source.fine, &source.spectrum);
    let (Some(first), Some(second), Some(white)) = (
        relative_xyz(told, told, observer),
        relative_xyz(drawn, drawn, observer),
        relative_xyz(white, white, observer),
    ) else {
        return;
    };
    let de2000 = ciede2000(lab(first, white), lab(second, white));
    let kelvin = |xy: Option<Chromaticity>| xy.and_then(|xy| color_temperature(xy).ok()).map(|found| found.cct_k);
    let shift = kelvin(Chromaticity::of_light(drawn)).zip(kelvin(Chromaticity::of_light(told)));
    let shift = shift.map(|(drawn, told)| drawn - told);
    let temperature = shift.map_or(String::new(), |shift| format!(", CCT {shift:+.1} K"));
    facts.value("drawn_by_5_nm", json!({ "de2000": de2000, "cct_shift_k": shift }));
    facts.line("drawn by 5 nm", format!("ΔE00 {de2000:.2}{temperature}"));
    if let Some(coarse) = &source.coarse
        && let Some(smooth) = relative_xyz(&coarse.smooth, &coarse.smooth, observer)
    {
        coarse_facts(facts, coarse, ciede2000(lab(first, white), lab(smooth, white)));
    }
}

/// How far the colour would be off if the values of a coarse table were joined by smooth curves.
fn coarse_facts(facts: &mut Facts, coarse: &Coarse, de2000: f64) {
    let step = number(coarse.step_nm);
    facts.value("interpolation", json!({ "step_nm": coarse.step_nm, "sprague_de2000": de2000 }));
    let choose = format!("--interpolation sprague: ΔE00 {de2000:.2} from this");
    facts.line("interpolation", format!("lines between values {step} nm apart; {choose}"));
}

/// What drawing a surface by 5 nm costs: each colour to the white of its own sums.
fn drawn_surface_facts(facts: &mut Facts, source: &Source, light: &Source, told: Lab, observer: &Observer) {
    let (white, seen) = (light.spectrum, source.spectrum * light.spectrum);
    if let (Some(white), Some(xyz)) =
        (relative_xyz(&white, &white, observer), relative_xyz(&seen, &white, observer))
    {
        let de2000 = ciede2000(told, lab(xyz, white));
        facts.value("drawn_by_5_nm", json!({ "de2000": de2000 }));
        facts.line("drawn by 5 nm", format!("ΔE00 {de2000:.2}"));
    }
}

fn temperature_facts(facts: &mut Facts, light: &FineSpectrum) {
    let Some(Ok(found)) = Chromaticity::of_light(light).map(color_temperature) else {
        facts.value("cct_k", Value::Null);
        facts.line("CCT", "none: no black body is near");
        return;
    };
    let far = found.duv.abs() > MOST_DUV;
    facts.value("cct_k", found.cct_k);
    facts.value("duv", found.duv);
    facts.value("cct_is_meaningful", !far);
    let warning = if far { " (too far from black bodies to mean much)" } else { "" };
    facts.line("CCT", format!("{:.1} K, Duv {:+.4}{warning}", found.cct_k, found.duv));
    if far {
        return;
    }
    match color_rendering(light) {
        Ok(rendering) => {
            facts.value("ra", rendering.ra);
            facts.value("r", rendering.r.to_vec());
            facts.line("Ra", format!("{:.1} (R9 {:.1})", rendering.ra, rendering.r[8]));
        }
        Err(error) => facts.line("Ra", format!("none: {error}")),
    }
}

/// What the light is in photometric units; absolute figures only where its unit is understood.
fn power_facts(facts: &mut Facts, source: &Source) {
    let light = &source.fine;
    let (day, night) = (luminous(light, Adapted::Photopic), luminous(light, Adapted::Scotopic));
    facts.value("efficacy_lm_per_w", efficacy_lm_per_w(light).and_then(finite));
    facts.value("sp_ratio", finite(night / day));
    facts.value("unit", source.unit.as_str());
    if let Some(efficacy) = efficacy_lm_per_w(light) {
        facts.line("efficacy", format!("{efficacy:.1} lm/W of 300 to 780 nm"));
    }
    facts.line(
        "S/P ratio",
        finite(night / day).map_or("none, it is not seen".to_owned(), |_| fixed(night / day, 3)),
    );
    let Some(unit) = source.power_unit else {
        if !source.unit.is_empty() {
            facts.line("luminous", format!("none: the unit '{}' is not understood", source.unit));
        }
        return;
    };
    let (day, night) = (unit.factor * day, unit.factor * night);
    let name = unit.radiometry.photometric_unit();
    facts.value("luminous", finite(day));
    facts.value("scotopic", finite(night));
    facts.value("luminous_unit", name);
    facts.line("luminous", format!("{} {name} by day, {} at night", number(day), number(night)));
}

fn surface_facts(facts: &mut Facts, source: &Source, light: &Source, observer: &Observer) {
    let seen = &source.fine * &light.fine;
    facts.value("kind", "surface");
    facts.value("under", light.name.as_str());
    facts.line("under", format!("{}, {}", light.name, light.title));
    if observer.kind != ObserverKind::Xyz {
        response_facts(facts, &seen, Some(&light.fine), observer);
    }
    let white = relative_xyz(&light.fine, &light.fine, observer);
    let color = relative_xyz(&seen, &light.fine, observer).zip(white);
    if let Some((xyz, white)) = color {
        color_facts(facts, xyz, white);
        if let Some(screen) = DisplayColor::adapted(xyz, white) {
            screen_facts(facts, screen, &format!("adapted from {}", light.name));
        }
    } else if observer.kind == ObserverKind::Xyz {
        facts.line("XYZ", "none: the observer does not see this light");
    }
    if let Some(white) = Chromaticity::of_light(&light.fine) {
        hue_facts(facts, &seen, white, &light.name);
    }
    if let Some((xyz, white)) = color {
        drawn_surface_facts(facts, source, light, lab(xyz, white), observer);
        if let Some(coarse) = &source.coarse
            && let Some(smooth) = relative_xyz(&(&coarse.smooth * &light.fine), &light.fine, observer)
        {
            coarse_facts(facts, coarse, ciede2000(lab(xyz, white), lab(smooth, white)));
        }
    }
}
