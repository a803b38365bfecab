//! One spectrum in each row, under a row of wavelengths.

use super::axes::is_in_micrometres;
use super::lines::{Cell, Line, cells};
use super::{MOST_SPECTRA, Source, is_of_light, stem};
use crate::file::read::error::{clean, excerpt};
use crate::file::read::named::note;
use crate::file::read::text::{Separator, fields};
use crate::file::read::units::{Column, LIKELY_NM, MAX_NAME, Scale};
use crate::file::read::{NamedSpectrum, Place, Quantity, ReadError};

/// A row of wavelengths, and what follows it.
pub(super) struct Rows {
    /// The place of the row of wavelengths among the lines.
    head: usize,
    separator: Separator,
    /// How many fields stand before the first wavelength.
    first: usize,
    nm: Vec<f64>,
    /// Whether a wavelength has its unit behind it.
    has_unit: bool,
    /// Whether they stand there in µm.
    is_um: bool,
}

/// The first row of wavelengths that has a row of as many numbers below it.
pub(super) fn find(content: &[Line<'_>], unit: Option<Scale>) -> Option<Rows> {
    for (at, line) in content.iter().enumerate() {
        for separator in Separator::ALL {
            let Some(rows) = wavelengths(at, line, separator, unit) else { continue };
            let below = content[at + 1..].iter().find(|line| !line.is_comment);
            if below.is_some_and(|line| rows.holds(line)) {
                return Some(rows);
            }
        }
    }
    None
}

/// The most wavelengths in µm of a row that are looked at.
const LIKELY_UM: core::ops::RangeInclusive<f64> = 0.1..=30.0;

/// A line as a row of wavelengths: words, then wavelengths that only rise or only fall, then maybe words.
fn wavelengths(at: usize, line: &Line<'_>, separator: Separator, unit: Option<Scale>) -> Option<Rows> {
    let (mut first, mut nm, mut has_unit) = (None, Vec::new(), false);
    for (index, field) in fields(line.text, separator).enumerate() {
        match (wavelength(field, separator), first) {
            (Some((value, unit)), _) if LIKELY_NM.contains(&value) || LIKELY_UM.contains(&value) => {
                first.get_or_insert(index);
                nm.push(value);
                has_unit |= unit;
            }
            (None, None) if nm.len() <= MOST_SPECTRA => {}
            (None, Some(_)) => break,
            _ => return None,
        }
    }
    let first = first.filter(|first| *first > 0)?;
    let is_um = matches!(unit, None | Some(Scale::Micrometres)) && !has_unit && is_in_micrometres(&nm);
    if is_um {
        nm.iter_mut().for_each(|nm| *nm = Scale::Micrometres.convert(*nm));
    }
    let is_likely = nm.iter().all(|nm| LIKELY_NM.contains(nm));
    let rises = nm.windows(2).all(|pair| pair[0] < pair[1]);
    let falls = nm.windows(2).all(|pair| pair[0] > pair[1]);
    let found = Rows { head: at, separator, first, nm, has_unit, is_um };
    (found.nm.len() > 1 && is_likely && (rises || falls)).then_some(found)
}

/// A wavelength of the head, with whether its unit is there: `400`, `400nm`, `R400`, `SPEC_400`, `R_400nm`.
fn wavelength(field: &str, separator: Separator) -> Option<(f64, bool)> {
    match Cell::of(field, separator) {
        Cell::Number(value) => return Some((value, false)),
        Cell::Nanometres(value) => return Some((value, true)),
        Cell::Missing => return None,
        Cell::Word => {}
    }
    let start = field.find(|c: char| c.is_ascii_digit())?;
    let is_prefix = field[..start].chars().all(|c| c.is_ascii_alphabetic() || "_ %".contains(c));
    match Cell::of(&field[start..], separator) {
        Cell::Number(value) if is_prefix => Some((value, false)),
        _ => None,
    }
}

impl Rows {
    /// How many wavelengths there are.
    pub(super) fn wavelengths(&self) -> usize {
        self.nm.len()
    }

    /// The place of the line below the wavelengths.
    pub(super) fn below(&self) -> usize {
        self.head + 1
    }

    /// Whether a line has a number where its first value should be, and no word where values are.
    fn holds(&self, line: &Line<'_>) -> bool {
        let row = self.values(line);
        let has_value = row.iter().any(|cell| cell.value().is_some());
        (has_value || row.len() == self.nm.len()) && !row.contains(&Cell::Word)
    }

    /// The cells of a line below the wavelengths.
    fn values(&self, line: &Line<'_>) -> Vec<Cell> {
        let row = cells(line.text, self.separator, self.first + self.nm.len());
        row.into_iter().skip(self.first).take(self.nm.len()).collect()
    }

    /// Reads all rows.
    pub(super) fn read(&self, source: &Source<'_>) -> Result<Vec<NamedSpectrum>, ReadError> {
        let head = &source.content[self.head];
        let fields_of_head: Vec<&str> = fields(head.text, self.separator).take(self.first).collect();
        let corners: Vec<Column> = fields_of_head.iter().map(|field| Column::of(field)).collect();
        let mut notes = Vec::new();
        let mut spectra: Vec<NamedSpectrum> = Vec::new();
        let mut foot = &source.content[source.content.len()..];
        for (at, line) in
            source.content.iter().enumerate().skip(self.head + 1).filter(|(_, line)| !line.is_comment)
        {
            let row = self.values(line);
            if self.is_foot(&row) {
                foot = &source.content[at..];
                break;
            }
            let name = self.name(line, &corners, source, spectra.len());
            let quantity = self.quantity(line);
            spectra.push(NamedSpectrum { quantity, ..self.spectrum(source, line, &row, name)? });
            source.check_count(spectra.len(), line.number)?;
        }
        source.tell_skipped(&source.content[..self.head], foot, &mut notes);
        let scale = Scale::of(head.text);
        if self.is_um {
            note(&mut notes, "wavelengths taken as µm, since in nm they were X-rays");
        } else if scale == Scale::Unknown && !self.has_unit && source.unit.is_none() {
            note(&mut notes, "no unit of wavelength given: taken as nm");
        }
        let quantity = self.quantity_of_all(source, &corners);
        let unit = corners.iter().map(|one| one.unit.as_str()).find(|unit| !unit.is_empty()).unwrap_or("");
        for spectrum in &mut spectra {
            if spectrum.quantity == Quantity::Unknown {
                spectrum.quantity = quantity;
            }
            spectrum.unit = unit.to_owned();
            spectrum.notes.splice(0..0, notes.iter().cloned());
        }
        Ok(spectra)
    }

    /// What the line of wavelengths says of all rows, or the lines above it.
    fn quantity_of_all(&self, source: &Source<'_>, corners: &[Column]) -> Quantity {
        let head = &source.content[self.head];
        let of_light = fields(head.text, self.separator).take(self.first).filter(|field| is_of_light(field));
        match corners.iter().find(|column| column.quantity != Quantity::Unknown) {
            Some(one) => one.quantity,
            // Only light has an illuminance and a colour temperature.
            None if of_light.count() >= 2 => Quantity::Light,
            None => source.quantity_of(&source.content[..=self.head]),
        }
    }

    /// Whether a line below the rows is none of them: it has no value where they have theirs.
    fn is_foot(&self, row: &[Cell]) -> bool {
        row.iter().all(|cell| cell.value().is_none())
            && (row.len() < self.nm.len() || row.contains(&Cell::Word))
    }

    /// What a row says that it is: a field before its values that is a quantity and nothing else, such as `Reflectance`.
    fn quantity(&self, line: &Line<'_>) -> Quantity {
        let mut said = fields(line.text, self.separator).take(self.first).map(Quantity::alone);
        said.find(|quantity| *quantity != Quantity::Unknown).unwrap_or_default()
    }

    /// The name of a row: its words, or one made from the file's name.
    fn name(&self, line: &Line<'_>, corners: &[Column], source: &Source<'_>, index: usize) -> String {
        let fields = fields(line.text, self.separator).take(self.first);
        let words: Vec<&str> = match corners.len() {
            // The only field is the name, even if it is a number.
            1 => fields.collect(),
            _ => fields.filter(|field| Cell::of(field, self.separator) == Cell::Word).collect(),
        };
        match words.join(" ").trim() {
            "" => format!("{} {}", stem(source.file), index + 1),
            name => clean(name, MAX_NAME),
        }
    }

    /// The spectrum of a row.
    fn spectrum(
        &self,
        source: &Source<'_>,
        line: &Line<'_>,
        row: &[Cell],
        name: String,
    ) -> Result<NamedSpectrum, ReadError> {
        if let Some(word) = row.iter().position(|cell| *cell == Cell::Word) {
            let text = fields(line.text, self.separator).nth(self.first + word).unwrap_or_default();
            let place = Place::Field { line: line.number, field: (self.first + word) as u64 + 1 };
            return Err(ReadError::malformed(
                source.file,
                place,
                "a number from -1e30 to 1e30",
                excerpt(text),
            ));
        }
        let points = self.nm.iter().zip(row).filter_map(|(nm, cell)| Some((*nm, cell.value()?)));
        let (mut nm, mut values): (Vec<f64>, Vec<f64>) = points.unzip();
        if nm.is_empty() {
            let found = format!("none for {}", excerpt(&name));
            return Err(ReadError::malformed(
                source.file,
                Place::Line(line.number),
                "at least one value",
                found,
            ));
        }
        if nm.first() > nm.last() {
            nm.reverse();
            values.reverse();
        }
        Ok(NamedSpectrum { name, nm, values, ..Default::default() })
    }
}
