//! The picture that a PLY file names.

use glanz_color::Rgb;
use glanz_color::read::{Place, ReadError};

use super::super::context::Context;
use crate::{ClassicMaterial, Material, Mesh, Texture, TextureUse};

/// The material of the mesh: grey, or with the first picture that the header names.
pub(super) fn material(
    names: &[(String, Place)],
    mesh: &Mesh,
    context: &mut Context<'_>,
) -> Result<(Material, Vec<Texture>), ReadError> {
    let plain = (Material::default_gray(), Vec::new());
    let Some((name, place)) = names.first() else { return Ok(plain) };
    if names.iter().any(|(other, _)| other != name) {
        context.notes.add_at("PLY: of several texture files the first is taken for all faces", place.clone());
    }
    if mesh.uvs.is_empty() {
        let note = format!("PLY: the texture '{name}' is left out, since there are no texture coordinates");
        context.notes.add_at(&note, place.clone());
        return Ok(plain);
    }
    let Some(bytes) = context.find_picture(std::slice::from_ref(name), place) else { return Ok(plain) };
    let mut memory = context.options.memory;
    let Some(picture) = context.decode_picture(&bytes, name, place, &mut memory)? else { return Ok(plain) };
    let white = ClassicMaterial {
        ambient: Rgb::WHITE.into(),
        diffuse: Rgb::WHITE.into(),
        ..ClassicMaterial::default()
    };
    let mut material = white.build("default").expect("the default model exists");
    material.base_color = Some(TextureUse::plain(0));
    Ok((material, vec![Texture { name: name.clone(), ..picture }]))
}
