//! The reader of MERL's tables, as they are and with the numbers of one filled up.

#![no_main]

use glanz_measure::{Format, fuzz};
use libfuzzer_sys::fuzz_target;

/// 90 × 90 × 180 cells.
const HEAD: [u8; 12] = [90, 0, 0, 0, 90, 0, 0, 0, 180, 0, 0, 0];
const BYTES: usize = HEAD.len() + 3 * 90 * 90 * 180 * 8;

fuzz_target!(|bytes: &[u8]| fuzz::read_filled(Format::Merl, bytes, &HEAD, BYTES));
