//! The virtual goniometer: where light and detector stand, and its noise.

use glanz_math::Vec3;

/// Angles of the light from the normal, in degrees.
const LIGHTS_DEG: [f64; 4] = [15.0, 30.0, 45.0, 60.0];

/// Slopes of the facet that mirrors, from the least to the greatest.
const LEAST_SLOPE: f64 = 0.008;
const GREATEST_SLOPE: f64 = 1.0;

/// Readings for each light, and those on one turn of the spiral.
const READINGS: usize = 400;
const TURN: f64 = 20.0;

/// Directions to the light and to the detector, dense about the mirror direction and sparse far from it, as highlights of
/// unknown width want them: the facets that mirror lie on a spiral of slopes from 0.008 to 1, one for each of lights at 15, 30,
/// 45 and 60° from the normal. Light comes along x and along y in turn, so that both widths of a grain are seen. Detectors that
/// would lie more than 80° from the normal are left out.
///
/// ```
/// let pairs = glanz_measure::spiral_about_mirror();
/// assert!(pairs.len() > 1000 && pairs.iter().all(|[wi, wo]| wi.z > 0.1 && wo.z > 0.1));
/// ```
pub fn spiral_about_mirror() -> Vec<[Vec3<f64>; 2]> {
    let least = libm::cos(80.0_f64.to_radians());
    let mut pairs = Vec::new();
    for (light, theta) in LIGHTS_DEG.iter().enumerate() {
        let azimuth = if light % 2 == 0 { 180.0_f64 } else { 270.0 };
        let wi = Vec3::from_angles(theta.to_radians(), azimuth.to_radians());
        for index in 0..READINGS {
            let part = index as f64 / (READINGS - 1) as f64;
            let slope = LEAST_SLOPE * libm::pow(GREATEST_SLOPE / LEAST_SLOPE, part);
            let turns = index as f64 / TURN;
            let facet = Vec3::from_angles(libm::atan(slope), core::f64::consts::TAU * turns);
            let wo = facet * (2.0 * facet.dot(wi)) - wi;
            if wo.z > least && facet.dot(wi) > 0.0 {
                pairs.push([wi, wo]);
            }
        }
    }
    pairs
}

/// Numbers of a normal distribution of variance 1, and of an even one, the same on every machine.
///
/// ```
/// use glanz_measure::Noise;
///
/// let mut noise = Noise::new(1);
/// let mean = (0..1000).map(|_| noise.normal()).sum::<f64>() / 1000.0;
/// assert!(mean.abs() < 0.1);
/// assert_eq!(Noise::new(7).normal(), Noise::new(7).normal());
/// ```
#[derive(Clone, Debug)]
pub struct Noise(u64);

impl Noise {
    /// The noise of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// The next number (G. Box and M. Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let (a, b) = (self.unit(), self.unit());
        libm::sqrt(-2.0 * libm::log(a)) * libm::cos(core::f64::consts::TAU * b)
    }

    /// The next number of an even distribution from 0 to 1, without 0 (G. Marsaglia's xorshift).
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }
}
