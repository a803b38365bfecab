//! Files that appear whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::OutputError;
use super::inputs::is_input;

/// A file being written. Errors name the path that was asked for.
#[derive(Debug)]
pub struct TargetFile {
    file: BufWriter<File>,
    path: PathBuf,
    /// What is written to.
    written: PathBuf,
}

impl TargetFile {
    /// The file that was asked for.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The file that is filled: a temporary one beside the target. Another program may write to it in place of this one.
    pub fn written_path(&self) -> &Path {
        &self.written
    }

    fn named(&self, error: io::Error) -> io::Error {
        io::Error::new(error.kind(), format!("{}: cannot write: {error}", self.path.display()))
    }
}

impl Write for TargetFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map_err(|e| self.named(e))
    }
    fn flush(&mut self) -> io::Result<()> {
        self.file.flush().map_err(|e| self.named(e))
    }
}

impl Seek for TargetFile {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to).map_err(|e| self.named(e))
    }
}

/// Lets `write` fill a temporary file beside `path` and puts it in place of `path` at the end.
///
/// If `write` fails or panics, or the disk is full, the temporary file is removed and what was at
/// `path` stays as it was; it also stays if the program is killed. What is written has reached the disk before
/// it is put in place. A link is followed, also one to a file that is not there yet. A device or a pipe gets the
/// whole file at the end. The permissions of a file that is replaced are kept, and hold for the temporary one.
pub fn write_atomically<T, E: From<OutputError>>(
    path: impl AsRef<Path>,
    write: impl FnOnce(&mut TargetFile) -> Result<T, E>,
) -> Result<T, E> {
    let path = path.as_ref();
    let target = followed(path);
    let failed = |action| move |source| OutputError::File { path: path.to_owned(), action, source };
    let old = fs::metadata(&target).ok();
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return into_stream(path, &target, write);
    }
    if is_input(&target) {
        return Err(OutputError::Input { path: path.to_owned() }.into());
    }
    let (temporary, file) = create_beside(&target).map_err(failed("create a file beside it"))?;
    if let Some(old) = old {
        // Keeping the permissions is a courtesy: some file systems have none.
        let _ = file.set_permissions(old.permissions());
    }
    let (result, file) = fill(file, path, &temporary.0, write)?;
    file.sync_all().map_err(failed("write it to the disk"))?;
    drop(file);
    temporary.put_at(&target).map_err(failed("replace it"))?;
    Ok(result)
}

/// Where a path leads: through links, also to what is not there.
fn followed(path: &Path) -> PathBuf {
    /// More links than any system follows.
    const LINKS: usize = 40;
    let mut target = path.to_owned();
    for _ in 0..LINKS {
        if let Ok(whole) = fs::canonicalize(&target) {
            return whole;
        }
        match fs::read_link(&target) {
            // A relative link begins at the folder that it lies in.
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return target,
        }
    }
    path.to_owned()
}

/// Gives a device or a pipe a whole file, which some formats are written to with steps back.
fn into_stream<T, E: From<OutputError>>(
    path: &Path,
    target: &Path,
    write: impl FnOnce(&mut TargetFile) -> Result<T, E>,
) -> Result<T, E> {
    let failed = |action| move |source| OutputError::File { path: path.to_owned(), action, source };
    let mut stream = OpenOptions::new().write(true).open(target).map_err(failed("open"))?;
    let beside = std::env::temp_dir().join("glanz");
    let (temporary, file) = create_beside(&beside).map_err(failed("create a temporary file"))?;
    let (result, _) = fill(file, path, &temporary.0, write)?;
    let mut whole = File::open(&temporary.0).map_err(failed("read a temporary file"))?;
    io::copy(&mut whole, &mut stream).map_err(failed("write"))?;
    Ok(result)
}

fn fill<T, E: From<OutputError>>(
    file: File,
    path: &Path,
    written: &Path,
    write: impl FnOnce(&mut TargetFile) -> Result<T, E>,
) -> Result<(T, File), E> {
    let file = BufWriter::with_capacity(1 << 16, file);
    let mut file = TargetFile { file, path: path.to_owned(), written: written.to_owned() };
    let result = write(&mut file)?;
    file.flush().map_err(OutputError::Stream)?;
    let file = file.file.into_inner().map_err(|error| OutputError::Stream(error.into_error()))?;
    Ok((result, file))
}

/// The temporary files that there are now.
static TEMPORARIES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes all temporary files of [`write_atomically`]. It is for a program that is about to end because it was told to,
/// in the middle of writing: what it writes after this is lost, and the targets stay as they were.
pub fn remove_temporaries() {
    let mut temporaries = TEMPORARIES.lock().unwrap_or_else(PoisonError::into_inner);
    for path in temporaries.drain(..) {
        let _ = fs::remove_file(path);
    }
}

/// A file that is removed when this is dropped.
struct Temporary(PathBuf);

impl Temporary {
    fn new(path: PathBuf) -> Self {
        TEMPORARIES.lock().unwrap_or_else(PoisonError::into_inner).push(path.clone());
        Self(path)
    }

    fn put_at(self, target: &Path) -> io::Result<()> {
        fs::rename(&self.0, target)?;
        self.unlist();
        core::mem::forget(self);
        Ok(())
    }

    /// Takes the file off the list of those that are to be removed; false if it is not there any more.
    fn unlist(&self) -> bool {
        let mut temporaries = TEMPORARIES.lock().unwrap_or_else(PoisonError::into_inner);
        let place = temporaries.iter().position(|path| *path == self.0);
        place.map(|place| temporaries.swap_remove(place)).is_some()
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // Nothing is left to do if this fails: the error that led here is reported already.
        if self.unlist() {
            let _ = fs::remove_file(&self.0);
        }
    }
}

/// A new file in the folder of `target`; a name that is taken is passed over, so that processes
/// writing the same target do not meet.
fn create_beside(target: &Path) -> io::Result<(Temporary, File)> {
    /// File systems have names of at most 255 bytes.
    const LONGEST: usize = 240;
    let name = target.file_name().ok_or_else(|| io::Error::other("the path names no file"))?;
    let name = if name.len() > LONGEST { std::ffi::OsStr::new("glanz") } else { name };
    for attempt in 0..10_000 {
        let mut hidden = std::ffi::OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{attempt}.tmp"));
        let path = target.with_file_name(hidden);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((Temporary::new(path), file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(io::Error::other("ten thousand temporary files are in the way"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of its own for each test, removed at the end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("glanz-atomic-{name}-{}", std::process::id()));
            fs::create_dir_all(&path).unwrap();
            Self(path)
        }
        fn names(&self) -> Vec<String> {
            let entries = fs::read_dir(&self.0).unwrap();
            let mut names: Vec<_> =
                entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
            names.sort();
            names
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn write(path: &Path, text: &str) -> Result<(), OutputError> {
        write_atomically(path, |out| Ok(out.write_all(text.as_bytes())?))
    }

    #[test]
    fn a_file_is_made_and_replaced() {
        let folder = Folder::new("replace");
        let path = folder.0.join("a.png");
        write(&path, "one").unwrap();
        write(&path, "two").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(folder.names(), ["a.png"]);
    }

    #[test]
    fn a_failure_leaves_the_old_file_and_no_temporary() {
        let folder = Folder::new("failure");
        let path = folder.0.join("a.png");
        write(&path, "old").unwrap();
        let result: Result<(), OutputError> = write_atomically(&path, |out| {
            out.write_all(&[0; 200_000])?;
            Err(OutputError::Encode { format: "PNG", message: "broken".to_owned() })
        });
        assert!(result.is_err());
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(folder.names(), ["a.png"]);
    }

    #[test]
    fn a_panic_leaves_the_old_file_and_no_temporary() {
        let folder = Folder::new("panic");
        let path = folder.0.join("a.png");
        write(&path, "old").unwrap();
        let panicked = std::panic::catch_unwind(|| {
            write_atomically(&path, |_| -> Result<(), OutputError> { panic!("in the middle") })
        });
        assert!(panicked.is_err());
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(folder.names(), ["a.png"]);
    }

    #[test]
    fn the_old_file_is_whole_until_the_new_one_is() {
        let folder = Folder::new("until");
        let path = folder.0.join("a.png");
        write(&path, "old").unwrap();
        let seen = write_atomically(&path, |out| -> Result<String, OutputError> {
            out.write_all(b"new")?;
            out.flush()?;
            Ok(fs::read_to_string(&path)?)
        });
        assert_eq!(seen.unwrap(), "old");
    }

    #[test]
    fn a_leftover_of_a_killed_process_is_passed_over() {
        let folder = Folder::new("leftover");
        fs::write(folder.0.join(".a.png.0.tmp"), "left").unwrap();
        write(&folder.0.join("a.png"), "new").unwrap();
        assert_eq!(folder.names(), [".a.png.0.tmp", "a.png"]);
    }

    #[test]
    fn an_error_names_the_path() {
        let folder = Folder::new("names");
        let missing = folder.0.join("no/such/folder/a.png");
        let message = write(&missing, "x").unwrap_err().to_string();
        assert!(message.starts_with(&missing.display().to_string()), "{message}");
        assert!(write(&folder.0, "x").is_err(), "a folder is no file");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_an_error_that_names_the_path() {
        let message = write(Path::new("/dev/full"), "x").unwrap_err().to_string();
        assert!(message.starts_with("/dev/full: cannot write"), "{message}");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_permissions_are_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = Folder::new("link");
        let (real, link) = (folder.0.join("real.png"), folder.0.join("link.png"));
        write(&real, "old").unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&real, &link).unwrap();
        write(&link, "new").unwrap();
        assert_eq!(fs::read_to_string(&real).unwrap(), "new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
    }

    #[test]
    fn names_as_long_as_they_may_be_are_written() {
        let folder = Folder::new("long");
        let path = folder.0.join("x".repeat(255));
        write(&path, "one").unwrap();
        assert_eq!(folder.names(), ["x".repeat(255)]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_nothing_is_followed_and_a_hidden_file_stays_hidden() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = Folder::new("links");
        symlink("deep.png", folder.0.join("link.png")).unwrap();
        symlink("link.png", folder.0.join("second.png")).unwrap();
        write(&folder.0.join("second.png"), "one").unwrap();
        assert_eq!(folder.names(), ["deep.png", "link.png", "second.png"]);
        assert!(fs::symlink_metadata(folder.0.join("link.png")).unwrap().is_symlink());
        let path = folder.0.join("deep.png");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
        let seen: Result<u32, OutputError> = write_atomically(&path, |out| {
            out.write_all(b"two")?;
            Ok(fs::metadata(out.written_path()).unwrap().permissions().mode() & 0o777)
        });
        assert_eq!(seen.unwrap(), 0o600);
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_gets_the_whole_file_though_it_is_written_with_steps_back() {
        let folder = Folder::new("pipe");
        let path = folder.0.join("p.exr");
        if !std::process::Command::new("mkfifo").arg(&path).status().unwrap().success() {
            panic!("mkfifo is part of POSIX");
        }
        let reading = {
            let path = path.clone();
            std::thread::spawn(move || fs::read(path).unwrap())
        };
        let done: Result<(), OutputError> = write_atomically(&path, |out| {
            out.write_all(b"....five")?;
            out.seek(SeekFrom::Start(0))?;
            out.write_all(b"four")?;
            out.seek(SeekFrom::End(0))?;
            Ok(())
        });
        done.unwrap();
        assert_eq!(reading.join().unwrap(), b"fourfive");
    }
}
