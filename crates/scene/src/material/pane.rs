//! Panes of clear or coloured glass.

use glanz_color::{Ior, Spectrum};
use serde::{Deserialize, Serialize};

/// A plane-parallel sheet of a clear or coloured medium, thick against a wavelength: inter-reflections add up without
/// interference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pane {
    /// What it is made of; `k` is not used, absorption takes its place.
    pub ior: Ior,
    /// Its thickness in m.
    pub thickness: f64,
    /// How it absorbs, in 1/m: exp(−absorption · path) is left (Beer and Lambert).
    pub absorption: Spectrum,
}

impl Pane {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.ior.eta.is_finite() && self.thickness.is_finite() && self.absorption.is_finite()
    }
}
