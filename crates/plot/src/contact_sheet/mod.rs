//! Contact sheets: drawn pictures in rows and columns, with titles, captions and heat maps of their differences.

mod canvas;
mod grid;
mod heat_map_sheet;
mod sheet;

pub use canvas::{Canvas, Lettering};
pub use grid::{Grid, Variation};
pub use heat_map_sheet::heat_map_sheet;
pub use sheet::ContactSheet;
