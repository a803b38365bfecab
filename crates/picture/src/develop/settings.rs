//! What a user can choose about development.

pub use glanz_color::{Encoding, ToneMap};

use super::ScreenMatrix;
use crate::Meaning;

/// How a frame becomes a picture.
///
/// ```
/// use glanz_picture::{Develop, Encoding, Frame, ToneMap, develop};
///
/// let rgb = [vec![4.0], vec![1.0], vec![0.25]];
/// let frame = Frame { width: 1, height: 1, rgb, alpha: vec![1.0], ..Frame::default() };
/// assert_eq!(develop(&frame, &Develop::default())?, [255, 255, 137, 255], "4 is clipped");
/// let darker = Develop { ev: -2.0, ..Develop::default() };
/// assert_eq!(develop(&frame, &darker)?, [255, 137, 71, 255]);
/// let compressed = Develop { tone_map: ToneMap::Reinhard, ..Develop::default() };
/// assert!(develop(&frame, &compressed)?[1] < 255, "where 1 was 255");
/// let raw = Develop { encoding: Encoding::Raw, ..Develop::default() };
/// assert_eq!(develop(&frame, &raw)?, [255, 255, 64, 255], "0.25 · 255, rounded");
/// # Ok::<(), glanz_picture::ChannelError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Develop {
    /// Exposure in stops: channels are multiplied by 2^ev.
    pub ev: f32,
    /// Tone mapping.
    pub tone_map: ToneMap,
    /// Ordered dithering before rounding to 8 bits; 16-bit codes need none.
    pub dither: bool,
    /// How linear light becomes codes.
    pub encoding: Encoding,
    /// From the frame's channels to linear sRGB; none where they are linear sRGB already.
    pub to_screen: Option<ScreenMatrix>,
}
impl Develop {
    /// What the channels of a frame must be that is developed so.
    pub fn expects(&self) -> Meaning {
        self.to_screen.map_or(Meaning::LinearSrgb, |matrix| matrix.from)
    }
}
