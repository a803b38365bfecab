//! Details that an eye does not resolve: at little light, and away from where it looks.

use super::plane::{Plane, for_each_row};
use super::pyramid::{Blur, blurred, double_blended, halved};
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
    /// More, the farther from where the eye looks.
    Around { gaze: [f64; 2], angles: Angles, luminance: f64 },
}

/// Levels beyond which nothing gets blurrier: 2^9 pixels.
const MOST_LEVELS: usize = 9;

impl Acuity {
    /// At an adapting luminance; none where the picture has no detail that is lost.
    pub(crate) fn new(luminance: f64, gaze: Option<[f64; 2]>, angles: Angles) -> Option<Self> {
        match gaze {
            Some(gaze) => Some(Self::Around { gaze, angles, luminance }),
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
        let height = plane.height;
        *channel = match self {
            Self::Everywhere(sigma_px) => {
                blurred(plane, 0.0, &[Blur { weight: 1.0, sigma_px: *sigma_px }], None).values
            }
            Self::Around { gaze, angles, luminance } => {
                let table = SigmaTable::new(*luminance, *angles, *gaze, [width, height]);
                around(plane, 0, &table).values
            }
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

/// The variance of the blur by the squared distance from the gaze, over the picture.
struct SigmaTable {
    gaze: [f64; 2],
    angles: Angles,
    luminance: f64,
    levels: usize,
}

impl SigmaTable {
    fn new(luminance: f64, angles: Angles, gaze: [f64; 2], [width, height]: [usize; 2]) -> Self {
        let mut table = Self { gaze, angles, luminance, levels: MOST_LEVELS };
        let corners = [[0.0, 0.0], [width as f64, 0.0], [0.0, height as f64], [width as f64, height as f64]];
        let most = corners.map(|corner| table.variance(corner)).into_iter().fold(0.0, f64::max);
        table.levels = (0..MOST_LEVELS).find(|level| of_level(*level) >= most).unwrap_or(MOST_LEVELS);
        table
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

/// A plane at a level, blended with the next ones as the table has it.
fn around(plane: Plane, level: usize, table: &SigmaTable) -> Plane {
    if level >= table.levels {
        return plane;
    }
    let coarse = around(halved(&plane), level + 1, table);
    let scale = libm::exp2(level as f64);
    let onward = Onward::new(table, level, scale, &plane);
    double_blended(plane, &coarse, |y, row| onward.row(y, row))
}

/// How every place of a level goes on, on a grid of every eighth pixel, between which it is linear.
struct Onward {
    columns: usize,
    values: Vec<f32>,
}

/// Pixels between the places of the grid.
const GRID: usize = 8;

impl Onward {
    fn new(table: &SigmaTable, level: usize, scale: f64, plane: &Plane) -> Self {
        let (columns, rows) = (plane.width / GRID + 2, plane.height / GRID + 2);
        let margin = plane.margin as f64;
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
        Acuity::new(1000.0, Some([20.0, 120.0]), angles()).unwrap().apply(&mut channel, 320);
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
        Acuity::new(luminance, None, angles).unwrap().apply(&mut channel, width);
        let inside = &channel[width + 100..2 * width - 100];
        let most = inside.iter().fold(0.0_f32, |a, b| a.max(*b));
        let least = inside.iter().fold(1.0_f32, |a, b| a.min(*b));
        assert!(((most - least) - 0.1).abs() < 0.01, "{}", most - least);
    }

    #[test]
    fn by_day_a_screen_shows_no_more_than_the_eye_resolves() {
        assert!(Acuity::new(1000.0, None, angles()).is_none());
        assert!(Acuity::new(0.01, None, angles()).is_some());
    }

    #[test]
    fn uniform_light_stays_uniform() {
        for gaze in [None, Some([10.0, 200.0])] {
            let mut channel = vec![0.3; 321 * 201];
            if let Some(acuity) = Acuity::new(0.01, gaze, angles()) {
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
