//! Work on readings, block by block.
//!
//! Sums are formed within blocks and then over them, in order: they are the same bits for any number of threads.

use core::ops::Range;

/// Readings of a block: a few rows of so many numbers stay in the nearest cache.
pub(super) const BLOCK: usize = 1024;

/// Fewer blocks are done by one thread: to wake others takes longer.
#[cfg(feature = "rayon")]
const PARALLEL: usize = 64;

fn block(len: usize, number: usize) -> Range<usize> {
    number * BLOCK..((number + 1) * BLOCK).min(len)
}

/// What a function gives for each block, in order.
pub(super) fn map<T: Send>(len: usize, work: impl Fn(Range<usize>) -> T + Sync + Send) -> Vec<T> {
    let count = len.div_ceil(BLOCK);
    #[cfg(feature = "rayon")]
    if count >= PARALLEL {
        use rayon::prelude::*;
        return (0..count).into_par_iter().with_min_len(8).map(|number| work(block(len, number))).collect();
    }
    (0..count).map(|number| work(block(len, number))).collect()
}

/// Numbers, one for each reading, of a function that fills those of a block.
pub(super) fn fill(len: usize, work: impl Fn(Range<usize>, &mut [f64]) + Sync + Send) -> Vec<f64> {
    let mut out = vec![0.0; len];
    #[cfg(feature = "rayon")]
    if len >= PARALLEL * BLOCK {
        use rayon::prelude::*;
        let blocks = out.par_chunks_mut(BLOCK).with_min_len(8).enumerate();
        blocks.for_each(|(number, part)| work(block(len, number), part));
        return out;
    }
    out.chunks_mut(BLOCK).enumerate().for_each(|(number, part)| work(block(len, number), part));
    out
}

/// The sum of products, in eight sums side by side, which become vector instructions.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let ((a, rest_a), (b, rest_b)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    for (a, b) in a.iter().zip(b) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_rows_of_any_length_are_summed() {
        for n in [0, 1, 7, 8, 13, 100] {
            let row: Vec<f64> = (0..n).map(f64::from).collect();
            let expected = f64::from(n * (n - 1) * (2 * n - 1) / 6);
            assert_eq!(dot(&row, &row), expected, "{n}");
        }
    }

    #[test]
    fn blocks_cover_all_readings_once() {
        for len in [0, 1, BLOCK, BLOCK + 1, 70 * BLOCK + 3] {
            let parts = map(len, |range| range);
            assert_eq!(parts.iter().map(|range| range.len()).sum::<usize>(), len);
            let filled = fill(len, |range, out| {
                out.iter_mut().zip(range).for_each(|(out, i)| *out += i as f64);
            });
            assert!(filled.iter().enumerate().all(|(i, value)| *value == i as f64));
        }
    }
}
