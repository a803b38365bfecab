//! Whiteness and tint of whites, CIE 15:2004.
//!
//! ```
//! use glanz_color::whiteness::{Field, whiteness};
//!
//! let d65 = [0.95047, 1.0, 1.08883];
//! let white = whiteness(d65, d65, Field::Two).expect("the perfect diffuser has a colour");
//! assert_eq!((white.whiteness, white.tint), (100.0, 0.0));
//! ```

use crate::measures::chromaticity::Chromaticity;
use crate::observers::Observer;

/// The field of view of an observer, on which the tint depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// 2°.
    Two,
    /// 10°.
    Ten,
}

impl Field {
    /// That of an observer that comes with the crate; none for others, and for those without X, Y and Z.
    ///
    /// ```
    /// use glanz_color::observer;
    /// use glanz_color::whiteness::Field;
    ///
    /// assert_eq!(Field::of(&observer("cie1964")?), Some(Field::Ten));
    /// assert_eq!(Field::of(&observer("photopic")?), None);
    /// # Ok::<_, glanz_color::UnknownName>(())
    /// ```
    pub fn of(observer: &Observer) -> Option<Self> {
        match observer.name.as_str() {
            "cie1931" | "cie2015-2" => Some(Self::Two),
            "cie1964" | "cie2015-10" => Some(Self::Ten),
            _ => None,
        }
    }
}

/// Whiteness and tint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whiteness {
    /// W, 100 for the perfect diffuser; more for papers and textiles with brightener.
    pub whiteness: f64,
    /// T: positive is greenish, negative reddish, 0 the perfect diffuser.
    pub tint: f64,
    /// Whether W is above 40 and below 5Y − 280, and T from −4 to 2: limits beyond which the CIE calls samples no whites. They
    /// are quoted after memory and not verified against the publication.
    pub is_valid: bool,
}

/// W = Y + 800 (xn − x) + 1700 (yn − y) and T = 1000 (xn − x) − 650 (yn − y), 900 in place of 1000 for 10°; X, Y, Z of a surface and
/// of the perfect diffuser, whose Y is 1, under the same light. None where one of them has no chromaticity.
///
/// The CIE defines it for D65; other lights compare samples only among each other.
pub fn whiteness(xyz: [f64; 3], white: [f64; 3], field: Field) -> Option<Whiteness> {
    let (color, diffuser) = (Chromaticity::of_xyz(xyz)?, Chromaticity::of_xyz(white)?);
    let (dx, dy) = (diffuser.x - color.x, diffuser.y - color.y);
    let y = 100.0 * xyz[1] / white[1];
    let whiteness = y + 800.0 * dx + 1700.0 * dy;
    let by_x = match field {
        Field::Two => 1000.0,
        Field::Ten => 900.0,
    };
    let tint = by_x * dx - 650.0 * dy;
    let is_valid = whiteness > 40.0 && whiteness < 5.0 * y - 280.0 && (-4.0..=2.0).contains(&tint);
    Some(Whiteness { whiteness, tint, is_valid })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_white_has_the_numbers_of_colour_science() {
        // colour-science 0.4.7, whiteness_CIE2004: the white is that of D65 for 10°.
        let white = Chromaticity::new(0.3139, 0.3311).xyz();
        let color = Chromaticity::new(0.3167, 0.3334).xyz();
        let found = whiteness(color, white, Field::Two).unwrap();
        assert!((found.whiteness - 93.85).abs() < 1e-9 && (found.tint + 1.305).abs() < 1e-9, "{found:?}");
        assert!(found.is_valid);
    }

    #[test]
    fn a_wider_field_weighs_x_less() {
        let (white, color) = (Chromaticity::new(0.313, 0.329).xyz(), Chromaticity::new(0.303, 0.329).xyz());
        let [two, ten] = [Field::Two, Field::Ten].map(|field| whiteness(color, white, field).unwrap());
        assert!((two.tint - 10.0).abs() < 1e-9 && (ten.tint - 9.0).abs() < 1e-9);
        assert!((two.whiteness - 108.0).abs() < 1e-9 && !two.is_valid);
        assert_eq!(whiteness([0.0; 3], white, Field::Two), None);
    }
}
