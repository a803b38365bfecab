//! The reader of UTIA's tables, as they are and with the numbers of one filled up.

#![no_main]

use glanz_measure::{Format, fuzz};
use libfuzzer_sys::fuzz_target;

/// Three planes over 6 × 48 directions to the light and to the viewer.
const BYTES: usize = 3 * 6 * 48 * 6 * 48 * 8;

fuzz_target!(|bytes: &[u8]| fuzz::read_filled(Format::Utia, bytes, &[], BYTES));
