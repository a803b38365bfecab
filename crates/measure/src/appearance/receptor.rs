//! Sources and receptors of gloss meters: flux from a rectangle of directions into another one.

use core::f64::consts::PI;

use glanz_math::Vec3;

use super::Function;

/// The refractive index of the glass whose gloss is 100 (ISO 2813, ASTM D523).
pub(super) const GLASS: f64 = 1.567;

/// The image of the source of gloss meters in the plane of the receptor, in degrees: in the plane of measurement and
/// across it.
pub(super) const SOURCE_DEG: [f64; 2] = [0.75, 2.5];

/// Steps along the sides of the source.
const SOURCE_STEPS: usize = 8;

/// A source and a receptor, both rectangles of angles, in degrees: in the plane of measurement and across it.
pub(super) struct Path {
    /// The angle of the light from the normal.
    pub light_deg: f64,
    /// The size of the source's image.
    pub source_deg: [f64; 2],
    /// The angle of the receptor from the normal, on the other side.
    pub angle_deg: f64,
    /// The size of its aperture.
    pub receptor_deg: [f64; 2],
    /// Steps along the sides of the receptor.
    pub steps: usize,
}

impl Path {
    /// The part of the light that falls on the surface which the receptor gets, one number per channel.
    pub(super) fn fraction(&self, f: &mut Function<'_>) -> Vec<f64> {
        let mut flux: Vec<f64> = Vec::new();
        let mut falls = 0.0;
        let receptor = aperture(self.angle_deg.to_radians(), 0.0, self.receptor_deg, self.steps);
        for (wi, light) in aperture(self.light_deg.to_radians(), PI, self.source_deg, SOURCE_STEPS) {
            falls += light * wi.z;
            for (wo, solid) in &receptor {
                let values = f(wi, *wo);
                flux.resize(values.len(), 0.0);
                let weight = light * wi.z * solid * wo.z;
                flux.iter_mut().zip(values).for_each(|(sum, value)| *sum += value * weight);
            }
        }
        flux.iter().map(|sum| sum / falls).collect()
    }

    /// The same of polished black glass, by a receptor in the mirror direction.
    pub(super) fn fraction_of_glass(&self) -> f64 {
        let part = |receptor: f64, source: f64| {
            (libm::tan(0.5 * receptor.to_radians()) / libm::tan(0.5 * source.to_radians())).min(1.0)
        };
        let seen =
            part(self.receptor_deg[0], self.source_deg[0]) * part(self.receptor_deg[1], self.source_deg[1]);
        seen * reflectance(GLASS, self.light_deg.to_radians())
    }
}

/// Directions of a rectangle of angles about one in the plane of x, with their solid angles. What lies below the horizon is
/// left out.
fn aperture(theta: f64, phi: f64, sides_deg: [f64; 2], steps: usize) -> Vec<(Vec3<f64>, f64)> {
    let middle = Vec3::from_angles(theta, phi);
    let along = Vec3::from_angles(theta + PI / 2.0, phi);
    let across = Vec3::new(0.0, 1.0, 0.0);
    let [half_along, half_across] = sides_deg.map(|side| libm::tan(0.5 * side.to_radians()));
    let place = |step: usize| 2.0 * (step as f64 + 0.5) / steps as f64 - 1.0;
    let area = 4.0 * half_along * half_across / (steps * steps) as f64;
    let mut all = Vec::with_capacity(steps * steps);
    for i in 0..steps {
        for j in 0..steps {
            let (x, y) = (place(i) * half_along, place(j) * half_across);
            let square = 1.0 + x * x + y * y;
            let direction = (middle + along * x + across * y) * (1.0 / libm::sqrt(square));
            if direction.z > 0.0 {
                all.push((direction, area / (square * libm::sqrt(square))));
            }
        }
    }
    all
}

/// What glass reflects of light that is not polarised (Fresnel).
pub(super) fn reflectance(n: f64, theta: f64) -> f64 {
    let (cos, sin) = (libm::cos(theta), libm::sin(theta));
    let inside = libm::sqrt(n * n - sin * sin);
    let s = (cos - inside) / (cos + inside);
    let p = (n * n * cos - inside) / (n * n * cos + inside);
    0.5 * (s * s + p * p)
}
