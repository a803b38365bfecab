//! Details that an eye does not resolve: at little light, and away from where it looks.

use super::plane::{Plane, for_each_row};
use super::pyramid::{Blur, MARGIN, blurred, double_blended, halved, next_size};
use crate::curves::{acuity_cutoff, acuity_cutoff_at, blur_sigma_deg};

/// How angles belong to pixels.
///
/// ```
/// use glanz_eye::Angles;
///
/// // A camera 500 pixels before a picture of 1000: 90° across.
/// let wide = Angles { px_per_deg: 500_f64.to_radians(), distance_px: Some(500.0), middle: [500.0, 500.0] };
/// assert!((wide.between([0.0, 500.0], [1000.0, 500.0]) - 90.0).abs() < 1e-9);
/// let screen = Angles { px_per_deg: 40.0, distance_px: None, middle: [500.0, 500.0] };
/// assert_eq!(screen.between([0.0, 500.0], [1000.0, 500.0]), 25.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// Pixels per degree at the middle of the picture.
    pub px_per_deg: f64,
    /// The distance of the picture from the eye in pixels, where a perspective camera looks: angles are between rays.
    pub distance_px: Option<f64>,
    /// The middle of the picture.
    pub middle: [f64; 2],
}

impl Angles {
    /// The angle between two pixels in degrees.
    pub fn between(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let Some(distance) = self.distance_px else {
            let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
            return libm::sqrt(dx * dx + dy * dy) / self.px_per_deg;
        };
        let ray = |p: [f64; 2]| [p[0] - self.middle[0], p[1] - self.middle[1], distance];
        let (a, b) = (ray(a), ray(b));
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let cos = dot(a, b) / libm::sqrt(dot(a, a) * dot(b, b));
        libm::acos(cos.clamp(-1.0, 1.0)).to_degrees()
    }
}

/// What is lost.
pub(crate) enum Acuity {
    /// The same everywhere: a Gaussian of this σ in pixels.
    Everywhere(f64),
    /// More, the farther from where the eye looks: how every place of each level goes on to the next one.
    Around(Vec<Onward>),
}

/// Levels beyond which nothing gets blurrier: 2^9 pixels.
const MOST_LEVELS: usize = 9;

impl Acuity {
    /// At an adapting luminance, of pictures of a size; none where they have no detail that is lost.
    pub(crate) fn new(
        luminance: f64,
        gaze: Option<[f64; 2]>,
        angles: Angles,
        size: [usize; 2],
    ) -> Option<Self> {
        match gaze {
            Some(gaze) => Some(Self::Around(SigmaTable { gaze, angles, luminance }.levels(size))),
            None => {
                let sigma = sigma_px(acuity_cutoff(luminance), angles.px_per_deg);
                (sigma > 0.0).then_some(Self::Everywhere(sigma))
            }
        }
    }

    pub(crate) fn apply(&self, channel: &mut Vec<f32>, width: usize) {
        if channel.is_empty() {
            return;
        }
        let plane = Plane::of(std::mem::take(channel), width);
        *channel = match self {
            Self::Everywhere(sigma_px) => {
                blurred(plane, 0.0, &[Blur { weight: 1.0, sigma_px: *sigma_px }], None).values
            }
            Self::Around(levels) => around(plane, levels).values,
        };
    }
}

/// The σ in pixels of what is left of a cutoff in cycles per degree; 0 where the pixels themselves are coarser.
fn sigma_px(cutoff: f64, px_per_deg: f64) -> f64 {
    match cutoff < 0.5 * px_per_deg {
        true => blur_sigma_deg(cutoff) * px_per_deg,
        false => 0.0,
    }
}

/// The variance of the blur over the picture.
struct SigmaTable {
    gaze: [f64; 2],
    angles: Angles,
    luminance: f64,
}

impl SigmaTable {
    /// How places go on from each level to the next one, as far as anything of a picture of this size does.
    fn levels(&self, size: [usize; 2]) -> Vec<Onward> {
        let [width, height] = size.map(|size| size as f64);
        let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        let most = corners.map(|corner| self.variance(corner)).into_iter().fold(0.0, f64::max);
        let levels = (0..MOST_LEVELS).find(|level| of_level(*level) >= most).unwrap_or(MOST_LEVELS);
        let sizes = std::iter::successors(Some((size, 0)), |(size, margin)| {
            Some((next_size(*size, *margin), MARGIN))
        });
        (0..levels).zip(sizes).map(|(level, (size, margin))| Onward::new(self, level, size, margin)).collect()
    }

    /// The variance of the blur at a place, in squared pixels.
    fn variance(&self, at: [f64; 2]) -> f64 {
        let eccentricity = self.angles.between(at, self.gaze);
        let sigma = sigma_px(acuity_cutoff_at(self.luminance, eccentricity), self.angles.px_per_deg);
        sigma * sigma
    }

    /// How far a place of a level goes on to the next one, from 0 to 1.
    fn onward(&self, level: usize, at: [f64; 2]) -> f32 {
        let (here, next) = (of_level(level), of_level(level + 1));
        ((self.variance(at) - here) / (next - here)).clamp(0.0, 1.0) as f32
    }
}

/// The variance in squared pixels of going down to a level and up again.
fn of_level(level: usize) -> f64 {
    0.5 * (libm::exp2(2.0 * level as f64) - 1.0)
}

/// A plane, blended with the next levels as they say.
fn around(plane: Plane, levels: &[Onward]) -> Plane {
    let Some((onward, next)) = levels.split_first() else { return plane };
    let coarse = around(halved(&plane), next);
    double_blended(plane, &coarse, |y, row| onward.row(y, row))
}

/// How every place of a level goes on, on a grid of every eighth pixel, between which it is linear.
pub(crate) struct Onward {
    columns: usize,
    values: Vec<f32>,
}

/// Pixels between the places of the grid.
const GRID: usize = 8;

impl Onward {
    fn new(table: &SigmaTable, level: usize, [width, height]: [usize; 2], margin: usize) -> Self {
        let (columns, rows) = (width / GRID + 2, height / GRID + 2);
        let (scale, margin) = (libm::exp2(level as f64), margin as f64);
        let mut values = vec![0.0; columns * rows];
        for_each_row(&mut values, columns, |y, row| {
            for (x, value) in row.iter_mut().enumerate() {
                let at = [x, y].map(|i| ((i * GRID) as f64 - margin + 0.5) * scale);
                *value = table.onward(level, at);
            }
        });
        Self { columns, values }
    }

    fn row(&self, y: usize, row: &mut [f32]) {
        let (cell, part) = (y / GRID, (y % GRID) as f32 / GRID as f32);
        let upper = &self.values[cell * self.columns..][..self.columns];
        let lower = &self.values[(cell + 1) * self.columns..][..self.columns];
        let tall: Vec<f32> = upper.iter().zip(lower).map(|(a, b)| a + part * (b - a)).collect();
        for (cell, values) in row.chunks_mut(GRID).enumerate() {
            let (from, step) = (tall[cell], (tall[cell + 1] - tall[cell]) / GRID as f32);
            for (x, value) in values.iter_mut().enumerate() {
                *value = from + step * x as f32;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn angles() -> Angles {
        Angles { px_per_deg: 60.0, distance_px: None, middle: [160.0, 120.0] }
    }

    /// A picture of stripes of 4 pixels.
    fn stripes() -> Vec<f32> {
        (0..320 * 240).map(|i| if (i % 320) / 2 % 2 == 0 { 1.0 } else { 0.0 }).collect()
    }

    fn contrast(channel: &[f32], x: usize) -> f32 {
        let row = &channel[120 * 320 + x..][..8];
        row.iter().fold(0.0_f32, |a, b| a.max(*b)) - row.iter().fold(1.0_f32, |a, b| a.min(*b))
    }

    #[test]
    fn details_are_lost_away_from_the_gaze() {
        let mut channel = stripes();
        Acuity::new(1000.0, Some([20.0, 120.0]), angles(), [320, 240]).unwrap().apply(&mut channel, 320);
        assert!(contrast(&channel, 16) > 0.9, "{}", contrast(&channel, 16));
        assert!(contrast(&channel, 300) < 0.3, "{}", contrast(&channel, 300));
        assert!(contrast(&channel, 200) > contrast(&channel, 300));
    }

    #[test]
    fn a_tenth_is_left_of_a_grating_at_the_cutoff() {
        // 1 cd/m²: 31 cycles per degree; pixels of 1/128 of a degree show them.
        let (width, luminance) = (4096, 1.0);
        let angles = Angles { px_per_deg: 128.0, ..angles() };
        let cutoff = acuity_cutoff(luminance);
        let wave = |x: usize| 0.5 + 0.5 * libm::cos(core::f64::consts::TAU * cutoff * x as f64 / 128.0);
        let mut channel: Vec<f32> = (0..width * 3).map(|i| wave(i % width) as f32).collect();
        Acuity::new(luminance, None, angles, [width, 3]).unwrap().apply(&mut channel, width);
        let inside = &channel[width + 100..2 * width - 100];
        let most = inside.iter().fold(0.0_f32, |a, b| a.max(*b));
        let least = inside.iter().fold(1.0_f32, |a, b| a.min(*b));
        assert!(((most - least) - 0.1).abs() < 0.01, "{}", most - least);
    }

    #[test]
    fn by_day_a_screen_shows_no_more_than_the_eye_resolves() {
        assert!(Acuity::new(1000.0, None, angles(), [320, 240]).is_none());
        assert!(Acuity::new(0.01, None, angles(), [320, 240]).is_some());
    }

    #[test]
    fn uniform_light_stays_uniform() {
        for gaze in [None, Some([10.0, 200.0])] {
            let mut channel = vec![0.3; 321 * 201];
            if let Some(acuity) = Acuity::new(0.01, gaze, angles(), [321, 201]) {
                acuity.apply(&mut channel, 321);
            }
            assert!(channel.iter().all(|v| (v - 0.3).abs() < 1e-6));
        }
    }

    #[test]
    fn angles_of_a_camera_are_between_rays() {
        let camera = Angles { px_per_deg: 10.0, distance_px: Some(100.0), middle: [50.0, 50.0] };
        assert!((camera.between([150.0, 50.0], [50.0, 50.0]) - 45.0).abs() < 1e-9);
        assert!((camera.between([150.0, 50.0], [-50.0, 50.0]) - 90.0).abs() < 1e-9);
    }
}
