//! Spectra in CGATS.17 text, as spectrophotometers for print write them: `.txt`, `.cgats`, `.sp`.
//!
//! Lines of keywords, then fields between `BEGIN_DATA_FORMAT` and `END_DATA_FORMAT`, then a line for each
//! sample between `BEGIN_DATA` and `END_DATA`; a file may hold several such tables. Spectral values are
//! in fields with a wavelength in their names (`SPECTRAL_NM380`, `SPECTRAL_NM_380`, `SPEC_380`, `nm380`)
//! or in pairs of `SPECTRAL_NM` and `SPECTRAL_DEC` (fractions) or `SPECTRAL_PCT` (per cent). Other fields are
//! skipped; `SPECTRAL_NORM` is the value that stands for 1; samples are named by `SAMPLE_NAME`, else `SAMPLE_ID`. Values are those that `MEAS_TYPE` says,
//! else light in files of kind SPECT and CCSS, of displays, and where a keyword speaks of emission, else reflectance.

use crate::file::read::error::{clean, excerpt};
use crate::file::read::named::note;
use crate::file::read::table::{MOST_SPECTRA, stem};
use crate::file::read::text::{Separator, expect_number, fields, lines, number};
use crate::file::read::units::{LIKELY_NM, MAX_NAME};
use crate::file::read::{NamedSpectrum, Place, Quantity, ReadError, read_as};

/// The most fields of a table.
const MOST_FIELDS: usize = 10_000;

/// Words of keywords by which a file of kind SPECT says that it is of surfaces.
const SAMPLES: [&str; 2] = ["color sample", "colour sample"];

/// Whether text is in this format.
pub(in crate::file::read) fn is_cgats(text: &str) -> bool {
    lines(text).any(|(_, line)| line.trim() == "BEGIN_DATA_FORMAT")
}

/// Reads the spectra of a CGATS file. `file` is its name for messages.
///
/// # Errors
///
/// [`ReadError`] tells the line and field that is not as this module says, or that the file holds no spectra.
pub fn read_cgats(bytes: &[u8], file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    read_as(bytes, file, parse)
}

/// The spectra of a text as the file has them, before their scale is settled.
pub(in crate::file::read) fn parse(text: &str, file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    let first = lines(text).map(|(_, line)| line.trim()).find(|line| !line.is_empty()).unwrap_or("");
    let mut reader = Reader {
        file,
        // Files of one spectrum (SPECT) and of displays (CCSS) are of light, if they do not say otherwise.
        quantity: if ["SPECT", "CCSS"].contains(&first) { Quantity::Light } else { Quantity::Reflectance },
        norm: 1.0,
        part: Part::Keywords,
        separator: Separator::Blanks,
        fields: Vec::new(),
        spectra: Vec::new(),
        sets: None,
        is_said: first != "SPECT",
        notes: Vec::new(),
    };
    let mut last = 0;
    for (line, text) in lines(text) {
        let text = text.trim_matches([' ', '\r']);
        if !text.trim().is_empty() && !text.starts_with('#') {
            reader.line(line, text)?;
        }
        last = line;
    }
    if !reader.is_said {
        note(
            &mut reader.notes,
            "it has no MEAS_TYPE: taken as light (--as surface, or as = \"surface\", for a reflectance)",
        );
    }
    if reader.part != Part::Keywords {
        let expected = if reader.part == Part::Data { "END_DATA" } else { "END_DATA_FORMAT" };
        return Err(ReadError::malformed(file, Place::Line(last), expected, "the end of the file"));
    }
    reader.finish()
}

/// Where in the file a line is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Keywords,
    Format,
    Data,
}

/// What a field holds.
#[derive(Clone, Copy, PartialEq)]
enum Field {
    /// The sample's name.
    Name,
    /// The sample's number.
    Id,
    /// The value at this wavelength.
    Value(f64),
    /// A wavelength; its value is in the next field.
    Wavelength,
    /// The value at the wavelength of the field before, times this factor.
    Paired(f64),
    /// Nothing of use here.
    Other,
}

impl Field {
    fn of(name: &str) -> Self {
        let name = name.to_ascii_uppercase();
        match name.as_str() {
            "SAMPLE_NAME" | "SAMPLENAME" => return Self::Name,
            "SAMPLE_ID" | "SAMPLEID" | "SAMPLE_LOC" => return Self::Id,
            "SPECTRAL_NM" => return Self::Wavelength,
            "SPECTRAL_DEC" => return Self::Paired(1.0),
            "SPECTRAL_PCT" => return Self::Paired(0.01),
            _ => {}
        }
        let bare = name.strip_suffix("_NM").or(name.strip_suffix("NM")).unwrap_or(&name);
        let nm = ["SPECTRAL_NM_", "SPECTRAL_NM", "SPECTRAL_", "SPEC_", "NM_", "NM", "R_", "R", "XYZ_R_"]
            .iter()
            .find_map(|prefix| number(bare.strip_prefix(prefix)?, false))
            .or_else(|| number(bare, false).filter(|_| bare != name));
        nm.filter(|nm| LIKELY_NM.contains(nm)).map_or(Self::Other, Self::Value)
    }
}

struct Reader<'a> {
    file: &'a str,
    quantity: Quantity,
    /// The value that stands for 1.
    norm: f64,
    part: Part,
    separator: Separator,
    fields: Vec<Field>,
    spectra: Vec<NamedSpectrum>,
    /// How many samples the file says there are, and how many there are in this table.
    sets: Option<(f64, usize)>,
    /// Whether the file tells what its values are.
    is_said: bool,
    notes: Vec<String>,
}

impl Reader<'_> {
    fn line(&mut self, line: u64, text: &str) -> Result<(), ReadError> {
        match (self.part, text.trim()) {
            (Part::Keywords, "BEGIN_DATA_FORMAT") => {
                self.fields.clear();
                self.part = Part::Format;
            }
            (Part::Format, "END_DATA_FORMAT") | (Part::Data, "END_DATA") => self.end(),
            (Part::Keywords, "BEGIN_DATA") if self.fields.is_empty() => {
                let (expected, found) = ("BEGIN_DATA_FORMAT with fields before BEGIN_DATA", "none");
                return Err(ReadError::malformed(self.file, Place::Line(line), expected, found));
            }
            (Part::Keywords, "BEGIN_DATA") => self.part = Part::Data,
            (Part::Keywords, text) => self.keyword(text),
            (Part::Format, _) => return self.format(line, text),
            (Part::Data, _) => return self.sample(line, text),
        }
        Ok(())
    }

    fn keyword(&mut self, text: &str) {
        let value = |name: &str| Some(text.strip_prefix(name)?.trim().trim_matches('"').to_lowercase());
        if let Some(told) = value("MEAS_TYPE").or(value("MEASUREMENT_TYPE")).or(value("QUANTITY")) {
            self.is_said = true;
            self.quantity = match told.as_str() {
                "emission" | "emissive" | "ambient" | "ambient_flash" | "light" => Quantity::Light,
                _ if Quantity::alone(&told) != Quantity::Unknown => Quantity::alone(&told),
                _ if told.starts_with("transmi") => Quantity::Transmittance,
                _ => Quantity::Reflectance,
            };
        } else {
            let of_display =
                value("DEVICE_CLASS").is_some_and(|told| told == "display" || told == "emission");
            let lower = text.to_lowercase();
            if of_display || ["emission", "emissive", "radiance"].iter().any(|word| lower.contains(word)) {
                self.quantity = Quantity::Light;
                self.is_said = true;
            } else if !self.is_said && SAMPLES.iter().any(|word| lower.contains(word)) {
                (self.quantity, self.is_said) = (Quantity::Reflectance, true);
            }
        }
        if let Some(norm) = text.strip_prefix("SPECTRAL_NORM") {
            self.norm =
                number(norm.trim().trim_matches('"'), false).filter(|norm| *norm > 0.0).unwrap_or(1.0);
        }
        if let Some(count) = text.strip_prefix("NUMBER_OF_SETS") {
            self.sets = number(count, false).map(|count| (count, 0));
        }
    }

    /// The end of a part. That a file tells a wrong number of samples is no harm, but may mean that it
    /// was cut.
    fn end(&mut self) {
        if self.part == Part::Data
            && let Some((told, found)) = self.sets.take()
            && told != found as f64
        {
            note(&mut self.notes, format!("NUMBER_OF_SETS is {told}, but there are {found} samples"));
        }
        self.part = Part::Keywords;
    }

    fn format(&mut self, line: u64, text: &str) -> Result<(), ReadError> {
        self.separator = if text.contains('\t') { Separator::Char('\t') } else { Separator::Blanks };
        self.fields.extend(fields(text, self.separator).map(Field::of).take(MOST_FIELDS + 1));
        if self.fields.len() > MOST_FIELDS {
            let (file, place) = (self.file.to_owned(), Place::Line(line));
            let (limit, found) = (MOST_FIELDS as u64, self.fields.len() as u64);
            return Err(ReadError::TooLarge { file, place, limit, unit: "fields", found });
        }
        Ok(())
    }

    fn sample(&mut self, line: u64, text: &str) -> Result<(), ReadError> {
        if let Some((_, count)) = &mut self.sets {
            *count += 1;
        }
        let mut points = Vec::new();
        let (mut name, mut id, mut nm, mut count) = ("", "", None, 0);
        for (index, part) in fields(text, self.separator).enumerate().filter(|(_, part)| !part.is_empty()) {
            count = index + 1;
            let value =
                || expect_number(part, false, self.file, || Place::Field { line, field: index as u64 + 1 });
            match self.fields.get(index) {
                Some(Field::Name) => name = part,
                Some(Field::Id) => id = part,
                Some(Field::Value(nm)) => points.push((*nm, value()?)),
                Some(Field::Wavelength) => nm = Some(value()?).filter(|nm| LIKELY_NM.contains(nm)),
                Some(Field::Paired(factor)) => match nm.take() {
                    Some(nm) => points.push((nm, value()? * factor)),
                    None => {
                        let (expected, found) =
                            ("a wavelength from 100 to 10000 nm before the value", "none");
                        return Err(ReadError::malformed(self.file, Place::Line(line), expected, found));
                    }
                },
                Some(Field::Other) => {}
                None => break,
            }
        }
        if count != self.fields.len() && self.separator == Separator::Blanks || count > self.fields.len() {
            let expected = format!("{} fields", self.fields.len());
            let found = if count > self.fields.len() { "more".to_owned() } else { count.to_string() };
            return Err(ReadError::malformed(self.file, Place::Line(line), expected, found));
        }
        let name = if name.is_empty() { id } else { name };
        self.push(line, name, points)
    }

    /// Adds a spectrum of points in any order.
    fn push(&mut self, line: u64, name: &str, mut points: Vec<(f64, f64)>) -> Result<(), ReadError> {
        if points.is_empty() {
            return Ok(());
        }
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Some(pair) = points.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let found = format!("{} nm twice", pair[0].0);
            return Err(ReadError::malformed(self.file, Place::Line(line), "each wavelength once", found));
        }
        if self.spectra.len() == MOST_SPECTRA {
            let (file, place, limit) = (self.file.to_owned(), Place::Line(line), MOST_SPECTRA as u64);
            return Err(ReadError::TooLarge { file, place, limit, unit: "spectra", found: limit + 1 });
        }
        let name = match name {
            "" => format!("{} {}", stem(self.file), self.spectra.len() + 1),
            name => clean(name, MAX_NAME),
        };
        let (nm, values) = points.into_iter().map(|(nm, value)| (nm, value / self.norm)).unzip();
        let quantity = self.quantity;
        self.spectra.push(NamedSpectrum { name, nm, values, quantity, ..Default::default() });
        Ok(())
    }

    fn finish(mut self) -> Result<Vec<NamedSpectrum>, ReadError> {
        if self.spectra.is_empty() {
            let expected = "samples with spectral fields, such as SPECTRAL_NM380 or nm380";
            let found = match self.fields.len() {
                0 => excerpt("no BEGIN_DATA_FORMAT"),
                fields => format!("{fields} fields, none of them spectral, or no samples"),
            };
            return Err(ReadError::malformed(self.file, Place::File, expected, found));
        }
        for spectrum in &mut self.spectra {
            self.notes.iter().for_each(|text| note(&mut spectrum.notes, text.clone()));
        }
        Ok(self.spectra)
    }
}
