//! Reading.

use super::channels::ChannelKind;
use super::{Attribute, Band, ExrChannel, ExrFile, ExrPart, ExrReadError, ReradiationBand, SpectralImage};
use crate::file::read::error::{Place, ReadError};

/// How many bytes of pixels a picture may have where the caller sets no other limit: those of 3840 × 2160
/// pixels with 120 wavelengths.
pub const MAX_PICTURE_BYTES: u64 = 4 << 30;
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
    let failed = |error: ExrReadError| {
        let (expected, found) = match error {
            ExrReadError::Malformed { expected, found } => (expected, found),
            ExrReadError::Unsupported { expected, found } => (expected.to_owned(), found),
            ExrReadError::FeatureOff(off) => return ReadError::feature_off(file, off),
        };
        ReadError::malformed(file, Place::File, expected, found)
    };
    let opened = ExrFile::open(bytes).map_err(failed)?;
    check_size(opened.parts(), file, max_bytes)?;
    let part = opened.parts()[0].clone();
    let all: Vec<usize> = (0..part.channels.len()).collect();
    let planes = opened.planes(0, &all).map_err(failed)?;
    let mut image = SpectralImage { width: part.width, height: part.height, ..SpectralImage::default() };
    image.take_planes(part.channels, planes);
    image.sort(file)?;
    for (key, value) in part.attributes {
        attribute(&mut image, key, value);
    }
    Ok(image)
}

/// Refuses more pixels than are allowed.
fn check_size(parts: &[ExrPart], file: &str, limit: u64) -> Result<(), ReadError> {
    let bytes = |part: &ExrPart| {
        let pixels = (part.width as u64).saturating_mul(part.height as u64);
        pixels.saturating_mul(part.channels.len() as u64 * 4)
    };
    let found = parts.iter().map(bytes).fold(0, u64::saturating_add);
    if found <= limit {
        return Ok(());
    }
    let (file, place, unit) = (file.to_owned(), Place::File, "bytes of pixels");
    Err(ReadError::TooLarge { file, place, limit, unit, found })
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
fn attribute(image: &mut SpectralImage, key: String, value: Attribute) {
    match (key.as_str(), value) {
        ("emissiveUnits", Attribute::Text(text)) => image.emissive_units = text,
        ("EV", Attribute::Number(ev)) if ev.is_finite() => image.exposure_ev = ev,
        ("EV", Attribute::Text(text)) => {
            let ev = text.trim().parse().ok().filter(|ev: &f32| ev.is_finite());
            image.exposure_ev = ev.unwrap_or(0.0);
        }
        ("spectralLayoutVersion", Attribute::Text(version)) if version != "1.0" => {
            image.notes.push(format!("layout version '{version}' read as 1.0"));
        }
        ("spectralLayoutVersion", _) => {}
        (_, Attribute::Text(text)) if image.texts.len() < MOST_TEXTS.0 => {
            image.texts.push((key, text.chars().take(MOST_TEXTS.1).collect()));
        }
        _ => {}
    }
}

impl SpectralImage {
    /// Takes the planes of all channels, those that are spectral or the preview.
    fn take_planes(&mut self, channels: Vec<ExrChannel>, planes: Vec<Vec<f32>>) {
        let mut rgb = [None, None, None];
        for (ExrChannel { name, .. }, values) in channels.into_iter().zip(planes) {
            match ChannelKind::of(&name) {
                ChannelKind::Emissive(0, nm) => self.emissive.push(Band { nm, values }),
                ChannelKind::Reflective(nm) => self.reflective.push(Band { nm, values }),
                ChannelKind::Bispectral(in_nm, out_nm) => {
                    self.reradiation.push(ReradiationBand { in_nm, out_nm, values });
                }
                ChannelKind::Rgb(index) => rgb[index] = Some(values),
                kind => left_out(&mut self.notes, kind, &name),
            }
        }
        self.rgb = match rgb {
            [Some(r), Some(g), Some(b)] => Some([r, g, b]),
            _ => None,
        };
    }

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
