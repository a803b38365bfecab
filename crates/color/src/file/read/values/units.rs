//! Units and quantities as headers name them.

use crate::file::read::error::clean;
use crate::file::read::{Place, PowerUnit, Quantity, ReadError};
use crate::spectra::units::{frequency_hz, lambda_nm_of_energy, lambda_nm_of_frequency};

/// Wavelengths that a file may hold, in nm: from X-rays to the far infrared. All else is a wrong unit.
const WAVELENGTHS_NM: core::ops::RangeInclusive<f64> = 10.0..=100_000.0;
/// Wavelengths that are taken for nm where no unit stands.
pub(in crate::file::read) const LIKELY_NM: core::ops::RangeInclusive<f64> = 100.0..=10_000.0;

/// How a file gives the place in the spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Wavelength in nm.
    Nanometres,
    /// Wavelength in µm.
    Micrometres,
    /// Wavelength in m.
    Metres,
    /// Wavelength in Å.
    Angstroms,
    /// Wavenumber in cm⁻¹.
    InverseCentimetres,
    /// Frequency in THz.
    Terahertz,
    /// Frequency in Hz.
    Hertz,
    /// Energy of a photon in eV.
    Electronvolts,
    /// Nothing is said: nm, if they can be.
    #[default]
    Unknown,
}

/// Words that name a scale. `m` comes last: it is in the words of few headers, but in some.
const SCALES: [(&str, Scale); 24] = [
    ("cm-1", Scale::InverseCentimetres),
    ("1/cm", Scale::InverseCentimetres),
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
    ("micrometers", Scale::Micrometres),
    ("micrometre", Scale::Micrometres),
    ("micrometres", Scale::Micrometres),
    ("thz", Scale::Terahertz),
    ("terahertz", Scale::Terahertz),
    ("hz", Scale::Hertz),
    ("ev", Scale::Electronvolts),
    ("å", Scale::Angstroms),
    ("angstrom", Scale::Angstroms),
    ("angstroms", Scale::Angstroms),
    ("a", Scale::Angstroms),
    ("m", Scale::Metres),
];

/// Whether a word is the unit of wavelengths. Single letters are words of many headers.
pub(in crate::file::read) fn names_scale(word: &str) -> bool {
    let plain = plain(word);
    SCALES.iter().any(|(name, _)| *name == plain && name.len() > 1)
}

/// Words in the brackets of an axis that are no units.
const NO_UNITS: [&str; 6] = ["vacuum", "vac", "air", "x", "axis", "λ"];

impl Scale {
    /// The units by name, as options and messages give them, with what they are of.
    pub const UNITS: [(&'static str, &'static str, Self); 8] = [
        ("nm", "Wavelengths in nm", Self::Nanometres),
        ("um", "Wavelengths in µm", Self::Micrometres),
        ("m", "Wavelengths in m", Self::Metres),
        ("angstrom", "Wavelengths in Å", Self::Angstroms),
        ("cm-1", "Wavenumbers in 1/cm", Self::InverseCentimetres),
        ("thz", "Frequencies in THz", Self::Terahertz),
        ("hz", "Frequencies in Hz", Self::Hertz),
        ("ev", "Energies of photons in eV", Self::Electronvolts),
    ];

    /// The unit of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::UNITS.into_iter().find(|(known, ..)| *known == name).map(|(.., scale)| scale)
    }

    /// The scale that a header's text names.
    pub(in crate::file::read) fn of(header: &str) -> Self {
        let lower = plain(header);
        let words = || lower.split(|c: char| !(c.is_alphanumeric() || "-/".contains(c)));
        // What is joined to other words by a slash, as in λ/nm, counts, too.
        let parts = || words().flat_map(|word| word.split('/')).chain(words());
        let named = SCALES.into_iter().find(|(name, scale)| {
            // A lone letter is a unit in brackets only: "a" is a word of many titles.
            let in_brackets = || bracketed(&lower).is_some_and(|unit| unit.trim() == *name);
            parts().any(|word| word == *name) && (*scale != Self::Angstroms || *name != "a" || in_brackets())
        });
        named.map_or(Self::Unknown, |(_, scale)| scale)
    }

    /// The scale of a column of wavelengths by its header, or the unit in brackets that is not known.
    pub(in crate::file::read) fn of_axis(header: &str) -> Result<Self, String> {
        let found = Self::of(header);
        let Some(unit) = bracketed(header).map(str::trim) else { return Ok(found) };
        let is_no_unit = unit.is_empty() || NO_UNITS.contains(&unit.to_lowercase().as_str());
        match found {
            Self::Unknown if !is_no_unit => Err(unit.to_owned()),
            _ => Ok(found),
        }
    }

    /// The wavelength in nm of a number on this scale.
    pub(in crate::file::read) fn nm(
        self,
        value: f64,
        file: &str,
        place: impl FnOnce() -> Place,
    ) -> Result<f64, ReadError> {
        let nm = self.convert(value);
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

    /// Whether a number on this scale may be a wavelength.
    pub(in crate::file::read) fn is_likely(self, value: f64) -> bool {
        let range = if self == Self::Unknown { LIKELY_NM } else { WAVELENGTHS_NM };
        range.contains(&self.convert(value))
    }

    /// The wavelength in nm of a number on this scale, which may be none.
    pub(in crate::file::read) fn convert(self, value: f64) -> f64 {
        match self {
            Self::Nanometres | Self::Unknown => value,
            Self::Micrometres => decimal(value * 1e3),
            Self::Metres => decimal(value * 1e9),
            Self::Angstroms => decimal(value * 0.1),
            Self::InverseCentimetres => 1e7 / value,
            Self::Terahertz => lambda_nm_of_frequency(value * 1e12),
            Self::Hertz => lambda_nm_of_frequency(value),
            Self::Electronvolts => lambda_nm_of_energy(value),
        }
    }

    /// Whether equal steps of it are no equal steps of wavelength.
    pub(in crate::file::read) fn is_inverse(self) -> bool {
        matches!(self, Self::InverseCentimetres | Self::Terahertz | Self::Hertz | Self::Electronvolts)
    }
}

/// A text in small letters, with one micro and one way of writing powers: files use several.
fn plain(text: &str) -> String {
    let lower = text.to_lowercase().replace('μ', "µ");
    lower.replace(['−', '⁻'], "-").replace('¹', "1").replace("cm^-1", "cm-1").replace("cm^{-1}", "cm-1")
}

/// What stands in the last brackets of a text, which may have brackets in them: `sr m2` of `L (W/(sr m2))` is not it.
pub(in crate::file::read) fn bracketed(text: &str) -> Option<&str> {
    let (start, end) = brackets(text)?;
    Some(&text[start + 1..end])
}

/// Where the last outermost brackets of a text open and close.
fn brackets(text: &str) -> Option<(usize, usize)> {
    let mut depth = 0_usize;
    let (mut open, mut found) = (0, None);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => {
                if depth == 0 {
                    open = at;
                }
                depth += 1;
            }
            ')' | ']' if depth > 0 => {
                depth -= 1;
                if depth == 0 {
                    found = Some((open, at));
                }
            }
            _ => {}
        }
    }
    found
}

/// Without the noise of binary fractions, so that 0.58 µm are 580 nm.
fn decimal(nm: f64) -> f64 {
    libm::round(nm * 1e6) / 1e6
}

/// dν/dλ in THz per nm: what a density per THz is multiplied with to be one per nm.
pub(in crate::file::read) fn terahertz_per_nm(nm: f64) -> f64 {
    frequency_hz(nm) * 1e-12 / nm
}

/// What the header of a column says.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::file::read) struct Column {
    /// The name without the unit.
    pub(in crate::file::read) name: String,
    /// What is measured.
    pub(in crate::file::read) quantity: Quantity,
    /// The unit as the file gives it; empty if it does not.
    pub(in crate::file::read) unit: String,
}

impl Column {
    /// Takes a header apart: `name (unit)`, `name [unit]`, `name, unit` or `name`.
    pub(in crate::file::read) fn of(header: &str) -> Self {
        let header = header.trim();
        let (name, unit) = match brackets(header) {
            Some((open, close)) if header[close + 1..].trim().is_empty() => {
                (header[..open].trim(), header[open + 1..close].trim())
            }
            _ => (header, unit_at_end(header)),
        };
        let unit = if is_percent(header) && PowerUnit::parse(unit).is_none() { "%" } else { unit };
        // A reflected radiance has a unit of power, and is light.
        let is_power = PowerUnit::parse(unit).is_some() || photons(unit).is_some();
        let quantity = if is_power { Quantity::Light } else { Quantity::of(header) };
        Self { name: clean(name, MAX_NAME), quantity, unit: clean(unit, MAX_NAME) }
    }

    /// Whether the values are in per cent.
    pub(in crate::file::read) fn is_percent(&self) -> bool {
        is_percent(&self.unit)
    }

    /// Whether the values are densities per THz.
    pub(in crate::file::read) fn is_per_terahertz(&self) -> bool {
        self.unit.to_lowercase().contains("thz")
    }
}

/// Whether a text says per cent: `%`, `% R`, `percent`, `pct`.
pub(in crate::file::read) fn is_percent(text: &str) -> bool {
    let lower = text.to_lowercase();
    let words = || lower.split(|c: char| !(c.is_alphanumeric() || c == '%'));
    lower.contains('%')
        || lower.contains("per cent")
        || words().any(|word| word == "percent" || word == "pct")
}

/// A unit of power behind a name without brackets: `Irradiance W/m2/nm`.
fn unit_at_end(header: &str) -> &str {
    let starts = header.char_indices().filter(|(at, _)| *at > 0 && header[..*at].ends_with([' ', ',']));
    let mut rests = starts.map(|(at, _)| header[at..].trim());
    rests.find(|rest| PowerUnit::parse(rest).is_some() || photons(rest).is_some()).unwrap_or("")
}

/// Whether a unit counts photons, and how many of them are one: `photons/s/m2/nm`, `µmol/m²/s/nm`.
pub(in crate::file::read) fn photons(unit: &str) -> Option<f64> {
    let unit = plain(unit);
    let first =
        unit.split(|c: char| c.is_whitespace() || "/·*.".contains(c)).find(|word| !word.is_empty())?;
    match first {
        "photon" | "photons" | "quanta" => Some(1.0),
        "µmol" | "umol" | "micromol" | "micromoles" => Some(1e-6 * AVOGADRO),
        "mmol" => Some(1e-3 * AVOGADRO),
        "mol" => Some(AVOGADRO),
        _ => None,
    }
}

/// Photons in a mole of them (SI, 2019: exact).
const AVOGADRO: f64 = 6.022_140_76e23;

/// The most characters of a name or a unit that are kept.
pub(in crate::file::read) const MAX_NAME: usize = 200;

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
            ("a lamp", Scale::Unknown),
            ("Wavelength (A)", Scale::Angstroms),
            ("Wavenumber (cm-1)", Scale::InverseCentimetres),
            ("ν̃ / cm⁻¹", Scale::InverseCentimetres),
            ("Energy [eV]", Scale::Electronvolts),
            ("Frequency (Hz)", Scale::Hertz),
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
        assert_eq!(nm(Scale::InverseCentimetres, 20_000.0), 500.0);
        assert!((nm(Scale::Electronvolts, 2.0) - 619.92).abs() < 0.01);
        let message = Scale::Nanometres.nm(0.5, "f", || Place::Line(3)).unwrap_err().to_string();
        assert_eq!(message, "f: line 3: expected a wavelength from 10 nm to 100 µm, found 0.5");
        assert!(Scale::Unknown.nm(0.5, "f", || Place::File).is_err());
        assert!(Scale::Terahertz.nm(0.0, "f", || Place::File).is_err());
    }

    #[test]
    fn a_unit_that_is_not_known_is_told() {
        assert_eq!(Scale::of_axis("Position (px)"), Err("px".to_owned()));
        assert_eq!(Scale::of_axis("Wavelength (vacuum)"), Ok(Scale::Unknown));
        assert_eq!(Scale::of_axis("Wavelength [nm]"), Ok(Scale::Nanometres));
    }

    #[test]
    fn photons_are_counted_in_several_ways() {
        assert_eq!(photons("photons/s/m2/nm"), Some(1.0));
        assert_eq!(photons("µmol m-2 s-1 nm-1"), Some(6.022_140_76e17));
        assert_eq!(photons("W/m2/nm"), None);
    }

    #[test]
    fn headers_hold_a_name_and_a_unit() {
        let column = Column::of("Red patch reflectance (%)");
        assert_eq!((column.name.as_str(), column.quantity), ("Red patch reflectance", Quantity::Reflectance));
        assert!(column.is_percent());
        let column = Column::of("lamp [W/m2/nm]");
        assert_eq!((column.name.as_str(), column.unit.as_str()), ("lamp", "W/m2/nm"));
        assert!(Column::of("%T").is_percent() && Column::of("% R").is_percent());
        assert!(!Column::of("Reflectance (8/d)").is_percent());
        let column = Column::of("L (W/(sr m2 nm))");
        assert_eq!((column.name.as_str(), column.unit.as_str()), ("L", "W/(sr m2 nm)"));
        assert_eq!(column.quantity, Quantity::Light);
        for header in ["Reflected radiance (W/m2/sr/nm)", "Reflected radiance", "light reflected, W/m2/nm"] {
            assert_eq!(Column::of(header).quantity, Quantity::Light, "{header}");
        }
        assert_eq!(Column::of("Reflected radiance factor").quantity, Quantity::Reflectance);
        assert_eq!(Column::of("Irradiance W/m2/nm").unit, "W/m2/nm");
        assert!(Column::of("L (W/sr/m2/THz)").is_per_terahertz());
    }
}
