//! Which spectrum of a file that holds several is meant.

use glanz_color::read::{NamedSpectrum, preferred};

use super::spectra::same;
use crate::print;
use crate::print::failure::Failure;

/// The spectrum that is meant: the only one, that of the column, or the one that comes first, which is told.
pub(super) fn pick<'a>(
    spectra: &'a [NamedSpectrum],
    file: &str,
    column: Option<&str>,
) -> Result<&'a NamedSpectrum, Failure> {
    let list = || spectra.iter().map(|one| one.name.as_str()).take(12).collect::<Vec<_>>().join(", ");
    let Some(column) = column else {
        if let Some((found, why)) = preferred(spectra) {
            print::note(format_args!("note: {}", taken(spectra, found, why, file)));
            return Ok(found);
        }
        return spectra.first().ok_or_else(|| Failure::new(format_args!("{file} holds no spectrum")));
    };
    let number = column.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    let by_name = spectra.iter().find(|one| same(&one.name, column));
    by_name
        .or_else(|| number.and_then(|index| spectra.get(index)))
        .ok_or_else(|| Failure::new(format_args!("{file} holds no spectrum '{column}'; it holds {}", list())))
}

/// How many of a file's other spectra are named.
const NAMED: usize = 6;

/// What is told of a spectrum that is taken of several: which, why, which others there are, and how to choose them.
fn taken(spectra: &[NamedSpectrum], found: &NamedSpectrum, why: &str, file: &str) -> String {
    let others = || spectra.iter().filter(|one| !std::ptr::eq(*one, found)).map(|one| one.name.as_str());
    let more = if others().count() > NAMED { ", …" } else { "" };
    let others = others().take(NAMED).collect::<Vec<_>>().join(", ");
    let (count, name) = (spectra.len(), &found.name);
    format!(
        "{file} holds {count} spectra: '{name}' is taken, {why}; --column NAME or NUMBER takes another: {others}{more}"
    )
}
