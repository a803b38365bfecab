//! The tint table: the only place where wavelengths are.

pub(crate) mod fill;
pub(crate) mod in_rgb;
pub(crate) mod interfaces;
pub(crate) mod observation;
pub(crate) mod quadrature;
pub(crate) mod seeing;
pub(crate) mod tint_coordinate;
pub(crate) mod tint_series;
pub(crate) mod tint_table;
pub(crate) mod white;
