//! `glanz example`: the example scenes, which are part of the program.

use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use glanz_picture::output::write_atomically;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::check_folder;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz example list
  glanz example kite
  glanz example glass -o scenes/glass.toml
  glanz example ball -o - | glanz render - -o ball.png";

/// A file inside the program.
type Stored = (&'static str, &'static [u8]);

macro_rules! stored {
    ($($name:literal),+ $(,)?) => {
        [$(($name, include_bytes!(concat!("../../scenes/", $name)))),+]
    };
}

/// The example scenes, by the names of their files.
const SCENES: [Stored; 35] = stored![
    "ball.toml",
    "black-light.toml",
    "brewster.toml",
    "brushed-metal.toml",
    "brushed.toml",
    "car-paint.toml",
    "colorchecker.toml",
    "cook-torrance.toml",
    "flowers.toml",
    "fluorescence.toml",
    "full.toml",
    "glass.toml",
    "highlight-in-facet.toml",
    "hls-cone.toml",
    "kite.toml",
    "leaf.toml",
    "lights.toml",
    "mach-bands.toml",
    "measured.toml",
    "metals.toml",
    "metamers.toml",
    "mixing.toml",
    "orientation.toml",
    "plate.toml",
    "shader-kite.toml",
    "shader-lights.toml",
    "shader-normal-matrix.toml",
    "shader-toon.toml",
    "smoothing.toml",
    "soap.toml",
    "street-at-dusk.toml",
    "suzanne.toml",
    "teapot.toml",
    "three-spheres.toml",
    "traffic-lights.toml",
];

/// The files that they name.
const FILES: [Stored; 19] = stored![
    "data/metamer-a.csv",
    "data/metamer-b.csv",
    "data/studio.hdr",
    "measured/brushed-steel.csv",
    "measured/cc_ibiza_sunset_rgb.bsdf",
    "measured/noisy.csv",
    "measured/paper_white_rgb.bsdf",
    "measured/satin_rosaline_rgb.bsdf",
    "models/hls-double-cone.ply",
    "models/plate.ply",
    "models/suzanne.glb",
    "shaders/course.vert",
    "shaders/normals.frag",
    "shaders/gouraud.vert",
    "shaders/phong.frag",
    "shaders/wrong-normals.vert",
    "shaders/right-normals.vert",
    "shaders/lamp.frag",
    "shaders/toon.frag",
];

/// Options of `glanz example`.
#[derive(Args, Debug)]
pub(crate) struct ExampleArgs {
    /// The example, or list for what there is
    #[arg(value_name = "NAME")]
    name: String,

    /// Where to write it, files that it needs beside it; - for the scene alone to stdout [default: NAME.toml in the
    /// current folder]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// Write even over files with another content
    #[arg(long)]
    force: bool,

    #[command(flatten)]
    format: FormatArgs,
}

/// The examples that there are, or the files that were written.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// All examples, or the one that was written
    examples: Vec<ExampleFacts>,
    /// The files that were written; none by `glanz example list`
    written: Vec<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ExampleFacts {
    name: &'static str,
    /// What it shows, in a sentence
    about: String,
    /// The files that it needs beside it
    files: Vec<&'static str>,
}

impl ExampleArgs {
    /// Lists or writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.name == "list" {
            return self.list();
        }
        let known = || SCENES.iter().map(|(file, _)| stem(file));
        let Some(scene) = SCENES.iter().find(|(file, _)| stem(file) == self.name) else {
            let near = glanz_math::names::did_you_mean(&self.name, known());
            let message =
                format!("there is no example '{}'{near}; `glanz example list` tells all", self.name);
            return Err(Failure::Usage(message));
        };
        if self.output.as_deref() == Some(Path::new("-")) {
            return self.print(scene);
        }
        let path = self.output.clone().unwrap_or_else(|| PathBuf::from(scene.0));
        let written = self.write(scene, &path)?;
        if self.format.is_json() {
            let written = written.iter().map(|path| path.display().to_string()).collect();
            return print::json(&Document { examples: vec![facts(scene)], written });
        }
        written.iter().for_each(|path| print::note(format_args!("wrote {}", path.display())));
        Ok(())
    }

    fn list(&self) -> Result<(), Failure> {
        let examples: Vec<ExampleFacts> = SCENES.iter().map(facts).collect();
        if self.format.is_json() {
            return print::json(&Document { examples, written: Vec::new() });
        }
        let line = |example: &ExampleFacts| format!("{:<20} {}\n", example.name, example.about);
        print::text(&examples.iter().map(line).collect::<String>())
    }

    /// The scene alone to stdout.
    fn print(&self, scene: &Stored) -> Result<(), Failure> {
        if self.format.is_json() {
            let message = "stdout cannot take both the scene and --format json; name a file with -o";
            return Err(Failure::Usage(message.to_owned()));
        }
        let files: Vec<_> = needed(scene).map(|(name, _)| *name).collect();
        if !files.is_empty() {
            let name = &self.name;
            print::note(format_args!(
                "note: it needs {}, which `glanz example {name}` writes",
                files.join(", ")
            ));
        }
        print::bytes(scene.1)
    }

    /// Writes the scene and the files that it needs beside it.
    fn write(&self, scene: &Stored, path: &Path) -> Result<Vec<PathBuf>, Failure> {
        check_folder(path)?;
        let files: Vec<_> = needed(scene).map(|(name, bytes)| (path.with_file_name(name), *bytes)).collect();
        let all: Vec<(PathBuf, &[u8])> = files.into_iter().chain([(path.to_owned(), scene.1)]).collect();
        for (path, bytes) in &all {
            self.check_free(path, bytes)?;
        }
        for (path, bytes) in &all {
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder).map_err(|error| could_not(path, &error))?;
            }
            write_atomically(path, |out| -> Result<(), Failure> {
                std::io::Write::write_all(out, bytes).map_err(|error| could_not(path, &error))
            })?;
        }
        Ok(all.into_iter().map(|(path, _)| path).collect())
    }

    /// That no file of another content is in the way.
    fn check_free(&self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        if self.force || !path.exists() || std::fs::read(path).is_ok_and(|found| found == bytes) {
            return Ok(());
        }
        let report = Report::new(format_args!("'{}' exists already, with another content", path.display()));
        Err(report.file(path).help("write over it with --force, or choose another file with -o").into())
    }
}

fn could_not(path: &Path, error: &std::io::Error) -> Failure {
    let error = print::failure::without_number(&error.to_string());
    Report::new(format_args!("cannot write '{}': {error}", path.display())).file(path).into()
}

/// The name of an example.
fn stem(file: &'static str) -> &'static str {
    file.strip_suffix(".toml").unwrap_or(file)
}

/// The files that a scene names.
fn needed(scene: &Stored) -> impl Iterator<Item = &'static Stored> {
    let text = String::from_utf8_lossy(scene.1).into_owned();
    FILES.iter().filter(move |(name, _)| text.contains(&format!("\"{name}\"")))
}

fn facts(scene: &Stored) -> ExampleFacts {
    let text = String::from_utf8_lossy(scene.1);
    ExampleFacts {
        name: stem(scene.0),
        about: about(&text),
        files: needed(scene).map(|(name, _)| *name).collect(),
    }
}

/// The first sentence of the comment that a scene begins with.
fn about(text: &str) -> String {
    let comment = text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim);
    let words = comment.take_while(|line| !line.is_empty()).collect::<Vec<_>>().join(" ");
    let mut ends = words.match_indices(". ").map(|(at, _)| at + 1);
    // "E. Thiel" ends no sentence: the letter before the stop stands alone.
    let is_end = |at: &usize| !words[..at - 1].ends_with(|c: char| c.is_uppercase());
    let end = ends.find(is_end).unwrap_or(words.len());
    words[..end].to_owned()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_example_of_the_repository_is_in_the_program() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let scenes: BTreeSet<String> = names
            .map(|name| name.to_string_lossy().into_owned())
            .filter(|name| name.ends_with(".toml"))
            .collect();
        let stored: BTreeSet<String> = SCENES.iter().map(|(name, _)| (*name).to_owned()).collect();
        assert_eq!(stored, scenes);
    }

    #[test]
    fn the_sentence_about_an_example_ends_at_its_stop() {
        assert_eq!(about("# A ball. Or two.\n# More.\n\nx = 1"), "A ball.");
        assert_eq!(
            about("# The kite of E. Thiel,\n# lecture 5: light. And more."),
            "The kite of E. Thiel, lecture 5: light."
        );
        assert_eq!(about("x = 1"), "");
    }
}
