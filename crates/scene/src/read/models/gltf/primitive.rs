//! Meshes from primitives.

use std::collections::HashMap;

use glam::{Vec2, Vec3, Vec4};
use glanz_color::read::{Place, ReadError};

use super::super::finish::finish_mesh;
use super::super::model::Model;
use super::budget::Budget;
use super::json::Primitive;
use super::source::Source;
use crate::Mesh;
use crate::read::notes::Notes;

/// Bytes of a vertex with all its attributes.
const VERTEX_BYTES: u64 = 64;

/// Builds the meshes that nodes ask for, each once.
pub(super) struct Builder<'a> {
    source: &'a Source<'a>,
    budget: &'a mut Budget,
    meshes: Vec<Mesh>,
    /// For each mesh of the file, its meshes and their materials here.
    built: HashMap<usize, Vec<(usize, usize)>>,
    /// The numbers here of the file's materials; `None` for the default one.
    materials: HashMap<Option<usize>, usize>,
    /// The other way round.
    used: Vec<Option<usize>>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(source: &'a Source<'a>, budget: &'a mut Budget) -> Self {
        let (built, materials) = (HashMap::new(), HashMap::new());
        Self { source, budget, meshes: Vec::new(), built, materials, used: Vec::new() }
    }

    /// Takes memory off the budget.
    pub(super) fn spend(&mut self, bytes: u64, place: impl Fn() -> String) -> Result<(), ReadError> {
        self.budget.spend(bytes, self.source.file, place)
    }

    /// Gives the meshes to the model, and returns the file's materials in the order of use.
    pub(super) fn finish(self, model: &mut Model) -> Vec<Option<usize>> {
        model.meshes = self.meshes;
        self.used
    }

    /// The meshes, with their materials, that a mesh of the file consists of.
    pub(super) fn mesh(
        &mut self,
        index: usize,
        user: &str,
        notes: &mut Notes,
    ) -> Result<&[(usize, usize)], ReadError> {
        let source = self.source;
        if !self.built.contains_key(&index) {
            let mesh = source.root.meshes.get(index).ok_or_else(|| {
                let expected = format!("one of {} meshes", source.root.meshes.len());
                source.malformed(Place::Path(user.to_owned()), expected, format!("mesh {index}"))
            })?;
            let mut parts = Vec::new();
            for (number, primitive) in mesh.primitives.iter().enumerate() {
                let path = format!("meshes[{index}].primitives[{number}]");
                self.spend(mesh.name.len() as u64, || path.clone())?;
                if let Some(mut built) = build(source, self.budget, primitive, &path, notes)? {
                    built.name.clone_from(&mesh.name);
                    parts.push((self.meshes.len(), self.material(primitive.material, &path)?));
                    self.meshes.push(built);
                }
            }
            self.built.insert(index, parts);
        }
        Ok(&self.built[&index])
    }

    /// The number here of a material of the file.
    fn material(&mut self, material: Option<usize>, path: &str) -> Result<usize, ReadError> {
        let count = self.source.root.materials.len();
        if let Some(index) = material.filter(|&index| index >= count) {
            let place = Place::Path(format!("{path}.material"));
            let expected = format!("one of {count} materials");
            return Err(self.source.malformed(place, expected, format!("material {index}")));
        }
        Ok(*self.materials.entry(material).or_insert_with(|| {
            self.used.push(material);
            self.used.len() - 1
        }))
    }
}

/// The mesh of a primitive; `None` with a note where it holds no triangles.
fn build(
    source: &Source<'_>,
    budget: &mut Budget,
    primitive: &Primitive,
    path: &str,
    notes: &mut Notes,
) -> Result<Option<Mesh>, ReadError> {
    let mode = primitive.mode.unwrap_or(4);
    if mode > 6 {
        let place = Place::Path(format!("{path}.mode"));
        return Err(source.malformed(place, "a mode of 0 to 6", mode.to_string()));
    }
    if mode < 4 {
        notes.add("glTF: points and lines are ignored");
        return Ok(None);
    }
    let Some(&position) = primitive.attributes.get("POSITION") else {
        notes.add("glTF: primitives without positions are ignored");
        return Ok(None);
    };
    notes.add_times("glTF: morph targets are ignored", u64::from(!primitive.targets.is_empty()));
    let vertices = source.count(position, path)?;
    let mut corners = triangles(corners(source, budget, primitive, vertices, path)?, mode, notes);
    if corners.is_empty() {
        return Ok(None);
    }
    // Primitives may share a large array of vertices: each takes only what it uses.
    let pick = (corners.len() < vertices).then(|| compact(&mut corners));
    let mut mesh = attributes(source, primitive, position, pick.as_deref(), path, notes)?;
    mesh.corners = corners;
    finish_mesh(&mut mesh, notes);
    Ok(Some(mesh))
}

/// The vertex of each corner, by the indices of the primitive if it has them.
fn corners(
    source: &Source<'_>,
    budget: &mut Budget,
    primitive: &Primitive,
    vertices: usize,
    path: &str,
) -> Result<Vec<u32>, ReadError> {
    let count = primitive.indices.map_or(Ok(vertices), |indices| source.count(indices, path))?;
    let size = 16 * count as u64 + VERTEX_BYTES * vertices.min(count) as u64;
    budget.spend(size, source.file, || path.to_owned())?;
    match primitive.indices {
        Some(indices) => source.indices(indices, vertices, &format!("{path}.indices")),
        None => Ok((0..vertices as u32).collect()),
    }
}

/// The corners of single triangles (glTF 2.0, §3.7.2.1).
fn triangles(mut corners: Vec<u32>, mode: u32, notes: &mut Notes) -> Vec<u32> {
    match mode {
        5 => {
            let odd = |i: usize| [[0, 1, 2], [0, 2, 1]][i % 2];
            let strip = corners.windows(3).enumerate();
            strip.flat_map(|(i, window)| odd(i).map(|corner| window[corner])).collect()
        }
        6 => {
            let Some((&hub, rim)) = corners.split_first() else { return corners };
            rim.windows(2).flat_map(|edge| [edge[0], edge[1], hub]).collect()
        }
        _ => {
            let whole = corners.len() / 3 * 3;
            if whole < corners.len() {
                notes.add("glTF: corners after the last whole triangle are ignored");
            }
            corners.truncate(whole);
            corners
        }
    }
}

/// Renumbers the corners without gaps and returns the old numbers.
fn compact(corners: &mut [u32]) -> Vec<u32> {
    let mut used = corners.to_vec();
    used.sort_unstable();
    used.dedup();
    for corner in corners {
        *corner = used.partition_point(|number| number < corner) as u32;
    }
    used
}

/// The accessor of an attribute and the place that names it, if there is one; it has a value for each of the
/// `count` positions.
fn attribute(
    source: &Source<'_>,
    primitive: &Primitive,
    name: &str,
    count: usize,
    path: &str,
) -> Result<Option<(usize, String)>, ReadError> {
    let Some(&index) = primitive.attributes.get(name) else { return Ok(None) };
    let user = format!("{path}.attributes.{name}");
    let found = source.count(index, &user)?;
    if found == count {
        return Ok(Some((index, user)));
    }
    let expected = format!("{count} items, as there are positions");
    Err(source.malformed(Place::Path(user), expected, found.to_string()))
}

/// The vertices of a primitive: all, or those that `pick` names.
fn attributes(
    source: &Source<'_>,
    primitive: &Primitive,
    position: usize,
    pick: Option<&[u32]>,
    path: &str,
    notes: &mut Notes,
) -> Result<Mesh, ReadError> {
    let uv_set = primitive.material.map_or(0, |material| source.uv_set(material));
    let uv_name = format!("TEXCOORD_{uv_set}");
    let count = source.count(position, path)?;
    let find = |name: &str| attribute(source, primitive, name, count, path);
    let user = format!("{path}.attributes.POSITION");
    let positions = source.floats::<3>(position, &["VEC3"], pick, &user)?;
    let mut mesh = Mesh { positions: positions.into_iter().map(Vec3::from).collect(), ..Mesh::default() };
    if let Some((index, user)) = find("NORMAL")? {
        let normals = source.floats::<3>(index, &["VEC3"], pick, &user)?;
        mesh.normals = normals.into_iter().map(Vec3::from).collect();
    }
    if let Some((index, user)) = find("TANGENT")? {
        let tangents = source.floats::<4>(index, &["VEC4"], pick, &user)?;
        mesh.tangents = tangents.into_iter().map(Vec4::from).collect();
    }
    if let Some((index, user)) = find(&uv_name)? {
        let uvs = source.floats::<2>(index, &["VEC2"], pick, &user)?;
        mesh.uvs = uvs.into_iter().map(Vec2::from).collect();
    }
    if let Some((index, user)) = find("COLOR_0")? {
        let colors = source.floats::<4>(index, &["VEC3", "VEC4"], pick, &user)?;
        mesh.colors = colors.into_iter().map(Vec4::from).collect();
    }
    for name in primitive.attributes.keys() {
        let known = ["POSITION", "NORMAL", "TANGENT", "COLOR_0", uv_name.as_str()];
        if !known.contains(&name.as_str()) {
            notes.add(&format!("glTF: the attribute {name} is ignored"));
        }
    }
    Ok(mesh)
}
