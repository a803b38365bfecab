//! Units of spectral power, as headers of files give them.

use crate::file::read::{NamedSpectrum, Quantity};

/// What an absolute spectrum measures: radiant quantities and the photometric ones that follow from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radiometry {
    /// Power, W/nm: luminous flux in lm.
    Flux,
    /// Power per area, W/(m² nm): illuminance in lx.
    Irradiance,
    /// Power per solid angle, W/(sr nm): luminous intensity in cd.
    Intensity,
    /// Power per area and solid angle, W/(m² sr nm): luminance in cd/m².
    Radiance,
}

impl Radiometry {
    /// The unit of the photometric quantity.
    pub const fn photometric_unit(self) -> &'static str {
        match self {
            Self::Flux => "lm",
            Self::Irradiance => "lx",
            Self::Intensity => "cd",
            Self::Radiance => "cd/m²",
        }
    }
}

/// A unit of spectral power in units of W, m², sr and nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerUnit {
    /// What is measured in it.
    pub radiometry: Radiometry,
    /// How many of the units without prefixes it is: 0.01 for µW/(cm² nm).
    pub factor: f64,
}

/// Prefixes of the watt; large and small letters are different ones.
const WATTS: [(&str, f64); 11] = [
    ("W", 1.0),
    ("w", 1.0),
    ("watt", 1.0),
    ("watts", 1.0),
    ("kW", 1e3),
    ("mW", 1e-3),
    ("µW", 1e-6),
    ("uW", 1e-6),
    ("nW", 1e-9),
    ("pW", 1e-12),
    ("MW", 1e6),
];
/// What power is divided by: the unit, which of area, solid angle and wavelength it is, its size.
const DIVISORS: [(&str, usize, f64); 9] = [
    ("m2", 0, 1.0),
    ("sqm", 0, 1.0),
    ("cm2", 0, 1e-4),
    ("mm2", 0, 1e-6),
    ("sr", 1, 1.0),
    ("nm", 2, 1.0),
    ("µm", 2, 1e3),
    ("um", 2, 1e3),
    // The reader has converted densities per THz to densities per nm.
    ("THz", 2, 1.0),
];

impl PowerUnit {
    /// The unit of a text such as `W/m²/nm`, `µW/(cm² nm)` or `W sr-1 m-2 nm-1`; none where it is not of
    /// spectral power, or not understood.
    pub fn parse(text: &str) -> Option<Self> {
        // Two characters look like a micro, and exponents are written in many ways.
        let text = text
            .replace('μ', "µ")
            .replace(" per ", "/")
            .replace('²', "2")
            .replace("⁻", "-")
            .replace('¹', "1");
        let text = text.replace(['^', '{', '}'], "").replace('−', "-");
        let (above, below) = text.split_once('/').unwrap_or((&text, ""));
        let words = |part: &str| -> Vec<String> {
            let split = part.split(|c: char| c.is_whitespace() || "/()[]*·⋅×.".contains(c));
            split.filter(|word| !word.is_empty()).map(str::to_owned).collect()
        };
        let (above, below) = (words(above), words(below));
        let (watt, above) = above.split_first()?;
        let &(_, mut factor) = WATTS.iter().find(|(name, _)| name == watt)?;
        let mut divided = [false; 3];
        // Before the slash only negative powers divide, behind it all.
        let above = above.iter().map(|word| word.replace("-2", "2").replace("-1", "")).zip(above);
        for (word, whole) in above {
            take(&word, &mut divided, &mut factor).filter(|()| whole.contains('-'))?;
        }
        below.iter().try_for_each(|word| take(word, &mut divided, &mut factor))?;
        let radiometry = match divided {
            [false, false, true] => Radiometry::Flux,
            [true, false, true] => Radiometry::Irradiance,
            [false, true, true] => Radiometry::Intensity,
            [true, true, true] => Radiometry::Radiance,
            _ => return None,
        };
        Some(Self { radiometry, factor })
    }
}

/// Divides by a unit; none where it is unknown, or one of its kind has been there.
fn take(word: &str, divided: &mut [bool; 3], factor: &mut f64) -> Option<()> {
    let &(_, kind, size) = DIVISORS.iter().find(|(name, ..)| *name == word)?;
    if core::mem::replace(&mut divided[kind], true) {
        return None;
    }
    *factor /= size;
    Some(())
}

impl NamedSpectrum {
    /// The unit of its values, where it is one of spectral power that is understood.
    pub fn power_unit(&self) -> Option<PowerUnit> {
        PowerUnit::parse(&self.unit)
            .filter(|_| !self.quantity.is_ratio() && self.quantity != Quantity::Relative)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_power_are_understood_with_their_prefixes() {
        for (text, radiometry, factor) in [
            ("W/nm", Radiometry::Flux, 1.0),
            ("mW/m²/nm", Radiometry::Irradiance, 1e-3),
            ("µW/cm²/nm", Radiometry::Irradiance, 1e-2),
            ("uW cm^-2 nm^-1", Radiometry::Irradiance, 1e-2),
            ("μW·cm⁻²·nm⁻¹", Radiometry::Irradiance, 1e-2),
            ("W/(m2 sr nm)", Radiometry::Radiance, 1.0),
            ("W/sr/m2/THz", Radiometry::Radiance, 1.0),
            ("W.m-2.sr-1.µm-1", Radiometry::Radiance, 1e-3),
            ("mW/sr/nm", Radiometry::Intensity, 1e-3),
            ("MW/m2/nm", Radiometry::Irradiance, 1e6),
            ("W.sr⁻¹.m⁻².nm⁻¹", Radiometry::Radiance, 1.0),
            ("W/(sr m2 nm)", Radiometry::Radiance, 1.0),
            ("watts/sqm/nm", Radiometry::Irradiance, 1.0),
        ] {
            let found = PowerUnit::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(found.radiometry, radiometry, "{text}");
            assert!((found.factor / factor - 1.0).abs() < 1e-12, "{text}: {}", found.factor);
        }
    }

    #[test]
    fn other_units_are_not_guessed() {
        for text in [
            "",
            "W",
            "W/m2",
            "W nm",
            "W m2/nm",
            "counts/nm",
            "W/ft2/nm",
            "W/nm/nm",
            "/nm",
            "%",
            "photons/s/m2/nm",
        ] {
            assert_eq!(PowerUnit::parse(text), None, "{text}");
        }
    }
}
