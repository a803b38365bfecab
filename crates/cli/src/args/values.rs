//! Values of options, from text.

use glanz_color::{Rgb, srgb_decode_u8};
use glanz_scene::{AnotherScale, Background};

/// The widest and highest picture, in pixels.
const MAX_SIZE: u32 = 16_384;

/// `WxH` in pixels.
pub(crate) fn size(text: &str) -> Result<(u32, u32), String> {
    let (width, height) = text.split_once(['x', '×']).ok_or("expected WIDTHxHEIGHT, such as 800x600")?;
    let side = |name: &str, text: &str| match text.trim().parse::<u64>() {
        Ok(value) if (1..=u64::from(MAX_SIZE)).contains(&value) => Ok(value as u32),
        Ok(_) => Err(format!("the {name} must be between 1 and {MAX_SIZE} pixels")),
        Err(_) => Err(format!("the {name} must be a whole number of pixels, such as 800x600")),
    };
    Ok((side("width", width)?, side("height", height)?))
}

/// `x,y,z`, finite.
pub(super) fn triple(text: &str) -> Result<[f64; 3], String> {
    let values = numbers(text)?;
    values
        .try_into()
        .map_err(|values: Vec<f64>| format!("expected three numbers x,y,z, found {}", values.len()))
}

/// Two angles in degrees: from the normal, and around it.
pub(crate) fn angles(text: &str) -> Result<[f64; 2], String> {
    let [theta, phi]: [f64; 2] = numbers(text)?
        .try_into()
        .map_err(|values: Vec<f64>| format!("expected two angles theta,phi, found {}", values.len()))?;
    if !(0.0..=180.0).contains(&theta) {
        return Err(format!("theta is the angle from the normal, 0 to 180 degrees, not {theta}"));
    }
    Ok([theta, phi])
}

/// Finite numbers between commas.
pub(crate) fn numbers(text: &str) -> Result<Vec<f64>, String> {
    let number = |part: &str| match part.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("'{}' is not a finite number", part.trim())),
    };
    text.split(',').map(number).collect()
}

/// `PATH=VALUE`.
pub(crate) fn assignment(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((path, value)) if !path.trim().is_empty() => {
            Ok((path.trim().to_owned(), value.trim().to_owned()))
        }
        _ => Err("expected PATH=VALUE, such as materials.red.shininess=64".to_owned()),
    }
}

/// `transparent`, `#rrggbb` (sRGB codes), or linear `r,g,b`.
pub(crate) fn background(text: &str) -> Result<Background, String> {
    const EXPECTED: &str = "expected #rrggbb, linear r,g,b, or transparent";
    if text == "transparent" {
        return Ok(Background::Transparent);
    }
    if let Some(hex) = text.strip_prefix('#') {
        let code = u32::from_str_radix(hex, 16).ok().filter(|_| hex.len() == 6).ok_or(EXPECTED)?;
        let [_, r, g, b] = code.to_be_bytes();
        return Ok(Background::Color(Rgb([r, g, b].map(srgb_decode_u8))));
    }
    let color = triple(text).map_err(|_| EXPECTED)?;
    if color.iter().any(|c| !(0.0..=1e6).contains(c)) {
        return Err("the colours of the background must not be negative".to_owned());
    }
    let color = Rgb(color.map(|c| c as f32));
    AnotherScale::check(color).map_err(|error| format!("{error}; {}", error.help()))?;
    Ok(Background::Color(color))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_two_whole_numbers_in_range() {
        assert_eq!(size("800x600"), Ok((800, 600)));
        assert_eq!(size("16384×1"), Ok((16_384, 1)));
        for wrong in ["", "800", "0x1", "1x0", "16385x1", "1e3x1", "-1x1", "1000000000x1000000000"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_background_is_codes_or_linear_or_nothing() {
        assert_eq!(background("transparent"), Ok(Background::Transparent));
        assert_eq!(background("#ffffff"), Ok(Background::Color(Rgb::WHITE)));
        assert_eq!(background("0.5,0,1"), Ok(Background::Color(Rgb([0.5, 0.0, 1.0]))));
        for wrong in ["white", "#fff", "#12345g", "#1234567", "1,2", "-1,0,0", "nan,0,0", "255,128,0"] {
            assert!(background(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn an_assignment_keeps_what_follows_the_first_equals_sign() {
        assert_eq!(assignment("a.b = x=1"), Ok(("a.b".to_owned(), "x=1".to_owned())));
        assert!(assignment("a.b").is_err() && assignment("=1").is_err());
    }
}
