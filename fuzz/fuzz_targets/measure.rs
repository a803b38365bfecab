//! The readers of measured reflectance, the content says which, and that of published fits.

#![no_main]

use glanz_measure::{Measured, PublishedFit, ReadOptions};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(fits) = PublishedFit::read(&String::from_utf8_lossy(bytes)) {
        fits.iter().for_each(|fit| drop(fit.lobes()));
    }
    if let Ok(measured) = Measured::read(bytes, "file", &ReadOptions::default()) {
        let readings = measured.readings();
        for index in 0..readings.len() {
            assert_eq!(readings.values(index).len(), readings.channels().count());
            let [wi, wo] = readings.pair(index);
            drop((measured.value(wi, wo), measured.extended(wo, wi)));
        }
    }
});
