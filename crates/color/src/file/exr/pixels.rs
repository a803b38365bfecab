//! Pixels of spectral pictures, from and to spectra.

use super::{Band, ReradiationBand, SpectralImage};
use crate::file::read::reradiation::NamedReradiation;
use crate::file::read::{NamedSpectrum, Quantity};
use crate::spectra::{SAMPLES, STEP_NM, Spectrum, lambda_nm};
use crate::surfaces::reradiation::Reradiation;

impl SpectralImage {
    /// A picture of light on the grid: a spectrum for each pixel, by rows from the top.
    ///
    /// # Panics
    ///
    /// If there are not as many spectra as pixels.
    pub fn of_light(width: usize, height: usize, spectra: &[Spectrum]) -> Self {
        let emissive = bands(width * height, spectra);
        Self { width, height, emissive, ..Self::default() }
    }

    /// A picture of reflectance on the grid: a spectrum for each pixel, by rows from the top.
    ///
    /// # Panics
    ///
    /// If there are not as many spectra as pixels.
    pub fn of_reflectance(width: usize, height: usize, spectra: &[Spectrum]) -> Self {
        let reflective = bands(width * height, spectra);
        Self { width, height, reflective, ..Self::default() }
    }

    /// A picture of re-radiation on the grid: a matrix for each pixel, by rows from the top. Pairs of
    /// wavelengths that are 0 in all pixels are left out: programs built on OpenImageIO open no file of
    /// more than 1024 channels, and a material that excites and emits everywhere has 4753.
    ///
    /// # Panics
    ///
    /// If there are not as many matrices as pixels.
    pub fn of_reradiation(width: usize, height: usize, matrices: &[Reradiation]) -> Self {
        let diagonals: Vec<Spectrum> = matrices.iter().map(Reradiation::reflectance).collect();
        let mut image = Self::of_reflectance(width, height, &diagonals);
        for (input, out) in (0..SAMPLES).flat_map(|input| (0..SAMPLES).map(move |out| (input, out))) {
            let values: Vec<f32> = matrices.iter().map(|matrix| matrix.get(out, input) as f32).collect();
            if out != input && values.iter().any(|value| *value != 0.0) {
                let (in_nm, out_nm) = (lambda_nm(input), lambda_nm(out));
                image.reradiation.push(ReradiationBand { in_nm, out_nm, values });
            }
        }
        image
    }

    /// The light of a pixel; none if the picture has no light or the pixel is outside.
    pub fn light_at(&self, x: usize, y: usize) -> Option<NamedSpectrum> {
        let unit = self.emissive_units.clone();
        Some(NamedSpectrum { quantity: Quantity::Light, unit, ..self.spectrum(&self.emissive, x, y)? })
    }

    /// The reflectance of a pixel, that is the diagonal of its re-radiation; none if the picture has none or
    /// the pixel is outside.
    pub fn reflectance_at(&self, x: usize, y: usize) -> Option<NamedSpectrum> {
        Some(NamedSpectrum { quantity: Quantity::Reflectance, ..self.spectrum(&self.reflective, x, y)? })
    }

    /// The re-radiation of a pixel, diagonal and all; pairs that the picture does not have are 0. None if
    /// the picture has no re-radiation or the pixel is outside. The width of a band is the step of
    /// emission, that of the grid where there is but one wavelength.
    pub fn reradiation_at(&self, x: usize, y: usize) -> Option<NamedReradiation> {
        let index = self.index(x, y)?;
        if self.reradiation.is_empty() {
            return None;
        }
        let (out_nm, in_nm) = self.axes();
        let mut values = vec![0.0; out_nm.len() * in_nm.len()];
        let diagonal = self.reflective.iter().map(|band| (band.nm, band.nm, &band.values));
        let pairs = self.reradiation.iter().map(|band| (band.in_nm, band.out_nm, &band.values));
        for (input, out, pixels) in diagonal.chain(pairs) {
            let row = out_nm.partition_point(|nm| *nm < out);
            let column = in_nm.partition_point(|nm| *nm < input);
            values[row * in_nm.len() + column] = f64::from(*pixels.get(index)?);
        }
        let steps = out_nm.len().saturating_sub(1);
        let band_nm = match steps {
            0 => STEP_NM,
            steps => (out_nm[steps] - out_nm[0]) / steps as f64,
        };
        let name = format!("pixel {x}, {y}");
        Some(NamedReradiation { name, out_nm, in_nm, values, band_nm, notes: Vec::new() })
    }

    /// All wavelengths of emission and of excitation, ascending; those of reflectance are both.
    pub(super) fn axes(&self) -> (Vec<f64>, Vec<f64>) {
        let axis = |of: fn(&ReradiationBand) -> f64| {
            let mut nm: Vec<f64> = self.reflective.iter().map(|band| band.nm).collect();
            nm.extend(self.reradiation.iter().map(of));
            nm.sort_by(f64::total_cmp);
            nm.dedup();
            nm
        };
        (axis(|band| band.out_nm), axis(|band| band.in_nm))
    }

    fn index(&self, x: usize, y: usize) -> Option<usize> {
        (x < self.width && y < self.height).then_some(y * self.width + x)
    }

    fn spectrum(&self, bands: &[Band], x: usize, y: usize) -> Option<NamedSpectrum> {
        let index = self.index(x, y)?;
        let values: Option<Vec<f64>> =
            bands.iter().map(|band| band.values.get(index).copied().map(f64::from)).collect();
        let nm: Vec<f64> = bands.iter().map(|band| band.nm).collect();
        let name = format!("pixel {x}, {y}");
        (!nm.is_empty()).then_some(NamedSpectrum { name, nm, values: values?, ..NamedSpectrum::default() })
    }
}

/// The planes of spectra on the grid.
fn bands(pixels: usize, spectra: &[Spectrum]) -> Vec<Band> {
    assert_eq!(pixels, spectra.len(), "one spectrum for each pixel");
    let plane = |index: usize| spectra.iter().map(|spectrum| spectrum[index] as f32).collect();
    (0..SAMPLES).map(|index| Band { nm: lambda_nm(index), values: plane(index) }).collect()
}
