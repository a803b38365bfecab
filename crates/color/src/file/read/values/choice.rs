//! Which spectrum of a file is meant where nobody says it.

use crate::file::read::{NamedSpectrum, Quantity};

/// The spectrum of several that a reader would take first, and why: what an instrument made of the others, else the only one
/// that says what it is of, else the first that says it, else the first. None of one alone, or of none.
///
/// ```
/// use glanz_color::read::{preferred, read_spectra};
///
/// let file = "nm,red reflectance,blue reflectance\n400,0.1,0.5\n700,0.6,0.1\n";
/// let spectra = read_spectra(file.as_bytes(), "patches.csv")?;
/// assert_eq!(preferred(&spectra).map(|(one, why)| (one.name.as_str(), why)), Some(("red reflectance", "the first")));
/// # Ok::<(), glanz_color::read::ReadError>(())
/// ```
pub fn preferred(spectra: &[NamedSpectrum]) -> Option<(&NamedSpectrum, &'static str)> {
    let [first, _, ..] = spectra else { return None };
    if let Some(found) = processed(spectra) {
        return Some((found, "what the instrument made of the others"));
    }
    let mut known = spectra.iter().filter(|one| one.quantity != Quantity::Unknown);
    Some(match (known.next(), known.next()) {
        (Some(only), None) => (only, "the only one that says what it is of"),
        (Some(one), _) if one != first => (one, "the first that says what it is of"),
        _ => (first, "the first"),
    })
}

/// The spectrum that an instrument made of the others that it wrote beside it: dark, reference and sample.
///
/// Named *processed*, or `P` beside `D`, `R` and `S`; none where there is no such, or more than one.
pub fn processed(spectra: &[NamedSpectrum]) -> Option<&NamedSpectrum> {
    let is_processed = |one: &&NamedSpectrum| one.name.to_lowercase().contains("processed");
    let mut named = spectra.iter().filter(is_processed);
    if let Some(found) = named.next() {
        return Some(found).filter(|_| named.next().is_none() && spectra.len() > 1);
    }
    let is_jaz =
        spectra.len() > 1 && spectra.iter().all(|one| ["D", "R", "S", "P"].contains(&one.name.as_str()));
    spectra.iter().find(|one| is_jaz && one.name == "P")
}
