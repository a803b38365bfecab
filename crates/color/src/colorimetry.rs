//! What a colour engineer says of light that reaches an eye.

use glanz_color::adaptation::Adaptation;
use glanz_color::chromaticity::Chromaticity;
use glanz_color::dominant::{Dominant, complementary, dominant};
use glanz_color::models::{ColorModel, D65_XYZ, Lab, LinearSrgb, Srgb, Xyz};
use glanz_color::{Observer, ObserverKind, Spectrum};
use serde_json::{Value, json};

/// How far a code value of sRGB may lie outside of 0 … 1 and still count as inside: an eighth of a step of
/// 8 bits, below what digits of chromaticities leave open.
const GAMUT_TOLERANCE: f64 = 0.000_5;

/// XYZ of light for an observer, relative to a white whose Y is 1.
pub fn relative_xyz(light: &Spectrum, white: &Spectrum, observer: &Observer) -> Option<[f64; 3]> {
    let (color, white) = (observer.response(light), observer.response(white));
    let ([x, y, z], [_, y_white, _]) = (color.as_slice(), white.as_slice()) else { return None };
    let xyz = [x / y_white, y / y_white, z / y_white];
    (observer.kind == ObserverKind::Xyz && xyz.iter().all(|v| v.is_finite())).then_some(xyz)
}

/// CIELAB relative to any white: it depends on nothing but the ratios to it.
pub fn lab(xyz: [f64; 3], white: [f64; 3]) -> Lab {
    Lab::from_xyz(Xyz(core::array::from_fn(|i| xyz[i] / white[i] * D65_XYZ[i])))
}

/// A colour on a screen whose white is D65.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// sRGB code values, not clipped.
    pub srgb: [f64; 3],
}

impl Screen {
    /// The colour as an eye adapted to `white` sees it, by Bradford; none for whites without one of the cones'
    /// signals.
    pub fn adapted(xyz: [f64; 3], white: [f64; 3]) -> Option<Self> {
        let matrix = Adaptation::Bradford.matrix(Xyz(white), Xyz(D65_XYZ)).ok()?;
        Some(Self { srgb: Srgb::from_xyz(Xyz(matrix.apply(xyz))).0 })
    }

    /// The colour of a light, as bright as the screen can show it, for an eye adapted to D65.
    pub fn of_light(xyz: [f64; 3]) -> Self {
        let LinearSrgb(rgb) = LinearSrgb::from_xyz(Xyz(xyz));
        let most = rgb.into_iter().fold(f64::MIN_POSITIVE, f64::max);
        Self { srgb: LinearSrgb(rgb.map(|c| c / most)).to::<Srgb>().0 }
    }

    /// Whether the screen can show it.
    pub fn is_in_gamut(self) -> bool {
        self.srgb.iter().all(|c| (-GAMUT_TOLERANCE..=1.0 + GAMUT_TOLERANCE).contains(c))
    }

    /// The code in 8 bits, clipped: `#rrggbb`.
    pub fn hex(self) -> String {
        let [r, g, b] = self.srgb.map(|c| (255.0 * c).round().clamp(0.0, 255.0) as u8);
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

/// Hue and saturation in the diagram of CIE 1931; none for what has the white's colour, or none.
pub fn hue(color: &Spectrum, white: Chromaticity) -> Option<(Dominant, Option<Dominant>)> {
    let xy = Chromaticity::of_light(color)?;
    Some((dominant(xy, white).ok()?, complementary(xy, white).ok()))
}

/// A dominant wavelength in words: `580.2 nm`, or `purple, complement of 520.1 nm`.
pub fn wavelength(dominant: &Dominant) -> String {
    match dominant.is_purple() {
        true => format!("purple, complement of {:.1} nm", -dominant.nm),
        false => format!("{:.1} nm", dominant.nm),
    }
}

/// A number, or null where there is none.
pub fn finite(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}

/// Numbers with so many decimals each, between blanks.
pub fn decimals(values: &[f64], decimals: usize) -> String {
    let texts: Vec<_> = values.iter().map(|value| fixed(*value, decimals)).collect();
    texts.join(" ")
}

/// A number with so many decimals; one that would need very many digits in powers of ten. No minus before 0.
pub fn fixed(value: f64, decimals: usize) -> String {
    if value.abs() >= 1e7 {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glanz_color::light;

    #[test]
    fn the_white_is_white_under_any_light() {
        let a = light("A").unwrap();
        let xyz = relative_xyz(&a, &a, &Observer::default()).unwrap();
        let Lab([l, a_star, b_star]) = lab(xyz, xyz);
        assert!((l - 100.0).abs() < 1e-9 && a_star.abs() < 1e-9 && b_star.abs() < 1e-9);
        let screen = Screen::adapted(xyz, xyz).unwrap();
        assert!(screen.is_in_gamut());
        assert_eq!(screen.hex(), "#ffffff");
    }

    #[test]
    fn numbers_have_no_minus_before_nothing() {
        assert_eq!(decimals(&[-0.000_01, 1.25, -3.0], 2), "0.00 1.25 -3.00");
        assert_eq!(fixed(2.5e9, 4), "2.500e9");
    }
}
