//! `glanz color xy`: the numbers of a chromaticity.

use std::fmt::Write;

use clap::Args;
use glanz_color::chromaticity::Chromaticity;
use glanz_color::dominant::{complementary, dominant};
use glanz_color::temperature::{MOST_DUV, color_temperature};
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::numbers;
use crate::input::spectra::light_source;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, decimals, fixed, wavelength};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color xy 0.3127,0.3290
  glanz color xy 0.45,0.41 --white D65 --format json
  glanz color xy 0.1978,0.4684 --from uv1976

Dominant wavelength and purity are against --white, equal energy by default, as for a light.
Colour temperature and Duv are those of the nearest black body in the CIE 1960 diagram; beyond a
Duv of 0.05 they mean nothing. All are those of the CIE 1931 observer, as they are defined.";

/// In which diagram the two numbers are.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
enum Diagram {
    /// x, y of CIE 1931
    Xy,
    /// u, v of CIE 1960
    Uv1960,
    /// u', v' of CIE 1976
    Uv1976,
}

/// Options of `glanz color xy`.
#[derive(Args, Debug)]
pub(crate) struct XyArgs {
    /// The chromaticity: two numbers
    #[arg(value_name = "X,Y", allow_hyphen_values = true)]
    chromaticity: String,

    /// The diagram that the numbers are of
    #[arg(long, value_enum, value_name = "DIAGRAM", default_value = "xy")]
    from: Diagram,

    /// The white of the dominant wavelength: a light's name or file
    #[arg(long, value_name = "LIGHT", default_value = "E")]
    white: String,

    #[command(flatten)]
    format: FormatArgs,
}

/// The numbers of a chromaticity.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// x, y of CIE 1931
    xy: [f64; 2],
    /// u, v of CIE 1960
    uv1960: [f64; 2],
    /// u', v' of CIE 1976
    uv1976: [f64; 2],
    /// The white of the dominant wavelength
    white: String,
    /// In nm; of purples minus the complementary wavelength; null for the white itself
    dominant_nm: Option<f64>,
    /// The excitation purity
    purity: Option<f64>,
    /// In nm; of greens, whose complement is purple, minus their own dominant wavelength
    complementary_nm: Option<f64>,
    /// The correlated colour temperature in K
    cct_k: Option<f64>,
    /// The distance from the black bodies in u, v; positive is greenish
    duv: Option<f64>,
    /// Whether the distance is so small that the temperature says something
    cct_is_meaningful: bool,
}

impl XyArgs {
    /// Tells the numbers.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let color = self.color()?;
        let light = light_source(&self.white)?;
        let white = match light.name.as_str() {
            "E" => Chromaticity::E,
            name => Chromaticity::of_light(&light.fine)
                .ok_or_else(|| Failure::Usage(format!("no observer sees the light '{name}'")))?,
        };
        let found = dominant(color, white).ok();
        if let Some(purity) = found.map(|found| found.purity).filter(|purity| *purity > 1.0) {
            let purity = fixed(purity, 3);
            print::note(format_args!(
                "note: no light has this chromaticity: it lies outside of the spectral locus (purity {purity})"
            ));
        }
        let temperature = color_temperature(color).ok();
        let document = Document {
            xy: [color.x, color.y],
            uv1960: color.uv1960(),
            uv1976: color.uv1976(),
            white: light.name,
            dominant_nm: found.map(|found| found.nm),
            purity: found.map(|found| found.purity),
            complementary_nm: complementary(color, white).ok().map(|found| found.nm),
            cct_k: temperature.map(|found| found.cct_k),
            duv: temperature.map(|found| found.duv),
            cct_is_meaningful: temperature.is_some_and(|found| found.duv.abs() <= MOST_DUV),
        };
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text(&document, color, white))
    }

    fn color(&self) -> Result<Chromaticity, Failure> {
        let wrong = |message: String| Failure::Usage(format!("'{}': {message}", self.chromaticity));
        let found = numbers(&self.chromaticity).map_err(&wrong)?;
        let pair: [f64; 2] = found
            .try_into()
            .map_err(|found: Vec<f64>| wrong(format!("expected two numbers x,y, found {}", found.len())))?;
        let color = match self.from {
            Diagram::Xy => Chromaticity::new(pair[0], pair[1]),
            Diagram::Uv1960 => Chromaticity::from_uv1960(pair),
            Diagram::Uv1976 => Chromaticity::from_uv1976(pair),
        };
        let is_possible = color.x >= 0.0 && color.y > 0.0 && color.x + color.y <= 1.0;
        match is_possible {
            true => Ok(color),
            false => Err(wrong(format!(
                "no colour has x {}, y {}: both are at least 0, y above it, and their sum at most 1",
                color.x, color.y
            ))),
        }
    }
}

fn text(document: &Document, color: Chromaticity, white: Chromaticity) -> String {
    let mut text = String::new();
    let mut line = |label: &str, value: String| {
        writeln!(text, "{label:<14} {value}").expect("a string takes everything");
    };
    line("xy", decimals(&document.xy, 5));
    line("uv (1960)", decimals(&document.uv1960, 5));
    line("u'v' (1976)", decimals(&document.uv1976, 5));
    match dominant(color, white) {
        Ok(found) => {
            line("dominant", format!("{} against {}", wavelength(&found), document.white));
            line("purity", fixed(found.purity, 4));
        }
        Err(error) => line("dominant", format!("none: {error}")),
    }
    if let Ok(found) = complementary(color, white)
        && !found.is_purple()
    {
        line("complementary", wavelength(&found));
    }
    match (document.cct_k, document.duv) {
        (Some(kelvin), Some(duv)) => {
            let far = " (too far from black bodies to mean much)";
            let warning = if document.cct_is_meaningful { "" } else { far };
            line("CCT", format!("{kelvin:.1} K, Duv {duv:+.4}{warning}"));
        }
        _ => line("CCT", "none: no black body is near".to_owned()),
    }
    text
}
