//! Points of the unit square that are spread evenly, the same ones in every picture.

use glanz_math::PI;

/// A point of the unit square, and the direction that its first coordinate is of a whole turn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SquarePoint {
    pub u: f64,
    pub v: f64,
    /// Cosine and sine of 2π u.
    pub turn: [f64; 2],
}

/// Which points of a set are taken: two halves of a set are as even as the whole, and their difference tells how far it
/// is from the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    Whole,
    Half(u32),
}

/// Sets that know nothing of each other.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Purpose {
    Light,
    Hemisphere,
    Lobe,
}

/// So many points of Sobol's first two dimensions, whose blocks of 2ⁿ points are stratified in every way that 2ⁿ
/// cells of equal area allow (I. M. Sobol, 1967; a (0, 2)-sequence), displaced for each purpose.
pub(crate) fn spread(count: usize, part: Part, purpose: Purpose) -> Vec<SquarePoint> {
    let (first, count) = match part {
        Part::Whole => (0, count),
        Part::Half(number) => (number * (count / 2) as u32, count / 2),
    };
    // Any bits: a set that is displaced by exclusive or stays as even as it was.
    let [x, y] = match purpose {
        Purpose::Light => [0x5bd1_e995, 0x2545_f491],
        Purpose::Hemisphere => [0x9e37_79b9, 0x85eb_ca6b],
        Purpose::Lobe => [0xc2b2_ae35, 0x27d4_eb2f],
    };
    let unit = |bits: u32| (f64::from(bits) + 0.5) / 4_294_967_296.0;
    let point = |i: u32| {
        let (u, v) = (unit(i.reverse_bits() ^ x), unit(second_dimension(i) ^ y));
        let (sin, cos) = libm::sincos(2.0 * PI * u);
        SquarePoint { u, v, turn: [cos, sin] }
    };
    (first..first + count as u32).map(point).collect()
}

/// The bits of a number in the second dimension: its direction numbers follow from the polynomial x + 1.
fn second_dimension(mut number: u32) -> u32 {
    let (mut bits, mut direction) = (0, 1 << 31);
    while number != 0 {
        if number & 1 == 1 {
            bits ^= direction;
        }
        direction ^= direction >> 1;
        number >>= 1;
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_stratified_in_all_ways() {
        for (part, count) in [(Part::Whole, 256), (Part::Half(0), 512), (Part::Half(1), 512)] {
            let points = spread(count, part, Purpose::Lobe);
            for columns in [1, 2, 4, 8, 16, 32, 64, 128, 256] {
                let rows = 256 / columns;
                let mut found = vec![0; 256];
                for point in &points {
                    let cell = |at: f64, count: usize| (at * count as f64) as usize;
                    found[cell(point.v, rows) * columns + cell(point.u, columns)] += 1;
                }
                assert!(found.iter().all(|count| *count == 1), "{part:?}, {columns} columns");
            }
        }
    }
}
