//! Linear algebra: 3 × 3 matrices and small systems of equations.

mod linear;
mod matrix;

pub(crate) use linear::solve;
pub use matrix::Matrix3;
