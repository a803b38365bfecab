//! The linear picture.

use glanz_math::SimdLevel;

use crate::develop::to_screen_with;
use crate::{ChannelError, Channels, ToScreen};

/// A drawn picture before development: linear channels of the observer, one plane after the other.
///
/// Every plane holds `width · height` values in rows from the top. Colours are premultiplied with
/// alpha; where the background is a colour, alpha is 1 everywhere.
///
/// ```
/// use glanz_picture::{Develop, Frame, develop};
///
/// // One pixel of mid grey in linear sRGB.
/// let rgb = [vec![0.2140], vec![0.2140], vec![0.2140]];
/// let frame = Frame { width: 1, height: 1, rgb, alpha: vec![1.0], ..Frame::default() };
/// assert_eq!(develop(&frame, &Develop::default())?, [127, 127, 127, 255]);
/// # Ok::<(), glanz_picture::ChannelError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// What the channels mean.
    pub channels: Channels,
    /// The first three channels.
    pub rgb: [Vec<f32>; 3],
    /// The other channels of an observer with more than three.
    pub more: Vec<Vec<f32>>,
    /// How much of the pixel is covered.
    pub alpha: Vec<f32>,
    /// Distance from the eye plane in metres, infinite where no surface is; empty if not asked for.
    pub depth: Vec<f32>,
    /// World-space shading normal of the nearest surface, null where no surface is; empty planes if not
    /// asked for.
    pub normal: [Vec<f32>; 3],
    /// 1 + the number of the nearest object, 0 where no surface is; empty if not asked for.
    pub object: Vec<u32>,
}

impl Frame {
    /// The same picture in linear sRGB.
    ///
    /// # Errors
    /// If the map is for other channels than the frame has.
    pub fn on_screen(self, to_screen: &ToScreen) -> Result<Self, ChannelError> {
        self.channels.expect(to_screen.from())?;
        let mut frame = self;
        to_screen_with(&mut frame, to_screen, SimdLevel::best());
        frame.more.clear();
        frame.channels = Channels { observer: frame.channels.observer, ..Channels::default() };
        Ok(frame)
    }

    /// The colour and alpha of a pixel.
    pub fn pixel(&self, x: usize, y: usize) -> [f32; 4] {
        let i = y * self.width + x;
        [self.rgb[0][i], self.rgb[1][i], self.rgb[2][i], self.alpha[i]]
    }
}
