//! What the command line gives a program: pictures and numbers.

use std::path::Path;

use glanz_math::names::did_you_mean;
use glanz_scene::read::{ReadOptions, read_texture};
use glanz_shader::{Pictures, Program, TextureInfo, TexturePicture};

use super::RunArgs;
use crate::args::{cube_faces, numbers};
use crate::print::failure::{Failure, Report, without_number};

/// A file of a picture is no longer than this.
const MOST_BYTES: u64 = 1 << 28;

/// The pictures of the textures, in their order.
pub(super) fn pictures(args: &RunArgs, program: &Program) -> Result<Pictures, Failure> {
    let textures = &program.interface().textures;
    let mut pictures = vec![None; textures.len()];
    let channels = [&args.channel0, &args.channel1, &args.channel2, &args.channel3];
    for (number, file) in channels.into_iter().enumerate() {
        let Some(file) = file else { continue };
        let names = [format!("iChannel{number}"), format!("u_tex{number}")];
        let index = textures.iter().position(|own| names.contains(&own.name)).ok_or_else(|| {
            Failure::Usage(format!(
                "--channel{number}: the shader looks into no texture '{}'",
                names.join("' or '")
            ))
        })?;
        pictures[index] = Some(picture(&file.to_string_lossy(), &textures[index])?);
    }
    for (name, file) in &args.texture {
        let index = textures.iter().position(|own| own.name == *name).ok_or_else(|| {
            let hint = did_you_mean(name, textures.iter().map(|own| own.name.as_str()));
            Failure::Usage(format!("--texture: the shader looks into no texture '{name}'{hint}"))
        })?;
        pictures[index] = Some(picture(file, &textures[index])?);
    }
    Ok(Pictures(pictures))
}

fn picture(file: &str, texture: &TextureInfo) -> Result<TexturePicture, Failure> {
    let name = &texture.name;
    if texture.layered || texture.compared || !matches!(texture.dimension, "2d" | "cube") {
        let message =
            format!("a picture fills a sampler2D or a samplerCube, and '{name}' is another kind of texture");
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
    let length = std::fs::metadata(path).map_err(io)?.len();
    if length > MOST_BYTES {
        return Err(could_not(&format!("a picture of {length} bytes is more than {MOST_BYTES}")));
    }
    let bytes = std::fs::read(path).map_err(io)?;
    let texture = read_texture(&bytes, file, &ReadOptions::default())
        .map_err(|error| Failure::from(Report::new(error).file(path)))?;
    Ok(TexturePicture::new(texture.width, texture.height, &texture.rgba))
}

/// The numbers of uniforms.
pub(super) fn uniforms(args: &RunArgs, program: &Program) -> Result<Vec<(String, Vec<f32>)>, Failure> {
    let mut values = program.uniforms();
    let mut all = Vec::new();
    for (name, text) in &args.uniform {
        let usage = |error: String| Failure::Usage(format!("--uniform {name}: {error}"));
        let text = match text.as_str() {
            "true" => "1",
            "false" => "0",
            text => text,
        };
        let numbers: Vec<f32> = numbers(text).map_err(usage)?.into_iter().map(|x| x as f32).collect();
        values.set(name, &numbers).map_err(|error| usage(error.to_string()))?;
        all.push((name.clone(), numbers));
    }
    Ok(all)
}
