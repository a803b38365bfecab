//! Lights: punctual, area and environment lights, and the luminaires that shape them.

mod default_lights;
mod environment;
mod luminaire;
mod setters;
mod source;

pub use default_lights::{DefaultLights, add_default_lights};
pub use environment::EnvironmentMap;
pub use luminaire::{Luminaire, Profile};
pub use setters::LightError;
pub use source::{AreaShape, Attenuation, Light, LightColors, LightKind, Space};
