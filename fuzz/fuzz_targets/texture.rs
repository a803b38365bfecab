//! The reader of pictures.

#![no_main]

use glanz_scene::read::{ReadOptions, read_texture};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let options =
        ReadOptions { memory: glanz_math::MemoryBudget::of_bytes(64 << 20), ..ReadOptions::default() };
    match read_texture(bytes, "file", &options) {
        Ok(texture) => {
            assert_eq!(texture.rgba.len() as u64, 4 * u64::from(texture.width) * u64::from(texture.height))
        }
        Err(error) => assert!(error.to_string().contains(": expected ")),
    }
});
