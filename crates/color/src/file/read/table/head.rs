//! What stands above the numbers of a table: names, quantities and units of its columns.

use super::Source;
use super::lines::{Cell, Line, Run};
use crate::file::read::text::{Separator, fields};
use crate::file::read::units::{Column, Scale, names_scale};
use crate::file::read::{PowerUnit, Quantity, ReadError};

/// Beginnings of headers of wavelengths, in several languages.
const AXES: [&str; 14] = [
    "wave",
    "lambda",
    "λ",
    "longueur",
    "wellenl",
    "lunghezza",
    "longitud",
    "frequency",
    "freq",
    "energy",
    "ν",
    "wl ",
    "band center",
    "center w",
];
/// What stands above the numbers.
pub(super) struct Head {
    /// The place of its first line that is understood.
    pub(super) first: usize,
    /// What is said of each column, the wavelengths' too.
    pub(super) columns: Vec<String>,
    /// What is said of all columns, in a line that is no row of headers.
    pub(super) title: Option<String>,
    /// The quantity that other lines name.
    pub(super) quantity: Quantity,
    /// The unit of wavelengths that other lines name.
    pub(super) scale: Scale,
    /// Whether it says that the values are photons, as LI-COR's LI-1800 does.
    pub(super) is_quantum: bool,
}

/// Programs whose heads name no columns: a mark of the head, and the columns. The SIG format of Spectra
/// Vista: its last column is 100 times the third by the second; the R package spectrolab (Meireles and Schweiger) reads it so.
const KNOWN: [(&str, [&str; 4]); 1] =
    [("Spectra Vista SIG Data", ["Wavelength (nm)", "Reference", "Target", "Reflectance (%)"])];

/// The unit of the LI-1800 where its head says `QNTM`.
pub(super) const QUANTA: &str = "umol/m2/s/nm";

impl Head {
    pub(super) fn of(source: &Source<'_>, separator: Separator, run: Run) -> Result<Self, ReadError> {
        let above = &source.content[..run.first];
        let line = source.content[run.first].number;
        let known = KNOWN.iter().find(|(mark, names)| {
            names.len() == run.width && above.first().is_some_and(|line| line.text.contains(mark))
        });
        let row = |line: &Line<'_>| headers(line, separator, run);
        let (mut first, mut columns, mut title) = (run.first, None, None);
        if let Some((last, rest)) = above.split_last() {
            first = run.first - 1;
            columns = row(last);
            // A row of units under the row of names.
            let names = columns.as_ref().filter(|units| units.iter().all(|field| is_unit(field)));
            if let (Some(units), Some(names)) = (names, rest.last().and_then(row)) {
                first = run.first - 2;
                columns = Some(joined(&names, units));
            }
            if columns.is_none() {
                title = Some(last.text.to_owned());
            }
        }
        if let Some((_, names)) = known {
            (columns, title) = (Some(names.map(str::to_owned).to_vec()), None);
        }
        let count = columns.as_ref().map_or(run.width, Vec::len).max(run.width);
        source.check_count(count.saturating_sub(1), line)?;
        let mut columns = columns.unwrap_or_default();
        columns.resize(count, String::new());
        let others = above.iter().filter(|line| names_axis(line.text) || is_unit(line.text));
        let scale = others.map(|line| Scale::of(line.text)).find(|scale| *scale != Scale::Unknown);
        let (quantity, scale) = (source.quantity_of(above), scale.unwrap_or_default());
        let is_quantum = above.iter().any(|line| line.text.contains("QNTM"));
        Ok(Self { first, columns, title, quantity, scale, is_quantum })
    }

    /// What is said of a column.
    pub(super) fn column(&self, index: usize) -> Column {
        match &self.title {
            Some(title) => Column { name: String::new(), ..Column::of(title) },
            None => Column::of(&self.columns[index]),
        }
    }

    pub(super) fn axis_header(&self, index: usize) -> &str {
        self.title.as_deref().unwrap_or(&self.columns[index])
    }
}

/// The fields of a line as headers of the columns, if it has as many.
fn headers(line: &Line<'_>, separator: Separator, run: Run) -> Option<Vec<String>> {
    let split = |separator| -> Vec<String> { fields(line.text, separator).map(str::to_owned).collect() };
    let own = split(separator);
    let fits = |fields: &[String]| match separator {
        Separator::Blanks => fields.len() == run.width,
        Separator::Char(_) => fields.len() > 1 && (fields.len() >= run.width || names_axis(&fields[0])),
    };
    // Numbers behind a word that is no axis are a value of the head, such as `IRR 2.6`.
    let is_pair = |fields: &[String]| {
        let is_number = |field: &String| !matches!(Cell::of(field, separator), Cell::Word);
        !names_axis(&fields[0]) && fields.len() > 1 && fields[1..].iter().all(is_number)
    };
    // A line that begins with a number is one of values, not of headers.
    let begins_with_number = |fields: &[String]| matches!(Cell::of(&fields[0], separator), Cell::Number(_));
    if fits(&own) && !is_pair(&own) && !begins_with_number(&own) {
        return Some(own);
    }
    // The head may be separated otherwise than the numbers.
    let other = Separator::of(line.text);
    Some(split(other)).filter(|fields| other != separator && fields.len() == run.width && fields.len() > 1)
}

/// Whether a field is a unit and no more: `nm`, `(nm)`, `[%]`, `W/m²/nm`, or nothing.
fn is_unit(field: &str) -> bool {
    let field = field.trim();
    if field.starts_with('[') && field.ends_with(']') {
        return true;
    }
    let bare = field.trim_start_matches('(').trim_end_matches(')').trim();
    bare.is_empty() || names_scale(bare) || bare == "%" || PowerUnit::parse(bare).is_some()
}

/// Names with their units behind them.
fn joined(names: &[String], units: &[String]) -> Vec<String> {
    let unit =
        |index: usize| units.get(index).map_or("", |unit| unit.trim_matches(['(', ')', '[', ']', ' ']));
    let with_unit = |(index, name): (usize, &String)| match unit(index) {
        "" => name.clone(),
        unit => format!("{name} ({unit})"),
    };
    names.iter().enumerate().map(with_unit).collect()
}

/// Whether a header is that of wavelengths.
pub(super) fn names_axis(header: &str) -> bool {
    let lower = header.trim().to_lowercase().replace('μ', "µ");
    let bare = lower.trim_matches(['(', ')', '[', ']', '"', ' ']);
    AXES.iter().any(|word| bare.starts_with(word))
        || bare == "wl"
        || names_scale(bare)
        || lower.contains("wavelength")
}
