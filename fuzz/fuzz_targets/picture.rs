//! The reader of pictures that are compared.

#![no_main]

use glanz_picture::compare::decode_picture;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match decode_picture(bytes, "file") {
    Ok(picture) => {
        let values = picture.width * picture.height;
        assert!(values > 0 && picture.rgb.iter().all(|plane| plane.len() == values));
        assert!(picture.rgb.iter().flatten().all(|value| value.is_finite()));
    }
    Err(error) => assert!(error.to_string().contains(": expected ")),
});
