//! Media: by name, by number, or from files of n and k.

use std::path::Path;
use std::sync::Arc;

use glanz_color::Ior;
use glanz_color::read::{NamedIor, ReadError, ior_partner, read_ior, read_ior_pair};
use glanz_plot::Medium;
use glanz_scene::Tint;

use super::spectra::{names_file, read};
use crate::print;
use crate::print::failure::Failure;

/// The wavelength at which words for media are tried, in nm.
const TRIED_NM: f64 = 550.0;

/// Endings of files of n and k, beside those of spectra.
const ENDINGS: [&str; 4] = ["yml", "yaml", "nk", "ri"];

/// A medium at a wavelength in nm: a name, a number, n and k as `1.5+3i`, or a file.
pub(crate) fn medium(word: &str, nm: f64) -> Result<Medium, Failure> {
    match file(word)? {
        Some(ior) => Ok(Medium::of(&ior, nm)),
        None => Ok(Medium::named(word, nm)?),
    }
}

/// Fresnel reflection of a medium.
pub(crate) fn tint(word: &str) -> Result<Tint, Failure> {
    if let Some(ior) = file(word)? {
        return Ok(Tint::Ior(Arc::new(ior)));
    }
    // The words that are no media have their errors there.
    let known = Medium::named(word, TRIED_NM)?;
    Ok(Tint::Ior(Arc::new(glanz_color::ior(word).unwrap_or_else(|_| Ior::constant(known.eta)))))
}

/// The medium of a file; none where the word is no file.
fn file(word: &str) -> Result<Option<Ior>, Failure> {
    let ending = Path::new(word).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let is_own = ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending));
    // A name comes first, as of spectra: a file of the same name is `./Au`.
    if glanz_color::ior(word).is_ok() || word.trim().parse::<f64>().is_ok() || !(is_own || names_file(word)) {
        return Ok(None);
    }
    let bytes = read(Path::new(word))?;
    let partner = ior_partner(word).filter(|partner| Path::new(partner).exists());
    let pair = partner.map(|name| Ok::<_, Failure>((read(Path::new(&name))?, name))).transpose()?;
    let read = match &pair {
        Some((k, name)) => read_ior_pair((&bytes, word), (k, name)),
        None => read_ior(&bytes, word),
    };
    settled(read, word).map(Some)
}

fn settled(read: Result<NamedIor, ReadError>, word: &str) -> Result<Ior, Failure> {
    let (ior, notes) = read.and_then(|medium| medium.to_ior())?;
    notes.iter().for_each(|note| print::note(format!("{word}: {note}")));
    Ok(ior)
}
