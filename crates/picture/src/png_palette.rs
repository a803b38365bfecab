//! Palettes of PNG, before a decoder trusts them.

/// The bytes of the palette of a PNG file, if they are no whole entries of three bytes, 1 to 256 of them.
///
/// A decoder that takes such a palette reads beyond its end. What is no PNG has no palette.
///
/// ```
/// use glanz_picture::wrong_png_palette;
///
/// let chunk = |kind: &[u8; 4], data: &[u8]| {
///     [&(data.len() as u32).to_be_bytes()[..], kind, data, &[0; 4]].concat()
/// };
/// let png = |palette: &[u8]| {
///     [b"\x89PNG\r\n\x1a\n".to_vec(), chunk(b"IHDR", &[0; 13]), chunk(b"PLTE", palette)].concat()
/// };
/// assert_eq!(wrong_png_palette(&png(&[0; 6])), None);
/// assert_eq!(wrong_png_palette(&png(&[0; 4])), Some(4));
/// assert_eq!(wrong_png_palette(b"GIF89a"), None);
/// ```
pub fn wrong_png_palette(file: &[u8]) -> Option<usize> {
    const MOST: usize = 3 * 256;
    let mut rest = file.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    loop {
        let length = u32::from_be_bytes(*rest.first_chunk::<4>()?) as usize;
        let kind = rest.get(4..8)?;
        match kind {
            b"PLTE" => return (length == 0 || length > MOST || !length.is_multiple_of(3)).then_some(length),
            // The palette stands before the picture.
            b"IDAT" | b"IEND" => return None,
            // Length, kind and checksum are four bytes each.
            _ => rest = rest.get(length.checked_add(12)?..)?,
        }
    }
}
