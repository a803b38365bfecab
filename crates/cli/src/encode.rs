//! From pictures to files.

use glanz_picture::output::{Format, Metadata, PictureData};

use super::args::Target;
use super::print;
use super::print::failure::Failure;

/// The format that the target asks for by its ending.
pub(crate) fn format(target: &Target) -> Result<Format, Failure> {
    match target {
        Target::Stdout => Ok(Format::Png),
        Target::File(path) => Format::from_path(path).map_err(|error| Failure::Usage(error.to_string())),
    }
}

/// That the target is a PNG, for pictures that are made of codes only.
pub(crate) fn expect_png(target: &Target, what: &str) -> Result<(), Failure> {
    match format(target)? {
        Format::Png => Ok(()),
        other => Err(Failure::Usage(format!("{what} is written as .png, not as {}", other.name()))),
    }
}

/// The number for the content of a scene, as files carry it.
pub(crate) fn scene_hash(hash: u64) -> String {
    format!("{hash:016x}")
}

/// What a picture tells about its scene.
pub(crate) fn metadata(hash: u64) -> Metadata {
    Metadata { scene_hash: Some(scene_hash(hash)), ..Metadata::default() }
}

/// What a sheet of pictures tells about its scene, and what is unusual about how they were drawn.
pub(crate) fn metadata_of_sheet(hash: u64, entries: Vec<(String, String)>) -> Metadata {
    Metadata { entries, ..metadata(hash) }
}

/// Brings a picture to where it goes. A file is old or new, but never half.
pub(crate) fn deliver(picture: PictureData, target: &Target, metadata: &Metadata) -> Result<(), Failure> {
    let format = format(target)?;
    match target {
        Target::Stdout => print::bytes(&picture.to_bytes(format, metadata)?),
        Target::File(path) => Ok(picture.save(path, metadata)?),
    }
}
