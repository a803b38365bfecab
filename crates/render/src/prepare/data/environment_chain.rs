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
        let first = &neighbors[numbers[0] as usize % WIDTHS];
        // Mostly all lanes look at the same levels.
        let is_one = numbers[..R::LANES].iter().all(|number| *number == numbers[0]);
        let (low, high, t) = if is_one {
            let level = |number: usize| LevelLanes::of(like, &self.levels[number]);
            let t = (place - like.lit(f64::from(first.place))) * like.lit(f64::from(first.scale));
            (level(first.low), level(first.high), t)
        } else {
            let (mut from, mut scale) = ([0.0; 16], [0.0; 16]);
            let (mut low, mut high) = ([first.low; 16], [first.high; 16]);
            for lane in 0..R::LANES {
                let own = &neighbors[numbers[lane] as usize % WIDTHS];
                (low[lane], high[lane]) = (own.low, own.high);
                (from[lane], scale[lane]) = (own.place, own.scale);
            }
            let t = (place - like.with_array(&from)) * like.with_array(&scale);
            (LevelLanes::each(like, &self.levels, &low), LevelLanes::each(like, &self.levels, &high), t)
        };
        let t = t.to_array();
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
}

impl ChainLevel {
    /// Pixels from row to row.
    #[inline(always)]
    pub fn stride(&self) -> usize {
        self.width + 2
    }
}

/// The levels of all lanes.
struct LevelLanes<R> {
    width: R,
    height: R,
    first: [i32; 16],
    stride: [i32; 16],
}

/// Where all lanes look.
struct Corners {
    /// The pixel above on the left, and the one below it.
    upper: [i32; 16],
    lower: [i32; 16],
    x: [f32; 16],
    y: [f32; 16],
}

impl<R: Real> LevelLanes<R> {
    /// The same for all.
    #[inline(always)]
    fn of(like: R, level: &ChainLevel) -> Self {
        Self {
            width: like.lit(level.width as f64),
            height: like.lit(level.height as f64),
            first: [level.first as i32; 16],
            stride: [level.stride() as i32; 16],
        }
    }

    #[inline(always)]
    fn each(like: R, levels: &[ChainLevel], numbers: &[usize; 16]) -> Self {
        let (mut width, mut height) = ([0.0; 16], [0.0; 16]);
        let (mut first, mut stride) = ([0; 16], [0; 16]);
        for lane in 0..R::LANES {
            let level = &levels[numbers[lane]];
            (width[lane], height[lane]) = (level.width as f32, level.height as f32);
            (first[lane], stride[lane]) = (level.first as i32, level.stride() as i32);
        }
        Self { width: like.with_array(&width), height: like.with_array(&height), first, stride }
    }

    /// The corners around fractions of the way around and down.
    #[inline(always)]
    fn place(&self, around: R, down: R) -> Corners {
        let half = around.lit(0.5);
        let (width, height) = (self.width, self.height);
        // What is no number becomes the first pixel.
        let x = (around * width + half).max(around.zero()).min(width + half);
        let y = (down * height - half).max(around.zero()).min(height - around.one());
        let ((columns, whole_x), (rows, whole_y)) = (x.whole(), y.whole());
        let (mut upper, mut lower) = ([0; 16], [0; 16]);
        for lane in 0..R::LANES {
            upper[lane] = self.first[lane] + rows[lane] * self.stride[lane] + columns[lane];
            lower[lane] = upper[lane] + self.stride[lane];
        }
        Corners { upper, lower, x: (x - whole_x).to_array(), y: (y - whole_y).to_array() }
    }
}

impl Corners {
    /// The value of a lane, linear between the centres of pixels.
    #[inline(always)]
    fn value(&self, pixels: &[[f32; 4]], lane: usize) -> [f32; 4] {
        let (upper, lower) = (self.upper[lane] as usize, self.lower[lane] as usize);
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
