//! The pairs of directions that lobes are judged at.

use glanz_math::{PI, Vec3};

use super::subject::Subject;
use crate::DirectionPair;

/// Angles from the normal, in degrees: the pole, the middle, and ever nearer to the horizon.
pub(super) const THETA: [f64; 13] =
    [0.0, 5.0, 15.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0, 89.0, 89.9, 89.99, 89.999];
/// Azimuths of the light about the viewer's, in degrees: the plane of incidence, across it, and others.
const PHI: [f64; 8] = [0.0, 37.0, 90.0, 145.0, 179.0, 180.0, 181.0, 261.0];
/// Azimuths of the viewer on an anisotropic surface, in degrees.
const PHI_ANISOTROPIC: [f64; 4] = [0.0, 30.0, 60.0, 90.0];
/// Distances from the mirror direction, in degrees: where narrow lobes are.
const NEAR_MIRROR: [f64; 9] = [-8.0, -2.0, -0.5, -0.05, 0.0, 0.05, 0.5, 2.0, 8.0];
/// Angles from the normal over the whole sphere, in degrees, with pole and horizon a hair missed.
const THETA_SPHERE: [f64; 13] =
    [0.0, 1e-4, 12.0, 30.0, 45.0, 60.0, 75.0, 89.0, 89.999, 90.0, 90.001, 120.0, 180.0];
/// Azimuths for these, in degrees.
const PHI_SPHERE: [f64; 6] = [0.0, 37.0, 90.0, 179.0, 180.0, 261.0];

/// From degrees.
pub(super) fn radians(degrees: f64) -> f64 {
    degrees * PI / 180.0
}

/// The direction at these angles in degrees.
pub(super) fn direction(theta: f64, phi: f64) -> Vec3<f64> {
    Vec3::from_angles(radians(theta), radians(phi))
}

/// Azimuths from which a lobe is viewed: one where it is isotropic.
pub(super) fn azimuths(subject: &dyn Subject) -> &'static [f64] {
    if subject.info().anisotropic { &PHI_ANISOTROPIC } else { &PHI_ANISOTROPIC[..1] }
}

/// A viewer and a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// The direction to the viewer.
    pub wo: Vec3<f64>,
    /// The direction to the light.
    pub wi: Vec3<f64>,
}

impl Place {
    /// The place at these angles in degrees: of the viewer and of the light, from the normal and about it.
    fn at((theta_o, phi_o): (f64, f64), (theta_i, phi_i): (f64, f64)) -> Self {
        Self { wo: direction(theta_o, phi_o), wi: direction(theta_i, phi_i) }
    }

    /// The pair in `f64`.
    pub(super) fn pair(&self) -> DirectionPair<f64> {
        DirectionPair::new(self.wo, self.wi)
    }

    /// The pair of the directions rounded to `f32`.
    pub(super) fn pair_f32(&self) -> DirectionPair<f32> {
        DirectionPair::new(to_f32(self.wo), to_f32(self.wi))
    }

    /// Its angles in words.
    pub(super) fn words(&self) -> String {
        let degrees = |radians: f64| radians * 180.0 / PI;
        let number = |v: f64| {
            let text = format!("{v:.3}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        let theta = |w: Vec3<f64>| degrees(libm::atan2(libm::hypot(w.x, w.y), w.z));
        let phi = |w: Vec3<f64>| degrees(libm::atan2(w.y, w.x));
        let (phi_o, phi_i) = (phi(self.wo), phi(self.wi));
        // Rounding may leave an azimuth a hair below 0, and so below a full turn.
        let turn = (phi_i - phi_o + 5e-4).rem_euclid(360.0) - 5e-4;
        let azimuth = match number(phi_o).as_str() {
            "0" | "-0" => String::new(),
            other => format!(", φo = {other}°"),
        };
        let (theta_o, theta_i) = (number(theta(self.wo)), number(theta(self.wi)));
        format!("θo = {theta_o}°{azimuth}, θi = {theta_i}°, φi – φo = {}°", number(turn.abs()))
    }
}

/// Pairs with the viewer above the surface and the light on the side that the lobe answers to, many of them about the
/// mirror direction.
pub(super) fn places(subject: &dyn Subject) -> Vec<Place> {
    let transmits = subject.transmits();
    let side = |theta: f64| if transmits { 180.0 - theta } else { theta };
    let mut places = Vec::new();
    for &phi_o in azimuths(subject) {
        for theta_o in THETA {
            for theta in THETA {
                places.extend(PHI.map(|phi| Place::at((theta_o, phi_o), (side(theta), phi_o + phi))));
            }
            let near = NEAR_MIRROR
                .map(|near| theta_o + near)
                .into_iter()
                .filter(|theta| (0.0..90.0).contains(theta));
            places.extend(near.map(|theta| Place::at((theta_o, phi_o), (side(theta), phi_o + 180.0))));
        }
    }
    places
}

/// All of [`places`], and pairs over the whole sphere: viewers and lights above, below and in the surface, equal and
/// opposite ones among them.
pub(super) fn places_anywhere(subject: &dyn Subject) -> Vec<Place> {
    let ring = |theta: f64| PHI_SPHERE.map(move |phi| direction(theta, phi));
    let mut sphere: Vec<_> = THETA_SPHERE.iter().flat_map(|theta| ring(*theta)).collect();
    // Rounding leaves 6e-17 for the cosine of 90 degrees; these lie in the plane exactly.
    sphere.extend([Vec3::new(1.0, 0.0, 0.0), Vec3::new(-1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)]);
    let mut places = places(subject);
    for wo in &sphere {
        places.extend(sphere.iter().map(|wi| Place { wo: *wo, wi: *wi }));
        places.push(Place { wo: *wo, wi: -*wo });
    }
    places
}

/// The vector in single precision.
pub(super) fn to_f32(v: Vec3<f64>) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}
