//! Environment maps: radiance by direction.

use core::f64::consts::PI;

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// An environment in equirectangular projection: linear RGB of sRGB primaries, every value finite and at
/// least 0.
///
/// Rows go from straight up (+Y) to straight down, columns once around to the right, as seen from inside:
/// the middle of the picture is −Z, its right quarter +X, its left quarter −X, its left and right edges
/// meet at +Z. This is the convention of most HDR panoramas.
///
/// ```
/// use glanz_scene::{EnvironmentMap, glam::DVec3};
///
/// // The upper row of pixels is bright.
/// let sky = EnvironmentMap { width: 2, height: 2, pixels: vec![[1.0; 3], [1.0; 3], [0.0; 3], [0.0; 3]] };
/// assert_eq!(EnvironmentMap::place(DVec3::NEG_Z), (0.5, 0.5));
/// assert!((sky.mean()[0] - 0.5).abs() < 1e-12);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EnvironmentMap {
    /// Pixels in a row; at least 1.
    pub width: usize,
    /// Rows; at least 1.
    pub height: usize,
    /// By rows from the top.
    pub pixels: Vec<[f32; 3]>,
}

impl EnvironmentMap {
    /// The unit vector towards a place of the picture: u and v from 0 to 1, to the right and down.
    pub fn direction(u: f64, v: f64) -> DVec3 {
        let (phi, theta) = ((u - 0.5) * 2.0 * PI, v * PI);
        let (ring, y) = (libm::sin(theta), libm::cos(theta));
        DVec3::new(ring * libm::sin(phi), y, -ring * libm::cos(phi))
    }

    /// The place of the picture that a direction of any length but zero sees: the inverse of
    /// [`Self::direction`]. At the poles, u is 0.5.
    pub fn place(direction: DVec3) -> (f64, f64) {
        let DVec3 { x, y, z } = direction;
        let ring = (x * x + z * z).sqrt();
        let phi = if ring > 0.0 { libm::atan2(x, -z) } else { 0.0 };
        (phi / (2.0 * PI) + 0.5, libm::atan2(ring, y) / PI)
    }

    /// The solid angle of a pixel of a row, in sr; those of all pixels add up to 4π.
    pub fn solid_angle(&self, row: usize) -> f64 {
        let edge = |row: usize| libm::cos(PI * row as f64 / self.height as f64);
        (edge(row) - edge(row + 1)) * 2.0 * PI / self.width as f64
    }

    /// The mean over all directions: what a uniform map with the same light in all would hold.
    pub fn mean(&self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (row, pixels) in self.pixels.chunks_exact(self.width).enumerate() {
            let weight = self.solid_angle(row) / (4.0 * PI);
            for pixel in pixels {
                sum.iter_mut().zip(pixel).for_each(|(sum, value)| *sum += weight * f64::from(*value));
            }
        }
        sum
    }

    /// The value in a direction of any length but zero, linear between the centres of pixels, across the
    /// seam too. Beyond the centres of the first and last row it is held.
    pub fn at(&self, direction: DVec3) -> [f64; 3] {
        let (u, v) = Self::place(direction);
        let x = u * self.width as f64 - 0.5;
        let y = (v * self.height as f64 - 0.5).clamp(0.0, (self.height - 1) as f64);
        let (left, top) = (x.floor(), y.floor());
        let column = |x: f64| x.rem_euclid(self.width as f64) as usize % self.width;
        let columns = [(column(left), 1.0 - (x - left)), (column(left + 1.0), x - left)];
        let below = (top as usize + 1).min(self.height - 1);
        let rows = [(top as usize, 1.0 - (y - top)), (below, y - top)];
        let mut sum = [0.0; 3];
        for ((row, down), (column, across)) in rows.into_iter().flat_map(|r| columns.map(|c| (r, c))) {
            let pixel = self.pixels[row * self.width + column];
            sum.iter_mut().zip(pixel).for_each(|(sum, value)| *sum += down * across * f64::from(value));
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of sines, cosines and their inverses.
    const ROUNDING: f64 = 1e-12;

    #[test]
    fn the_middle_is_ahead_and_the_right_is_to_the_right() {
        let cases = [
            ((0.5, 0.5), DVec3::NEG_Z),
            ((0.75, 0.5), DVec3::X),
            ((0.25, 0.5), DVec3::NEG_X),
            ((1.0, 0.5), DVec3::Z),
            ((0.5, 0.0), DVec3::Y),
            ((0.5, 1.0), DVec3::NEG_Y),
        ];
        for ((u, v), direction) in cases {
            assert!((EnvironmentMap::direction(u, v) - direction).length() < ROUNDING, "{u}, {v}");
        }
    }

    #[test]
    fn places_and_directions_are_inverse() {
        for (u, v) in [(0.01, 0.02), (0.3, 0.5), (0.5, 0.9), (0.77, 0.31), (0.99, 0.999)] {
            let (found_u, found_v) = EnvironmentMap::place(3.0 * EnvironmentMap::direction(u, v));
            assert!((found_u - u).abs() < ROUNDING && (found_v - v).abs() < ROUNDING, "{found_u}, {found_v}");
        }
        assert_eq!(EnvironmentMap::place(DVec3::Y), (0.5, 0.0));
    }

    fn map(width: usize, height: usize, of: impl Fn(usize, usize) -> f32) -> EnvironmentMap {
        let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        EnvironmentMap { width, height, pixels: places.map(|(x, y)| [of(x, y), 0.5, 2.0]).collect() }
    }

    #[test]
    fn solid_angles_cover_the_sphere_and_the_mean_weighs_by_them() {
        let map = map(8, 4, |_, row| if row < 2 { 1.0 } else { 0.0 });
        let whole: f64 = (0..4).map(|row| 8.0 * map.solid_angle(row)).sum();
        assert!((whole - 4.0 * PI).abs() < ROUNDING);
        for (found, expected) in map.mean().iter().zip([0.5, 0.5, 2.0]) {
            assert!((found - expected).abs() < ROUNDING, "{found}");
        }
    }

    #[test]
    fn pixels_are_met_at_their_centres_and_blend_across_the_seam() {
        let map = map(4, 2, |x, y| (x + 4 * y) as f32);
        for (x, y) in [(0, 0), (3, 0), (2, 1)] {
            let (u, v) = ((x as f64 + 0.5) / 4.0, (y as f64 + 0.5) / 2.0);
            let found = map.at(EnvironmentMap::direction(u, v));
            assert!((found[0] - (x + 4 * y) as f64).abs() < ROUNDING, "{x}, {y}: {found:?}");
        }
        let seam = map.at(EnvironmentMap::direction(0.0, 0.25))[0];
        assert!((seam - 1.5).abs() < ROUNDING, "between 3 and 0: {seam}");
        assert!((map.at(DVec3::Y)[0] - 1.5).abs() < ROUNDING, "the top row is held");
    }
}
