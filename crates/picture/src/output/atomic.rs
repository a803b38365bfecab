//! Files that appear whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::OutputError;
use super::inputs::is_input;
use super::temporary::TEMPORARIES;

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
    let target = written_file(path)?;
    let failed = |action| move |source| OutputError::File { path: path.to_owned(), action, source };
    let old = fs::metadata(&target).ok();
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return into_stream(path, &target, write);
    }
    if is_input(&target) {
        return Err(OutputError::Input { path: path.to_owned() }.into());
    }
    let (temporary, file) = TEMPORARIES.create_beside(&target).map_err(failed("create a file beside it"))?;
    if let Some(old) = old {
        // Keeping the permissions is a courtesy: some file systems have none.
        let _ = file.set_permissions(old.permissions());
    }
    let (result, file) = fill(file, path, temporary.path(), write)?;
    file.sync_all().map_err(failed("write it to the disk"))?;
    drop(file);
    temporary.put_at(&target).map_err(failed("replace it"))?;
    Ok(result)
}

/// The file that [`write_atomically`] writes for a path: through links, also to what is not there. Two paths that lead
/// to one file have the same.
///
/// ```
/// use glanz_picture::output::written_file;
///
/// let folder = std::env::temp_dir();
/// assert_eq!(written_file(folder.join("./a.png"))?, written_file(folder.join("a.png"))?);
/// # Ok::<(), glanz_picture::output::OutputError>(())
/// ```
///
/// # Errors
/// [`OutputError::File`] for links in a circle.
pub fn written_file(path: impl AsRef<Path>) -> Result<PathBuf, OutputError> {
    /// More links than any system follows.
    const LINKS: usize = 40;
    let path = path.as_ref();
    let mut target = path.to_owned();
    for _ in 0..LINKS {
        if let Ok(whole) = fs::canonicalize(&target) {
            return Ok(whole);
        }
        match fs::read_link(&target) {
            // A relative link begins at the folder that it lies in.
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(in_whole_folder(target)),
        }
    }
    let source = io::Error::other("its links lead to no file");
    Err(OutputError::File { path: path.to_owned(), action: "follow it", source })
}

/// The path of a file that is not there, by the whole path of its folder.
fn in_whole_folder(path: PathBuf) -> PathBuf {
    let folder = path.parent().map(|folder| if folder == Path::new("") { Path::new(".") } else { folder });
    let folder = folder.and_then(|folder| fs::canonicalize(folder).ok());
    match folder.zip(path.file_name()) {
        Some((folder, name)) => folder.join(name),
        None => path,
    }
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
    let (temporary, file) = TEMPORARIES.create_beside(&beside).map_err(failed("create a temporary file"))?;
    let (result, _) = fill(file, path, temporary.path(), write)?;
    let mut whole = File::open(temporary.path()).map_err(failed("read a temporary file"))?;
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
    fn links_in_a_circle_are_an_error_and_stay() {
        use std::os::unix::fs::symlink;
        let folder = Folder::new("circle");
        symlink("b.png", folder.0.join("a.png")).unwrap();
        symlink("a.png", folder.0.join("b.png")).unwrap();
        let message = write(&folder.0.join("a.png"), "x").unwrap_err().to_string();
        assert!(message.contains("a.png: cannot follow it: its links lead to no file"), "{message}");
        assert!(fs::symlink_metadata(folder.0.join("a.png")).unwrap().is_symlink());
        assert_eq!(folder.names(), ["a.png", "b.png"]);
    }

    #[cfg(unix)]
    #[test]
    fn one_file_has_many_names() {
        use std::os::unix::fs::symlink;
        let folder = Folder::new("names-of-one");
        symlink(&folder.0, folder.0.join("same")).unwrap();
        symlink("a.png", folder.0.join("link.png")).unwrap();
        let of = |name: &str| written_file(folder.0.join(name)).unwrap();
        for name in ["./a.png", "same/a.png", "link.png", "same/link.png"] {
            // Before the file is there, and when it is.
            assert_eq!(of(name), of("a.png"), "{name}");
        }
        write(&folder.0.join("a.png"), "x").unwrap();
        assert_eq!(of("same/link.png"), of("a.png"));
        assert_ne!(of("b.png"), of("a.png"));
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
