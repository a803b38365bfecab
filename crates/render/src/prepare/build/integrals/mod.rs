//! What lobes make of area lights and environments.

pub(crate) mod chain;
pub(crate) mod irradiance;
pub(crate) mod lobe_integrals;
pub(crate) mod lookups;
pub(crate) mod ltc;
pub(crate) mod simplex;
