//! Names of channels.

use crate::spectra::units::{SPEED_OF_LIGHT, frequency_hz};

/// What a channel holds, told by its name. Wavelengths are in nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ChannelKind {
    /// A Stokes component of light, 0 to 3.
    Emissive(u8, f64),
    /// A fraction of light.
    Reflective(f64),
    /// Re-radiation from the first to the second wavelength.
    Bispectral(f64, f64),
    /// A channel of the preview.
    Rgb(usize),
    /// Something else.
    Other,
}

impl ChannelKind {
    /// The kind that a name tells.
    pub(super) fn of(name: &str) -> Self {
        if let Some(index) = ["R", "G", "B"].iter().position(|rgb| *rgb == name) {
            return Self::Rgb(index);
        }
        let Some((kind, rest)) = name.split_once('.') else { return Self::Other };
        let stokes = match kind {
            "S0" => Some(0),
            "S1" => Some(1),
            "S2" => Some(2),
            "S3" => Some(3),
            _ => None,
        };
        let pair = rest.split_once('.').map(|(a, b)| (wavelength(a), wavelength(b)));
        match (stokes, kind, pair) {
            (Some(component), _, None) => {
                wavelength(rest).map_or(Self::Other, |nm| Self::Emissive(component, nm))
            }
            (None, "T", None) => wavelength(rest).map_or(Self::Other, Self::Reflective),
            (None, "T", Some((Some(input), Some(out)))) if input == out => Self::Reflective(input),
            (None, "T", Some((Some(input), Some(out)))) => Self::Bispectral(input, out),
            _ => Self::Other,
        }
    }
}

/// The name of a channel of light.
pub(super) fn emissive(nm: f64) -> String {
    format!("S0.{}", comma(nm))
}

/// The name of a channel of reflectance.
pub(super) fn reflective(nm: f64) -> String {
    format!("T.{}", comma(nm))
}

/// The name of a channel of re-radiation.
pub(super) fn bispectral(in_nm: f64, out_nm: f64) -> String {
    format!("T.{}.{}", comma(in_nm), comma(out_nm))
}

/// A wavelength in nm as names have it.
fn comma(nm: f64) -> String {
    format!("{nm:.6}nm").replace('.', ",")
}

/// Units of wavelength and frequency: a prefix and its factor.
const PREFIXES: [(&str, f64); 21] = [
    ("Y", 1e24),
    ("Z", 1e21),
    ("E", 1e18),
    ("P", 1e15),
    ("T", 1e12),
    ("G", 1e9),
    ("M", 1e6),
    ("k", 1e3),
    ("h", 1e2),
    ("da", 1e1),
    ("", 1.0),
    ("d", 1e-1),
    ("c", 1e-2),
    ("m", 1e-3),
    ("u", 1e-6),
    ("n", 1e-9),
    ("p", 1e-12),
    ("f", 1e-15),
    ("a", 1e-18),
    ("z", 1e-21),
    ("y", 1e-24),
];

/// The wavelength in nm of a number with its unit, as `550,0nm` or `545,08THz`.
fn wavelength(text: &str) -> Option<f64> {
    let (text, is_frequency) = match text.strip_suffix("Hz") {
        Some(text) => (text, true),
        None => (text.strip_suffix('m')?, false),
    };
    // An exponent is part of the number, so that the `E` of 1E5nm is not 10^18.
    let end = text.rfind(|c: char| c.is_ascii_digit() || c == ',')? + 1;
    let (number, prefix) = text.split_at(end);
    let (_, factor) = PREFIXES.into_iter().find(|(name, _)| *name == prefix)?;
    if !number.chars().all(|c| c.is_ascii_digit() || ",eE+-".contains(c)) {
        return None;
    }
    let number: f64 = number.replacen(',', ".", 1).parse().ok()?;
    let nm = match (is_frequency, prefix) {
        (true, _) => SPEED_OF_LIGHT * 1e9 / (number * factor),
        (false, "n") => number,
        (false, _) => number * factor * 1e9,
    };
    // All that can be a wavelength of light; and no channel name makes NaN or infinity.
    (nm > 0.0 && nm.is_finite() && frequency_hz(nm).is_finite()).then_some(nm)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_kind_and_wavelengths() {
        for (name, kind) in [
            ("S0.500,000000nm", ChannelKind::Emissive(0, 500.0)),
            ("S3.380,5nm", ChannelKind::Emissive(3, 380.5)),
            ("T.400nm", ChannelKind::Reflective(400.0)),
            ("T.380,000000nm.420,000000nm", ChannelKind::Bispectral(380.0, 420.0)),
            ("T.380nm.380,0nm", ChannelKind::Reflective(380.0)),
            ("T.5,5e2nm", ChannelKind::Reflective(550.0)),
            ("G", ChannelKind::Rgb(1)),
            ("A", ChannelKind::Other),
            ("S4.500nm", ChannelKind::Other),
            ("T.nm", ChannelKind::Other),
            ("T.0nm", ChannelKind::Other),
            ("S0.380nm.420nm", ChannelKind::Other),
            ("T.380nm.420nm.430nm", ChannelKind::Other),
            ("depth.Z", ChannelKind::Other),
        ] {
            assert_eq!(ChannelKind::of(name), kind, "{name}");
        }
    }

    #[test]
    fn other_units_are_converted() {
        let ChannelKind::Reflective(nm) = ChannelKind::of("T.0,55um") else { panic!("no wavelength") };
        assert!((nm - 550.0).abs() < 1e-9);
        let ChannelKind::Emissive(0, nm) = ChannelKind::of("S0.599,584916THz") else {
            panic!("no wavelength")
        };
        assert!((nm - 500.0).abs() < 1e-9);
    }

    #[test]
    fn what_is_written_is_read() {
        assert_eq!(emissive(500.0), "S0.500,000000nm");
        assert_eq!(ChannelKind::of(&bispectral(380.0, 402.5)), ChannelKind::Bispectral(380.0, 402.5));
        assert_eq!(ChannelKind::of(&reflective(785.25)), ChannelKind::Reflective(785.25));
    }
}
