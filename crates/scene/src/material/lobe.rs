//! Lobes: the terms of a material.

use std::sync::Arc;

use glanz_bsdf::{LayerWeight, Shape};
use glanz_color::Spectrum;
use serde::{Deserialize, Serialize};

use crate::Tint;

/// One term of a material: a shape times a tint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lobe {
    /// The directional part.
    #[serde(deserialize_with = "super::brdf::deserialize")]
    pub shape: Shape,
    /// The coloured part. For an emission lobe: the light sent out.
    pub tint: Tint,
    /// Whether the base colour texture and vertex colours multiply the tint.
    pub textured: bool,
    /// The weights of the layers over it, from the inner to the outer.
    pub layers: Vec<LayerWeight>,
    /// What a coat over it absorbs.
    pub absorption: Option<Arc<Absorption>>,
    /// Which part of the surface it belongs to.
    pub metalness: Metalness,
}

impl Lobe {
    /// A bare lobe that textures do not touch.
    pub fn new(shape: Shape, tint: impl Into<Tint>) -> Self {
        let (tint, metalness) = (tint.into(), Metalness::Any);
        Self { shape, tint, textured: false, layers: Vec::new(), absorption: None, metalness }
    }

    /// The same, multiplied by textures and vertex colours.
    pub fn textured(self) -> Self {
        Self { textured: true, ..self }
    }

    /// The same under one more layer.
    pub fn under(mut self, layer: LayerWeight) -> Self {
        self.layers.push(layer);
        self
    }
}

/// Which part of a surface a lobe belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Metalness {
    /// All of it.
    #[default]
    Any,
    /// Metal: the lobe counts `factor · texture`.
    Metal {
        /// How metallic the surface is where the texture is 1, or where there is none.
        factor: f64,
    },
    /// The rest: the lobe counts `1 − factor · texture`.
    Dielectric {
        /// How metallic the surface is where the texture is 1, or where there is none.
        factor: f64,
    },
}

/// How a coat over a lobe absorbs: the optical depth of its thickness, and the index of refraction by which
/// the path through it depends on the angles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Absorption {
    /// absorption · thickness at each wavelength.
    pub depth: Spectrum,
    /// Index of refraction of the coat.
    pub eta: f64,
}
