//! Pictures: linear frames, their development to display codes, picture files, and comparison.
//!
//! A [`Frame`] holds linear channels; [`develop()`] does white adaptation, exposure, tone mapping and encoding,
//! and only there does anything become sRGB. [`output`] writes PNG, OpenEXR, GIF and APNG files, [`compare`]
//! tells how far two pictures are apart.

mod channels;
pub mod compare;
mod develop;
mod frame;
pub mod output;

pub use channels::{ChannelError, Channels, Meaning, Scale};
pub use develop::{
    Develop, DevelopKernel, ScreenMatrix, ToScreen, ToneMap, develop, develop_with, develop16, develop16_with,
};
pub use frame::Frame;
