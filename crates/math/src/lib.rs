//! Numbers for Glanz, names as people type them ([`names`]), and what a machine has: [`SimdLevel`], [`MemoryBudget`].
//!
//! Every formula of the project is written once, generic over [`Real`], and runs as `f64` (the
//! reference), as `f32` and as 16 lanes of `f32` ([`Lanes`]). The three agree by
//! construction: `f32` and `Lanes` use the same operations in the same order, so they agree to the
//! last bit; `f64` tells how much precision the others lose.
//!
//! Only `+ − × ÷ √`, comparisons and our own [`Real::exp2`] and [`Real::log2`] are used: IEEE 754
//! defines the first five exactly, the others are polynomials made of them. Nothing here depends on
//! the C library of a platform and nothing is contracted to a fused multiply-add.
//!
//! ```
//! use glanz_math::{Lanes, Real, SimdLevel, at_level};
//!
//! /// Lambert's cosine to a power, in any kind of number.
//! fn lobe<R: Real>(cosine: R) -> R {
//!     cosine.clamp(0.0, 1.0).pow(cosine.lit(20.0))
//! }
//!
//! let mut row = [0.0; 16];
//! at_level!(SimdLevel::best(), simd => lobe(Lanes::splat(simd, 0.9)).store(&mut row));
//! assert_eq!(row, [lobe(0.9_f32); 16]);
//! assert!((f64::from(row[0]) - lobe(0.9_f64)).abs() < 1e-6);
//! ```

mod chebyshev;
mod exponent;
mod function;
pub mod inline;
mod lanes;
mod level;
mod memory;
pub mod names;
mod poly;
mod quadrature;
mod real;
mod twice;
mod vec3;
pub mod wgsl;

pub use chebyshev::{Chebyshev, chebyshev_nodes};
pub use exponent::Exponent;
pub use function::RealFunction;
pub use lanes::{Lanes, LanesMask};
pub use level::{LevelError, SimdLevel, narrowest};
pub use memory::{MemoryBudget, MemorySizeError, OverBudget};
pub use quadrature::{GaussLegendre, hemisphere, sphere_directions};
pub use real::{POW_FLOOR_LOG2, Real};
pub use twice::Twice;
pub use vec3::{Frame, Vec3};

/// π as the field writes it, for code that is generic over [`Real`] through [`Real::lit`].
pub const PI: f64 = core::f64::consts::PI;

/// The SIMD library whose levels and vectors [`Lanes`] uses.
pub use fearless_simd as simd;
