//! The commands that draw scenes.

pub(in crate::commands) mod ffmpeg;
pub(super) mod film;
pub(super) mod lighting_error;
pub(super) mod modes;
pub(super) mod relight;
pub(super) mod render;
mod seen_picture;
pub(super) mod shade_compare;
pub(super) mod sheet;
mod side_by_side;
pub(super) mod stage_sheet;
pub(super) mod sweep;
mod watch;
mod watched;
