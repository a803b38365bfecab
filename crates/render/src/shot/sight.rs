//! How a prepared scene is looked at: view, drawing and development, without the scene.

use glanz_color::Rgb;
use glanz_eye::{Angles, SCREEN_PX_PER_DEG, Seeing, Viewer};
use glanz_picture::{Develop, ToScreen};
use glanz_scene::{Background, Camera, Projection, Scene, White};

use super::{ShotError, ShotOptions};
use crate::view::{DrawOptions, View};

/// How a prepared scene is looked at.
#[derive(Clone, Debug)]
pub(crate) struct Sight {
    pub camera: Camera,
    pub view: View,
    /// The background is in the observer's channels.
    pub draw: DrawOptions,
    pub develop: Develop,
    pub white: White,
    /// Behind all surfaces, in linear sRGB.
    pub background: Background,
    /// From the observer's channels to the screen; none where they are the screen's.
    pub to_screen: Option<ToScreen>,
    /// The eye whose stages frames go through; none where they are shown as they are drawn.
    pub seeing: Option<Seeing>,
}

impl Sight {
    /// How a scene is looked at with these options; checks camera and size, too.
    pub(crate) fn of(scene: &Scene, options: &ShotOptions) -> Result<Self, ShotError> {
        let observation = &options.prepare.observation;
        let to_screen = match options.draw.show.is_light() {
            true => observation.to_screen(scene, options.white)?,
            false => None,
        };
        let mut sight = Self::new(options, to_screen)?;
        if let Some(viewer) = &options.viewer
            && options.draw.show.is_light()
            && viewer.has_stages()
        {
            let light = (&scene.lights[..], scene.photometric);
            let angles = angles(&sight.camera, &sight.view, viewer);
            sight.seeing = Some(observation.seeing(viewer, light, options.white, angles)?);
        }
        Ok(sight)
    }

    /// Looks by another camera.
    pub(crate) fn turn(&mut self, camera: Camera, view: View) {
        if let Some(seeing) = &mut self.seeing {
            seeing.angles = angles(&camera, &view, &seeing.viewer);
        }
        (self.camera, self.view) = (camera, view);
    }

    fn new(options: &ShotOptions, to_screen: Option<ToScreen>) -> Result<Self, ShotError> {
        let ShotOptions { draw, ev, tone_map, encoding, dither, white, size, camera, .. } = *options;
        let view = View::new(&camera, size.0, size.1)?;
        let develop = Develop { ev, tone_map, dither, encoding, to_screen: None };
        let background = draw.background;
        let (to_screen_later, seeing) = (None, None);
        let mut sight =
            Self { camera, view, draw, develop, white, background, to_screen: to_screen_later, seeing };
        sight.adapt(to_screen);
        Ok(sight)
    }

    /// Takes another way to the screen: that of another observer, or under other lights.
    pub(crate) fn adapt(&mut self, to_screen: Option<ToScreen>) {
        self.draw.background = match (self.background, &to_screen) {
            (Background::Color(color), Some(to_screen)) => {
                Background::Color(Rgb(to_screen.channels_of(color.0)))
            }
            (background, _) => background,
        };
        for (c, channels) in self.draw.primaries.iter_mut().enumerate() {
            let one = core::array::from_fn(|i| if i == c { 1.0 } else { 0.0 });
            *channels = to_screen.as_ref().map_or(one, |to_screen| to_screen.channels_of(one));
        }
        self.develop.to_screen = to_screen.as_ref().and_then(ToScreen::matrix);
        self.to_screen = to_screen;
    }
}

/// How angles belong to the pixels of a picture: as the viewer has it, else as a perspective camera has it.
pub(crate) fn angles(camera: &Camera, view: &View, viewer: &Viewer) -> Angles {
    let middle = [view.width, view.height].map(|size| 0.5 * f64::from(size));
    match (viewer.viewing.px_per_deg, camera.projection) {
        (Some(px_per_deg), _) => Angles { px_per_deg, distance_px: None, middle },
        (None, Projection::Perspective { fov_y }) => {
            let distance = middle[1] / libm::tan(0.5 * fov_y);
            Angles { px_per_deg: distance.to_radians(), distance_px: Some(distance), middle }
        }
        (None, Projection::Orthographic { .. }) => {
            Angles { px_per_deg: SCREEN_PX_PER_DEG, distance_px: None, middle }
        }
    }
}
