//! Environments as pictures that the pixel loop looks up.

use core::fmt;
use std::sync::OnceLock;

use glanz_math::{PI, Real, Vec3};

use super::EnvironmentChain;

/// The coarsest of the levels that programs see has so many rows.
const FEWEST_ROWS: usize = 2;

/// An equirectangular picture, as [`EnvironmentMap`].
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentMap {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// By rows from the top.
    pub pixels: Vec<[f32; 3]>,
    /// The same, ever coarser, made when a program first looks.
    halves: Derived<Vec<EnvironmentMap>>,
    /// The same, ever more blurred, made for the first lobe that looks it up.
    chain: Derived<EnvironmentChain>,
}

/// What follows from a map, so it is no part of what the map is.
struct Derived<T>(OnceLock<T>);

impl<T> Default for Derived<T> {
    fn default() -> Self {
        Self(OnceLock::new())
    }
}

impl<T> Clone for Derived<T> {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl<T> PartialEq for Derived<T> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<T> fmt::Debug for Derived<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Derived")
    }
}

impl From<&glanz_scene::EnvironmentMap> for EnvironmentMap {
    fn from(map: &glanz_scene::EnvironmentMap) -> Self {
        Self::of(map.width, map.height, map.pixels.clone())
    }
}

impl EnvironmentMap {
    /// A picture from its value in the direction of each pixel, a unit vector.
    pub fn from_fn(width: usize, height: usize, value: impl Fn([f64; 3]) -> [f32; 3] + Sync + Send) -> Self {
        let at = |i: usize| {
            let (column, row) = ((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
            value(
                glanz_scene::EnvironmentMap::direction(column / width as f64, row / height as f64).to_array(),
            )
        };
        Self::of(width, height, crate::parallel::collect(width * height, at))
    }

    fn of(width: usize, height: usize, pixels: Vec<[f32; 3]>) -> Self {
        Self { width, height, pixels, halves: Derived::default(), chain: Derived::default() }
    }

    /// The map at ever greater widths; none before a lobe asks for it.
    pub fn chain(&self) -> Option<&EnvironmentChain> {
        self.chain.0.get()
    }

    /// Makes the chain of widths, if there is none.
    pub(crate) fn chain_with(&self, make: impl FnOnce() -> EnvironmentChain) {
        self.chain.0.get_or_init(make);
    }

    /// Rows and columns.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// The pixel in a row and column.
    pub fn pixel(&self, row: usize, column: usize) -> [f32; 3] {
        self.pixels[row * self.width + column]
    }

    /// The unit vector in the direction of a pixel's centre.
    pub fn direction(&self, row: usize, column: usize) -> [f64; 3] {
        let (u, v) = ((column as f64 + 0.5) / self.width as f64, (row as f64 + 0.5) / self.height as f64);
        glanz_scene::EnvironmentMap::direction(u, v).to_array()
    }

    /// The solid angle of each pixel of a row.
    pub fn solid_angle(&self, row: usize) -> f64 {
        let edge = |row: usize| libm::cos(PI * row as f64 / self.height as f64);
        (edge(row) - edge(row + 1)) * 2.0 * PI / self.width as f64
    }

    /// Half as wide and high, each pixel the mean of those that it covers by their solid angles.
    pub fn halved(&self) -> Self {
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let covered =
            |i: usize, own: usize, all: usize| i * all / own..((i + 1) * all / own).max(i * all / own + 1);
        let mean = |i: usize| {
            let (mut sum, mut weight) = ([0.0; 3], 0.0);
            for row in covered(i / width, height, self.height) {
                for column in covered(i % width, width, self.width) {
                    let own = self.solid_angle(row);
                    weight += own;
                    for (sum, value) in sum.iter_mut().zip(self.pixel(row, column)) {
                        *sum += own * f64::from(value);
                    }
                }
            }
            sum.map(|sum| (sum / weight) as f32)
        };
        Self::of(width, height, crate::parallel::collect(width * height, mean))
    }

    /// This map and ever coarser ones, each half as fine as the one before.
    pub(crate) fn level(&self, level: usize) -> &Self {
        let halves = self.halves();
        level.min(halves.len()).checked_sub(1).map_or(self, |level| &halves[level])
    }

    /// How many levels there are.
    pub(crate) fn level_count(&self) -> usize {
        1 + self.halves().len()
    }

    fn halves(&self) -> &[Self] {
        self.halves.0.get_or_init(|| {
            let mut halves: Vec<Self> = Vec::new();
            while halves.last().unwrap_or(self).height > FEWEST_ROWS {
                let next = halves.last().unwrap_or(self).halved();
                halves.push(next);
            }
            halves
        })
    }

    /// The value in the direction of a unit vector, linear between the centres of pixels.
    #[inline(always)]
    pub fn at<R: Real>(&self, direction: Vec3<R>) -> [R; 3] {
        let like = direction.x;
        let around = direction.x.atan2(-direction.z) * like.lit(0.5 / PI) + like.lit(0.5);
        let down = direction.y.acos() * like.lit(1.0 / PI);
        let half = like.lit(0.5);
        let columns = (around * like.lit(self.width as f64) - half).to_array();
        let rows = (down * like.lit(self.height as f64) - half).to_array();
        let mut values = [[0.0; 16]; 3];
        for lane in 0..R::LANES {
            let value = self.between(columns[lane], rows[lane]);
            values.iter_mut().zip(value).for_each(|(array, value)| array[lane] = value);
        }
        // Not `map`, which would be a call below a SIMD dispatch.
        let [r, g, b] = &values;
        [like.with_array(r), like.with_array(g), like.with_array(b)]
    }

    /// The value at a place in pixels, 0 being the centre of the first. Around it continues, up and down it is
    /// held.
    fn between(&self, column: f32, row: f32) -> [f32; 3] {
        // A direction that is no number gives the first pixel.
        let row = Real::clamp(row, 0.0, (self.height - 1) as f64);
        let column = Real::clamp(column, -1.0, self.width as f64);
        let whole = column.floor();
        let (x, y) = (column - whole, row - row.floor());
        let left = (whole as i64).rem_euclid(self.width as i64) as usize;
        let right = if left + 1 == self.width { 0 } else { left + 1 };
        let top = row as usize;
        let bottom = (top + 1).min(self.height - 1);
        let mix = |a: [f32; 3], b: [f32; 3], t: f32| [0, 1, 2].map(|c: usize| a[c] + (b[c] - a[c]) * t);
        let upper = mix(self.pixel(top, left), self.pixel(top, right), x);
        let lower = mix(self.pixel(bottom, left), self.pixel(bottom, right), x);
        mix(upper, lower, y)
    }
}
