//! `glanz shader export`: the lights and materials of a scene as programs with filled structs.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_bsdf::LightTerm;
use glanz_math::names::shown;
use glanz_picture::output::{OutputError, write_atomically};
use glanz_render::{Shot, UniformFill};
use glanz_scene::{Program, ProgramText, Scene};
use glanz_shader::{DefaultProgram, Stage};
use schemars::JsonSchema;
use serde::Serialize;

use super::scene::SceneArgs;
use crate::print::failure::{Failure, Report, without_number};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shader export scene.toml -o program
  glanz render scene.toml --fs program/red.frag

Of each material a fragment shader in GLSL 330, whose structs LightSources and Material hold the scene's numbers, the
vertex shader for all of them, and the same in WGSL. Places of lights are in the camera's space.";

/// Options of `glanz shader export`.
#[derive(Args, Debug)]
pub(crate) struct ExportArgs {
    #[command(flatten)]
    scene: SceneArgs,

    /// The folder for the files, which is made if it is not there
    #[arg(short, long, value_name = "FOLDER", value_hint = ValueHint::DirPath, help_heading = "Output")]
    output: PathBuf,

    #[command(flatten)]
    format: FormatArgs,
}

impl ExportArgs {
    /// Writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.output.as_os_str() == "-" {
            return Err(Failure::Usage("stdout takes one file, not a folder; name one with -o".to_owned()));
        }
        let (scene, shot) = self.scene.shot()?;
        let mut notes = Vec::new();
        let mut files = Vec::new();
        let (mut done, mut names) = (Vec::new(), HashSet::new());
        for (number, object) in scene.objects.iter().enumerate() {
            if !done.contains(&object.material) {
                done.push(object.material);
                files.extend(of_material(&scene, &shot, number, &mut names, &mut notes)?);
            }
        }
        if files.is_empty() {
            return Err(Report::new("the scene has no object, so there is no material to be written").into());
        }
        let vertex = known("phong-330")?.text(Stage::Vertex);
        files.insert(0, ("scene.vert".to_owned(), vertex));
        self.write(&files)?;
        for (name, _) in &files {
            print::note(format_args!("wrote {}", self.output.join(name).display()));
        }
        notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
        if !self.format.is_json() {
            return Ok(());
        }
        let names = files.iter().map(|(name, _)| self.output.join(name).display().to_string());
        print::json(&Document { files: names.collect(), notes })
    }

    fn write(&self, files: &[(String, String)]) -> Result<(), Failure> {
        std::fs::create_dir_all(&self.output).map_err(|error| {
            let why = without_number(&error.to_string());
            let message = format!("cannot make the folder '{}': {why}", self.output.display());
            Failure::from(Report::new(message).file(&self.output))
        })?;
        for (name, text) in files {
            let path = self.output.join(name);
            write_atomically(&path, |out| {
                std::io::Write::write_all(out, text.as_bytes()).map_err(|source| OutputError::File {
                    path: path.clone(),
                    action: "write it",
                    source,
                })
            })?;
        }
        Ok(())
    }
}

fn known(name: &str) -> Result<&'static DefaultProgram, Failure> {
    DefaultProgram::named(name).ok_or_else(|| Failure::new(format_args!("there is no program '{name}'")))
}

/// The texts of a material, as the object of this number has it.
fn of_material(
    scene: &Scene,
    shot: &Shot,
    object: usize,
    names: &mut HashSet<String>,
    notes: &mut Vec<String>,
) -> Result<Vec<(String, String)>, Failure> {
    let number = scene.objects[object].material;
    let material = &scene.materials[number];
    let name = file_stem(&material.name, number, names);
    let program = program_of(scene, number, notes)?;
    let fills = |program: &DefaultProgram| -> Result<Vec<UniformFill>, Failure> {
        let text = ProgramText::new(program.file_name(Stage::Fragment), program.text(Stage::Fragment));
        Ok(shot.uniforms_of(&Program::of_fragment(text), object)?)
    };
    let values = fills(program)?;
    let held = count(&values).max(1);
    let glsl = program.filled(Stage::Fragment, &glsl_values(&values));
    let glsl = glsl.replace("const int MNL = 10; ", &format!("const int MNL = {held}; "));
    let wgsl = DefaultProgram::filled_wgsl(&wgsl_values(&fills(known("phong-330")?)?));
    Ok(vec![(format!("{name}.frag"), glsl), (format!("{name}.wgsl"), wgsl)])
}

/// The program of the material's first highlight.
fn program_of(
    scene: &Scene,
    number: usize,
    notes: &mut Vec<String>,
) -> Result<&'static DefaultProgram, Failure> {
    let material = &scene.materials[number];
    let highlight = material.lobes.iter().find(|lobe| lobe.shape.info().term == LightTerm::Specular);
    let model = highlight.map_or("lambert", |lobe| lobe.shape.info().name);
    if let Some(program) = DefaultProgram::all().iter().find(|program| program.model == Some(model)) {
        return Ok(program);
    }
    let name = shown(&material.name);
    notes.push(format!("material '{name}': its model {model} has no program; Phong's stands in"));
    known("phong-330")
}

/// A name for files, from that of a material; another than those that are `taken`, also where case does not count.
fn file_stem(name: &str, number: usize, taken: &mut HashSet<String>) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || "-_".contains(c) { c } else { '_' };
    let mut stem: String = match name {
        "" => format!("material{number}"),
        name => name.chars().map(plain).collect(),
    };
    while !taken.insert(stem.to_ascii_lowercase()) {
        stem += &format!("_{number}");
    }
    stem
}

/// A number that reads back to the same bits.
fn number(value: f32) -> String {
    format!("{value:?}")
}

/// The value of a uniform.
fn value_of<'a>(fills: &'a [UniformFill], name: &str) -> &'a [f32] {
    fills.iter().find(|fill| fill.name == name).map_or(&[], |fill| &fill.values)
}

/// The members of a light, in their order, and how many numbers each is.
const LIGHT: [(&str, usize); 10] = [
    ("posDir", 4),
    ("ambient", 4),
    ("diffuse", 4),
    ("specular", 4),
    ("constantAttenuation", 1),
    ("linearAttenuation", 1),
    ("quadraticAttenuation", 1),
    ("spotDirection", 3),
    ("spotCutoff", 1),
    ("spotExponent", 1),
];

fn joined(values: &[f32]) -> String {
    values.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}

/// The numbers of a light, member by member; `vector` names the constructor of so many numbers.
fn light(fills: &[UniformFill], i: usize, vector: &dyn Fn(usize) -> String) -> String {
    let member = |(name, count): (&str, usize)| {
        let values = value_of(fills, &format!("lights.source[{i}].{name}"));
        if count == 1 { joined(values) } else { format!("{}({})", vector(count), joined(values)) }
    };
    LIGHT.map(member).join(", ")
}

/// How many lights the structs hold.
fn count(fills: &[UniformFill]) -> usize {
    value_of(fills, "lights.nbrLights").first().map_or(0, |count| *count as usize).min(10)
}

/// The constants in GLSL.
fn glsl_values(fills: &[UniformFill]) -> String {
    let vector = |count: usize| format!("vec{count}");
    let mut text = format!(
        "// In the camera's space.\nconst LightSources lights = LightSources({}, LightSource[MNL](\n",
        count(fills)
    );
    let held = count(fills).max(1);
    for i in 0..held {
        let end = if i + 1 < held { "," } else { "" };
        writeln!(text, "    LightSource({}){end}", light(fills, i, &vector))
            .expect("a string takes everything");
    }
    text.push_str("));\n");
    let members = fills.iter().filter(|fill| fill.name.starts_with("material."));
    let member = |fill: &UniformFill| match fill.values.len() {
        1 => joined(&fill.values),
        count => format!("vec{count}({})", joined(&fill.values)),
    };
    let all: Vec<_> = members.map(member).collect();
    writeln!(text, "const Material material = Material({});", all.join(", "))
        .expect("a string takes everything");
    text
}

/// The constants in WGSL, which allows no array without elements.
fn wgsl_values(fills: &[UniformFill]) -> String {
    let vector = |count: usize| format!("vec{count}<f32>");
    let count = count(fills);
    let held = count.max(1);
    let mut text = format!(
        "const count = {count}u;\nvar<private> source: array<LightSource, {held}> = array<LightSource, {held}>(\n"
    );
    for i in 0..held {
        writeln!(text, "    LightSource({}),", light(fills, i, &vector)).expect("a string takes everything");
    }
    text.push_str(");\n");
    let member = |name: &str| format!("vec4<f32>({})", joined(value_of(fills, &format!("material.{name}"))));
    let colors = ["ambient", "diffuse", "specular", "emission"].map(member).join(", ");
    let shininess = joined(value_of(fills, "material.shininess"));
    writeln!(text, "const material = Material({colors}, {shininess});\n").expect("a string takes everything");
    text
}

/// Programs of a scene that were written.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    files: Vec<String>,
    /// What stands in for something else
    notes: Vec<String>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn materials_have_files_of_their_own() {
        let mut taken = HashSet::new();
        let names = ["a b", "A_b", "紅", "白", "", "a_b_1"];
        let stems: Vec<_> = (0..).zip(names).map(|(i, name)| file_stem(name, i, &mut taken)).collect();
        assert_eq!(stems, ["a_b", "A_b_1", "_", "__3", "material4", "a_b_1_5"]);
    }
}
