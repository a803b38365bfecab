//! Formats with rules of their own: XML, CGATS, JCAMP-DX, and the matrices of re-radiation.

pub(super) mod bfc;
pub(super) mod cgats;
pub(super) mod cxf;
pub(super) mod jcamp;
pub(super) mod matrix;
pub(super) mod spdx;
mod xml;
