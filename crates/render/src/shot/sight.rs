//! How a prepared scene is looked at: view, drawing and development, without the scene.

use glanz_color::Rgb;
use glanz_picture::{Develop, ToScreen};
use glanz_scene::{Background, Camera, White};

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
}

impl Sight {
    /// Checks camera and size, too.
    pub(crate) fn new(options: &ShotOptions, to_screen: Option<ToScreen>) -> Result<Self, ShotError> {
        let ShotOptions { draw, ev, tone_map, encoding, dither, white, size, camera, .. } = *options;
        let view = View::new(&camera, size.0, size.1)?;
        let develop = Develop { ev, tone_map, dither, encoding, to_screen: None };
        let background = draw.background;
        let mut sight = Self { camera, view, draw, develop, white, background, to_screen: None };
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
