//! Files that are read, and so are not written over.

use std::collections::HashSet;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// Which file it is, whatever it is called.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = std::path::PathBuf;

/// The files that were read; none while nobody asks for them to be kept.
static INPUTS: Mutex<Option<HashSet<Identity>>> = Mutex::new(None);

/// From now on files that this process reads are not written over: [`write_atomically`](super::write_atomically) refuses
/// it, by whatever name or link. The command asks for it; a program that changes its own files does not.
///
/// ```
/// use glanz_picture::output::{OutputError, keep_inputs, note_input, write_atomically};
///
/// let path = std::env::temp_dir().join("glanz-doc-input.csv");
/// std::fs::write(&path, "nm,value\n")?;
/// keep_inputs();
/// note_input(&path);
/// let written = write_atomically(&path, |_| Ok::<_, OutputError>(()));
/// assert!(matches!(written, Err(OutputError::Input { .. })));
/// # std::fs::remove_file(path)?;
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn keep_inputs() {
    INPUTS.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_default();
}

/// Notes that a file is read, if [`keep_inputs`] was called; see the example there.
pub fn note_input(path: &Path) {
    if let Some(inputs) = INPUTS.lock().unwrap_or_else(PoisonError::into_inner).as_mut() {
        inputs.extend(identity(path));
    }
}

/// Whether a file was read that is kept.
pub(super) fn is_input(path: &Path) -> bool {
    let inputs = INPUTS.lock().unwrap_or_else(PoisonError::into_inner);
    inputs.as_ref().is_some_and(|inputs| identity(path).is_some_and(|own| inputs.contains(&own)))
}

/// None of what is no file.
#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    let metadata = std::fs::metadata(path).ok().filter(std::fs::Metadata::is_file)?;
    Some((metadata.dev(), metadata.ino()))
}

/// None of what is no file.
#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    if path.is_file() { std::fs::canonicalize(path).ok() } else { None }
}
