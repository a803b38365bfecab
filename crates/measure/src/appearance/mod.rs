//! Numbers of appearance: gloss, radiance factors, and what spheres see.

use core::f64::consts::{FRAC_1_PI, PI, TAU};

use glanz_math::Vec3;

/// A BRDF in 1/sr, for a direction to the light and one to the detector; one number per channel.
pub type Function<'a> = dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64> + 'a;

/// The refractive index of the glass whose gloss is 100 (ISO 2813, ASTM D523).
const GLASS: f64 = 1.567;

/// The image of the source in the plane of the receptor, in degrees: in the plane of measurement and across it.
const SOURCE: [f64; 2] = [0.75, 2.5];

/// Steps along the sides of the source and of the receptor.
const STEPS: [usize; 2] = [8, 80];

/// A geometry of gloss meters: the angle of light and receptor from the normal, and the receptor's aperture in the plane of
/// measurement and across it, in degrees (ISO 2813, ASTM D523).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlossMeter {
    /// The angle from the normal.
    pub angle_deg: f64,
    /// The receptor's aperture.
    pub receptor_deg: [f64; 2],
}

impl GlossMeter {
    /// For high gloss.
    pub const AT_20: Self = Self { angle_deg: 20.0, receptor_deg: [1.8, 3.6] };
    /// For all surfaces.
    pub const AT_60: Self = Self { angle_deg: 60.0, receptor_deg: [4.4, 11.7] };
    /// For low gloss.
    pub const AT_85: Self = Self { angle_deg: 85.0, receptor_deg: [4.0, 6.0] };

    /// The gloss, one number per channel: 100 times the flux from the source into the receptor, by that of polished black
    /// glass of index 1.567.
    ///
    /// ```
    /// use glanz_measure::GlossMeter;
    ///
    /// // White paper without any gloss still sends some light there.
    /// let white = GlossMeter::AT_60.gloss(&mut |_, _| vec![1.0 / std::f64::consts::PI]);
    /// assert!((white[0] - 2.485).abs() < 0.005);
    /// ```
    pub fn gloss(&self, f: &mut Function<'_>) -> Vec<f64> {
        let theta = self.angle_deg.to_radians();
        let mut flux: Vec<f64> = Vec::new();
        let mut falls = 0.0;
        for (wi, light) in aperture(theta, PI, SOURCE, STEPS[0]) {
            falls += light * wi.z;
            for (wo, solid) in aperture(theta, 0.0, self.receptor_deg, STEPS[1]) {
                let values = f(wi, wo);
                flux.resize(values.len(), 0.0);
                let weight = light * wi.z * solid * wo.z;
                flux.iter_mut().zip(values).for_each(|(sum, value)| *sum += value * weight);
            }
        }
        flux.iter().map(|sum| 100.0 * sum / (falls * reflectance(GLASS, theta))).collect()
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
fn reflectance(n: f64, theta: f64) -> f64 {
    let (cos, sin) = (libm::cos(theta), libm::sin(theta));
    let inside = libm::sqrt(n * n - sin * sin);
    let s = (cos - inside) / (cos + inside);
    let p = (n * n * cos - inside) / (n * n * cos + inside);
    0.5 * (s * s + p * p)
}

/// The radiance factors πf of a multi-angle instrument: light at 45°, and detectors by the angle from the mirror direction
/// towards the light, in degrees, as −15, 15, 25, 45, 75, 110.
///
/// ```
/// use std::f64::consts::FRAC_1_PI;
///
/// // A perfect diffuser looks the same from everywhere.
/// let factor = glanz_measure::multi_angle(&mut |_, _| vec![FRAC_1_PI], 25.0);
/// assert!((factor[0] - 1.0).abs() < 1e-12);
/// ```
pub fn multi_angle(f: &mut Function<'_>, aspecular_deg: f64) -> Vec<f64> {
    // The mirror direction lies at +45° in the plane, the light at −45°.
    let angle = (45.0 - aspecular_deg).to_radians();
    let wo = Vec3::from_angles(angle.abs(), if angle < 0.0 { PI } else { 0.0 });
    let wi = Vec3::from_angles(PI / 4.0, PI);
    f(wi, wo).into_iter().map(|value| value * PI).collect()
}

/// What an integrating sphere measures, 8°/d: the part of the light at 8° that is reflected into the hemisphere, with all of
/// it, and without what lies within `port_deg` of the mirror direction. Instruments' ports are 4 to 5°.
///
/// ```
/// use std::f64::consts::FRAC_1_PI;
///
/// let [included, excluded] = glanz_measure::sphere(&mut |_, _| vec![0.5 * FRAC_1_PI], 4.1);
/// assert!((included[0] - 0.5).abs() < 1e-3 && excluded[0] < included[0]);
/// ```
pub fn sphere(f: &mut Function<'_>, port_deg: f64) -> [Vec<f64>; 2] {
    let wi = Vec3::from_angles(8.0_f64.to_radians(), PI);
    let mirror = Vec3::new(-wi.x, -wi.y, wi.z);
    let port = libm::cos(port_deg.to_radians());
    let steps = [400_usize, 180];
    let (mut all, mut without): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for a in 0..steps[0] {
        // Around the mirror direction, most densely near it.
        let u = (a as f64 + 0.5) / steps[0] as f64;
        let (theta, width) = (u * u * (PI / 2.0 + 0.14), 2.0 * u / steps[0] as f64 * (PI / 2.0 + 0.14));
        for b in 0..steps[1] {
            let local = Vec3::from_angles(theta, (b as f64 + 0.5) * TAU / steps[1] as f64);
            let wo = turned(local, mirror);
            if wo.z <= 0.0 {
                continue;
            }
            let values = f(wi, wo);
            all.resize(values.len(), 0.0);
            without.resize(values.len(), 0.0);
            let weight = wo.z * libm::sin(theta) * width * TAU / steps[1] as f64;
            let is_outside = wo.dot(mirror) < port;
            for (c, value) in values.iter().enumerate() {
                all[c] += value * weight;
                without[c] += if is_outside { value * weight } else { 0.0 };
            }
        }
    }
    [all, without]
}

/// A direction about z, brought about another one in the plane of x.
fn turned(w: Vec3<f64>, about: Vec3<f64>) -> Vec3<f64> {
    Vec3::new(about.z * w.x + about.x * w.z, w.y, about.z * w.z - about.x * w.x)
}

/// The radiance factor πf of 45°/0°: light at 45° in the plane of x, the detector above.
///
/// ```
/// use std::f64::consts::FRAC_1_PI;
///
/// assert!((glanz_measure::forty_five_zero(&mut |_, _| vec![0.8 * FRAC_1_PI])[0] - 0.8).abs() < 1e-12);
/// ```
pub fn forty_five_zero(f: &mut Function<'_>) -> Vec<f64> {
    let values = f(Vec3::from_angles(PI / 4.0, PI), Vec3::from_angles(0.0, 0.0));
    values.into_iter().map(|value| value / FRAC_1_PI).collect()
}
