//! The reader of the text of pab's goniometers.

#![no_main]

use glanz_measure::{Format, fuzz};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| fuzz::read(Format::Pab, bytes));
