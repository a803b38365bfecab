//! A folder of one's own, and the command in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder that is removed at the end.
pub(crate) struct Folder(PathBuf);

/// What a run of the command left behind.
#[derive(Debug)]
pub(crate) struct Run {
    /// The exit code.
    pub code: i32,
    /// Data.
    pub stdout: Vec<u8>,
    /// All else.
    pub stderr: String,
}

impl Folder {
    /// A new, empty folder.
    pub(crate) fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("glanz-cli-{}-{number}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// A folder with `scene.toml` in it.
    pub(crate) fn with_scene() -> Self {
        let folder = Self::new();
        folder.write("scene.toml", SCENE);
        folder
    }

    /// The path of a file in it.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// Writes a file, in a folder of its own if the name has one.
    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        if let Some((folder, _)) = name.rsplit_once('/') {
            fs::create_dir_all(self.path(folder)).unwrap();
        }
        fs::write(self.path(name), content).unwrap();
    }

    /// The bytes of a file.
    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of all files, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let names = fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().file_name());
        let mut names: Vec<_> = names.map(|name| name.to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// Runs `glanz` with these words in this folder.
    pub(crate) fn glanz(&self, words: &[&str]) -> Run {
        self.glanz_with(words, &[])
    }

    /// The same with environment variables.
    pub(crate) fn glanz_with(&self, words: &[&str], variables: &[(&str, &str)]) -> Run {
        let output = command(&self.0).args(words).envs(variables.iter().copied()).output().unwrap();
        Run {
            code: output.status.code().expect("ends by itself"),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

impl Run {
    /// stdout as text, of a run that went well.
    pub(crate) fn text(&self) -> &str {
        assert_eq!(self.code, 0, "{}", self.stderr);
        std::str::from_utf8(&self.stdout).unwrap()
    }

    /// stdout as JSON, of a run that went well.
    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_str(self.text()).unwrap()
    }

    /// Exit code and message, of a run that failed and printed nothing else.
    pub(crate) fn failure(&self) -> String {
        assert_ne!(self.code, 0);
        assert!(self.stdout.is_empty(), "{:?}", String::from_utf8_lossy(&self.stdout));
        assert_eq!(self.stderr.matches("error:").count(), 1, "{}", self.stderr);
        format!("{}\n{}", self.code, self.stderr)
    }
}

/// The command, undisturbed by the variables of whoever runs the tests.
pub(crate) fn command(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_glanz"));
    command.current_dir(folder).stdin(Stdio::null());
    for variable in
        ["GLANZ_SIMD", "NO_COLOR", "CLICOLOR_FORCE", "FORCE_COLOR", "COLUMNS", "LINES", "RUST_BACKTRACE"]
    {
        command.env_remove(variable);
    }
    command
}

/// A ball under one lamp.
pub(crate) const SCENE: &str = r#"[image]
width = 48
height = 32
samples = 1
background = [0.1, 0.1, 0.2]

[camera]
eye = [0.0, 0.0, 4.0]

[ambient]
color = [0.1, 0.1, 0.1]

[[lights]]
kind = "point"
position = [2.0, 2.0, 3.0]
color = [0.9, 0.9, 0.9]

[materials.ball]
model = "phong"
ambient = [0.8, 0.1, 0.1]
diffuse = [0.8, 0.1, 0.1]
specular = [0.6, 0.6, 0.6]
shininess = 32.0

[[objects]]
mesh = { sphere = { radius = 1.0, slices = 16, stacks = 8 } }
material = "ball"
"#;
