//! The reader of PLY files.

#![no_main]

mod check;

use glanz_scene::read::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| check::read(bytes, Format::Ply));
