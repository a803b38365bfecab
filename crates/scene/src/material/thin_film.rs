//! Thin films, in which light interferes.

use glanz_color::Ior;
use serde::{Deserialize, Serialize};

/// A film so thin that the light reflected on both of its sides interferes: soap, oil, an oxide.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Film {
    /// Its thickness in nm.
    pub thickness_nm: f64,
    /// What it is made of; clear.
    pub film: Ior,
    /// What it lies on; air for a soap bubble.
    pub base: Ior,
}

impl Film {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let finite = |ior: &Ior| ior.eta.is_finite() && ior.k.is_finite();
        self.thickness_nm.is_finite() && finite(&self.film) && finite(&self.base)
    }
}
