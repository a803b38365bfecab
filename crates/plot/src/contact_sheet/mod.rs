//! Contact sheets: drawn pictures in rows and columns, with titles, captions and heat maps of their differences.
//!
//! ```
//! use glanz_plot::{Canvas, ContactSheet};
//!
//! let sheet = ContactSheet {
//!     columns: vec!["grey".to_owned(), "white".to_owned()],
//!     per_row: 2,
//!     count: 2,
//!     cell: (40, 30),
//!     ..ContactSheet::default()
//! };
//! let mut canvas = sheet.begin()?;
//! for (index, color) in [[128; 3], [255; 3]].into_iter().enumerate() {
//!     sheet.put(&mut canvas, index, &Canvas::new(40, 30, color));
//! }
//! assert!(canvas.width > 80 && canvas.height > 30);
//! # Ok::<(), glanz_plot::Error>(())
//! ```

mod canvas;
mod grid;
mod heat_map_sheet;
mod sheet;

pub use canvas::{Canvas, Lettering};
pub use grid::{Grid, Variation};
pub use heat_map_sheet::heat_map_sheet;
pub use sheet::ContactSheet;
