//! Pages as SVG and PNG, in memory and in files.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use glanz_picture::output::write_atomically;

use super::shapes::Page;
use super::{png, svg};
use crate::Error;

/// The formats of pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PageFormat {
    /// Scalable Vector Graphics.
    Svg,
    /// A PNG of two pixels per point.
    Png,
}

impl PageFormat {
    /// The format that the ending of a file's name stands for.
    ///
    /// # Errors
    /// [`Error::UnknownExtension`] for any ending but `.svg` and `.png`.
    pub fn from_path(path: &Path) -> Result<Self, Error> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        match ending.to_ascii_lowercase().as_str() {
            "svg" => Ok(Self::Svg),
            "png" => Ok(Self::Png),
            _ => Err(Error::UnknownExtension { path: path.to_owned() }),
        }
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

    /// The page as the bytes of a PNG file, two pixels per point.
    ///
    /// # Errors
    /// [`Error::Output`] if the page cannot be encoded.
    pub fn png(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = Vec::new();
        png::write(self, &mut bytes)?;
        Ok(bytes)
    }

    /// Writes the page, as SVG or PNG by the ending of the file's name. The file is replaced as a whole, or not at
    /// all.
    ///
    /// # Errors
    /// [`Error::UnknownExtension`], or [`Error::Output`] if the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        PlotFile::new(path.as_ref())?.save(self)
    }
}

/// A file for a page, whose format is known: a name can be refused before any work is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotFile {
    path: PathBuf,
    format: PageFormat,
}

impl PlotFile {
    /// The file of this name.
    ///
    /// # Errors
    /// [`Error::UnknownExtension`] for any ending but `.svg` and `.png`.
    pub fn new(path: impl Into<PathBuf>) -> Result<Self, Error> {
        let path = path.into();
        Ok(Self { format: PageFormat::from_path(&path)?, path })
    }

    /// The file's name.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The file's format.
    pub fn format(&self) -> PageFormat {
        self.format
    }

    /// Writes the page. The file is replaced as a whole, or not at all.
    ///
    /// # Errors
    /// [`Error::Output`] if the page cannot be encoded or the file not be written.
    pub fn save(&self, page: &Page) -> Result<(), Error> {
        write_atomically(&self.path, |out| match self.format {
            PageFormat::Svg => svg::write(page, out).map_err(Error::from),
            PageFormat::Png => png::write(page, out).map_err(Error::from),
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
        assert_eq!(format("a.b/c.SVG"), Some(PageFormat::Svg));
        assert_eq!(format("c.png"), Some(PageFormat::Png));
        assert_eq!((format("c.pdf"), format("svg")), (None, None));
    }
}
