//! One channel of a picture, and rows of work on it.

use glanz_math::{SimdLevel, at_level};

/// One channel: values in rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plane {
    /// The width of rows, margins included.
    pub width: usize,
    /// The number of rows, margins included.
    pub height: usize,
    /// How many pixels on each side are beyond the picture's edge; an even number.
    pub margin: usize,
    pub values: Vec<f32>,
}

impl Plane {
    /// A channel of a picture.
    pub(crate) fn of(values: Vec<f32>, width: usize) -> Self {
        Self { width, height: values.len() / width.max(1), margin: 0, values }
    }

    /// One without light.
    pub(crate) fn zero(width: usize, height: usize, margin: usize) -> Self {
        Self { width, height, margin, values: vec![0.0; width * height] }
    }

    /// A row, counted with the margin; beyond the edges the nearest.
    pub(crate) fn row(&self, y: isize) -> &[f32] {
        let y = y.clamp(0, self.height as isize - 1) as usize;
        &self.values[y * self.width..(y + 1) * self.width]
    }
}

/// Calls `work` with parts of three channels, the same pixels of each, in parallel where the feature `rayon` is on.
pub(crate) fn for_each_part_of_three(
    channels: &mut [Vec<f32>; 3],
    work: impl Fn([&mut [f32]; 3]) + Sync + Send,
) {
    const PART: usize = 1 << 13;
    let [a, b, c] = channels;
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let parts = (a.par_chunks_mut(PART), b.par_chunks_mut(PART), c.par_chunks_mut(PART));
        parts.into_par_iter().for_each(|(a, b, c)| work([a, b, c]));
    }
    #[cfg(not(feature = "rayon"))]
    for ((a, b), c) in a.chunks_mut(PART).zip(b.chunks_mut(PART)).zip(c.chunks_mut(PART)) {
        work([a, b, c]);
    }
}

/// Calls `work` with the number and the values of every channel of a frame, side by side where the feature `rayon` is on.
pub(crate) fn for_each_channel<'a>(
    channels: impl Iterator<Item = &'a mut Vec<f32>>,
    work: impl Fn(usize, &mut Vec<f32>) + Sync + Send,
) {
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let channels: Vec<_> = channels.collect();
        channels.into_par_iter().enumerate().for_each(|(c, channel)| work(c, channel));
    }
    #[cfg(not(feature = "rayon"))]
    channels.enumerate().for_each(|(c, channel)| work(c, channel));
}

/// The sum of a channel: rows one after the other, each by itself, so that the bits do not depend on threads.
pub(crate) fn sum(channel: &[f32], width: usize) -> f64 {
    let of_row =
        |row: &[f32]| -> f64 { at_level!(SimdLevel::best(), simd => { let _ = simd; sum_of_row(row) }) };
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let rows: Vec<f64> = channel.par_chunks(width).with_min_len(16).map(of_row).collect();
        rows.iter().sum()
    }
    #[cfg(not(feature = "rayon"))]
    channel.chunks(width).map(of_row).sum()
}

/// The sum of a row: eight sums side by side; what is no number counts for nothing.
#[inline(always)]
fn sum_of_row(row: &[f32]) -> f64 {
    let finite = |v: f32| if v.is_finite() { f64::from(v) } else { 0.0 };
    let (eights, rest) = row.as_chunks::<8>();
    let mut sums = [0.0; 8];
    for eight in eights {
        for i in 0..8 {
            sums[i] += finite(eight[i]);
        }
    }
    sums.iter().sum::<f64>() + rest.iter().map(|v| finite(*v)).sum::<f64>()
}

/// Calls `work` with the number and the values of every row, in parallel where the feature `rayon` is on. Rows depend on nothing but
/// their number, so that the bits do not depend on the threads.
pub(crate) fn for_each_row<T: Send>(
    values: &mut [T],
    width: usize,
    work: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    if width == 0 {
        return;
    }
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let least = (1 << 13) / width.max(1) + 1;
        values.par_chunks_mut(width).with_min_len(least).enumerate().for_each(|(y, row)| work(y, row));
    }
    #[cfg(not(feature = "rayon"))]
    values.chunks_mut(width).enumerate().for_each(|(y, row)| work(y, row));
}
