//! Integrating spheres.

use core::f64::consts::{PI, TAU};

use glanz_math::Vec3;

use super::Function;

/// Steps from the mirror direction to the edge of the port, from there to the horizon, and around.
const STEPS_WITHIN: usize = 100;
const STEPS: usize = 300;
const AROUND: usize = 180;

/// The farthest that the horizon is from the mirror direction: a right angle and 8°, in radians.
const MOST: f64 = PI / 2.0 + 0.14;

/// What an integrating sphere measures, 8°/d, which is d/8° by reciprocity: the part of the light at 8° that is reflected into
/// the hemisphere, with all of it (specular component included, SCI), and without what lies within `port_deg` of the mirror
/// direction (SCE). Ports differ from instrument to instrument; 4 to 5° is common, which is not verified against a standard.
///
/// ```
/// use std::f64::consts::FRAC_1_PI;
///
/// let [included, excluded] = glanz_measure::sphere(&mut |_, _| vec![0.5 * FRAC_1_PI], 4.1);
/// assert!((included[0] - 0.5).abs() < 1e-3 && excluded[0] < included[0]);
/// ```
pub fn sphere(f: &mut Function<'_>, port_deg: f64) -> [Vec<f64>; 2] {
    let port = port_deg.to_radians();
    let (mut all, mut without): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for (wo, weight, is_outside) in
        rings(0.0, port, STEPS_WITHIN, false).chain(rings(port, MOST, STEPS, true))
    {
        let values = f(light(), wo);
        all.resize(values.len(), 0.0);
        without.resize(values.len(), 0.0);
        for (c, value) in values.iter().enumerate() {
            all[c] += value * weight;
            without[c] += if is_outside { value * weight } else { 0.0 };
        }
    }
    [all, without]
}

/// The angle of the light from the normal, in degrees.
pub const SPHERE_DEG: f64 = 8.0;

/// The direction to the light.
fn light() -> Vec3<f64> {
    Vec3::from_angles(SPHERE_DEG.to_radians(), PI)
}

/// Directions above the horizon from one angle about the mirror direction to another, most densely near the first; with their
/// cosine times their solid angle, and what was said of them.
fn rings(from: f64, to: f64, steps: usize, mark: bool) -> impl Iterator<Item = (Vec3<f64>, f64, bool)> {
    let wi = light();
    let mirror = Vec3::new(-wi.x, -wi.y, wi.z);
    (0..steps * AROUND).filter_map(move |index| {
        let u = ((index / AROUND) as f64 + 0.5) / steps as f64;
        let (theta, width) = (from + u * u * (to - from), 2.0 * u / steps as f64 * (to - from));
        let phi = ((index % AROUND) as f64 + 0.5) * TAU / AROUND as f64;
        let wo = turned(Vec3::from_angles(theta, phi), mirror);
        (wo.z > 0.0).then(|| (wo, wo.z * libm::sin(theta) * width * TAU / AROUND as f64, mark))
    })
}

/// A direction about z, brought about another one in the plane of x.
fn turned(w: Vec3<f64>, about: Vec3<f64>) -> Vec3<f64> {
    Vec3::new(about.z * w.x + about.x * w.z, w.y, about.z * w.z - about.x * w.x)
}
