//! Closures and arrays that are surely inlined.
//!
//! Code below a SIMD dispatch must be inlined into it, closures too, or it runs without the level's
//! instructions.
//!
//! ```
//! use glanz_math::inline::{inlined, nine, three};
//!
//! let double = inlined(
//!     #[inline(always)]
//!     |x: f32| x + x,
//! );
//! assert_eq!(three([1.0, 2.0, 3.0], double), [2.0, 4.0, 6.0]);
//! assert_eq!(nine(|i| i * i)[8], 64);
//! ```

/// The closure itself: a place where `#[inline(always)]` may stand on a closure that has a name, since the
/// language allows the attribute on arguments but not on the value of a `let`.
#[inline(always)]
pub fn inlined<F>(closure: F) -> F {
    closure
}

/// `values.map(f)`, surely inlined: the standard `map` is a call below a SIMD dispatch.
#[inline(always)]
pub fn three<T, U>([a, b, c]: [T; 3], f: impl Fn(T) -> U) -> [U; 3] {
    [f(a), f(b), f(c)]
}

/// Nine values, surely inlined and unrolled.
#[inline(always)]
pub fn nine<T>(f: impl Fn(usize) -> T) -> [T; 9] {
    [f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7), f(8)]
}
