//! Pictures that an eye looks at in place of a scene.

use glanz_color::exr::{Band, SpectralImage};
use glanz_color::{FIRST_NM, Observer, SAMPLES, STEP_NM, Spectrum, rgb_spectra};
use glanz_eye::{Angles, SCREEN_PX_PER_DEG, Seen, Viewer};
use glanz_picture::{Frame, ToScreen};
use glanz_scene::{ColorMode, Light, White};

use super::ShotError;
use crate::prepare::Observation;

/// The light of a picture.
#[derive(Clone, Copy, Debug)]
pub enum PictureLight<'a> {
    /// Linear sRGB, planes of `width` pixels a row: each colour stands for the smooth spectrum under D65 that Mallett and Yuksel (2019)
    /// give to it.
    Rgb {
        /// Pixels in a row.
        width: usize,
        /// Red, green and blue.
        rgb: &'a [Vec<f32>; 3],
    },
    /// Spectra of light, in radiance per nm, 1 in all being the classic unit; between wavelengths they are linear, beyond them 0.
    Spectra(&'a SpectralImage),
}

/// A picture as an eye sees it.
#[derive(Clone, Debug)]
pub struct SeenPicture {
    /// The channels of the eye, as [`Shot::frame`](crate::Shot::frame) has them.
    pub frame: Frame,
    /// What the eye made of it, where it goes through stages.
    pub seen: Option<Seen>,
    to_screen: Option<ToScreen>,
}

impl SeenPicture {
    /// A frame of these channels, in linear sRGB.
    ///
    /// # Errors
    /// If the frame has other channels.
    pub fn on_screen(&self, frame: Frame) -> Result<Frame, ShotError> {
        Ok(match &self.to_screen {
            Some(to_screen) => frame.on_screen(to_screen)?,
            None => frame,
        })
    }

    /// The picture itself in linear sRGB.
    ///
    /// # Errors
    /// As [`SeenPicture::on_screen`].
    pub fn screen(&self) -> Result<Frame, ShotError> {
        self.on_screen(self.frame.clone())
    }
}

/// A picture as an eye sees it, and what the eye made of it where it goes through stages.
///
/// White is D65, and a pixel is a fortieth of a degree unless the viewer says otherwise.
///
/// ```
/// use glanz_eye::Viewer;
/// use glanz_render::{PictureLight, see_picture};
///
/// let rgb = [vec![0.8], vec![0.1], vec![0.1]];
/// let deutan: Viewer = "deutan".parse::<glanz_eye::Eye>()?.into();
/// let seen = see_picture(PictureLight::Rgb { width: 1, rgb: &rgb }, &deutan)?;
/// // Red and green are the same yellow to it.
/// let [r, g, b, _] = seen.screen()?.pixel(0, 0);
/// assert!((r - g).abs() < 0.3 * r && b < 0.5 * r);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the spectra are not of light.
pub fn see_picture(light: PictureLight<'_>, viewer: &Viewer) -> Result<SeenPicture, ShotError> {
    let observation = Observation::of_viewer(ColorMode::Spectral, viewer)?;
    let lights = daylight();
    let mut frame = frame_of(light, &observation)?;
    let middle = [frame.width, frame.height].map(|size| 0.5 * size as f64);
    let px_per_deg = viewer.viewing.px_per_deg.unwrap_or(SCREEN_PX_PER_DEG);
    let angles = Angles { px_per_deg, distance_px: None, middle };
    let seen = match viewer.has_stages() {
        true => Some(observation.seeing(viewer, (&lights, false), White::D65, angles)?.see(&mut frame)),
        false => None,
    };
    let to_screen = observation.to_screen_under(&lights, false, White::D65)?;
    Ok(SeenPicture { frame, seen, to_screen })
}

/// What each channel of an observer has of a picture.
///
/// ```
/// use glanz_eye::Eye;
/// use glanz_render::{PictureLight, picture_frame};
///
/// let rgb = [vec![1.0], vec![1.0], vec![1.0]];
/// let light = PictureLight::Rgb { width: 1, rgb: &rgb };
/// let frame = picture_frame(light, &Eye::default().observer_with_rods())?;
/// assert_eq!(frame.channels.names, ["L", "M", "S", "R"]);
/// assert!((frame.rgb[0][0] - 1.0).abs() < 1e-3 && (frame.more[0][0] - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`see_picture`].
pub fn picture_frame(light: PictureLight<'_>, observer: &Observer) -> Result<Frame, ShotError> {
    frame_of(light, &Observation::new(ColorMode::Spectral, Some(observer.clone()))?)
}

/// White is D65.
fn daylight() -> [Light; 1] {
    [Light::directional([0.0, 0.0, -1.0], [1.0; 3])]
}

/// The channels of an observation.
fn frame_of(light: PictureLight<'_>, observation: &Observation) -> Result<Frame, ShotError> {
    let channels = 0..observation.channel_count();
    let (width, height, mut planes): (usize, usize, Vec<Vec<f32>>) = match light {
        PictureLight::Rgb { width, rgb } => {
            let daylight = rgb_spectra::daylight();
            let parts = rgb_spectra::basis().each_ref().map(|spectrum| *spectrum * daylight);
            let plane = |c: usize| {
                let factors = parts.each_ref().map(|part| observation.weight(c).dot(part));
                sum(rgb.iter().zip(factors), rgb[0].len())
            };
            (width, rgb[0].len() / width.max(1), channels.map(plane).collect())
        }
        PictureLight::Spectra(image) => {
            if image.emissive.is_empty() {
                return Err(ShotError::NoLight);
            }
            let plane = |c: usize| {
                let factors = band_factors(&image.emissive, observation.weight(c));
                let values = image.emissive.iter().map(|band| &band.values);
                sum(values.zip(factors), image.width * image.height)
            };
            (image.width, image.height, channels.map(plane).collect())
        }
    };
    let more = planes.split_off(3);
    let rgb = <[Vec<f32>; 3]>::try_from(planes).unwrap_or_default();
    let channels = observation.channels(&daylight(), false, White::D65, (0, observation.channel_count()));
    Ok(Frame { width, height, rgb, more, alpha: vec![1.0; width * height], channels, ..Frame::default() })
}

/// The weighted sum of planes.
fn sum<'a>(planes: impl Iterator<Item = (&'a Vec<f32>, f64)>, pixels: usize) -> Vec<f32> {
    let mut sum = vec![0.0_f64; pixels];
    for (plane, factor) in planes {
        sum.iter_mut().zip(plane).for_each(|(sum, value)| *sum += factor * f64::from(*value));
    }
    sum.into_iter().map(|value| value as f32).collect()
}

/// What each band counts for a sensitivity: the spectrum between bands is linear, and nothing beyond the first and the last.
fn band_factors(bands: &[Band], sensitivity: &Spectrum) -> Vec<f64> {
    let mut factors = vec![0.0; bands.len()];
    for sample in 0..SAMPLES {
        let nm = FIRST_NM + STEP_NM * sample as f64;
        let after = bands.partition_point(|band| band.nm < nm);
        let weight = sensitivity.0[sample] * STEP_NM;
        match (after.checked_sub(1), bands.get(after)) {
            (_, Some(band)) if band.nm == nm => factors[after] += weight,
            (Some(before), Some(band)) => {
                let part = (nm - bands[before].nm) / (band.nm - bands[before].nm);
                factors[before] += weight * (1.0 - part);
                factors[after] += weight * part;
            }
            _ => {}
        }
    }
    factors
}
