//! Meshes and textures.

use super::WriteError;
use super::names::{MeshKey, builtin};
use super::side_files::{SideFiles, mesh_data, png};
use super::text::{Document, Table, key, list, singles, string};
use crate::{Mesh, Texture, TextureFilter, Wrap};

/// The most vertices and corners of a mesh that is written into the scene file.
const MAX_INLINE: usize = 64;

/// Adds `[meshes.NAME]`, unless objects name the mesh themselves.
pub(super) fn write(mesh: &Mesh, name: &MeshKey, document: &mut Document, files: &mut SideFiles) {
    let MeshKey::Table(name) = name else { return };
    let mut table = Table::default();
    table.put_unless(mesh.name == *name, "name", string(&mesh.name));
    if builtin(mesh).is_some() {
        table.put("mesh", string(&mesh.name));
    } else if mesh.positions.len() <= MAX_INLINE && mesh.corners.len() <= 4 * MAX_INLINE {
        put_inline(mesh, &mut table);
    } else {
        table.put("data", data(mesh, files));
    }
    document.section(&format!("[meshes.{}]", key(name)), &table, false);
}

fn put_inline(mesh: &Mesh, table: &mut Table) {
    table.put("positions", list(mesh.positions.iter().map(|v| singles(&v.to_array()))));
    let normals = list(mesh.normals.iter().map(|v| singles(&v.to_array())));
    table.put_unless(mesh.normals.is_empty(), "normals", normals);
    for (name, uvs) in [("uvs", &mesh.uvs), ("uvs2", &mesh.uvs2)] {
        table.put_unless(uvs.is_empty(), name, list(uvs.iter().map(|v| singles(&v.to_array()))));
    }
    let tangents = list(mesh.tangents.iter().map(|v| singles(&v.to_array())));
    table.put_unless(mesh.tangents.is_empty(), "tangents", tangents);
    let colors = list(mesh.colors.iter().map(|v| singles(&v.to_array())));
    table.put_unless(mesh.colors.is_empty(), "colors", colors);
    let face = |face: &[u32]| list(face.iter().map(u32::to_string));
    let faces = if mesh.face_starts.is_empty() { "triangles" } else { "faces" };
    table.put(faces, list(mesh.faces().map(face)));
}

fn data(mesh: &Mesh, files: &mut SideFiles) -> String {
    let mut table = Table::default();
    table.put("file", string(&files.add("mesh", "bin", mesh_data(mesh))));
    table.put("vertices", mesh.positions.len().to_string());
    table.put("corners", mesh.corners.len().to_string());
    table.put_unless(mesh.face_starts.is_empty(), "face_starts", mesh.face_starts.len().to_string());
    let attributes = [
        ("normals", mesh.normals.len()),
        ("uvs", mesh.uvs.len()),
        ("uvs2", mesh.uvs2.len()),
        ("tangents", mesh.tangents.len()),
        ("colors", mesh.colors.len()),
    ];
    let held = attributes.into_iter().filter(|(_, length)| *length > 0).map(|(name, _)| string(name));
    table.put("attributes", list(held));
    table.inline()
}

/// Adds `[textures.NAME]`.
pub(super) fn write_texture(
    texture: &Texture,
    name: &str,
    document: &mut Document,
    files: &mut SideFiles,
) -> Result<(), WriteError> {
    let mut table = Table::default();
    table.put_unless(texture.name == name, "name", string(&texture.name));
    table.put("file", string(&files.add("texture", "png", png(texture)?)));
    table.put_unless(texture.srgb, "srgb", "false");
    let wrap = match texture.wrap {
        [u, v] if u == v => string(u.name()),
        both => list(both.map(|wrap| string(wrap.name()))),
    };
    table.put_unless(texture.wrap == [Wrap::default(); 2], "wrap", wrap);
    table.put_unless(texture.filter == TextureFilter::default(), "filter", string(texture.filter.name()));
    document.section(&format!("[textures.{}]", key(name)), &table, false);
    Ok(())
}

/// A mesh of an object, and whether it needs its colours asked for.
pub(super) fn of_object(name: &MeshKey) -> (String, bool) {
    match name {
        MeshKey::Table(name) => (string(name), false),
        MeshKey::Builtin(builtin) => {
            (string(builtin.name()), builtin.mesh().is_ok_and(|mesh| !mesh.colors.is_empty()))
        }
    }
}
