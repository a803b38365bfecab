//! How far light by points is from the truth.

use core::fmt;

use super::{Shot, ShotError};
use crate::prepare::LightShape;
use crate::view::{Aovs, DrawOptions, ExactLighting, Half, Samples, View};
use glanz_scene::Background;

/// The most pixels of the pictures that are compared.
const PIXELS: f64 = 4096.0;

/// How far areas and environments by points are from the truth: half of the difference that both halves of the points make, in
/// parts of the mean over the surfaces. [`Shot::light_error`] measures it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightError {
    /// Points of each light at each pixel.
    pub points: u32,
    /// Pixels with surfaces that were compared.
    pub pixels: usize,
    /// The root of the mean square.
    pub rms: f64,
    /// The greatest.
    pub most: f64,
}

impl fmt::Display for LightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, pixels, rms, most } = self;
        write!(
            f,
            "areas and environments by {points} points: a pixel is off by about {:.2} % of what surfaces have on average, at \
             most by {:.1} % (by both halves of the points, at {pixels} pixels)",
            100.0 * rms,
            100.0 * most
        )
    }
}

impl Shot {
    /// How far the light of a picture by points is from the truth, measured in a small picture; nothing where all light is found
    /// otherwise.
    ///
    /// ```
    /// use glanz_render::{ExactLighting, Shot, ShotOptions};
    /// use glanz_scene::{DefaultLights, Mesh, Scene, library};
    ///
    /// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(32, 24);
    /// DefaultLights::Studio.add(&mut scene);
    /// let mut options = ShotOptions::of(&scene)?;
    /// options.draw.exact = Some(ExactLighting::new(256));
    /// let error = Shot::with(&scene, options)?.light_error()?.expect("there is an environment");
    /// assert!(error.points == 256 && error.rms > 0.0 && error.rms < 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Shot::frame`].
    pub fn light_error(&mut self) -> Result<Option<LightError>, ShotError> {
        let extended =
            |shape: &LightShape| matches!(shape, LightShape::Area { .. } | LightShape::Environment(_));
        let is_any = self.prepared.lights.iter().any(|light| extended(&light.shape));
        let Some(ExactLighting { points, .. }) = self.sight.draw.exact.filter(|_| is_any) else {
            return Ok(None);
        };
        let View { width, height, .. } = self.sight.view;
        let factor = (PIXELS / (f64::from(width) * f64::from(height))).sqrt().min(1.0);
        let side = |length: u32| ((f64::from(length) * factor) as u32).max(1);
        let view = View::new(&self.sight.camera, side(width), side(height))?;
        let halves = [Half::First, Half::Second].map(|half| {
            let exact = Some(ExactLighting { points, half: Some(half) });
            let (samples, background) = (Samples::One, Background::Transparent);
            let aovs = Aovs::default();
            let options = DrawOptions { exact, samples, background, aovs, ..self.sight.draw };
            self.backend.draw(&self.prepared, &view, &options)
        });
        let seen: Vec<usize> = (0..halves[0].alpha.len()).filter(|i| halves[0].alpha[*i] > 0.0).collect();
        let of =
            |half: usize, i: usize| halves[half].rgb.iter().map(|plane| f64::from(plane[i])).sum::<f64>();
        let mean = seen.iter().map(|i| 0.5 * (of(0, *i) + of(1, *i))).sum::<f64>() / seen.len() as f64;
        let error = |i: &usize| 0.5 * (of(0, *i) - of(1, *i)).abs() / mean;
        let squares = seen.iter().map(|i| error(i) * error(i)).sum::<f64>();
        let most = seen.iter().map(error).fold(0.0, f64::max);
        let rms = libm::sqrt(squares / seen.len() as f64);
        let is_known = mean > 0.0 && rms.is_finite();
        Ok(is_known.then_some(LightError { points, pixels: seen.len(), rms, most }))
    }
}
