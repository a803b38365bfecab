//! From a scene to linear frames: [`prepare`](mod@prepare), [`view`], back ends.
//!
//! [`prepare()`] turns a `Scene` into plain arrays ([`Prepared`]): geometry, lobe shapes, lights and the tint table, in
//! which all work with wavelengths is done. [`view`] makes of these what every back end needs per frame. A
//! [`Backend`] turns both into a [`Frame`] of linear channels; the CPU's is [`cpu::Renderer`].

mod backend;
pub mod cpu;
mod observe;
mod parallel;
pub mod prepare;
mod session;
mod shot;
pub mod view;

pub use backend::{Backend, default_backend, draw, draw_rgba8};
pub use glam;
pub use glanz_picture::{
    Develop, DevelopKernel, Frame, ToScreen, ToneMap, develop, develop_with, develop16, develop16_with,
};
pub use observe::{draw_observed, takes_several_frames};
pub use prepare::{
    Change, Observation, ObservationError, PrepareError, PrepareOptions, Prepared, SCREEN_WHITE_CD_M2,
    prepare,
};
pub use session::Session;
pub use shot::{SaveError, Shot, ShotError, ShotOptions, Step};
pub use view::{Aovs, DebugView, DrawOptions, Samples, SamplesError, View, ViewError};
