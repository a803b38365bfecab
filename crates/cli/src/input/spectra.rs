//! Spectra, lights, observers and re-radiation: by name, or from a file.
//!
//! A name comes first; a file of the same name is found as `./name`. `FILE:COLUMN` is one spectrum of a file
//! that holds several, by its name or its number from 1.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use glanz_color::read::{
    NamedSpectrum, PowerUnit, Quantity, ReadOptions, is_bfc, read_reradiation, read_spectra_with,
};
use glanz_color::{
    CatalogSpectrum, FineSpectrum, Observer, Outside, Reradiation, Spectrum, SpectrumKind, TableError,
    UnknownName, catalog_spectrum, fluorescent, fluorescents, light, observer,
};
use glanz_eye::{Eye, EyeError};
use glanz_math::names::{plain, suggestion};
use glanz_scene::read::read_sensor;

use super::column::pick;
use super::resolution::{Coarse, fine};
pub(crate) use super::tables::TableArgs;
use crate::print;
use crate::print::failure::{Failure, Report, without_number};

/// The most that is read of a file: what the readers take, and one byte by which they see more.
const MAX_BYTES: u64 = (16 << 20) + 1;

/// Endings by which a word is known to be a file's name, whether or not the file exists.
const ENDINGS: [&str; 15] =
    ["csv", "tsv", "txt", "dat", "spdx", "xml", "cxf", "bfc", "exr", "jdx", "dx", "sp", "spd", "xls", "ttt"];

/// A surface may exceed 1 by the rounding of numbers in a file without a remark.
const RATIO_TOLERANCE: f64 = 1e-6;

/// A spectrum that the command line named.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    /// Its name.
    pub name: String,
    /// What it is, in a few words, and where it comes from.
    pub title: String,
    /// What it is of.
    pub kind: SpectrumKind,
    /// The values on the grid, as they are drawn.
    pub spectrum: Spectrum,
    /// The values by 1 nm, for numbers; those of a coarse table are joined by lines.
    pub fine: FineSpectrum,
    /// The same with the values of a coarse table joined by smooth curves.
    pub coarse: Option<Coarse>,
    /// The unit of the values as the file gives it; empty if there is none.
    pub unit: String,
    /// The same, where it is one of spectral power that is understood.
    pub power_unit: Option<PowerUnit>,
}

/// A re-radiation matrix that the command line named.
#[derive(Clone, Debug)]
pub(crate) struct FluorescentSource {
    /// Its name.
    pub name: String,
    /// What it is, in a few words.
    pub title: String,
    /// The matrix on the grid.
    pub matrix: Reradiation,
}

impl Source {
    fn of_catalog(word: &str, CatalogSpectrum { title, kind, spectrum, fine }: CatalogSpectrum) -> Self {
        Self {
            name: word.to_owned(),
            title,
            kind,
            spectrum,
            fine,
            coarse: None,
            unit: String::new(),
            power_unit: None,
        }
    }
}

/// The spectrum of that name, or of that file; of `wanted` where the file does not say what it is of.
///
/// What is assumed of a file is told on stderr.
pub(crate) fn source(word: &str, wanted: Option<SpectrumKind>, table: &TableArgs) -> Result<Source, Failure> {
    let unknown_name = match catalog_spectrum(word) {
        Ok(found) => return Ok(Source::of_catalog(word, found)),
        // Numbers that are not possible have their own message.
        Err(error @ UnknownName::Parameter { .. }) => return Err(Failure::Usage(error.to_string())),
        Err(error) => error,
    };
    match open(word)? {
        Some(opened) => from_file(&opened, wanted, table),
        None if fluorescent(word).is_ok() => Err(Failure::Usage(format!(
            "'{word}' is fluorescent: no reflectance tells its colour; see 'glanz color fluorescence'"
        ))),
        None => Err(unknown("spectrum", word, &unknown_name)),
    }
}

/// The light of that name, or of that file.
pub(crate) fn light_source(word: &str) -> Result<Source, Failure> {
    light_source_with(word, &TableArgs::default())
}

/// The light of that name, or of that file, which is read as these options say, but for what it is of.
pub(crate) fn light_source_with(word: &str, table: &TableArgs) -> Result<Source, Failure> {
    let table = &table.of_lights();
    match light(word) {
        Ok(_) => source(word, Some(SpectrumKind::Light), table),
        // Numbers that are not possible have their own message.
        Err(error @ UnknownName::Parameter { .. }) => Err(Failure::Usage(error.to_string())),
        Err(error) => match open(word)? {
            Some(opened) => light_from_file(&opened, table),
            None => Err(unknown("light", word, &error)),
        },
    }
}

/// The observer of that name, the eye, or the sensor whose channels are the columns of that file.
pub(crate) fn observer_source(word: &str) -> Result<Observer, Failure> {
    if Eye::is_named(word) {
        let eye: Eye = word.parse().map_err(|error: EyeError| Failure::Usage(error.to_string()))?;
        return Ok(eye.observer());
    }
    if let Some(count) = word.strip_prefix("population:") {
        let message = format!(
            "population:{count} is many eyes, but one looks here: glanz eye SCENE --population {count}"
        );
        return Err(Failure::Usage(message));
    }
    let error = match observer(word) {
        Ok(observer) => return Ok(observer),
        Err(error) => error,
    };
    let Some(Opened { bytes, file, .. }) = open(word)? else {
        return Err(unknown("observer", word, &error));
    };
    read_sensor(&bytes, &file).map_err(Failure::new)
}

/// The re-radiation matrix of that name, or of that file.
pub(crate) fn fluorescent_source(word: &str) -> Result<FluorescentSource, Failure> {
    let error = match fluorescent(word) {
        Ok(matrix) => {
            let info = fluorescents().iter().find(|info| same(info.name, word));
            let title = info.map_or(String::new(), |info| info.title.to_owned());
            return Ok(FluorescentSource { name: word.to_owned(), title, matrix });
        }
        Err(error) => error,
    };
    let Some(Opened { bytes, file, .. }) = open(word)? else {
        return Err(unknown("fluorescent material", word, &error));
    };
    let read = read_reradiation(&bytes, &file)?;
    if !read.notes.is_empty() {
        print::note(format_args!("note: {file}: {}", read.notes.join("; ")));
    }
    let matrix = read.to_reradiation().map_err(|error| Failure::new(format_args!("{file}: {error}")))?;
    Ok(FluorescentSource { name: read.name, title: file, matrix })
}

/// The only spectrum of a file, on its own scale.
pub(crate) fn relative_spectrum(file: &Path) -> Result<Spectrum, Failure> {
    let name = file.display().to_string();
    let options = ReadOptions { quantity: Some(Quantity::Relative), ..ReadOptions::default() };
    let spectra = read_spectra_with(&read(file)?, &name, &options)?;
    on_grid(pick(&spectra, &name, None)?, Some(Outside::Zero))
}

/// All surfaces of a file.
pub(crate) fn surfaces(file: &str) -> Result<Vec<Spectrum>, Failure> {
    let options = TableArgs::default().options(Some(SpectrumKind::Surface));
    let spectra = read_spectra_with(&read(Path::new(file))?, file, &options)?;
    let surface = |named: &NamedSpectrum| {
        if matches!(named.quantity, Quantity::Light | Quantity::Relative | Quantity::Absorptance) {
            return Err(not_a(named, file, "a surface"));
        }
        let spectrum = on_grid(named, Some(Outside::Hold))?;
        note_beyond_1(&spectrum, &named.name);
        Ok(spectrum)
    };
    spectra.iter().map(surface).collect()
}

/// A light from a file that does not say that it is something else.
fn light_from_file(opened: &Opened, table: &TableArgs) -> Result<Source, Failure> {
    let source = from_file(opened, Some(SpectrumKind::Light), table)?;
    match source.kind {
        SpectrumKind::Light => Ok(source),
        SpectrumKind::Surface => {
            let (file, name) = (&opened.file, &source.name);
            Err(Failure::new(format_args!("{file}: expected a light, found that '{name}' is of a surface")))
        }
    }
}

/// The failure for a spectrum that the file calls something else than what is wanted.
fn not_a(named: &NamedSpectrum, file: &str, wanted: &str) -> Failure {
    let what = match named.quantity {
        Quantity::Reflectance => "a reflectance",
        Quantity::Transmittance => "a transmittance",
        Quantity::Absorptance => "an absorptance",
        Quantity::Absorbance => "an absorbance",
        Quantity::Light | Quantity::Relative => "light",
        Quantity::Unknown => "unknown",
    };
    Failure::new(format_args!("{file}: expected {wanted}, found that '{}' is {what}", named.name))
}

/// Says where a surface gives back more light than it gets.
fn note_beyond_1(surface: &Spectrum, name: &str) {
    let most = surface.points().max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((nm, value)) = most.filter(|(_, value)| *value > 1.0 + RATIO_TOLERANCE) {
        print::note(format_args!(
            "note: '{name}' gives back up to {} of the light ({nm} nm): only what glows exceeds 1",
            print::number(value)
        ));
    }
}

/// Words between commas; commas in brackets, as in `gaussian(530, 30)`, do not count.
pub(crate) fn words(text: &str) -> Result<Vec<String>, String> {
    let mut words = vec![String::new()];
    let mut depth = 0_usize;
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if c == ',' && depth == 0 {
            words.push(String::new());
        } else if let Some(word) = words.last_mut() {
            word.push(c);
        }
    }
    words.iter_mut().for_each(|word| *word = word.trim().to_owned());
    match words.iter().any(String::is_empty) {
        true => Err("expected names between commas, such as D65,A,FL11".to_owned()),
        false => Ok(words),
    }
}

pub(super) fn same(a: &str, b: &str) -> bool {
    plain(a) == plain(b)
}

/// The failure for a word that is neither a name nor a file.
fn unknown(what: &str, word: &str, error: &UnknownName) -> Failure {
    let suggestion = match error {
        UnknownName::NotFound { near, .. } => suggestion(near),
        UnknownName::Parameter { .. } => String::new(),
    };
    Failure::Usage(format!("there is no {what} '{word}', and no file of that name{suggestion}"))
}

/// A file that was named.
struct Opened {
    bytes: Vec<u8>,
    /// Its name.
    file: String,
    /// The column of it that is meant.
    column: Option<String>,
}

/// Reads the file that is meant; none where the word is no file.
fn open(word: &str) -> Result<Option<Opened>, Failure> {
    let whole = Path::new(word);
    let split = word.rsplit_once(':').filter(|(file, column)| !file.is_empty() && !column.is_empty());
    let (file, column) = match split {
        _ if whole.exists() => (word, None),
        Some((file, column)) if Path::new(file).exists() || has_ending(file) => (file, Some(column)),
        _ if has_ending(word) || word.contains(['/', '\\']) => (word, None),
        _ => return Ok(None),
    };
    let bytes = read(Path::new(file))?;
    Ok(Some(Opened { bytes, file: file.to_owned(), column: column.map(str::to_owned) }))
}

/// Whether a word is the name of a file, by its ending, its folder, or since there is one.
pub(super) fn names_file(word: &str) -> bool {
    has_ending(word) || word.contains(['/', '\\']) || Path::new(word).exists()
}

fn has_ending(word: &str) -> bool {
    let ending = Path::new(word).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending))
}

/// Reads a file, but not more than the readers take.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let failed = |error: std::io::Error| {
        let error = without_number(&error.to_string());
        Failure::from(Report::new(format_args!("cannot read '{}': {error}", path.display())).file(path))
    };
    if path.is_dir() {
        let report = Report::new(format_args!("cannot read '{}': it is a folder", path.display()));
        return Err(report.file(path).into());
    }
    let mut bytes = Vec::new();
    File::open(path).map_err(failed)?.take(MAX_BYTES).read_to_end(&mut bytes).map_err(failed)?;
    Ok(bytes)
}

fn from_file(opened: &Opened, wanted: Option<SpectrumKind>, table: &TableArgs) -> Result<Source, Failure> {
    let file = opened.file.as_str();
    if is_bfc(&opened.bytes) {
        let report = Report::new(format_args!("{file} is a re-radiation matrix: it has no single spectrum"));
        return Err(report.help(format_args!("'glanz color fluorescence {file}' tells its colours")).into());
    }
    let spectra = read_spectra_with(&opened.bytes, file, &table.options(wanted))?;
    let named = pick(&spectra, file, opened.column.as_deref().or(table.column.as_deref()))?;
    let kind = kind_of(named, file)?;
    let outside = if kind == SpectrumKind::Surface { Outside::Hold } else { Outside::Zero };
    let spectrum = on_grid(named, Some(outside))?;
    let (fine, coarse) = fine(named, outside).map_err(|error| failed(named, &error))?;
    if kind == SpectrumKind::Surface {
        note_beyond_1(&spectrum, &named.name);
    }
    Ok(Source {
        name: named.name.clone(),
        title: format!("from {file}"),
        kind,
        spectrum,
        fine,
        coarse,
        unit: named.unit.clone(),
        power_unit: named.power_unit(),
    })
}

/// What a spectrum of a file is of, by what the file says, or what was said of it.
fn kind_of(named: &NamedSpectrum, file: &str) -> Result<SpectrumKind, Failure> {
    match named.quantity {
        Quantity::Reflectance | Quantity::Transmittance => Ok(SpectrumKind::Surface),
        Quantity::Light | Quantity::Relative => Ok(SpectrumKind::Light),
        Quantity::Absorptance | Quantity::Absorbance => {
            let message = format!("{file}: '{}' is an absorptance, which has no colour", named.name);
            Err(Report::new(message).help("say what it stands for with --as").into())
        }
        // The level of values does not tell: a lamp may be scaled to any.
        Quantity::Unknown => {
            named.notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
            let message = format!("{file} does not say what '{}' is of", named.name);
            Err(Report::new(message).help("say --as light or --as surface").file(Path::new(file)).into())
        }
    }
}

fn on_grid(named: &NamedSpectrum, outside: Option<Outside>) -> Result<Spectrum, Failure> {
    told(named, named.to_spectrum(outside))
}

/// The failure for a spectrum whose values are none.
fn failed(named: &NamedSpectrum, error: &TableError) -> Failure {
    Failure::new(format_args!("'{}': {error}", named.name))
}

/// The spectrum that came of a file's; what had to be assumed is told on stderr.
fn told(
    named: &NamedSpectrum,
    found: Result<(Spectrum, Vec<String>), TableError>,
) -> Result<Spectrum, Failure> {
    let (spectrum, notes) = found.map_err(|error| failed(named, &error))?;
    named.notes.iter().chain(&notes).for_each(|note| print::note(format_args!("note: {note}")));
    Ok(spectrum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_in_brackets_do_not_part_words() {
        assert_eq!(words("D65, gaussian(530, 30) ,A").unwrap(), ["D65", "gaussian(530, 30)", "A"]);
        assert!(words("D65,,A").is_err() && words("").is_err());
    }

    #[test]
    fn endings_tell_files_from_names() {
        assert!(has_ending("a/b.CSV") && has_ending("b.bfc"));
        assert!(!has_ending("FL3.1") && !has_ending("neutral-6.5"));
    }
}
