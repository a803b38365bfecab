//! Surfaces: reflectances, indices of refraction, fluorescence and re-radiation.

pub mod dyes;
pub(crate) mod fluorescent;
pub(crate) mod fluorophore;
pub(crate) mod ior;
pub(crate) mod paper_notes;
pub(crate) mod reflectances;
pub(crate) mod reradiation;
