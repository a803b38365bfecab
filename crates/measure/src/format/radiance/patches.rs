//! Klems' patches of the hemisphere: rings of them, the first of each about azimuth 0.

use core::f64::consts::{FRAC_PI_2, TAU};

use glanz_math::Vec3;
use roxmltree::Node;

use super::{at, element, is, words};
use crate::ReadError;

/// A division of the hemisphere.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Patches {
    pub(super) name: String,
    pub(super) rings: Vec<Ring>,
}

/// Patches between two angles from the normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ring {
    /// In radians.
    pub(super) theta: [f64; 2],
    pub(super) count: usize,
}

/// The names of the known divisions, the bounds of their rings in degrees and the numbers of patches.
const KNOWN: [(&str, &[f64], &[usize]); 3] = [
    (
        "LBNL/Klems Full",
        &[0.0, 5.0, 15.0, 25.0, 35.0, 45.0, 55.0, 65.0, 75.0, 90.0],
        &[1, 8, 16, 20, 24, 24, 24, 16, 12],
    ),
    ("LBNL/Klems Half", &[0.0, 6.5, 19.5, 32.5, 46.5, 61.5, 76.5, 90.0], &[1, 8, 12, 16, 20, 12, 4]),
    ("LBNL/Klems Quarter", &[0.0, 9.0, 27.0, 46.0, 66.0, 90.0], &[1, 8, 12, 12, 8]),
];

impl Patches {
    /// The full division, of 145 patches.
    pub(super) fn full() -> Self {
        Self::known("LBNL/Klems Full").expect("the full division is known")
    }

    fn known(name: &str) -> Option<Self> {
        let (name, bounds, counts) = KNOWN.iter().find(|(own, _, _)| own.eq_ignore_ascii_case(name))?;
        let ring = |(pair, count): (&[f64], &usize)| Ring {
            theta: [pair[0].to_radians(), pair[1].to_radians()],
            count: *count,
        };
        Some(Self { name: (*name).to_owned(), rings: bounds.windows(2).zip(*counts).map(ring).collect() })
    }

    /// Those of a name: a known one, or one that the file defines.
    pub(super) fn named(definition: Node, name: &str) -> Result<Self, ReadError> {
        if let Some(known) = Self::known(name) {
            return Ok(known);
        }
        let bases = definition.descendants().filter(|node| is(*node, "AngleBasis"));
        for basis in bases {
            if element(basis, "AngleBasisName").map(words).is_ok_and(|own| own.eq_ignore_ascii_case(name)) {
                return Self::defined(basis, name);
            }
        }
        let known = KNOWN.map(|(name, _, _)| name).join(", ");
        Err(at(definition, format!("the angle basis '{name}' is neither defined nor known; known: {known}")))
    }

    fn defined(basis: Node, name: &str) -> Result<Self, ReadError> {
        let mut rings: Vec<Ring> = Vec::new();
        for block in basis.children().filter(|node| is(*node, "AngleBasisBlock")) {
            let number = |name: &str| {
                let node = element(block, name)?;
                let number = words(node).parse::<f64>().ok().filter(|x| (0.0..=1000.0).contains(x));
                number.ok_or_else(|| at(node, format!("<{name}> must be a number, found '{}'", words(node))))
            };
            let theta = [number("LowerTheta")?.to_radians(), number("UpperTheta")?.to_radians()];
            let count = number("nPhis")? as usize;
            let before = rings.last().map_or(0.0, |ring| ring.theta[1]);
            if theta[0] >= theta[1] || (theta[0] - before).abs() > 1e-6 || count == 0 {
                return Err(at(
                    block,
                    "the rings of an angle basis must follow each other, and have patches",
                ));
            }
            rings.push(Ring { theta, count });
        }
        match rings.is_empty() {
            true => Err(at(basis, format!("the angle basis '{name}' has no rings"))),
            false => Ok(Self { name: name.to_owned(), rings }),
        }
    }

    /// How many patches there are.
    pub(super) fn len(&self) -> usize {
        self.rings.iter().map(|ring| ring.count).sum()
    }

    /// The patch that a direction lies in; nothing beyond the last ring.
    pub(super) fn find(&self, w: Vec3<f64>) -> Option<usize> {
        let theta = libm::atan2(libm::sqrt(w.x * w.x + w.y * w.y), w.z);
        let mut first = 0;
        for ring in &self.rings {
            if theta < ring.theta[1] || ring.theta[1] >= FRAC_PI_2 - 1e-9 {
                let turn = libm::atan2(w.y, w.x) / TAU * ring.count as f64 + 0.5;
                let place = libm::floor(turn).rem_euclid(ring.count as f64) as usize;
                return Some(first + place.min(ring.count - 1));
            }
            first += ring.count;
        }
        None
    }

    /// The ring of a patch, and its number in it.
    fn ring(&self, mut patch: usize) -> (Ring, usize) {
        for ring in &self.rings {
            if patch < ring.count {
                return (*ring, patch);
            }
            patch -= ring.count;
        }
        unreachable!("patches are counted by their rings")
    }

    /// The direction at a place in a patch, both coordinates from 0 to 1, evenly by projected solid angle.
    pub(super) fn direction(&self, patch: usize, [s, t]: [f64; 2]) -> Vec3<f64> {
        let (ring, place) = self.ring(patch);
        let [low, high] = ring.theta.map(|theta| libm::sin(theta) * libm::sin(theta));
        let sin2 = low + (high - low) * s;
        let around = if ring.count == 1 { t } else { (place as f64 + t - 0.5) / ring.count as f64 };
        Vec3::from_angles(libm::asin(libm::sqrt(sin2).min(1.0)), around * TAU)
    }

    /// The direction in the middle of a patch: half way between its angles, the normal for one about it.
    pub(super) fn middle(&self, patch: usize) -> Vec3<f64> {
        let (ring, place) = self.ring(patch);
        if ring.count == 1 && ring.theta[0] == 0.0 {
            return Vec3::from_angles(0.0, 0.0);
        }
        let theta = 0.5 * (ring.theta[0] + ring.theta[1].min(FRAC_PI_2));
        Vec3::from_angles(theta, place as f64 / ring.count as f64 * TAU)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_lie_in_their_patches() {
        for (name, _, _) in KNOWN {
            let patches = Patches::known(name).unwrap();
            assert_eq!(patches.len(), [145, 73, 41][KNOWN.iter().position(|own| own.0 == name).unwrap()]);
            for patch in 0..patches.len() {
                assert_eq!(patches.find(patches.middle(patch)), Some(patch));
                for place in [[0.01, 0.01], [0.99, 0.01], [0.5, 0.99]] {
                    assert_eq!(
                        patches.find(patches.direction(patch, place)),
                        Some(patch),
                        "{name} {place:?}"
                    );
                }
            }
        }
    }
}
