//! Colour models: a type for each, conversions between all of them, and the same by name.
//!
//! Every model converts to and from [`Xyz`], which is relative to the white D65 with Y = 1; a model of
//! another white (ACEScg) is adapted by Bradford. Typed: `Hls([210.0, 0.4, 0.8]).to::<Ac1c2>()`. By name:
//! [`convert`]`("hls", "ac1c2", &[210.0, 0.4, 0.8])`.
//!
//! **Colours outside of a gamut.** RGB spaces and CMY hold them with components outside of 0 … 1, the CIE's
//! models, OKLab and those of the eye hold any colour. HLS, HSV and CMYK can hold the sRGB cube only: the
//! typed conversion takes the nearest colour of the cube, component by component; [`convert`] refuses.
//!
//! ```
//! use glanz_color::models::{ColorModel, Hls, Hsv, Lab, Srgb, convert};
//!
//! let Hsv([hue_deg, saturation, value]) = Srgb([0.25, 0.5, 0.75]).to();
//! assert!((hue_deg - 210.0).abs() < 1e-9 && (saturation - 2.0 / 3.0).abs() < 1e-9 && value == 0.75);
//! let Lab([l, _, _]) = Hls([210.0, 0.5, 0.5]).to();
//! assert!((l - 52.0).abs() < 0.5);
//! assert_eq!(convert("hsv", "srgb", &[0.0, 1.0, 1.0])?.len(), 3);
//! assert!(convert("hsv", "srgb", &[0.0, 1.5, 1.0]).is_err(), "no such saturation");
//! # Ok::<_, glanz_color::models::ConvertError>(())
//! ```

mod cie;
pub(crate) mod cones;
mod device;
mod info;
mod oklab;
mod registry;
mod rgb;
mod space;
#[cfg(test)]
mod tests;
mod transfer;
mod vision;

pub use cie::{Lab, Lch, Luv, XyY, Xyz};
pub use device::{Cmy, Cmyk, Hls, Hsv};
pub use info::{Channel, ColorModel, Limit, ModelInfo};
pub use oklab::{Oklab, Oklch};
pub use registry::{ConvertError, Model, convert};
pub use rgb::{AcesCg, AdobeRgb, DisplayP3, LinearSrgb, Rec2020, Srgb};
pub use space::{D65_XY, D65_XYZ, RgbSpace};
pub use transfer::Transfer;
pub use vision::{AC1C2_TO_XYZ, Ac1c2, Lms, Opponent, XYZ_TO_AC1C2};
