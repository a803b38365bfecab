//! Dominant and complementary wavelength, excitation purity: document 000's hue and saturation.
//!
//! CIE 15:2018, section 9.2, in the CIE 1931 diagram: the ray from the white through the colour meets the
//! border of all colours, the spectral locus closed by the line of purples from 380 to 700 nm.
//!
//! ```
//! use glanz_color::chromaticity::Chromaticity;
//! use glanz_color::dominant::dominant;
//! use glanz_color::light;
//!
//! // The light of a high-pressure sodium lamp has the hue of sodium's line.
//! let sodium = Chromaticity::of_light(&light("HP1")?).expect("it is seen");
//! let found = dominant(sodium, Chromaticity::E).expect("it is not white");
//! assert!((found.nm - 589.0).abs() < 1.0 && found.purity > 0.8);
//! // A magenta has no dominant wavelength; it goes by its complement, a green.
//! let magenta = dominant(Chromaticity::new(0.35, 0.18), Chromaticity::E).expect("it is not white");
//! assert!(magenta.is_purple() && magenta.nm < -500.0);
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

use std::sync::LazyLock;

use crate::measures::chromaticity::Chromaticity;
use crate::observers::cie1931_by_1_nm;

/// The ends of the locus: outside of them the chromaticity of single wavelengths stands nearly still.
const ENDS_NM: [f64; 2] = [380.0, 700.0];

/// Nearer to the white than this there is no hue: the fourth digit, to which whites are known. Sums by 5 nm
/// leave the equal-energy light, whose x and y are 1/3, half of that away from it.
const ACHROMATIC: f64 = 1e-4;

/// How far beyond the border a colour may lie and still be on it: sums by 5 nm put ultraviolet, whose place is
/// the end of the locus at 380 nm, 2e-4 (at 365 nm) to 2e-3 (at 360 nm) beside it. Nothing real is purer than a single
/// wavelength.
const BORDER: f64 = 3e-3;

/// How far beyond the ends of a piece of the border a ray may meet it, as a part of the piece: a ray through the point
/// between two pieces misses both by rounding.
const ROUNDING: f64 = 1e-9;

/// Where a colour lies between the white and the border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dominant {
    /// The dominant wavelength in nm; for purples, which have none, minus the complementary wavelength.
    pub nm: f64,
    /// Excitation purity: 0 at the white, 1 on the border.
    pub purity: f64,
    /// The point of the border.
    pub border: Chromaticity,
}

impl Dominant {
    /// Whether the hue is that of no single wavelength.
    pub fn is_purple(&self) -> bool {
        self.nm < 0.0
    }
}

/// Why there is no dominant wavelength.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DominantError {
    /// The colour is the white.
    #[error("expected a colour that differs from the white, found both at x {x}, y {y}", x = .0.x, y = .0.y)]
    Achromatic(Chromaticity),
    /// No light has the white's chromaticity.
    #[error("expected a white inside of the spectral locus, found x {x}, y {y}", x = .0.x, y = .0.y)]
    WhiteOutside(Chromaticity),
}

/// The dominant wavelength and purity of a colour against a white.
///
/// The locus is that of the functions by 1 nm, straight in between.
///
/// # Errors
///
/// A colour that has the white's chromaticity, or a white outside of the locus.
pub fn dominant(color: Chromaticity, white: Chromaticity) -> Result<Dominant, DominantError> {
    let direction = [color.x - white.x, color.y - white.y];
    let found = along(direction, color, white)?;
    let is_on_border = (1.0..=1.0 + BORDER).contains(&found.purity);
    Ok(Dominant { purity: if is_on_border { 1.0 } else { found.purity }, ..found })
}

/// The same for the hue that makes white with the colour: the other way from the white.
///
/// Its wavelength is the complementary wavelength; for greens, whose complement is purple, it is minus
/// their own dominant wavelength. The purity says how far the colour's mirror image lies.
///
/// # Errors
///
/// As for [`dominant`].
pub fn complementary(color: Chromaticity, white: Chromaticity) -> Result<Dominant, DominantError> {
    let direction = [white.x - color.x, white.y - color.y];
    along(direction, color, white)
}

fn along(direction: [f64; 2], color: Chromaticity, white: Chromaticity) -> Result<Dominant, DominantError> {
    let distance = libm::hypot(direction[0], direction[1]);
    let finite = color.x.is_finite() && color.y.is_finite();
    if distance <= ACHROMATIC || !finite {
        return Err(DominantError::Achromatic(color));
    }
    let ray = |sign: f64| meet(white, direction.map(|d| sign * d / distance));
    let (ahead, behind) = ray(1.0).zip(ray(-1.0)).ok_or(DominantError::WhiteOutside(white))?;
    let border = Chromaticity::new(
        white.x + ahead.distance * direction[0] / distance,
        white.y + ahead.distance * direction[1] / distance,
    );
    let is_pure = distance / ahead.distance > 1.0 - BORDER;
    let nm = match (ahead.nm, behind.nm) {
        (Some(nm), _) => nm,
        (None, _) if is_pure && end_at(border).is_some() => end_at(border).unwrap_or_default(),
        (None, Some(nm)) => -nm,
        // The purples are one straight line: no ray from inside meets it both ways.
        (None, None) => return Err(DominantError::WhiteOutside(white)),
    };
    Ok(Dominant { nm, purity: distance / ahead.distance, border })
}

/// The end of the locus that a point of the purples is, to within the errors of sums by 5 nm.
fn end_at(border: Chromaticity) -> Option<f64> {
    let near = |end: &Chromaticity| libm::hypot(end.x - border.x, end.y - border.y) < BORDER;
    let ends = [locus().first(), locus().last()].into_iter().zip(ENDS_NM);
    ends.filter_map(|(end, nm)| end.filter(|end| near(end)).map(|_| nm)).next()
}

/// Where a ray meets the border: at which wavelength, or none on the purples.
struct Meeting {
    distance: f64,
    nm: Option<f64>,
}

/// The farthest meeting of the ray with the border.
fn meet(from: Chromaticity, direction: [f64; 2]) -> Option<Meeting> {
    let locus = locus();
    let count = locus.len();
    let meetings = (0..count).filter_map(|i| {
        let (start, end) = (locus[i], locus[(i + 1) % count]);
        let (distance, part) = cross(from, direction, start, end)?;
        let nm = (i + 1 < count).then_some(ENDS_NM[0] + i as f64 + part);
        Some(Meeting { distance, nm })
    });
    meetings.max_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// How far along the ray, and at which part of the piece from `start` to `end`, they meet.
fn cross(
    from: Chromaticity,
    direction: [f64; 2],
    start: Chromaticity,
    end: Chromaticity,
) -> Option<(f64, f64)> {
    let piece = [end.x - start.x, end.y - start.y];
    let to = [start.x - from.x, start.y - from.y];
    let by = direction[0] * piece[1] - direction[1] * piece[0];
    let distance = (to[0] * piece[1] - to[1] * piece[0]) / by;
    let part = (to[0] * direction[1] - to[1] * direction[0]) / by;
    // Parallel lines give infinities and NaN, which lie in no range.
    let meets = (-ROUNDING..=1.0 + ROUNDING).contains(&part);
    (distance > 0.0 && distance.is_finite() && meets).then_some((distance, part.clamp(0.0, 1.0)))
}

/// The chromaticities of single wavelengths, from 380 to 700 nm by 1 nm.
pub fn locus() -> &'static [Chromaticity] {
    static LOCUS: LazyLock<Vec<Chromaticity>> = LazyLock::new(|| {
        let seen = cie1931_by_1_nm().iter().filter(|(nm, _)| (ENDS_NM[0]..=ENDS_NM[1]).contains(nm));
        seen.map(|(_, xyz)| Chromaticity::of_xyz(*xyz).expect("380 to 700 nm are seen")).collect()
    });
    &LOCUS
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const D65: Chromaticity = Chromaticity::new(0.3127, 0.3290);

    /// x, y, dominant wavelength and purity against D65 by colour-science 0.4.7, `dominant_wavelength`
    /// (which gives the nearest whole nm) and `excitation_purity`.
    const KNOWN: [(f64, f64, f64, f64); 10] = [
        (0.4, 0.4, 580.0, 0.442_96),
        (0.25, 0.25, 474.0, 0.314_94),
        (0.543_695_57, 0.321_079_44, 616.0, 0.622_89),
        (0.28, 0.6, 545.0, 0.684_23),
        (0.35, 0.2, -533.0, 0.563_02),
        (0.2, 0.1, 448.0, 0.731_53),
        (0.6, 0.35, 604.0, 0.861_38),
        (0.15, 0.06, 464.0, 0.924_92),
        (0.30, 0.60, 549.0, 0.734_48),
        (0.64, 0.33, 611.0, 0.916_79),
    ];

    #[test]
    fn colours_have_the_dominant_wavelengths_of_colour_science() {
        for (x, y, nm, purity) in KNOWN {
            let found = dominant(Chromaticity::new(x, y), D65).unwrap();
            assert!((found.nm - nm).abs() < 0.6, "{x} {y}: {found:?}, not {nm}");
            assert!((found.purity - purity).abs() < 2e-3, "{x} {y}: {found:?}, not {purity}");
        }
    }

    #[test]
    fn the_complement_of_the_complement_is_the_colour() {
        let orange = Chromaticity::new(0.5, 0.42);
        let there = complementary(orange, D65).unwrap();
        let back = complementary(there.border, D65).unwrap();
        assert!((back.nm - dominant(orange, D65).unwrap().nm).abs() < 1e-9);
        let green = Chromaticity::new(0.28, 0.6);
        assert_eq!(complementary(green, D65).unwrap().nm, -dominant(green, D65).unwrap().nm);
    }

    #[test]
    fn white_has_no_hue_and_a_white_outside_is_refused() {
        assert_eq!(dominant(D65, D65), Err(DominantError::Achromatic(D65)));
        let outside = Chromaticity::new(0.1, 0.1);
        assert_eq!(dominant(D65, outside), Err(DominantError::WhiteOutside(outside)));
    }

    #[test]
    fn equal_energy_has_no_hue_and_ultraviolet_is_not_purer_than_pure() {
        let of = |name: &str| Chromaticity::of_light(&crate::light(name).unwrap()).unwrap();
        assert!(matches!(dominant(of("E"), Chromaticity::E), Err(DominantError::Achromatic(_))));
        assert_eq!(dominant(of("UV365"), Chromaticity::E).unwrap().purity, 1.0);
    }

    #[test]
    fn every_point_of_the_locus_has_its_wavelength_and_is_pure() {
        for white in [Chromaticity::E, D65] {
            for (index, point) in locus().iter().enumerate() {
                let nm = ENDS_NM[0] + index as f64;
                let found = dominant(*point, white).unwrap();
                // From 699 nm on nothing moves, and at the violet end hardly anything.
                let exact = if (390.0..=695.0).contains(&nm) { 1e-6 } else { 5.0 };
                assert!((found.nm - nm).abs() <= exact, "{nm}: {found:?}");
                assert!((found.purity - 1.0).abs() < 1e-9, "{nm}: {found:?}");
            }
        }
    }

    #[test]
    fn lines_at_the_ends_of_the_band_are_not_purple() {
        let of = |nm: f64| {
            dominant(
                Chromaticity::of_light(&crate::light(&format!("line({nm})")).unwrap()).unwrap(),
                Chromaticity::E,
            )
        };
        for (nm, expected) in [(695.0, 695.0), (700.0, 700.0), (780.0, 700.0), (360.0, 380.0), (380.0, 380.0)]
        {
            let found = of(nm).unwrap();
            assert!((found.nm - expected).abs() < 1.5, "{nm}: {found:?}");
            assert!((found.purity - 1.0).abs() < 1e-9, "{nm}: {found:?}");
        }
        // Between the ends there is purple, right beside them too.
        let [first, last] = [locus()[0], locus()[locus().len() - 1]];
        let beside =
            Chromaticity::new(last.x + 0.02 * (first.x - last.x), last.y + 0.02 * (first.y - last.y));
        assert!(dominant(beside, Chromaticity::E).unwrap().is_purple());
    }

    proptest! {
        #[test]
        fn mixing_a_wavelength_with_white_keeps_its_wavelength(nm in 385.0..695.0_f64, purity in 0.05..0.95_f64) {
            let after = nm as usize - 380;
            let part = nm - libm::floor(nm);
            let [a, b] = [locus()[after], locus()[after + 1]];
            let pure = Chromaticity::new(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
            let at = |a: f64, b: f64| a + purity * (b - a);
            let found = dominant(Chromaticity::new(at(D65.x, pure.x), at(D65.y, pure.y)), D65);
            let found = found.expect("a colour inside of the locus");
            // At the ends a nanometre moves the point by 1e-5 only.
            prop_assert!((found.nm - nm).abs() < 1e-6, "{found:?} is not {nm}");
            prop_assert!((found.purity - purity).abs() < 1e-9);
        }
    }
}
