//! One spectrum in each column, beside a column of wavelengths.

use super::lines::{Cell, Line, Run, cells};
use super::pieces::longest_piece;
use super::{MOST_SPECTRA, Source};
use crate::file::read::error::excerpt;
use crate::file::read::named::note;
use crate::file::read::text::{Separator, fields};
use crate::file::read::units::{Column, LIKELY_NM, Scale, terahertz_per_nm};
use crate::file::read::{NamedSpectrum, Place, PowerUnit, Quantity, ReadError};
use crate::spectra::{FIRST_NM, LAST_NM};

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
/// Headers of wavelengths that are short.
const SHORT_AXES: [&str; 8] = ["nm", "um", "µm", "wl", "thz", "ev", "cm-1", "nanometers"];

/// Reads the spectra of a run of lines of numbers.
pub(super) fn read(
    source: &Source<'_>,
    separator: Separator,
    run: Run,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let head = Head::of(source, separator, run)?;
    let mut values = vec![Vec::new(); head.columns.len()];
    let mut has_unit = false;
    for line in body(source, run) {
        let row = cells(line.text, separator, head.columns.len());
        has_unit |= matches!(row.first(), Some(Cell::Nanometres(_)));
        for (column, values) in values.iter_mut().enumerate() {
            values.push(row.get(column).and_then(|cell| cell.value()).unwrap_or(f64::NAN));
        }
    }
    let axes = axes(source, &head, &values, has_unit)?;
    let (run, repeated) = longest_piece(source, run, axes[0].column, &mut values);
    check_neighbours(source, separator, run, &head, &axes[0], &values)?;
    let mut notes = Vec::new();
    source.tell_skipped(&source.content[..head.first], &source.content[run.end..], &mut notes);
    notes.extend(repeated);
    let first_axis = axes[0].column;
    if first_axis > 0 {
        let columns = if first_axis == 1 { "1 column" } else { &*format!("{first_axis} columns") };
        note(&mut notes, format!("{columns} before the wavelengths left out"));
    }
    let mut spectra = spectra(source, run, &head, &axes, &values, &notes)?;
    name(source, &head, &mut spectra);
    Ok(spectra)
}

/// The lines of a run.
fn body<'a>(source: &Source<'a>, run: Run) -> impl Iterator<Item = &'a Line<'a>> {
    source.content[run.first..run.end].iter().filter(|line| !line.is_comment)
}

/// What stands above the numbers.
struct Head {
    /// The place of its first line that is understood.
    first: usize,
    /// What is said of each column, the wavelengths' too.
    columns: Vec<String>,
    /// What is said of all columns, in a line that is no row of headers.
    title: Option<String>,
    /// The quantity that other lines name.
    quantity: Quantity,
    /// The unit of wavelengths that other lines name.
    scale: Scale,
    /// Whether it says that the values are photons, as LI-COR's LI-1800 does.
    is_quantum: bool,
}

/// The unit of the LI-1800 where its head says `QNTM`.
const QUANTA: &str = "umol/m2/s/nm";

impl Head {
    fn of(source: &Source<'_>, separator: Separator, run: Run) -> Result<Self, ReadError> {
        let above = &source.content[..run.first];
        let line = source.content[run.first].number;
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
    fn column(&self, index: usize) -> Column {
        match &self.title {
            Some(title) => Column { name: String::new(), ..Column::of(title) },
            None => Column::of(&self.columns[index]),
        }
    }

    fn axis_header(&self, index: usize) -> &str {
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
    if fits(&own) && !is_pair(&own) {
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
    let is_scale = SHORT_AXES.iter().any(|unit| bare.eq_ignore_ascii_case(unit));
    bare.is_empty() || is_scale || bare == "%" || PowerUnit::parse(bare).is_some()
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
fn names_axis(header: &str) -> bool {
    let lower = header.trim().to_lowercase().replace('μ', "µ");
    let bare = lower.trim_matches(['(', ')', '[', ']', '"', ' ']);
    AXES.iter().any(|word| bare.starts_with(word))
        || SHORT_AXES.contains(&bare)
        || lower.contains("wavelength")
}

/// A column of wavelengths.
struct Axis {
    column: usize,
    scale: Scale,
}

/// The columns of wavelengths: those whose header says so, else the first one whose numbers can be.
fn axes(
    source: &Source<'_>,
    head: &Head,
    values: &[Vec<f64>],
    has_unit: bool,
) -> Result<Vec<Axis>, ReadError> {
    let scale = |column: usize| -> Result<Scale, ReadError> {
        if let Some(unit) = source.unit {
            return Ok(unit);
        }
        let said = Scale::of_axis(head.axis_header(column)).or_else(|unit| match head.title {
            // The brackets of a title may hold anything.
            Some(_) => Ok(Scale::Unknown),
            None => Err(unit),
        });
        let said = said.map_err(|unit| {
            let expected = "a unit of wavelength: nm, µm, m, Å, cm⁻¹, THz, Hz or eV";
            ReadError::malformed(source.file, Place::File, expected, excerpt(&unit))
        })?;
        Ok(match said {
            Scale::Unknown if has_unit => Scale::Nanometres,
            Scale::Unknown => head.scale,
            scale => scale,
        })
    };
    let named = (0..values.len()).filter(|column| head.title.is_none() && names_axis(&head.columns[*column]));
    let mut named: Vec<usize> =
        named.filter(|column| values[*column].iter().any(|v| v.is_finite())).collect();
    if named.last() == Some(&(values.len() - 1)) {
        // A last column has no values behind it: its header names a wavelength for another reason.
        named.pop();
    }
    if named.is_empty() {
        let found = (0..values.len().saturating_sub(1)).find_map(|column| {
            let scale = scale(column).ok()?;
            is_axis(&values[column], scale).then_some(column)
        });
        named.push(found.unwrap_or(0));
    }
    named.into_iter().map(|column| Ok(Axis { column, scale: scale(column)? })).collect()
}

/// Whether numbers can be wavelengths: they only rise or only fall, and lie where wavelengths do.
fn is_axis(values: &[f64], scale: Scale) -> bool {
    let known = || values.iter().copied().filter(|value| value.is_finite());
    let pairs = || known().zip(known().skip(1));
    let ordered = pairs().all(|(a, b)| a < b) || pairs().all(|(a, b)| a > b);
    ordered && known().next().is_some() && known().all(|value| scale.is_likely(value))
}

/// One line too wide, or with a word in it, in the middle of a table must not end it silently.
fn check_neighbours(
    source: &Source<'_>,
    separator: Separator,
    run: Run,
    head: &Head,
    axis: &Axis,
    values: &[Vec<f64>],
) -> Result<(), ReadError> {
    let known: Vec<f64> = values[axis.column].iter().copied().filter(|value| value.is_finite()).collect();
    let (Some(&first), Some(&last)) = (known.first(), known.last()) else { return Ok(()) };
    let step = (last - first).abs() / (known.len() - 1).max(1) as f64;
    // Wavelengths a few steps beyond an end belong to the table; where it has no steps, all that may be wavelengths.
    let continues = |value: f64, beyond: f64| match last - first {
        0.0 => value != first && axis.scale.is_likely(value),
        way => {
            let end = if beyond > 0.0 { last } else { first };
            (0.0..=20.0 * step).contains(&(beyond * way.signum() * (value - end)))
        }
    };
    let before = source.content[..run.first].iter().rev().find(|line| !line.is_comment);
    let after = source.content[run.end..].iter().find(|line| !line.is_comment);
    for (line, beyond) in [(before, -1.0), (after, 1.0)] {
        let Some(line) = line else { continue };
        let row = cells(line.text, separator, head.columns.len());
        let wavelength = row.get(axis.column).and_then(|cell| cell.value());
        if wavelength.is_some_and(|value| continues(value, beyond)) {
            check_row(source, separator, line, &row, run.width.max(head.columns.len()))?;
        }
    }
    Ok(())
}

/// Tells what is wrong with a line that should be one of numbers.
fn check_row(
    source: &Source<'_>,
    separator: Separator,
    line: &Line<'_>,
    row: &[Cell],
    width: usize,
) -> Result<(), ReadError> {
    if row.len() < 2 {
        return Err(ReadError::malformed(
            source.file,
            Place::Line(line.number),
            "a wavelength and at least one value",
            "one field",
        ));
    }
    if let Some(word) = row.iter().position(|cell| *cell == Cell::Word) {
        let text = fields(line.text, separator).nth(word).unwrap_or_default();
        let place = Place::Field { line: line.number, field: word as u64 + 1 };
        return Err(ReadError::malformed(source.file, place, "a number from -1e30 to 1e30", excerpt(text)));
    }
    let (expected, found) = match row.len() > width {
        true => (format!("at most {width} fields"), "more".to_owned()),
        false => (format!("{width} fields"), row.len().to_string()),
    };
    Err(ReadError::malformed(source.file, Place::Line(line.number), expected, found))
}

/// Why there is no table: the first line that begins like one tells, if there is one.
pub(super) fn no_numbers(source: &Source<'_>) -> ReadError {
    for line in source.content.iter().filter(|line| !line.is_comment) {
        let separator = Separator::of(line.text);
        let row = cells(line.text, separator, MOST_SPECTRA);
        let begins = row.first().and_then(|cell| cell.value()).is_some_and(|nm| LIKELY_NM.contains(&nm));
        if begins && let Err(error) = check_row(source, separator, line, &row, row.len()) {
            return error;
        }
    }
    let found = if source.content.is_empty() { "an empty file" } else { "none" };
    ReadError::malformed(source.file, Place::File, "lines of wavelengths and values", found)
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
        let mut spectrum = NamedSpectrum {
            name: said.name.clone(),
            quantity: said.quantity,
            unit: said.unit.clone(),
            notes: notes.to_vec(),
            ..Default::default()
        };
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
    for name in empty.iter().filter(|name| !name.is_empty()).take(4) {
        let text = format!("column {} has no values", excerpt(name));
        spectra.iter_mut().for_each(|spectrum| note(&mut spectrum.notes, text.clone()));
    }
    Ok(spectra)
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

/// Where the numbers of a spectrum come from.
struct Table<'a> {
    source: &'a Source<'a>,
    /// The lines' numbers in the file.
    lines: &'a [u64],
    scale: Scale,
}

impl Table<'_> {
    /// Gives a spectrum its points, by rising wavelength.
    fn fill(&self, spectrum: &mut NamedSpectrum, axis: &[f64], values: &[f64]) -> Result<(), ReadError> {
        let mut points = Vec::with_capacity(values.len());
        let mut without = 0;
        for ((number, value), line) in axis.iter().zip(values).zip(self.lines) {
            match (number.is_finite(), value.is_finite()) {
                (true, true) => {
                    let nm = self
                        .scale
                        .nm(*number, self.source.file, || Place::Field { line: *line, field: 1 })?;
                    points.push((nm, *value, *line));
                }
                (false, true) => without += 1,
                (_, false) => {}
            }
        }
        if without > 0 {
            note(&mut spectrum.notes, format!("{without} values without a wavelength are left out"));
        }
        if points.first().zip(points.last()).is_some_and(|(first, last)| first.0 > last.0) {
            points.reverse();
        }
        let points = self.merged(self.ordered(points, &mut spectrum.notes)?, &mut spectrum.notes);
        (spectrum.nm, spectrum.values) = points.into_iter().map(|(nm, value, _)| (nm, value)).unzip();
        Ok(())
    }

    /// Wavelengths must rise, or fall, where they are used; beyond the visible band those that do not are left out.
    fn ordered(&self, points: Vec<Point>, notes: &mut Vec<String>) -> Result<Vec<Point>, ReadError> {
        let wrong = |points: &[Point]| points.windows(2).position(|pair| pair[0].0 > pair[1].0);
        if wrong(&points).is_none() {
            return Ok(points);
        }
        let in_band = |point: &Point| (FIRST_NM..=LAST_NM).contains(&point.0);
        let kept: Vec<Point> = points.iter().copied().filter(in_band).collect();
        match wrong(&kept) {
            None if kept.len() > 1 => {
                let left_out = points.len() - kept.len();
                note(notes, format!("{left_out} values beyond 300 to 780 nm are out of order and left out"));
                Ok(kept)
            }
            _ => {
                let at = wrong(&points).unwrap_or_default();
                let ((a, _, line), (b, _, other)) = (points[at], points[at + 1]);
                let (a, b, line) = if line < other { (a, b, other) } else { (b, a, line) };
                let order = if points[0].2 < points[points.len() - 1].2 { "rising" } else { "falling" };
                let found = format!("{b} nm after {a} nm");
                let expected = format!("wavelengths in {order} order, each once");
                Err(ReadError::malformed(self.source.file, Place::Line(line), expected, found))
            }
        }
    }

    /// Each wavelength once: of several values the mean.
    fn merged(&self, points: Vec<Point>, notes: &mut Vec<String>) -> Vec<Point> {
        let mut merged: Vec<Point> = Vec::with_capacity(points.len());
        let (mut twice, mut same) = (0, 1.0);
        for point in points {
            match merged.last_mut() {
                Some(last) if last.0 == point.0 => {
                    (twice, same) = (twice + 1, same + 1.0);
                    last.1 += (point.1 - last.1) / same;
                }
                _ => {
                    same = 1.0;
                    merged.push(point);
                }
            }
        }
        if twice > 0 {
            note(
                notes,
                format!("{twice} wavelengths stand there more than once: the mean of their values is taken"),
            );
        }
        merged
    }
}

/// A wavelength in nm, a value, and its line.
type Point = (f64, f64, u64);

/// Brings the values of a column to densities per nm, and tells what is taken for granted.
fn settle_column(spectrum: &mut NamedSpectrum, column: &Column, scale: Scale) {
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
