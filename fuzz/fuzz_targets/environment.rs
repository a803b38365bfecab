//! The readers of surroundings: Radiance HDR and OpenEXR.

#![no_main]

use glanz_scene::read::{ReadOptions, read_environment};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let options =
        ReadOptions { memory: glanz_math::MemoryBudget::of_bytes(64 << 20), ..ReadOptions::default() };
    match read_environment(bytes, "file", &options) {
        Ok((map, _)) => {
            assert!(map.width > 0 && map.pixels.len() == map.width * map.height);
            assert!(map.pixels.iter().flatten().all(|value| value.is_finite() && *value >= 0.0));
        }
        Err(error) => assert!(error.to_string().contains(": expected ")),
    }
});
