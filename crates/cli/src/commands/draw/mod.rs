//! The commands that draw scenes.

pub mod film;
pub mod modes;
pub mod relight;
pub mod render;
pub mod shade_compare;
pub mod sheet;
mod side_by_side;
pub mod stage_sheet;
pub mod sweep;
