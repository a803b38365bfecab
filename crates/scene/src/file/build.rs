//! From the tables of a scene file to a scene.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::path::{Path, PathBuf};

use glam::{DMat4, Vec4};
use glanz_color::Rgb;

use super::error::Problem;
use super::hash::Hash;
use super::materials::{FilterName, MaterialTable, TextureValue, WrapName};
use super::near::{did_you_mean, list};
use super::objects::{ColorsName, ColorsValue, MeshValue, ObjectTable};
use super::types::{CameraRef, CameraTable, ProjectionName, SceneTable};
use super::values::At;
use crate::builtin::{Builtin, MAX_TRIANGLES};
use crate::read::{
    FolderFiles, Model, ReadOptions, ResolveError, Resolver, read_model, read_texture, resolve,
};
use crate::{
    Camera, Image, Light, LightColors, LightKind, Material, Mesh, Normals, Object, Projection,
    RenderSettings, Scene, Space, Texture, TextureFilter, TextureUse, Wrap,
};

/// What an object's mesh is made from; objects that agree in all of it share the mesh.
#[derive(Debug, Clone, PartialEq)]
struct MeshKey {
    source: MeshSource,
    normals: Option<Normals>,
    levels: u32,
    colors: Colors,
    lights: bool,
    /// The material, where that of a file is replaced.
    material: Option<usize>,
}

#[derive(Debug, Clone, PartialEq)]
enum MeshSource {
    Builtin(Builtin),
    File(PathBuf),
}

#[derive(Debug, Clone, PartialEq)]
enum Colors {
    Mesh,
    None,
    List(Vec<Vec4>),
}

/// Something that was put into the scene and may be put there again.
struct Placed {
    key: MeshKey,
    /// Its objects, placed relative to the whole.
    objects: Vec<Object>,
    triangles: u64,
    /// The lights that come along, and nothing else.
    lights: Model,
    cameras: Vec<(String, Camera)>,
}

/// The way from tables to a scene.
pub(crate) struct Builder {
    base: PathBuf,
    options: ReadOptions,
    pub scene: Scene,
    pub notes: Vec<String>,
    pub hash: Hash,
    material_names: BTreeMap<String, usize>,
    default_material: Option<usize>,
    placed: Vec<Placed>,
    textures: HashMap<String, usize>,
    cameras: Vec<(String, Camera)>,
    hashed: Vec<PathBuf>,
    triangles: u64,
}

impl Builder {
    /// References are relative to `base` and do not leave it unless `allow_outside`.
    pub fn new(base: &Path, allow_outside: bool, hash: Hash) -> Self {
        // An empty path is the current folder.
        let base = if base.as_os_str().is_empty() { PathBuf::from(".") } else { base.to_owned() };
        let options = ReadOptions { root: Some(base.clone()), allow_outside, ..ReadOptions::default() };
        Self {
            base,
            options,
            scene: Scene::default(),
            notes: Vec::new(),
            hash,
            material_names: BTreeMap::new(),
            default_material: None,
            placed: Vec::new(),
            textures: HashMap::new(),
            cameras: Vec::new(),
            hashed: Vec::new(),
            triangles: 0,
        }
    }

    /// Fills the scene.
    pub fn build(&mut self, table: &SceneTable) -> Result<(), Problem> {
        self.scene.image = Image {
            width: table.image.width.0,
            height: table.image.height.0,
            samples: table.image.samples.0,
            supersample: table.image.supersample,
            background: table.image.background.0,
        };
        self.scene.render = RenderSettings {
            shading: table.render.shading.shading(),
            interpolation: table.render.interpolation.interpolation(),
        };
        if let Some(ambient) = &table.ambient {
            self.scene.lights.push(Light {
                name: "ambient".to_owned(),
                kind: LightKind::Ambient,
                colors: LightColors { ambient: ambient.color.0, ..LightColors::all(Rgb::BLACK) },
                space: Space::World,
            });
        }
        for light in &table.lights {
            self.scene.lights.push(light.build(&light.span)?);
        }
        for (name, material) in &table.materials {
            let built = self.material(name, material)?;
            self.material_names.insert(name.clone(), self.scene.materials.len());
            self.scene.materials.push(built);
        }
        for object in &table.objects {
            self.object(object)?;
        }
        // Last, since it may be a camera of an object's file.
        self.scene.camera = table.camera.as_ref().map(|camera| self.camera(camera)).transpose()?;
        Ok(())
    }

    fn camera(&self, camera: &At<CameraRef>) -> Result<Camera, Problem> {
        match &camera.value {
            CameraRef::Table(table) => table.build(&camera.span),
            CameraRef::Name(name) => {
                let found = self.cameras.iter().find(|(known, _)| known == name);
                found.map(|(_, camera)| *camera).ok_or_else(|| {
                    let known = || self.cameras.iter().map(|(name, _)| name.as_str());
                    let message = format!("unknown camera '{name}'{}", did_you_mean(name, known()));
                    Problem::at(&camera.span, message)
                        .help(format!("the cameras in the files of the objects are: {}", list(known())))
                })
            }
        }
    }

    fn material(&mut self, name: &str, table: &MaterialTable) -> Result<Material, Problem> {
        let mut material = table.build(name, &mut self.notes)?;
        material.base_color = self.texture_use(table.base_color_texture.as_ref(), true)?;
        material.normal_map = self.texture_use(table.normal_texture.as_ref(), false)?;
        material.emission_map = self.texture_use(table.emission_texture.as_ref(), true)?;
        Ok(material)
    }

    fn texture_use(
        &mut self,
        value: Option<&At<TextureValue>>,
        srgb: bool,
    ) -> Result<Option<TextureUse>, Problem> {
        let Some(value) = value else { return Ok(None) };
        let table = &value.0;
        let key = format!("{}\n{}\n{}\n{srgb}", table.file, table.wrap.name(), table.filter.name());
        let texture = match self.textures.get(&key) {
            Some(texture) => *texture,
            None => {
                let texture = self.texture(value, srgb)?;
                self.scene.textures.push(texture);
                self.textures.insert(key, self.scene.textures.len() - 1);
                self.scene.textures.len() - 1
            }
        };
        let mut texture_use = TextureUse::plain(texture);
        if let Some([u, v]) = table.repeat {
            texture_use.transform = [[u.0 as f32, 0.0, 0.0], [0.0, v.0 as f32, 0.0]];
        }
        texture_use.scale = table.scale.map_or(1.0, |scale| scale.0 as f32);
        Ok(Some(texture_use))
    }

    fn texture(&mut self, value: &At<TextureValue>, srgb: bool) -> Result<Texture, Problem> {
        let table = &value.0;
        let bytes = FolderFiles::new(&self.base, &self.options)
            .read(&table.file)
            .map_err(|error| unresolved(&table.file, &error, &value.span))?;
        self.hash.bytes(&bytes);
        let texture = read_texture(&bytes, &table.file, &self.options)
            .map_err(|error| Problem::at(&value.span, error.to_string()))?;
        let wrap = match table.wrap {
            WrapName::Repeat => Wrap::Repeat,
            WrapName::Mirror => Wrap::Mirror,
            WrapName::Clamp => Wrap::Clamp,
        };
        let filter = match table.filter {
            FilterName::Trilinear => TextureFilter::Trilinear,
            FilterName::Nearest => TextureFilter::Nearest,
        };
        Ok(Texture { wrap: [wrap; 2], filter, srgb, ..texture })
    }

    /// The file that the scene names, if it may be read.
    fn resolve(&self, reference: &str, span: &Range<usize>) -> Result<PathBuf, Problem> {
        resolve(&self.base, reference, &self.options).map_err(|error| unresolved(reference, &error, span))
    }

    /// Adds a file's bytes to the hash, once. A file that cannot be read is left out: its reader will
    /// say so.
    fn hash_file(&mut self, path: &Path) {
        if self.hashed.iter().any(|known| known == path) {
            return;
        }
        self.hashed.push(path.to_owned());
        let Ok(mut file) = std::fs::File::open(path) else { return };
        let mut buffer = vec![0; 1 << 16];
        while let Ok(length) = std::io::Read::read(&mut file, &mut buffer) {
            if length == 0 {
                break;
            }
            self.hash.bytes(&buffer[..length]);
        }
    }

    fn object(&mut self, object: &At<ObjectTable>) -> Result<(), Problem> {
        let transform = object.place().transform()?;
        let key = self.mesh_key(object)?;
        let placed = match self.placed.iter().position(|placed| placed.key == key) {
            Some(placed) => placed,
            None => {
                let placed = match &key.source {
                    MeshSource::Builtin(builtin) => self.builtin(object, *builtin, key.clone())?,
                    MeshSource::File(path) => {
                        let path = path.clone();
                        self.file(object, &path, key.clone())?
                    }
                };
                self.placed.push(placed);
                self.placed.len() - 1
            }
        };
        let placed = &self.placed[placed];
        self.triangles = self.triangles.saturating_add(placed.triangles);
        let count = placed.objects.len();
        let shading = object.shading.map(|s| s.shading());
        let interpolation = object.interpolation.map(|i| i.interpolation());
        for part in &placed.objects {
            let name = match (object.name.as_str(), count) {
                ("", _) => part.name.clone(),
                (name, 1) => name.to_owned(),
                (name, _) => format!("{name}/{}", part.name),
            };
            let transform = transform * part.transform;
            self.scene.objects.push(Object { name, transform, shading, interpolation, ..part.clone() });
        }
        placed.lights.clone().append_to(&mut self.scene, transform, None, true);
        self.cameras
            .extend(placed.cameras.iter().map(|(name, camera)| (name.clone(), moved(camera, &transform))));
        self.check_budget(0, &object.mesh.span)
    }

    /// Refuses more triangles than can be drawn, before they are made.
    fn check_budget(&self, more: u64, span: &Range<usize>) -> Result<(), Problem> {
        match self.triangles.saturating_add(more) {
            0..=MAX_TRIANGLES => Ok(()),
            found => {
                let message = format!(
                    "expected at most {MAX_TRIANGLES} triangles in a scene, found {found} up to here"
                );
                Err(Problem::at(span, message))
            }
        }
    }

    fn mesh_key(&mut self, object: &ObjectTable) -> Result<MeshKey, Problem> {
        let source = match &object.mesh.value {
            MeshValue::Builtin(builtin) => {
                if let Some(lights) = &object.lights {
                    return Err(Problem::at(&lights.span, "a built-in mesh has no lights"));
                }
                MeshSource::Builtin(*builtin)
            }
            MeshValue::File(file) => MeshSource::File(self.resolve(file, &file.span)?),
        };
        let builtin = matches!(source, MeshSource::Builtin(_));
        let colors = match object.colors.as_ref().map(|colors| &colors.value) {
            None if builtin && object.material.is_some() => Colors::None,
            None | Some(ColorsValue::Name(ColorsName::Mesh)) => Colors::Mesh,
            Some(ColorsValue::Name(ColorsName::None)) => Colors::None,
            Some(ColorsValue::List(list)) => {
                Colors::List(list.iter().map(|color| Vec4::from_array(with_alpha(color.0))).collect())
            }
        };
        Ok(MeshKey {
            source,
            normals: object.normals()?,
            levels: object.subdivide.as_ref().map_or(0, |levels| levels.0),
            colors,
            lights: object.lights.as_ref().is_some_and(|lights| lights.value),
            material: self.material_index(object, builtin)?,
        })
    }

    /// The material that the object names; `None` for those of a file.
    fn material_index(&mut self, object: &ObjectTable, builtin: bool) -> Result<Option<usize>, Problem> {
        match &object.material {
            Some(name) => {
                let index = self.material_names.get(name.as_str());
                index.copied().map(Some).ok_or_else(|| {
                    let known = || self.material_names.keys().map(String::as_str);
                    let message = format!("unknown material '{}'{}", name.value, did_you_mean(name, known()));
                    Problem::at(&name.span, message).help(format!("the materials are: {}", list(known())))
                })
            }
            None if builtin => {
                let index = *self.default_material.get_or_insert_with(|| {
                    self.scene.materials.push(Material::default_gray());
                    self.scene.materials.len() - 1
                });
                Ok(Some(index))
            }
            None => Ok(None),
        }
    }

    fn builtin(&mut self, object: &ObjectTable, builtin: Builtin, key: MeshKey) -> Result<Placed, Problem> {
        let span = &object.mesh.span;
        self.check_budget(subdivided_count(builtin.triangle_count(), key.levels), span)?;
        let mesh = builtin.mesh().map_err(|error| Problem::at(span, error.to_string()))?;
        let mesh = self.finish_mesh(mesh, object, &key)?;
        let triangles = mesh.triangle_count() as u64;
        let part = Object {
            name: mesh.name.clone(),
            mesh: self.scene.meshes.len(),
            material: key.material.expect("objects of built-in meshes have one"),
            transform: DMat4::IDENTITY,
            shading: None,
            interpolation: None,
        };
        self.scene.meshes.push(mesh);
        Ok(Placed { key, objects: vec![part], triangles, lights: Model::default(), cameras: Vec::new() })
    }

    fn file(&mut self, object: &ObjectTable, path: &Path, key: MeshKey) -> Result<Placed, Problem> {
        let span = &object.mesh.span;
        self.hash_file(path);
        let mut model =
            read_model(path, &self.options).map_err(|error| Problem::at(span, error.to_string()))?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        self.notes.extend(model.notes.iter().map(|note| format!("{name}: {note}")));
        self.check_budget(subdivided_count(model.triangle_count() as u64, key.levels), span)?;
        let meshes = std::mem::take(&mut model.meshes);
        model.meshes =
            meshes.into_iter().map(|mesh| self.finish_mesh(mesh, object, &key)).collect::<Result<_, _>>()?;
        let triangles = model.triangle_count() as u64;
        let cameras = std::mem::take(&mut model.cameras);
        let mut lights = Model { lights: std::mem::take(&mut model.lights), ..Model::default() };
        if !key.lights && !lights.lights.is_empty() {
            let count = lights.lights.len();
            self.notes
                .push(format!("{name}: its {count} lights are left out; 'lights = true' takes them along"));
            lights.lights.clear();
        }
        let range = model.append_to(&mut self.scene, DMat4::IDENTITY, key.material, false);
        // They come back one by one, with the transform of each object of the scene file.
        let objects = self.scene.objects.drain(range).collect();
        Ok(Placed { key, objects, triangles, lights, cameras })
    }

    fn finish_mesh(&self, mut mesh: Mesh, object: &ObjectTable, key: &MeshKey) -> Result<Mesh, Problem> {
        match &key.colors {
            Colors::Mesh => {}
            Colors::None => mesh.colors = Vec::new(),
            Colors::List(colors) if colors.len() == mesh.positions.len() => mesh.colors = colors.clone(),
            Colors::List(colors) => {
                let (found, expected) = (colors.len(), mesh.positions.len());
                let message = format!("expected {expected} colours, one for each vertex, found {found}");
                return Err(Problem::at(&object.colors.as_ref().expect("given").span, message));
            }
        }
        if key.levels > 0 {
            let span = &object.subdivide.as_ref().expect("more levels than none are given").span;
            mesh = mesh.subdivided(key.levels).map_err(|error| Problem::at(span, error.to_string()))?;
        }
        Ok(match key.normals {
            Some(normals) => mesh.with_normals(normals),
            None => mesh,
        })
    }
}

fn unresolved(reference: &str, error: &ResolveError, span: &Range<usize>) -> Problem {
    match error {
        ResolveError::Outside(_) => {
            Problem::at(span, format!("'{reference}' leaves the folder of the scene file"))
                .help("files elsewhere are read only where that is allowed explicitly")
        }
        ResolveError::Missing => Problem::at(span, format!("there is no file '{reference}'"))
            .help("file names are relative to the scene file"),
        ResolveError::TooLarge { limit, found } => {
            Problem::at(span, format!("'{reference}' has {found} bytes; at most {limit} are read"))
        }
        ResolveError::Io(error) => Problem::at(span, format!("'{reference}' cannot be read: {error}")),
    }
}

fn with_alpha(color: Rgb) -> [f32; 4] {
    let [r, g, b] = color.0;
    [r, g, b, 1.0]
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

impl CameraTable {
    fn build(&self, span: &Range<usize>) -> Result<Camera, Problem> {
        let eye = self.eye.0;
        let target = self.target.as_ref().map_or(glam::DVec3::ZERO, |target| target.0);
        // Below this the direction between them is lost in the rounding of the coordinates.
        if (eye - target).length() <= 1e-12 * eye.length().max(1.0) {
            let span = self.target.as_ref().map_or(&self.eye.span, |target| &target.span);
            return Err(Problem::at(span, "'eye' and 'target' are the same point; they must differ"));
        }
        let projection = match (self.projection, &self.fov_deg, &self.height) {
            (ProjectionName::Perspective, _, Some(height)) => {
                return Err(Problem::at(&height.span, "'height' needs projection = \"orthographic\""));
            }
            (ProjectionName::Orthographic, Some(fov), _) => {
                return Err(Problem::at(&fov.span, "an orthographic camera has no 'fov_deg'")
                    .help("'height' says how much it shows, in metres"));
            }
            (ProjectionName::Orthographic, None, None) => {
                return Err(Problem::at(span, "an orthographic camera needs 'height', which is missing"));
            }
            (ProjectionName::Orthographic, None, Some(height)) => {
                Projection::Orthographic { height: height.0 }
            }
            (ProjectionName::Perspective, fov, None) => {
                Projection::Perspective { fov_y: fov.as_ref().map_or(40.0, |fov| fov.0).to_radians() }
            }
        };
        let up = self.up.map_or(glam::DVec3::Y, |up| up.0);
        Ok(Camera { eye, target, up, projection })
    }
}
