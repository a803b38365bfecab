//! A scene from any file: a scene file, or a model put into an empty scene.

use std::path::Path;

use glam::DMat4;
use glanz_math::MemoryBudget;
use thiserror::Error;

use crate::builtin::MAX_TRIANGLES;
use crate::file::{self, FileError, LoadOptions, Loaded};
use crate::memory::LEAST_TRIANGLE_BYTES;
use crate::read::{Model, Place, ReadError, ReadOptions, read_model};
use crate::{Background, Camera, Scene, exposure};

/// The material that values set for a bare model: the one of objects that name none.
const MODEL_MATERIAL: &str =
    "[materials.default]\nambient = [0.7, 0.7, 0.7]\ndiffuse = [0.7, 0.7, 0.7]\nspecular = [0.2, 0.2, 0.2]\n";

/// A scene and what belongs to its file.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// The scene.
    pub scene: Scene,
    /// Cameras of a model that can be chosen by name.
    pub cameras: Vec<(String, Camera)>,
    /// The names of the variants that a model's materials have.
    pub variants: Vec<String>,
    /// What was ignored or changed, in words for people.
    pub notes: Vec<String>,
    /// Whether the lights are not the file's own.
    pub default_lights: bool,
    /// What it was read within; drawing it asks the same budget.
    pub memory: MemoryBudget,
}

/// Why a file gives no scene.
#[derive(Debug, Error)]
pub enum OpenError {
    /// A scene file cannot be used.
    #[error(transparent)]
    Scene(#[from] FileError),
    /// A model cannot be read.
    #[error(transparent)]
    Model(#[from] ReadError),
}

/// Whether a file is a scene file rather than a model, by its name.
pub fn is_scene_file(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// Reads a scene file, or a model of any known format.
///
/// A model is put into an empty scene, on which the values of the options work as on any other; setting
/// `materials.default` gives it that material in place of its own. A model without lights gets some; one with lamps is
/// exposed by them (`render.ev`), unless the options set an exposure or lights. [`LoadOptions::lights`] chooses among those.
///
/// ```
/// let path = std::env::temp_dir().join("glanz-doc-open.obj");
/// std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")?;
/// let opened = glanz_scene::open(&path, &Default::default())?;
/// assert!(opened.default_lights && opened.scene.lights.len() == 3);
/// # std::fs::remove_file(path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the file cannot be read, or does not say what it should.
pub fn open(path: &Path, options: &LoadOptions) -> Result<Opened, OpenError> {
    match is_scene_file(path) {
        true => Ok(Opened::of_loaded(file::load(path, options)?, options)),
        false => open_model(path, options),
    }
}

/// Reads a scene from a text, as [`open`] reads one from a scene file. Files that it names are relative to `base`.
///
/// # Errors
/// If the text does not say what it should.
pub fn open_str(text: &str, base: &Path, options: &LoadOptions) -> Result<Opened, OpenError> {
    Ok(Opened::of_loaded(file::parse_str(text, base, options)?, options))
}

fn open_model(path: &Path, options: &LoadOptions) -> Result<Opened, OpenError> {
    let sets_material = options.sets.iter().any(|(path, _)| path.starts_with("materials."));
    let text = if sets_material { MODEL_MATERIAL } else { "" };
    let settings = file::parse_str(text, path.parent().unwrap_or(Path::new("")), options)?;
    let mut opened = Opened::of_loaded(settings, options);
    let LoadOptions { allow_outside, memory, .. } = *options;
    let read =
        ReadOptions { allow_outside, memory, variant: options.variant.clone(), ..ReadOptions::default() };
    let mut model = read_model(path, &read)?;
    check_budget(&model, path, memory)?;
    opened.notes.append(&mut model.notes);
    opened.cameras = core::mem::take(&mut model.cameras);
    opened.variants = core::mem::take(&mut model.variants);
    if opened.scene.camera.is_none() {
        opened.scene.camera = opened.cameras.first().map(|(_, camera)| *camera);
    }
    let material = sets_material.then_some(0);
    let set_lights = !opened.scene.lights.is_empty();
    let own_lights = set_lights || !model.lights.is_empty();
    model.append_to(&mut opened.scene, DMat4::IDENTITY, material, options.lights.is_none());
    if options.lights.is_some() || !own_lights {
        options.lights.unwrap_or_default().add(&mut opened.scene);
        opened.default_lights = !opened.scene.lights.is_empty();
    } else if !set_lights && !options.sets.iter().any(|(path, _)| path == "render.ev") {
        opened.expose();
    }
    Ok(opened)
}

/// Refuses a model that uses its meshes so often that they make more triangles than can be drawn, or than there is memory for.
fn check_budget(model: &Model, path: &Path, memory: MemoryBudget) -> Result<(), ReadError> {
    let (file, place, found) = (path.display().to_string(), Place::File, model.triangle_count() as u64);
    if found > MAX_TRIANGLES {
        let (limit, unit) = (MAX_TRIANGLES, "triangles in a scene");
        return Err(ReadError::TooLarge { file, place, limit, unit, found });
    }
    let bytes = found * LEAST_TRIANGLE_BYTES;
    memory
        .check(format_args!("{found} triangles"), bytes)
        .map_err(|over| ReadError::memory(&file, place, over))
}

impl Opened {
    /// Exposes a model by its own lamps, whose units say nothing of how bright a picture is to be.
    fn expose(&mut self) {
        let Some(stops) = exposure::of_lamps(&self.scene) else { return };
        self.scene.render.ev = stops;
        // What is behind the model has no light of its own to be exposed by.
        if let Background::Color(color) = &mut self.scene.image.background {
            let dimmed = libm::exp2(-stops) as f32;
            color.0.iter_mut().for_each(|value| *value *= dimmed);
        }
        self.notes.push(format!(
            "the lights of the file ask for an exposure of {stops:+.1} stops, which is taken; --ev sets another one, \
             --lights three-point or studio other lights"
        ));
    }

    fn of_loaded(loaded: Loaded, options: &LoadOptions) -> Self {
        let (scene, notes) = (loaded.scene, loaded.notes);
        let (cameras, variants) = (Vec::new(), Vec::new());
        Self { scene, cameras, variants, notes, default_lights: false, memory: options.memory }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle and a sun that shines on it with that many lux.
    fn opened(lux: f64, sets: &[(&str, &str)]) -> Opened {
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}},{{"extensions":{{"KHR_lights_punctual":{{"light":0}}}}}}],
            "extensions":{{"KHR_lights_punctual":{{"lights":[{{"type":"directional","intensity":{lux}}}]}}}},
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],
            "buffers":[{{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}]}}"#
        );
        let name = format!("glanz-open-{lux}-{}-{}.gltf", sets.len(), std::process::id());
        let path = std::env::temp_dir().join(name);
        std::fs::write(&path, text).unwrap();
        let sets = sets.iter().map(|&(path, value)| (path.to_owned(), value.to_owned())).collect();
        let opened = open(&path, &LoadOptions { sets, ..LoadOptions::default() });
        std::fs::remove_file(&path).unwrap();
        opened.unwrap()
    }

    #[test]
    fn a_bare_model_is_exposed_by_its_own_lamps_unless_an_exposure_is_set() {
        let white = core::f64::consts::PI;
        let bright = opened(white * 1024.0, &[]);
        assert_eq!((bright.scene.render.ev, bright.default_lights), (-10.0, false));
        assert!(
            bright
                .notes
                .iter()
                .any(|note| note.contains("an exposure of -10.0 stops") && note.contains("--ev"))
        );
        // The background stays what it is on the screen.
        let shown = |opened: &Opened| match opened.scene.image.background {
            Background::Color(color) => f64::from(color.0[2]) * libm::exp2(opened.scene.render.ev),
            other => panic!("{other:?}"),
        };
        let plain = opened(white, &[]);
        assert!((shown(&bright) - shown(&plain)).abs() < 1e-6 && shown(&plain) > 0.01);
        assert_eq!((plain.scene.render.ev, plain.notes.len()), (0.0, 0));
        let set = opened(white * 1024.0, &[("render.ev", "-3")]);
        assert_eq!((set.scene.render.ev, set.notes.len()), (-3.0, 0));
    }
}
