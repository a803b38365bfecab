//! An environment at ever greater widths, which all glossy lobes look up.

use glanz_math::{PI, Real, Vec3};

/// The widths: half octaves from [`EnvironmentChain::NARROWEST`], of which the odd ones below
/// [`EnvironmentChain::WHOLE_BELOW`] are left out.
const WIDTHS: usize = 17;

/// An environment blurred by kernels of a row of widths, and linear between them.
///
/// The kernel of width σ is (1 − r² / 10 σ²)³ over the chord r, 0 beyond: its variance along each of two directions is
/// that of a Gaussian of standard deviation σ, and its tails are lighter, so that a mean of two neighbours is nearly
/// the kernel of a width between.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentChain {
    /// From the narrowest to the widest; the first is the map itself, no finer than that width asks for.
    pub levels: Vec<BlurredMap>,
}

/// An equirectangular picture whose edges are there twice, so that no reader has to go around.
#[derive(Clone, Debug, PartialEq)]
pub struct BlurredMap {
    /// Pixels in a row, without what is there twice.
    pub width: usize,
    /// Rows, without the one that is there twice.
    pub height: usize,
    /// By rows from the top; each begins with its last pixel and ends with its first one, and the last row is there
    /// twice. The fourth value is 0.
    pub pixels: Vec<[f32; 4]>,
}

impl EnvironmentChain {
    /// The least standard deviation, in radians.
    pub const NARROWEST: f64 = 0.003;
    /// Below this place whole octaves are kept alone.
    pub const WHOLE_BELOW: usize = 6;
    /// The place of the widest level.
    pub const LAST: usize = WIDTHS - 1;

    /// The places that levels are kept of, in half octaves.
    pub fn places() -> impl Iterator<Item = usize> {
        (0..WIDTHS).filter(|place| *place >= Self::WHOLE_BELOW || place % 2 == 0)
    }

    /// The standard deviation at a place, in radians.
    pub fn width(place: f64) -> f64 {
        Self::NARROWEST * libm::exp2(0.5 * place)
    }

    /// The two places that a place lies between, and how far it is on the way; in octaves where `wide` or fine.
    #[inline(always)]
    pub fn between(place: f32, wide: bool) -> ([usize; 2], f32) {
        let whole = place as usize;
        let (whole, step) = match wide || whole < Self::WHOLE_BELOW {
            true => (whole & !1, 2),
            false => (whole, 1),
        };
        let whole = whole.min(Self::LAST - step);
        ([whole, whole + step], (place - whole as f32) / step as f32)
    }

    /// The number of the level at a place that is kept.
    #[inline(always)]
    pub fn number(place: usize) -> usize {
        if place < Self::WHOLE_BELOW { place / 2 } else { place - Self::WHOLE_BELOW / 2 }
    }

    /// Adds the value in a direction at a place among the widths, times `amount`, to each lane's sum.
    #[inline(always)]
    pub fn add_to<R: Real>(&self, sums: &mut [[f32; 4]; 16], direction: Vec3<R>, place: R, amount: R, wide: bool) {
        let like = direction.x;
        let around = (direction.x.atan2(-direction.z) * like.lit(0.5 / PI) + like.lit(0.5)).to_array();
        let down = (direction.y.acos() * like.lit(1.0 / PI)).to_array();
        let (place, amount) = (place.to_array(), amount.to_array());
        for lane in 0..R::LANES {
            let ([low, high], t) = Self::between(place[lane], wide);
            let (low, high) = (&self.levels[Self::number(low)], &self.levels[Self::number(high)]);
            let (low, high) = (low.at(around[lane], down[lane]), high.at(around[lane], down[lane]));
            let (sum, amount) = (&mut sums[lane], amount[lane]);
            for c in 0..4 {
                sum[c] += amount * (low[c] + (high[c] - low[c]) * t);
            }
        }
    }
}

impl BlurredMap {
    /// The value at fractions of the way around and down, linear between the centres of pixels.
    #[inline(always)]
    fn at(&self, around: f32, down: f32) -> [f32; 4] {
        // What is no number becomes the first pixel.
        let x = (around * self.width as f32 + 0.5).max(0.0).min(self.width as f32 + 0.5);
        let y = (down * self.height as f32 - 0.5).max(0.0).min((self.height - 1) as f32);
        let (column, row) = (x as usize, y as usize);
        let (x, y) = (x - column as f32, y - row as f32);
        let stride = self.width + 2;
        let first = row * stride + column;
        let upper: &[[f32; 4]; 2] = self.pixels[first..first + 2].try_into().unwrap_or(&[[0.0; 4]; 2]);
        let lower: &[[f32; 4]; 2] =
            self.pixels[first + stride..first + stride + 2].try_into().unwrap_or(&[[0.0; 4]; 2]);
        let mut value = [0.0; 4];
        for c in 0..4 {
            let a = upper[0][c] + (upper[1][c] - upper[0][c]) * x;
            let b = lower[0][c] + (lower[1][c] - lower[0][c]) * x;
            value[c] = a + (b - a) * y;
        }
        value
    }

    /// A row with its first and last pixel there twice.
    pub(crate) fn row(&self, row: usize) -> &[[f32; 4]] {
        let stride = self.width + 2;
        &self.pixels[row * stride..(row + 1) * stride]
    }
}
