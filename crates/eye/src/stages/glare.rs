//! Light that is scattered in the eye: CIE 135/1 as a sum of Gaussians, each a blur.

use super::plane::Plane;
use super::pyramid::{Blur, blurred};
use crate::Eye;
use crate::curves::GlareMixture;

/// Light that is scattered by less than this σ in degrees stays where it is: whoever looks at the picture scatters it by the eye of
/// their own.
const LEAST_DEG: f64 = 0.1;

/// The σ in degrees of the widest Gaussian on a picture.
const WIDEST_DEG: f64 = 64.0;

/// The blurs of an eye: what is spread, and what stays.
pub(crate) struct Glare {
    blurs: Vec<Blur>,
    rest: f64,
}

impl Glare {
    pub(crate) fn new(eye: &Eye, px_per_deg: f64) -> Self {
        let mixture = GlareMixture { least_sigma_deg: LEAST_DEG, ..GlareMixture::new(eye.age, eye.iris) };
        let mut blurs: Vec<Blur> = Vec::new();
        for gaussian in mixture.gaussians() {
            // A picture is flat, and a Gaussian over the half space has more light near its middle than a flat one of its weight:
            // peaks are kept. What is wider than a picture is as good as uniform over it, and is put into one.
            let sigma_deg = gaussian.sigma_deg.min(WIDEST_DEG);
            let sigma = sigma_deg.to_radians();
            let weight = gaussian.density(0.0) * 2.0 * core::f64::consts::PI * sigma * sigma;
            let sigma_px = sigma_deg * px_per_deg;
            match blurs.last_mut() {
                Some(last) if last.sigma_px == sigma_px => last.weight += weight,
                _ => blurs.push(Blur { weight, sigma_px }),
            }
        }
        let rest = 1.0 - blurs.iter().map(|blur| blur.weight).sum::<f64>();
        Self { blurs, rest }
    }

    pub(crate) fn apply(&self, channel: &mut Vec<f32>, width: usize) {
        if channel.is_empty() {
            return;
        }
        let plane = Plane::of(std::mem::take(channel), width);
        *channel = blurred(plane, self.rest, &self.blurs).values;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::{vos_glare, vos_glare_integral};

    /// What CIE 135/1 is asked to be met by.
    const ERROR: f64 = 0.025;

    #[test]
    fn a_lamp_is_surrounded_by_the_glare_function() {
        // 16 pixels per degree, a picture of 64 degrees.
        let (size, px_per_deg) = (1025, 16.0);
        for age in [25.0, 70.0] {
            let eye = Eye { age, ..Eye::default() };
            let mut channel = vec![0.0; size * size];
            let middle = size / 2;
            channel[middle * size + middle] = 1.0;
            Glare::new(&eye, px_per_deg).apply(&mut channel, size);
            let per_px = 1.0 / (px_per_deg * 180.0 / core::f64::consts::PI);
            for deg in [2.0, 3.0, 5.0, 8.0, 12.0, 20.0] {
                let px = (deg * px_per_deg) as usize;
                // The mean over directions: a point lies somewhere within a pixel of the coarse levels.
                let around = [(px, 0), (0, px)].map(|(x, y)| {
                    let at = |x: usize, y: usize| f64::from(channel[y * size + x]);
                    0.5 * (at(middle + x, middle + y) + at(middle - x, middle - y))
                });
                let found = 0.5 * (around[0] + around[1]) / (per_px * per_px);
                let exact = vos_glare(deg, age, 0.5) / vos_glare_integral(age, 0.5);
                assert!((found / exact - 1.0).abs() < ERROR, "{age}, {deg}°: {found} for {exact}");
            }
        }
    }
}
