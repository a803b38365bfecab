//! The pairs of directions that are looked at.

use glanz_math::{PI, Vec3};

use super::subject::Subject;

/// Angles from the normal, in degrees: the pole, the middle, and ever nearer to the horizon.
pub(super) const THETA: [f64; 13] =
    [0.0, 5.0, 15.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0, 89.0, 89.9, 89.99, 89.999];
/// Azimuths of the light, in degrees: the plane of incidence, across it, and odd ones.
const AROUND: [f64; 8] = [0.0, 37.0, 90.0, 145.0, 179.0, 180.0, 181.0, 261.0];
/// Azimuths of the viewer on a surface with a grain, in degrees.
pub(super) const GRAIN: [f64; 4] = [0.0, 30.0, 60.0, 90.0];
/// Distances from the mirror direction, in degrees: where narrow lobes are.
const NEAR_MIRROR: [f64; 9] = [-8.0, -2.0, -0.5, -0.05, 0.0, 0.05, 0.5, 2.0, 8.0];

/// From degrees.
pub(super) fn radians(degrees: f64) -> f64 {
    degrees * PI / 180.0
}

/// The direction at these angles in degrees.
pub(super) fn direction(theta: f64, phi: f64) -> Vec3<f64> {
    Vec3::from_angles(radians(theta), radians(phi))
}

/// Azimuths from which a subject is seen: one where it is the same all around.
pub(super) fn azimuths(subject: &dyn Subject) -> &'static [f64] {
    if subject.info().anisotropic { &GRAIN } else { &GRAIN[..1] }
}

/// Angles of a pair of directions in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// The viewer's angle from the normal.
    pub theta_o: f64,
    /// The viewer's azimuth.
    pub phi_o: f64,
    /// The light's angle from the normal, up to 180.
    pub theta_i: f64,
    /// The light's azimuth.
    pub phi_i: f64,
}

impl Place {
    /// The direction to the viewer.
    pub fn wo(self) -> Vec3<f64> {
        direction(self.theta_o, self.phi_o)
    }

    /// The direction to the light.
    pub fn wi(self) -> Vec3<f64> {
        direction(self.theta_i, self.phi_i)
    }

    /// In words.
    pub fn words(self) -> String {
        let Self { theta_o, phi_o, theta_i, phi_i } = self;
        let short = |v: f64| {
            let text = format!("{v:.3}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        let turn = short((phi_i - phi_o).rem_euclid(360.0));
        let grain = if phi_o == 0.0 { String::new() } else { format!(", φo = {}°", short(phi_o)) };
        format!("θo = {}°{grain}, θi = {}°, φi – φo = {turn}°", short(theta_o), short(theta_i))
    }
}

/// All pairs with the light on the side that the subject answers to.
pub(super) fn places(subject: &dyn Subject) -> Vec<Place> {
    let transmits = subject.transmits();
    let side = |theta: f64| if transmits { 180.0 - theta } else { theta };
    let mut places = Vec::new();
    for &phi_o in azimuths(subject) {
        for theta_o in THETA {
            for theta in THETA {
                for phi in AROUND {
                    places.push(Place { theta_o, phi_o, theta_i: side(theta), phi_i: phi_o + phi });
                }
            }
            for near in NEAR_MIRROR {
                let theta = theta_o + near;
                if (0.0..90.0).contains(&theta) {
                    places.push(Place { theta_o, phi_o, theta_i: side(theta), phi_i: phi_o + 180.0 });
                }
            }
        }
    }
    places
}

/// The vector in single precision.
pub(super) fn short(v: Vec3<f64>) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}
