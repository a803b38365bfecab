//! Writing.

use std::io::{Seek, Write};

use ::exr::error::Error as ExrError;
use ::exr::meta::attribute::{AttributeValue, Chromaticities, Text};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes,
    LineOrder, SmallVec, Vec2, WritableImage,
};
use thiserror::Error;

use super::{SpectralImage, channels};

/// The primaries and the white of sRGB, IEC 61966-2-1.
const SRGB: Chromaticities = Chromaticities {
    red: Vec2(0.64, 0.33),
    green: Vec2(0.30, 0.60),
    blue: Vec2(0.15, 0.06),
    white: Vec2(0.3127, 0.3290),
};

/// The unit that is written where the picture tells none.
const RADIANCE: &str = "W.m^-2.sr^-1";

/// Why a spectral picture could not be written.
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
    let (width, height) = (image.width, image.height);
    if width == 0 || height == 0 {
        let found = format!("{width}×{height}");
        return Err(ExrWriteError::Content { expected: "at least one pixel", found });
    }
    let attributes = attributes(&image)?;
    let mut list = SmallVec::new();
    for (name, values) in planes(image) {
        let (expected, found) = (width * height, values.len());
        if found != expected {
            return Err(ExrWriteError::Size { channel: name, expected, found });
        }
        list.push(AnyChannel::new(name.as_str(), FlatSamples::F32(values)));
    }
    let list = AnyChannels::sort(list);
    let twice = list.list.windows(2).find(|pair| pair[0].name == pair[1].name);
    if let Some(pair) = twice {
        let found = format!("channel {} twice", pair[0].name);
        return Err(ExrWriteError::Content { expected: "each wavelength once", found });
    }
    if list.list.is_empty() {
        return Err(ExrWriteError::Content { expected: "at least one channel", found: "none".to_owned() });
    }
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let mut picture = Image::from_layer(Layer::new(Vec2(width, height), attributes, encoding, list));
    picture.attributes.chromaticities = Some(SRGB);
    picture.write().non_parallel().to_buffered(out).map_err(failed)
}

/// All channels, with their names.
fn planes(image: SpectralImage) -> impl Iterator<Item = (String, Vec<f32>)> {
    let rgb = image.rgb.into_iter().flat_map(|rgb| ["R", "G", "B"].map(str::to_owned).into_iter().zip(rgb));
    let light = image.emissive.into_iter().map(|band| (channels::emissive(band.nm), band.values));
    let share = image.reflective.into_iter().map(|band| (channels::reflective(band.nm), band.values));
    let pairs = image.reradiation.into_iter();
    let pairs = pairs.map(|band| (channels::bispectral(band.in_nm, band.out_nm), band.values));
    rgb.chain(light).chain(share).chain(pairs)
}

/// The attributes of the layout, and the picture's own.
fn attributes(image: &SpectralImage) -> Result<LayerAttributes, ExrWriteError> {
    let mut attributes = LayerAttributes::default();
    let mut put = |key: &str, value: AttributeValue| -> Result<(), ExrWriteError> {
        attributes.other.insert(text(key)?, value);
        Ok(())
    };
    for (key, value) in &image.texts {
        put(key, AttributeValue::Text(text(value)?))?;
    }
    put("spectralLayoutVersion", AttributeValue::Text(text("1.0")?))?;
    put("EV", AttributeValue::F32(image.exposure_ev))?;
    if !image.emissive.is_empty() {
        let units = if image.emissive_units.is_empty() { RADIANCE } else { &image.emissive_units };
        put("emissiveUnits", AttributeValue::Text(text(units)?))?;
    }
    Ok(attributes)
}

fn text(text: &str) -> Result<Text, ExrWriteError> {
    Text::new_or_none(text)
        .ok_or_else(|| ExrWriteError::Content { expected: "Latin text", found: format!("'{text}'") })
}

fn failed(error: ExrError) -> ExrWriteError {
    match error {
        ExrError::Io(error) => ExrWriteError::Stream(error),
        other => {
            ExrWriteError::Content { expected: "a picture that OpenEXR can hold", found: other.to_string() }
        }
    }
}
