//! How files of spectra are read: the options of all commands that read them.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use glanz_color::SpectrumKind;
use glanz_color::read::{Quantity, ReadOptions, Scale, ValueScale};

/// What the option --as takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// Power by wavelength
    Light,
    /// Reflectance or transmittance by wavelength
    Surface,
    /// What comes back of the light
    Reflectance,
    /// What passes of the light
    Transmittance,
    /// -log10 of what passes
    Absorbance,
}

impl Kind {
    /// Whether it is of a light or of a surface.
    pub(crate) fn spectrum_kind(self) -> SpectrumKind {
        match self {
            Self::Light => SpectrumKind::Light,
            Self::Surface | Self::Reflectance | Self::Transmittance | Self::Absorbance => {
                SpectrumKind::Surface
            }
        }
    }

    fn quantity(self) -> Quantity {
        match self {
            Self::Light => Quantity::Light,
            Self::Surface | Self::Reflectance => Quantity::Reflectance,
            Self::Transmittance => Quantity::Transmittance,
            Self::Absorbance => Quantity::Absorbance,
        }
    }
}

/// How files of spectra are read, where they do not say it or are wrong.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Files of spectra")]
pub(crate) struct TableArgs {
    /// What a file's spectrum is of, where the file does not say it or is wrong
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub kind: Option<Kind>,

    /// The unit of a file's wavelengths
    #[arg(long, value_name = "UNIT", value_parser = units())]
    pub unit: Option<Scale>,

    /// The scale of a file's values: fraction, percent, or the value that stands for 1
    #[arg(long, value_name = "SCALE", value_parser = value_scale)]
    pub scale: Option<ValueScale>,

    /// Which of a file's spectra: its name, or its number from 1
    #[arg(long, value_name = "NAME|NUMBER")]
    pub column: Option<String>,

    /// Of a spectral picture (OpenEXR), the pixel, from 0,0 at the top left [default: the middle]
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pub pixel: Option<(usize, usize)>,
}

/// Parses what --unit takes.
fn units() -> impl TypedValueParser<Value = Scale> {
    let values = Scale::UNITS.iter().map(|(name, about, _)| PossibleValue::new(name).help(*about));
    PossibleValuesParser::new(values).try_map(|name| Scale::named(&name).ok_or("a unit of wavelength"))
}

/// Parses what --pixel takes.
fn pixel(text: &str) -> Result<(usize, usize), String> {
    let both = text.split_once(',').and_then(|(x, y)| Some((x.trim().parse().ok()?, y.trim().parse().ok()?)));
    both.ok_or_else(|| "expected column and row of a pixel, such as 320,240".to_owned())
}

/// Parses what --scale takes.
fn value_scale(text: &str) -> Result<ValueScale, String> {
    match text {
        "fraction" => Ok(ValueScale::Fraction),
        "percent" | "%" => Ok(ValueScale::Percent),
        other => {
            match other.parse::<f64>() {
                Ok(value) if value > 0.0 && value.is_finite() => Ok(ValueScale::Whole(value)),
                _ => Err("expected fraction, percent, or a number above 0 that stands for 1, such as 255"
                    .to_owned()),
            }
        }
    }
}

impl TableArgs {
    /// What is known of a file where the command wants this kind.
    pub(super) fn options(&self, wanted: Option<SpectrumKind>) -> ReadOptions {
        ReadOptions {
            quantity: self.kind.map(Kind::quantity),
            default_quantity: wanted.map(|kind| match kind {
                SpectrumKind::Light => Quantity::Light,
                SpectrumKind::Surface => Quantity::Reflectance,
            }),
            unit: self.unit,
            scale: self.scale,
            pixel: self.pixel,
        }
    }

    /// The same for the lights beside the spectra that it is about: what those are of does not hold for them.
    pub(super) fn of_lights(&self) -> Self {
        Self { kind: None, column: None, ..self.clone() }
    }
}
