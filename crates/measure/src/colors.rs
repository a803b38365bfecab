//! Colours of readings: from channels to XYZ, under a light, for an observer.

use glanz_color::models::{ColorModel, LinearSrgb, Xyz};
use glanz_color::{FineSpectrum, Observer, Outside, xyz_of_light, xyz_of_reflectance};

use crate::Channels;

impl Channels {
    /// X, Y and Z of radiance factors πf of these channels, Y = 1 for the perfect diffuser. None where the values are no
    /// numbers or fewer than channels, where the observer has no X, Y and Z or does not see the light.
    ///
    /// - Wavelengths are summed by 1 nm under the light; beyond the table its end values are held.
    /// - One channel is a grey: the same at all wavelengths.
    /// - RGB are taken as linear sRGB, and so, as X, Y and Z are, under D65 for the CIE 1931 observer, whatever light and
    ///   observer are: [`Channels::has_spectra`] tells.
    ///
    /// ```
    /// use glanz_color::{Observer, fine_light};
    /// use glanz_measure::Channels;
    ///
    /// let (a, observer) = (fine_light("A")?, Observer::default());
    /// let yellow = Channels::Wavelengths(vec![450.0, 550.0, 650.0]).xyz(&[0.1, 0.7, 0.9], &a, &observer).expect("it is seen");
    /// assert!(yellow[0] > yellow[1] && yellow[1] > 10.0 * yellow[2]);
    /// assert_eq!(Channels::Luminance.xyz(&[0.5], &a, &observer).expect("it is seen")[1], 0.5);
    /// # Ok::<(), glanz_color::UnknownName>(())
    /// ```
    pub fn xyz(&self, factors: &[f64], light: &FineSpectrum, observer: &Observer) -> Option<[f64; 3]> {
        let xyz = match self {
            Self::Luminance => {
                xyz_of_light(light, observer).map(|white| white * factors.first().unwrap_or(&f64::NAN))
            }
            Self::Rgb => LinearSrgb(factors.try_into().ok()?).to_xyz().0,
            Self::Xyz => factors.try_into().ok()?,
            Self::Wavelengths(nm) => {
                let spectrum = FineSpectrum::from_table(nm, factors, Outside::Hold).ok()?;
                xyz_of_reflectance(&spectrum, light, observer)
            }
        };
        xyz.iter().all(|value| value.is_finite()).then_some(xyz)
    }

    /// X, Y and Z of the perfect diffuser, Y = 1: what [`Channels::xyz`] gives for a white.
    pub fn white(&self, light: &FineSpectrum, observer: &Observer) -> Option<[f64; 3]> {
        let white = match self {
            Self::Rgb | Self::Xyz => Xyz::WHITE.0,
            Self::Luminance | Self::Wavelengths(_) => xyz_of_light(light, observer),
        };
        white.iter().all(|value| value.is_finite()).then_some(white)
    }

    /// Whether colours depend on the light and the observer: of wavelengths, and of one channel, which is a grey.
    pub fn has_spectra(&self) -> bool {
        matches!(self, Self::Luminance | Self::Wavelengths(_))
    }
}
