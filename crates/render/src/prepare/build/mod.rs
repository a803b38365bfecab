//! Build

pub(crate) mod closed;
pub(crate) mod facets;
pub(crate) mod geometry;
pub(crate) mod lights;
pub(crate) mod lobe_integrals;
pub(crate) mod ltc;
pub(crate) mod materials;
pub(crate) mod polygons;
pub(crate) mod prefilter;
pub(crate) mod simplex;
