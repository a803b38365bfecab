//! Lanes: vectors of 16 numbers give the bits of scalar `f32`, at every SIMD level.

use crate::DirectionPair;
use crate::laws::grid::{Place, places_anywhere};
use crate::laws::subject::{ONLY_F64, Subject};
use crate::laws::verdict::{Finding, Law};

/// The levels that exist; those that this machine lacks are left out.
const LEVELS: [&str; 6] = ["scalar", "sse2", "avx2", "avx512", "neon", "simd128"];

/// Looks for a lane that differs, at any level of this machine.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_values() {
        return Finding::not_applicable(Law::Lanes, reason);
    }
    let places = places_anywhere(subject);
    let mut levels = Vec::new();
    let mut worst: (f64, Option<(Place, &str)>) = (0.0, None);
    for level in LEVELS {
        for sixteen in places.chunks_exact(16) {
            let pairs: [DirectionPair<f32>; 16] = core::array::from_fn(|i| sixteen[i].pair_f32());
            let Some(values) = subject.value_lanes(level, &pairs) else { break };
            if levels.last() != Some(&level) {
                levels.push(level);
            }
            for ((pair, value), place) in pairs.iter().zip(values).zip(sixteen) {
                let scalar = subject.value_f32(pair).unwrap_or(f32::NAN);
                if scalar.to_bits() != value.to_bits() {
                    let off = f64::from((value - scalar).abs());
                    worst =
                        if worst.1.is_none() || off > worst.0 { (off, Some((*place, level))) } else { worst };
                }
            }
        }
    }
    if levels.is_empty() {
        return Finding::not_applicable(Law::Lanes, ONLY_F64);
    }
    let detail = match worst.1 {
        Some((place, level)) => format!("{level} is off by {:.1e} 1/sr: {}", worst.0, place.words()),
        None => "16 lanes give the bits of scalar f32".to_owned(),
    };
    Finding::judged(Law::Lanes, subject.info(), worst.1.is_none(), worst.0, detail)
}
