//! `glanz render photo.exr --observer age:70`: a picture that an eye looks at.

use std::path::Path;

use glanz_color::exr::{MAX_PICTURE_BYTES, SpectralImage, read_spectral_exr};
use glanz_eye::{Eye, EyeError, Viewer};
use glanz_picture::compare::{Scale, decode_picture};
use glanz_picture::output::{Format, Metadata, PictureData};
use glanz_picture::{Frame, develop, develop16};
use glanz_render::{PictureLight, ShotError, see_picture};
use glanz_scene::RenderSettings;

use super::render::RenderArgs;
use crate::args::{BitDepth, Target};
use crate::encode;
use crate::print;
use crate::print::failure::{Failure, Report};

/// The endings of pictures.
const ENDINGS: [&str; 2] = ["exr", "png"];

impl RenderArgs {
    /// Whether the input is a picture, not a scene.
    pub(super) fn is_picture(&self) -> bool {
        let ending = self.input.input.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
    }

    /// Shows a picture as an eye sees it.
    pub(super) fn seen_picture(&self) -> Result<(), Failure> {
        let viewer = self.viewer()?;
        let path = &self.input.input;
        let target = self.target.resolve(path, "_seen.png")?;
        let format = encode::format(&target)?;
        let bytes = std::fs::read(path).map_err(|error| Failure::from(Report::new(error).file(path)))?;
        let frame = look(&bytes, path, &viewer)?;
        let settings = self.develop.resolve(&RenderSettings::default())?;
        let (width, height) = (frame.width, frame.height);
        let picture = match (format, self.bit_depth) {
            (Format::Exr, _) => PictureData::Light { screen: frame, channels: Vec::new() },
            (Format::Png, BitDepth::Sixteen) => {
                let rgba = develop16(&frame, &settings).map_err(ShotError::from)?;
                PictureData::Codes16 { width, height, rgba }
            }
            _ => {
                let rgba = develop(&frame, &settings).map_err(ShotError::from)?;
                PictureData::Codes8 { width, height, rgba }
            }
        };
        let entries = vec![("Observer".to_owned(), viewer.eye.to_string())];
        encode::deliver(picture, &target, &Metadata { entries, ..Metadata::default() })?;
        if let Target::File(path) = &target {
            print::note(format_args!("wrote {}", path.display()));
        }
        Ok(())
    }

    /// The eye that looks.
    fn viewer(&self) -> Result<Viewer, Failure> {
        let name = match &self.look.color.observer {
            Some(name) if Eye::is_named(name) => name,
            _ => {
                let message = "the input is a picture: name the eye that looks at it, such as --observer age:70 or deutan";
                return Err(Failure::Usage(message.to_owned()));
            }
        };
        let eye: Eye =
            name.parse().map_err(|error: EyeError| Failure::Usage(format!("--observer: {error}")))?;
        if let Some(remark) = eye.remark() {
            print::note(format_args!("note: {remark}"));
        }
        Ok(eye.into())
    }
}

/// The picture as the eye sees it, in linear sRGB.
fn look(bytes: &[u8], path: &Path, viewer: &Viewer) -> Result<Frame, Failure> {
    let wrong = |error: &dyn std::fmt::Display| Failure::from(Report::new(error).file(path));
    let name = path.display().to_string();
    if let Some(image) = spectra(bytes, &name) {
        let seen = see_picture(PictureLight::Spectra(&image), viewer);
        return seen.map(|(frame, _)| frame).map_err(|error| wrong(&error));
    }
    let picture = decode_picture(bytes, &name).map_err(|error| wrong(&error))?;
    picture.notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
    let kind = if picture.scale == Scale::Codes { "codes" } else { "linear light" };
    print::note(format_args!(
        "note: the picture has no spectra: its {kind} stand for the smooth ones of Mallett and Yuksel (2019) under D65"
    ));
    let light = PictureLight::Rgb { width: picture.width, rgb: &picture.rgb };
    see_picture(light, viewer).map(|(frame, _)| frame).map_err(|error| wrong(&error))
}

/// The spectra of a picture, if it has spectra of light.
fn spectra(bytes: &[u8], name: &str) -> Option<SpectralImage> {
    let image = read_spectral_exr(bytes, name, MAX_PICTURE_BYTES).ok()?;
    (!image.emissive.is_empty() || !image.reflective.is_empty()).then_some(image)
}
