//! The reader of scene files, in a folder without other files.

#![no_main]

use std::path::Path;

use glanz_scene::file::{LoadOptions, parse_str};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    if let Err(error) = parse_str(text, Path::new("/nonexistent"), &LoadOptions::default()) {
        assert!(!error.to_string().is_empty());
    }
});
