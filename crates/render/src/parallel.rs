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
