//! From a scene to a picture, on the CPU.
//!
//! `prepare` turns a `Scene` into plain arrays ([`Prepared`]): lobe shapes, light geometry and the
//! tint tables, in which all colour work is done. [`draw`] turns those into a [`Frame`] of linear
//! channels, [`develop()`] turns a frame into display codes, [`output`] writes picture files.

pub mod compare;
pub mod cpu;
mod develop;
mod draw;
mod frame;
mod observe;
pub mod output;
mod parallel;
mod prepare;
mod view;

pub use develop::{
    Develop, DevelopKernel, ToScreen, ToneMap, develop, develop_with, develop16, develop16_with,
};
pub use draw::{DrawOptions, Aovs, DebugView, draw, draw_rgba8};
pub use frame::Frame;
pub use observe::draw_observed;
pub use prepare::{
    Observation, ObservationError, PrepareError, PrepareOptions, Prepared, SCREEN_WHITE_CD_M2, prepare,
};
pub use view::{View, ViewError};
