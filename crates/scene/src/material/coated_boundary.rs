//! Boundaries below a clear coat, which meet the coat's index of refraction instead of air's.

use std::sync::Arc;

use glanz_color::Ior;
use serde::{Deserialize, Serialize};

use crate::{Film, Polarization, Tint};

/// A smooth boundary that light meets from inside of a coat. What it reflects goes to and fro between both: see
/// [`coated_reflectance`](glanz_bsdf::coated_reflectance). What the coat itself reflects is not in it.
///
/// ```
/// use std::sync::Arc;
///
/// use glanz_color::Ior;
/// use glanz_scene::{Boundary, CoatedBoundary};
///
/// let copper = Boundary::Medium(Arc::new(glanz_color::ior("Cu")?));
/// let lacquered = CoatedBoundary { below: copper, coat: Ior::constant(1.5), alpha: 0.05 };
/// assert_eq!(lacquered.eta(), 1.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CoatedBoundary {
    /// The boundary below.
    pub below: Boundary,
    /// What the coat is made of; clear.
    pub coat: Ior,
    /// The width of the coat's highlight, as of the shape `ggx`.
    pub alpha: f64,
}

/// What reflects by Fresnel's law.
///
/// ```
/// use std::sync::Arc;
///
/// use glanz_color::{Ior, Rgb};
/// use glanz_scene::{Boundary, Tint};
///
/// let glass = Tint::Ior(Arc::new(Ior::constant(1.5)));
/// assert!(matches!(Boundary::of(&glass), Some(Boundary::Medium(_))));
/// assert_eq!(Boundary::of(&Tint::Rgb(Rgb([0.5; 3]))), None);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Boundary {
    /// The boundary to a medium.
    Medium(Arc<Ior>),
    /// The same of light in one polarisation.
    Polarized(Arc<Ior>, Polarization),
    /// A film on a medium.
    Film(Arc<Film>),
}

impl Boundary {
    /// The boundary whose reflection in air a tint is; `None` for colours, and for panes, which have two.
    pub fn of(tint: &Tint) -> Option<Self> {
        match tint {
            Tint::Ior(ior) => Some(Self::Medium(Arc::clone(ior))),
            Tint::Polarized(ior, polarization) => Some(Self::Polarized(Arc::clone(ior), *polarization)),
            Tint::Film(film) => Some(Self::Film(Arc::clone(film))),
            _ => None,
        }
    }

    fn is_finite(&self) -> bool {
        match self {
            Self::Medium(ior) | Self::Polarized(ior, _) => ior.eta.is_finite() && ior.k.is_finite(),
            Self::Film(film) => film.is_finite(),
        }
    }
}

impl CoatedBoundary {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.below.is_finite() && self.coat.eta.is_finite() && self.alpha.is_finite()
    }

    /// The coat's index at the middle of the visible range, by which the geometry of the layer goes.
    pub fn eta(&self) -> f64 {
        self.coat.eta.at(MIDDLE_NM)
    }
}

/// The middle of the visible range, in nm.
pub(crate) const MIDDLE_NM: f64 = 550.0;
