//! From a scene to plain arrays.

use glanz_scene::{Interpolation, Scene, Shading};
use thiserror::Error;

/// What to change of a scene on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PrepareOptions {
    /// Shading for all objects.
    pub shading: Option<Shading>,
    /// Interpolation for all objects.
    pub interpolation: Option<Interpolation>,
    /// Model for all highlights (the shape of every specular lobe), keeping their shininess.
    pub model: Option<String>,
}

/// Why a scene cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PrepareError {
    /// A mesh is malformed.
    #[error("mesh '{name}': {source}")]
    Mesh {
        /// The mesh's name.
        name: String,
        /// What is wrong.
        source: glanz_scene::MeshError,
    },
    /// The model asked for does not exist or does not fit.
    #[error(transparent)]
    Model(#[from] glanz_bsdf::ParamError),
    /// A number of the scene is unusable.
    #[error("{what}")]
    Scene {
        /// Where, and what is expected.
        what: String,
    },
}

/// A scene as plain arrays, ready to draw from any camera.
#[derive(Clone, Debug, Default)]
pub struct Prepared {}

/// Turns a scene into arrays. All colour work happens here.
pub fn prepare(scene: &Scene, options: &PrepareOptions) -> Result<Prepared, PrepareError> {
    let _ = (scene, options);
    Ok(Prepared {})
}
