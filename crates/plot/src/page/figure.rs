//! What draws itself on a page.

use std::path::Path;

use super::files::{PlotFile, PlotFormat};
use super::shapes::Page;
use super::{pdf, png, svg};
use crate::Error;
use crate::data::PlotData;
use crate::words::Lang;

/// A figure: plain data that draws itself on a [`Page`] and tells its numbers.
pub trait Figure {
    /// The page with the figure on it. A figure that can be wider or narrower takes about this width and height in
    /// points, if they are given; see [`sized_page`](Self::sized_page).
    fn layout(&self, size: Option<(f64, f64)>) -> Page;

    /// The numbers of the figure, with their units.
    fn data(&self) -> PlotData;

    /// The title, to be read or changed.
    fn title_mut(&mut self) -> &mut String;

    /// The language of its words, and of its numbers: French has decimal commas.
    fn lang(&self) -> Lang;

    /// The page with the figure on it, in its own size.
    fn page(&self) -> Page {
        self.layout(None).with_numbers_in(self.lang())
    }

    /// The page with the figure on it, exactly so many points wide and high; a PNG has as many pixels. Letters and
    /// lines keep their size, and grow where the page is larger both ways than the figure's own.
    fn sized_page(&self, (width, height): (u32, u32)) -> Page {
        let (width, height) = (f64::from(width), f64::from(height));
        let own = self.page();
        let scale = (width / f64::from(own.width)).min(height / f64::from(own.height)).max(1.0);
        let page = self.layout(Some((width / scale, height / scale))).with_numbers_in(self.lang());
        page.fitted(width, height)
    }

    /// The bytes of a file in this format. Of a given size, the page is [`sized_page`](Self::sized_page).
    ///
    /// # Errors
    /// [`Error::Output`] if the page cannot be encoded.
    fn to_bytes(&self, format: PlotFormat, size: Option<(u32, u32)>) -> Result<Vec<u8>, Error> {
        let page = || size.map_or_else(|| self.page(), |size| self.sized_page(size));
        let mut bytes = Vec::new();
        match format {
            PlotFormat::Svg => svg::write(&page(), &mut bytes)?,
            PlotFormat::Png => png::write(&page(), &mut bytes)?,
            PlotFormat::Pdf => bytes = pdf::write(&page(), &self.data().title),
            PlotFormat::Csv => bytes = self.csv().into_bytes(),
            PlotFormat::Json => bytes = self.json().into_bytes(),
        }
        Ok(bytes)
    }

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

    /// The figure as the bytes of a PDF file; see [`Page::pdf`].
    fn pdf(&self) -> Vec<u8> {
        pdf::write(&self.page(), &self.data().title)
    }

    /// The numbers as a table; see [`PlotData::csv`].
    fn csv(&self) -> String {
        self.data().csv()
    }

    /// The numbers as a JSON document; see [`PlotData::json`].
    fn json(&self) -> String {
        self.data().json()
    }

    /// Writes the figure in the format that the ending of the file's name stands for: `.svg`, `.png`, `.pdf`, `.csv`
    /// or `.json`. The file is replaced as a whole, or not at all.
    ///
    /// # Errors
    /// [`Error::UnknownExtension`], or [`Error::Output`] if the file cannot be written.
    fn save(&self, path: &Path) -> Result<(), Error> {
        let file = PlotFile::new(path)?;
        file.write(&self.to_bytes(file.format(), None)?)
    }
}
