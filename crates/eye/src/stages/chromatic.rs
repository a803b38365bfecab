//! Longitudinal chromatic aberration: light of the ends of the spectrum is out of focus.
//!
//! A pixel of a channel has light of many wavelengths; each is blurred to a disc of its own, and the channel by their sum, as its
//! sensitivity weighs them under daylight. Exact for grey things; the spectrum of a pixel is not known here.

use glanz_color::{SAMPLES, Spectrum, lambda_nm, light};

use super::plane::Plane;
use super::pyramid::{Blur, blurred};
use crate::Eye;
use crate::curves::defocus_disc_deg;

/// The wavelength that an eye focuses on.
pub(crate) const FOCUS_NM: f64 = 555.0;

/// The least blur that is drawn, σ in pixels.
const SHARP_PX: f64 = 0.25;

/// Blurs of one octave.
const PER_OCTAVE: f64 = 2.0;

/// The blurs of a channel (0 to 2: L, M, S; 3: the rods) through a pupil, and what stays sharp.
pub(crate) struct Chromatic {
    blurs: Vec<Blur>,
    rest: f64,
}

impl Chromatic {
    pub(crate) fn new(eye: &Eye, channel: usize, pupil_mm: f64, px_per_deg: f64) -> Self {
        let sensitivity = if channel == 3 { eye.rods() } else { eye.cone(channel) };
        let weights = sensitivity * light("D65").unwrap_or(Spectrum::ZERO);
        let sum: f64 = weights.0.iter().sum();
        // Weight, and weight times variance, of half octaves of σ.
        let mut steps: Vec<[f64; 2]> = Vec::new();
        let mut rest = 0.0;
        for i in (0..SAMPLES).filter(|i| weights.0[*i] > 0.0) {
            let weight = weights.0[i] / sum;
            // A disc of diameter d has the variance d²/16 along each direction.
            let sigma = 0.25 * defocus_disc_deg(lambda_nm(i), pupil_mm, FOCUS_NM) * px_per_deg;
            if sigma < SHARP_PX {
                rest += weight;
                continue;
            }
            let step = (PER_OCTAVE * libm::log2(sigma / SHARP_PX)) as usize;
            if steps.len() <= step {
                steps.resize(step + 1, [0.0; 2]);
            }
            steps[step][0] += weight;
            steps[step][1] += weight * sigma * sigma;
        }
        let filled = steps.into_iter().filter(|[weight, _]| *weight > 0.0);
        let blur = |[weight, second]: [f64; 2]| Blur { weight, sigma_px: libm::sqrt(second / weight) };
        Self { blurs: filled.map(blur).collect(), rest }
    }

    pub(crate) fn apply(&self, channel: &mut Vec<f32>, width: usize) {
        if channel.is_empty() || self.blurs.is_empty() {
            return;
        }
        let plane = Plane::of(std::mem::take(channel), width);
        *channel = blurred(plane, self.rest, &self.blurs, None).values;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The variance in squared degrees that a channel is blurred by.
    fn variance(channel: usize, pupil_mm: f64, px_per_deg: f64) -> f64 {
        let found = Chromatic::new(&Eye::default(), channel, pupil_mm, px_per_deg);
        found.blurs.iter().map(|blur| blur.weight * blur.sigma_px * blur.sigma_px).sum::<f64>()
            / (px_per_deg * px_per_deg)
    }

    #[test]
    fn all_light_is_kept_and_the_short_waves_are_blurred_most() {
        for channel in 0..4 {
            let found = Chromatic::new(&Eye::default(), channel, 6.0, 60.0);
            let sum = found.rest + found.blurs.iter().map(|blur| blur.weight).sum::<f64>();
            assert!((sum - 1.0).abs() < 1e-12, "{channel}: {sum}");
        }
        let [l, m, s, rods] = [0, 1, 2, 3].map(|channel| variance(channel, 3.0, 1000.0));
        assert!(s > 9.0 * l && s > 9.0 * m && rods > m && rods < s, "{l} {m} {s} {rods}");
        // As a disc: about that of 450 nm, 0.142°.
        let disc = 4.0 * libm::sqrt(s);
        assert!((0.12..0.16).contains(&disc), "{disc}");
        // Twice the pupil, twice the disc.
        assert!((variance(2, 6.0, 1000.0) / s - 4.0).abs() < 1e-9);
    }

    #[test]
    fn a_point_of_s_spreads_as_wide_as_its_disc_and_uniform_light_stays() {
        let size = 101;
        let mut point = vec![0.0; size * size];
        point[50 * size + 50] = 1.0;
        let chromatic = Chromatic::new(&Eye::default(), 2, 4.0, 60.0);
        chromatic.apply(&mut point, size);
        let (mut sum, mut second) = (0.0, 0.0);
        for (i, value) in point.iter().enumerate() {
            let dx = (i % size) as f64 - 50.0;
            sum += f64::from(*value);
            second += f64::from(*value) * dx * dx;
        }
        let expected = variance(2, 4.0, 60.0) * 3600.0;
        assert!(
            (sum - 1.0).abs() < 1e-4 && (second / expected - 1.0).abs() < 0.03,
            "{sum} {second} {expected}"
        );
        let mut even = vec![0.4; 64 * 48];
        chromatic.apply(&mut even, 64);
        assert!(even.iter().all(|v| (v - 0.4).abs() < 1e-6));
    }

    #[test]
    fn from_far_away_nothing_is_blurred() {
        let mut point = vec![0.0, 1.0, 0.0, 0.0];
        Chromatic::new(&Eye::default(), 2, 2.0, 1.0).apply(&mut point, 2);
        assert_eq!(point, [0.0, 1.0, 0.0, 0.0]);
    }
}
