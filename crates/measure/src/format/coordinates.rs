//! Pairs of directions as four angles.

use core::f64::consts::{FRAC_PI_2, PI};

use glanz_math::Vec3;

use super::LEAST_COSINE;

/// Which four angles name a pair of directions.
///
/// ```
/// use glanz_measure::Coordinates;
///
/// // Light at 30°, the detector 10° from the mirror direction, towards the normal.
/// let [wi, wo] = Coordinates::Specular.pair([30.0, 180.0, 10.0, 0.0].map(f64::to_radians));
/// assert!((wi.z - 30_f64.to_radians().cos()).abs() < 1e-12);
/// assert!((wo.z - 20_f64.to_radians().cos()).abs() < 1e-12 && wo.x > 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    /// θi, φi, θo and φo.
    Spherical,
    /// θi, φi, θo and φo − φi.
    SphericalDifference,
    /// θi, φi, the angle between detector and mirror direction, and the azimuth around the mirror direction, which counts
    /// from the side of the normal.
    Specular,
    /// θh and φh of the half vector, θd and φd of the light about it.
    HalfDifference,
}

impl Coordinates {
    /// The angles of a pair of directions, to the light and to the detector, in radians.
    pub fn angles(self, wi: Vec3<f64>, wo: Vec3<f64>) -> [f64; 4] {
        let [theta_i, phi_i] = polar(wi);
        match self {
            Self::Spherical | Self::SphericalDifference => {
                let [theta_o, phi_o] = polar(wo);
                let from = if self == Self::Spherical { 0.0 } else { phi_i };
                [theta_i, phi_i, theta_o, phi_o - from]
            }
            Self::Specular => {
                let [radial, azimuth] = polar(turned_y(turned_z(wo, -phi_i), theta_i));
                [theta_i, phi_i, radial, azimuth]
            }
            Self::HalfDifference => {
                let half = (wi + wo).normalized();
                let [theta_h, phi_h] = polar(half);
                let [theta_d, phi_d] = polar(turned_y(turned_z(wi, -phi_h), -theta_h));
                [theta_h, phi_h, theta_d, phi_d]
            }
        }
    }

    /// The directions to the light and to the detector of four angles in radians.
    pub fn pair(self, [a, b, c, d]: [f64; 4]) -> [Vec3<f64>; 2] {
        match self {
            Self::Spherical => [Vec3::from_angles(a, b), Vec3::from_angles(c, d)],
            Self::SphericalDifference => [Vec3::from_angles(a, b), Vec3::from_angles(c, d + b)],
            Self::Specular => {
                let wo = turned_z(turned_y(Vec3::from_angles(c, d), -a), b);
                [Vec3::from_angles(a, b), wo]
            }
            Self::HalfDifference => {
                let half = Vec3::from_angles(a, b);
                let wi = turned_z(turned_y(Vec3::from_angles(c.min(FRAC_PI_2), d), a), b);
                [wi, wi.reflected(half)]
            }
        }
    }

    /// The azimuth of the light that a table has which depends on differences of azimuths alone: the mirror direction is
    /// at 0.
    pub(crate) fn default_azimuth(self) -> f64 {
        match self {
            Self::HalfDifference => 0.0,
            _ => PI,
        }
    }
}

/// A direction at or below the horizon, brought a little above it.
pub(super) fn clamped(w: Vec3<f64>) -> Vec3<f64> {
    if w.z >= LEAST_COSINE {
        return w;
    }
    let around = libm::sqrt(w.x * w.x + w.y * w.y);
    let scale = if around > 0.0 { libm::sqrt(1.0 - LEAST_COSINE * LEAST_COSINE) / around } else { 0.0 };
    Vec3::new(w.x * scale, w.y * scale, LEAST_COSINE)
}

/// Angle from z and azimuth.
fn polar(w: Vec3<f64>) -> [f64; 2] {
    [libm::atan2(libm::sqrt(w.x * w.x + w.y * w.y), w.z), libm::atan2(w.y, w.x)]
}

/// Turned about z, from x to y.
fn turned_z(w: Vec3<f64>, by: f64) -> Vec3<f64> {
    let (sin, cos) = libm::sincos(by);
    Vec3::new(cos * w.x - sin * w.y, sin * w.x + cos * w.y, w.z)
}

/// Turned about y, from z to x.
fn turned_y(w: Vec3<f64>, by: f64) -> Vec3<f64> {
    let (sin, cos) = libm::sincos(by);
    Vec3::new(cos * w.x + sin * w.z, w.y, cos * w.z - sin * w.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_come_back_from_directions() {
        use Coordinates::{HalfDifference, Specular, Spherical, SphericalDifference};
        for coordinates in [Spherical, SphericalDifference, Specular, HalfDifference] {
            for angles in [[0.3, 0.4, 0.2, 1.1], [0.6, -1.0, 0.5, -2.0], [1.2, 3.0, 0.3, 0.1]] {
                let [wi, wo] = coordinates.pair(angles);
                let again = coordinates.angles(wi, wo);
                for (a, b) in angles.iter().zip(again) {
                    let turns = (a - b) / core::f64::consts::TAU;
                    assert!((turns - turns.round()).abs() < 1e-12, "{coordinates:?} {angles:?} {again:?}");
                }
            }
        }
        // Away from the normal the azimuth about the mirror direction is 180°.
        let [_, wo] = Specular.pair([0.5, 0.0, 0.2, PI]);
        assert!((polar(wo)[0] - 0.7).abs() < 1e-12 && wo.x < 0.0);
    }
}
