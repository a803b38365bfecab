//! Scenes and models from files.

use std::ffi::OsStr;
use std::path::Path;

use glam::DMat4;
use glanz_scene::file::{FileError, LoadOptions, Loaded, load, parse_str};
use glanz_scene::read::{ReadError, ReadOptions, read_model};
use glanz_scene::{Camera, Scene, add_default_lights};

use super::args::{CameraArgs, InputArgs};
use super::print::failure::{Failure, Report, without_number};

/// The material that `--set` describes for a bare model: the one of objects that name none.
const MODEL_MATERIAL: &str =
    "[materials.default]\nambient = [0.7, 0.7, 0.7]\ndiffuse = [0.7, 0.7, 0.7]\nspecular = [0.2, 0.2, 0.2]\n";

/// A scene and what belongs to it.
#[derive(Clone, Debug)]
pub struct Input {
    /// The scene.
    pub scene: Scene,
    /// Cameras of a model that can be chosen by name.
    pub cameras: Vec<(String, Camera)>,
    /// What was ignored or changed, in words.
    pub notes: Vec<String>,
    /// A number for the content of the scene; 0 for bare models.
    pub hash: u64,
    /// Whether the lights are not the file's own.
    pub default_lights: bool,
}

impl InputArgs {
    /// Reads the file, with the values that `--set` gives and then those in `more`. The camera that
    /// `camera` names is among the input's cameras.
    pub fn load(&self, camera: Option<&CameraArgs>, more: &[(String, String)]) -> Result<Input, Failure> {
        let sets = self.set.iter().chain(more).cloned().collect();
        let options = LoadOptions { allow_outside: self.allow_outside, sets };
        match self.is_scene() {
            true => self.load_scene(options, camera.and_then(|camera| camera.camera.as_deref())),
            false => self.load_model(&options),
        }
    }

    /// Whether the file is a scene rather than a model, by its name.
    fn is_scene(&self) -> bool {
        self.input.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
    }

    /// A scene finds a camera of its models itself, if its own `camera` is a name.
    fn load_scene(&self, mut options: LoadOptions, camera: Option<&str>) -> Result<Input, Failure> {
        options.sets.extend(camera.map(|name| ("camera".to_owned(), format!("{name:?}"))));
        let mut input = load(&self.input, &options).map(Input::of_scene).map_err(failure_of_scene)?;
        input.cameras.extend(camera.map(str::to_owned).zip(input.scene.camera));
        Ok(input)
    }

    /// A model is put into an empty scene, on which `--set` works as on any other; setting
    /// `materials.default` gives the model that material in place of its own.
    fn load_model(&self, options: &LoadOptions) -> Result<Input, Failure> {
        let sets_material = options.sets.iter().any(|(path, _)| path.starts_with("materials."));
        let text = if sets_material { MODEL_MATERIAL } else { "" };
        let settings = parse_str(text, self.input.parent().unwrap_or(Path::new("")), options);
        let mut input = Input::of_scene(settings.map_err(failure_of_scene)?);
        let read = ReadOptions { allow_outside: self.allow_outside, ..ReadOptions::default() };
        let mut model = read_model(&self.input, &read).map_err(|error| self.failure_of_model(&error))?;
        input.notes.append(&mut model.notes);
        input.cameras = std::mem::take(&mut model.cameras);
        if input.scene.camera.is_none() {
            input.scene.camera = input.cameras.first().map(|(_, camera)| *camera);
        }
        let material = sets_material.then_some(0);
        let own_lights = !input.scene.lights.is_empty() || !model.lights.is_empty();
        model.append_to(&mut input.scene, DMat4::IDENTITY, material, true);
        if !own_lights {
            add_default_lights(&mut input.scene);
            input.default_lights = true;
        }
        Ok(input)
    }

    fn failure_of_model(&self, error: &ReadError) -> Failure {
        let report = Report::from(error);
        let known_ending = ["glb", "gltf", "obj", "ply", "stl"].iter().any(|ending| {
            self.input.extension().is_some_and(|own| own.eq_ignore_ascii_case(OsStr::new(ending)))
        });
        match known_ending || !self.input.is_file() {
            true => report.into(),
            false => report.help("the name of a scene file ends in .toml").into(),
        }
    }
}

impl Input {
    /// A scene made in code.
    pub fn of_stage(scene: Scene) -> Self {
        let (cameras, notes) = (Vec::new(), Vec::new());
        Self { scene, cameras, notes, hash: 0, default_lights: true }
    }

    fn of_scene(loaded: Loaded) -> Self {
        Self {
            scene: loaded.scene,
            cameras: Vec::new(),
            notes: loaded.notes,
            hash: loaded.hash,
            default_lights: false,
        }
    }
}

/// Tells an error of a scene file with the line that it is in.
fn failure_of_scene(error: FileError) -> Failure {
    let from_set = error.path.as_os_str() == "override";
    let place = if from_set { "--set".to_owned() } else { error.path.display().to_string() };
    let report = match &error.span {
        Some(span) => Report::new(&error.message).source(&place, error.text.to_string(), span.clone()),
        None => Report::new(format_args!("{place}: {}", without_number(&error.message))),
    };
    let report = match (from_set, error.line) {
        (true, _) => report,
        (false, 0) => report.file(&error.path),
        (false, line) => report.file(&error.path).place(line.into(), error.column.into()),
    };
    match error.help {
        Some(help) => report.help(help).into(),
        None => report.into(),
    }
}
