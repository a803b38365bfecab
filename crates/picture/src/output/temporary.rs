//! Temporary files: each is removed when it is not needed any more, and all when the program is told to end.

use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporary files of this process.
pub(super) static TEMPORARIES: Temporaries = Temporaries::new();

/// Removes all temporary files of [`write_atomically`](super::write_atomically). It is for a program that is about to
/// end because it was told to, in the middle of writing: what is being written is lost, and the targets stay as they
/// were. From now on this process writes no file: that is an error.
pub fn remove_temporaries() {
    TEMPORARIES.close();
}

/// Temporary files, and whether there may be more of them.
pub(super) struct Temporaries(Mutex<State>);

struct State {
    paths: Vec<PathBuf>,
    /// Whether the program is about to end, and all files were removed.
    is_closed: bool,
}

impl Temporaries {
    const fn new() -> Self {
        Self(Mutex::new(State { paths: Vec::new(), is_closed: false }))
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Removes all files. There will be no more.
    fn close(&self) {
        let mut state = self.state();
        state.is_closed = true;
        for path in state.paths.drain(..) {
            let _ = fs::remove_file(path);
        }
    }

    /// A new file in the folder of `target`; a name that is taken is passed over, so that processes
    /// writing the same target do not meet.
    pub(super) fn create_beside(&self, target: &Path) -> io::Result<(Temporary<'_>, File)> {
        /// File systems have names of at most 255 bytes.
        const LONGEST: usize = 240;
        let name = target.file_name().ok_or_else(|| io::Error::other("the path names no file"))?;
        let name = if name.len() > LONGEST { OsStr::new("glanz") } else { name };
        // Locked until the file is on the list: one that is created while all are removed would stay.
        let mut state = self.open_state()?;
        for attempt in 0..10_000 {
            let mut hidden = OsString::from(".");
            hidden.push(name);
            hidden.push(format!(".{attempt}.tmp"));
            let path = target.with_file_name(hidden);
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    state.paths.push(path.clone());
                    return Ok((Temporary { path, all: self }, file));
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::other("ten thousand temporary files are in the way"))
    }

    /// The state, if the program is not about to end.
    fn open_state(&self) -> io::Result<MutexGuard<'_, State>> {
        let state = self.state();
        match state.is_closed {
            true => Err(io::Error::new(io::ErrorKind::Interrupted, "the program is about to end")),
            false => Ok(state),
        }
    }
}

impl State {
    /// Takes a file off the list; false if it is not there any more.
    fn take_off(&mut self, path: &Path) -> bool {
        let place = self.paths.iter().position(|own| own == path);
        place.map(|place| self.paths.swap_remove(place)).is_some()
    }
}

/// A file that is removed when this is dropped.
pub(super) struct Temporary<'a> {
    path: PathBuf,
    all: &'a Temporaries,
}

impl Temporary<'_> {
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Puts the file in place of `target`.
    pub(super) fn put_at(self, target: &Path) -> io::Result<()> {
        let mut state = self.all.open_state()?;
        fs::rename(&self.path, target)?;
        state.take_off(&self.path);
        Ok(())
    }
}

impl Drop for Temporary<'_> {
    fn drop(&mut self) {
        // Nothing is left to do if this fails: the error that led here is reported already.
        if self.all.state().take_off(&self.path) {
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_file_is_created_once_all_were_removed() {
        let target = std::env::temp_dir().join(format!("glanz-temporary-{}", std::process::id()));
        let all = Temporaries::new();
        let (first, _) = all.create_beside(&target).unwrap();
        let path = first.path().to_owned();
        assert!(path.is_file());
        all.close();
        assert!(!path.exists());
        assert!(first.put_at(&target).is_err());
        assert!(all.create_beside(&target).is_err());
        assert!(!path.exists() && !target.exists());
    }

    #[test]
    fn nothing_is_left_where_others_remove_all_again_and_again() {
        let folder = std::env::temp_dir().join(format!("glanz-temporaries-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        for _ in 0..50 {
            let all = Temporaries::new();
            std::thread::scope(|scope| {
                scope.spawn(|| {
                    while let Ok((file, _)) = all.create_beside(&folder.join("a")) {
                        // The program ends before it is dropped.
                        core::mem::forget(file);
                    }
                });
                std::thread::yield_now();
                all.close();
            });
            assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        }
        fs::remove_dir_all(folder).unwrap();
    }
}
