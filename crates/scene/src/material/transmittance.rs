//! Transmittance of surfaces: how much of the light from behind reaches the viewer.

use std::sync::Arc;

use glanz_color::Ior;
use serde::{Deserialize, Serialize};

use crate::{Film, Pane, Tint};

/// What is seen through a surface: the share of the light from behind at each wavelength, along the line of
/// sight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Transmittance {
    /// The same share at every angle.
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
