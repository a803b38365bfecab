//! Light that is scattered in the eye: CIE 135/1 as a sum of Gaussians, each a blur.

use super::acuity::Angles;
use super::field::{self, Field, Ways};
use super::plane::Plane;
use super::pyramid::{Blur, MARGIN, blurred, next_size};
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
    field: Option<Ways>,
}

impl Glare {
    /// Of pictures of this size.
    pub(crate) fn new(eye: &Eye, angles: Angles, size: [usize; 2]) -> Self {
        Self::from(LEAST_DEG, eye, angles, size)
    }

    /// That of all light which is scattered by a σ of `least_deg` and more.
    fn from(least_deg: f64, eye: &Eye, angles: Angles, size: [usize; 2]) -> Self {
        let mixture = GlareMixture { least_sigma_deg: least_deg, ..GlareMixture::new(eye.age, eye.iris) };
        let mut blurs: Vec<Blur> = Vec::new();
        for gaussian in mixture.gaussians() {
            // A picture is flat, and a Gaussian over the half space has more light near its middle than a flat one of its weight:
            // peaks are kept. What is wider than a picture is as good as uniform over it, and is put into one.
            let sigma_deg = gaussian.sigma_deg.min(WIDEST_DEG);
            let sigma = sigma_deg.to_radians();
            let weight = gaussian.density(0.0) * 2.0 * core::f64::consts::PI * sigma * sigma;
            let sigma_px = sigma_deg * angles.px_per_deg;
            match blurs.last_mut() {
                Some(last) if last.sigma_px == sigma_px => last.weight += weight,
                _ => blurs.push(Blur { weight, sigma_px }),
            }
        }
        let rest = 1.0 - blurs.iter().map(|blur| blur.weight).sum::<f64>();
        let field = Field::new(angles.distance_px, angles.middle).map(|field| {
            let size =
                (0..field::LEVEL).fold((size, 0), |(size, margin), _| (next_size(size, margin), MARGIN)).0;
            field.ways(size, MARGIN)
        });
        Self { blurs, rest, field }
    }

    pub(crate) fn apply(&self, channel: &mut Vec<f32>, width: usize) {
        if channel.is_empty() {
            return;
        }
        let plane = Plane::of(std::mem::take(channel), width);
        *channel = blurred(plane, self.rest, &self.blurs, self.field.as_ref()).values;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::{vos_glare, vos_glare_integral};

    /// What CIE 135/1 is asked to be met by.
    const ERROR: f64 = 0.025;

    /// A lamp of one pixel, `off` pixels right of the middle of a square picture, and the light about it.
    fn lamp(glare: &Glare, size: usize, off: usize) -> Vec<f32> {
        let mut channel = vec![0.0; size * size];
        channel[size / 2 * size + size / 2 + off] = 1.0;
        glare.apply(&mut channel, size);
        channel
    }

    /// The mean of four places about the middle: a point lies somewhere within a pixel of the coarse levels.
    fn around(channel: &[f32], size: usize, px: f64) -> f64 {
        let at = |dx: f64, dy: f64| {
            let [x, y] = [dx, dy].map(|d| (size / 2) as f64 + d);
            let (left, top) = (x.floor(), y.floor());
            let value = |x: f64, y: f64| f64::from(channel[y as usize * size + x as usize]);
            let row = |y: f64| value(left, y) + (x - left) * (value(left + 1.0, y) - value(left, y));
            row(top) + (y - top) * (row(top + 1.0) - row(top))
        };
        0.25 * (at(px, 0.0) + at(-px, 0.0) + at(0.0, px) + at(0.0, -px))
    }

    fn screen(px_per_deg: f64, size: usize) -> Angles {
        Angles { px_per_deg, distance_px: None, middle: [0.5 * size as f64; 2] }
    }

    /// The solid angle of a pixel of a screen in sr.
    fn pixel_sr(px_per_deg: f64) -> f64 {
        let across = px_per_deg.recip().to_radians();
        across * across
    }

    #[test]
    fn a_lamp_is_surrounded_by_the_glare_function() {
        // 16 pixels per degree, a picture of 64 degrees.
        let (size, px_per_deg) = (1025, 16.0);
        for age in [25.0, 70.0] {
            let eye = Eye { age, ..Eye::default() };
            let channel = lamp(&Glare::new(&eye, screen(px_per_deg, size), [size; 2]), size, 0);
            for deg in [2.0, 3.0, 5.0, 8.0, 12.0, 20.0] {
                let found = around(&channel, size, deg * px_per_deg) / pixel_sr(px_per_deg);
                let exact = vos_glare(deg, age, 0.5) / vos_glare_integral(age, 0.5);
                assert!((found / exact - 1.0).abs() < ERROR, "{age}, {deg}°: {found} for {exact}");
            }
        }
    }

    #[test]
    fn from_two_thousandths_of_a_degree_to_thirty_it_is_the_glare_function() {
        let size = 1025;
        for age in [25.0, 70.0] {
            let eye = Eye { age, ..Eye::default() };
            let integral = vos_glare_integral(age, 0.5);
            let mut worst: f64 = 0.0;
            // Pictures of 0.25 to 85 degrees: readings are far enough away for a pixel to be a point.
            for px_per_deg in [4000.0, 400.0, 60.0, 12.0] {
                let channel = lamp(&Glare::from(0.0, &eye, screen(px_per_deg, size), [size; 2]), size, 0);
                for px in [8.0, 10.0, 13.0, 20.0, 31.0, 50.0, 80.0, 125.0, 200.0, 300.0, 360.0] {
                    let deg: f64 = px / px_per_deg;
                    let found = around(&channel, size, px) / pixel_sr(px_per_deg);
                    let exact = vos_glare(deg, age, 0.5) / integral;
                    worst = worst.max((found / exact - 1.0).abs());
                }
            }
            assert!(worst < ERROR, "{age}: {worst}");
        }
    }

    /// The direction of a pixel of a camera.
    fn direction(angles: Angles, at: [f64; 2]) -> [f64; 3] {
        let [x, y] = [0, 1].map(|c| at[c] + 0.5 - angles.middle[c]);
        let z = angles.distance_px.unwrap();
        let length = libm::sqrt(x * x + y * y + z * z);
        [x / length, y / length, z / length]
    }

    #[test]
    fn of_a_wide_camera_angles_are_between_rays() {
        // 70° across.
        let size = 1025;
        let distance = 0.5 * size as f64 / libm::tan(35.0_f64.to_radians());
        let angles = Angles {
            px_per_deg: distance.to_radians(),
            distance_px: Some(distance),
            middle: [0.5 * size as f64; 2],
        };
        let eye = Eye { age: 70.0, ..Eye::default() };
        let glare = Glare::new(&eye, angles, [size; 2]);
        // In the middle the function itself; away from it within so much.
        for (off, error) in [(0, ERROR), (200, 0.03), (400, 0.15)] {
            let channel = lamp(&glare, size, off);
            let lamp_at = direction(angles, [(size / 2 + off) as f64, (size / 2) as f64]);
            let lamp_sr = lamp_at[2].powi(3) / (distance * distance);
            let mut worst: f64 = 0.0;
            for (x, y) in (0..size).step_by(64).flat_map(|x| (0..size).step_by(64).map(move |y| (x, y))) {
                let there = direction(angles, [x as f64, y as f64]);
                let cos: f64 = lamp_at.iter().zip(there).map(|(a, b)| a * b).sum();
                let deg = libm::acos(cos).to_degrees();
                if !(3.0..30.0).contains(&deg) {
                    continue;
                }
                let exact = vos_glare(deg, 70.0, 0.5) / vos_glare_integral(70.0, 0.5);
                let found = f64::from(channel[y * size + x]) / lamp_sr;
                worst = worst.max((found / exact - 1.0).abs());
            }
            assert!(worst < error, "{off}: {worst}");
        }
    }
}
