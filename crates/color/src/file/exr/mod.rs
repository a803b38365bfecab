//! Spectral pictures in OpenEXR.
//!
//! The layout of Fichet, Pacanowski and Wilkie, "An OpenEXR Layout for Spectral Images", Journal of
//! Computer Graphics Techniques 10(3), 2021, version 1.0: a channel for each wavelength, its name being
//! the kind of value and the wavelength with a decimal comma, since a point would begin a group.
//!
//! * `S0.550,000000nm`: light. S1 to S3, its polarisation, are left out with a remark.
//! * `T.550,000000nm`: the fraction of light that a surface gives back, or a medium lets through.
//! * `T.380,000000nm.550,000000nm`: re-radiation, from an excitation to an emission; its diagonal is in `T`.
//! * `R`, `G`, `B`: a preview for programs that know no spectra.
//!
//! Other units of wavelength and frequency are read, 16-bit and 32-bit channels too. Written are 32-bit floats,
//! as ZIP.
//! The attribute `emissiveUnits` is a text; by custom `W.m^-2.sr^-1` is said of radiance per nm.
//!
//! Beneath lie [`ExrFile`] and [`write_planes`], which read and write any named planes. Both need the feature `exr`:
//! without it they are there, and each call ends in a [`FeatureOff`](crate::FeatureOff).
//!
#![cfg_attr(feature = "exr", doc = "```")]
#![cfg_attr(not(feature = "exr"), doc = "```ignore")]
//! use std::io::Cursor;
//!
//! use glanz_color::exr::{
//!     Band, MAX_PICTURE_BYTES, SpectralImage, read_spectral_exr, write_spectral_exr,
//! };
//!
//! // Two pixels of light at three wavelengths.
//! let band = |nm: f64| Band { nm, values: vec![0.5, 2.0] };
//! let emissive = [450.0, 550.0, 650.0].map(band).to_vec();
//! let image = SpectralImage { width: 2, height: 1, emissive, ..SpectralImage::default() };
//! let mut file = Cursor::new(Vec::new());
//! write_spectral_exr(&mut file, image.clone())?;
//! let read = read_spectral_exr(file.get_ref(), "two.exr", MAX_PICTURE_BYTES)?;
//! assert_eq!(read.emissive, image.emissive);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod channels;
#[cfg(feature = "exr")]
mod dwa;
#[cfg(feature = "exr")]
mod file;
#[cfg(not(feature = "exr"))]
mod off;
mod part;
mod pixels;
#[cfg(feature = "exr")]
mod planes;
mod read;
#[cfg(test)]
#[cfg(feature = "exr")]
pub(crate) mod tests;
mod write;

#[cfg(feature = "exr")]
pub use file::ExrFile;
#[cfg(not(feature = "exr"))]
pub use off::{ExrFile, write_planes};
pub use part::{ExrChannel, ExrPart, ExrReadError};
#[cfg(feature = "exr")]
pub use planes::write_planes;
pub use read::{MAX_PICTURE_BYTES, read_spectral_exr};
pub use write::{ExrWriteError, write_spectral_exr};

use crate::FeatureOff;

const OFF: FeatureOff = FeatureOff { format: "OpenEXR", feature: "exr" };

/// That OpenEXR files can be read and written.
///
/// # Errors
///
/// [`FeatureOff`] where the crate was built without its feature `exr`.
pub fn check_feature() -> Result<(), FeatureOff> {
    if cfg!(feature = "exr") { Ok(()) } else { Err(OFF) }
}

/// The value of an attribute of an OpenEXR file.
#[derive(Clone, Debug, PartialEq)]
pub enum Attribute {
    /// Text.
    Text(String),
    /// A number.
    Number(f32),
}

/// One wavelength of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// The wavelength in nm.
    pub nm: f64,
    /// The value of each pixel, by rows from the top.
    pub values: Vec<f32>,
}

/// One pair of wavelengths of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ReradiationBand {
    /// The wavelength of excitation in nm.
    pub in_nm: f64,
    /// The wavelength of emission in nm.
    pub out_nm: f64,
    /// The value of each pixel, by rows from the top.
    pub values: Vec<f32>,
}

/// A picture of spectra. Each of its parts may be empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpectralImage {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Light, by ascending wavelength.
    pub emissive: Vec<Band>,
    /// Reflectance or transmittance, by ascending wavelength; with `reradiation` its diagonal.
    pub reflective: Vec<Band>,
    /// Re-radiation to other wavelengths, ascending by excitation, then by emission.
    pub reradiation: Vec<ReradiationBand>,
    /// The preview: linear, sRGB primaries.
    pub rgb: Option<[Vec<f32>; 3]>,
    /// The unit of `emissive`; empty if the file does not say.
    pub emissive_units: String,
    /// The exposure with which the preview was made: RGB = 2^−EV times what the spectra give. 0 if the
    /// file does not say.
    pub exposure_ev: f32,
    /// Further attributes that are text: names and values.
    pub texts: Vec<(String, String)>,
    /// What the reader left out, in words.
    pub notes: Vec<String>,
}
