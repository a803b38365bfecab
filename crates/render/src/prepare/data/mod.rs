//! What a back end reads: plain arrays with public fields.
//!
//! | field of [`Prepared`] | layout |
//! |---|---|
//! | [`geometry`](Prepared::geometry) | clusters of triangles; vertices as arrays, relative to their object's anchor |
//! | [`objects`](Prepared::objects) | a range of clusters, a material, an anchor in the world each |
//! | [`materials`](Prepared::materials) | lobes, and rows of the tint table: entry `light · lobes + lobe` |
//! | [`lights`](Prepared::lights) | geometry in the world; an environment is three lights of the table |
//! | [`textures`](Prepared::textures) | mip levels of 8-bit codes with a table to decode them |
//! | [`bvh`](Prepared::bvh) | the triangles that cast shadows, nodes and leaves in order |
//!
//! [`Prepared::pack`] lays all of it out in two pools of `u32` and `f32`, for upload; [`Section`] has the layout.
//!
//! ```
//! use glanz_render::{PrepareOptions, prepare};
//! use glanz_scene::{Light, Material, Mesh, Scene};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("cube")?, Material::default_gray())
//!     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]));
//! let prepared = prepare(&scene, &PrepareOptions::default())?;
//! assert_eq!((prepared.triangle_count(), prepared.objects.len(), prepared.lights.len()), (12, 1, 1));
//! let material = &prepared.materials[0];
//! assert_eq!(material.tints.len(), material.lobes.len() * prepared.lights.len());
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod bvh;
pub(crate) mod environment_chain;
pub(crate) mod environment_map;
pub(crate) mod geometry;
pub(crate) mod intensity_grid;
pub(crate) mod irradiance;
pub(crate) mod lights;
pub(crate) mod lobe_integrals;
pub(crate) mod lookups;
pub(crate) mod ltc;
pub(crate) mod materials;
pub(crate) mod mipmap;
pub(crate) mod objects;
pub mod pack;
pub(crate) mod program;
pub(crate) mod tint_coordinate;
pub(crate) mod view_nodes;

use std::sync::Arc;

use glanz_math::Chebyshev;
use glanz_picture::Channels;

pub use bvh::{Bvh, BvhNode};
pub use environment_chain::{ChainLevel, EnvironmentChain};
pub use environment_map::EnvironmentMap;
pub use geometry::{CLUSTER_TRIANGLES, CLUSTER_VERTICES, Cluster, Geometry, VERTEX_ALIGN};
pub use intensity_grid::IntensityGrid;
pub use irradiance::{IRRADIANCE_TERMS, Irradiance};
pub use lights::{EnvironmentLight, LightShape, PreparedLight, PreparedLuminaire};
pub use lobe_integrals::{Albedo, AreaIntegral, LobeIntegrals};
pub use lookups::{LobeLookups, Lookup};
pub use ltc::{LtcComponent, LtcTable};
pub use materials::{DirectLobe, LobeRoughness, MixTints, PreparedMask, PreparedMaterial, TextureMeans};
pub use mipmap::{MipLevel, Mipmap};
pub use objects::{Attributes, Facets, Polygons, PreparedObject};
pub use pack::{NO_RECORD, Packed, Pool, Section, Span};
pub use program::PreparedProgram;
pub use tint_coordinate::TintCoordinate;
pub use view_nodes::{FLATTEST as FLATTEST_VIEW, VIEWS as TABLE_VIEWS, ViewNodes};

use crate::prepare::source::Source;

/// Three channels over a [coordinate](TintCoordinate), 0 … 1.
pub type TintSeries = Chebyshev<f32, 3>;

/// A scene as plain arrays, ready to draw from any camera.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Prepared {
    /// The objects of the scene, in their order.
    pub objects: Vec<PreparedObject>,
    /// Vertices and triangles of all objects.
    pub geometry: Arc<Geometry>,
    /// Materials, each with its row of the tint table.
    pub materials: Vec<PreparedMaterial>,
    /// Lights that have a direction: all but ambient ones.
    pub lights: Vec<PreparedLight>,
    /// Decoded, mipmapped textures.
    pub textures: Vec<Arc<Mipmap>>,
    /// Shaders of the user's own, in the order of the scene's.
    pub programs: Vec<Arc<PreparedProgram>>,
    /// The number of facets of all objects.
    pub facet_count: u32,
    /// What each of the three spectra of the first environment gives in the channels, seen directly.
    pub environment_tint: Option<[[f32; 3]; 3]>,
    /// The triangles that cast shadows; none where nothing does.
    pub bvh: Option<Arc<Bvh>>,
    /// What the three channels of a frame are.
    pub channels: Channels,
    /// What the table was filled from, so that it can be filled anew.
    pub(crate) source: Source,
}

impl Prepared {
    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.geometry.triangle_count()
    }
}
