//! Work on the rows of planes, in parallel where the feature `rayon` is on.

/// Rows that one task takes at least.
#[cfg(feature = "rayon")]
const ROWS_AT_LEAST: usize = 8;

/// Calls `work` for every row of `out`.
pub(super) fn for_each_row<T: Send>(
    out: &mut [T],
    width: usize,
    work: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    if width == 0 {
        return;
    }
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        out.par_chunks_mut(width).with_min_len(ROWS_AT_LEAST).enumerate().for_each(|(y, row)| work(y, row));
    }
    #[cfg(not(feature = "rayon"))]
    out.chunks_mut(width).enumerate().for_each(|(y, row)| work(y, row));
}

/// Three planes of which pixel `i` is `value(i)`.
pub(super) fn three_planes(
    width: usize,
    height: usize,
    value: impl Fn(usize) -> [f32; 3] + Sync + Send,
) -> [Vec<f32>; 3] {
    let mut planes = [(); 3].map(|()| vec![0.0; width * height]);
    let [first, second, third] = &mut planes;
    let work = |y: usize, [first, second, third]: [&mut [f32]; 3]| {
        for x in 0..first.len() {
            [first[x], second[x], third[x]] = value(y * width + x);
        }
    };
    if width == 0 {
        return planes;
    }
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let rows = first.par_chunks_mut(width).zip(second.par_chunks_mut(width));
        let rows = rows.zip(third.par_chunks_mut(width)).with_min_len(ROWS_AT_LEAST).enumerate();
        rows.for_each(|(y, ((first, second), third))| work(y, [first, second, third]));
    }
    #[cfg(not(feature = "rayon"))]
    {
        let rows = first.chunks_mut(width).zip(second.chunks_mut(width));
        let rows = rows.zip(third.chunks_mut(width)).enumerate();
        rows.for_each(|(y, ((first, second), third))| work(y, [first, second, third]));
    }
    planes
}

/// One plane of which pixel `i` is `value(i)`.
pub(super) fn one_plane<T: Copy + Default + Send>(
    width: usize,
    height: usize,
    value: impl Fn(usize) -> T + Sync + Send,
) -> Vec<T> {
    let mut plane = vec![T::default(); width * height];
    for_each_row(&mut plane, width, |y, row| {
        for (x, out) in row.iter_mut().enumerate() {
            *out = value(y * width + x);
        }
    });
    plane
}
