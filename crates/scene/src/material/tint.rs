//! The colours of lights and surfaces: RGB, or functions of wavelength.
//!
//! Any scene can be drawn in any colour mode: RGB is turned into spectra where spectra are wanted and
//! spectra into RGB where that is wanted (`glanz_render::prepare`).

use serde::{Deserialize, Serialize};
use std::sync::Arc;

use crate::names::names;
use crate::{CoatedBoundary, Film, Pane};
use glanz_color::{Ior, Reradiation, Rgb, Spectrum, photometry, rgb_spectra};

/// Sources of less luminous efficacy, in lm/W between 300 and 780 nm, are measured by their power: their
/// luminance is so small that a black light scaled by it would burn everything that glows.
const LEAST_EFFICACY: f64 = 1.0;

/// The colour of light that a lamp or a glowing surface sends.
///
/// ```
/// use glanz_scene::LightColor;
///
/// let lamp = LightColor::unit(&glanz_color::light("A")?).expect("it has power");
/// assert!((lamp.strength() - 1.0).abs() < 1e-9);
/// let dim = lamp.scaled(0.25);
/// assert!((dim.luminance().expect("it is seen") - 0.25).abs() < 1e-9);
/// # Ok::<(), glanz_color::UnknownName>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum LightColor {
    /// Amounts of the sRGB primaries; equal amounts are D65.
    Rgb(Rgb),
    /// Spectral power per nm, scaled so that ∫ S·ȳ dλ (CIE 1931) is its luminance in the scene's
    /// unit: 1 is the classic unit light.
    Spectrum(Arc<Spectrum>),
}

impl LightColor {
    /// No light.
    pub const BLACK: Self = Self::Rgb(Rgb::BLACK);

    /// The unit light of this spectrum: of luminance 1, or of the power of D65 with that luminance where the
    /// spectrum is hardly visible. None where it has no power at all.
    pub fn unit(spectrum: &Spectrum) -> Option<Self> {
        let strength = strength(spectrum);
        let exists = strength > 0.0 && strength.is_finite();
        exists.then(|| Self::Spectrum(Arc::new(*spectrum * (1.0 / strength))))
    }

    /// Its luminance; none where the eye hardly sees it.
    pub fn luminance(&self) -> Option<f64> {
        let luminance = match self {
            Self::Rgb(rgb) => f64::from(rgb.luminance()),
            Self::Spectrum(spectrum) if is_visible(spectrum) => rgb_spectra::luminance(spectrum),
            Self::Spectrum(_) => 0.0,
        };
        (luminance > 0.0).then_some(luminance)
    }

    /// How many unit lights of its own spectrum this light is; see [`LightColor::unit`].
    pub fn strength(&self) -> f64 {
        match self {
            Self::Rgb(rgb) => f64::from(rgb.luminance()),
            Self::Spectrum(spectrum) => strength(spectrum),
        }
    }

    /// Whether no light is sent at all.
    pub fn is_black(&self) -> bool {
        match self {
            Self::Rgb(rgb) => *rgb == Rgb::BLACK,
            Self::Spectrum(spectrum) => **spectrum == Spectrum::ZERO,
        }
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Rgb(rgb) => rgb.is_finite(),
            Self::Spectrum(spectrum) => spectrum.is_finite(),
        }
    }

    /// The same colour, more or less of it.
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Rgb(rgb) => Self::Rgb(*rgb * factor as f32),
            Self::Spectrum(spectrum) => Self::Spectrum(Arc::new(**spectrum * factor)),
        }
    }
}

fn strength(spectrum: &Spectrum) -> f64 {
    match is_visible(spectrum) {
        true => rgb_spectra::luminance(spectrum),
        false => spectrum.integral() / rgb_spectra::daylight().integral(),
    }
}

/// Whether its luminance is a measure for a light.
fn is_visible(spectrum: &Spectrum) -> bool {
    let lumens = photometry::PHOTOPIC_LM_PER_W * rgb_spectra::luminance(spectrum);
    lumens >= LEAST_EFFICACY * spectrum.integral()
}

impl From<Rgb> for LightColor {
    fn from(rgb: Rgb) -> Self {
        Self::Rgb(rgb)
    }
}

impl From<[f32; 3]> for LightColor {
    fn from(rgb: [f32; 3]) -> Self {
        Self::Rgb(Rgb(rgb))
    }
}

/// The coloured part of a lobe: what it does to each wavelength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tint {
    /// Reflectance in the sRGB primaries.
    Rgb(Rgb),
    /// Reflectance or transmittance at each wavelength; for an emission lobe the light sent out, scaled as
    /// [`LightColor::Spectrum`].
    Spectrum(Arc<Spectrum>),
    /// Light that comes back at other wavelengths too.
    Reradiation(Arc<Reradiation>),
    /// Fresnel reflection of a smooth boundary, by the angle between viewer and half vector; where a
    /// lobe has none, at normal incidence. Lobes that light passes through take what is not reflected.
    Ior(Arc<Ior>),
    /// Fresnel reflection of light that a filter lets pass in one polarisation.
    Polarized(Arc<Ior>, Polarization),
    /// Fresnel reflection in Schlick's form: this reflectance at normal incidence, 1 at grazing.
    Schlick(Box<Tint>),
    /// What a film and its base reflect.
    Film(Arc<Film>),
    /// What both sides of a pane reflect.
    Pane(Arc<Pane>),
    /// What a boundary below a coat reflects.
    Coated(Arc<CoatedBoundary>),
}

names! {
    /// Polarisation: the direction of the electric field against the plane of incidence.
    pub Polarization {
        /// Perpendicular to it (German: senkrecht).
        S = "s",
        /// Parallel to it.
        P = "p",
    } default S
}

impl Tint {
    /// Nothing comes back.
    pub const BLACK: Self = Self::Rgb(Rgb::BLACK);

    /// Whether nothing comes back.
    pub fn is_black(&self) -> bool {
        *self == Self::BLACK
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Rgb(rgb) => rgb.is_finite(),
            Self::Spectrum(spectrum) => spectrum.is_finite(),
            Self::Reradiation(matrix) => matrix.is_finite(),
            Self::Ior(ior) | Self::Polarized(ior, _) => ior.eta.is_finite() && ior.k.is_finite(),
            Self::Schlick(at_normal) => at_normal.is_finite(),
            Self::Film(film) => film.is_finite(),
            Self::Pane(pane) => pane.is_finite(),
            Self::Coated(boundary) => boundary.is_finite(),
        }
    }

    /// Whether it depends on the angle at which light meets the facet that sends it on.
    pub fn depends_on_angle(&self) -> bool {
        !matches!(self, Self::Rgb(_) | Self::Spectrum(_) | Self::Reradiation(_))
    }

    /// The tint in RGB, if that is how it was given.
    pub fn rgb(&self) -> Option<Rgb> {
        match self {
            Self::Rgb(rgb) => Some(*rgb),
            _ => None,
        }
    }
}

impl From<Rgb> for Tint {
    fn from(rgb: Rgb) -> Self {
        Self::Rgb(rgb)
    }
}

impl From<[f32; 3]> for Tint {
    fn from(rgb: [f32; 3]) -> Self {
        Self::Rgb(Rgb(rgb))
    }
}
