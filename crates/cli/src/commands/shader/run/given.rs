//! What the command line gives programs: pictures and numbers.

use std::path::Path;

use glanz_scene::read::{ReadOptions, read_texture, remark_of_texture};
use glanz_shader::{Program, TextureInfo, TexturePicture, UniformError, UniformValues};

use super::RunArgs;
use crate::args::{cube_faces, numbers};
use crate::input::whole_file::{MOST_BYTES, read_whole};
use crate::print;
use crate::print::failure::{Failure, Report, without_number};

/// The picture of a file for a texture.
pub(super) fn picture(file: &str, texture: &TextureInfo) -> Result<TexturePicture, Failure> {
    let name = &texture.name;
    let is_known = matches!((texture.dimension, texture.compared), ("2d", _) | ("cube", false));
    if texture.layered || !is_known {
        let message = format!(
            "a picture fills a sampler2D, a sampler2DShadow or a samplerCube, and '{name}' is another kind of texture"
        );
        return Err(Failure::Usage(message));
    }
    if texture.dimension == "2d" {
        return read(file);
    }
    let Some(faces) = cube_faces(file) else { return Ok(read(file)?.panorama()) };
    let mut pictures = Vec::with_capacity(6);
    for face in &faces {
        pictures.push(read(face)?);
    }
    let cube = pictures.try_into().ok().and_then(TexturePicture::cube);
    cube.ok_or_else(|| {
        Failure::Usage(format!("the faces of the cube map '{name}' must be squares of one size"))
    })
}

fn read(file: &str) -> Result<TexturePicture, Failure> {
    let path = Path::new(file);
    let could_not =
        |why: &str| Failure::from(Report::new(format_args!("cannot read '{file}': {why}")).file(path));
    let io = |error: std::io::Error| could_not(&without_number(&error.to_string()));
    let bytes = read_whole(path, MOST_BYTES).map_err(io)?;
    let texture = read_texture(&bytes, file, &ReadOptions::default())
        .map_err(|error| Failure::from(Report::new(error).file(path)))?;
    remark_of_texture(&bytes, file).iter().for_each(|note| print::note(format_args!("note: {note}")));
    Ok(TexturePicture::new(texture.width, texture.height, &texture.rgba))
}

/// Uniforms and the numbers that they are set to.
type Set = Vec<(String, Vec<f32>)>;

/// The numbers of uniforms, of each program those that it has.
pub(super) fn uniforms<'a>(
    args: &RunArgs,
    programs: impl Iterator<Item = &'a Program>,
) -> Result<Vec<Set>, Failure> {
    let mut values: Vec<UniformValues> = programs.map(Program::uniforms).collect();
    let mut all = vec![Vec::new(); values.len()];
    for (name, text) in &args.uniform {
        let usage = |error: String| Failure::Usage(format!("--uniform {name}: {error}"));
        let text = match text.as_str() {
            "true" => "1",
            "false" => "0",
            text => text,
        };
        let numbers: Vec<f32> = numbers(text).map_err(usage)?.into_iter().map(|x| x as f32).collect();
        let mut unknown = None;
        for (values, set) in values.iter_mut().zip(&mut all) {
            match values.set(name, &numbers) {
                Ok(()) => set.push((name.clone(), numbers.clone())),
                Err(error @ UniformError::Unknown { .. }) => unknown = Some(error),
                Err(error) => return Err(usage(error.to_string())),
            }
        }
        if let Some(error) = unknown.filter(|_| all.iter().all(|set| set.iter().all(|(own, _)| own != name)))
        {
            return Err(usage(error.to_string()));
        }
    }
    Ok(all)
}
