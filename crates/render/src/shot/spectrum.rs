//! The spectrum of each pixel.

use glanz_color::exr::{Band, SpectralImage};
use glanz_color::photometry::PHOTOPIC_LM_PER_W;
use glanz_color::{Spectrum, lambda_nm, rgb_spectra};
use glanz_picture::Frame;
use glanz_scene::{Background, ColorMode};

use super::{Shot, ShotError, Step};
use crate::draw_observed;
use crate::prepare::Observation;
use crate::view::{Aovs, DrawOptions};

/// The part of the work that drawing all wavelengths is, beside three channels to look at.
const SPECTRUM_PART: f64 = 33.0 / 34.0;

impl Shot {
    /// The spectrum of each pixel, drawn three wavelengths at a time, with a picture to look at.
    ///
    /// # Errors
    /// If the colour mode has no spectra, or the picture does not show light.
    pub fn spectral_image(&mut self, step: Step) -> Result<SpectralImage, ShotError> {
        let mode = self.prepared.observation().mode();
        if !matches!(mode, ColorMode::Spectral | ColorMode::Reference) || !self.sight.draw.show.is_light() {
            return Err(ShotError::NoSpectra { mode });
        }
        // The reference draws all wavelengths for the preview too.
        let part = if mode == ColorMode::Reference { 0.5 } else { SPECTRUM_PART };
        let spectra = self.spectral_frame(&mut |done| step(part * done))?;
        let preview = self.frame_in_steps(Aovs::default(), &mut |done| step(part + (1.0 - part) * done))?;
        let (width, height) = (spectra.width, spectra.height);
        let unit = if self.prepared.is_photometric() { "W.m^-2.sr^-1" } else { "relative" };
        Ok(SpectralImage {
            width,
            height,
            emissive: self.bands(spectra),
            rgb: Some(self.on_screen(preview)?.rgb),
            emissive_units: unit.to_owned(),
            ..SpectralImage::default()
        })
    }

    /// A channel for each wavelength, over nothing.
    fn spectral_frame(&mut self, step: Step) -> Result<Frame, ShotError> {
        let background = match self.sight.draw.background {
            Background::Environment => Background::Environment,
            _ => Background::Transparent,
        };
        let options = DrawOptions { background, ..self.sight.draw };
        let prepared = self.prepared.observed_by(Observation::spectrum())?;
        Ok(draw_observed(&mut *self.backend, &prepared, &self.sight.view, &options, step)?)
    }

    /// The wavelengths of a frame over the background, in the unit of the file.
    fn bands(&self, frame: Frame) -> Vec<Band> {
        let unit = if self.prepared.is_photometric() { 1.0 / PHOTOPIC_LM_PER_W } else { 1.0 } as f32;
        let behind = match self.sight.background {
            Background::Color(color) => rgb_spectra::spectrum_of_light(color),
            Background::Transparent | Background::Environment => Spectrum::ZERO,
        };
        let alpha = &frame.alpha;
        let band = |(i, mut values): (usize, Vec<f32>)| {
            let behind = behind[i] as f32;
            values.iter_mut().zip(alpha).for_each(|(v, a)| *v = (*v + behind * (1.0 - a)) * unit);
            Band { nm: lambda_nm(i), values }
        };
        frame.rgb.into_iter().chain(frame.more).enumerate().map(band).collect()
    }
}
