//! One spectrum in each row, under a row of wavelengths.

use super::axes::is_in_micrometres;
use super::columns::settle_column;
use super::head::names_axis;
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
    /// The unit of the wavelengths; unknown where nothing says it.
    scale: Scale,
    /// Whether they are taken for µm, though nothing says it.
    is_um: bool,
}

/// Fewer wavelengths may be a line of a table that begins with a word, such as a date.
const FEWEST_SURE: usize = 6;

/// The first row of wavelengths that has a row of as many numbers below it.
pub(super) fn find(content: &[Line<'_>], unit: Option<Scale>) -> Option<Rows> {
    // What a line above the wavelengths says of their unit.
    let mut above = Scale::Unknown;
    for (at, line) in content.iter().enumerate() {
        for separator in Separator::ALL {
            let Some(rows) = wavelengths(at, line, separator, unit, above) else { continue };
            let below = content[at + 1..].iter().find(|line| !line.is_comment);
            let is_said = above == Scale::Unknown && rows.scale != Scale::Unknown;
            let is_head = |line| is_said || rows.nm.len() >= FEWEST_SURE || !rows.is_like(line, unit, above);
            if below.is_some_and(|line| rows.holds(line) && is_head(line)) {
                return Some(rows);
            }
        }
        if above == Scale::Unknown && names_axis(line.text) {
            above = Scale::of(line.text);
        }
    }
    None
}

/// A line as a row of wavelengths: words, then wavelengths that only rise or only fall, then maybe words. Their unit is that of
/// the caller, else what the words before them say, else what is said above.
fn wavelengths(
    at: usize,
    line: &Line<'_>,
    separator: Separator,
    unit: Option<Scale>,
    above: Scale,
) -> Option<Rows> {
    let (mut first, mut numbers, mut has_unit) = (None, Vec::new(), false);
    let mut said = unit.unwrap_or_default();
    let mut is_axis = unit.is_some();
    for (index, field) in fields(line.text, separator).enumerate() {
        match (wavelength(field, separator), first) {
            (Some((value, unit)), _) if value > 0.0 => {
                first.get_or_insert(index);
                numbers.push(value);
                has_unit |= unit;
            }
            (None, None) if index <= MOST_SPECTRA => {
                if said == Scale::Unknown && names_axis(field) && !is_of_light(field) {
                    (said, is_axis) = (Scale::of(field), true);
                }
            }
            (None, Some(_)) => break,
            _ => return None,
        }
    }
    let first = first.filter(|first| *first > 0 && numbers.len() > 1)?;
    let scales = match (has_unit, said) {
        (true, _) => [Some(Scale::Nanometres), None],
        (false, Scale::Unknown) => {
            [Some(above).filter(|above| *above != Scale::Unknown), Some(Scale::Unknown)]
        }
        // What the words of the row say holds; a lone unit may be a column of another quantity.
        (false, said) => [Some(said), (!is_axis).then_some(Scale::Unknown)],
    };
    let build = |scale| Rows::of(at, separator, first, &numbers, scale);
    scales.into_iter().flatten().find_map(build)
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
    /// The row of these wavelengths on this scale, if they can be.
    fn of(head: usize, separator: Separator, first: usize, numbers: &[f64], scale: Scale) -> Option<Self> {
        let is_um = scale == Scale::Unknown && is_in_micrometres(numbers);
        let taken = if is_um { Scale::Micrometres } else { scale };
        let rises = numbers.windows(2).all(|pair| pair[0] < pair[1]);
        let falls = numbers.windows(2).all(|pair| pair[0] > pair[1]);
        let is_likely = numbers.iter().all(|number| LIKELY_NM.contains(&taken.convert(*number)));
        let nm = numbers.iter().map(|number| taken.convert(*number)).collect();
        (is_likely && (rises || falls)).then_some(Self { head, separator, first, nm, scale, is_um })
    }

    /// Whether a line could be such a row of wavelengths, too.
    fn is_like(&self, line: &Line<'_>, unit: Option<Scale>, above: Scale) -> bool {
        wavelengths(0, line, self.separator, unit, above)
            .is_some_and(|other| other.first == self.first && other.nm.len() == self.nm.len())
    }

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
        if self.is_um {
            note(&mut notes, "wavelengths taken as µm, since in nm they were X-rays");
        } else if self.scale == Scale::Unknown {
            note(&mut notes, "no unit of wavelength given: taken as nm");
        }
        let quantity = self.quantity_of_all(source, &corners);
        // The unit of the wavelengths is none of values.
        let of_values = corners.iter().zip(&fields_of_head).filter(|(_, field)| !names_axis(field));
        let unit = of_values.map(|(one, _)| one.unit.as_str()).find(|unit| !unit.is_empty()).unwrap_or("");
        for spectrum in &mut spectra {
            self.settle(spectrum, quantity, unit);
            spectrum.notes.splice(0..0, notes.iter().cloned());
        }
        Ok(spectra)
    }

    /// Gives a spectrum what is said of all, and brings densities by frequency to those by wavelength.
    fn settle(&self, spectrum: &mut NamedSpectrum, quantity: Quantity, unit: &str) {
        if spectrum.quantity == Quantity::Unknown {
            spectrum.quantity = quantity;
        }
        spectrum.unit = unit.to_owned();
        if self.scale.is_inverse() {
            let said = Column { name: String::new(), quantity: spectrum.quantity, unit: unit.to_owned() };
            settle_column(spectrum, &said, self.scale);
        }
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
