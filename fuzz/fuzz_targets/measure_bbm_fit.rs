//! The reader of published fits, BBM's `.fit`.

#![no_main]

use glanz_measure::fuzz;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| fuzz::read_fits(bytes));
