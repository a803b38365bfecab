//! From a scene to a picture, on the CPU.
//!
//! `prepare` turns a `Scene` into plain arrays ([`Prepared`]): lobe shapes, light geometry and the
//! tint tables, in which all colour work is done. [`draw`] turns those into a [`Frame`] of linear
//! channels, [`develop()`] turns a frame into display codes, [`output`] writes picture files.

pub mod cpu;
mod draw;
mod observe;
mod parallel;
mod prepare;
mod view;

pub use draw::{Aovs, DebugView, DrawOptions, draw, draw_rgba8};
pub use glanz_picture::{
    Develop, DevelopKernel, Frame, ToScreen, ToneMap, develop, develop_with, develop16, develop16_with,
};
pub use observe::draw_observed;
pub use prepare::{
    Observation, ObservationError, PrepareError, PrepareOptions, Prepared, SCREEN_WHITE_CD_M2, prepare,
};
pub use view::{View, ViewError};
