//! Coats and panes.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::file::tables::colors::ColorValue;
use crate::file::tables::media::IorValue;
use crate::file::tables::values::{Amount, At, Fraction};

/// A layer over a material.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CoatTable {
    /// Its index of refraction, or the name of a glass; 1.5 by default.
    pub ior: Option<At<IorValue>>,
    /// The width of its highlight, as of the shape `ggx`; 0.03 by default.
    pub alpha: Option<At<Fraction>>,
    /// How much of the surface it covers; 1 by default.
    pub weight: Option<At<Fraction>>,
    /// Its thickness in mm, 0.05 by default; 0 is no coat.
    pub thickness_mm: Option<At<Amount>>,
    /// Its transmittance over 1 mm: a colour or a spectrum; 1 by default.
    pub transmittance_1mm: Option<At<ColorValue>>,
}

/// A sheet of glass.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PaneTable {
    /// Its index of refraction, or the name of a glass; 1.5 by default.
    pub ior: Option<At<IorValue>>,
    /// The width of its highlight, as of the shape `ggx`; 0.01 by default.
    pub alpha: Option<At<Fraction>>,
    /// Its thickness in mm; 4 by default.
    pub thickness_mm: Option<At<Amount>>,
    /// Its transmittance over 1 mm: a colour or a spectrum; 1 by default.
    pub transmittance_1mm: Option<At<ColorValue>>,
}
