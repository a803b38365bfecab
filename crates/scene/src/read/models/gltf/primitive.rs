//! Meshes from primitives.

use std::collections::HashMap;

use glam::{Vec2, Vec3, Vec4};
use glanz_color::read::{Place, ReadError};

use super::super::anchor::Anchor;
use super::super::finish::{drop_faces_without_positions, finish_mesh};
use super::super::model::Model;
use super::json::Primitive;
use super::pose::Pose;
use super::source::Source;
use crate::Mesh;
use crate::read::notes::Notes;

/// Bytes of a vertex with all its attributes.
const VERTEX_BYTES: u64 = 64;

/// A mesh of the file, and the node that poses it if one does.
type Posed = (usize, Option<usize>);

/// Builds the meshes that nodes ask for, each once.
pub(super) struct Builder<'a> {
    source: &'a Source<'a>,
    meshes: Vec<Mesh>,
    /// For each mesh, its meshes and their materials here.
    built: HashMap<Posed, Vec<(usize, usize)>>,
    /// The numbers here of the file's materials; `None` for the default one.
    materials: HashMap<Option<usize>, usize>,
    /// The other way round.
    used: Vec<Option<usize>>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(source: &'a Source<'a>) -> Self {
        let (built, materials) = (HashMap::new(), HashMap::new());
        Self { source, meshes: Vec::new(), built, materials, used: Vec::new() }
    }

    /// Takes memory off the budget.
    pub(super) fn spend(&mut self, bytes: u64, place: impl Fn() -> String) -> Result<(), ReadError> {
        self.source.budget.spend(bytes, self.source.file, place)
    }

    /// Gives the meshes to the model, and returns the file's materials in the order of use.
    pub(super) fn finish(self, model: &mut Model) -> Vec<Option<usize>> {
        model.meshes = self.meshes;
        self.used
    }

    /// The meshes, with their materials, that a mesh of the file consists of, in the pose that a node gives it.
    pub(super) fn mesh(
        &mut self,
        index: usize,
        pose: Option<(usize, &Pose)>,
        user: &str,
        notes: &mut Notes,
    ) -> Result<&[(usize, usize)], ReadError> {
        let source = self.source;
        let key = (index, pose.map(|(node, _)| node));
        if !self.built.contains_key(&key) {
            let mesh = source.root.meshes.get(index).ok_or_else(|| {
                let expected = format!("one of {} meshes", source.root.meshes.len());
                source.malformed(Place::Path(user.to_owned()), expected, format!("mesh {index}"))
            })?;
            let standard = Pose { weights: mesh.weights.clone(), joints: None };
            let pose = pose.map_or(&standard, |(_, pose)| pose);
            let mut parts = Vec::new();
            for (number, primitive) in mesh.primitives.iter().enumerate() {
                let path = format!("meshes[{index}].primitives[{number}]");
                self.spend(mesh.name.len() as u64, || path.clone())?;
                if let Some(mut built) = build(source, primitive, pose, &path, notes)? {
                    built.name.clone_from(&mesh.name);
                    parts.push((self.meshes.len(), self.material(primitive.material, &path, notes)));
                    self.meshes.push(built);
                }
            }
            self.built.insert(key, parts);
        }
        Ok(&self.built[&key])
    }

    /// The number here of a material of the file.
    fn material(&mut self, material: Option<usize>, path: &str, notes: &mut Notes) -> usize {
        let count = self.source.root.materials.len();
        let known = material.filter(|&index| index < count);
        if known != material {
            let place = Place::Path(format!("{path}.material"));
            notes.add_at("glTF: materials that are not there are the default one", place);
        }
        *self.materials.entry(known).or_insert_with(|| {
            self.used.push(known);
            self.used.len() - 1
        })
    }
}

/// The mesh of a primitive; `None` with a note where it holds no triangles.
fn build(
    source: &Source<'_>,
    primitive: &Primitive,
    pose: &Pose,
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
    let source = &mut source.of_primitive(primitive, path, notes)?;
    let vertices = source.count(position, path)?;
    let mut corners = corners(source, primitive, vertices, path, notes)?;
    if corners.is_empty() {
        return Ok(None);
    }
    // Primitives may share a large array of vertices: each takes only what it uses.
    let pick = (corners.len() < vertices).then(|| compact(&mut corners));
    let mut mesh = attributes(source, primitive, position, pick.as_deref(), path, notes)?;
    mesh.corners = corners;
    if let Err(error) = pose.apply(source, primitive, pick.as_deref(), path, &mut mesh) {
        notes.add_at(
            &format!("glTF: a mesh is drawn as it was bound, since its pose cannot be read ({error})"),
            Place::Path(path.to_owned()),
        );
    }
    drop_faces_without_positions(&mut mesh, notes);
    Anchor::default().tell_of_steps(&mesh, notes);
    finish_mesh(&mut mesh, notes);
    Ok(Some(mesh))
}

/// The vertex of each corner of the triangles, by the indices of the primitive if it has them.
fn corners(
    source: &mut Source<'_>,
    primitive: &Primitive,
    vertices: usize,
    path: &str,
    notes: &mut Notes,
) -> Result<Vec<u32>, ReadError> {
    let spend = |count: usize, source: &Source<'_>| {
        let size = 16 * count as u64 + VERTEX_BYTES * vertices.min(count) as u64;
        source.budget.spend(size, source.file, || path.to_owned())
    };
    if let Some(corners) = source.draco.take_corners() {
        spend(corners.len(), source)?;
        return Ok(corners);
    }
    let count = primitive.indices.map_or(Ok(vertices), |indices| source.count(indices, path))?;
    spend(count, source)?;
    let corners = match primitive.indices {
        Some(indices) => source.indices(indices, vertices, &format!("{path}.indices"))?,
        None => (0..vertices as u32).collect(),
    };
    Ok(triangles(corners, primitive.mode.unwrap_or(4), notes))
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

/// The vertices of a primitive: all, or those that `pick` names.
fn attributes(
    source: &Source<'_>,
    primitive: &Primitive,
    position: usize,
    pick: Option<&[u32]>,
    path: &str,
    notes: &mut Notes,
) -> Result<Mesh, ReadError> {
    let uv_sets = primitive.material.map_or([Some(0), None], |material| source.uv_sets(material));
    let uv_names = uv_sets.map(|set| set.map_or(String::new(), |set| format!("TEXCOORD_{set}")));
    let count = source.count(position, path)?;
    let user = format!("{path}.attributes.POSITION");
    let positions = source.floats::<3>(position, &["VEC3"], pick, &user)?;
    let mut mesh = Mesh { positions: positions.into_iter().map(Vec3::from).collect(), ..Mesh::default() };
    let mut reader = Attributes { source, primitive, pick, count, path, notes };
    let normal = "is computed from the faces where it is no finite number";
    mesh.normals = reader.read("NORMAL", &["VEC3"], Vec3::ZERO, normal);
    mesh.tangents =
        reader.read("TANGENT", &["VEC4"], Vec4::ZERO, "is computed anew, since some is no finite number");
    let uvs = [&mut mesh.uvs, &mut mesh.uvs2];
    for (uvs, name) in uvs.into_iter().zip(&uv_names) {
        *uvs = reader.read(name, &["VEC2"], Vec2::ZERO, "is taken as 0 where it is no finite number");
    }
    let white = "is taken as white where it is no finite number";
    mesh.colors = reader.read("COLOR_0", &["VEC3", "VEC4"], Vec4::ONE, white);
    for name in primitive.attributes.keys() {
        let known = ["POSITION", "NORMAL", "TANGENT", "COLOR_0", uv_names[0].as_str(), uv_names[1].as_str()];
        let is_pose = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
        if !known.contains(&name.as_str()) && !is_pose {
            notes.add(&format!("glTF: the attribute {name} is ignored"));
        }
    }
    Ok(mesh)
}

/// A reader of attributes that may be left out.
struct Attributes<'a> {
    source: &'a Source<'a>,
    primitive: &'a Primitive,
    pick: Option<&'a [u32]>,
    /// As many as there are positions.
    count: usize,
    path: &'a str,
    notes: &'a mut Notes,
}

impl Attributes<'_> {
    /// An attribute, empty with a remark where it cannot be read; values that are no numbers are replaced.
    fn read<const N: usize, T: From<[f32; N]> + Copy>(
        &mut self,
        name: &str,
        kinds: &[&str],
        replacement: T,
        why: &str,
    ) -> Vec<T> {
        let Some(&index) = self.primitive.attributes.get(name) else { return Vec::new() };
        let user = format!("{}.attributes.{name}", self.path);
        let values = self
            .checked_count(index, &user)
            .and_then(|()| self.source.floats::<N>(index, kinds, self.pick, &user));
        let values = match values {
            Ok(values) => values,
            Err(error) => {
                let note = format!("glTF: the attribute {name} is left out ({error})");
                self.notes.add_kind_at(&format!("glTF: {name} is left out"), Place::Path(user), || note);
                return Vec::new();
            }
        };
        let mut odd = 0;
        let values = values.into_iter().map(|value| match value.iter().all(|number| number.is_finite()) {
            true => T::from(value),
            false => {
                odd += 1;
                replacement
            }
        });
        let values = values.collect();
        self.notes.add_times(&format!("glTF: the attribute {name} {why}"), odd);
        values
    }

    /// That there is a value for each position.
    fn checked_count(&self, index: usize, user: &str) -> Result<(), ReadError> {
        let found = self.source.count(index, user)?;
        let expected = format!("{} items, as there are positions", self.count);
        match found == self.count {
            true => Ok(()),
            false => Err(self.source.malformed(Place::Path(user.to_owned()), expected, found.to_string())),
        }
    }
}
