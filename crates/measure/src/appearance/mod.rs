//! Numbers of appearance: gloss, haze, radiance factors, flop, and what spheres see.
//!
//! Each is computed of a BRDF as an instrument would measure it: [`GlossMeter`], [`HazeMeter`], [`multi_angle`],
//! [`forty_five_zero`] and [`sphere`]. The colour of what they measure is [`Channels::xyz`](crate::Channels::xyz).

mod gloss;
mod haze;
mod multi_angle;
mod receptor;
mod sphere;

use glanz_math::Vec3;

pub use gloss::GlossMeter;
pub use haze::{HazeMeter, haze_of_gloss, log_haze};
pub use multi_angle::{MultiAngle, flop_index, forty_five_zero, multi_angle};
pub use sphere::{SPHERE_DEG, sphere};

/// A BRDF in 1/sr, for a direction to the light and one to the detector; one number per channel.
pub type Function<'a> = dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64> + 'a;
