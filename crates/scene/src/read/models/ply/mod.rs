//! PLY, the Stanford polygon format, as text or binary of either byte order.
//!
//! Read of the element `vertex`: `x y z`, `nx ny nz`, `red green blue alpha`, and `s t`, `u v` or
//! `texture_u texture_v`; of `face`: `vertex_indices` (or `vertex_index`), `red green blue alpha`, and `texcoord`, the
//! texture coordinates of its corners; of `tristrips` the indices. A comment `TextureFile` names the picture.
//! All number types are taken. Colours in whole numbers are sRGB codes, those in floats linear.
//! Texture coordinates are turned, since PLY counts v upwards. Faces stay polygons. Everything else
//! is skipped, with a note.

mod body;
mod faces;
mod header;
mod texture;
mod vertex;

use std::io::BufRead;

use glanz_color::read::{Place, ReadError};

use super::anchor::Anchor;
use super::context::Context;
use super::faces::close_face;
use super::finish::{drop_faces_without_positions, finish_mesh};
use super::model::Model;
use crate::{Mesh, Object};
use body::Body;
use faces::{FaceData, push_corner};
use header::{Element, Header, Kind, Role};
use vertex::Vertex;

/// Reads a file of `len` bytes.
pub(super) fn read(reader: impl BufRead, len: u64, context: &mut Context<'_>) -> Result<Model, ReadError> {
    let (header, reader, line) = Header::read(reader, context.file, &mut context.notes)?;
    let mut body = Body::new(reader, header.encoding, context.file, line);
    let (mut mesh, mut anchor, mut data) = (Mesh::default(), Anchor::default(), FaceData::default());
    for element in &header.elements {
        match element.kind {
            Kind::Vertex => read_vertices(element, len, &mut body, (&mut mesh, &mut anchor), context)?,
            Kind::Face => data.read(element, &mut body, &mut mesh, context)?,
            Kind::Strips => read_strips(element, &mut body, &mut mesh, context)?,
            Kind::Other => {
                context.notes.add(&format!("PLY: the element '{}' is ignored", element.name));
                skip(element, &mut body)?;
            }
        }
        for name in element.ignored() {
            context.notes.add(&format!("PLY: the property '{name}' of '{}' is ignored", element.name));
        }
    }
    body.tell(&mut context.notes);
    check_corners(&mesh, context.file)?;
    let mut mesh = data.give_to(mesh);
    drop_faces_without_positions(&mut mesh, &mut context.notes);
    if header.has_short_positions() {
        anchor.tell_of_steps(&mesh, &mut context.notes);
    }
    finish_mesh(&mut mesh, &mut context.notes);
    let object = Object {
        name: String::new(),
        mesh: 0,
        material: 0,
        transform: anchor.transform(),
        shading: None,
        interpolation: None,
        program: None,
    };
    if mesh.corners.is_empty() {
        context.notes.add("the file holds no faces: nothing can be drawn");
    }
    let (material, textures) = texture::material(&header.textures, &mesh, context)?;
    let (meshes, objects, materials) = (vec![mesh], vec![object], vec![material]);
    Ok(Model { meshes, objects, materials, textures, ..Model::default() })
}

/// Reads the vertices.
fn read_vertices<R: BufRead>(
    element: &Element,
    len: u64,
    body: &mut Body<'_, R>,
    (mesh, anchor): (&mut Mesh, &mut Anchor),
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    let has = |role| element.properties.iter().any(|property| property.role == Some(role));
    let (normals, colors, uvs) = (has(Role::Normal(0)), has(Role::Color(0)), has(Role::Uv(0)));
    // Every property of a vertex takes at least one byte, so that a claim cannot fill the memory.
    let held = element.count.min(len / element.properties.len().max(1) as u64) as usize;
    mesh.positions.reserve_exact(held);
    for index in 0..element.count {
        body.begin(element.name.as_str(), index)?;
        let mut vertex = Vertex::default();
        for property in &element.properties {
            if property.list.is_some() {
                body.list(property, |_| Ok(()))?;
                continue;
            }
            let value = body.scalar(property.scalar)?;
            if let Some(role) = property.role {
                vertex.set(role, value, property.scalar);
            }
        }
        body.end();
        if mesh.positions.len() >= u32::MAX as usize {
            return Err(ReadError::malformed(context.file, body.place(), "at most 2^32 vertices", "more"));
        }
        vertex.clean(|note| context.notes.add_at(note, body.place()));
        anchor.push(vertex.position, &mut mesh.positions);
        normals.then(|| mesh.normals.push(vertex.normal));
        colors.then(|| mesh.colors.push(vertex.color));
        uvs.then(|| mesh.uvs.push(vertex.uv));
    }
    Ok(())
}

/// Reads triangle strips: every corner after the second makes a triangle with the two before it,
/// turned every second time; −1 begins a new strip.
fn read_strips<R: BufRead>(
    element: &Element,
    body: &mut Body<'_, R>,
    mesh: &mut Mesh,
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    context.notes.add("PLY: triangle strips are cut into triangles");
    for index in 0..element.count {
        body.begin(element.name.as_str(), index)?;
        for property in &element.properties {
            match (property.list, property.role) {
                (Some(_), Some(Role::Corners)) => {
                    let (mut last, mut count) = ([0.0; 2], 0u64);
                    body.list(property, |corner| {
                        if corner == -1.0 {
                            count = 0;
                            return Ok(());
                        }
                        if count >= 2 && ![last[0], last[1]].contains(&corner) && last[0] != last[1] {
                            let first = mesh.corners.len();
                            let [a, b] = if count % 2 == 0 { last } else { [last[1], last[0]] };
                            [a, b, corner].into_iter().try_for_each(|corner| push_corner(mesh, corner))?;
                            close_face(mesh, first);
                        }
                        last = [last[1], corner];
                        count += 1;
                        Ok(())
                    })?;
                }
                (Some(_), _) => body.list(property, |_| Ok(()))?,
                (None, _) => drop(body.scalar(property.scalar)?),
            }
        }
        body.end();
    }
    Ok(())
}

/// Reads over an element.
fn skip<R: BufRead>(element: &Element, body: &mut Body<'_, R>) -> Result<(), ReadError> {
    if element.properties.is_empty() {
        // Nothing is stored for such elements, however many are claimed.
        return Ok(());
    }
    for index in 0..element.count {
        body.begin(element.name.as_str(), index)?;
        for property in &element.properties {
            match property.list {
                Some(_) => body.list(property, |_| Ok(()))?,
                None => drop(body.scalar(property.scalar)?),
            }
        }
        body.end();
    }
    Ok(())
}

/// Vertices may come after the faces: only here is it known how many there are.
fn check_corners(mesh: &Mesh, file: &str) -> Result<(), ReadError> {
    let vertices = mesh.positions.len();
    let Some(corner) = mesh.corners.iter().position(|&corner| corner as usize >= vertices) else {
        return Ok(());
    };
    let face = match mesh.face_starts.is_empty() {
        true => corner / 3,
        false => mesh.face_starts.partition_point(|&start| start as usize <= corner) - 1,
    };
    let expected = format!("numbers of vertices below {vertices}");
    Err(ReadError::malformed(
        file,
        Place::Item("face", face as u64),
        expected,
        mesh.corners[corner].to_string(),
    ))
}

#[cfg(test)]
pub(in crate::read) mod tests;
