//! From the objects of a scene file to meshes and objects of a scene.
//!
//! Objects that are made of the same share their meshes; a file is read once.

use std::ops::Range;
use std::path::{Path, PathBuf};

use glam::{DMat4, Vec4};

use super::place::PlaceKeys;
use crate::builtin::Builtin;
use crate::file::build::builder::{Builder, FileModel, Part};
use crate::file::error::Problem;
use crate::file::near::{did_you_mean, list};
use crate::file::tables::geometry::objects::{ColorsName, ColorsValue, MeshValue, NormalsName, ObjectTable};
use crate::file::tables::values::At;
use crate::memory::{check_triangles, texture_bytes};
use crate::read::{Model, ReadOptions, read_model};
use crate::{Camera, Material, Mesh, Normals, Object, Projection};

/// What a mesh is made from. Its `Debug` text names it: equal texts, equal meshes.
#[derive(Debug)]
struct Recipe {
    source: Source,
    normals: Option<Normals>,
    levels: u32,
    colors: Colors,
}

#[derive(Debug)]
enum Source {
    Builtin(Builtin),
    /// One of the scene's own meshes.
    Own(usize),
    /// And the variant of its materials.
    File(FileKey),
}

/// A file of models, and the variant of its materials.
pub(in crate::file) type FileKey = (PathBuf, Option<String>);

#[derive(Debug)]
enum Colors {
    Mesh,
    None,
    Position,
    List(Vec<Vec4>),
}

impl Recipe {
    /// Whether a mesh is used as it is.
    fn is_plain(&self) -> bool {
        self.normals.is_none() && self.levels == 0 && matches!(self.colors, Colors::Mesh)
    }
}

impl Builder {
    pub(in crate::file::build) fn object(&mut self, object: &At<ObjectTable>) -> Result<(), Problem> {
        let transform = object.place().transform()?;
        let material = self.material_index(object)?;
        let program = object.program.as_ref().map(|program| self.program(program)).transpose()?;
        let recipe = self.recipe(object)?;
        let key = format!("{recipe:?}");
        let parts = match self.made.parts.get(&key) {
            Some(parts) => parts.clone(),
            None => {
                let parts = match &recipe.source {
                    Source::Builtin(builtin) => self.builtin(object, builtin, &recipe)?,
                    Source::Own(mesh) => self.own(object, *mesh, &recipe)?,
                    Source::File(key) => self.file(object, key, &recipe)?,
                };
                self.made.parts.insert(key, parts.clone());
                parts
            }
        };
        if let Source::File(key) = &recipe.source {
            self.companions(object, key, &transform);
        }
        self.add_triangles(parts.iter().map(|part| part.triangles), &object.mesh.span)?;
        for part in &parts {
            let name = match (object.name.as_str(), parts.len()) {
                ("", _) => part.name.clone(),
                (name, 1) => name.to_owned(),
                (name, _) => format!("{name}/{}", part.name),
            };
            let material = material.or(part.material).unwrap_or_else(|| self.default_material());
            self.scene.objects.push(Object {
                name,
                mesh: part.mesh,
                material,
                transform: transform * part.transform,
                shading: object.shading,
                interpolation: object.interpolation,
                program,
            });
        }
        Ok(())
    }

    fn recipe(&self, object: &ObjectTable) -> Result<Recipe, Problem> {
        let source = match &object.mesh.value {
            MeshValue::Builtin(builtin) => {
                if let Some(lights) = &object.lights {
                    return Err(Problem::at(&lights.span, "a built-in mesh has no lights"));
                }
                Source::Builtin(*builtin)
            }
            MeshValue::Named(name) => Source::Own(self.own_mesh(name, &object.mesh.span)?),
            MeshValue::File(file) => {
                let variant = object.variant.as_ref().map(|variant| variant.value.clone());
                Source::File((self.resolve(file, &file.span)?, variant))
            }
        };
        if let (Some(variant), false) = (&object.variant, matches!(source, Source::File(_))) {
            return Err(Problem::at(&variant.span, "a variant is of the materials of a glTF file"));
        }
        let builtin = matches!(source, Source::Builtin(_));
        let colors = match object.colors.as_ref().map(|colors| &colors.value) {
            None if builtin && object.material.is_some() => Colors::None,
            None | Some(ColorsValue::Name(ColorsName::Mesh)) => Colors::Mesh,
            Some(ColorsValue::Name(ColorsName::None)) => Colors::None,
            Some(ColorsValue::Name(ColorsName::Position)) => Colors::Position,
            Some(ColorsValue::List(list)) => {
                Colors::List(list.iter().map(|color| glam::Vec3::from_array(color.0.0).extend(1.0)).collect())
            }
        };
        let levels = object.subdivide.as_ref().map_or(0, |levels| levels.0);
        Ok(Recipe { source, normals: object.normals()?, levels, colors })
    }

    /// The material that the object names.
    fn material_index(&mut self, object: &ObjectTable) -> Result<Option<usize>, Problem> {
        let Some(name) = &object.material else { return Ok(None) };
        let known = self.names.materials.get(name.as_str()).or_else(|| self.names.library.get(name.as_str()));
        if let Some(index) = known {
            return Ok(Some(*index));
        }
        let material = self.found_in_library(name)?;
        let index = self.scene.materials.len();
        self.scene.materials.push(material);
        self.names.library.insert(name.value.clone(), index);
        Ok(Some(index))
    }

    fn default_material(&mut self) -> usize {
        *self.names.default_material.get_or_insert_with(|| {
            self.scene.materials.push(Material::default_gray());
            self.scene.materials.len() - 1
        })
    }

    fn builtin(
        &mut self,
        object: &ObjectTable,
        builtin: &Builtin,
        recipe: &Recipe,
    ) -> Result<Vec<Part>, Problem> {
        let span = &object.mesh.span;
        self.check_budget(subdivided_count(builtin.triangle_count(), recipe.levels), span)?;
        let mesh = builtin.mesh().map_err(|error| Problem::at(span, error.to_string()))?;
        let mesh = finish(mesh, object, recipe)?;
        let (name, triangles) = (mesh.name.clone(), mesh.triangle_count() as u64);
        let part =
            Part { name, mesh: self.add_mesh(mesh), material: None, transform: DMat4::IDENTITY, triangles };
        Ok(vec![part])
    }

    /// The number of one of the scene's own meshes.
    fn own_mesh(&self, name: &str, span: &Range<usize>) -> Result<usize, Problem> {
        self.names.meshes.get(name).copied().ok_or_else(|| {
            let own = self.names.meshes.keys().map(String::as_str);
            let known: Vec<&str> = own.chain(Builtin::NAMES).collect();
            let shown = name.chars().take(40).collect::<String>();
            let near = did_you_mean(name, known.iter().copied());
            // A file's name in place of a table is the likeliest of all mistakes here.
            let advice = match name.contains('.') {
                true => "; for a file, write { file = \"..\" }".to_owned(),
                false => format!("; the meshes are: {}", list(known)),
            };
            let more = if near.is_empty() { advice } else { near };
            Problem::at(span, format!("unknown mesh '{shown}'{more}"))
        })
    }

    /// One of the scene's own meshes, whose objects have no name but their own.
    fn own(&mut self, object: &ObjectTable, mesh: usize, recipe: &Recipe) -> Result<Vec<Part>, Problem> {
        let mut part = Part {
            name: String::new(),
            mesh,
            material: None,
            transform: DMat4::IDENTITY,
            triangles: self.scene.meshes[mesh].triangle_count() as u64,
        };
        if !recipe.is_plain() {
            self.check_budget(subdivided_count(part.triangles, recipe.levels), &object.mesh.span)?;
            let finished = finish(self.scene.meshes[mesh].clone(), object, recipe)?;
            part.triangles = finished.triangle_count() as u64;
            part.mesh = self.add_mesh(finished);
        }
        Ok(vec![part])
    }

    fn add_mesh(&mut self, mesh: Mesh) -> usize {
        self.scene.meshes.push(mesh);
        self.scene.meshes.len() - 1
    }

    fn file(&mut self, object: &ObjectTable, key: &FileKey, recipe: &Recipe) -> Result<Vec<Part>, Problem> {
        if !self.made.files.contains_key(key) {
            let model = self.read_file(key, object)?;
            self.made.files.insert(key.clone(), model);
        }
        let mut parts = self.made.files[key].parts.clone();
        if recipe.is_plain() {
            return Ok(parts);
        }
        let triangles: u64 = parts.iter().map(|part| part.triangles).sum();
        self.check_budget(subdivided_count(triangles, recipe.levels), &object.mesh.span)?;
        // Parts may share meshes; so do those that are made of them.
        let mut made = std::collections::HashMap::new();
        for part in &mut parts {
            let mesh = match made.get(&part.mesh) {
                Some(mesh) => *mesh,
                None => {
                    let mesh = finish(self.scene.meshes[part.mesh].clone(), object, recipe)?;
                    let index = self.add_mesh(mesh);
                    made.insert(part.mesh, index);
                    index
                }
            };
            part.mesh = mesh;
            part.triangles = self.scene.meshes[mesh].triangle_count() as u64;
        }
        Ok(parts)
    }

    fn read_file(&mut self, (path, variant): &FileKey, object: &ObjectTable) -> Result<FileModel, Problem> {
        let options = ReadOptions { variant: variant.clone(), ..self.input.options.clone() };
        let span = &object.mesh.span;
        let mut model = read_model(path, &options).map_err(|error| {
            // What can be read without the variant has none of this name.
            let plain = ReadOptions { variant: None, ..options.clone() };
            let variant = object.variant.as_ref().filter(|_| read_model(path, &plain).is_ok());
            Problem::at(variant.map_or(span, |variant| &variant.span), error.to_string())
        })?;
        let textures = model.textures.iter().map(|texture| texture_bytes(texture.width, texture.height));
        let file = file_name(path);
        self.take(format_args!("the textures of '{file}'"), textures.sum(), span)?;
        self.input.notes.extend(model.notes.iter().map(|note| format!("{file}: {note}")));
        let cameras = std::mem::take(&mut model.cameras);
        let lights = Model { lights: std::mem::take(&mut model.lights), ..Model::default() };
        let range = model.append_to(&mut self.scene, DMat4::IDENTITY, None, false);
        // They come back one by one, with the transform of each object of the scene file.
        let meshes = &self.scene.meshes;
        let parts = self.scene.objects.drain(range).map(|object| Part {
            triangles: meshes[object.mesh].triangle_count() as u64,
            name: object.name,
            mesh: object.mesh,
            material: Some(object.material),
            transform: object.transform,
        });
        Ok(FileModel { parts: parts.collect(), lights, cameras })
    }

    /// Brings along what a file has beside its meshes.
    fn companions(&mut self, object: &ObjectTable, key: &FileKey, transform: &DMat4) {
        let (file, path) = (&self.made.files[key], &key.0);
        for (name, camera) in &file.cameras {
            self.made.cameras.push((name.clone(), moved(camera, transform)));
        }
        let count = file.lights.lights.len();
        if let Some(lights) = object.lights.as_ref().filter(|lights| lights.value && count > 0) {
            // A file's lights come in classic units.
            self.units.classic.push(lights.span.clone());
            file.lights.clone().append_to(&mut self.scene, *transform, None, true);
        } else if count > 0 {
            let file = file_name(path);
            let note = format!("{file}: its lights ({count}) are left out; 'lights = true' takes them along");
            if !self.input.notes.contains(&note) {
                self.input.notes.push(note);
            }
        }
    }

    fn add_triangles(
        &mut self,
        parts: impl Iterator<Item = u64>,
        span: &Range<usize>,
    ) -> Result<(), Problem> {
        self.made.triangles = parts.fold(self.made.triangles, u64::saturating_add);
        self.check_budget(0, span)
    }

    /// Refuses more triangles than can be drawn, or than there is memory for, before they are made.
    pub(in crate::file::build) fn check_budget(&self, more: u64, span: &Range<usize>) -> Result<(), Problem> {
        let triangles = self.made.triangles.saturating_add(more);
        check_triangles(triangles, self.input.options.memory).map_err(|message| Problem::at(span, message))
    }

    /// Takes out the meshes of files of which only others were made.
    pub(in crate::file::build) fn drop_unused_meshes(&mut self) {
        let mut index = vec![None; self.scene.meshes.len()];
        index[..self.names.meshes.len()].fill(Some(0));
        self.scene.objects.iter().for_each(|object| index[object.mesh] = Some(0));
        let mut used = index.iter().map(Option::is_some).collect::<Vec<_>>().into_iter();
        self.scene.meshes.retain(|_| used.next().unwrap_or(false));
        index.iter_mut().flatten().enumerate().for_each(|(new, slot)| *slot = new);
        for object in &mut self.scene.objects {
            object.mesh = index[object.mesh].expect("it is in use");
        }
    }
}

/// The mesh with the colours, subdivisions and normals that the object asks for.
fn finish(mut mesh: Mesh, object: &ObjectTable, recipe: &Recipe) -> Result<Mesh, Problem> {
    match (&recipe.colors, &object.colors) {
        (Colors::List(colors), Some(at)) => {
            let (found, expected) = (colors.len(), mesh.positions.len());
            if found != expected {
                let message = format!("expected {expected} colours, one for each vertex, found {found}");
                return Err(Problem::at(&at.span, message));
            }
            mesh.colors.clone_from(colors);
        }
        (Colors::None, _) => mesh.colors = Vec::new(),
        (Colors::Position, _) => mesh.colors = colors_of_positions(&mesh),
        _ => {}
    }
    if let Some(levels) = object.subdivide.as_ref().filter(|levels| levels.0 > 0) {
        mesh = mesh.subdivided(levels.0).map_err(|error| Problem::at(&levels.span, error.to_string()))?;
    }
    Ok(match recipe.normals {
        Some(normals) => mesh.with_normals(normals),
        None => mesh,
    })
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// The number of triangles after so many subdivisions.
fn subdivided_count(triangles: u64, levels: u32) -> u64 {
    triangles.saturating_mul(4_u64.saturating_pow(levels))
}

/// The camera moved with an object.
fn moved(camera: &Camera, transform: &DMat4) -> Camera {
    let up = transform.transform_vector3(camera.up);
    let projection = match camera.projection {
        Projection::Orthographic { height } => {
            Projection::Orthographic { height: height * up.length() / camera.up.length() }
        }
        perspective @ Projection::Perspective { .. } => perspective,
    };
    let [eye, target] = [camera.eye, camera.target].map(|point| transform.transform_point3(point));
    Camera { eye, target, up, projection }
}

impl ObjectTable {
    /// What was asked for the object's normals.
    pub(crate) fn normals(&self) -> Result<Option<Normals>, Problem> {
        let name = self.normals.as_ref().map(|n| n.value);
        match (name, &self.crease_deg) {
            (Some(NormalsName::Given | NormalsName::Facet), Some(crease)) => {
                Err(Problem::at(&crease.span, "'crease_deg' needs normals = \"smooth\""))
            }
            (None, None) => Ok(None),
            (Some(NormalsName::Given), None) => Ok(Some(Normals::Given)),
            (Some(NormalsName::Facet), None) => Ok(Some(Normals::Facet)),
            (Some(NormalsName::Smooth) | None, crease) => {
                let degrees = crease.as_ref().map_or(180.0, |c| c.0);
                Ok(Some(Normals::Smooth { crease: degrees.to_radians() }))
            }
        }
    }

    /// The keys that place the object.
    pub(crate) fn place(&self) -> PlaceKeys<'_> {
        PlaceKeys {
            translate: self.translate.as_ref(),
            rotate_deg: self.rotate_deg.as_ref(),
            scale: self.scale.as_ref(),
            matrix: self.matrix.as_ref(),
        }
    }
}

/// Linear red, green and blue by where vertices are, from 0 to 1 across the mesh; one half where it has no extent.
fn colors_of_positions(mesh: &Mesh) -> Vec<Vec4> {
    let bounds = mesh.bounds();
    let (low, size) = (bounds.min, bounds.max - bounds.min);
    let channel = |at: f64, low: f64, size: f64| if size > 0.0 { ((at - low) / size) as f32 } else { 0.5 };
    let color = |at: &glam::Vec3| {
        let at = at.as_dvec3();
        let [r, g, b] = [0, 1, 2].map(|axis| channel(at[axis], low[axis], size[axis]));
        Vec4::new(r, g, b, 1.0)
    };
    mesh.positions.iter().map(color).collect()
}
