//! What may stand where a colour may: RGB, or a table that names a function of wavelength.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::dyes::DyeTable;
use super::media::{CoatAbove, IorValue};
use super::sampled::Sampled;
use super::spectra_files::{AxisUnit, Column, FileQuantity, ScaleValue};
use super::values::{Amount, At, Color, Number};
use crate::Polarization;

/// A function of wavelength: exactly one of `spectrum`, `blackbody`, `gaussian`, `line`, `file`,
/// `nm` with `value`, `samples`, `reradiation`, `dye`, `matrix`, `pane`, `schlick`, and `ior` or `film_nm`.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct SpectralTable {
    /// The name of a light source (`glanz color list lights`) or of a reflectance.
    pub spectrum: Option<At<String>>,
    /// Temperature of a black body in K; light only.
    pub blackbody: Option<At<Amount>>,
    /// Centre and full width at half the maximum of a Gaussian, in nm.
    pub gaussian: Option<At<[Amount; 2]>>,
    /// Wavelength of a single line in nm; light only.
    pub line: Option<At<Amount>>,
    /// A file with a spectrum (CSV, SPDX, CGATS, CxF), relative to the scene file.
    pub file: Option<At<String>>,
    /// Which spectrum of a file with several, by its name, or its number from 1.
    pub column: Option<At<Column>>,
    /// What the file's values are, where it does not say it or is wrong.
    #[serde(rename = "as")]
    pub quantity: Option<At<FileQuantity>>,
    /// The unit of the file's wavelengths, where it does not say it or is wrong.
    pub unit: Option<At<AxisUnit>>,
    /// Column and row, from 0 at the top left, of the pixel of a spectral OpenEXR picture; the one in the middle by default.
    pub pixel: Option<At<[u32; 2]>>,
    /// Wavelengths in nm, increasing; with `value`.
    pub nm: Option<At<Vec<Number>>>,
    /// The values at these wavelengths.
    pub value: Option<At<Vec<Number>>>,
    /// The name of a fluorescent material (`glanz color list fluorescent`), or a file with its
    /// re-radiation matrix (BFC, CSV); surfaces only.
    pub reradiation: Option<At<String>>,
    /// A layer of a fluorescent dye over a base; surfaces only.
    pub dye: Option<Box<At<DyeTable>>>,
    /// Fresnel reflection: the name of a metal or glass (`glanz color list metals`), an index of refraction from 1.05
    /// to 20, n and k as "1.5+3i", in numbers or from a file; surfaces only.
    pub ior: Option<At<IorValue>>,
    /// Beside `ior`: Fresnel reflection through a polarising filter: the electric field perpendicular ("s") or
    /// parallel ("p") to the plane of incidence.
    pub polarization: Option<At<Polarization>>,
    /// Beside `ior` or `film_nm`: a coat above, through which light meets the boundary; highlights only.
    pub under_coat: Option<At<CoatAbove>>,
    /// Thickness in nm of a thin film, whose colours are those of interference; `ior` is what it lies on,
    /// air if that is missing. Surfaces only.
    pub film_nm: Option<At<Amount>>,
    /// What the film is made of: a glass, or an index of refraction; 1.33 by default.
    pub film_ior: Option<At<IorValue>>,
    /// The function as the scene holds it: a number, or the 97 values at 300, 305 … 780 nm. Of light they are in the
    /// scene's unit, and their level counts.
    pub samples: Option<At<Sampled>>,
    /// A re-radiation matrix: 97 rows, one for each wavelength of emission, of the re-radiated fractions of light at each of the
    /// 97 wavelengths of incidence; surfaces only.
    pub matrix: Option<At<Vec<Sampled>>>,
    /// What both sides of a pane reflect, or, in `transmittance`, what passes it; surfaces only.
    pub pane: Option<At<PaneTintTable>>,
    /// What rises to 1 at grazing angles in Schlick's form; surfaces only.
    pub schlick: Option<Box<At<ColorValue>>>,
    /// Multiplies the function; 1 by default. Of a file, "percent" or "fraction" says what its values are.
    pub scale: Option<At<ScaleValue>>,
    /// For light that a surface sends itself: its luminance in cd/m².
    pub luminance_cd_m2: Option<At<Amount>>,
}

/// A pane by its numbers: what both of its sides reflect, or what it lets through.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PaneTintTable {
    /// Its index of refraction.
    pub ior: IorValue,
    /// Its thickness in m.
    pub thickness_m: Number,
    /// Its absorption in 1/m; 0 by default.
    pub absorption: Option<Sampled>,
}

/// A colour: RGB, or a function of wavelength.
#[derive(Debug)]
pub(crate) enum ColorValue {
    Rgb(Color),
    Spectral(Box<SpectralTable>),
}

impl<'de> Deserialize<'de> for ColorValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value;
        impl<'de> Visitor<'de> for Value {
            type Value = ColorValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "a colour: three amounts such as [1.0, 0.5, 0.0], one for a grey, \"#rrggbb\", or a table such as { spectrum = \"D65\" }",
                )
            }
            fn visit_f64<E: Error>(self, amount: f64) -> Result<ColorValue, E> {
                Color::deserialize(serde::de::value::F64Deserializer::new(amount)).map(ColorValue::Rgb)
            }
            fn visit_i64<E: Error>(self, amount: i64) -> Result<ColorValue, E> {
                self.visit_f64(amount as f64)
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<ColorValue, E> {
                Color::deserialize(serde::de::value::StrDeserializer::new(text)).map(ColorValue::Rgb)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<ColorValue, A::Error> {
                Color::deserialize(SeqAccessDeserializer::new(seq)).map(ColorValue::Rgb)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ColorValue, A::Error> {
                let table = SpectralTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(ColorValue::Spectral(Box::new(table)))
            }
        }
        deserializer.deserialize_any(Value)
    }
}

impl JsonSchema for ColorValue {
    fn schema_name() -> Cow<'static, str> {
        "ColorOrSpectrum".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let color = generator.subschema_for::<Color>();
        let table = generator.subschema_for::<SpectralTable>();
        json_schema!({ "anyOf": [color, table] })
    }
}

/// A spectrum: the name of one, or its table.
#[derive(Debug)]
pub(crate) enum SpectrumValue {
    Name(String),
    Table(Box<SpectralTable>),
}

impl<'de> Deserialize<'de> for SpectrumValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value;
        impl<'de> Visitor<'de> for Value {
            type Value = SpectrumValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "the name of a light source such as \"D65\", or a table such as { blackbody = 2856 }",
                )
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<SpectrumValue, E> {
                Ok(SpectrumValue::Name(name.to_owned()))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<SpectrumValue, A::Error> {
                let table = SpectralTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(SpectrumValue::Table(Box::new(table)))
            }
        }
        deserializer.deserialize_any(Value)
    }
}

impl JsonSchema for SpectrumValue {
    fn schema_name() -> Cow<'static, str> {
        "SpectrumOrName".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<SpectralTable>();
        let name = "The name of a light source, as `glanz color list lights` tells them.";
        json_schema!({ "anyOf": [{ "type": "string", "description": name }, table] })
    }
}
