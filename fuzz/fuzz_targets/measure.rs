//! The readers of measured reflectance: the content says which.

#![no_main]

use glanz_measure::{Measured, ReadOptions};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(measured) = Measured::read(bytes, "file", &ReadOptions::default()) {
        let readings = measured.readings();
        for index in 0..readings.len() {
            assert_eq!(readings.values(index).len(), readings.channels().count());
        }
    }
});
