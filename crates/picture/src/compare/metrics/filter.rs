//! Separable filters with repeated edges.

use core::ops::{Add, Mul, Sub};

use crate::compare::rows::for_each_row;

/// What is filtered.
pub(crate) trait Sample:
    Copy + Default + Send + Sync + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl Sample for f32 {}
impl Sample for f64 {}

/// One direction of a filter: an odd number of weights around the middle.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kernel<T> {
    weights: Vec<T>,
    from_middle: bool,
}

impl<T: Sample> Kernel<T> {
    /// A kernel of these weights.
    pub(crate) fn new(weights: Vec<T>) -> Self {
        assert!(weights.len() % 2 == 1, "a kernel has a middle");
        Self { weights, from_middle: false }
    }

    /// A kernel whose weights sum to zero. It is applied to the differences from the middle, which is the
    /// same sum but exactly zero where nothing changes.
    pub(crate) fn of_differences(weights: Vec<T>) -> Self {
        Self { from_middle: true, ..Self::new(weights) }
    }

    /// Samples on either side of the middle.
    pub(crate) fn radius(&self) -> usize {
        self.weights.len() / 2
    }

    /// The sum for the sample at `middle`, with the neighbours by `at`.
    #[inline]
    fn apply(&self, middle: T, at: impl Fn(usize) -> T) -> T {
        let base = if self.from_middle { middle } else { T::default() };
        self.weights
            .iter()
            .enumerate()
            .fold(T::default(), |sum, (tap, &weight)| sum + weight * (at(tap) - base))
    }
}

/// The plane filtered with `down` along the columns, then with `across` along the rows.
pub(crate) fn filter<T: Sample>(plane: &[T], width: usize, across: &Kernel<T>, down: &Kernel<T>) -> Vec<T> {
    filter_across(&filter_down(plane, width, down), width, across)
}

/// The same with the rows first: zero-sum kernels go last, so that they meet smooth values.
pub(crate) fn filter_rows_first<T: Sample>(
    plane: &[T],
    width: usize,
    across: &Kernel<T>,
    down: &Kernel<T>,
) -> Vec<T> {
    filter_down(&filter_across(plane, width, across), width, down)
}

fn filter_across<T: Sample>(plane: &[T], width: usize, kernel: &Kernel<T>) -> Vec<T> {
    let mut out = vec![T::default(); plane.len()];
    let radius = kernel.radius();
    for_each_row(&mut out, width, |y, row| {
        let from = &plane[y * width..][..width];
        let mut padded = vec![from[0]; radius];
        padded.extend_from_slice(from);
        padded.resize(width + 2 * radius, from[width - 1]);
        for (x, out) in row.iter_mut().enumerate() {
            *out = kernel.apply(padded[x + radius], |tap| padded[x + tap]);
        }
    });
    out
}

fn filter_down<T: Sample>(plane: &[T], width: usize, kernel: &Kernel<T>) -> Vec<T> {
    let mut out = vec![T::default(); plane.len()];
    if width == 0 {
        return out;
    }
    let last = plane.len() / width - 1;
    for_each_row(&mut out, width, |y, row| {
        let line = |y: usize| &plane[y * width..][..width];
        let middle = line(y);
        for (tap, &weight) in kernel.weights.iter().enumerate() {
            let from = line((y + tap).saturating_sub(kernel.radius()).min(last));
            if kernel.from_middle {
                for ((out, &from), &middle) in row.iter_mut().zip(from).zip(middle) {
                    *out = *out + weight * (from - middle);
                }
            } else {
                for (out, &from) in row.iter_mut().zip(from) {
                    *out = *out + weight * from;
                }
            }
        }
    });
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_repeated() {
        let plane = [1.0, 2.0, 4.0, 10.0, 20.0, 40.0];
        let (one, mean) = (Kernel::new(vec![1.0]), Kernel::new(vec![1.0, 1.0, 1.0]));
        assert_eq!(filter(&plane, 3, &mean, &one), [4.0, 7.0, 10.0, 40.0, 70.0, 100.0]);
        assert_eq!(filter(&plane, 3, &one, &mean), [12.0, 24.0, 48.0, 21.0, 42.0, 84.0]);
    }

    #[test]
    fn weights_are_not_mirrored() {
        let (one, next) = (Kernel::new(vec![1.0_f32]), Kernel::new(vec![0.0, 0.0, 1.0]));
        assert_eq!(filter(&[1.0, 2.0, 3.0], 3, &next, &one), [2.0, 3.0, 3.0]);
        assert_eq!(filter_rows_first(&[1.0, 2.0, 3.0], 1, &one, &next), [2.0, 3.0, 3.0]);
    }

    #[test]
    fn both_orders_and_both_sums_agree() {
        let plane: Vec<f64> = (0..35).map(|i| f64::from(i * i % 17)).collect();
        let (smooth, slope) = (Kernel::new(vec![0.25, 0.5, 0.25]), vec![-0.5, -0.25, 0.0, 0.25, 0.5]);
        let (plain, careful) = (Kernel::new(slope.clone()), Kernel::of_differences(slope));
        let expected = filter(&plane, 7, &plain, &smooth);
        for found in [filter(&plane, 7, &careful, &smooth), filter_rows_first(&plane, 7, &careful, &smooth)] {
            assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-12));
        }
    }

    #[test]
    fn a_kernel_of_differences_is_zero_where_nothing_changes() {
        let third = 1.0 / 3.0;
        let kernel = Kernel::of_differences(vec![-0.3_f32, 0.1, 0.2]);
        let smooth = Kernel::new(vec![third, third, third]);
        assert!(filter(&[0.7; 12], 4, &kernel, &smooth).iter().all(|v| *v == 0.0));
        assert!(filter_rows_first(&[0.7; 12], 4, &smooth, &kernel).iter().all(|v| *v == 0.0));
    }

    #[test]
    fn a_kernel_may_be_wider_than_the_picture() {
        let wide = Kernel::new(vec![1.0_f32; 9]);
        assert_eq!(filter(&[1.0, 2.0], 1, &wide, &wide), [9.0 * (5.0 + 8.0), 9.0 * (4.0 + 10.0)]);
    }
}
