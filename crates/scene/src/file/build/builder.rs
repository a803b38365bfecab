//! The builder: what is known while tables become a scene.

use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DMat4;
use glanz_bsdf::FactorTable;
use glanz_math::MemoryBudget;

use super::geometry::objects::FileKey;
use crate::file::error::Problem;
use crate::file::tables::values::At;
use crate::read::{Model, ReadOptions};
use crate::{Camera, ChannelUse, EnvironmentMap, Material, Profile, Scene};

/// The way from tables to a scene.
pub(in crate::file) struct Builder {
    /// The scene so far.
    pub scene: Scene,
    /// The scene file's folder, and what was read of it.
    pub input: Input,
    /// Names, and what they stand for in the scene.
    pub names: Names,
    /// What was made so far, so that equal things are made once.
    pub made: Made,
    /// Where light is given in physical units, and where in classic ones.
    pub units: Units,
}

/// The scene file's folder, and what was read of it.
pub(in crate::file) struct Input {
    /// The folder that references are relative to.
    pub base: PathBuf,
    /// The limits of what is read.
    pub options: ReadOptions,
    /// What was ignored or approximated.
    pub notes: Vec<String>,
}

/// Indices in the scene, by name.
#[derive(Default)]
pub(in crate::file) struct Names {
    /// The scene's own materials.
    pub materials: BTreeMap<String, usize>,
    /// The materials that objects took from the library.
    pub library: BTreeMap<String, usize>,
    /// The material of objects that name none.
    pub default_material: Option<usize>,
    /// Textures that materials call by name.
    pub textures: BTreeMap<String, usize>,
    /// Meshes that objects call by name.
    pub meshes: BTreeMap<String, usize>,
}

/// What was made so far.
#[derive(Default)]
pub(in crate::file) struct Made {
    /// The models of files.
    pub files: HashMap<FileKey, FileModel>,
    /// What objects were made of, by their recipes.
    pub parts: HashMap<String, Vec<Part>>,
    /// The cameras of files, moved with their objects.
    pub cameras: Vec<(String, Camera)>,
    /// How many triangles all objects have.
    pub triangles: u64,
    /// Environment maps, by the names of their files.
    pub environments: HashMap<String, Arc<EnvironmentMap>>,
    /// Luminaire profiles, by the names of their files.
    pub profiles: HashMap<String, Arc<Profile>>,
    /// Measured reflectance, by what is said of it.
    pub measured: HashMap<String, Material>,
    /// Tables of factors, by the names of their files.
    pub factors: HashMap<String, Arc<FactorTable>>,
    /// Textures, by file and use.
    pub textures: HashMap<String, usize>,
    /// The channels of pictures that the material being made has.
    pub channels: Vec<ChannelUse>,
}

/// A mesh of something, placed relative to the whole.
#[derive(Clone)]
pub(in crate::file) struct Part {
    pub name: String,
    pub mesh: usize,
    /// A file's own material.
    pub material: Option<usize>,
    pub transform: DMat4,
    pub triangles: u64,
}

/// What a file holds, of which meshes, textures and materials are already in the scene.
pub(in crate::file) struct FileModel {
    pub parts: Vec<Part>,
    /// The lights alone.
    pub lights: Model,
    pub cameras: Vec<(String, Camera)>,
}

/// Where in the scene file the strength of light is given in which units.
#[derive(Default)]
pub(in crate::file) struct Units {
    pub photometric: Vec<Range<usize>>,
    pub classic: Vec<Range<usize>>,
}

impl Builder {
    /// References are relative to `base` and do not leave it unless `allow_outside`; what they take is taken off `memory`.
    pub(crate) fn new(base: &Path, allow_outside: bool, memory: MemoryBudget) -> Self {
        // An empty path is the current folder.
        let base = if base.as_os_str().is_empty() { PathBuf::from(".") } else { base.to_owned() };
        let root = Some(base.clone());
        let options = ReadOptions { root, allow_outside, memory, ..ReadOptions::default() };
        Self {
            scene: Scene::default(),
            input: Input { base, options, notes: Vec::new() },
            names: Names::default(),
            made: Made::default(),
            units: Units::default(),
        }
    }

    /// Takes memory off the budget for what stands at `span`.
    pub(in crate::file::build) fn take(
        &mut self,
        what: impl fmt::Display,
        bytes: u64,
        span: &Range<usize>,
    ) -> Result<(), Problem> {
        self.input.options.memory.take(what, bytes).map_err(|over| Problem::at(span, over.to_string()))
    }
}

/// Tables by name, in the order in which they stand in the file.
pub(super) fn in_order<T>(tables: &BTreeMap<String, At<T>>) -> Vec<(&String, &At<T>)> {
    let mut list: Vec<_> = tables.iter().collect();
    list.sort_by_key(|(_, table)| table.span.start);
    list
}
