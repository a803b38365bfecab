//! Scenes and models from files.

use std::ffi::OsStr;
use std::io::{self, IsTerminal, Read};
use std::path::Path;
use std::sync::OnceLock;

use glanz_math::MemoryBudget;
use glanz_scene::file::{FileError, LoadOptions};
use glanz_scene::read::ReadError;
use glanz_scene::{OpenError, Opened, Scene, is_scene_file, open, open_str};

use super::args::{CameraArgs, InputArgs};
use super::print::failure::{Failure, Report, without_number};

/// The path of errors about values of the command line.
const OVERRIDE: &str = "override";

/// A scene and what belongs to it.
pub(crate) type Input = Opened;

/// Values of a scene beside those of `--set`, and the option that gives them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct More<'a> {
    pub option: &'static str,
    pub values: &'a [(String, String)],
}

impl InputArgs {
    /// Reads the file, with the values that `--set` gives and then those in `more`. The camera that
    /// `camera` names is among the input's cameras.
    pub(crate) fn load(&self, camera: Option<&CameraArgs>, more: More<'_>) -> Result<Input, Failure> {
        let sets = self.set.iter().chain(more.values).cloned().collect();
        // A scene finds a camera of its models itself, if its own `camera` is a name.
        let is_scene = self.is_stdin() || is_scene_file(&self.input);
        if is_scene && self.lights.is_some() {
            let message = "--lights is for a model, which may have none; a scene says its lights itself";
            return Err(Failure::Usage(message.to_owned()));
        }
        if is_scene && self.variant.is_some() {
            let message = "--variant is for a model; a scene says it of an object: variant = \"NAME\"";
            return Err(Failure::Usage(message.to_owned()));
        }
        let mut options = LoadOptions {
            allow_outside: self.allow_outside,
            sets,
            lights: self.lights,
            variant: self.variant.clone(),
            memory: self.memory,
        };
        let camera = camera.and_then(|camera| camera.camera.as_deref()).filter(|_| is_scene);
        options.sets.extend(camera.map(|name| ("camera".to_owned(), quoted(name))));
        let opened = match self.is_stdin() {
            true => open_str(stdin_text()?, Path::new(""), &options),
            false => open(&self.input, &options),
        };
        let mut input = opened.map_err(|error| match error {
            OpenError::Scene(error) => {
                let option = self.option_of(&error.text, more);
                failure_of_scene(self.under_its_name(error), option)
            }
            OpenError::Model(error) => self.failure_of_model(&error),
        })?;
        self.program.apply(&mut input.scene)?;
        input.cameras.extend(camera.map(str::to_owned).zip(input.scene.camera));
        Ok(input)
    }

    /// The option that gave a value, `PATH = VALUE`, which is wrong.
    fn option_of(&self, text: &str, more: More<'_>) -> &'static str {
        let path = text.split(" = ").next().unwrap_or_default();
        let is_in = |values: &[(String, String)]| values.iter().any(|(own, _)| own == path);
        match path {
            _ if is_in(more.values) => more.option,
            "camera" if !is_in(&self.set) => "--camera",
            _ => "--set",
        }
    }

    /// An error of a scene from stdin, which has no file.
    fn under_its_name(&self, error: FileError) -> FileError {
        let from_set = error.path == Path::new(OVERRIDE);
        match self.is_stdin() && !from_set {
            true => FileError { path: self.name().to_owned(), ..error },
            false => error,
        }
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

/// A name as a value of TOML, which has the strings of JSON, but escapes one character more.
fn quoted(name: &str) -> String {
    serde_json::Value::from(name).to_string().replace('\u{7f}', "\\u007f")
}

/// The text on stdin. A scene that is drawn several times is read once.
fn stdin_text() -> Result<&'static str, Failure> {
    static TEXT: OnceLock<String> = OnceLock::new();
    if let Some(text) = TEXT.get() {
        return Ok(text);
    }
    if io::stdin().is_terminal() {
        let message = "stdin is a terminal; pipe a scene into it, such as `glanz render - < scene.toml`";
        return Err(Failure::Usage(message.to_owned()));
    }
    let mut text = String::new();
    let limit = glanz_scene::file::MAX_BYTES + 1;
    io::stdin().lock().take(limit).read_to_string(&mut text).map_err(|error| {
        Failure::new(format_args!("cannot read a scene from stdin: {}", without_number(&error.to_string())))
    })?;
    Ok(TEXT.get_or_init(|| text))
}

/// The input that a scene made in code is.
pub(crate) fn input_of_stage(scene: Scene) -> Input {
    let memory = MemoryBudget::default();
    Input {
        scene,
        cameras: Vec::new(),
        variants: Vec::new(),
        notes: Vec::new(),
        default_lights: true,
        memory,
    }
}

/// Tells an error of a scene file with the line that it is in, or of a value from the command line with its option.
pub(crate) fn failure_of_scene(error: FileError, option: &str) -> Failure {
    let from_set = error.path == Path::new(OVERRIDE);
    let place = if from_set { option.to_owned() } else { error.path.display().to_string() };
    let report = match &error.span {
        Some(span) => Report::new(&error.message).source(&place, error.text.to_string(), span.clone()),
        None => Report::new(format_args!("{place}: {}", without_number(&error.message))),
    };
    let report = match (from_set, error.line) {
        (true, _) => report,
        (false, 0) => report.file(&error.path),
        (false, line) => report.file(&error.path).place(line.into(), error.column.into()),
    };
    let report = match error.help {
        Some(help) => report.help(help),
        None => report,
    };
    match from_set {
        true => report.wrong_value(),
        false => report.into(),
    }
}
