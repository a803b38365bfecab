//! The names of tone mappings: the one list of scene files, command line and pictures.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How radiance is compressed to the display's range. All work on linear sRGB; formulas and sources
/// are those of the module `tone_map` of glanz-picture, which does it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ToneMap {
    /// Not at all: what is above 1 is clipped.
    #[default]
    None,
    /// Reinhard et al. 2002, equation 3: luminance L becomes L / (1 + L), chromaticity is kept.
    Reinhard,
    /// ACES, the reference and output transform for sRGB as fitted by Stephen Hill.
    Aces,
    /// AgX by Troy Sobotka, base look.
    Agx,
    /// Khronos PBR neutral.
    KhronosNeutral,
}

impl ToneMap {
    /// All of them with their names in files and on the command line.
    pub const ALL: [(Self, &'static str); 5] = [
        (Self::None, "none"),
        (Self::Reinhard, "reinhard"),
        (Self::Aces, "aces"),
        (Self::Agx, "agx"),
        (Self::KhronosNeutral, "khronos-neutral"),
    ];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The tone map with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| *known == name).map(|(map, _)| *map)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_tone_map_is_found_by_its_name() {
        for (map, name) in ToneMap::ALL {
            assert_eq!((ToneMap::named(name), map.name()), (Some(map), name));
        }
        assert_eq!(ToneMap::named("filmic"), None);
    }
}
