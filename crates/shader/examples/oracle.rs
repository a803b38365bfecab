//! Runs all fragment shaders of a folder over 16×16 pixels and writes beside each what it gives: `NAME.f32`, red, green,
//! blue and alpha as numbers by rows from the bottom, or `NAME.error`. The Python tests compare them with OpenGL.
//!
//!     cargo run -p glanz-shader --example oracle -- FOLDER

use std::error::Error;
use std::path::{Path, PathBuf};

use glanz_shader::{Moment, Pictures, Screen, Shader, TexturePicture};

/// Pixels along a side, of the picture and of the texture.
const SIDE: u32 = 16;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("expected the folder of the shaders")?;
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "frag") {
            match drawn(&path) {
                Ok(bytes) => std::fs::write(path.with_extension("f32"), bytes)?,
                Err(error) => std::fs::write(path.with_extension("error"), error.to_string())?,
            }
        }
    }
    Ok(())
}

fn drawn(path: &PathBuf) -> Result<Vec<u8>, Box<dyn Error>> {
    let program = Shader::fragment(std::fs::read_to_string(path)?).named(name(path)).compile()?;
    let mut uniforms = program.uniforms();
    let size = [SIDE; 2];
    let picture = |dimension| match dimension {
        "cube" => cube(),
        _ => Some(TexturePicture::new(SIDE, SIDE, &texels())),
    };
    let pictures = Pictures(program.interface().textures.iter().map(|own| picture(own.dimension)).collect());
    Moment { size, ..Moment::default() }.fill(&program, &mut uniforms);
    let picture = Screen::new(&program, &uniforms, size)?.textures(&pictures).draw(&mut |_| {})?;
    let rows = picture.pixels.chunks(picture.width).rev();
    Ok(rows.flatten().flatten().flat_map(|value| value.to_le_bytes()).collect())
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Smooth, but different in every texel; by rows from the top. The same as in the Python test.
fn texels() -> Vec<u8> {
    let rows = (0..SIDE).rev();
    rows.flat_map(|y| {
        (0..SIDE).flat_map(move |x| {
            [x * 15 + y, y * 15 + x, (x * y) % 200, 255 - x * 3 - y * 5].map(|code| code as u8)
        })
    })
    .collect()
}

/// A cube map, whose faces are by rows from t = 0. The same as in the Python test.
fn cube() -> Option<TexturePicture> {
    let from_bottom = texels();
    let rows: Vec<&[u8]> = from_bottom.chunks(4 * SIDE as usize).rev().collect();
    let face = |face: u8| {
        let more = [20 * face, 100 - 15 * face, 25 * face, 10];
        let codes = rows.concat().into_iter().zip(more.into_iter().cycle());
        let codes: Vec<u8> = codes.map(|(code, more)| code / 2 + more).collect();
        TexturePicture::new(SIDE, SIDE, &codes)
    };
    TexturePicture::cube([0, 1, 2, 3, 4, 5].map(face))
}
