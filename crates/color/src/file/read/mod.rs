//! Readers of spectra and of re-radiation matrices.
//!
//! | format | reader | written by |
//! |---|---|---|
//! | text tables: CSV, TSV, blanks | [`read_csv`] | [`write_csv`](crate::write::write_csv) |
//! | IES TM-27-14 `.spdx` | [`read_spdx`] | [`write_spdx`](crate::write::write_spdx) |
//! | JCAMP-DX `.jdx` | [`read_spectra`] | – |
//! | CGATS.17 `.txt` | [`read_cgats`] | – |
//! | CxF3 `.cxf` | [`read_cxf`] | – |
//! | n and k: text tables, `.spd` pairs, refractiveindex.info YAML | [`read_ior`] | – |
//! | Labsphere BFC-450 `.BFC` | [`read_bfc`] | – |
//! | text tables of re-radiation | [`read_matrix_csv`] | [`write_matrix_csv`](crate::write::write_matrix_csv) |
//! | spectral OpenEXR, with the feature `exr` | module [`exr`](crate::exr) | module `exr` |
//!
//! All take bytes and a file's name for messages, and open nothing themselves. A reader is total: it
//! returns what the file holds or one error that names file, place and what was expected. Its memory and
//! time are bounded by the size of the file, which is at most 16 MiB, never by a number that the file
//! claims; of a table of many samples, each is read with at most 16 KiB of the lines around it. What a reader had to assume stands in the `notes` of what it returns.
//!
//! ```
//! use glanz_color::read::{Quantity, read_spectra};
//!
//! let file = "wavelength (nm),leaf reflectance (%)\n400,5\n550,12\n700,45\n";
//! let spectra = read_spectra(file.as_bytes(), "leaf.csv")?;
//! assert_eq!(spectra[0].quantity, Quantity::Reflectance);
//! let (leaf, remarks) = spectra[0].to_spectrum(None)?;
//! assert!((leaf.at(550.0) - 0.12).abs() < 1e-12);
//! assert!(!remarks.is_empty(), "it was measured from 400 to 700 nm only");
//! let error = read_spectra(b"nm,a\n400,1\n410,x\n", "bad.csv").unwrap_err();
//! assert!(error.to_string().starts_with("bad.csv: line 3"));
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod error;
mod formats;
mod ior;
mod table;
#[cfg(test)]
mod tests;
mod text;
mod values;

pub use error::{Place, ReadError, excerpt};
pub use formats::bfc::read_bfc;
pub use formats::cgats::read_cgats;
pub use formats::cxf::read_cxf;
pub use formats::matrix::read_matrix_csv;
pub use formats::spdx::read_spdx;
pub use ior::{NamedIor, ior_partner, read_ior, read_ior_pair};
pub use table::read_csv;
pub use values::choice::{preferred, processed};
pub use values::named::NamedSpectrum;
pub use values::power::{PowerUnit, Radiometry};
pub use values::quantity::Quantity;
pub use values::reradiation::NamedReradiation;
pub use values::settle::{ReadOptions, ValueScale};
pub use values::units::Scale;

use formats::{cgats, cxf, jcamp, spdx};
pub(crate) use values::{named, reradiation};
use values::{settle, units};

/// How files begin that hold spectra, but no text, and what they are.
const BINARY: [(&[u8], &str); 6] = [
    (b"TM25", "a ray file of TM-25: rays, whose spectra are in their own binary sections"),
    (b"PK\x03\x04", "a ZIP archive, such as a .ProcSpec of Ocean Insight or an .xlsx spreadsheet"),
    (b"\xd0\xcf\x11\xe0", "a binary spreadsheet (.xls)"),
    (b"MATLAB 5.0 MAT-file", "a binary file of MATLAB (.mat)"),
    (b"\x89HDF", "a binary HDF5 file"),
    (b"AVS8", "a binary file of AvaSoft 8"),
];

/// The beginning of a file in which its format shows.
const SNIFFED: usize = 4096;

/// Reads spectra in whichever format the bytes are: `.spdx`, CxF3, CGATS, JCAMP-DX, a text table, or a spectral OpenEXR picture
/// (with the feature `exr`), of which a pixel is taken.
///
/// # Errors
///
/// [`ReadError`] of that format's reader.
pub fn read_spectra(bytes: &[u8], file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    read_spectra_with(bytes, file, &ReadOptions::default())
}

/// [`read_spectra`] with what is known of the file beside its bytes.
///
/// # Errors
///
/// [`ReadError`] of that format's reader.
pub fn read_spectra_with(
    bytes: &[u8],
    file: &str,
    options: &ReadOptions,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    if bytes.starts_with(&EXR_MAGIC) {
        return read_pixel(bytes, file, options);
    }
    if let Some((_, what)) = BINARY.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        let expected = "a table of text, .spdx, CxF, CGATS or JCAMP-DX (export the spectrum as text)";
        return Err(ReadError::malformed(file, Place::File, expected, *what));
    }
    let text = text::decode(bytes, file)?;
    let mut spectra = match format(&text, file)? {
        Format::Spdx => spdx::parse(&text, file),
        Format::Cxf => cxf::parse(&text, file),
        Format::Cgats => cgats::parse(&text, file),
        Format::Jcamp => jcamp::parse(&text, file),
        Format::Table => table::parse(&text, file, options.unit),
    }?;
    settle::settle(&mut spectra, options, file);
    if ior::is_half(file) {
        let text = "files of this name hold n or k of a medium (.eta.spd, .k.spd): --ior reads both";
        spectra.iter_mut().for_each(|spectrum| named::note(&mut spectrum.notes, text));
    }
    Ok(spectra)
}

/// The formats of spectra.
enum Format {
    Spdx,
    Cxf,
    Cgats,
    Jcamp,
    Table,
}

/// The format that a text is in.
fn format(text: &str, file: &str) -> Result<Format, ReadError> {
    if !text.trim_start().starts_with('<') {
        return Ok(match (cgats::is_cgats(text), jcamp::is_jcamp(text)) {
            (true, _) => Format::Cgats,
            (_, true) => Format::Jcamp,
            _ => Format::Table,
        });
    }
    let mut end = text.len().min(SNIFFED);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    let head = &text[..end];
    match (head.contains(spdx::ROOT), head.contains(cxf::ROOT)) {
        (true, _) => Ok(Format::Spdx),
        (_, true) => Ok(Format::Cxf),
        _ => {
            let expected = "an element 'IESTM2714' or 'CxF' in XML, or a text table";
            Err(ReadError::malformed(file, Place::File, expected, excerpt(head)))
        }
    }
}

/// Reads one format, with nothing known beside the bytes.
fn read_as(
    bytes: &[u8],
    file: &str,
    parse: impl FnOnce(&str, &str) -> Result<Vec<NamedSpectrum>, ReadError>,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let mut spectra = parse(&text::decode(bytes, file)?, file)?;
    settle::settle(&mut spectra, &ReadOptions::default(), file);
    Ok(spectra)
}

/// Reads a re-radiation matrix in whichever format the bytes are: `.BFC`, a text table, or a bispectral
/// OpenEXR picture, of which the pixel in the middle is taken (with the feature `exr`).
///
/// # Errors
///
/// [`ReadError`] of that format's reader.
pub fn read_reradiation(bytes: &[u8], file: &str) -> Result<NamedReradiation, ReadError> {
    if bytes.starts_with(&EXR_MAGIC) {
        return read_middle(bytes, file);
    }
    if is_bfc(bytes) { read_bfc(bytes, file) } else { read_matrix_csv(bytes, file) }
}

/// Whether the bytes are a re-radiation matrix of the BFC-450, by what stands at their beginning.
pub fn is_bfc(bytes: &[u8]) -> bool {
    bytes[..bytes.len().min(SNIFFED)].windows(7).any(|part| part == b"BFC-450")
}

/// How an OpenEXR file begins.
const EXR_MAGIC: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];

/// The most bytes that a spectral picture may take in memory.
const MAX_MATRIX_PICTURE: u64 = 1 << 30;

/// The spectra of a pixel of a spectral picture: the light that it sends, and what it reflects.
fn read_pixel(bytes: &[u8], file: &str, options: &ReadOptions) -> Result<Vec<NamedSpectrum>, ReadError> {
    let image = crate::file::exr::read_spectral_exr(bytes, file, MAX_MATRIX_PICTURE)?;
    let wrong = |expected: &str, found: &str| ReadError::malformed(file, Place::File, expected, found);
    let (x, y) = options.pixel.unwrap_or((image.width / 2, image.height / 2));
    if x >= image.width || y >= image.height {
        let size = format!("a picture of {}x{} pixels", image.width, image.height);
        return Err(wrong(&format!("a pixel {x}, {y}"), &size));
    }
    let mut spectra: Vec<_> =
        [image.light_at(x, y), image.reflectance_at(x, y)].into_iter().flatten().collect();
    if spectra.is_empty() {
        let (expected, found) = match image.reradiation.is_empty() {
            false => (
                "channels of light or reflectance (a re-radiation matrix has no single spectrum)",
                "those of re-radiation",
            ),
            true => ("channels of a spectrum, such as S0.550,000000nm", "a picture without them"),
        };
        return Err(wrong(expected, found));
    }
    let is_one = spectra.len() == 1;
    for spectrum in &mut spectra {
        let kind = if spectrum.quantity == Quantity::Light { " light" } else { " reflectance" };
        spectrum.name = table::stem(file) + if is_one { "" } else { kind };
        let (width, height) = (image.width, image.height);
        spectrum.notes.push(format!("the pixel {x}, {y} of {width}x{height} is taken"));
        if let Some(quantity) = options.quantity {
            spectrum.quantity = quantity;
        }
    }
    Ok(spectra)
}

/// The matrix of the pixel in the middle of a bispectral picture.
fn read_middle(bytes: &[u8], file: &str) -> Result<NamedReradiation, ReadError> {
    let image = crate::file::exr::read_spectral_exr(bytes, file, MAX_MATRIX_PICTURE)?;
    let (x, y) = (image.width / 2, image.height / 2);
    let mut matrix = image.reradiation_at(x, y).ok_or_else(|| {
        ReadError::malformed(
            file,
            Place::File,
            "channels of re-radiation such as T.380,000000nm.550,000000nm",
            "a picture without them",
        )
    })?;
    matrix.name = file.rsplit(['/', '\\']).next().unwrap_or(file).to_owned();
    matrix.notes.push(format!("the matrix of pixel {x}, {y} of {}x{} is taken", image.width, image.height));
    Ok(matrix)
}
