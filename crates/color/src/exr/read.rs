//! Reading.

use std::io::Cursor;

use ::exr::image::FlatSamples;
use ::exr::meta::MetaData;
use ::exr::meta::attribute::AttributeValue;
use ::exr::prelude::{ReadChannels, ReadLayers};

use super::channels::ChannelKind;
use super::{Band, ReradiationBand, SpectralImage};
use crate::read::{Place, ReadError};

/// How many bytes of pixels a picture may have where the caller sets no other limit: those of 3840 × 2160
/// pixels with 120 wavelengths.
pub const MAX_PICTURE_BYTES: u64 = 4 << 30;
/// No compression of OpenEXR makes a file smaller than by about this factor: deflate reaches 1032. A file
/// that claims more pixels does not hold them.
const MOST_COMPRESSION: u64 = 2048;
/// The most wavelengths of excitation, and of emission.
const MOST_BANDS: usize = 1024;
/// The most text attributes that are kept, and the most characters of each.
const MOST_TEXTS: (usize, usize) = (64, 65_536);

/// Reads a spectral picture. `file` is its name for messages; pixels may take at most `max_bytes`, see
/// [`MAX_PICTURE_BYTES`].
///
/// # Errors
///
/// [`ReadError`] where the bytes are no OpenEXR file, hold no spectral channel, or more pixels than allowed.
pub fn read_spectral_exr(bytes: &[u8], file: &str, max_bytes: u64) -> Result<SpectralImage, ReadError> {
    let malformed = |error: ::exr::error::Error| {
        ReadError::malformed(file, Place::File, "an OpenEXR picture with flat pixels", error.to_string())
    };
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(malformed)?;
    check_size(&meta, bytes.len() as u64, file, max_bytes)?;
    let reader = ::exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
    let reader = reader.first_valid_layer().all_attributes().non_parallel();
    let picture = reader.from_buffered(Cursor::new(bytes)).map_err(malformed)?;
    let layer = picture.layer_data;
    let mut image = SpectralImage { width: layer.size.0, height: layer.size.1, ..SpectralImage::default() };
    let mut rgb = [None, None, None];
    for channel in layer.channel_data.list {
        let name = channel.name.to_string();
        let values = floats(channel.sample_data);
        if values.len() != image.width * image.height {
            let (expected, found) = ("a value for each pixel", values.len().to_string());
            return Err(ReadError::malformed(file, Place::Channel(name), expected, found));
        }
        match ChannelKind::of(&name) {
            ChannelKind::Emissive(0, nm) => image.emissive.push(Band { nm, values }),
            ChannelKind::Reflective(nm) => image.reflective.push(Band { nm, values }),
            ChannelKind::Bispectral(in_nm, out_nm) => {
                image.reradiation.push(ReradiationBand { in_nm, out_nm, values });
            }
            ChannelKind::Rgb(index) => rgb[index] = Some(values),
            kind => left_out(&mut image.notes, kind, &name),
        }
    }
    image.rgb = match rgb {
        [Some(r), Some(g), Some(b)] => Some([r, g, b]),
        _ => None,
    };
    image.sort(file)?;
    for (key, value) in layer.attributes.other {
        attribute(&mut image, key.to_string(), value);
    }
    Ok(image)
}

/// Refuses more pixels than are allowed, or than the file can hold.
fn check_size(meta: &MetaData, bytes: u64, file: &str, max_bytes: u64) -> Result<(), ReadError> {
    let mut total = 0u64;
    for header in &meta.headers {
        if header.deep {
            return Err(ReadError::malformed(file, Place::File, "flat pixels", "deep data"));
        }
        let (width, height) = (header.layer_size.0 as u64, header.layer_size.1 as u64);
        let pixel = header.channels.list.len() as u64 * 4;
        total = total.saturating_add(width.saturating_mul(height).saturating_mul(pixel));
    }
    let limit = max_bytes.min(bytes.saturating_mul(MOST_COMPRESSION));
    if total <= limit {
        return Ok(());
    }
    let (file, place, unit) = (file.to_owned(), Place::File, "bytes of pixels for its size");
    Err(ReadError::TooLarge { file, place, limit, unit, found: total })
}

fn floats(samples: FlatSamples) -> Vec<f32> {
    match samples {
        FlatSamples::F32(values) => values,
        FlatSamples::F16(values) => values.into_iter().map(f32::from).collect(),
        FlatSamples::U32(values) => values.into_iter().map(|value| value as f32).collect(),
    }
}

/// Says which channel was left out.
fn left_out(notes: &mut Vec<String>, kind: ChannelKind, name: &str) {
    let text = match kind {
        ChannelKind::Emissive(..) => "polarisation (S1 to S3) left out".to_owned(),
        _ => format!("channel '{name}' left out: it is not spectral"),
    };
    if notes.len() < 16 && !notes.contains(&text) {
        notes.push(text);
    }
}

/// Takes an attribute of the layout, or keeps it if it is text.
fn attribute(image: &mut SpectralImage, key: String, value: AttributeValue) {
    match (key.as_str(), value) {
        ("emissiveUnits", AttributeValue::Text(text)) => image.emissive_units = text.to_string(),
        ("EV", AttributeValue::F32(ev)) if ev.is_finite() => image.exposure_ev = ev,
        ("EV", AttributeValue::Text(text)) => {
            let ev = text.to_string().trim().parse().ok().filter(|ev: &f32| ev.is_finite());
            image.exposure_ev = ev.unwrap_or(0.0);
        }
        ("spectralLayoutVersion", AttributeValue::Text(text)) => {
            let version = text.to_string();
            if version != "1.0" {
                image.notes.push(format!("layout version '{version}' read as 1.0"));
            }
        }
        (_, AttributeValue::Text(text)) if image.texts.len() < MOST_TEXTS.0 => {
            image.texts.push((key, text.to_string().chars().take(MOST_TEXTS.1).collect()));
        }
        _ => {}
    }
}

impl SpectralImage {
    /// Brings wavelengths into order; each must be there once.
    fn sort(&mut self, file: &str) -> Result<(), ReadError> {
        for bands in [&mut self.emissive, &mut self.reflective] {
            bands.sort_by(|a, b| a.nm.total_cmp(&b.nm));
            once(bands.windows(2).find(|pair| pair[0].nm == pair[1].nm).map(|pair| pair[0].nm), file)?;
            count(bands.len(), file)?;
        }
        let key = |band: &ReradiationBand| (band.in_nm, band.out_nm);
        let bands = &mut self.reradiation;
        bands.sort_by(|a, b| a.in_nm.total_cmp(&b.in_nm).then(a.out_nm.total_cmp(&b.out_nm)));
        once(bands.windows(2).find(|pair| key(&pair[0]) == key(&pair[1])).map(|pair| pair[0].in_nm), file)?;
        let (out_nm, in_nm) = self.axes();
        count(out_nm.len(), file)?;
        count(in_nm.len(), file)?;
        if self.emissive.is_empty() && self.reflective.is_empty() && self.reradiation.is_empty() {
            let expected = "channels such as 'S0.550,000000nm' or 'T.550,000000nm'";
            return Err(ReadError::malformed(file, Place::File, expected, "none"));
        }
        Ok(())
    }
}

fn once(twice: Option<f64>, file: &str) -> Result<(), ReadError> {
    match twice {
        None => Ok(()),
        Some(nm) => {
            let found = format!("two channels of {nm} nm");
            Err(ReadError::malformed(file, Place::File, "each wavelength once", found))
        }
    }
}

fn count(found: usize, file: &str) -> Result<(), ReadError> {
    if found <= MOST_BANDS {
        return Ok(());
    }
    let (file, place, limit, found) = (file.to_owned(), Place::File, MOST_BANDS as u64, found as u64);
    Err(ReadError::TooLarge { file, place, limit, unit: "wavelengths", found })
}
