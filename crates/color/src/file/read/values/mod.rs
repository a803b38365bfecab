//! What the numbers of a file are: quantities, units, scales.

pub(super) mod choice;
mod counts;
pub(crate) mod named;
pub(super) mod power;
pub(super) mod quantity;
pub(crate) mod reradiation;
pub(super) mod settle;
pub(super) mod units;
