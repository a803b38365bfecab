//! Faces, and what they have of their own: colours, and texture coordinates of their corners.

use std::io::BufRead;

use glam::{Vec2, Vec4};
use glanz_color::read::ReadError;

use super::super::context::Context;
use super::super::faces::{close_face, corners_fit};
use super::body::Body;
use super::header::{Element, Role};
use super::vertex::{NO_COLOR, color};
use crate::Mesh;
use crate::mesh::topology::Splitter;

/// A remark.
const SHIFTED: &str = "PLY: faces with more values than the header tells have no colour, since which values are the colour is not known";

/// What faces have that belongs to vertices of a mesh; empty where they do not have it.
#[derive(Default)]
pub(super) struct FaceData {
    /// The texture coordinates of each corner.
    uvs: Vec<Vec2>,
    /// The colour of each face.
    colors: Vec<Vec4>,
}

impl FaceData {
    /// Reads faces as they are.
    pub(super) fn read<R: BufRead>(
        &mut self,
        element: &Element,
        body: &mut Body<'_, R>,
        mesh: &mut Mesh,
        context: &mut Context<'_>,
    ) -> Result<(), ReadError> {
        let has = |role| element.properties.iter().any(|property| property.role == Some(role));
        let (has_uvs, has_colors) = (has(Role::CornerUvs), has(Role::Color(0)));
        let (mut dropped, mut uvs) = (0, Vec::new());
        for index in 0..element.count {
            body.begin(element.name.as_str(), index)?;
            let (first, mut shade) = (mesh.corners.len(), Vec4::ONE);
            uvs.clear();
            for property in &element.properties {
                match (property.list, property.role) {
                    (Some(_), Some(Role::Corners)) => {
                        body.list(property, |corner| push_corner(mesh, corner))?
                    }
                    (Some(_), Some(Role::CornerUvs)) => body.list(property, |value| {
                        uvs.push(value as f32);
                        Ok(())
                    })?,
                    (Some(_), _) => body.list(property, |_| Ok(()))?,
                    (None, Some(Role::Color(channel))) => {
                        shade[channel] = color(channel, body.scalar(property.scalar)?, property.scalar);
                    }
                    (None, _) => drop(body.scalar(property.scalar)?),
                }
            }
            let is_as_told = body.end();
            let listed = mesh.corners.len() - first;
            if !close_face(mesh, first) {
                dropped += 1;
                continue;
            }
            if has_colors {
                let odd = match (is_as_told, shade.is_finite()) {
                    // Values that the header does not tell of may stand before the colours.
                    (false, _) => Some(SHIFTED),
                    (true, false) => Some(NO_COLOR),
                    (true, true) => None,
                };
                odd.iter().for_each(|odd| context.notes.add_at(odd, body.place()));
                self.colors.push(if odd.is_some() { Vec4::ONE } else { shade });
            }
            if has_uvs && !self.push_uvs(&uvs, listed, mesh.corners.len() - first) {
                context.notes.add_at(
                    "PLY: texture coordinates that do not fit their face are taken as 0",
                    body.place(),
                );
            }
        }
        context.notes.add_times("faces of fewer than three corners are ignored", dropped);
        Ok(())
    }

    /// Adds the coordinates of a face with so many corners, of which so many are kept; whether they fit.
    fn push_uvs(&mut self, uvs: &[f32], listed: usize, kept: usize) -> bool {
        let fit = uvs.len() == 2 * listed && listed == kept && uvs.iter().all(|value| value.is_finite());
        match fit {
            // PLY counts v from the bottom, textures are stored from the top.
            true => self.uvs.extend(uvs.chunks_exact(2).map(|uv| Vec2::new(uv[0], 1.0 - uv[1]))),
            false => self.uvs.resize(self.uvs.len() + kept, Vec2::ZERO),
        }
        fit
    }

    /// The mesh whose vertices have what its faces have; those that need several values are split.
    pub(super) fn give_to(self, mesh: Mesh) -> Mesh {
        let (has_uvs, has_colors) =
            (self.uvs.len() == mesh.corners.len(), self.colors.len() == mesh.face_count());
        if mesh.corners.is_empty() || !(has_uvs || has_colors) {
            return mesh;
        }
        let mut splitter = Splitter::new(mesh.positions.len());
        let mut values = vec![(Vec2::ZERO, Vec4::ONE); mesh.positions.len()];
        let mut corners = Vec::with_capacity(mesh.corners.len());
        for (face, vertices) in mesh.faces().enumerate() {
            for &vertex in vertices {
                let uv = if has_uvs { self.uvs[corners.len()] } else { Vec2::ZERO };
                let color = if has_colors { self.colors[face] } else { Vec4::ONE };
                let key = (uv.to_array().map(f32::to_bits), color.to_array().map(f32::to_bits));
                let user = splitter.user(vertex, key);
                values.resize(splitter.sources.len(), (Vec2::ZERO, Vec4::ONE));
                values[user as usize] = (uv, color);
                corners.push(user);
            }
        }
        let mut split = mesh.pick_vertices(&splitter.sources);
        if has_uvs {
            split.uvs = values.iter().map(|(uv, _)| *uv).collect();
        }
        if has_colors {
            split.colors = values.iter().map(|(_, color)| *color).collect();
        }
        Mesh { corners, face_starts: mesh.face_starts, ..split }
    }
}

/// Adds a corner to the face that is being read.
pub(super) fn push_corner(mesh: &mut Mesh, corner: f64) -> Result<(), &'static str> {
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
