//! Materials: sums of lobes, their tints, the layers over them, and textures.

pub(crate) mod brdf;
mod classic;
mod coat;
mod coated_boundary;
mod lobe;
mod mask;
mod measured;
mod pane;
mod parameters;
mod surface;
mod texture;
mod thin_film;
mod tint;
mod transmittance;

pub use classic::ClassicMaterial;
pub use coat::Coat;
pub use coated_boundary::{Boundary, CoatedBoundary};
pub use lobe::{Absorption, Lobe, Metalness};
pub use mask::{ChannelUse, Mask, RoughnessMap, TextureChannel};
pub use pane::Pane;
pub use parameters::ParameterError;
pub use surface::{AlphaMode, Material, TextureUse};
pub use texture::{Texture, TextureFilter, Wrap};
pub use thin_film::Film;
pub use tint::{LightColor, Polarization, Tint};
pub use transmittance::Transmittance;
