//! What draws itself on a page.

use std::path::Path;

use super::shapes::Page;
use crate::Error;

/// A figure: plain data that draws itself on a [`Page`].
pub trait Figure {
    /// The page with the figure on it.
    fn page(&self) -> Page;

    /// The figure as SVG; see [`Page::svg`].
    ///
    /// # Errors
    /// Those of [`Page::svg`].
    fn svg(&self) -> Result<String, Error> {
        self.page().svg()
    }

    /// The figure as the bytes of a PNG file; see [`Page::png`].
    ///
    /// # Errors
    /// Those of [`Page::png`].
    fn png(&self) -> Result<Vec<u8>, Error> {
        self.page().png()
    }

    /// Writes the figure, as SVG or PNG by the ending of the file's name; see [`Page::save`].
    ///
    /// # Errors
    /// Those of [`Page::save`].
    fn save(&self, path: &Path) -> Result<(), Error> {
        self.page().save(path)
    }
}
