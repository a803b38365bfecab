//! Shaders that draw in place of the materials.

use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use glanz_render::Moment;
use glanz_scene::read::{ReadOptions, read_texture, remark_of_texture};
use glanz_scene::{Program, ProgramText, Scene, Texture, UniformValue, cube_face_files};

use crate::input::shader_text::{included, read};
use crate::input::whole_file::{MOST_BYTES, read_whole};
use crate::print;
use crate::print::failure::{Failure, Report, without_number};

/// Shaders of one's own.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Program")]
pub(crate) struct ProgramArgs {
    /// Draw all objects by this vertex shader: GLSL, or WGSL if its name ends in .wgsl
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub vs: Option<PathBuf>,

    /// Draw all objects by this fragment shader
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub fs: Option<PathBuf>,

    /// Set a uniform of the program, such as exposure=1.5, tint=1,0.5,0, picture=wood.png or sky=sky_*.png (six faces);
    /// may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = uniform)]
    pub uniform: Vec<(String, String)>,

    /// The time that programs are told, in seconds; in a film that of its first picture
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, allow_hyphen_values = true)]
    pub time: f32,

    /// Where the pointer is for programs: pixels from the lower left
    #[arg(long, value_name = "X,Y", value_parser = mouse)]
    pub mouse: Option<[f32; 2]>,
}

fn mouse(text: &str) -> Result<[f32; 2], String> {
    let both: Result<[f64; 2], _> = super::numbers(text)?.try_into();
    both.map(|both| both.map(|number| number as f32))
        .map_err(|_| "expected a place, such as 320,240".to_owned())
}

impl ProgramArgs {
    /// What programs are told of the first picture.
    pub(crate) fn moment(&self) -> Moment {
        let [x, y] = self.mouse.unwrap_or_default();
        Moment { time: self.time, mouse: [x, y, 0.0, 0.0], ..Moment::default() }
    }

    /// Lets the scene be drawn by what the options name, in place of or beside its own program.
    pub(crate) fn apply(&self, scene: &mut Scene) -> Result<(), Failure> {
        if self.vs.is_none() && self.fs.is_none() && self.uniform.is_empty() {
            return self.check_moment(scene);
        }
        let own = scene.program.and_then(|own| scene.programs.get(own)).cloned();
        let mut program = match (&self.vs, &self.fs) {
            (None, None) => own.ok_or_else(|| {
                Failure::Usage(
                    "--uniform needs a program: add --fs or --vs, or `program` in the scene".to_owned(),
                )
            })?,
            _ => Program::default(),
        };
        for (file, stage) in [(&self.vs, &mut program.vertex), (&self.fs, &mut program.fragment)] {
            if let Some(file) = file {
                *stage = Some(text(file)?);
            }
        }
        for (name, value) in &self.uniform {
            let value = self.value(name, value, scene)?;
            program.uniforms.insert(name.clone(), value);
        }
        // What the command line says holds for objects with a program of their own, too.
        if self.vs.is_some() || self.fs.is_some() {
            scene.objects.iter_mut().for_each(|object| object.program = None);
        }
        scene.set_program(program);
        Ok(())
    }

    /// That there is a program to be told of time and pointer.
    fn check_moment(&self, scene: &Scene) -> Result<(), Failure> {
        let has_program = scene.program.is_some() || scene.objects.iter().any(|own| own.program.is_some());
        let given = [("--time", self.time != 0.0), ("--mouse", self.mouse.is_some())];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            Some((option, _)) if !has_program => Err(Failure::Usage(format!(
                "{option} needs a program: add --fs or --vs, or `program` in the scene"
            ))),
            _ => Ok(()),
        }
    }

    /// Numbers between commas, true or false, or a picture.
    fn value(&self, name: &str, value: &str, scene: &mut Scene) -> Result<UniformValue, Failure> {
        match value.trim() {
            "true" => return Ok(UniformValue::Numbers(vec![1.0])),
            "false" => return Ok(UniformValue::Numbers(vec![0.0])),
            _ => {}
        }
        if let Ok(numbers) = super::numbers(value) {
            return Ok(UniformValue::Numbers(numbers));
        }
        let mut add = |file: &str| {
            scene.textures.push(texture(file)?);
            Ok::<usize, Failure>(scene.textures.len() - 1)
        };
        if let Some(faces) = cube_faces(value) {
            let mut indices = [0; 6];
            for (index, file) in indices.iter_mut().zip(&faces) {
                *index = add(file)?;
            }
            return Ok(UniformValue::Cube(indices));
        }
        if !Path::new(value).is_file() {
            let message =
                format!("--uniform {name}: expected numbers between commas, or a picture, not '{value}'");
            return Err(Failure::Usage(message));
        }
        Ok(UniformValue::Texture(add(value)?))
    }

    /// The files that the options name, with all that these may include.
    pub(crate) fn files(&self) -> Vec<PathBuf> {
        let mut files = Vec::new();
        for file in [&self.vs, &self.fs].into_iter().flatten() {
            files.push(file.clone());
            let includes = text(file).map(|text| text.includes).unwrap_or_default();
            let folder = file.parent().unwrap_or(Path::new(""));
            files.extend(includes.keys().map(|name| folder.join(name)));
        }
        files
    }
}

/// A file with what it includes.
pub(crate) fn text(file: &Path) -> Result<ProgramText, Failure> {
    let text = read(file)?;
    let mut found = |path: &str| included(file, path);
    Ok(ProgramText::with_includes(file.display().to_string(), text, &mut found))
}

/// The files of a cube map's faces: six between commas, or a pattern with '*' for their names.
pub(crate) fn cube_faces(value: &str) -> Option<[String; 6]> {
    let there = |names: &[String; 6]| Path::new(&names[0]).is_file();
    let ways = cube_face_files(value);
    let named = ways.iter().find(|names| there(names)).or(ways.first()).cloned();
    named.or_else(|| {
        let files: Vec<String> = value.split(',').map(|file| file.trim().to_owned()).collect();
        files.try_into().ok()
    })
}

fn texture(file: &str) -> Result<Texture, Failure> {
    let path = Path::new(file);
    let could_not =
        |why: String| Failure::from(Report::new(format!("cannot read '{file}': {why}")).file(path));
    let bytes =
        read_whole(path, MOST_BYTES).map_err(|error| could_not(without_number(&error.to_string())))?;
    let texture = read_texture(&bytes, file, &ReadOptions::default());
    let texture = texture.map_err(|error| could_not(error.to_string()))?;
    remark_of_texture(&bytes, file).iter().for_each(|note| print::note(format_args!("note: {note}")));
    Ok(texture)
}

/// `NAME=VALUE`.
fn uniform(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE, such as exposure=1.5")?;
    match name.trim().is_empty() || value.trim().is_empty() {
        true => Err("expected NAME=VALUE, such as exposure=1.5".to_owned()),
        false => Ok((name.trim().to_owned(), value.trim().to_owned())),
    }
}
