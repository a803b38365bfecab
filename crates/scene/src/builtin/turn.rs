//! Sines and cosines of fractions of a turn.

use core::f64::consts::TAU;

/// Sine and cosine of `part / whole` of a turn.
///
/// The angle is brought into the first eighth by whole numbers, so that quarters are exact, mirrored
/// points are mirrored to the last bit, and `part` and `part + whole` give the same bits.
pub(super) fn sin_cos_turn(part: u32, whole: u32) -> (f64, f64) {
    let (part, whole) = (u64::from(part % whole), u64::from(whole));
    // In units of an eighth of a turn: `eighth` whole ones, and `rest / whole` of the next.
    let (eighth, rest) = (8 * part / whole, 8 * part % whole);
    let odd = eighth % 2 == 1;
    let folded = if odd { whole - rest } else { rest };
    let (sin, cos) = libm::sincos(TAU * folded as f64 / (8 * whole) as f64);
    let (sin, cos) = if odd { (cos, sin) } else { (sin, cos) };
    match eighth / 2 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::sin_cos_turn;

    #[test]
    fn quarters_are_exact() {
        let quarters = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0)];
        for (i, expected) in quarters.into_iter().enumerate() {
            assert_eq!(sin_cos_turn(3 * i as u32, 12), expected);
        }
    }

    #[test]
    fn agrees_with_the_library_at_every_degree() {
        for degree in 0..720 {
            let angle = f64::from(degree).to_radians();
            let (sin, cos) = sin_cos_turn(degree, 360);
            // The argument of the library function is rounded to about 1e-15 at 4 pi.
            assert!((sin - libm::sin(angle)).abs() < 4e-15, "{degree}");
            assert!((cos - libm::cos(angle)).abs() < 4e-15, "{degree}");
        }
    }

    #[test]
    fn mirrored_angles_have_mirrored_bits() {
        for part in 0..97 {
            let (sin, cos) = sin_cos_turn(part, 97);
            assert_eq!(sin_cos_turn(97 - part, 97), (-sin, cos));
        }
    }
}
