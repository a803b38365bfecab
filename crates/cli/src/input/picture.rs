//! Pictures that an eye looks at in place of a scene.

use std::path::Path;

use glanz_color::Observer;
use glanz_color::exr::{SpectralImage, read_spectral_exr};
use glanz_color::read::{Place, ReadError};
use glanz_eye::Viewer;
use glanz_math::{MemoryBudget, OverBudget};
use glanz_picture::Frame;
use glanz_picture::compare::{Scale, decode_picture_within};
use glanz_render::{PictureLight, SeenPicture, picture_frame, see_picture};

use crate::input::whole_file::{MOST_BYTES, read_whole};
use crate::print::failure::{Failure, Report};

/// The endings of pictures.
const ENDINGS: [&str; 2] = ["exr", "png"];

/// The light of a picture file.
pub(crate) struct PictureInput {
    path: std::path::PathBuf,
    light: OwnLight,
    /// What is odd about it, or stands for something.
    pub notes: Vec<String>,
}

enum OwnLight {
    Spectra(Box<SpectralImage>),
    Rgb { width: usize, rgb: Box<[Vec<f32>; 3]> },
}

impl PictureInput {
    /// Whether a file is a picture, not a scene, by its name.
    pub(crate) fn is_named(path: &Path) -> bool {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
    }

    /// Reads one, which may take so much memory with what an eye makes of it.
    pub(crate) fn read(path: &Path, mut memory: MemoryBudget) -> Result<Self, Failure> {
        let bytes =
            read_whole(path, MOST_BYTES).map_err(|error| Failure::from(Report::new(error).file(path)))?;
        let name = path.display().to_string();
        let told = |error: &dyn std::fmt::Display| Failure::from(Report::new(error).file(path));
        if let Some(image) = spectra(&bytes, &name, memory).map_err(|error| told(&error))? {
            let bands = 4 * (image.emissive.len() + image.reflective.len()) as u64;
            take_seen(&mut memory, (image.width, image.height), bands).map_err(|over| told(&over))?;
            let light = OwnLight::Spectra(Box::new(image));
            return Ok(Self { path: path.to_owned(), light, notes: Vec::new() });
        }
        let picture = decode_picture_within(&bytes, &name, &mut memory).map_err(|error| told(&error))?;
        take_seen(&mut memory, (picture.width, picture.height), 0).map_err(|over| told(&over))?;
        let mut notes = picture.notes;
        let kind = if picture.scale == Scale::Codes { "codes" } else { "linear light" };
        notes.push(format!(
            "the picture has no spectra: its {kind} stand for the smooth ones of Mallett and Yuksel (2019) under D65"
        ));
        let light = OwnLight::Rgb { width: picture.width, rgb: Box::new(picture.rgb) };
        Ok(Self { path: path.to_owned(), light, notes })
    }

    /// The picture as an eye sees it.
    pub(crate) fn seen_by(&self, viewer: &Viewer) -> Result<SeenPicture, Failure> {
        see_picture(self.light(), viewer).map_err(|error| Failure::from(Report::new(error).file(&self.path)))
    }

    /// What the channels of an observer have of it.
    pub(crate) fn channels(&self, observer: &Observer) -> Result<Frame, Failure> {
        picture_frame(self.light(), observer)
            .map_err(|error| Failure::from(Report::new(error).file(&self.path)))
    }

    fn light(&self) -> PictureLight<'_> {
        match &self.light {
            OwnLight::Spectra(image) => PictureLight::Spectra(image),
            OwnLight::Rgb { width, rgb } => PictureLight::Rgb { width: *width, rgb },
        }
    }
}

/// What an eye makes of a pixel: its channels, a copy to blur, and what a screen shows.
const SEEN: u64 = 64;

/// Takes what an eye makes of a picture, beside so many bytes of each pixel.
fn take_seen(
    memory: &mut MemoryBudget,
    (width, height): (usize, usize),
    more: u64,
) -> Result<(), OverBudget> {
    let bytes = (width as u64 * height as u64).saturating_mul(SEEN + more);
    memory.take(format_args!("what an eye sees of {width}×{height} pixels"), bytes)
}

/// The spectra of a picture, if it has spectra of light.
fn spectra(bytes: &[u8], name: &str, memory: MemoryBudget) -> Result<Option<SpectralImage>, ReadError> {
    let image = match read_spectral_exr(bytes, name, memory.left()) {
        Ok(image) => image,
        Err(ReadError::TooLarge { found, .. }) => {
            let over = memory.check("its planes", found).err();
            return over.map_or(Ok(None), |over| Err(ReadError::memory(name, Place::File, over)));
        }
        Err(_) => return Ok(None),
    };
    Ok((!image.emissive.is_empty() || !image.reflective.is_empty()).then_some(image))
}
