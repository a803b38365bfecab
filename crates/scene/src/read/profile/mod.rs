//! Profiles of luminaires: ANSI/IES LM-63 (`.ies`) and EULUMDAT (`.ldt`).
//!
//! Own readers, since of the crates that there are none may be used: what reads both is under the AGPL.

mod eulumdat;
mod lm63;
mod planes;
mod source;
#[cfg(test)]
pub(super) mod tests;

use glanz_color::read::{Place, ReadError};

pub use source::MAX_PROFILE_BYTES;

use super::notes::Notes;
use crate::Profile;
use source::Source;

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
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    // Lines end with LF, CR LF, or CR alone.
    let text = if text.contains('\n') { text.to_owned() } else { text.replace('\r', "\n") };
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
