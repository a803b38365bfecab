//! Files beside a picture: tables of spectra, plots, and what is told of contact sheets.

use std::path::Path;

use glanz_color::Spectrum;
use glanz_color::write::write_csv;
use glanz_picture::output::{OutputError, write_atomically};
use glanz_plot::{Figure, PlotFile};
use serde_json::json;

use super::failure::Failure;
use super::stdout::{self, FormatArgs, note};
use crate::args::{Target, check_folder};

/// Writes spectra as columns, by their names. The file is old or new, but never half.
pub fn save_csv(path: &Path, spectra: &[(&str, &Spectrum)]) -> Result<(), Failure> {
    write_atomically(path, |out| write_csv(out, spectra).map_err(OutputError::Stream))?;
    note(format_args!("wrote {}", path.display()));
    Ok(())
}

/// That the file of a plot can be written, before any work is done.
pub fn check_plot(file: Option<&PlotFile>) -> Result<(), Failure> {
    file.map_or(Ok(()), |file| check_folder(file.path()))
}

/// Writes a plot. The file is old or new, but never half.
pub fn save_plot(file: &PlotFile, figure: &dyn Figure) -> Result<(), Failure> {
    file.save(&figure.page())?;
    note(format_args!("wrote {}", file.path().display()));
    Ok(())
}

/// Tells that a contact sheet was written, and to programs what each picture of it sets.
pub fn tell_sheet(
    target: &Target,
    (width, height): (usize, usize),
    cells: &[Vec<(String, String)>],
    format: FormatArgs,
) -> Result<(), Failure> {
    let Target::File(path) = target else {
        return Ok(());
    };
    note(format_args!("wrote {}", path.display()));
    if !format.is_json() {
        return Ok(());
    }
    let cell = |values: &Vec<(String, String)>| -> serde_json::Map<_, _> {
        values.iter().map(|(path, value)| (path.clone(), value.clone().into())).collect()
    };
    let cells: Vec<_> = cells.iter().map(cell).collect();
    let path = path.display().to_string();
    stdout::json(&json!({ "file": path, "width": width, "height": height, "cells": cells }))
}
