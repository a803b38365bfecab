//! A layer of a fluorescent dye over a base.

use schemars::JsonSchema;
use serde::Deserialize;

use super::values::{Amount, At};

/// A layer of a fluorescent dye over a base: a dye by `name`, or `excitation`, `emission` and `quantum_yield`.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct DyeTable {
    /// The name of a dye (`glanz color list dyes`).
    pub name: Option<At<String>>,
    /// A file with the spectrum of excitation or absorbance, on any scale, relative to the scene file.
    pub excitation: Option<At<String>>,
    /// A file with the spectrum of emission, as power per nm on any scale.
    pub emission: Option<At<String>>,
    /// Photons emitted for each absorbed, 0 to 1.
    pub quantum_yield: Option<At<Amount>>,
    /// The greatest decadic absorbance of the layer, for light that enters and comes back: 1, the default, absorbs nine
    /// tenths.
    pub absorbance: Option<At<Amount>>,
    /// The reflectance of the base, 0 to 1; 0.9 by default.
    pub base: Option<At<Amount>>,
}
