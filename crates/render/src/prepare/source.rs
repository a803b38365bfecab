//! What the tint table was filled from, kept so that it can be filled anew without the scene.

use std::sync::Arc;

use glanz_scene::{Light, Material, Mesh, Scene, White};

use super::options::PrepareOptions;

/// Lights, materials and options of the last preparation.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Source {
    pub colors: Arc<Colors>,
    pub options: PrepareOptions,
    /// The first of the three channels of the observation that frames get.
    pub first_channel: usize,
    /// For each object what moving it again needs.
    pub objects: Vec<ObjectSource>,
}

/// Everything that the tint table depends on but the options.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Colors {
    pub lights: Vec<Light>,
    pub materials: Vec<Material>,
    pub photometric: bool,
    pub white: White,
}

/// What an object's vertices were made of.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ObjectSource {
    pub mesh: usize,
    /// How many vertices the scene's mesh has.
    pub vertices: usize,
    /// The mesh with normals or tangents that the scene's lacks.
    pub completed: Option<Arc<Mesh>>,
    /// Of the linear part of the transform.
    pub determinant: f64,
}

impl Colors {
    pub(crate) fn of(scene: &Scene) -> Self {
        Self {
            lights: scene.lights.clone(),
            materials: scene.materials.clone(),
            photometric: scene.photometric,
            white: scene.render.white,
        }
    }
}
