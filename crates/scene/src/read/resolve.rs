//! Files that other files refer to, and the folder that they may not leave.

use glanz_picture::output::note_input;
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use glanz_color::read::{Place, ReadError};

use super::ReadOptions;

/// Why a reference could not be followed.
#[derive(Debug)]
pub enum ResolveError {
    /// It leads out of this folder.
    Outside(String),
    /// There is no such file.
    Missing,
    /// The file has more bytes than this.
    TooLarge {
        /// The most that is allowed.
        limit: u64,
        /// What the file has.
        found: u64,
    },
    /// The operating system refused.
    Io(io::Error),
}

impl ResolveError {
    /// The error as one of the file and place that hold the reference.
    pub(super) fn at(self, file: &str, place: Place, reference: &str) -> ReadError {
        let (file, reference) = (file.to_owned(), reference.to_owned());
        match self {
            Self::Outside(root) => ReadError::Outside { file, place, reference, root },
            Self::Missing => ReadError::Missing { file, place, reference },
            Self::TooLarge { limit, found } => {
                ReadError::TooLarge { file: reference, place: Place::File, limit, unit: "bytes", found }
            }
            Self::Io(source) => ReadError::Io { file: reference, place: Place::File, source },
        }
    }
}

/// Where the files come from that a model refers to.
pub trait Resolver {
    /// The bytes of the file that `reference` names.
    fn read(&self, reference: &str) -> Result<Vec<u8>, ResolveError>;
}

/// Knows no files.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Resolver for NoFiles {
    fn read(&self, _reference: &str) -> Result<Vec<u8>, ResolveError> {
        Err(ResolveError::Missing)
    }
}

/// Files in memory, by name.
impl Resolver for HashMap<String, Vec<u8>> {
    fn read(&self, reference: &str) -> Result<Vec<u8>, ResolveError> {
        self.get(reference).cloned().ok_or(ResolveError::Missing)
    }
}

/// Files in a folder and below.
#[derive(Clone, Debug)]
pub struct FolderFiles {
    folder: PathBuf,
    options: ReadOptions,
}

impl FolderFiles {
    /// References are relative to `folder`. They may not leave `options.root`, or `folder` itself
    /// where that is `None`.
    pub fn new(folder: &Path, options: &ReadOptions) -> Self {
        Self { folder: folder.to_owned(), options: options.clone() }
    }
}

impl Resolver for FolderFiles {
    fn read(&self, reference: &str) -> Result<Vec<u8>, ResolveError> {
        let path = resolve(&self.folder, reference, &self.options)?;
        let most = self.options.max_bytes.min(self.options.memory.left());
        let (file, len) = open(&path, most)?;
        let mut bytes = Vec::new();
        let memory = bytes.try_reserve_exact(len as usize);
        memory.map_err(|error| ResolveError::Io(io::Error::new(io::ErrorKind::OutOfMemory, error)))?;
        // The file may grow while it is read: the limit holds all the same.
        file.take(most).read_to_end(&mut bytes).map_err(ResolveError::Io)?;
        Ok(bytes)
    }
}

/// Opens a regular file of at most `max_bytes`, and tells its length. Devices and pipes, which may
/// have no end, are refused.
pub(super) fn open(path: &Path, max_bytes: u64) -> Result<(File, u64), ResolveError> {
    note_input(path);
    let of_io = |error: io::Error| match error.kind() {
        io::ErrorKind::NotFound => ResolveError::Missing,
        _ => ResolveError::Io(error),
    };
    // Asked before opening, since opening a pipe waits for its other end.
    let regular = std::fs::metadata(path).map_err(of_io)?.is_file();
    if !regular {
        return Err(ResolveError::Io(io::Error::new(io::ErrorKind::InvalidInput, "not a regular file")));
    }
    let file = File::open(path).map_err(of_io)?;
    let found = file.metadata().map_err(of_io)?.len();
    if found > max_bytes {
        return Err(ResolveError::TooLarge { limit: max_bytes, found });
    }
    Ok((file, found))
}

/// The path of the file that `reference` names, as seen from `folder`.
///
/// Unless `options.allow_outside`, it must lie in `options.root` (in `folder` where that is `None`),
/// also after all `..` and symbolic links. Both kinds of slash separate folders, so that files from
/// other systems work.
pub fn resolve(folder: &Path, reference: &str, options: &ReadOptions) -> Result<PathBuf, ResolveError> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let reference = reference.replace('\\', "/");
    let joined = folder.join(&reference);
    if options.allow_outside {
        return Ok(joined);
    }
    let root = options.root.as_deref().unwrap_or(folder);
    let root = if root.as_os_str().is_empty() { Path::new(".") } else { root };
    let outside = || ResolveError::Outside(root.display().to_string());
    let canonical_root = root.canonicalize().map_err(ResolveError::Io)?;
    let canonical_folder = folder.canonicalize().map_err(ResolveError::Io)?;
    // A drive letter is an absolute path on one system and a name on others: refused on all.
    let drive = reference.as_bytes().get(1) == Some(&b':');
    if drive || !without_dots(&canonical_folder.join(&reference)).starts_with(&canonical_root) {
        return Err(outside());
    }
    match joined.canonicalize() {
        Ok(path) if path.starts_with(&canonical_root) => Ok(path),
        Ok(_) => Err(outside()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Err(ResolveError::Missing),
        Err(error) => Err(ResolveError::Io(error)),
    }
}

/// The path with `.` and `..` taken out by their names alone.
fn without_dots(path: &Path) -> PathBuf {
    let mut clean = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                clean.pop();
            }
            other => clean.push(other),
        }
    }
    clean
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of its own for one test, removed at its end.
    struct Scratch(PathBuf);

    impl Scratch {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("glanz-resolve-{name}-{}", std::process::id()));
            std::fs::create_dir_all(path.join("inner/deep")).unwrap();
            std::fs::write(path.join("outer.txt"), b"outer").unwrap();
            std::fs::write(path.join("inner/a.txt"), b"a").unwrap();
            Self(path)
        }
    }

    impl Drop for Scratch {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    fn read(folder: &Path, reference: &str, options: &ReadOptions) -> Result<Vec<u8>, ResolveError> {
        FolderFiles::new(folder, options).read(reference)
    }

    #[test]
    fn references_inside_are_followed_and_others_refused() {
        let scratch = Scratch::new("inside");
        let (inner, options) = (scratch.0.join("inner"), ReadOptions::default());
        assert_eq!(read(&inner, "a.txt", &options).unwrap(), b"a");
        assert_eq!(read(&inner, "deep/../a.txt", &options).unwrap(), b"a");
        assert_eq!(read(&inner, "deep\\..\\a.txt", &options).unwrap(), b"a");
        let absolute = scratch.0.join("outer.txt").display().to_string();
        for reference in ["../outer.txt", "deep/../../outer.txt", &absolute, "/etc/passwd", "C:/x", "../none"]
        {
            let result = read(&inner, reference, &options);
            assert!(matches!(result, Err(ResolveError::Outside(_))), "{reference}: {result:?}");
        }
        assert!(matches!(read(&inner, "none.txt", &options), Err(ResolveError::Missing)));
    }

    #[test]
    fn a_wider_root_or_leave_allows_more() {
        let scratch = Scratch::new("root");
        let inner = scratch.0.join("inner");
        let wider = ReadOptions { root: Some(scratch.0.clone()), ..ReadOptions::default() };
        assert_eq!(read(&inner, "../outer.txt", &wider).unwrap(), b"outer");
        assert!(matches!(read(&inner, "../../x", &wider), Err(ResolveError::Outside(_))));
        let free = ReadOptions { allow_outside: true, ..ReadOptions::default() };
        assert_eq!(read(&inner, "../outer.txt", &free).unwrap(), b"outer");
    }

    #[cfg(unix)]
    #[test]
    fn symbolic_links_may_not_leave_either() {
        let scratch = Scratch::new("link");
        let inner = scratch.0.join("inner");
        std::os::unix::fs::symlink(scratch.0.join("outer.txt"), inner.join("link.txt")).unwrap();
        std::os::unix::fs::symlink("a.txt", inner.join("good.txt")).unwrap();
        let options = ReadOptions::default();
        assert!(matches!(read(&inner, "link.txt", &options), Err(ResolveError::Outside(_))));
        assert_eq!(read(&inner, "good.txt", &options).unwrap(), b"a");
    }

    #[test]
    fn folders_and_files_over_the_limit_are_refused() {
        let scratch = Scratch::new("limit");
        let options = ReadOptions { max_bytes: 4, ..ReadOptions::default() };
        let result = read(&scratch.0, "outer.txt", &options);
        assert!(matches!(result, Err(ResolveError::TooLarge { limit: 4, found: 5 })), "{result:?}");
        assert!(matches!(read(&scratch.0, "inner", &options), Err(ResolveError::Io(_))));
    }
}
