//! Differences between drawn frames of one scene, over the pixels that show a surface.
//!
//! [`Difference`] is the error of linear light and of display codes, [`DeltaE`] the colour difference ΔE00 per
//! pixel. Unlike a [`Pair`](super::Pair) of picture files, frames know where a surface is: the background counts
//! for nothing.
//!
//! ```
//! use glanz_picture::Frame;
//! use glanz_picture::compare::frames::{Developed, Difference};
//!
//! // One pixel that shows a surface, and the same a little brighter.
//! let grey = |value: f32| Developed {
//!     frame: Frame {
//!         width: 1,
//!         height: 1,
//!         rgb: [0; 3].map(|_| vec![value]),
//!         alpha: vec![1.0],
//!         object: vec![1],
//!         ..Frame::default()
//!     },
//!     codes: vec![118, 118, 118, 255],
//! };
//! let difference = Difference::between(&grey(0.18), &grey(0.2));
//! assert!((difference.rmse_linear - 0.02).abs() < 1e-6 && difference.rmse_codes == 0.0);
//! ```

mod delta;
mod difference;

pub use delta::DeltaE;
pub use difference::{Developed, Difference};
