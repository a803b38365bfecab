//! What a user can choose about development.

pub use glanz_color::ToneMap;

use super::ScreenMatrix;
use crate::Meaning;

/// How a frame becomes a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Develop {
    /// Exposure in stops: channels are multiplied by 2^ev.
    pub ev: f32,
    /// Tone mapping.
    pub tone_map: ToneMap,
    /// Ordered dithering before rounding to 8 bits; 16-bit codes need none.
    pub dither: bool,
    /// From the frame's channels to linear sRGB; none where they are linear sRGB already.
    pub to_screen: Option<ScreenMatrix>,
}
impl Develop {
    /// What the channels of a frame must be that is developed so.
    pub fn expects(&self) -> Meaning {
        self.to_screen.map_or(Meaning::LinearSrgb, |matrix| matrix.from)
    }
}
