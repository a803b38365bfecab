//! Whole files, and no more of them than they may have.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// The most bytes that a picture or a table of measurements may have; the anisotropic sets of the collections have some 100 MB.
pub(crate) const MOST_BYTES: u64 = 1 << 30;

/// Reads a file of at most so many bytes. Pipes are read, too; devices that have no end are not.
pub(crate) fn read_whole(path: &Path, most: u64) -> Result<Vec<u8>> {
    let too_large =
        |found| Error::new(ErrorKind::FileTooLarge, format!("expected at most {most} bytes, found {found}"));
    let file = File::open(path)?;
    let length = file.metadata()?.len();
    if length > most {
        return Err(too_large(length.to_string()));
    }
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(too_large("more".to_owned()));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_up_to_its_most() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
        let whole = std::fs::read(&path).unwrap();
        let length = whole.len() as u64;
        assert_eq!(read_whole(&path, length).unwrap(), whole);
        let error = read_whole(&path, length - 1).unwrap_err().to_string();
        assert_eq!(error, format!("expected at most {} bytes, found {length}", length - 1));
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_an_end_is_not_read() {
        let error = read_whole(Path::new("/dev/zero"), 1000).unwrap_err().to_string();
        assert_eq!(error, "expected at most 1000 bytes, found more");
    }
}
