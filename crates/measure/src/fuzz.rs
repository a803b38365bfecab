//! The readers of files, each by itself whatever the content is, for fuzz targets. Not a part of the library's interface.

use crate::format::read_as;
use crate::{Format, Measured, PublishedFit, ReadError, ReadOptions};

/// Reads a file as one of this format, and looks at what was read: at readings, and at values between them.
pub fn read(format: Format, bytes: &[u8]) {
    if let Ok(measured) = checked(read_as(format, bytes, "file", &ReadOptions::default())) {
        look(&measured);
    }
}

/// Reads a file of a format whose files all have one length, which no fuzzer would find: the bytes after the head, over and over.
pub fn read_filled(format: Format, bytes: &[u8], head: &[u8], length: usize) {
    read(format, bytes);
    if !bytes.is_empty() {
        let mut filled = [head, &bytes.repeat(length.div_ceil(bytes.len()))].concat();
        filled.truncate(length);
        read(format, &filled);
    }
}

/// Reads published fits, and makes lobes of them.
pub fn read_fits(bytes: &[u8]) {
    if let Ok(fits) = checked(PublishedFit::read(&String::from_utf8_lossy(bytes))) {
        fits.iter().for_each(|fit| drop(fit.lobes()));
    }
}

/// An error says something, and its line counts from 1.
fn checked<T>(read: Result<T, ReadError>) -> Result<T, ReadError> {
    if let Err(error) = &read {
        assert!(!error.to_string().is_empty() && error.line() != Some(0), "{error:?}");
    }
    read
}

/// Readings that are looked at, so that large tables take no longer.
const LOOKED_AT: usize = 2000;

fn look(measured: &Measured) {
    let readings = measured.readings();
    let count = readings.channels().count();
    for index in (0..readings.len()).step_by(readings.len().div_ceil(LOOKED_AT).max(1)) {
        assert_eq!(readings.values(index).len(), count);
        let [wi, wo] = readings.pair(index);
        for w in [wi, wo] {
            assert!((w.dot(w) - 1.0).abs() < 1e-6, "a direction has the length 1: {w:?}");
        }
        for value in [measured.value(wi, wo), measured.extended(wo, wi)].into_iter().flatten() {
            assert_eq!(value.len(), count);
        }
    }
}
