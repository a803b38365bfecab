//! Thin things that light passes: films as thick as a wavelength, panes, and what is seen through them.

use std::sync::Arc;

use glanz_color::{Ior, Spectrum};

use crate::Tint;

/// A film so thin that the light reflected on both of its sides interferes: soap, oil, an oxide.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Its thickness in nm.
    pub thickness_nm: f64,
    /// What it is made of; clear.
    pub film: Ior,
    /// What it lies on; air for a soap bubble.
    pub base: Ior,
}

/// A plane-parallel sheet of clear or coloured matter, thick against a wavelength: light that is reflected
/// to and fro in it adds up without interference.
#[derive(Clone, Debug, PartialEq)]
pub struct Pane {
    /// What it is made of; `k` is not used, absorption takes its place.
    pub ior: Ior,
    /// Its thickness in m.
    pub thickness: f64,
    /// How it absorbs, in 1/m: exp(−absorption · path) is left (Beer and Lambert).
    pub absorption: Spectrum,
}

/// What is seen through a surface: the share of the light from behind at each wavelength, along the line of
/// sight.
#[derive(Clone, Debug, PartialEq)]
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

/// How a coat over a lobe absorbs: the optical depth of its thickness, and the index of refraction by which
/// the path through it depends on the angles.
#[derive(Clone, Debug, PartialEq)]
pub struct Absorption {
    /// absorption · thickness at each wavelength.
    pub depth: Spectrum,
    /// Index of refraction of the coat.
    pub eta: f64,
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

impl Film {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let finite = |ior: &Ior| ior.eta.is_finite() && ior.k.is_finite();
        self.thickness_nm.is_finite() && finite(&self.film) && finite(&self.base)
    }
}

impl Pane {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.ior.eta.is_finite() && self.thickness.is_finite() && self.absorption.is_finite()
    }
}
