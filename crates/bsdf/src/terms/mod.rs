//! Terms that several models, and tints, share.

mod fresnel;

pub use fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_schlick};
