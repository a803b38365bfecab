//! The metrics: a map of errors from a pair of pictures.

pub(super) mod de2000;
pub(super) mod filter;
pub(super) mod flip;
pub(super) mod rmse;
pub(super) mod ssim;
