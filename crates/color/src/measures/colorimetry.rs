//! Colorimetry of a stimulus: relative XYZ, CIELAB for any white, display codes, dominant wavelength, metamerism.
//!
//! ```
//! use glanz_color::colorimetry::{DisplayColor, lab, relative_xyz};
//! use glanz_color::{Observer, light};
//!
//! let (observer, a) = (Observer::default(), light("A")?);
//! let gold = glanz_color::ior("gold")?.normal_reflectance();
//! let white = relative_xyz(&a, &a, &observer).expect("A is visible");
//! let xyz = relative_xyz(&(gold * a), &a, &observer).expect("A is visible");
//! assert!(lab(xyz, white).0[2] > 20.0, "gold is yellow");
//! let code = DisplayColor::adapted(xyz, white).expect("A has a signal in all cones").hex();
//! assert_eq!(code.len(), 7);
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

use crate::measures::adaptation::Adaptation;
use crate::measures::chromaticity::Chromaticity;
use crate::measures::difference::{cie76, ciede2000};
use crate::measures::dominant::{Dominant, complementary, dominant};
use crate::models::{ColorModel, D65_XYZ, Lab, LinearSrgb, Srgb, Xyz};
use crate::observers::{Observer, ObserverKind};
use crate::spectra::Sampled;

/// How far a code value of sRGB may lie outside of 0 … 1 and still count as inside: an eighth of a step of
/// 8 bits, below what digits of chromaticities leave open.
const GAMUT_TOLERANCE: f64 = 0.000_5;

/// XYZ of light for an observer, relative to a white whose Y is 1; none for an observer without X, Y, Z and for a
/// white that it does not see.
pub fn relative_xyz<S: Sampled>(light: &S, white: &S, observer: &Observer) -> Option<[f64; 3]> {
    let (color, white) = (light.responses(observer), white.responses(observer));
    let ([x, y, z], [_, y_white, _]) = (color.as_slice(), white.as_slice()) else { return None };
    let xyz = [x / y_white, y / y_white, z / y_white];
    (observer.kind == ObserverKind::Xyz && xyz.iter().all(|v| v.is_finite())).then_some(xyz)
}

/// CIELAB relative to any white; see [`Lab::for_white`].
pub fn lab(xyz: [f64; 3], white: [f64; 3]) -> Lab {
    Lab::for_white(Xyz(xyz), Xyz(white))
}

/// A colour on an sRGB display, whose white is D65.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayColor {
    /// sRGB code values, not clipped.
    pub srgb: [f64; 3],
}

impl DisplayColor {
    /// The corresponding colour of a stimulus under `white`, adapted to D65 by Bradford; none for whites without
    /// one of the cones' signals.
    pub fn adapted(xyz: [f64; 3], white: [f64; 3]) -> Option<Self> {
        let matrix = Adaptation::Bradford.matrix(Xyz(white), Xyz(D65_XYZ)).ok()?;
        Some(Self { srgb: Srgb::from_xyz(Xyz(matrix.apply(xyz))).0 })
    }

    /// The colour of a light, as bright as the display can show it, for an observer adapted to D65.
    pub fn of_light(xyz: [f64; 3]) -> Self {
        let LinearSrgb(rgb) = LinearSrgb::from_xyz(Xyz(xyz));
        let most = rgb.into_iter().fold(f64::MIN_POSITIVE, f64::max);
        Self { srgb: LinearSrgb(rgb.map(|c| c / most)).to::<Srgb>().0 }
    }

    /// Whether it is within the gamut.
    pub fn is_in_gamut(self) -> bool {
        self.srgb.iter().all(|c| (-GAMUT_TOLERANCE..=1.0 + GAMUT_TOLERANCE).contains(c))
    }

    /// The code in 8 bits, clipped: `#rrggbb`.
    pub fn hex(self) -> String {
        let [r, g, b] = self.srgb.map(|c| (255.0 * c).round().clamp(0.0, 255.0) as u8);
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

/// The dominant and the complementary wavelength in the diagram of CIE 1931; none for a stimulus with the white's
/// chromaticity, or with none.
pub fn dominant_wavelength<S: Sampled>(
    color: &S,
    white: Chromaticity,
) -> Option<(Dominant, Option<Dominant>)> {
    let xy = Chromaticity::of_light(color)?;
    Some((dominant(xy, white).ok()?, complementary(xy, white).ok()))
}

/// How far two surfaces are apart under one light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairDifference {
    /// ΔE00.
    pub de2000: f64,
    /// ΔE*ab (CIE 1976).
    pub de76: f64,
}

impl PairDifference {
    /// The difference of two stimuli for a white.
    pub fn between([first, second]: [[f64; 3]; 2], white: [f64; 3]) -> Self {
        let (first, second) = (lab(first, white), lab(second, white));
        Self { de2000: ciede2000(first, second), de76: cie76(first, second) }
    }
}

/// The special metamerism index, change of illuminant (CIE 15:2018, 9.2.2): the difference of a pair of surfaces
/// under another light than the `reference`. `pair` and `white` are under the other light.
///
/// If the pair does not match under the reference, X, Y and Z of the second surface are first multiplied by X1/X2,
/// Y1/Y2 and Z1/Z2 of the reference. None for a second surface that is black there: it cannot be brought to match.
pub fn metamerism_index(
    [first, second]: [[f64; 3]; 2],
    white: [f64; 3],
    [first_reference, second_reference]: [[f64; 3]; 2],
) -> Option<PairDifference> {
    let corrected: [f64; 3] = core::array::from_fn(|i| second[i] * first_reference[i] / second_reference[i]);
    let possible = corrected.iter().all(|v| v.is_finite());
    possible.then(|| PairDifference::between([first, corrected], white))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;

    #[test]
    fn the_white_is_white_under_any_light() {
        let a = light("A").unwrap();
        let xyz = relative_xyz(&a, &a, &Observer::default()).unwrap();
        let Lab([l, a_star, b_star]) = lab(xyz, xyz);
        assert!((l - 100.0).abs() < 1e-9 && a_star.abs() < 1e-9 && b_star.abs() < 1e-9);
        let color = DisplayColor::adapted(xyz, xyz).unwrap();
        assert!(color.is_in_gamut());
        assert_eq!(color.hex(), "#ffffff");
    }

    #[test]
    fn a_pair_that_differs_alike_under_both_lights_has_no_metamerism() {
        let (first, second) = ([0.2, 0.2, 0.2], [0.1, 0.1, 0.1]);
        let white = [0.95, 1.0, 1.09];
        let index = metamerism_index([first, second], white, [first, second]).unwrap();
        assert!(index.de76 < 1e-12 && index.de2000 < 1e-9, "{index:?}");
        assert!(PairDifference::between([first, second], white).de76 > 5.0);
        assert_eq!(metamerism_index([first, second], white, [first, [0.0; 3]]), None);
    }
}
