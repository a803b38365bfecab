//! `glanz shader list` and `glanz shader print`: programs to begin with.

use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_picture::output::write_atomically;
use glanz_scene::{Scene, Shading};
use glanz_shader::{DefaultProgram, Stage};
use schemars::JsonSchema;
use serde::Serialize;

use super::check::StageName;
use crate::args::check_folder;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Shown after the help of `list`.
pub(crate) const LIST_EXAMPLES: &str = "\
Examples:
  glanz shader list
  glanz shader list --format json";

/// Shown after the help of `print`.
pub(crate) const PRINT_EXAMPLES: &str = "\
Examples:
  glanz shader print phong-330
  glanz shader print phong-330 --stage fragment -o phong.frag
  glanz shader print gouraud-330 --stage vertex > gouraud.vert

Draw with what you changed of it: glanz render scene.toml --fs phong.frag";

/// Options of `glanz shader list`.
#[derive(Args, Debug)]
pub(crate) struct ListArgs {
    #[command(flatten)]
    format: FormatArgs,
}

/// Options of `glanz shader print`.
#[derive(Args, Debug)]
pub(crate) struct PrintArgs {
    /// A program of `glanz shader list`
    #[arg(value_name = "NAME")]
    name: String,

    /// One stage alone [default: both, one after the other]
    #[arg(long, value_enum, value_name = "STAGE")]
    stage: Option<StageName>,

    /// Write it into this file; - for stdout
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "stage")]
    output: Option<PathBuf>,

    #[command(flatten)]
    format: FormatArgs,
}

/// A program to begin with, as a whole.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PrintDocument {
    name: &'static str,
    title: &'static str,
    /// The model whose pictures it equals; null where there is none
    model: Option<&'static str>,
    vertex: String,
    fragment: String,
    /// The file that was written
    file: Option<String>,
}

/// Programs to begin with.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ListDocument {
    programs: Vec<ProgramFacts>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ProgramFacts {
    name: &'static str,
    title: &'static str,
    /// The model whose pictures it equals; null where there is none
    model: Option<&'static str>,
    /// glsl or wgsl
    language: &'static str,
}

impl ListArgs {
    /// Tells which there are.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let all = DefaultProgram::all();
        if self.format.is_json() {
            let facts = |program: &DefaultProgram| ProgramFacts {
                name: program.name,
                title: program.title,
                model: program.model,
                language: if program.is_wgsl() { "wgsl" } else { "glsl" },
            };
            return print::json(&ListDocument { programs: all.iter().map(facts).collect() });
        }
        let width = all.iter().map(|program| program.name.len()).max().unwrap_or(0);
        let line = |program: &DefaultProgram| {
            let model = program.model.map_or(String::new(), |model| format!("; model {model}"));
            format!("{:width$}  {}{model}\n", program.name, program.title)
        };
        print::text(&all.iter().map(line).collect::<String>())
    }
}

impl PrintArgs {
    /// Prints a program.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let names = || DefaultProgram::all().iter().map(|program| program.name);
        let Some(program) = DefaultProgram::named(&self.name) else {
            let near = glanz_math::names::did_you_mean(&self.name, names());
            let known = names().collect::<Vec<_>>().join(", ");
            let message = format!("there is no program '{}'{near}; there are: {known}", self.name);
            return Err(Failure::Usage(message));
        };
        let text = match self.stage {
            Some(stage) => program.text(stage.stage()),
            // A text of WGSL holds both.
            None if program.is_wgsl() => program.text(Stage::Fragment),
            None => [Stage::Vertex, Stage::Fragment]
                .map(|stage| format!("// {}\n{}", program.file_name(stage), program.text(stage)))
                .join("\n"),
        };
        let document = |file: Option<String>| PrintDocument {
            name: program.name,
            title: program.title,
            model: program.model,
            vertex: program.text(Stage::Vertex),
            fragment: program.text(Stage::Fragment),
            file,
        };
        let Some(path) = self.output.as_ref().filter(|path| path.as_os_str() != "-") else {
            return if self.format.is_json() { print::json(&document(None)) } else { print::text(&text) };
        };
        check_folder(path)?;
        write_atomically(path, |out| {
            std::io::Write::write_all(out, text.as_bytes()).map_err(|source| {
                glanz_picture::output::OutputError::File { path: path.clone(), action: "write it", source }
            })
        })?;
        print::note(format_args!("wrote {}", path.display()));
        match self.format.is_json() {
            true => print::json(&document(Some(path.display().to_string()))),
            false => Ok(()),
        }
    }
}

/// Prints the shaders that draw a scene; of one that has none, those that draw as its shading does.
pub(crate) fn print_of(scene: &Scene) -> Result<(), Failure> {
    let own = scene.programs.iter().flat_map(|program| [&program.vertex, &program.fragment]).flatten();
    let mut texts: Vec<(String, String)> = own.map(|text| (text.name.clone(), text.text.clone())).collect();
    if texts.is_empty() {
        let name = if scene.render.shading == Shading::Gouraud { "gouraud-330" } else { "phong-330" };
        let program = DefaultProgram::named(name).ok_or_else(|| Failure::new("there is no such program"))?;
        texts = [Stage::Vertex, Stage::Fragment]
            .map(|stage| (program.file_name(stage), program.text(stage)))
            .to_vec();
    }
    let told = texts.iter().map(|(name, text)| format!("// {name}\n{text}"));
    print::text(&told.collect::<Vec<_>>().join("\n"))
}
