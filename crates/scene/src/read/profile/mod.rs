//! Profiles of luminaires: ANSI/IES LM-63 (`.ies`) and EULUMDAT (`.ldt`).
//!
//! Own readers, since of the crates that there are none may be used: what reads both is under the AGPL.

mod eulumdat;
mod lm63;
mod planes;
#[cfg(test)]
pub(super) mod tests;

use glanz_color::read::{Place, ReadError, excerpt};

use super::notes::Notes;
use crate::Profile;

/// The most bytes of a file. A profile at every degree of both angles takes half a megabyte.
pub const MAX_PROFILE_BYTES: u64 = 16 << 20;
/// The most that any number of a file may be, in cd, lm or as a factor.
const MAX_VALUE: f64 = 1e12;

/// Reads the profile of a luminaire: LM-63 of any year with type C photometry, or EULUMDAT. `file` is the
/// file's name: its ending and its first bytes tell which.
///
/// The answer has intensities in cd with the lamps that the file names, and what was left out, in words.
///
/// # Errors
///
/// [`ReadError`] where the file breaks its format, has photometry of type A or B, or is larger than
/// [`MAX_PROFILE_BYTES`].
pub fn read_profile(bytes: &[u8], file: &str) -> Result<(Profile, Vec<String>), ReadError> {
    if bytes.len() as u64 > MAX_PROFILE_BYTES {
        let (limit, found) = (MAX_PROFILE_BYTES, bytes.len() as u64);
        return Err(ReadError::TooLarge {
            file: file.to_owned(),
            place: Place::File,
            limit,
            unit: "bytes of a profile",
            found,
        });
    }
    // Names in these files are in whatever code page; they are not needed.
    let text = String::from_utf8_lossy(bytes);
    let mut source = Source { file, notes: Notes::default() };
    let profile = match is_lm63(&text, file) {
        true => lm63::read(&text, &mut source)?,
        false => eulumdat::read(&text, &mut source)?,
    };
    Ok((profile, source.notes.into_strings()))
}

/// Whether this is LM-63: its first bytes count more than the name, the name more than the rest.
fn is_lm63(text: &str, file: &str) -> bool {
    let ending = |ending: &str| file.to_ascii_lowercase().ends_with(ending);
    let tilt = || text.lines().any(|line| line.trim_start().starts_with("TILT="));
    text.starts_with("IESNA") || text.starts_with("IES:") || ending(".ies") || (!ending(".ldt") && tilt())
}

/// What both readers share.
struct Source<'a> {
    /// The file's name, for messages.
    file: &'a str,
    notes: Notes,
}

impl Source<'_> {
    fn malformed(&self, place: Place, expected: impl Into<String>, found: impl Into<String>) -> ReadError {
        ReadError::malformed(self.file, place, expected, found)
    }

    /// A number that stands in a line.
    fn number(&self, text: &str, line: u64, what: &str) -> Result<f64, ReadError> {
        let number = text.parse().ok().filter(|value: &f64| value.abs() <= MAX_VALUE);
        number.ok_or_else(|| {
            let expected = format!("{what}, a number of at most {MAX_VALUE:e}");
            self.malformed(Place::Line(line), expected, excerpt(text))
        })
    }

    /// A number of things, at least 1.
    fn count(&self, value: f64, line: u64, what: &str) -> Result<usize, ReadError> {
        // That many would not fit into a file.
        let most = MAX_PROFILE_BYTES as f64;
        match value.fract() == 0.0 && (1.0..=most).contains(&value) {
            true => Ok(value as usize),
            false => Err(self.malformed(
                Place::Line(line),
                format!("{what}, a whole number of at least 1"),
                value.to_string(),
            )),
        }
    }

    /// Intensities without negative ones, which measurements have where there is no light.
    fn not_negative(&mut self, candela: &mut [f64]) {
        let negative = candela.iter_mut().filter(|value| **value < 0.0);
        let count = negative.map(|value| *value = 0.0).count();
        self.notes.add_times("an intensity below 0 is taken as 0", count as u64);
    }
}
