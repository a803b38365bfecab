//! The readers of spectra: text tables, TM-27, CGATS and CxF3, by the content and each for itself.

#![no_main]

use glanz_color::TableError;
use glanz_color::read::{read_cgats, read_csv, read_cxf, read_spdx, read_spectra};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    for read in [read_spectra, read_csv, read_spdx, read_cgats, read_cxf] {
        match read(bytes, "file") {
            Ok(spectra) => {
                assert!(!spectra.is_empty());
                for spectrum in spectra {
                    assert_eq!(spectrum.nm.len(), spectrum.values.len());
                    assert!(spectrum.nm.windows(2).all(|pair| pair[0] < pair[1]));
                    let found = spectrum.to_spectrum(None);
                    let is_negative = matches!(found, Err(TableError::Negative { .. }));
                    assert!(is_negative || found.is_ok() == (spectrum.nm.len() > 1));
                }
            }
            Err(error) => assert!(error.to_string().contains(": expected ")),
        }
    }
});
