//! Under which names the parts of a scene are written.

use std::collections::HashSet;

use crate::builtin::Builtin;
use crate::{Mesh, Object, Scene};

/// How a mesh is written.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum MeshKey {
    /// As a built-in mesh, by each object that has it; with its own colours if it has any.
    Builtin(Builtin),
    /// In a table of this name.
    Table(String),
}

/// The names of all parts.
#[derive(Debug)]
pub(super) struct Names {
    pub textures: Vec<String>,
    pub meshes: Vec<MeshKey>,
    pub materials: Vec<String>,
}

impl Names {
    /// Those of a scene.
    pub(super) fn of(scene: &Scene) -> Self {
        let textures = scene.textures.iter().map(|texture| texture.name.as_str());
        let materials = scene.materials.iter().map(|material| material.name.as_str());
        Self {
            textures: unique(textures, "texture", &[]),
            meshes: mesh_keys(scene),
            materials: unique(materials, "material", &[]),
        }
    }
}

/// The names, with numbers where they are empty, twice or reserved.
fn unique<'a>(names: impl Iterator<Item = &'a str>, what: &str, reserved: &[&str]) -> Vec<String> {
    let mut taken: HashSet<String> = reserved.iter().map(|name| (*name).to_owned()).collect();
    let free = |name: &str| {
        let name = if name.is_empty() { what } else { name };
        let numbered = (2..).map(|number| format!("{name}-{number}"));
        let mut candidates = std::iter::once(name.to_owned()).chain(numbered);
        let free = candidates.find(|name| !taken.contains(name)).expect("there is no end of numbers");
        taken.insert(free.clone());
        free
    };
    names.map(free).collect()
}

/// Meshes in tables come first in a scene that is read, then those that objects name, in the order of the objects.
fn mesh_keys(scene: &Scene) -> Vec<MeshKey> {
    let tables =
        (0..=scene.meshes.len()).find(|first| are_builtin(scene, *first)).unwrap_or(scene.meshes.len());
    let names = unique(scene.meshes[..tables].iter().map(|mesh| mesh.name.as_str()), "mesh", &Builtin::NAMES);
    let builtin = scene.meshes[tables..].iter().filter_map(builtin).map(MeshKey::Builtin);
    names.into_iter().map(MeshKey::Table).chain(builtin).collect()
}

/// Whether the meshes from this number on are different built-in ones in the order in which objects use them.
fn are_builtin(scene: &Scene, first: usize) -> bool {
    let mut order: Vec<usize> = Vec::new();
    let mut named = true;
    for object in scene.objects.iter().filter(|object| object.mesh >= first) {
        if !order.contains(&object.mesh) {
            order.push(object.mesh);
        }
        named &= has_own_name(object);
    }
    let meshes = &scene.meshes[first..];
    let found: Vec<Builtin> = meshes.iter().filter_map(builtin).collect();
    let different = found.iter().enumerate().all(|(i, mesh)| !found[..i].contains(mesh));
    named && found.len() == meshes.len() && different && order.into_iter().eq(first..scene.meshes.len())
}

/// An object without a name gets that of its built-in mesh when it is read.
fn has_own_name(object: &Object) -> bool {
    !object.name.is_empty()
}

/// The built-in mesh that this one is, with its default parameters.
pub(super) fn builtin(mesh: &Mesh) -> Option<Builtin> {
    Builtin::named(&mesh.name).filter(|builtin| builtin.mesh().is_ok_and(|made| made == *mesh))
}
