//! What lobes make of area lights and environments.

pub(crate) mod albedo;
pub(crate) mod chain;
pub(crate) mod fit;
pub(crate) mod irradiance;
pub(crate) mod lobe_integrals;
