//! The readers of re-radiation matrices: BFC-450 and text tables.

#![no_main]

use glanz_color::read::{read_bfc, read_matrix_csv, read_reradiation};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    for read in [read_reradiation, read_bfc, read_matrix_csv] {
        match read(bytes, "file") {
            Ok(matrix) => {
                assert_eq!(matrix.values.len(), matrix.out_nm.len() * matrix.in_nm.len());
                match matrix.to_reradiation() {
                    Ok(matrix) => assert!(matrix.is_finite()),
                    Err(error) => assert!(error.to_string().starts_with("expected ")),
                }
            }
            Err(error) => assert!(error.to_string().contains(": expected ")),
        }
    }
});
