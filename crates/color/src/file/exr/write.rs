//! Writing.

use std::io::{Seek, Write};

use thiserror::Error;

use super::{Attribute, SpectralImage, channels, write_planes};
use crate::FeatureOff;

/// The unit that is written where the picture tells none.
const RADIANCE: &str = "W.m^-2.sr^-1";

/// Why a picture could not be written.
#[derive(Debug, Error)]
pub enum ExrWriteError {
    /// A channel has not one value for each pixel.
    #[error("channel {channel}: expected {expected} values, one for each pixel, found {found}")]
    Size {
        /// The channel.
        channel: String,
        /// How many values there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// Something that no file can hold.
    #[error("expected {expected}, found {found}")]
    Content {
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// The crate was built without its feature `exr`.
    #[error(transparent)]
    FeatureOff(#[from] FeatureOff),
    /// The operating system refused.
    #[error("expected a writable file, found: {0}")]
    Stream(#[from] std::io::Error),
}

/// Writes a spectral picture, and takes it, so that its planes need not be copied.
///
/// The format goes back to fill in a table: for a stream write to a `Cursor<Vec<u8>>` first.
///
/// # Errors
///
/// [`ExrWriteError`]; nothing of use is written then.
pub fn write_spectral_exr(out: impl Write + Seek, image: SpectralImage) -> Result<(), ExrWriteError> {
    let size = (image.width, image.height);
    let mut attributes: Vec<(&str, Attribute)> = Vec::new();
    let texts = image.texts.clone();
    attributes.extend(texts.iter().map(|(key, value)| (key.as_str(), Attribute::Text(value.clone()))));
    attributes.push(("spectralLayoutVersion", Attribute::Text("1.0".to_owned())));
    attributes.push(("EV", Attribute::Number(image.exposure_ev)));
    if !image.emissive.is_empty() {
        let units = if image.emissive_units.is_empty() { RADIANCE } else { &image.emissive_units };
        attributes.push(("emissiveUnits", Attribute::Text(units.to_owned())));
    }
    write_planes(out, size, planes(image), &attributes)
}

/// All channels, with their names.
fn planes(image: SpectralImage) -> impl Iterator<Item = (String, Vec<f32>)> {
    let rgb = image.rgb.into_iter().flat_map(|rgb| ["R", "G", "B"].map(str::to_owned).into_iter().zip(rgb));
    let light = image.emissive.into_iter().map(|band| (channels::emissive(band.nm), band.values));
    let reflective = image.reflective.into_iter().map(|band| (channels::reflective(band.nm), band.values));
    let pairs = image.reradiation.into_iter();
    let pairs = pairs.map(|band| (channels::bispectral(band.in_nm, band.out_nm), band.values));
    rgb.chain(light).chain(reflective).chain(pairs)
}
