//! The page that figures are drawn on, and its file formats.
//!
//! A [`Page`] is a list of shapes in points and knows no file format; [`Page::svg`], [`Page::png`] and
//! [`Page::save`] write it.

mod figure;
mod files;
pub(crate) mod letters;
mod paint;
mod png;
mod shapes;
pub(crate) mod style;
mod svg;

pub use figure::Figure;
pub use files::{PageFormat, PlotFile};
pub use shapes::{Anchor, Page, Raster, Rect, Shape, Text};
pub use style::{Rgb8, curve_color, curve_dash, dash};
