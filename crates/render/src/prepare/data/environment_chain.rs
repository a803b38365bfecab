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
    pub levels: Vec<ChainLevel>,
    /// Of all levels, by rows from the top; each row begins with its last pixel and ends with its first one, and the last
    /// row is there twice. The fourth value is 0.
    pub pixels: Vec<[f32; 4]>,
}

/// An equirectangular picture among the pixels of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChainLevel {
    /// Pixels in a row, without the two that are there twice.
    pub width: usize,
    /// Rows, without the one that is there twice.
    pub height: usize,
    /// Its first pixel.
    pub first: usize,
}

/// Two levels of a chain, and how places lie between them.
#[derive(Clone, Copy)]
struct Neighbors {
    low: usize,
    high: usize,
    place: f32,
    scale: f32,
}

/// The neighbours of each place, and the same a whole octave apart.
static NEIGHBORS: [[Neighbors; WIDTHS]; 2] = [neighbors(false), neighbors(true)];

const fn neighbors(wide: bool) -> [Neighbors; WIDTHS] {
    let mut all = [Neighbors { low: 0, high: 0, place: 0.0, scale: 1.0 }; WIDTHS];
    let mut place = 0;
    while place < WIDTHS {
        let step = EnvironmentChain::step(place, wide);
        let low = if step == 2 { place & !1 } else { place };
        let low = if low + step < WIDTHS { low } else { WIDTHS - 1 - step };
        all[place] = Neighbors {
            low: EnvironmentChain::number(low),
            high: EnvironmentChain::number(low + step),
            place: low as f32,
            scale: 1.0 / step as f32,
        };
        place += 1;
    }
    all
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

    /// Half octaves between the neighbours of a place.
    const fn step(place: usize, wide: bool) -> usize {
        if wide || place < Self::WHOLE_BELOW { 2 } else { 1 }
    }

    /// The number of the level at a place that is kept.
    const fn number(place: usize) -> usize {
        if place < Self::WHOLE_BELOW { place / 2 } else { place - Self::WHOLE_BELOW / 2 }
    }

    /// The two places that a place lies between, and how far it is on the way; in octaves where `wide` or fine.
    pub(crate) fn between(place: f32, wide: bool) -> ([usize; 2], f32) {
        let own = &NEIGHBORS[usize::from(wide)][place as usize];
        let step = (1.0 / own.scale) as usize;
        ([own.place as usize, own.place as usize + step], (place - own.place) * own.scale)
    }

    /// Adds the value in a direction at a place among the widths, times `amount`, to each lane's sum.
    #[inline(always)]
    pub fn add_to<R: Real>(
        &self,
        sums: &mut [[f32; 4]; 16],
        direction: Vec3<R>,
        place: R,
        amount: R,
        wide: bool,
    ) {
        let like = direction.x;
        let around = direction.x.atan2(-direction.z) * like.lit(0.5 / PI) + like.lit(0.5);
        let down = direction.y.acos() * like.lit(1.0 / PI);
        let (numbers, _) = place.clamp(0.0, Self::LAST as f64).whole();
        let neighbors = &NEIGHBORS[usize::from(wide)];
        let (mut low, mut high) = (LevelLanes::new(), LevelLanes::new());
        let (mut from, mut scale) = ([0.0; 16], [0.0; 16]);
        for lane in 0..R::LANES {
            let own = &neighbors[numbers[lane] as usize % WIDTHS];
            low.set(lane, &self.levels[own.low]);
            high.set(lane, &self.levels[own.high]);
            (from[lane], scale[lane]) = (own.place, own.scale);
        }
        let t = ((place - like.with_array(&from)) * like.with_array(&scale)).to_array();
        let (low, high) = (low.place(around, down), high.place(around, down));
        let amount = amount.to_array();
        for lane in 0..R::LANES {
            let (a, b) = (low.value(&self.pixels, lane), high.value(&self.pixels, lane));
            let (amount, t) = (amount[lane], t[lane]);
            let sum = &mut sums[lane];
            for c in 0..4 {
                sum[c] += amount * (a[c] + (b[c] - a[c]) * t);
            }
        }
    }

    /// A row of a level with its first and last pixel there twice.
    pub(crate) fn row(&self, level: &ChainLevel, row: usize) -> &[[f32; 4]] {
        let first = level.first + row * level.stride();
        &self.pixels[first..first + level.stride()]
    }
}

impl ChainLevel {
    /// Pixels from row to row.
    #[inline(always)]
    pub fn stride(&self) -> usize {
        self.width + 2
    }
}

/// The levels of all lanes.
struct LevelLanes {
    width: [f32; 16],
    height: [f32; 16],
    first: [usize; 16],
    stride: [usize; 16],
}

/// Where all lanes look.
struct Corners {
    /// The pixel above on the left, and the one below it.
    upper: [usize; 16],
    lower: [usize; 16],
    x: [f32; 16],
    y: [f32; 16],
}

impl LevelLanes {
    #[inline(always)]
    fn new() -> Self {
        Self { width: [0.0; 16], height: [0.0; 16], first: [0; 16], stride: [0; 16] }
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, level: &ChainLevel) {
        self.width[lane] = level.width as f32;
        self.height[lane] = level.height as f32;
        (self.first[lane], self.stride[lane]) = (level.first, level.stride());
    }

    /// The corners around fractions of the way around and down.
    #[inline(always)]
    fn place<R: Real>(&self, around: R, down: R) -> Corners {
        let half = around.lit(0.5);
        let (width, height) = (around.with_array(&self.width), around.with_array(&self.height));
        // What is no number becomes the first pixel.
        let x = (around * width + half).max(around.zero()).min(width + half);
        let y = (down * height - half).max(around.zero()).min(height - around.one());
        let ((columns, whole_x), (rows, whole_y)) = (x.whole(), y.whole());
        let (mut upper, mut lower) = ([0; 16], [0; 16]);
        for lane in 0..R::LANES {
            upper[lane] = self.first[lane] + rows[lane] as usize * self.stride[lane] + columns[lane] as usize;
            lower[lane] = upper[lane] + self.stride[lane];
        }
        Corners { upper, lower, x: (x - whole_x).to_array(), y: (y - whole_y).to_array() }
    }
}

impl Corners {
    /// The value of a lane, linear between the centres of pixels.
    #[inline(always)]
    fn value(&self, pixels: &[[f32; 4]], lane: usize) -> [f32; 4] {
        let (upper, lower) = (self.upper[lane], self.lower[lane]);
        let (upper, lower) = (&pixels[upper..upper + 2], &pixels[lower..lower + 2]);
        let (x, y) = (self.x[lane], self.y[lane]);
        let mut value = [0.0; 4];
        for c in 0..4 {
            let a = upper[0][c] + (upper[1][c] - upper[0][c]) * x;
            let b = lower[0][c] + (lower[1][c] - lower[0][c]) * x;
            value[c] = a + (b - a) * y;
        }
        value
    }
}
