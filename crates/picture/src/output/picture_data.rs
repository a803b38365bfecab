//! A drawn picture, as a file keeps it.

use std::io::{Cursor, Seek, Write};
use std::path::Path;

use glanz_color::exr::{SpectralImage, write_spectral_exr};

use super::{
    Animation, Effort, Format, Metadata, OutputError, write_apng, write_atomically, write_exr, write_gif,
    write_png8, write_png16,
};
use crate::Frame;

/// How long a picture alone is shown in a format that moves.
const STILL_S: f64 = 1.0;

/// What is kept of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureKind {
    /// 8-bit codes.
    Codes8,
    /// 16-bit codes.
    Codes16,
    /// Linear light, with depth, normals and object numbers.
    Light,
    /// The spectrum of each pixel.
    Spectrum,
}

impl PictureKind {
    /// What a file of this format keeps where nothing else is asked for: linear light in OpenEXR, else 8-bit codes.
    pub fn of(format: Format) -> Self {
        match format {
            Format::Exr => Self::Light,
            Format::Png | Format::Gif | Format::Apng => Self::Codes8,
        }
    }
}

/// A drawn picture, as a file keeps it.
///
/// ```
/// use glanz_picture::output::{Format, Metadata, PictureData};
///
/// let white = PictureData::Codes8 { width: 2, height: 1, rgba: vec![255; 8] };
/// let bytes = white.to_bytes(Format::Png, &Metadata::default())?;
/// assert!(bytes.starts_with(b"\x89PNG"));
/// # Ok::<(), glanz_picture::output::OutputError>(())
/// ```
#[derive(Clone, Debug)]
pub enum PictureData {
    /// 8-bit sRGB codes.
    Codes8 {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// `4·width·height` codes, straight RGBA, rows from the top.
        rgba: Vec<u8>,
    },
    /// 16-bit sRGB codes.
    Codes16 {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// `4·width·height` codes, straight RGBA, rows from the top.
        rgba: Vec<u16>,
    },
    /// Linear light, as a screen shows it and as the observer sees it.
    Light {
        /// Linear sRGB, with depth, normals and object numbers.
        screen: Frame,
        /// The observer's channels with their names; none in mode RGB.
        channels: Vec<(String, Vec<f32>)>,
    },
    /// The spectrum of each pixel.
    Spectrum(SpectralImage),
}

impl PictureData {
    /// Writes the picture. 16-bit codes are for PNG, light and spectra for OpenEXR.
    ///
    /// # Errors
    /// If the stream takes no more, or the format cannot hold this picture.
    pub fn write(
        self,
        out: impl Write + Seek,
        format: Format,
        metadata: &Metadata,
    ) -> Result<(), OutputError> {
        match (self, format) {
            (Self::Codes8 { width, height, rgba }, Format::Gif) => {
                write_gif(out, &still(width, height), [Ok(rgba)], metadata)
            }
            (Self::Codes8 { width, height, rgba }, Format::Apng) => {
                write_apng(out, &still(width, height), [Ok(rgba)], metadata)
            }
            (Self::Codes8 { width, height, rgba }, Format::Png) => {
                write_png8(out, (width, height), &rgba, Effort::Fast, metadata)
            }
            (Self::Codes16 { width, height, rgba }, Format::Png) => {
                write_png16(out, (width, height), &rgba, Effort::Fast, metadata)
            }
            (Self::Light { screen, channels }, Format::Exr) => write_exr(out, screen, channels, metadata),
            (Self::Spectrum(image), Format::Exr) => write_spectrum(out, image, metadata),
            (picture, format) => Err(OutputError::Encode {
                format: format.name(),
                message: format!("it holds {}", picture.content_name()),
            }),
        }
    }

    /// The bytes of the picture's file.
    ///
    /// # Errors
    /// If the format cannot hold this picture.
    pub fn to_bytes(self, format: Format, metadata: &Metadata) -> Result<Vec<u8>, OutputError> {
        let mut out = Cursor::new(Vec::new());
        self.write(&mut out, format, metadata)?;
        Ok(out.into_inner())
    }

    /// Writes the picture into a file, in the format that its name ends in. The file is old or new, never half.
    ///
    /// # Errors
    /// If the name has no known ending, the file cannot be written, or its format cannot hold this picture.
    pub fn save(self, path: impl AsRef<Path>, metadata: &Metadata) -> Result<(), OutputError> {
        let format = Format::from_path(&path)?;
        format.check_feature()?;
        write_atomically(path, |out| self.write(out, format, metadata))
    }

    fn content_name(&self) -> &'static str {
        match self {
            Self::Codes8 { .. } => "8-bit codes",
            Self::Codes16 { .. } => "16-bit codes",
            Self::Light { .. } => "linear light",
            Self::Spectrum(_) => "spectra",
        }
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

fn still(width: usize, height: usize) -> Animation {
    Animation { width, height, frames: 1, frame_s: STILL_S }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_format_refuses_what_it_cannot_hold() {
        let codes = PictureData::Codes8 { width: 1, height: 1, rgba: vec![0; 4] };
        let error = codes.to_bytes(Format::Exr, &Metadata::default()).unwrap_err();
        assert_eq!(error.to_string(), "this picture cannot be written as OpenEXR: it holds 8-bit codes");
    }

    #[test]
    fn codes_go_into_every_format_of_codes() {
        for format in [Format::Png, Format::Gif, Format::Apng] {
            assert_eq!(PictureKind::of(format), PictureKind::Codes8);
            let codes = PictureData::Codes8 { width: 1, height: 1, rgba: vec![255; 4] };
            let bytes = codes.to_bytes(format, &Metadata::default());
            match format.check_feature() {
                Ok(()) => assert!(!bytes.unwrap().is_empty()),
                Err(off) => assert_eq!(bytes.unwrap_err().to_string(), off.to_string()),
            }
        }
    }
}
