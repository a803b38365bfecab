//! The noise of photons: at little light few are caught, and their number varies.
//!
//! The number of photons of a pixel is that of a Poisson distribution about its mean. Pixels draw from numbers of their own, so that the
//! bits depend neither on threads nor on the machine.

use glanz_color::{Spectrum, light};

use super::plane::for_each_row;
use crate::Eye;
use crate::curves::PHOTOPIC_EFFICACY;

/// How long receptors gather light, in seconds: that of rods in the dark, and some more than that of cones. Our choice.
pub(crate) const GATHERED_S: f64 = 0.1;

/// The part of the photons that a layer of the pigment alone would catch that the cones of a kind catch among the others: their share of the
/// mosaic. Our choice; people differ from equally many L and M to sixteen times as many L.
const SHARES: [f64; 3] = [0.63, 0.32, 0.05];

/// The part of caught photons that change a molecule.
const EFFICIENCY: f64 = 0.67;

/// The part of the photons of 507 nm at the cornea that rods answer to. Our choice; 0.1 to 0.3 are found in the literature.
const RODS: f64 = 0.2;

/// Photons that receptors of a channel answer to, per second, deg² and mm² of the pupil, for the value 1 where that is 1 cd/m².
///
/// The value 1 of a channel is what the standard eye of the same field has from a white of D65 of luminance 1.
pub(crate) fn photons_of_one(eye: &Eye, channel: usize) -> f64 {
    /// Planck's constant times the speed of light, in J·nm.
    const HC: f64 = 6.626_070_15e-34 * 299_792_458.0 * 1e9;
    const DEG: f64 = core::f64::consts::PI / 180.0;
    let standard = eye.standard();
    let d65 = light("D65").unwrap_or(Spectrum::ZERO);
    // W/(m²·sr) of D65 of 1 cd/m² are 1 / (683 · mean of V).
    let luminance = PHOTOPIC_EFFICACY * standard.luminosity().dot(&d65);
    let sensitivity = match channel {
        3 => eye.standard().rods(),
        cone => standard.cone(cone),
    };
    let answer = sensitivity.dot(&d65) / luminance;
    // λ times the part that is caught, at the peak.
    let peak = match channel {
        3 => 507.0 * RODS,
        cone => standard.catch_at_peak(cone) * SHARES[cone] * EFFICIENCY,
    };
    DEG * DEG * 1e-6 * answer * peak / HC
}

/// Draws the photons of a channel. `photons` is their number for the value 1; where that is 0, nothing is seen by the channel.
pub(crate) fn draw(channel: &mut [f32], width: usize, photons: f64, seed: u64) {
    if !(photons > 0.0 && photons.is_finite()) {
        return;
    }
    for_each_row(channel, width, |y, row| {
        for (x, value) in row.iter_mut().enumerate() {
            let mean = f64::from(*value) * photons;
            // What is no light has no photons; what is no number stays none.
            if mean > 0.0 && mean.is_finite() {
                let mut draws = Draws::of(seed, (y * width + x) as u64);
                *value = (poisson(mean, &mut draws) / photons) as f32;
            }
        }
    });
}

/// Even numbers of one pixel: SplitMix64 (G. Steele, D. Lea, C. Flood 2014), begun at a place of its own.
struct Draws(u64);

impl Draws {
    fn of(seed: u64, pixel: u64) -> Self {
        let mut start = Self(seed);
        let seed = start.next();
        let mut start = Self(seed ^ pixel.wrapping_mul(0xd134_2543_de82_ef95));
        Self(start.next())
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to 1, without both.
    fn unit(&mut self) -> f64 {
        ((self.next() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// Of a normal distribution of variance 1.
    fn normal(&mut self) -> f64 {
        let (a, b) = (self.unit(), self.unit());
        libm::sqrt(-2.0 * libm::log(a)) * libm::cos(core::f64::consts::TAU * b)
    }
}

/// Above this mean the distribution is drawn from a normal one with its skewness.
const MANY: f64 = 50.0;

/// A number of a Poisson distribution.
fn poisson(mean: f64, draws: &mut Draws) -> f64 {
    if mean > MANY {
        // E. Cornish and R. Fisher 1938, to the second term.
        let z = draws.normal();
        let sigma = libm::sqrt(mean);
        return (mean + sigma * z + (z * z - 1.0) / 6.0).round().max(0.0);
    }
    // By adding up the probabilities of 0, 1, 2 …
    let wanted = draws.unit();
    let mut probability = libm::exp(-mean);
    let (mut sum, mut count) = (probability, 0.0);
    while sum < wanted && count < 10.0 * MANY {
        count += 1.0;
        probability *= mean / count;
        sum += probability;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::photons_per_troland;

    fn drawn(mean: f64, count: usize) -> Vec<f64> {
        let mut channel = vec![mean as f32; count];
        draw(&mut channel, 1000, 1.0, 7);
        channel.into_iter().map(f64::from).collect()
    }

    #[test]
    fn mean_variance_and_skewness_are_those_of_photons() {
        let count = 200_000;
        for mean in [0.05, 0.7, 4.0, 30.0, 49.0, 51.0, 400.0, 1e5] {
            let found = drawn(mean, count);
            let mean_of = |f: &dyn Fn(f64) -> f64| found.iter().map(|v| f(*v)).sum::<f64>() / count as f64;
            let middle = mean_of(&|v| v);
            let variance = mean_of(&|v| (v - middle) * (v - middle));
            let third = mean_of(&|v| (v - middle) * (v - middle) * (v - middle));
            let root = libm::sqrt(count as f64);
            // Four standard errors of each.
            assert!((middle - mean).abs() < 4.0 * libm::sqrt(mean) / root, "{mean}: mean {middle}");
            let kurtosis = 2.0 + 1.0 / mean;
            let error = 4.0 * libm::sqrt(kurtosis) / root;
            assert!((variance / mean - 1.0).abs() < error, "{mean}: variance {variance}");
            let skewness = third / (variance * libm::sqrt(variance));
            let error = 4.0 * libm::sqrt(6.0 + 40.0 / mean + 15.0 / (mean * mean)) / root;
            assert!((skewness - 1.0 / libm::sqrt(mean)).abs() < error, "{mean}: skewness {skewness}");
        }
    }

    #[test]
    fn counts_are_as_likely_as_poisson_has_them() {
        let count = 100_000;
        for mean in [0.5, 3.0, 20.0] {
            let found = drawn(mean, count);
            let mut probability = libm::exp(-mean);
            for k in 0..40 {
                let expected = probability * count as f64;
                let seen = found.iter().filter(|v| **v == f64::from(k)).count() as f64;
                // Five standard deviations, and one for counts that are too few for a normal distribution.
                assert!(
                    (seen - expected).abs() < 5.0 * libm::sqrt(expected) + 1.0,
                    "{mean}, {k}: {seen}, {expected}"
                );
                probability *= mean / f64::from(k + 1);
            }
        }
    }

    #[test]
    fn neighbours_and_channels_have_nothing_in_common() {
        let size = 200;
        let plane = |seed| {
            let mut channel = vec![4.0_f32; size * size];
            draw(&mut channel, size, 1.0, seed);
            channel
        };
        let (a, b) = (plane(1), plane(2));
        let correlation = |a: &[f32], b: &[f32]| {
            let product = |(a, b): (&f32, &f32)| (f64::from(*a) - 4.0) * (f64::from(*b) - 4.0);
            a.iter().zip(b).map(product).sum::<f64>() / (4.0 * a.len() as f64)
        };
        for found in [correlation(&a, &b), correlation(&a, &a[1..]), correlation(&a, &a[size..])] {
            assert!(found.abs() < 4.0 / size as f64, "{found}");
        }
        assert_ne!(a, b);
        assert_eq!(a, plane(1));
    }

    #[test]
    fn a_line_of_one_wavelength_has_the_photons_of_its_trolands() {
        // 1 cd/m² at 555 nm through 1 mm²: what reaches the cornea, times what L catches of it.
        let eye = Eye::default();
        let d65 = light("D65").unwrap();
        let per_value = photons_of_one(&eye, 0);
        let line_radiance = 1.0 / (PHOTOPIC_EFFICACY * eye.luminosity().at(555.0));
        let value = eye.cone(0).at(555.0) * line_radiance
            / (eye.cone(0).dot(&d65) / (PHOTOPIC_EFFICACY * eye.luminosity().dot(&d65)));
        let caught = eye.cone(0).at(555.0) * eye.catch_at_peak(0) / 555.0 * SHARES[0] * EFFICIENCY;
        let expected = photons_per_troland(555.0, PHOTOPIC_EFFICACY * eye.luminosity().at(555.0)) * caught;
        let found = per_value * value;
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} for {expected}");
        // Of light that is caught best a layer of the pigment catches more than half.
        assert!((0.5..0.6).contains(&(eye.catch_at_peak(0) / 570.2)));
    }

    #[test]
    fn dark_channels_and_no_numbers_stay() {
        let mut channel = vec![0.0, -1.0, f32::NAN, f32::INFINITY];
        draw(&mut channel, 4, 10.0, 1);
        assert_eq!(channel[..2], [0.0, -1.0]);
        assert!(channel[2].is_nan() && channel[3].is_infinite());
    }
}
