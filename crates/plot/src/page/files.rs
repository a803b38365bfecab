//! Formats of plots, and files.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use glanz_picture::output::{OutputError, write_atomically};

use super::shapes::Page;
use super::{pdf, png, svg};
use crate::Error;

/// The formats of plots: three of pages, and two of the numbers that the curves are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlotFormat {
    /// Scalable Vector Graphics.
    Svg,
    /// A PNG picture.
    Png,
    /// A PDF page, with text that can be searched.
    Pdf,
    /// The numbers as a table.
    Csv,
    /// The numbers as a JSON document.
    Json,
}

impl PlotFormat {
    /// Every format with its name, which is also the ending of its files, and a line about it.
    pub const ALL: [(Self, &'static str, &'static str); 5] = [
        (Self::Svg, "svg", "vector graphics for browsers and editors"),
        (Self::Png, "png", "a picture"),
        (Self::Pdf, "pdf", "a page for papers and print"),
        (Self::Csv, "csv", "the numbers of the curves, as a table"),
        (Self::Json, "json", "the numbers of the curves, for programs"),
    ];

    /// Its name, which is also the ending of its files.
    pub fn name(self) -> &'static str {
        Self::ALL.into_iter().find(|(format, ..)| *format == self).map_or("", |(_, name, _)| name)
    }

    /// Whether it is a page, with a size, not a list of numbers.
    pub fn is_page(self) -> bool {
        matches!(self, Self::Svg | Self::Png | Self::Pdf)
    }

    /// The format that the ending of a file's name stands for.
    ///
    /// # Errors
    /// [`Error::UnknownExtension`] for any other ending.
    pub fn from_path(path: &Path) -> Result<Self, Error> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let found = Self::ALL.into_iter().find(|(_, name, _)| name.eq_ignore_ascii_case(ending));
        found.map(|(format, ..)| format).ok_or_else(|| Error::UnknownExtension { path: path.to_owned() })
    }
}

impl Page {
    /// The page as SVG.
    ///
    /// # Errors
    /// [`Error::Output`] if a raster cannot be encoded.
    pub fn svg(&self) -> Result<String, Error> {
        let mut bytes = Vec::new();
        svg::write(self, &mut bytes)?;
        Ok(String::from_utf8(bytes).expect("SVG is written from strings"))
    }

    /// The page as the bytes of a PNG file, with [`Page::density`] pixels per point.
    ///
    /// # Errors
    /// [`Error::Output`] if the page cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = Vec::new();
        png::write(self, &mut bytes)?;
        Ok(bytes)
    }

    /// The page as the bytes of a PDF file (1.7) of this title. The font is embedded, and the text can be searched.
    pub fn pdf(&self, title: &str) -> Vec<u8> {
        pdf::write(self, title)
    }
}

/// A file for a plot, whose format is known: a name can be refused before any work is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotFile {
    path: PathBuf,
    format: PlotFormat,
}

impl PlotFile {
    /// The file of this name, in the format that its ending stands for.
    ///
    /// # Errors
    /// [`Error::UnknownExtension`] for an ending that is none of [`PlotFormat::ALL`].
    pub fn new(path: impl Into<PathBuf>) -> Result<Self, Error> {
        let path = path.into();
        Ok(Self { format: PlotFormat::from_path(&path)?, path })
    }

    /// The file of this name in this format, whatever its ending.
    pub fn of_format(path: impl Into<PathBuf>, format: PlotFormat) -> Self {
        Self { path: path.into(), format }
    }

    /// The file's name.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The file's format.
    pub fn format(&self) -> PlotFormat {
        self.format
    }

    /// Writes the bytes of a plot, such as those of [`Figure::to_bytes`](super::Figure::to_bytes). The file is replaced
    /// as a whole, or not at all.
    ///
    /// # Errors
    /// [`Error::Output`] if the file cannot be written.
    pub fn write(&self, bytes: &[u8]) -> Result<(), Error> {
        write_atomically(&self.path, |out| {
            out.write_all(bytes).map_err(|error| Error::from(OutputError::Stream(error)))
        })
    }
}

impl FromStr for PlotFile {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        Self::new(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_tells_the_format() {
        let format = |name: &str| name.parse::<PlotFile>().map(|file| file.format()).ok();
        assert_eq!(format("a.b/c.SVG"), Some(PlotFormat::Svg));
        assert_eq!((format("c.png"), format("c.pdf")), (Some(PlotFormat::Png), Some(PlotFormat::Pdf)));
        assert_eq!((format("c.csv"), format("c.json")), (Some(PlotFormat::Csv), Some(PlotFormat::Json)));
        assert_eq!((format("c.jpg"), format("svg")), (None, None));
    }
}
