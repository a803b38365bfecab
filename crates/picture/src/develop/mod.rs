//! From linear channels to display codes.
//!
//! The steps, in this order: straight colour from premultiplied, the way from the observer's channels to
//! linear sRGB, exposure, tone map, clip to 0 … 1,
//! sRGB encoding (unless none is asked for), ordered dithering if asked for, rounding. They are written once, generic over
//! [`Real`](glanz_math::Real): the rasteriser runs [`DevelopKernel`] on 16 pixels while they are in
//! registers, [`develop()`] runs the same text over a whole frame, so both give the same bytes.
//!
//! Every input gives a defined code: NaN and −∞ count as 0, +∞ as the brightest value. Through the matrix of an
//! observer, infinite light has no colour and may count as 0.

mod dither;
mod encode;
mod kernel;
mod on_screen;
mod pack;
mod picture;
mod settings;
mod to_screen;
mod tone_map;

pub use kernel::DevelopKernel;
pub(crate) use on_screen::to_screen_with;
pub use picture::{develop, develop_with, develop16, develop16_with};
pub use settings::{Develop, Encoding, ToneMap};
pub use to_screen::{ScreenMatrix, ToScreen};
