//! From a scene to linear frames: [`prepare`](mod@prepare), [`view`], back ends.
//!
//! [`prepare()`] turns a `Scene` into plain arrays ([`Prepared`]): geometry, lobe shapes, lights and the tint table, in
//! which all work with wavelengths is done. [`view`] makes of these what every back end needs per frame. A
//! [`Backend`] turns both into a [`Frame`] of linear channels; the CPU's is [`cpu::Renderer`].
//!
//! ```
//! use glanz_render::Shot;
//! use glanz_scene::{Light, Mesh, Scene, library};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
//!     .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0; 3]))
//!     .with_size(64, 48);
//! let frame = Shot::new(&scene)?.frame()?;
//! let [r, g, b, alpha] = frame.pixel(32, 24);
//! assert!(r > g && g > b && alpha == 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Shot`] makes one picture, [`Session`] many of a scene that changes.

mod backend;
pub mod cpu;
mod material_response;
mod observe;
mod parallel;
pub mod prepare;
mod session;
mod shot;
pub mod view;

pub use backend::{Backend, BackendError, DrawMeter, default_backend, draw, draw_rgba8};
pub use cpu::probe::{Arrival, PointPlace, Probe, ProbedLight, ProbedLobe, ProbedPoint, ProbedSurface};
pub use glam;
pub use glanz_picture::{
    Develop, DevelopKernel, Encoding, Frame, ToScreen, ToneMap, develop, develop_with, develop16,
    develop16_with,
};
pub use material_response::MaterialResponse;
pub use observe::{draw_observed, draw_observed_into, takes_several_frames};
pub use prepare::{
    Change, Observation, ObservationError, OwnWhite, PrepareError, PrepareOptions, Prepared, ProgramError,
    SCREEN_WHITE_CD_M2, check_memory, prepare,
};
pub use session::Session;
pub use shot::{
    LightError, NOT_REACHED, PictureLight, Remark, RemarkKind, SaveError, SeenPicture, Shot, ShotError,
    ShotOptions, Step, UniformFill, ValueFrame, Xray, picture_frame, see_picture,
};
pub use view::{
    Aovs, DebugView, DrawOptions, ExactLighting, Half, Moment, Samples, SamplesError, View, ViewError,
};
