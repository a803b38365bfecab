//! Work on many things at once, in parallel where the feature `rayon` is on.

/// The values of a function for 0 … `count`, in order.
pub(crate) fn collect<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        (0..count).into_par_iter().map(f).collect()
    }
    #[cfg(not(feature = "rayon"))]
    {
        (0..count).map(f).collect()
    }
}

/// Gives each part of so many values, and its number, to a function.
pub(crate) fn chunks<T: Send>(values: &mut [T], size: usize, f: impl Fn(usize, &mut [T]) + Sync + Send) {
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        values.par_chunks_mut(size).enumerate().for_each(|(i, chunk)| f(i, chunk));
    }
    #[cfg(not(feature = "rayon"))]
    {
        values.chunks_mut(size).enumerate().for_each(|(i, chunk)| f(i, chunk));
    }
}
