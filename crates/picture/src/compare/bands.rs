//! Maps made in bands of rows, so that what filters hold at once does not grow with the height of the picture.

use core::ops::Range;

/// Rows of a band, at least; with wide filters it has more, so that most of its rows are of use.
const ROWS: usize = 256;

/// The map of `height` rows of `width` values, of which each band is what `map` gives for its rows. Values depend on rows up to
/// `margin` away, which each band gets too; the first and the last row of the picture are the edges that filters see.
pub(super) fn in_bands(
    width: usize,
    height: usize,
    margin: usize,
    map: impl Fn(Range<usize>) -> Vec<f32>,
) -> Vec<f32> {
    let rows = ROWS.max(4 * margin);
    let mut whole = Vec::with_capacity(width * height);
    for first in (0..height).step_by(rows) {
        let last = (first + rows).min(height);
        let from = first.saturating_sub(margin);
        let band = map(from..(last + margin).min(height));
        whole.extend_from_slice(&band[(first - from) * width..][..(last - first) * width]);
    }
    whole
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_make_the_map_that_all_rows_at_once_make() {
        let source: Vec<f32> = (0..3 * 1000).map(|i| (i * 37 % 101) as f32).collect();
        // The mean with the rows three above and below, the picture's own edges being repeated.
        let map = |rows: Range<usize>| -> Vec<f32> {
            let own = &source[rows.start * 3..rows.end * 3];
            let at = |y: usize, x: usize| own[y * 3 + x];
            let mean = |i: usize| {
                let (y, x) = (i / 3, i % 3);
                at(y.saturating_sub(3), x) + at(y, x) + at((y + 3).min(rows.len() - 1), x)
            };
            (0..own.len()).map(mean).collect()
        };
        assert_eq!(in_bands(3, 1000, 3, map), map(0..1000));
        assert_ne!(in_bands(3, 1000, 2, map), map(0..1000), "a margin that is too narrow shows");
    }
}
