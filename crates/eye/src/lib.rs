//! The eye: what another person sees of a scene, at another age, by another light, and why.
//!
//! An [`Eye`] becomes an [`Observer`](glanz_color::Observer), by which a picture is drawn at no further cost.
//!
//! ```
//! use glanz_color::light;
//! use glanz_eye::Eye;
//!
//! // How much of daylight the cones of an eye of 70 get, in parts of one of 32.
//! let (old, young) = ("age:70".parse::<Eye>()?.observer(), Eye::default().observer());
//! let d65 = light("D65")?;
//! let parts: Vec<f64> = old.response(&d65).iter().zip(young.response(&d65)).map(|(a, b)| a / b).collect();
//! assert!(parts[0] > 0.8 && parts[2] < 0.5, "S loses most");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cones;
/// Formulas of the eye in closed form: pupil, mesopic luminance, glare, contrast sensitivity, response, Mach bands, retina.
pub mod curves;
mod eye;
mod mach;
mod media;
mod opponent;
mod parse;
mod population;
mod screen;
mod stages;
mod viewing;

pub use eye::{AGES, Cones, Eye, EyeError, FIELDS_DEG, KNOWN_AGES, Lens, MAX_SHIFT_NM};
pub use mach::{MachBand, MachProfile};
pub use media::{macular_density, pigment_density};
pub use opponent::opponent;
pub use population::ASANO;
pub use screen::{BrettelOnScreen, machado};
pub use stages::{Angles, Defect, LUMINANCE, Seeing, Seen};
pub use viewing::{LEVELS, ROD_LIMIT_CD_M2, RodColor, SCREEN_PX_PER_DEG, Viewer, Viewing, level_cd_m2};
