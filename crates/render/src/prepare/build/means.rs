//! What textures say on the whole.

use std::sync::Arc;

use glanz_scene::TextureUse;

use crate::prepare::data::{Mipmap, PreparedMaterial, TextureMeans};

/// Gives a material the means of its textures; 1 for one that is not there.
pub(crate) fn set(material: &mut PreparedMaterial, textures: &[Arc<Mipmap>]) {
    let mean = |map: &TextureUse| textures.get(map.texture).map_or([1.0; 4], |texture| texture.mean());
    let [_, rough, metal, _] = material.metal_rough_map.as_ref().map_or([1.0; 4], mean);
    let channels = material.channels.iter().map(|own| mean(&own.map)[own.channel as usize]).collect();
    material.means = TextureMeans { metal_rough: [rough, metal], channels };
}
