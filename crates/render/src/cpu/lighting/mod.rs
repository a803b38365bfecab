//! The sum over lights and lobes: C = Σ_l a_l · Σ_k s_k · T\[l, k, c\].

pub(crate) mod area;
pub(crate) mod environment;
pub(crate) mod exact;
pub(crate) mod form_factor;
pub(crate) mod general;
pub(crate) mod incident;
pub(crate) mod inlined_models;
pub(crate) mod light_sum;
pub(crate) mod matte_highlight;
pub(crate) mod point;
pub(crate) mod punctual;
pub(crate) mod reflect;
pub(crate) mod shade_material;
pub(crate) mod shadow;
