//! Transmittance of surfaces: how much of the light from behind reaches the viewer.

use std::sync::Arc;

use glanz_color::Ior;
use serde::{Deserialize, Serialize};

use crate::{Film, Pane, Tint};

/// The transmittance of a surface along the line of sight, at each wavelength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Transmittance {
    /// The same at every angle.
    Constant(Tint),
    /// What one boundary to this medium does not reflect.
    Boundary(Arc<Ior>),
    /// What a pane lets through.
    Pane(Arc<Pane>),
    /// What a film in air does not reflect.
    Film(Arc<Film>),
}

impl Transmittance {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Constant(tint) => tint.is_finite(),
            Self::Boundary(ior) => ior.eta.is_finite(),
            Self::Pane(pane) => pane.is_finite(),
            Self::Film(film) => film.is_finite(),
        }
    }
}
