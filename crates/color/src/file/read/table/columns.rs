//! One spectrum in each column, beside a column of wavelengths.

use super::Source;
use super::axes::{self, Axis};
use super::head::{Head, QUANTA};
use super::lines::{Cell, Line, Run, cells, unit_behind};
use super::neighbours::check_neighbours;
use super::pieces::longest_piece;
use super::points::Table;
use crate::file::read::error::excerpt;
use crate::file::read::named::note;
use crate::file::read::text::Separator;
use crate::file::read::units::{Column, Scale, terahertz_per_nm};
use crate::file::read::{NamedSpectrum, Place, Quantity, ReadError};

/// Reads the spectra of a run of lines of numbers.
pub(super) fn read(
    source: &Source<'_>,
    separator: Separator,
    run: Run,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let head = Head::of(source, separator, run)?;
    let (mut values, has_unit) = numbers(source, separator, run, head.columns.len());
    let mut notes = Vec::new();
    let axes = axes::find(source, &head, &mut values, has_unit, &mut notes)?;
    let (run, repeated) = longest_piece(source, run, axes[0].column, &mut values);
    check_neighbours(source, separator, run, &head, &axes[0], &values)?;
    source.tell_skipped(&source.content[..head.first], &source.content[run.end..], &mut notes);
    notes.extend(repeated);
    let first_axis = axes[0].column;
    if first_axis > 0 {
        let columns = if first_axis == 1 { "1 column" } else { &*format!("{first_axis} columns") };
        note(&mut notes, format!("{columns} before the wavelengths left out"));
    }
    let mut spectra = spectra(source, run, &head, &axes, &values, &notes)?;
    take_unit(&mut spectra, unit_behind(source.content[run.first].text, separator));
    take_head(&head, &mut spectra);
    name(source, &head, &mut spectra);
    Ok(spectra)
}

/// The numbers of each column, and whether wavelengths have their unit behind them.
fn numbers(source: &Source<'_>, separator: Separator, run: Run, count: usize) -> (Vec<Vec<f64>>, bool) {
    let mut values = vec![Vec::new(); count];
    let mut has_unit = false;
    for line in body(source, run) {
        let row = cells(line.text, separator, count);
        has_unit |= matches!(row.first(), Some(Cell::Nanometres(_)));
        for (column, values) in values.iter_mut().enumerate() {
            values.push(row.get(column).and_then(|cell| cell.value()).unwrap_or(f64::NAN));
        }
    }
    (values, has_unit)
}

/// The unit of values that stands behind each wavelength, as in `380(mW/m2/nm)`.
fn take_unit(spectra: &mut [NamedSpectrum], unit: Option<&str>) {
    let Some(unit) = unit else { return };
    for spectrum in spectra {
        (spectrum.unit, spectrum.quantity) = (unit.to_owned(), Quantity::Light);
    }
}

/// The lines of a run.
fn body<'a>(source: &Source<'a>, run: Run) -> impl Iterator<Item = &'a Line<'a>> {
    source.content[run.first..run.end].iter().filter(|line| !line.is_comment)
}

/// The spectra of the columns, each by the column of wavelengths before it.
fn spectra(
    source: &Source<'_>,
    run: Run,
    head: &Head,
    axes: &[Axis],
    values: &[Vec<f64>],
    notes: &[String],
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let lines: Vec<u64> = body(source, run).map(|line| line.number).collect();
    let mut spectra = Vec::new();
    let mut empty = Vec::new();
    for column in axes[0].column + 1..values.len() {
        if axes.iter().any(|axis| axis.column == column) {
            continue;
        }
        let axis = axes.iter().rev().find(|axis| axis.column < column).unwrap_or(&axes[0]);
        let said = head.column(column);
        let mut spectrum = begun(&said, notes);
        let table = Table { source, lines: &lines, scale: axis.scale };
        table.fill(&mut spectrum, &values[axis.column], &values[column])?;
        if spectrum.nm.is_empty() {
            empty.push(spectrum.name);
            continue;
        }
        settle_column(&mut spectrum, &said, axis.scale);
        spectra.push(spectrum);
    }
    if spectra.is_empty() {
        return Err(ReadError::malformed(source.file, Place::File, "at least one value", "none"));
    }
    for name in empty.iter().filter(|name| !name.is_empty()).take(4) {
        let text = format!("column {} has no values", excerpt(name));
        spectra.iter_mut().for_each(|spectrum| note(&mut spectrum.notes, text.clone()));
    }
    Ok(spectra)
}

/// A spectrum of which its column's header is known alone.
fn begun(said: &Column, notes: &[String]) -> NamedSpectrum {
    let (name, unit, notes) = (said.name.clone(), said.unit.clone(), notes.to_vec());
    NamedSpectrum { name, quantity: said.quantity, unit, notes, ..Default::default() }
}

/// What the head says of spectra that say nothing themselves.
fn take_head(head: &Head, spectra: &mut [NamedSpectrum]) {
    if head.is_quantum {
        for spectrum in spectra.iter_mut().filter(|one| one.unit.is_empty() && !one.quantity.is_ratio()) {
            spectrum.unit = QUANTA.to_owned();
            spectrum.quantity = Quantity::Light;
        }
    }
    // What the head says is of all columns, unless these tell themselves apart.
    if spectra.iter().all(|spectrum| spectrum.quantity == Quantity::Unknown) {
        spectra.iter_mut().for_each(|spectrum| spectrum.quantity = head.quantity);
    }
}

/// Gives names to spectra that have none.
fn name(source: &Source<'_>, head: &Head, spectra: &mut [NamedSpectrum]) {
    let count = spectra.len();
    for (index, spectrum) in spectra.iter_mut().enumerate() {
        if spectrum.name.is_empty() || head.title.is_some() {
            spectrum.name = source.unnamed(index, count);
        }
    }
}

/// Brings the values of a column to densities per nm, and tells what is taken for granted.
pub(super) fn settle_column(spectrum: &mut NamedSpectrum, column: &Column, scale: Scale) {
    if scale == Scale::Unknown {
        note(&mut spectrum.notes, "no unit of wavelength given: taken as nm");
    }
    if column.is_per_terahertz() {
        for (value, nm) in spectrum.values.iter_mut().zip(&spectrum.nm) {
            *value *= terahertz_per_nm(*nm);
        }
        note(&mut spectrum.notes, "densities per THz converted to densities per nm");
    } else if scale.is_inverse() && !spectrum.quantity.is_ratio() && !column.is_percent() {
        note(
            &mut spectrum.notes,
            "values over frequency taken as densities per nm, since no unit says per THz",
        );
    }
}
