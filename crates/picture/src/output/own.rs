//! Which files Glanz wrote itself.

use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The metadata stand before the pixels; more of a file is not read.
const HEAD: u64 = 1 << 16;
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Whether a file is a PNG or APNG whose metadata say that Glanz wrote it. What cannot be read is not.
///
/// ```
/// use glanz_picture::output::{Metadata, PictureData, is_own};
///
/// let path = std::env::temp_dir().join("glanz-doc-own.png");
/// PictureData::Codes8 { width: 1, height: 1, rgba: vec![255; 4] }.save(&path, &Metadata::default())?;
/// assert!(is_own(&path));
/// # std::fs::remove_file(&path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn is_own(path: impl AsRef<Path>) -> bool {
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    read.is_ok() && head.starts_with(SIGNATURE) && chunks(&head[SIGNATURE.len()..]).any(is_ours)
}

/// Type and content of the chunks before the pixels.
fn chunks(mut rest: &[u8]) -> impl Iterator<Item = (&[u8], &[u8])> {
    core::iter::from_fn(move || {
        let (length, after) = rest.split_first_chunk::<4>()?;
        let length = u32::from_be_bytes(*length) as usize;
        let (kind, after) = after.split_at_checked(4)?;
        let (content, after) = after.split_at_checked(length)?;
        // Behind the content stand four bytes of a checksum.
        rest = after.get(4..)?;
        (kind != b"IDAT").then_some((kind, content))
    })
}

/// Whether a chunk is a text that names the program as Glanz.
fn is_ours((kind, content): (&[u8], &[u8])) -> bool {
    kind == b"tEXt" && content.starts_with(b"Software\0glanz ")
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::output::{Metadata, PictureData};

    fn path(name: &str) -> PathBuf {
        std::env::temp_dir().join(format!("glanz-own-{}-{name}", std::process::id()))
    }

    #[test]
    fn a_picture_of_another_program_is_not_ours() {
        let path = path("other.png");
        let picture = || PictureData::Codes8 { width: 3, height: 2, rgba: vec![7; 24] };
        picture().save(&path, &Metadata::default()).unwrap();
        assert!(is_own(&path));
        let other = Metadata { software: "another".to_owned(), ..Metadata::default() };
        picture().save(&path, &other).unwrap();
        assert!(!is_own(&path));
        std::fs::remove_file(path).unwrap();
    }

    #[test]
    fn what_is_cut_or_missing_is_not_ours() {
        let path = path("cut");
        assert!(!is_own(&path));
        let whole = PictureData::Codes8 { width: 3, height: 2, rgba: vec![7; 24] }
            .to_bytes(crate::output::Format::Png, &Metadata::default())
            .unwrap();
        for length in [0, 4, 8, 20, 40] {
            std::fs::write(&path, &whole[..length]).unwrap();
            assert!(!is_own(&path), "{length}");
        }
        std::fs::remove_file(path).unwrap();
    }
}
