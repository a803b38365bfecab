//! A law each: a function from a lobe to a verdict, with the worst case found.

pub(super) mod energy;
pub(super) mod lanes;
pub(super) mod limits;
pub(super) mod normalization;
pub(super) mod positivity;
pub(super) mod precision;
pub(super) mod reciprocity;
pub(super) mod side;
