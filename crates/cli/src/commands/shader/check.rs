//! `glanz shader check`: whether a shader compiles, what it takes and gives, and what is probably not meant.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use glanz_shader::{Place, Port, Program, Role, Shader, Stage, Uniform, Warning, check_stages};
use schemars::JsonSchema;
use serde::Serialize;

use crate::input::shader_text::Texts;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shader check phong.frag
  glanz shader check phong.vert phong.frag
  glanz shader check toy.glsl --stage fragment --format json

GLSL 110 to 460 and ES 100 and 300, by #version; WGSL where the name ends in .wgsl; a main of Shadertoy (mainImage);
a .brdf of BRDF Explorer. A vertex and a fragment shader are also compared with each other. What a name stands
for is told beside it; what stands for nothing is for the user to set.";

/// Options of `glanz shader check`.
#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// Files of shaders
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// The stage of all, whatever their names end in
    #[arg(long, value_enum, value_name = "STAGE")]
    stage: Option<StageName>,

    #[command(flatten)]
    format: FormatArgs,
}

/// A stage by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum StageName {
    Vertex,
    Fragment,
}

impl StageName {
    /// The stage.
    pub(super) fn stage(self) -> Stage {
        match self {
            Self::Vertex => Stage::Vertex,
            Self::Fragment => Stage::Fragment,
        }
    }
}

impl CheckArgs {
    /// Compiles and tells.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let mut programs = Vec::with_capacity(self.files.len());
        for file in &self.files {
            programs.push((file.display().to_string(), compile(file, self.stage_of(file), &[])?));
        }
        let of = |stage: Stage| programs.iter().find(|(_, program)| program.stage() == stage);
        let between = match (of(Stage::Vertex), of(Stage::Fragment)) {
            (Some((_, vertex)), Some((_, fragment))) => check_stages(vertex, fragment),
            _ => Vec::new(),
        };
        match self.format.is_json() {
            true => print::json(&Document {
                shaders: programs.iter().map(ShaderFacts::of).collect(),
                between: between.iter().map(WarningFacts::of).collect(),
            }),
            false => print::text(&text(&programs, &between)),
        }
    }

    /// The stage that is said, or that the name's ending tells.
    fn stage_of(&self, file: &Path) -> Stage {
        let ending = file.extension().map(|ending| ending.to_ascii_lowercase());
        let is_vertex = ending.is_some_and(|ending| ["vert", "vs", "vsh"].iter().any(|own| ending == *own));
        match self.stage {
            Some(StageName::Vertex) => Stage::Vertex,
            None if is_vertex => Stage::Vertex,
            _ => Stage::Fragment,
        }
    }
}

/// Compiles a file, with `#define`s in front; `#include` reads files of its folder.
pub(super) fn compile(file: &Path, stage: Stage, defines: &[(String, String)]) -> Result<Program, Failure> {
    let texts = Texts::read(file)?;
    let include = |path: &str, _: &str| texts.include(path);
    let mut shader = Shader::new(stage, texts.text()).named(texts.name()).include(&include);
    for (name, text) in defines {
        shader = shader.define(name, text);
    }
    shader.compile().map_err(|error| texts.failure(&error))
}

/// For people.
fn text(programs: &[(String, Program)], between: &[Warning]) -> String {
    let mut text = String::new();
    let mut line = |words: std::fmt::Arguments<'_>| {
        writeln!(text, "{words}").expect("a string takes everything");
    };
    for (file, program) in programs {
        let (each, once, registers) = program.size();
        let stage = program.stage().name();
        line(format_args!(
            "{file}: {stage} shader, {each} instructions, {once} once per draw, {registers} registers"
        ));
        let interface = program.interface();
        for port in interface.inputs.iter().filter(|port| !port.builtin) {
            line(format_args!(
                "  in       {}",
                described(&port.name, &port.ty.to_string(), port.role.as_ref())
            ));
        }
        for own in &interface.uniforms {
            line(format_args!("  uniform  {}", described(&own.name, &own.ty.to_string(), own.role.as_ref())));
        }
        for texture in &interface.textures {
            line(format_args!("  texture  {} {}", texture.name, texture.dimension));
        }
        for port in interface.outputs.iter().filter(|port| !port.builtin) {
            line(format_args!("  out      {}", described(&port.name, &port.ty.to_string(), None)));
        }
        program.warnings().iter().for_each(|warning| line(format_args!("{}", told(warning))));
    }
    between.iter().for_each(|warning| line(format_args!("{}", told(warning))));
    text
}

/// A name with its type and what it stands for.
fn described(name: &str, ty: &str, role: Option<&Role>) -> String {
    let words = role.map(|role| format!(" = {}", words(role))).unwrap_or_default();
    format!("{name} {ty}{words}")
}

/// The name of a role, in small words.
fn words(role: &Role) -> String {
    let mut words = String::new();
    for c in format!("{role:?}").chars() {
        if c.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(c.to_lowercase());
    }
    words
}

pub(super) fn told(Warning { place, message }: &Warning) -> String {
    place
        .as_ref()
        .map_or_else(|| format!("warning: {message}"), |place| format!("warning: {place}: {message}"))
}

/// Shaders that compile.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    shaders: Vec<ShaderFacts>,
    /// What does not fit between a vertex and a fragment shader
    between: Vec<WarningFacts>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ShaderFacts {
    file: String,
    /// vertex or fragment
    stage: String,
    /// For each vertex or fragment, loops once
    instructions: usize,
    registers: usize,
    inputs: Vec<VariableFacts>,
    uniforms: Vec<VariableFacts>,
    textures: Vec<String>,
    outputs: Vec<VariableFacts>,
    /// What is right but probably not meant
    warnings: Vec<WarningFacts>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct VariableFacts {
    name: String,
    /// As GLSL names it
    r#type: String,
    /// What it stands for by its name; null where that is for the user to set
    role: Option<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct WarningFacts {
    message: String,
    file: Option<String>,
    line: Option<u32>,
    column: Option<u32>,
}

impl ShaderFacts {
    fn of((file, program): &(String, Program)) -> Self {
        let interface = program.interface();
        let ports =
            |ports: &[Port]| ports.iter().filter(|port| !port.builtin).map(VariableFacts::of_port).collect();
        Self {
            file: file.clone(),
            stage: program.stage().name().to_owned(),
            instructions: program.size().0,
            registers: program.size().2,
            inputs: ports(&interface.inputs),
            uniforms: interface.uniforms.iter().map(VariableFacts::of_uniform).collect(),
            textures: interface.textures.iter().map(|texture| texture.name.clone()).collect(),
            outputs: ports(&interface.outputs),
            warnings: program.warnings().iter().map(WarningFacts::of).collect(),
        }
    }
}

impl VariableFacts {
    fn of_port(port: &Port) -> Self {
        Self { name: port.name.clone(), r#type: port.ty.to_string(), role: port.role.as_ref().map(words) }
    }

    fn of_uniform(own: &Uniform) -> Self {
        Self { name: own.name.clone(), r#type: own.ty.to_string(), role: own.role.as_ref().map(words) }
    }
}

impl WarningFacts {
    fn of(Warning { place, message }: &Warning) -> Self {
        let of = |value: fn(&Place) -> u32| place.as_ref().map(value);
        Self {
            message: message.clone(),
            file: place.as_ref().map(|place| place.file.clone()),
            line: of(|place| place.line),
            column: of(|place| place.column),
        }
    }
}
