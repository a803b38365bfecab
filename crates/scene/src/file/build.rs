//! From the tables of a scene file to a scene: all but the objects.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::error::Problem;
use super::hash::Hash;
use super::instances::{FileModel, Part};
use super::materials::{MaterialTable, TextureValue};
use super::near::{did_you_mean, list};
use super::spectra::for_luminance;
use super::types::{AmbientTable, CameraRef, CameraTable, ProjectionName, SceneTable};
use super::values::{At, FieldOfView};
use crate::builtin::Builtin;
use crate::read::{FolderFiles, ReadOptions, ResolveError, Resolver, read_texture, resolve};
use crate::{
    Camera, EnvironmentMap, Image, Light, LightColor, LightColors, LightKind, Material, Profile, Projection,
    RenderSettings, Scene, Texture, TextureFilter, TextureUse, Wrap,
};

/// The picture of a texture and how it is taken. Its `Debug` text names it.
#[derive(Debug)]
struct TextureSource<'a> {
    file: &'a str,
    wrap: [Wrap; 2],
    filter: TextureFilter,
    srgb: bool,
}

/// The way from tables to a scene.
pub(super) struct Builder {
    base: PathBuf,
    pub(super) options: ReadOptions,
    pub(super) scene: Scene,
    pub(super) notes: Vec<String>,
    pub(super) hash: Hash,
    pub(super) material_names: BTreeMap<String, usize>,
    /// The materials that objects took from the library.
    pub(super) library_names: BTreeMap<String, usize>,
    /// The index of the material of objects that name none.
    pub(super) default_material: Option<usize>,
    /// The models of the files read so far.
    pub(super) files: HashMap<PathBuf, FileModel>,
    /// What objects were made of so far, so that equal ones share their meshes.
    pub(super) parts: HashMap<String, Vec<Part>>,
    /// The cameras of the files, moved with their objects.
    pub(super) cameras: Vec<(String, Camera)>,
    /// How many triangles all objects have so far.
    pub(super) triangles: u64,
    /// Where light is given in physical units, and where in classic ones.
    pub(super) photometric: Vec<Range<usize>>,
    pub(super) classic: Vec<Range<usize>>,
    /// Surroundings and profiles, by the names of their files.
    pub(super) environments: HashMap<String, Arc<EnvironmentMap>>,
    pub(super) profiles: HashMap<String, Arc<Profile>>,
    textures: HashMap<String, usize>,
    texture_names: BTreeMap<String, usize>,
    /// The meshes that objects call by their names.
    pub(super) mesh_names: BTreeMap<String, usize>,
    hashed: HashSet<PathBuf>,
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
            library_names: BTreeMap::new(),
            default_material: None,
            files: HashMap::new(),
            parts: HashMap::new(),
            cameras: Vec::new(),
            triangles: 0,
            photometric: Vec::new(),
            classic: Vec::new(),
            environments: HashMap::new(),
            profiles: HashMap::new(),
            textures: HashMap::new(),
            texture_names: BTreeMap::new(),
            mesh_names: BTreeMap::new(),
            hashed: HashSet::new(),
        }
    }

    /// Fills the scene.
    pub fn build(&mut self, table: &SceneTable) -> Result<(), Problem> {
        self.settings(table);
        self.scene.observer = table.render.observer.as_ref().map(|name| self.observer(name)).transpose()?;
        if let Some(ambient) = &table.ambient {
            let colors = LightColors::ambient(self.ambient(ambient)?);
            let light = Light::new(LightKind::Ambient, colors);
            self.scene.lights.push(Light { name: "ambient".to_owned(), ..light });
        }
        for light in &table.lights {
            let light = light.build(&light.span, self)?;
            self.scene.lights.push(light);
        }
        self.check_background(table.image.background.as_ref())?;
        self.named_textures(table)?;
        self.named_meshes(table)?;
        for (name, material) in in_order(&table.materials) {
            let built = self.material(name, material)?;
            self.material_names.insert(name.clone(), self.scene.materials.len());
            self.scene.materials.push(built);
        }
        for object in &table.objects {
            self.object(object)?;
        }
        self.scene.photometric = self.one_kind_of_unit(table.render.photometric.as_ref())?;
        self.drop_unused_meshes();
        // Last, since it may be a camera of an object's file.
        self.scene.camera = table.camera.as_ref().map(|camera| self.camera(camera)).transpose()?;
        Ok(())
    }

    fn named_textures(&mut self, table: &SceneTable) -> Result<(), Problem> {
        for (name, texture) in in_order(&table.textures) {
            let (wrap, filter, srgb) = (texture.wrap.0, texture.filter, texture.srgb);
            let source = TextureSource { file: &texture.file, wrap, filter, srgb };
            let read = self.texture(&source, &texture.file.span)?;
            let people_call_it = texture.name.clone().unwrap_or_else(|| name.clone());
            self.texture_names.insert(name.clone(), self.scene.textures.len());
            self.scene.textures.push(Texture { name: people_call_it, ..read });
        }
        Ok(())
    }

    fn named_meshes(&mut self, table: &SceneTable) -> Result<(), Problem> {
        for (name, mesh) in in_order(&table.meshes) {
            if Builtin::named(name).is_some() {
                let message = format!("'{name}' is the name of a built-in mesh: call this one otherwise");
                return Err(Problem::at(&mesh.span, message));
            }
            let built = mesh.build(name, &mesh.span, self)?;
            self.mesh_names.insert(name.clone(), self.scene.meshes.len());
            self.scene.meshes.push(built);
        }
        Ok(())
    }

    fn settings(&mut self, table: &SceneTable) {
        self.scene.image = Image {
            width: table.image.width.0,
            height: table.image.height.0,
            samples: table.image.samples.0,
            supersample: table.image.supersample,
            background: table.image.background.as_ref().map_or(Image::default().background, |b| b.0),
        };
        self.scene.render = RenderSettings {
            shading: table.render.shading,
            interpolation: table.render.interpolation,
            show: table.render.show,
            tone_map: table.render.tone_map,
            ev: table.render.ev.map_or(0.0, |ev| ev.0),
            mode: table.render.mode.0,
            white: table.render.white.0,
            shadows: table.render.shadows,
        };
    }

    fn ambient(&mut self, table: &At<AmbientTable>) -> Result<LightColor, Problem> {
        let color = match (&table.color, &table.spectrum) {
            (Some(color), None) => self.light_color(color)?,
            (None, Some(spectrum)) => self.light_spectrum(spectrum)?,
            (None, None) => return Err(Problem::at(&table.span, "'color' is missing in [ambient]")),
            (Some(_), Some(spectrum)) => {
                let message = "'spectrum' beside 'color': only one can be the colour";
                return Err(Problem::at(&spectrum.span, message));
            }
        };
        match &table.luminance_cd_m2 {
            Some(luminance) => {
                self.photometric.push(luminance.span.clone());
                Ok(color.scaled(for_luminance(&color, luminance.0, &luminance.span)?))
            }
            None => {
                self.classic.extend((!color.is_black()).then(|| table.span.clone()));
                Ok(color)
            }
        }
    }

    /// Whether all light is in physical units; an error where some is and some is not.
    fn one_kind_of_unit(&self, explicit: Option<&At<bool>>) -> Result<bool, Problem> {
        match (explicit, self.photometric.first()) {
            (Some(At { value: true, .. }), _) => return Ok(true),
            (Some(At { value: false, span }), Some(_)) => {
                return Err(Problem::at(
                    span,
                    "'photometric' is false, but there is light in lx, cd, W/sr or cd/m²",
                ));
            }
            _ => {}
        }
        let (Some(_), Some(classic)) = (self.photometric.first(), self.classic.first()) else {
            return Ok(!self.photometric.is_empty());
        };
        let message = "light in classic units beside light in lx, cd, W/sr or cd/m²";
        Err(Problem::at(classic, message)
            .help("give every light, the ambient one and all emission in physical units, or none"))
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
        let mut material = table.build(name, self)?;
        if let (Some(library), Some(_)) = (&table.library, &table.base_color_texture)
            && !material.lobes.iter().any(|lobe| lobe.textured)
        {
            let library = &library.value;
            self.notes.push(format!(
                "material '{name}': no term of '{library}' takes a texture; only the texture's alpha counts"
            ));
        }
        material.base_color = self.texture_use(table.base_color_texture.as_ref(), true)?;
        material.normal_map = self.texture_use(table.normal_texture.as_ref(), false)?;
        material.metal_rough_map = self.texture_use(table.metal_rough_texture.as_ref(), false)?;
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
        let texture = match (&table.texture, &table.file) {
            (Some(name), None) => self.named_texture(name, value)?,
            (None, Some(file)) => {
                let source = TextureSource {
                    file,
                    wrap: table.wrap.as_ref().map_or([Wrap::default(); 2], |wrap| wrap.value.0),
                    filter: table.filter.as_ref().map_or(TextureFilter::default(), |filter| filter.value),
                    srgb,
                };
                self.texture_of_file(&source, &value.span)?
            }
            _ => return Err(Problem::at(&value.span, "a texture needs 'file', or 'texture' in its place")),
        };
        let mut texture_use = TextureUse::plain(texture);
        if let Some([u, v]) = table.repeat.as_ref().map(|repeat| repeat.value) {
            texture_use.transform = [[u.0 as f32, 0.0, 0.0], [0.0, v.0 as f32, 0.0]];
        }
        if let Some(transform) = &table.transform {
            if table.repeat.is_some() {
                return Err(Problem::at(&transform.span, "'transform' beside 'repeat'"));
            }
            texture_use.transform = transform.value.map(|row| row.map(|number| number.0 as f32));
        }
        texture_use.scale = table.scale.map_or(1.0, |scale| scale.0 as f32);
        Ok(Some(texture_use))
    }

    /// The number of one of the scene's own textures.
    fn named_texture(&self, name: &str, value: &At<TextureValue>) -> Result<usize, Problem> {
        if let Some(wrap) = &value.0.wrap {
            return Err(Problem::at(&wrap.span, "'wrap' beside 'texture': it belongs into [textures]"));
        }
        if let Some(filter) = &value.0.filter {
            return Err(Problem::at(&filter.span, "'filter' beside 'texture': it belongs into [textures]"));
        }
        self.texture_names.get(name).copied().ok_or_else(|| {
            let known = || self.texture_names.keys().map(String::as_str);
            let message = format!("unknown texture '{name}'{}", did_you_mean(name, known()));
            Problem::at(&value.span, message).help(format!("the textures are: {}", list(known())))
        })
    }

    /// The number of the texture of a file, read once.
    fn texture_of_file(&mut self, source: &TextureSource, span: &Range<usize>) -> Result<usize, Problem> {
        let key = format!("{source:?}");
        if let Some(texture) = self.textures.get(&key) {
            return Ok(*texture);
        }
        let texture = self.texture(source, span)?;
        self.scene.textures.push(texture);
        self.textures.insert(key, self.scene.textures.len() - 1);
        Ok(self.scene.textures.len() - 1)
    }

    fn texture(&mut self, source: &TextureSource, span: &Range<usize>) -> Result<Texture, Problem> {
        let TextureSource { file, wrap, filter, srgb } = *source;
        let bytes = FolderFiles::new(&self.base, &self.options)
            .read(file)
            .map_err(|error| unresolved(file, &error, span))?;
        self.hash.bytes(&bytes);
        let texture = read_texture(&bytes, file, &self.options)
            .map_err(|error| Problem::at(span, error.to_string()))?;
        // What all textures of a scene may take together; each alone is limited by its reader.
        let taken: u64 = self.scene.textures.iter().map(|texture| texture.rgba.len() as u64).sum();
        if taken + texture.rgba.len() as u64 > self.options.max_texture_bytes {
            let limit = self.options.max_texture_bytes;
            return Err(Problem::at(span, format!("the textures take more than {limit} bytes of memory")));
        }
        Ok(Texture { wrap, filter, srgb, ..texture })
    }

    /// The folder that references are relative to.
    pub(super) fn base(&self) -> &Path {
        &self.base
    }

    /// The file that the scene names, if it may be read.
    pub(super) fn resolve(&self, reference: &str, span: &Range<usize>) -> Result<PathBuf, Problem> {
        resolve(&self.base, reference, &self.options).map_err(|error| unresolved(reference, &error, span))
    }

    /// Adds a file's bytes to the hash, once. A file that cannot be read is left out: its reader will
    /// say so.
    pub(super) fn hash_file(&mut self, path: &Path) {
        let regular = std::fs::metadata(path).is_ok_and(|metadata| metadata.is_file());
        if !regular || !self.hashed.insert(path.to_owned()) {
            return;
        }
        let Ok(mut file) = std::fs::File::open(path) else { return };
        let mut buffer = vec![0; 1 << 16];
        while let Ok(length) = std::io::Read::read(&mut file, &mut buffer) {
            if length == 0 {
                break;
            }
            self.hash.bytes(&buffer[..length]);
        }
    }
}

/// Tables by name, in the order in which they stand in the file.
fn in_order<T>(tables: &BTreeMap<String, At<T>>) -> Vec<(&String, &At<T>)> {
    let mut list: Vec<_> = tables.iter().collect();
    list.sort_by_key(|(_, table)| table.span.start);
    list
}

pub(super) fn unresolved(reference: &str, error: &ResolveError, span: &Range<usize>) -> Problem {
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

impl CameraTable {
    fn perspective(&self, degrees: Option<&At<FieldOfView>>) -> Result<Projection, Problem> {
        let fov_y = match (degrees, &self.fov_rad) {
            (Some(_), Some(radians)) => {
                return Err(Problem::at(&radians.span, "'fov_rad' beside 'fov_deg'"));
            }
            (None, Some(radians)) if radians.0 < std::f64::consts::PI => radians.0,
            (None, Some(radians)) => {
                return Err(Problem::at(&radians.span, "expected less than π"));
            }
            (degrees, None) => degrees.map_or(40.0, |fov| fov.0).to_radians(),
        };
        Ok(Projection::Perspective { fov_y })
    }

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
            (ProjectionName::Perspective, fov, None) => self.perspective(fov.as_ref())?,
        };
        let up = self.up.map_or(glam::DVec3::Y, |up| up.0);
        Ok(Camera { eye, target, up, projection })
    }
}
