//! The reader of spectral pictures.

#![no_main]

use glanz_color::exr::read_spectral_exr;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match read_spectral_exr(bytes, "file", 64 << 20) {
    Ok(image) => {
        let pixels = image.width * image.height;
        assert!(image.emissive.iter().all(|band| band.values.len() == pixels));
        assert!(image.reflective.iter().all(|band| band.values.len() == pixels));
        if let Some(matrix) = image.reradiation_at(0, 0) {
            assert_eq!(matrix.values.len(), matrix.out_nm.len() * matrix.in_nm.len());
        }
    }
    Err(error) => assert!(error.to_string().contains(": expected ")),
});
