//! Pictures that an eye looks at in place of a scene.

use std::path::Path;

use glanz_color::Observer;
use glanz_color::exr::{MAX_PICTURE_BYTES, SpectralImage, read_spectral_exr};
use glanz_eye::Viewer;
use glanz_picture::Frame;
use glanz_picture::compare::{Scale, decode_picture};
use glanz_render::{PictureLight, SeenPicture, picture_frame, see_picture};

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

    /// Reads one.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let bytes = std::fs::read(path).map_err(|error| Failure::from(Report::new(error).file(path)))?;
        let name = path.display().to_string();
        if let Some(image) = spectra(&bytes, &name) {
            let light = OwnLight::Spectra(Box::new(image));
            return Ok(Self { path: path.to_owned(), light, notes: Vec::new() });
        }
        let picture =
            decode_picture(&bytes, &name).map_err(|error| Failure::from(Report::new(error).file(path)))?;
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

/// The spectra of a picture, if it has spectra of light.
fn spectra(bytes: &[u8], name: &str) -> Option<SpectralImage> {
    let image = read_spectral_exr(bytes, name, MAX_PICTURE_BYTES).ok()?;
    (!image.emissive.is_empty() || !image.reflective.is_empty()).then_some(image)
}
