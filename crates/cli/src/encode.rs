//! From pictures to files.

use std::io::{Cursor, Seek, Write};

use glanz_color::exr::{SpectralImage, write_spectral_exr};
use glanz_picture::output::{
    Animation, Effort, Format, Metadata, OutputError, write_apng, write_atomically, write_exr, write_gif,
    write_png8, write_png16,
};
use glanz_plot::Canvas;

use super::args::Target;
use super::pipeline::{Picture, Plan};
use super::print;
use super::print::failure::Failure;

/// How long a picture alone is shown in a format that moves.
const STILL_MS: u32 = 1000;

/// The format that the target asks for by its ending.
pub fn format(target: &Target) -> Result<Format, Failure> {
    match target {
        Target::Stdout => Ok(Format::Png),
        Target::File(path) => Format::from_path(path).map_err(|error| Failure::Usage(error.to_string())),
    }
}

/// That the target is a PNG, for pictures that are made of codes only.
pub fn expect_png(target: &Target, what: &str) -> Result<(), Failure> {
    match format(target)? {
        Format::Png => Ok(()),
        other => Err(Failure::Usage(format!("{what} is written as .png, not as {}", other.name()))),
    }
}

/// The number for the content of a scene, as files carry it.
pub fn scene_hash(hash: u64) -> String {
    format!("{hash:016x}")
}

/// What a picture tells about its scene.
pub fn metadata(hash: u64) -> Metadata {
    Metadata { scene_hash: Some(scene_hash(hash)), ..Metadata::default() }
}

/// What a picture tells about its scene, and about how its colours came to be.
pub fn metadata_of(hash: u64, plan: &Plan) -> Metadata {
    Metadata { entries: plan.facts(), ..metadata(hash) }
}

/// Writes a picture as it was drawn.
pub fn write(
    out: impl Write + Seek,
    picture: Picture,
    format: Format,
    metadata: &Metadata,
) -> Result<(), OutputError> {
    match (picture, format) {
        (Picture::Codes8(canvas), Format::Gif) => write_gif(out, &still(&canvas), [Ok(canvas.rgba)]),
        (Picture::Codes8(canvas), Format::Apng) => {
            write_apng(out, &still(&canvas), [Ok(canvas.rgba)], metadata)
        }
        (Picture::Codes8(canvas), _) => {
            write_png8(out, (canvas.width, canvas.height), &canvas.rgba, Effort::Fast, metadata)
        }
        (Picture::Codes16 { width, height, rgba }, _) => {
            write_png16(out, (width, height), &rgba, Effort::Fast, metadata)
        }
        (Picture::Spectrum(image), _) => write_spectrum(out, image, metadata),
        (Picture::Light(light), _) => write_exr(out, light.screen, light.channels, metadata),
    }
}

/// Writes the spectrum of each pixel, and what the picture tells about its scene.
fn write_spectrum(
    out: impl Write + Seek,
    mut image: SpectralImage,
    metadata: &Metadata,
) -> Result<(), OutputError> {
    image.texts = metadata.pairs().map(|(key, value)| (key.to_owned(), value.to_owned())).collect();
    Ok(write_spectral_exr(out, image)?)
}

fn still(canvas: &Canvas) -> Animation {
    Animation { width: canvas.width, height: canvas.height, frames: 1, delay_ms: STILL_MS }
}

/// The bytes of a picture's file.
pub fn to_memory(picture: Picture, format: Format, metadata: &Metadata) -> Result<Vec<u8>, OutputError> {
    let mut out = Cursor::new(Vec::new());
    write(&mut out, picture, format, metadata)?;
    Ok(out.into_inner())
}

/// Brings a picture to where it goes. A file is old or new, but never half.
pub fn deliver(picture: Picture, target: &Target, metadata: &Metadata) -> Result<(), Failure> {
    let format = format(target)?;
    match target {
        Target::Stdout => print::bytes(&to_memory(picture, format, metadata)?),
        Target::File(path) => {
            write_atomically(path, |out| write(out, picture, format, metadata)).map_err(Failure::from)
        }
    }
}
