//! The same functions as WGSL, for shaders that compute what this crate computes: the same operations in the same order.
//!
//! Interpreted with the numbers of [`Real`](crate::Real), as `glanz-shader` does, they give its bits. On a GPU `exp2`, `log2`,
//! quotients and roots are the device's, and a product and a sum may be fused.

/// `sqr`, `real_pow`, `real_acos` and constants.
pub const REAL: &str = include_str!("real.wgsl");

/// `power`, and the [`Exponent`](crate::Exponent) that it takes. It needs [`REAL`], and a function `number(at: u32) -> f32`
/// that gives the [`Exponent::numbers`](crate::Exponent::numbers).
///
/// ```
/// use glanz_math::{Exponent, wgsl};
///
/// let numbers = Exponent::new(20.0).numbers();
/// assert_eq!(numbers[..2], [20.0, 20.0]);
/// let shader = format!(
///     "{}{}const NUMBERS = array<f32, 3>({}, {}, {});
///     fn number(at: u32) -> f32 {{ return NUMBERS[at]; }}
///     fn highlight(cosine: f32) -> f32 {{ return power(cosine, exponent_at(0u)); }}",
///     wgsl::REAL, wgsl::EXPONENT, numbers[0], numbers[1], numbers[2],
/// );
/// assert!(shader.contains("fn power(x: f32, exponent: Exponent) -> f32"));
/// ```
pub const EXPONENT: &str = include_str!("exponent.wgsl");
