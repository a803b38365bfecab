//! Lobes: the terms of a material.

use std::sync::Arc;

use glanz_bsdf::{LayerWeight, Shape};
use glanz_color::Spectrum;
use serde::{Deserialize, Serialize};

use crate::{ChannelUse, Mask, RoughnessMap, TextureUse, Tint};

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
    /// Factors that pictures say.
    #[serde(default)]
    pub masks: Vec<Mask>,
    /// What says how rough it is.
    #[serde(default)]
    pub roughness: RoughnessMap,
}

impl Lobe {
    /// A bare lobe that textures do not touch.
    pub fn new(shape: Shape, tint: impl Into<Tint>) -> Self {
        Self {
            shape,
            tint: tint.into(),
            textured: false,
            layers: Vec::new(),
            absorption: None,
            metalness: Metalness::Any,
            masks: Vec::new(),
            roughness: RoughnessMap::Material,
        }
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

    /// The same with one more mask.
    pub fn masked(mut self, mask: Mask) -> Self {
        self.masks.push(mask);
        self
    }

    /// The channels of pictures that it asks for.
    pub fn channels(&self) -> impl Iterator<Item = ChannelUse> {
        let own = match self.roughness {
            RoughnessMap::Own(channel) => Some(channel),
            RoughnessMap::Material | RoughnessMap::Uniform => None,
        };
        self.masks.iter().map(|mask| mask.of).chain(own)
    }

    /// Its uses of textures, to be changed.
    pub(crate) fn textures_mut(&mut self) -> impl Iterator<Item = &mut TextureUse> {
        let own = match &mut self.roughness {
            RoughnessMap::Own(channel) => Some(channel),
            RoughnessMap::Material | RoughnessMap::Uniform => None,
        };
        self.masks.iter_mut().map(|mask| &mut mask.of).chain(own).map(|channel| &mut channel.map)
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
