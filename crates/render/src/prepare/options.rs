//! What is asked of the preparation, and why it fails.

use glanz_bsdf::ParamError;
use glanz_math::{MemoryBudget, OverBudget, names};
use glanz_scene::{Interpolation, Shading};
use thiserror::Error;

use crate::prepare::build::programs::ProgramError;
use crate::prepare::color::observation::{Observation, ObservationError};

/// What to change of a scene on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PrepareOptions {
    /// Shading for all objects.
    pub shading: Option<Shading>,
    /// Interpolation for all objects.
    pub interpolation: Option<Interpolation>,
    /// Model for all highlights (the shape of every specular lobe), keeping their shininess.
    pub model: Option<String>,
    /// Colour mode and observer.
    pub observation: Observation,
    /// What the scene, prepared and drawn, may take of memory with its picture.
    pub memory: MemoryBudget,
}

/// Why a scene cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PrepareError {
    /// A mesh is malformed.
    #[error("mesh '{}': {source}", names::shown(name))]
    Mesh {
        /// The mesh's name.
        name: String,
        /// What is wrong.
        source: glanz_scene::MeshError,
    },
    /// The model asked for does not exist or does not fit.
    #[error(transparent)]
    Model(#[from] ParamError),
    /// The observer does not fit the colour mode or the scene.
    #[error(transparent)]
    Observation(#[from] ObservationError),
    /// A program of the scene cannot be used.
    #[error(transparent)]
    Program(#[from] Box<ProgramError>),
    /// The scene takes more memory than it may.
    #[error(transparent)]
    Memory(#[from] OverBudget),
    /// A number of the scene is unusable.
    #[error("{what}")]
    Scene {
        /// Where, and what is expected.
        what: String,
    },
}
