//! Pictures that differ in values: every combination, in rows and columns with words to them.

use serde_json::json;

use super::args::Target;
use super::failure::Failure;
use super::print::{self, FormatArgs};
use super::sheet::Sheet;
use super::vary::{Vary, short_names};

/// The most pictures on a sheet.
const MAX_PICTURES: usize = 10_000;

/// Every combination of values; the last one runs along the columns.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a> {
    /// What varies.
    pub vary: &'a [Vary],
    /// Pictures per row where one value alone varies.
    pub columns: usize,
    /// Width and height of each picture, in pixels.
    pub cell: (u32, u32),
}

impl Grid<'_> {
    /// What each picture sets, in the order of the sheet.
    pub fn cells(&self) -> Result<Vec<Vec<(String, String)>>, Failure> {
        let count = self.vary.iter().try_fold(1_usize, |count, vary| count.checked_mul(vary.values.len()));
        let count = count.filter(|count| *count <= MAX_PICTURES);
        let count = count.ok_or_else(|| {
            Failure::Usage(format!("a sheet of more than {MAX_PICTURES} pictures is too large"))
        })?;
        Ok((0..count).map(|index| self.values(index)).collect())
    }

    /// What picture `index` sets: the last value runs fastest.
    fn values(&self, index: usize) -> Vec<(String, String)> {
        let mut rest = index;
        let mut values: Vec<_> = self
            .vary
            .iter()
            .rev()
            .map(|vary| {
                let value = vary.values[rest % vary.values.len()].clone();
                rest /= vary.values.len();
                (vary.path.clone(), value)
            })
            .collect();
        values.reverse();
        values
    }

    /// The sheet of `count` pictures: captions where one value varies, else words at rows and columns.
    pub fn sheet(&self, count: usize) -> Sheet {
        let paths: Vec<_> = self.vary.iter().map(|vary| vary.path.as_str()).collect();
        let names = short_names(&paths);
        let label = |which: usize, value: &str| format!("{} = {value}", names[which]);
        let cell = (self.cell.0 as usize, self.cell.1 as usize);
        if let [vary] = self.vary {
            let captions = vary.values.iter().map(|value| vec![label(0, value)]).collect();
            let per_row = count.min(self.columns);
            return Sheet { captions, per_row, count, cell, ..Sheet::default() };
        }
        let last = self.vary.len() - 1;
        let per_row = self.vary[last].values.len();
        let columns = self.vary[last].values.iter().map(|value| label(last, value)).collect();
        let row = |index: usize| {
            let values = self.values(index * per_row);
            let lines = values[..last].iter().enumerate().map(|(which, (_, value))| label(which, value));
            lines.collect::<Vec<_>>().join("\n")
        };
        let rows = (0..count / per_row).map(row).collect();
        Sheet { columns, rows, per_row, count, cell, ..Sheet::default() }
    }
}

/// Tells that a sheet was written, and to programs what each picture of it sets.
pub fn tell(
    target: &Target,
    (width, height): (usize, usize),
    cells: &[Vec<(String, String)>],
    format: FormatArgs,
) -> Result<(), Failure> {
    let Target::File(path) = target else {
        return Ok(());
    };
    print::note(format_args!("wrote {}", path.display()));
    if !format.is_json() {
        return Ok(());
    }
    let cell = |values: &Vec<(String, String)>| -> serde_json::Map<_, _> {
        values.iter().map(|(path, value)| (path.clone(), value.clone().into())).collect()
    };
    let cells: Vec<_> = cells.iter().map(cell).collect();
    let path = path.display().to_string();
    print::json(&json!({ "file": path, "width": width, "height": height, "cells": cells }))
}
