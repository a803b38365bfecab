//! What the numbers of a file are: quantities, units, scales.

pub(crate) mod named;
pub(super) mod power;
pub(crate) mod reradiation;
pub(super) mod settle;
pub(super) mod units;
