//! Pictures: linear frames, their development to display codes, picture files, and comparison.
//!
//! A [`Frame`] holds linear channels; [`develop()`] does white adaptation, exposure, tone mapping and encoding,
//! and only there does anything become sRGB. [`output`] writes PNG, OpenEXR, GIF and APNG files, [`compare`]
//! tells how far two pictures are apart.
//!
//! ```
//! use glanz_picture::{Develop, Frame, develop};
//!
//! // One grey pixel of linear light: 18 % is the code 118 of sRGB.
//! let frame = Frame {
//!     width: 1,
//!     height: 1,
//!     rgb: [0.18; 3].map(|value| vec![value]),
//!     alpha: vec![1.0],
//!     ..Frame::default()
//! };
//! assert_eq!(develop(&frame, &Develop::default())?, [118, 118, 118, 255]);
//! # Ok::<(), glanz_picture::ChannelError>(())
//! ```

mod channels;
pub mod compare;
mod develop;
mod frame;
pub mod output;
mod png_palette;

pub use channels::{ChannelError, Channels, Meaning, Scale};
pub use develop::{
    Develop, DevelopKernel, Encoding, ScreenMatrix, ToScreen, ToneMap, develop, develop_with, develop16,
    develop16_with,
};
pub use frame::Frame;
pub use png_palette::wrong_png_palette;
