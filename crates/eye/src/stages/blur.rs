//! Gaussians on one plane, added row by row.

use super::plane::Plane;

/// A Gaussian as it is applied to a plane: along both directions by the same weights.
pub(super) struct Kernel {
    /// The weights from the middle on.
    weights: Vec<f32>,
    /// How much of the light it takes.
    share: f32,
}

/// Pixels that are summed at a time, in registers.
const BLOCK: usize = 64;

impl Kernel {
    /// One of this variance in squared pixels, with weights that sum to 1.
    pub(super) fn new(variance: f64, share: f64) -> Self {
        Self { weights: weights(variance), share: share as f32 }
    }

    /// Adds a row of the blurred plane to `row`.
    #[inline(always)]
    pub(super) fn add_row(&self, plane: &Plane, y: usize, row: &mut [f32]) {
        let radius = self.weights.len() - 1;
        let mut tall = vec![0.0; plane.width + 2 * radius];
        let at = |d: isize| plane.row(y as isize + d);
        let rows: Vec<_> = (0..=radius as isize).map(|d| (at(-d), at(d))).collect();
        for_each_block(&mut tall[radius..][..plane.width], self, &rows, |out, sum| *out = sum);
        // Beyond the edges the plane goes on as it ends.
        let [first, last] = [tall[radius], tall[radius + plane.width - 1]];
        tall[..radius].fill(first);
        tall[radius + plane.width..].fill(last);
        let columns: Vec<_> = (0..=radius).map(|d| (&tall[radius - d..], &tall[radius + d..])).collect();
        for_each_block(row, self, &columns, |out, sum| *out += self.share * sum);
    }
}

/// Calls `put` with every value of a row and the weighed sum of those as far before as behind it.
#[inline(always)]
fn for_each_block(
    row: &mut [f32],
    kernel: &Kernel,
    taps: &[(&[f32], &[f32])],
    put: impl Fn(&mut f32, f32) + Copy,
) {
    let weights = &kernel.weights;
    let mut at = 0;
    let (blocks, rest) = row.as_chunks_mut::<BLOCK>();
    for block in blocks {
        sum_block(block, weights, taps, at, put);
        at += BLOCK;
    }
    let (eights, rest) = rest.as_chunks_mut::<8>();
    for eight in eights {
        sum_block(eight, weights, taps, at, put);
        at += 8;
    }
    for one in rest {
        sum_block(std::array::from_mut(one), weights, taps, at, put);
        at += 1;
    }
}

#[inline(always)]
fn sum_block<const N: usize>(
    block: &mut [f32; N],
    weights: &[f32],
    taps: &[(&[f32], &[f32])],
    at: usize,
    put: impl Fn(&mut f32, f32),
) {
    let middle = &taps[0].0[at..][..N];
    let mut sum = [0.0; N];
    for i in 0..N {
        sum[i] = weights[0] * middle[i];
    }
    for ((before, behind), weight) in taps.iter().zip(weights).skip(1) {
        let (before, behind) = (&before[at..][..N], &behind[at..][..N]);
        for i in 0..N {
            sum[i] += weight * (before[i] + behind[i]);
        }
    }
    block.iter_mut().zip(sum).for_each(|(out, sum)| put(out, sum));
}

/// The weights of a Gaussian from its middle on: samples, of a sum of 1, whose variance is the one that is wanted.
fn weights(variance: f64) -> Vec<f32> {
    if variance < 1e-3 {
        return vec![1.0];
    }
    if variance < 0.35 {
        // Three weights: samples of a curve so narrow would not have its variance.
        let side = variance / 2.0;
        return vec![(1.0 - 2.0 * side) as f32, side as f32];
    }
    let radius = (3.5 * libm::sqrt(variance)).ceil() as usize;
    let samples: Vec<f64> = (0..=radius).map(|d| libm::exp(-((d * d) as f64) / (2.0 * variance))).collect();
    let sum = samples[0] + 2.0 * samples[1..].iter().sum::<f64>();
    samples.iter().map(|w| (w / sum) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_the_sum_pixel_by_pixel_up_to_the_edges() {
        for (width, variance) in [(1, 2.0), (7, 0.2), (63, 3.0), (64, 0.0), (150, 8.0)] {
            let height = 9;
            let values: Vec<f32> = (0..width * height).map(|i| ((i * 37) % 101) as f32 / 101.0).collect();
            let plane = Plane::of(values, width);
            let kernel = Kernel::new(variance, 0.3);
            let radius = kernel.weights.len() as isize - 1;
            for y in 0..height {
                let mut row = vec![0.5; width];
                kernel.add_row(&plane, y, &mut row);
                for (x, found) in row.iter().enumerate() {
                    let mut sum = 0.0;
                    for (dy, dx) in
                        (-radius..=radius).flat_map(|dy| (-radius..=radius).map(move |dx| (dy, dx)))
                    {
                        let x = (x as isize + dx).clamp(0, width as isize - 1) as usize;
                        let weight = |d: isize| kernel.weights[d.unsigned_abs()];
                        sum += weight(dy) * weight(dx) * plane.row(y as isize + dy)[x];
                    }
                    assert!((found - (0.5 + 0.3 * sum)).abs() < 1e-6, "{width} {x} {y}: {found} for {sum}");
                }
            }
        }
    }
}
