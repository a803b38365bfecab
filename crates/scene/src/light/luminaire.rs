//! Luminaires: how much light goes into which direction.
//!
//! Directions are those of CIE 121-1996 and type C of ANSI/IES LM-63: γ is the angle from the luminaire's
//! axis (which points down in a ceiling), and C turns about it. C 90° lies along a lamp tube, C 0° across.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

/// Luminous intensity over the directions of a luminaire, expanded to full symmetry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// The half planes C in degrees, increasing, from 0 to 360; the last is the first again. A single 0 for
    /// intensity that is the same all around.
    pub c_deg: Vec<f64>,
    /// The angles γ in degrees, increasing, within 0 to 180. Nothing is sent beyond them.
    pub gamma_deg: Vec<f64>,
    /// Intensity in cd, by half planes: that of C `i` and γ `j` is at `i * gamma_deg.len() + j`. All are
    /// finite and at least 0.
    pub candela: Vec<f64>,
}

impl Profile {
    /// The intensity in cd, linear between the angles. C may be any angle; beyond the range of γ it is 0.
    pub fn at(&self, c_deg: f64, gamma_deg: f64) -> f64 {
        let (first, last) = (self.gamma_deg[0], self.gamma_deg[self.gamma_deg.len() - 1]);
        if !(first..=last).contains(&gamma_deg) {
            return 0.0;
        }
        let (row, down) = bracket(&self.gamma_deg, gamma_deg);
        let (plane, across) = bracket(&self.c_deg, c_deg.rem_euclid(360.0));
        let along = |plane: usize| {
            let values = &self.candela[plane * self.gamma_deg.len()..];
            blend(values[row], values[(row + 1).min(self.gamma_deg.len() - 1)], down)
        };
        blend(along(plane), along((plane + 1).min(self.c_deg.len() - 1)), across)
    }

    /// The greatest intensity in cd.
    pub fn max(&self) -> f64 {
        self.candela.iter().copied().fold(0.0, f64::max)
    }

    /// The luminous flux in lm: the integral over all directions, by the trapezium rule over C and exact
    /// for what is linear in γ times its sine.
    pub fn flux_lm(&self) -> f64 {
        let count = self.gamma_deg.len();
        let ring = |plane: usize| -> f64 {
            let values = &self.candela[plane * count..][..count];
            let cells = self.gamma_deg.windows(2).zip(values.windows(2));
            cells.map(|(gamma, value)| cell([gamma[0], gamma[1]], [value[0], value[1]])).sum()
        };
        if self.c_deg.len() == 1 {
            return 2.0 * core::f64::consts::PI * ring(0);
        }
        let turns = self.c_deg.windows(2).enumerate();
        turns.map(|(i, c)| (c[1] - c[0]).to_radians() * 0.5 * (ring(i) + ring(i + 1))).sum()
    }
}

/// ∫ I(γ) sin γ dγ for I linear between two angles.
fn cell(gamma_deg: [f64; 2], value: [f64; 2]) -> f64 {
    let [a, b] = gamma_deg.map(f64::to_radians);
    let slope = (value[1] - value[0]) / (b - a);
    let whole = |gamma: f64, value: f64| slope * libm::sin(gamma) - value * libm::cos(gamma);
    whole(b, value[1]) - whole(a, value[0])
}

/// The last of the increasing angles that is not above `angle`, and how far it is to the next, 0 to 1.
fn bracket(angles: &[f64], angle: f64) -> (usize, f64) {
    let index = angles.partition_point(|known| *known <= angle).saturating_sub(1);
    match angles.get(index + 1) {
        Some(next) => (index, ((angle - angles[index]) / (next - angles[index])).clamp(0.0, 1.0)),
        None => (index, 0.0),
    }
}

fn blend(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// A profile as a light has it: what it sends is its colours times the profile over its maximum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Luminaire {
    /// The intensities.
    pub profile: Arc<Profile>,
    /// The direction γ = 0, in the light's space; any length but zero. A spot's is that of its cone.
    pub axis: DVec3,
    /// Where the half plane C 0° points, less its part along `axis`; not parallel to it.
    pub c0: DVec3,
}

impl Luminaire {
    /// Which way a luminaire points that says nothing else: down, as in a ceiling.
    pub const AXIS: DVec3 = DVec3::NEG_Y;

    /// A C 0° for an axis: +X, or +Y where the axis is near X.
    pub fn c0_for(axis: DVec3) -> DVec3 {
        // cos 2.6°: nearer than this, rounding of the axis would turn the planes.
        if axis.x.abs() > 0.999 * axis.length() { DVec3::Y } else { DVec3::X }
    }

    /// The unit directions of C 0°, C 90° and γ 0°. Seen from above, that is from behind the luminaire,
    /// C grows counter-clockwise; a luminaire that points down with C 0° along +X has C 90° along −Z.
    ///
    /// They are orthonormal but left-handed, since C turns against the axis.
    ///
    /// `None` where `c0` is parallel to `axis`, or one of them zero or not finite.
    pub fn frame(&self) -> Option<DMat3> {
        let axis = self.axis.try_normalize()?;
        let c90 = self.c0.try_normalize()?.cross(axis).try_normalize()?;
        Some(DMat3::from_cols(axis.cross(c90), c90, axis))
    }

    /// The intensity relative to the greatest, 0 to 1, along unit vectors given in [`Self::frame`].
    pub fn fraction(&self, local: DVec3) -> f64 {
        let max = self.profile.max();
        if max <= 0.0 {
            return 0.0;
        }
        let ring = (local.x * local.x + local.y * local.y).sqrt();
        let c = if ring > 0.0 { libm::atan2(local.y, local.x) } else { 0.0 };
        self.profile.at(c.to_degrees(), libm::atan2(ring, local.z).to_degrees()) / max
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;

    /// Rounding of a few sines and products.
    const ROUNDING: f64 = 1e-12;

    fn profile(c_deg: &[f64], gamma_deg: &[f64], candela: &[f64]) -> Profile {
        Profile { c_deg: c_deg.to_vec(), gamma_deg: gamma_deg.to_vec(), candela: candela.to_vec() }
    }

    #[test]
    fn values_are_linear_between_angles_and_nothing_beyond() {
        let found = profile(&[0.0, 180.0, 360.0], &[0.0, 90.0], &[10.0, 0.0, 30.0, 20.0, 10.0, 0.0]);
        for (c, gamma, expected) in [
            (0.0, 0.0, 10.0),
            (90.0, 0.0, 20.0),
            (180.0, 45.0, 25.0),
            (270.0, 90.0, 10.0),
            (-90.0, 0.0, 20.0),
        ] {
            assert!((found.at(c, gamma) - expected).abs() < ROUNDING, "{c}, {gamma}");
        }
        assert_eq!((found.at(0.0, 90.1), found.at(0.0, -0.1), found.max()), (0.0, 0.0, 30.0));
        let round = profile(&[0.0], &[0.0, 180.0], &[4.0, 2.0]);
        assert!((round.at(123.0, 90.0) - 3.0).abs() < ROUNDING);
    }

    #[test]
    fn the_flux_of_a_uniform_source_is_its_intensity_times_the_sphere() {
        let round = profile(&[0.0], &[0.0, 17.0, 180.0], &[2.0; 3]);
        let planes = profile(&[0.0, 90.0, 360.0], &[0.0, 90.0, 180.0], &[2.0; 9]);
        for found in [round.flux_lm(), planes.flux_lm()] {
            assert!((found - 8.0 * PI).abs() < 8.0 * PI * ROUNDING, "{found}");
        }
    }

    #[test]
    fn a_luminaire_in_a_ceiling_has_its_planes_counter_clockwise_from_above() {
        let one = Arc::new(profile(&[0.0], &[0.0, 180.0], &[1.0, 1.0]));
        let lamp = Luminaire { profile: one, axis: Luminaire::AXIS, c0: Luminaire::c0_for(Luminaire::AXIS) };
        let frame = lamp.frame().expect("they are not parallel");
        assert_eq!(frame, DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::NEG_Y));
        let along = Luminaire { c0: 2.0 * DVec3::NEG_Y, ..lamp };
        assert_eq!(along.frame(), None);
        assert_eq!(Luminaire::c0_for(DVec3::NEG_X), DVec3::Y);
    }

    #[test]
    fn shares_follow_the_angles() {
        let quarter = profile(&[0.0, 90.0, 360.0], &[0.0, 90.0], &[1.0, 0.5, 1.0, 2.0, 1.0, 0.5]);
        let lamp = Luminaire { profile: Arc::new(quarter), axis: DVec3::NEG_Y, c0: DVec3::X };
        for (local, expected) in [(DVec3::Z, 0.5), (DVec3::X, 0.25), (DVec3::Y, 1.0), (DVec3::NEG_Z, 0.0)] {
            assert!((lamp.fraction(local) - expected).abs() < ROUNDING, "{local}");
        }
    }
}
