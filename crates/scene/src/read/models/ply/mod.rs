//! PLY, the Stanford polygon format, as text or binary of either byte order.
//!
//! Read of the element `vertex`: `x y z`, `nx ny nz`, `red green blue alpha`, and `s t`, `u v` or
//! `texture_u texture_v`; of `face`: `vertex_indices` (or `vertex_index`); of `tristrips` the same.
//! All number types are taken. Colours in whole numbers are sRGB codes, those in floats linear.
//! Texture coordinates are turned, since PLY counts v upwards. Faces stay polygons. Everything else
//! is skipped, with a note.

mod body;
mod header;

use std::io::BufRead;

use glam::{DMat4, Vec2, Vec3, Vec4};
use glanz_color::read::{Place, ReadError};

use super::context::Context;
use super::faces::{close_face, corners_fit};
use super::finish::finish_mesh;
use super::model::Model;
use crate::{Material, Mesh, Object};
use body::Body;
use header::{Element, Header, Kind, Role, Scalar};

/// Reads a file of `len` bytes.
pub(super) fn read(reader: impl BufRead, len: u64, context: &mut Context<'_>) -> Result<Model, ReadError> {
    let (header, reader, line) = Header::read(reader, context.file)?;
    let mut body = Body::new(reader, header.encoding, context.file, line);
    let mut mesh = Mesh::default();
    for element in &header.elements {
        match element.kind {
            Kind::Vertex => read_vertices(element, len, &mut body, &mut mesh, context)?,
            Kind::Face => read_faces(element, &mut body, &mut mesh, context)?,
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
    check_corners(&mesh, context.file)?;
    finish_mesh(&mut mesh, &mut context.notes);
    let object = Object {
        name: String::new(),
        mesh: 0,
        material: 0,
        transform: DMat4::IDENTITY,
        shading: None,
        interpolation: None,
        program: None,
    };
    if mesh.corners.is_empty() {
        context.notes.add("the file holds no faces: nothing can be drawn");
    }
    let materials = vec![Material::default_gray()];
    Ok(Model { meshes: vec![mesh], objects: vec![object], materials, ..Model::default() })
}

/// Reads the vertices.
fn read_vertices<R: BufRead>(
    element: &Element,
    len: u64,
    body: &mut Body<'_, R>,
    mesh: &mut Mesh,
    context: &Context<'_>,
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
                vertex.set(role, value, property.scalar).ok_or_else(|| body.expected("a finite number"))?;
            }
        }
        body.end()?;
        if mesh.positions.len() >= u32::MAX as usize {
            return Err(ReadError::malformed(context.file, body.place(), "at most 2^32 vertices", "more"));
        }
        mesh.positions.push(vertex.position);
        normals.then(|| mesh.normals.push(vertex.normal));
        colors.then(|| mesh.colors.push(vertex.color));
        uvs.then(|| mesh.uvs.push(vertex.uv));
    }
    Ok(())
}

/// A vertex while it is read.
struct Vertex {
    position: Vec3,
    normal: Vec3,
    color: Vec4,
    uv: Vec2,
}

impl Default for Vertex {
    fn default() -> Self {
        Self { position: Vec3::ZERO, normal: Vec3::ZERO, color: Vec4::ONE, uv: Vec2::ZERO }
    }
}

impl Vertex {
    /// Takes one value in; `None` if it is not finite.
    fn set(&mut self, role: Role, value: f64, scalar: Scalar) -> Option<()> {
        let float = Some(value as f32).filter(|float| float.is_finite())?;
        match role {
            Role::Position(axis) => self.position[axis] = float,
            Role::Normal(axis) => self.normal[axis] = float,
            Role::Uv(0) => self.uv.x = float,
            // PLY counts v from the bottom, textures are stored from the top.
            Role::Uv(_) => self.uv.y = 1.0 - float,
            Role::Color(3) => self.color[3] = (value / scalar.one()) as f32,
            Role::Color(channel) if scalar.is_integer() => {
                self.color[channel] = glanz_color::srgb_decode((value / scalar.one()).max(0.0) as f32);
            }
            Role::Color(channel) => self.color[channel] = float,
            Role::Corners => {}
        }
        Some(())
    }
}

/// Reads faces as they are.
fn read_faces<R: BufRead>(
    element: &Element,
    body: &mut Body<'_, R>,
    mesh: &mut Mesh,
    context: &mut Context<'_>,
) -> Result<(), ReadError> {
    let mut dropped = 0;
    for index in 0..element.count {
        body.begin(element.name.as_str(), index)?;
        let first = mesh.corners.len();
        for property in &element.properties {
            match (property.list, property.role) {
                (Some(_), Some(Role::Corners)) => body.list(property, |corner| push_corner(mesh, corner))?,
                (Some(_), _) => body.list(property, |_| Ok(()))?,
                (None, _) => drop(body.scalar(property.scalar)?),
            }
        }
        body.end()?;
        dropped += u64::from(!close_face(mesh, first));
    }
    context.notes.add_times("faces of fewer than three corners are ignored", dropped);
    Ok(())
}

fn push_corner(mesh: &mut Mesh, corner: f64) -> Result<(), &'static str> {
    // Comparisons that are false for NaN, too.
    if !(corner >= 0.0 && corner < f64::from(u32::MAX)) {
        return Err("the number of a vertex");
    }
    if !corners_fit(mesh, 1) {
        return Err("at most 2^32 corners");
    }
    mesh.corners.push(corner as u32);
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
        body.end()?;
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
        body.end()?;
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
