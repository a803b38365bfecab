//! Which file format a name asks for.

use std::path::Path;

use glanz_color::FeatureOff;

use super::OutputError;

/// A picture file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Portable Network Graphics: 8 or 16 bit sRGB codes, lossless.
    Png,
    /// OpenEXR: linear `f32` channels, depth, normals, object numbers. Needs the feature `exr`.
    Exr,
    /// Graphics Interchange Format: animation in 256 colours per frame. Needs the feature `gif`.
    Gif,
    /// Animated PNG: animation, lossless.
    Apng,
}

impl Format {
    /// All formats with the extension of their names.
    pub const ALL: [(Self, &'static str); 4] =
        [(Self::Png, "png"), (Self::Exr, "exr"), (Self::Gif, "gif"), (Self::Apng, "apng")];

    /// The format that the name's extension stands for, in capitals or not.
    pub fn from_path(path: impl AsRef<Path>) -> Result<Self, OutputError> {
        let path = path.as_ref();
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        Self::ALL
            .iter()
            .find(|(_, known)| extension.eq_ignore_ascii_case(known))
            .map(|(format, _)| *format)
            .ok_or_else(|| OutputError::UnknownExtension { path: path.to_owned() })
    }

    /// The format's name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Exr => "OpenEXR",
            Self::Gif => "GIF",
            Self::Apng => "APNG",
        }
    }

    /// That files of this format can be written.
    ///
    /// # Errors
    /// If the crate was built without the feature that it needs: `exr` or `gif`.
    pub fn check_feature(self) -> Result<(), FeatureOff> {
        match self {
            Self::Exr => glanz_color::exr::check_feature(),
            Self::Gif if cfg!(not(feature = "gif")) => {
                Err(FeatureOff { format: self.name(), feature: "gif" })
            }
            Self::Png | Self::Gif | Self::Apng => Ok(()),
        }
    }

    /// Whether one file holds many frames.
    pub fn is_animation(self) -> bool {
        matches!(self, Self::Gif | Self::Apng)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_tells_the_format() {
        for (format, extension) in Format::ALL {
            assert_eq!(Format::from_path(format!("a.b/kite.{extension}")).unwrap(), format);
            assert_eq!(
                Format::from_path(extension.to_uppercase() + "." + &extension.to_uppercase()).unwrap(),
                format
            );
        }
    }

    #[test]
    fn another_extension_is_an_error_that_names_the_known_ones() {
        for name in ["kite.jpg", "kite", "png", ".png", "kite.png.", ""] {
            let message = Format::from_path(name).unwrap_err().to_string();
            assert_eq!(message, format!("{name}: the name must end in .png, .exr, .gif or .apng"));
        }
    }
}
