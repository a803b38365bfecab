//! Plots into files.

use std::path::{Path, PathBuf};

use glanz_picture::output::{OutputError, write_atomically};

use super::{Picture, png, svg};
use crate::args::check_folder;
use crate::failure::Failure;

/// The formats of plots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PlotFormat {
    Svg,
    Png,
}

/// A file that a plot goes to; its ending is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotFile {
    path: PathBuf,
    format: PlotFormat,
}

/// Parses the name of a plot's file, whose format is told by its ending.
pub fn plot_file(text: &str) -> Result<PlotFile, String> {
    let path = PathBuf::from(text);
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let format = match ending.to_ascii_lowercase().as_str() {
        "svg" => PlotFormat::Svg,
        "png" => PlotFormat::Png,
        _ => return Err("the name of a plot must end in .svg or .png".to_owned()),
    };
    Ok(PlotFile { path, format })
}

impl PlotFile {
    /// The file's name.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// That the file can be written, before any work is done.
    pub fn check(&self) -> Result<(), Failure> {
        check_folder(&self.path)
    }

    /// Writes the picture. The file is old or new, but never half.
    pub fn save(&self, picture: &Picture) -> Result<(), Failure> {
        write_atomically(&self.path, |out| -> Result<(), OutputError> {
            match self.format {
                PlotFormat::Svg => svg::write(picture, out),
                PlotFormat::Png => png::write(picture, out),
            }
        })
        .map_err(Failure::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_tells_the_format() {
        assert_eq!(plot_file("a.b/c.SVG").unwrap().format, PlotFormat::Svg);
        assert_eq!(plot_file("c.png").unwrap().format, PlotFormat::Png);
        assert!(plot_file("c.pdf").is_err() && plot_file("svg").is_err());
    }
}
