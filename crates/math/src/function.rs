//! Functions behind trait objects, which know no generic numbers.

use crate::SimdLevel;

/// A function of `N` real numbers that is known for each kind of number apart, so that it can stand behind a trait object
/// and still be called by code that is generic over [`Real`](crate::Real): see [`Real::apply`](crate::Real::apply).
///
/// ```
/// use glanz_math::{Real, RealFunction, SimdLevel};
///
/// struct Product;
///
/// impl RealFunction<2> for Product {
///     fn in_f64(&self, [a, b]: [f64; 2]) -> f64 {
///         a * b
///     }
///     fn in_f32(&self, [a, b]: [f32; 2]) -> f32 {
///         a * b
///     }
///     fn in_lanes(&self, _: SimdLevel, [a, b]: &[[f32; 16]; 2]) -> [f32; 16] {
///         std::array::from_fn(|i| a[i] * b[i])
///     }
/// }
///
/// fn area<R: Real>(function: &dyn RealFunction<2>, side: R) -> R {
///     side.apply(function, [side, side])
/// }
/// assert_eq!(area(&Product, 3.0_f64), 9.0);
/// ```
pub trait RealFunction<const N: usize> {
    /// Its value in double precision.
    fn in_f64(&self, arguments: [f64; N]) -> f64;

    /// Its value in single precision.
    fn in_f32(&self, arguments: [f32; N]) -> f32;

    /// Its values for 16 rows of arguments: in every lane the bits of [`RealFunction::in_f32`]. `level` is the SIMD level
    /// of the caller.
    fn in_lanes(&self, level: SimdLevel, arguments: &[[f32; 16]; N]) -> [f32; 16];
}
