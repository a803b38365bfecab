//! Meshes from faces whose corners name position, texture coordinate and normal apart.

use std::collections::HashMap;

use glam::{Vec2, Vec3};

use super::super::anchor::Anchor;
use super::super::faces::{close_face, corners_fit};
use super::super::finish::finish_mesh;
use super::corner::{Corner, NONE};
use super::data::Data;
use crate::read::notes::Notes;
use crate::{Mesh, Object};

/// The vertex made last from a position: nearly every corner finds its vertex here.
#[derive(Clone, Copy)]
struct Slot {
    part: u32,
    vertex: u32,
    uv: u32,
    normal: u32,
}

/// A slot that no vertex was made from.
const FREE: Slot = Slot { part: NONE, vertex: 0, uv: NONE, normal: NONE };

/// The meshes of a file: one for each object and material that has faces.
#[derive(Default)]
pub(super) struct Parts {
    parts: Vec<Part>,
    /// The part of an object's and a material's number.
    by_names: HashMap<(u32, u32), u32>,
    objects: Names,
    materials: Names,
    /// Numbers of the object and the material that faces go to; 0 for none.
    current: (u32, u32),
    /// The smoothing group that faces are in; `None` before the first statement.
    smoothing: Option<u32>,
    slots: Vec<Slot>,
    /// The corners of a face while it is read.
    face: Vec<Corner>,
    /// Vertices that were pushed out of their slot.
    others: HashMap<(u32, Corner), u32>,
}

struct Part {
    mesh: Mesh,
    anchor: Anchor,
    material: u32,
    /// The smoothing group of each face; missing ones at the end are `None`.
    smoothing: Vec<Option<u32>>,
}

/// What became of a face.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Added {
    /// It was added.
    Face,
    /// It has too few corners to be one.
    TooFew,
    /// A position is no number.
    NotFinite,
}

/// Names with numbers from 1.
#[derive(Default)]
struct Names {
    numbers: HashMap<String, u32>,
    names: Vec<String>,
}

impl Names {
    fn number(&mut self, name: String) -> u32 {
        let next = self.names.len() as u32 + 1;
        let number = *self.numbers.entry(name.clone()).or_insert(next);
        if number == next {
            self.names.push(name);
        }
        number
    }
}

impl Parts {
    /// Faces go to this object from here on.
    pub(super) fn begin_object(&mut self, name: String) {
        self.current.0 = self.objects.number(name);
    }

    /// Faces have this material from here on.
    pub(super) fn use_material(&mut self, name: String) {
        self.current.1 = self.materials.number(name);
    }

    /// Faces are in this smoothing group from here on: a number, or `off`.
    pub(super) fn use_smoothing(&mut self, group: &[u8]) {
        let number = core::str::from_utf8(group).ok().and_then(|group| group.parse().ok());
        self.smoothing = Some(number.unwrap_or(u32::from(group == b"on")));
    }

    /// Adds a face. Errors say what was expected.
    pub(super) fn add_face(
        &mut self,
        corners: impl Iterator<Item = Result<Corner, String>>,
        data: &Data,
    ) -> Result<Added, String> {
        let mut face = std::mem::take(&mut self.face);
        face.clear();
        for corner in corners {
            face.push(corner?);
        }
        let added = self.add_corners(&face, data);
        self.face = face;
        added
    }

    fn add_corners(&mut self, face: &[Corner], data: &Data) -> Result<Added, String> {
        if !face.iter().all(|corner| data.positions[corner.position as usize].is_finite()) {
            return Ok(Added::NotFinite);
        }
        let part = self.current_part();
        self.slots.resize(data.positions.len(), FREE);
        let first = self.parts[part as usize].mesh.corners.len();
        for &corner in face {
            let vertex = self.vertex(part, corner, data);
            let mesh = &mut self.parts[part as usize].mesh;
            if !corners_fit(mesh, 1) {
                return Err("at most 2^32 corners in a mesh".to_owned());
            }
            mesh.corners.push(vertex);
        }
        let part = &mut self.parts[part as usize];
        if !close_face(&mut part.mesh, first) {
            return Ok(Added::TooFew);
        }
        if self.smoothing.is_some() {
            part.smoothing.resize(part.mesh.face_count() - 1, None);
            part.smoothing.push(self.smoothing);
        }
        Ok(Added::Face)
    }

    fn current_part(&mut self) -> u32 {
        let next = self.parts.len() as u32;
        let part = *self.by_names.entry(self.current).or_insert(next);
        if part == next {
            let (object, material) = self.current;
            let name = object.checked_sub(1).map(|i| self.objects.names[i as usize].clone());
            let mesh = Mesh { name: name.unwrap_or_default(), ..Mesh::default() };
            self.parts.push(Part { mesh, anchor: Anchor::default(), material, smoothing: Vec::new() });
        }
        part
    }

    /// The vertex of a corner, made where there is none yet.
    fn vertex(&mut self, part: u32, corner: Corner, data: &Data) -> u32 {
        let slot = self.slots[corner.position as usize];
        if (slot.part, slot.uv, slot.normal) == (part, corner.uv, corner.normal) {
            return slot.vertex;
        }
        if slot.part != NONE {
            if let Some(&vertex) = self.others.get(&(part, corner)) {
                return vertex;
            }
            let old = Corner { position: corner.position, uv: slot.uv, normal: slot.normal };
            self.others.insert((slot.part, old), slot.vertex);
        }
        let vertex = push_vertex(&mut self.parts[part as usize], corner, data);
        self.slots[corner.position as usize] = Slot { part, vertex, uv: corner.uv, normal: corner.normal };
        vertex
    }

    /// The meshes, an object for each, and the names of the materials that the objects use: those
    /// of material `i` is the name `i`, and `None` where no material was named.
    pub(super) fn finish(self, notes: &mut Notes) -> (Vec<Mesh>, Vec<Object>, Vec<Option<String>>) {
        let (mut meshes, mut objects) = (Vec::new(), Vec::new());
        let (mut names, mut used) = (Vec::new(), HashMap::new());
        for Part { mut mesh, anchor, material, mut smoothing } in self.parts {
            if mesh.corners.is_empty() {
                continue;
            }
            complete(&mut mesh);
            finish_mesh(&mut mesh, notes);
            if mesh.normals.is_empty() && !smoothing.is_empty() {
                smoothing.resize(mesh.face_count(), None);
                mesh = mesh.with_smoothing_groups(&smoothing);
            }
            let material = *used.entry(material).or_insert_with(|| {
                names.push(material.checked_sub(1).map(|i| self.materials.names[i as usize].clone()));
                names.len() - 1
            });
            objects.push(Object {
                name: mesh.name.clone(),
                mesh: meshes.len(),
                material,
                transform: anchor.transform(),
                shading: None,
                interpolation: None,
                program: None,
            });
            meshes.push(mesh);
        }
        (meshes, objects, names)
    }
}

/// Makes a vertex. Attributes are empty as long as no vertex has them.
fn push_vertex(part: &mut Part, corner: Corner, data: &Data) -> u32 {
    let Part { mesh, anchor, .. } = part;
    let vertex = mesh.positions.len();
    let position = corner.position as usize;
    anchor.push(data.positions[position], &mut mesh.positions);
    if let Some(uv) = data.uvs.get(corner.uv as usize) {
        mesh.uvs.resize(vertex, Vec2::ZERO);
        mesh.uvs.push(*uv);
    }
    if let Some(normal) = data.normals.get(corner.normal as usize) {
        mesh.normals.resize(vertex, Vec3::ZERO);
        mesh.normals.push(*normal);
    }
    if let Some(color) = data.colors.get(position) {
        mesh.colors.resize(vertex, Vec3::ONE.extend(1.0));
        mesh.colors.push(color.extend(1.0));
    }
    vertex as u32
}

/// Fills attributes up that some vertices have and some have not.
fn complete(mesh: &mut Mesh) {
    let vertices = mesh.positions.len();
    if !mesh.uvs.is_empty() {
        mesh.uvs.resize(vertices, Vec2::ZERO);
    }
    if !mesh.normals.is_empty() {
        mesh.normals.resize(vertices, Vec3::ZERO);
    }
    if !mesh.colors.is_empty() {
        mesh.colors.resize(vertices, Vec3::ONE.extend(1.0));
    }
}
