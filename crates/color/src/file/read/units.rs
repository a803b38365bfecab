//! Units and quantities as headers name them.

use super::error::clean;
use super::{Place, Quantity, ReadError};
use crate::spectra::units::{frequency_hz, lambda_nm_of_frequency};

/// Wavelengths that a file may hold, in nm: from X-rays to the far infrared. All else is a wrong unit.
const WAVELENGTHS_NM: core::ops::RangeInclusive<f64> = 10.0..=100_000.0;
/// Wavelengths that are taken for nm where no unit stands.
pub(super) const LIKELY_NM: core::ops::RangeInclusive<f64> = 100.0..=10_000.0;

/// How a file gives the place in the spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    /// Wavelength in nm.
    Nanometres,
    /// Wavelength in µm.
    Micrometres,
    /// Wavelength in m.
    Metres,
    /// Wavelength in Å.
    Angstroms,
    /// Frequency in THz.
    Terahertz,
    /// Nothing is said: nm, if they can be.
    Unknown,
}

/// Words that name a scale. `m` comes last: it is in the words of few headers, but in some.
const SCALES: [(&str, Scale); 17] = [
    ("nm", Scale::Nanometres),
    ("nanometer", Scale::Nanometres),
    ("nanometers", Scale::Nanometres),
    ("nanometre", Scale::Nanometres),
    ("nanometres", Scale::Nanometres),
    ("µm", Scale::Micrometres),
    ("um", Scale::Micrometres),
    ("micron", Scale::Micrometres),
    ("microns", Scale::Micrometres),
    ("micrometer", Scale::Micrometres),
    ("micrometre", Scale::Micrometres),
    ("thz", Scale::Terahertz),
    ("terahertz", Scale::Terahertz),
    ("å", Scale::Angstroms),
    ("angstrom", Scale::Angstroms),
    ("angstroms", Scale::Angstroms),
    ("m", Scale::Metres),
];

impl Scale {
    /// The scale that a header's text names.
    pub(super) fn of(header: &str) -> Self {
        // Two characters look like a micro; files use both.
        let lower = header.to_lowercase().replace('μ', "µ");
        let words = || lower.split(|c: char| !c.is_alphanumeric());
        let named = SCALES.into_iter().find(|(name, _)| words().any(|word| word == *name));
        named.map_or(Self::Unknown, |(_, scale)| scale)
    }

    /// The wavelength in nm of a number on this scale.
    pub(super) fn nm(self, value: f64, file: &str, place: impl FnOnce() -> Place) -> Result<f64, ReadError> {
        let nm = match self {
            Self::Nanometres | Self::Unknown => value,
            Self::Micrometres => decimal(value * 1e3),
            Self::Metres => decimal(value * 1e9),
            Self::Angstroms => decimal(value * 0.1),
            Self::Terahertz => lambda_nm_of_frequency(value * 1e12),
        };
        let (range, expected) = match self {
            Self::Unknown => {
                (LIKELY_NM, "wavelengths from 100 to 10000 nm, or another unit (µm, m, THz) in a header")
            }
            _ => (WAVELENGTHS_NM, "a wavelength from 10 nm to 100 µm"),
        };
        if range.contains(&nm) {
            return Ok(nm);
        }
        let found = if nm == value { format!("{value}") } else { format!("{value}, which is {nm} nm") };
        Err(ReadError::malformed(file, place(), expected, found))
    }
}

/// Without the noise of binary fractions, so that 0.58 µm are 580 nm.
fn decimal(nm: f64) -> f64 {
    libm::round(nm * 1e6) / 1e6
}

/// dν/dλ in THz per nm: what a density per THz is multiplied with to be one per nm.
pub(super) fn terahertz_per_nm(nm: f64) -> f64 {
    frequency_hz(nm) * 1e-12 / nm
}

/// What the header of a column says.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Column {
    /// The name without the unit.
    pub(super) name: String,
    /// What is measured.
    pub(super) quantity: Quantity,
    /// The unit as the file gives it; empty if it does not.
    pub(super) unit: String,
}

impl Column {
    /// Takes a header apart: `name (unit)`, `name [unit]` or `name`.
    pub(super) fn of(header: &str) -> Self {
        let header = header.trim();
        let open = header.rfind(['(', '[']).filter(|_| header.ends_with([')', ']']));
        let (name, unit) = match open {
            Some(open) => (header[..open].trim(), header[open + 1..].trim_end_matches([')', ']']).trim()),
            None => (header, ""),
        };
        let unit = if unit.is_empty() && header.contains('%') { "%" } else { unit };
        let quantity = Quantity::of(header);
        Self { name: clean(name, MAX_NAME), quantity, unit: clean(unit, MAX_NAME) }
    }

    /// Whether the values are in per cent.
    pub(super) fn is_percent(&self) -> bool {
        let unit = self.unit.to_lowercase();
        unit == "%" || unit == "percent" || unit == "per cent" || unit == "pct"
    }

    /// Whether the values are densities per THz.
    pub(super) fn is_per_terahertz(&self) -> bool {
        self.unit.to_lowercase().contains("thz")
    }
}

/// The most characters of a name or a unit that are kept.
pub(super) const MAX_NAME: usize = 200;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_found_among_words() {
        for (header, scale) in [
            ("Wavelength (nm)", Scale::Nanometres),
            ("lambda_nm", Scale::Nanometres),
            ("λ [µm]", Scale::Micrometres),
            ("λ/μm", Scale::Micrometres),
            ("wavelength m", Scale::Metres),
            ("frequency (THz)", Scale::Terahertz),
            ("Wavelength", Scale::Unknown),
            ("some", Scale::Unknown),
        ] {
            assert_eq!(Scale::of(header), scale, "{header}");
        }
    }

    #[test]
    fn every_scale_gives_nm() {
        let nm = |scale: Scale, value| scale.nm(value, "f", || Place::File).unwrap();
        assert_eq!(nm(Scale::Micrometres, 0.58), 580.0);
        assert_eq!(nm(Scale::Metres, 5.55e-7), 555.0);
        assert_eq!(nm(Scale::Angstroms, 5461.0), 546.1);
        assert_eq!(nm(Scale::Terahertz, 599.584916), 500.0);
        let message = Scale::Nanometres.nm(0.5, "f", || Place::Line(3)).unwrap_err().to_string();
        assert_eq!(message, "f: line 3: expected a wavelength from 10 nm to 100 µm, found 0.5");
        assert!(Scale::Unknown.nm(0.5, "f", || Place::File).is_err());
        assert!(Scale::Terahertz.nm(0.0, "f", || Place::File).is_err());
    }

    #[test]
    fn headers_hold_a_name_and_a_unit() {
        let column = Column::of("Red patch reflectance (%)");
        assert_eq!((column.name.as_str(), column.quantity), ("Red patch reflectance", Quantity::Reflectance));
        assert!(column.is_percent());
        let column = Column::of("lamp [W/m2/nm]");
        assert_eq!((column.name.as_str(), column.unit.as_str()), ("lamp", "W/m2/nm"));
        assert!(Column::of("%T").is_percent());
        assert!(Column::of("L (W/sr/m2/THz)").is_per_terahertz());
    }
}
