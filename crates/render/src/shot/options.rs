//! What a picture is made with.

use glanz_eye::Viewer;
use glanz_picture::{Encoding, ToneMap};
use glanz_scene::{Camera, Mistake, Scene, White};

use super::ShotError;
use crate::prepare::{Observation, PrepareOptions};
use crate::view::{DrawOptions, ExactLighting, Samples};

/// What a picture is made with beside the scene.
///
/// ```
/// use glanz_render::{Shot, ShotOptions, Samples};
/// use glanz_scene::Scene;
///
/// let scene = Scene::new().with_size(8, 8);
/// let mut options = ShotOptions::of(&scene)?;
/// options.draw.samples = Samples::Sixteen;
/// options.ev = 1.0;
/// let rgba = Shot::with(&scene, options)?.rgba8()?;
/// assert_eq!(rgba.len(), 4 * 8 * 8);
/// # Ok::<(), glanz_render::ShotError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ShotOptions {
    /// How the scene becomes arrays: colour mode and observer among it.
    pub prepare: PrepareOptions,
    /// How it is drawn. A background colour is given in linear sRGB.
    pub draw: DrawOptions,
    /// Exposure in stops.
    pub ev: f32,
    /// Tone mapping.
    pub tone_map: ToneMap,
    /// How linear light becomes codes.
    pub encoding: Encoding,
    /// Ordered dithering of 8-bit codes.
    pub dither: bool,
    /// The white that becomes the screen's.
    pub white: White,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The camera.
    pub camera: Camera,
    /// The eye that looks, and how it looks; its observer is the observation's.
    pub viewer: Option<Viewer>,
    /// A mistake to be drawn on purpose.
    pub mistake: Option<Mistake>,
}

impl ShotOptions {
    /// What is unusual about the making of the picture, as files tell it: another encoding than sRGB's, a mistake.
    pub fn makings(&self) -> Vec<(String, String)> {
        let raw = self.encoding == Encoding::Raw || self.mistake == Some(Mistake::NoGamma);
        let encoding = raw.then_some(("Encoding", "raw: linear values without a transfer function"));
        let mistake = self.mistake.map(|mistake| ("Mistake", mistake.name()));
        encoding.into_iter().chain(mistake).map(|(key, value)| (key.to_owned(), value.to_owned())).collect()
    }

    /// What the scene itself asks for.
    ///
    /// # Errors
    /// If the scene's observer does not fit its colour mode, or its number of samples is none of those that there are.
    pub fn of(scene: &Scene) -> Result<Self, ShotError> {
        let image = &scene.image;
        Ok(Self {
            prepare: PrepareOptions {
                observation: match &scene.eye {
                    Some(viewer) => Observation::of_viewer(scene.render.mode, viewer)?,
                    None => Observation::new(scene.render.mode, scene.observer.clone())?,
                },
                ..PrepareOptions::default()
            },
            draw: DrawOptions {
                samples: Samples::try_from(image.samples)?,
                supersample: image.supersample,
                show: scene.render.show,
                exact: ExactLighting::of(&scene.render),
                ..DrawOptions::new(image.background)
            },
            ev: scene.render.ev as f32,
            tone_map: scene.render.tone_map,
            encoding: scene.render.encoding,
            dither: false,
            white: scene.render.white,
            size: (image.width, image.height),
            camera: scene.camera_or_framing(f64::from(image.width) / f64::from(image.height)),
            viewer: scene.eye.clone(),
            mistake: scene.render.mistake,
        })
    }
}
