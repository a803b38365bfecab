//! The bytes of a glTF file: the binary container, buffers, data URIs.

use std::borrow::Cow;

use glanz_color::read::{Place, ReadError, excerpt};

use super::super::context::{Context, LFS_POINTER, is_lfs_pointer};
use super::json::{Buffer, Root};

const JSON_CHUNK: u32 = 0x4e4f_534a;
const BINARY_CHUNK: u32 = 0x004e_4942;

/// The JSON of a file, and the binary chunk if it is a binary container that has one.
pub(super) fn split<'a>(bytes: &'a [u8], file: &str) -> Result<(&'a [u8], Option<&'a [u8]>), ReadError> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes, None));
    }
    let version = word(bytes, 4, file)?;
    if version != 2 {
        let found = format!("glTF {version}");
        return Err(ReadError::unsupported(file, Place::Byte(4), "version 2 of glTF", found));
    }
    let length = word(bytes, 8, file)? as usize;
    if length > bytes.len() || length < 20 {
        let expected = format!("a file of {length} bytes, as told here, and at least 20");
        return Err(malformed(file, 8, expected, format!("{} bytes", bytes.len())));
    }
    chunks(&bytes[..length], file)
}

/// The chunks of a binary container: JSON, and the binary one if there is one.
fn chunks<'a>(bytes: &'a [u8], file: &str) -> Result<(&'a [u8], Option<&'a [u8]>), ReadError> {
    let (mut json, mut binary, mut at) = (None, None, 12);
    // Up to three bytes of padding may be left.
    while at + 8 <= bytes.len() {
        let (size, kind) = (word(bytes, at, file)? as usize, word(bytes, at + 4, file)?);
        let end = (at + 8).checked_add(size).filter(|end| *end <= bytes.len());
        let Some(end) = end else {
            let expected = format!("a chunk of at most {} bytes", bytes.len() - at - 8);
            return Err(malformed(file, at, expected, format!("{size} bytes")));
        };
        let chunk = &bytes[at + 8..end];
        match (kind, json) {
            (JSON_CHUNK, None) => json = Some(chunk),
            (BINARY_CHUNK, Some(_)) if binary.is_none() => binary = Some(chunk),
            (_, None) => {
                return Err(malformed(file, at + 4, "the chunk 'JSON'", excerpt(kind.to_le_bytes())));
            }
            // Chunks of other kinds are for extensions.
            _ => {}
        }
        at = end;
    }
    match json {
        Some(json) => Ok((json, binary)),
        None => Err(malformed(file, 12, "the chunk 'JSON'", "the end of the file")),
    }
}

fn word(bytes: &[u8], at: usize, file: &str) -> Result<u32, ReadError> {
    let word = bytes.get(at..at + 4).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes);
    word.ok_or_else(|| malformed(file, at, "4 bytes", "the end of the file"))
}

fn malformed(file: &str, byte: usize, expected: impl Into<String>, found: impl Into<String>) -> ReadError {
    ReadError::malformed(file, Place::Byte(byte as u64), expected, found)
}

/// The buffers of a file.
pub(super) struct Buffers<'a> {
    buffers: Vec<Cow<'a, [u8]>>,
}

impl<'a> Buffers<'a> {
    /// Loads all buffers, each with as many bytes as it should have.
    pub(super) fn load(
        root: &Root,
        binary: Option<&'a [u8]>,
        context: &Context<'_>,
    ) -> Result<Self, ReadError> {
        let mut buffers = Vec::new();
        let mut total = 0u64;
        let compressed = root.buffers_of_compressed_views();
        for (index, buffer) in root.buffers.iter().enumerate() {
            let path = || Place::Path(format!("buffers[{index}]"));
            // Only the first buffer may be the binary chunk.
            let binary = binary.filter(|_| index == 0);
            let has_bytes = buffer.uri.is_some() || binary.is_some();
            // Some writers do not say of a buffer without bytes that its views are compressed elsewhere.
            if buffer.is_fallback() || (!has_bytes && compressed.contains(&index)) {
                buffers.push(Cow::Borrowed(&[][..]));
                continue;
            }
            let bytes = bytes_of(buffer, binary, path(), context)?;
            total += bytes.len() as u64;
            if total > context.options.max_bytes {
                return Err(ReadError::TooLarge {
                    file: context.file.to_owned(),
                    place: path(),
                    limit: context.options.max_bytes,
                    unit: "bytes in all buffers",
                    found: total,
                });
            }
            buffers.push(bytes);
        }
        Ok(Self { buffers })
    }

    /// How many bytes there are in all.
    pub(super) fn total(&self) -> u64 {
        self.buffers.iter().map(|buffer| buffer.len() as u64).sum()
    }

    /// Whether a buffer has no bytes.
    pub(super) fn is_empty(&self, index: usize) -> bool {
        self.buffers.get(index).is_some_and(|buffer| buffer.is_empty())
    }

    /// The bytes of a view and the distance between its items, if it tells one.
    pub(super) fn view(
        &self,
        root: &Root,
        index: usize,
        file: &str,
    ) -> Result<(&[u8], Option<usize>), ReadError> {
        let path = || Place::Path(format!("bufferViews[{index}]"));
        let view = root.buffer_views.get(index).ok_or_else(|| {
            let expected = format!("one of {} bufferViews", root.buffer_views.len());
            ReadError::malformed(file, path(), expected, "none")
        })?;
        let bytes = self.slice(view.buffer, view.byte_offset, view.byte_length, file, path)?;
        let stride = view.byte_stride.map(|stride| match stride {
            1..=252 => Ok(stride as usize),
            _ => Err(ReadError::malformed(file, path(), "a byteStride of 4 to 252", stride.to_string())),
        });
        Ok((bytes, stride.transpose()?))
    }

    /// Some bytes of a buffer, as the part of the file at `path` says.
    pub(super) fn slice(
        &self,
        index: usize,
        offset: u64,
        length: u64,
        file: &str,
        path: impl Fn() -> Place,
    ) -> Result<&[u8], ReadError> {
        let buffer = self.buffers.get(index).ok_or_else(|| {
            let expected = format!("one of {} buffers", self.buffers.len());
            ReadError::malformed(file, path(), expected, format!("buffer {index}"))
        })?;
        let end = offset.checked_add(length).filter(|end| *end <= buffer.len() as u64).ok_or_else(|| {
            let expected = format!("bytes within the {} of buffer {index}", buffer.len());
            ReadError::malformed(file, path(), expected, format!("{length} bytes from byte {offset} on"))
        })?;
        Ok(&buffer[offset as usize..end as usize])
    }
}

/// The bytes of a buffer, as many as it should have.
fn bytes_of<'a>(
    buffer: &Buffer,
    binary: Option<&'a [u8]>,
    place: Place,
    context: &Context<'_>,
) -> Result<Cow<'a, [u8]>, ReadError> {
    let mut bytes = match (&buffer.uri, binary) {
        (Some(uri), _) => Cow::Owned(load_uri(uri, place.clone(), context)?),
        (None, Some(binary)) => Cow::Borrowed(binary),
        (None, None) => {
            return Err(ReadError::malformed(context.file, place, "a uri or a binary chunk", "neither"));
        }
    };
    let found = bytes.len() as u64;
    if found < buffer.byte_length {
        let expected = format!("{} bytes (byteLength)", buffer.byte_length);
        return Err(ReadError::malformed(context.file, place, expected, format!("{found} bytes")));
    }
    match &mut bytes {
        Cow::Owned(bytes) => bytes.truncate(buffer.byte_length as usize),
        Cow::Borrowed(bytes) => *bytes = &bytes[..buffer.byte_length as usize],
    }
    Ok(bytes)
}

/// The bytes that a URI holds or names.
pub(super) fn load_uri(uri: &str, place: Place, context: &Context<'_>) -> Result<Vec<u8>, ReadError> {
    if let Some(data) = uri.strip_prefix("data:") {
        let text = data.split_once(";base64,").map(|(_, text)| text);
        return text
            .and_then(|text| decode_base64(text.as_bytes()))
            .ok_or_else(|| ReadError::malformed(context.file, place, "a data URI in base64", excerpt(uri)));
    }
    if uri.contains("://") {
        let expected = "data or the name of a file";
        return Err(ReadError::unsupported(context.file, place, expected, excerpt(uri)));
    }
    let reference = decode_percent(uri);
    let bytes = context
        .resolver
        .read(&reference)
        .map_err(|error| error.at(context.file, place.clone(), &reference))?;
    if is_lfs_pointer(&bytes) {
        let found = format!("{} in {}", LFS_POINTER, excerpt(&reference));
        return Err(ReadError::malformed(context.file, place, "the bytes of a buffer", found));
    }
    Ok(bytes)
}

/// Bytes from base64 (RFC 4648, §4); padding may be missing. `None` for anything else.
fn decode_base64(text: &[u8]) -> Option<Vec<u8>> {
    let end = text.len() - text.iter().rev().take(2).take_while(|byte| **byte == b'=').count();
    let text = &text[..end];
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 2);
    for group in text.chunks(4) {
        let mut word = 0u32;
        for byte in group {
            let six = match byte {
                b'A'..=b'Z' => byte - b'A',
                b'a'..=b'z' => byte - b'a' + 26,
                b'0'..=b'9' => byte - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => return None,
            };
            word = (word << 6) | u32::from(six);
        }
        word <<= 6 * (4 - group.len());
        let three = word.to_be_bytes();
        match group.len() {
            1 => return None,
            count => bytes.extend_from_slice(&three[1..count]),
        }
    }
    Some(bytes)
}

/// A URI's path with its `%XX` replaced by the bytes that they mean.
pub(super) fn decode_percent(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut left = uri.as_bytes();
    while let [first, tail @ ..] = left {
        let hex = |byte: &u8| (*byte as char).to_digit(16);
        match (first, tail) {
            (b'%', [high, low, tail @ ..]) if hex(high).is_some() && hex(low).is_some() => {
                let value = hex(high).zip(hex(low)).map_or(0, |(high, low)| 16 * high + low);
                bytes.push(value as u8);
                left = tail;
            }
            _ => {
                bytes.push(*first);
                left = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_has_the_test_vectors_of_rfc_4648() {
        let vectors = [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmE", "fooba")];
        for (text, bytes) in vectors {
            assert_eq!(decode_base64(text.as_bytes()).as_deref(), Some(bytes.as_bytes()));
        }
        for wrong in ["Z", "Zg==Zg==", "Zm9\n", "===="] {
            assert_eq!(decode_base64(wrong.as_bytes()), None, "{wrong}");
        }
    }

    #[test]
    fn percent_signs_that_mean_nothing_stay() {
        assert_eq!(decode_percent("a%20b%2Fc%zz%4"), "a b/c%zz%4");
    }
}
