//! The page that figures are drawn on, and its file formats.
//!
//! A [`Page`] is a list of shapes in points and knows no file format; [`Page::svg`], [`Page::png`] and
//! [`Page::pdf`] write it.
//!
//! ```
//! use glanz_plot::page::{Anchor, Page};
//!
//! let mut page = Page::new(100, 60);
//! page.line([(10.0, 50.0), (90.0, 10.0)], [0, 0, 255], 1.5);
//! page.text("a line", (50.0, 55.0), Anchor::Middle, 9.0, [0, 0, 0]);
//! assert!(page.svg()?.contains("a line"));
//! assert!(page.png()?.starts_with(b"\x89PNG"));
//! assert!(page.pdf("A line").starts_with(b"%PDF"));
//! # Ok::<(), glanz_plot::Error>(())
//! ```

mod figure;
mod files;
mod fit;
pub(crate) mod letters;
mod paint;
mod pdf;
mod png;
mod shapes;
pub(crate) mod style;
mod svg;

pub use figure::Figure;
pub use files::{PlotFile, PlotFormat};
pub use letters::missing as missing_letters;
pub use shapes::{Anchor, Page, Raster, Rect, Shape, Text};
pub use style::{Rgb8, curve_color, curve_dash, dash};
