//! The reader of LightTools' tables.

#![no_main]

use glanz_measure::{Format, fuzz};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| fuzz::read(Format::LightTools, bytes));
