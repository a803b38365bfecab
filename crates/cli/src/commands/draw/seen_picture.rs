//! `glanz render photo.exr --observer age:70`: a picture that an eye looks at.

use glanz_eye::{Eye, EyeError, Viewer};
use glanz_picture::output::{Format, Metadata, PictureData};
use glanz_picture::{develop, develop16};
use glanz_render::ShotError;
use glanz_scene::RenderSettings;

use super::render::RenderArgs;
use crate::args::{BitDepth, Target};
use crate::encode;
use crate::input::picture::PictureInput;
use crate::print;
use crate::print::failure::Failure;

impl RenderArgs {
    /// Whether the input is a picture, not a scene.
    pub(super) fn is_picture(&self) -> bool {
        PictureInput::is_named(&self.input.input)
    }

    /// Shows a picture as an eye sees it.
    pub(super) fn seen_picture(&self) -> Result<(), Failure> {
        let viewer = self.viewer()?;
        let path = &self.input.input;
        let target = self.target.resolve(path, "_seen.png")?;
        let format = encode::format(&target)?;
        if format == Format::Exr {
            self.check_light()?;
        }
        let picture = PictureInput::read(path, self.input.memory)?;
        picture.notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
        let frame = picture.seen_by(&viewer)?.screen().map_err(Failure::from)?;
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
