//! Files beside a picture: tables of spectra, and what is told of contact sheets.

use std::collections::BTreeMap;
use std::path::Path;

use glanz_color::Spectrum;
use glanz_color::write::write_csv;
use glanz_picture::output::{OutputError, write_atomically};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

use super::failure::Failure;
use super::stdout::{self, FormatArgs, note};
use crate::args::Target;

/// Writes spectra as columns, by their names. The file is old or new, but never half.
pub(crate) fn save_csv(path: &Path, spectra: &[(&str, &Spectrum)]) -> Result<(), Failure> {
    write_atomically(path, |out| write_csv(out, spectra).map_err(OutputError::Stream))?;
    note(format_args!("wrote {}", path.display()));
    Ok(())
}

/// Tells that a contact sheet was written, and to programs what each picture of it sets and what there is to note.
pub(crate) fn tell_sheet(
    target: &Target,
    (width, height): (usize, usize),
    cells: &[Vec<(String, String)>],
    per_row: usize,
    (format, notes): (FormatArgs, Vec<String>),
) -> Result<(), Failure> {
    let Target::File(path) = target else {
        return Ok(());
    };
    note(format_args!("wrote {}", path.display()));
    if !format.is_json() {
        return Ok(());
    }
    let file = path.display().to_string();
    let cell = |(index, values): (usize, &Vec<(String, String)>)| CellFacts {
        file: file.clone(),
        row: index / per_row,
        column: index % per_row,
        values: values.iter().map(|(path, text)| (path.clone(), ValueFacts::of(text))).collect(),
    };
    let cells = cells.iter().enumerate().map(cell).collect();
    stdout::json(&SheetDocument { file: file.clone(), width, height, cells, notes })
}

/// A sheet of pictures.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SheetDocument {
    /// The sheet's file
    file: String,
    width: usize,
    height: usize,
    /// The pictures, row by row
    cells: Vec<CellFacts>,
    /// What was ignored or changed of the scene's file, and what is odd about the pictures: black, clipped, a mistake
    notes: Vec<String>,
}

/// A picture of a sheet.
#[derive(Debug, Serialize, JsonSchema)]
struct CellFacts {
    /// The file that the picture is in
    file: String,
    /// The row of the sheet, from 0 at the top
    row: usize,
    /// The column of the sheet, from 0 at the left
    column: usize,
    /// What the picture sets, by its path
    values: BTreeMap<String, ValueFacts>,
}

/// A value of the scene.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
enum ValueFacts {
    Number(f64),
    Truth(bool),
    List(Vec<Value>),
    Text(String),
}

impl ValueFacts {
    /// The value that a word of the command line stands for.
    fn of(text: &str) -> Self {
        let number = text.trim().parse::<f64>().ok().filter(|value| value.is_finite());
        match (number, text.trim()) {
            (Some(number), _) => Self::Number(number),
            (_, "true") => Self::Truth(true),
            (_, "false") => Self::Truth(false),
            (_, list) if list.starts_with('[') => {
                serde_json::from_str(list).map_or_else(|_| Self::Text(text.to_owned()), Self::List)
            }
            (_, quoted) => {
                let inner = quoted.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
                Self::Text(inner.unwrap_or(text).to_owned())
            }
        }
    }
}
