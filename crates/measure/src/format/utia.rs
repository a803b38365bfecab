//! UTIA's `.bin`: three planes of `f64` over θi, φi, θo and φo, every 15° and 7.5°.
//!
//! Angles from the normal end at 75°; beyond, values go on along the line through the last two, as in all readers.

use super::coordinates::Coordinates;
use super::table::{Axis, Kind, Parts, Table};
use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, ReadError};

/// Angles from the normal, and around it.
const SIZE: [usize; 2] = [6, 48];
const STEPS_DEG: [f64; 2] = [15.0, 7.5];
const PAIRS: usize = SIZE[0] * SIZE[1] * SIZE[0] * SIZE[1];
const BYTES: usize = 3 * PAIRS * 8;

/// Whether the length is right, and the bytes are no text.
pub(super) fn is_utia(bytes: &[u8]) -> bool {
    bytes.len() == BYTES && bytes.iter().any(|byte| *byte < 9 || *byte > 126)
}

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Measured, ReadError> {
    let numbers = bytes.as_chunks::<8>().0;
    if numbers.len() < 3 * PAIRS {
        return Err(ReadError::broken(format!("the file ends after {} of {BYTES} bytes", bytes.len())));
    }
    let mut values = vec![0.0; 3 * PAIRS];
    let mut negative = 0;
    for pair in 0..PAIRS {
        let [phi_o, rest] = [pair % SIZE[1], pair / SIZE[1]];
        let [theta_o, rest] = [rest % SIZE[0], rest / SIZE[0]];
        let [phi_i, theta_i] = [rest % SIZE[1], rest / SIZE[1]];
        // Both azimuths have the same steps, so that their difference has them, too.
        let difference = (phi_o + SIZE[1] - phi_i) % SIZE[1];
        let node = ((theta_i * SIZE[1] + phi_i) * SIZE[0] + theta_o) * SIZE[1] + difference;
        for channel in 0..3 {
            let raw = f64::from_le_bytes(numbers[channel * PAIRS + pair]);
            negative += usize::from(raw < 0.0);
            values[3 * node + channel] = value(raw, options) as f32;
        }
    }
    let axis = |around: usize, kind: Kind| {
        let nodes: Vec<f64> = (0..SIZE[around]).map(|step| step as f64 * STEPS_DEG[around]).collect();
        Axis::of_degrees(&nodes, kind)
    };
    let [theta, phi] = [axis(0, Kind::PolarContinued), axis(1, Kind::Azimuth)];
    let quantity = options.quantity.unwrap_or_default();
    let coordinates = Coordinates::SphericalDifference;
    let axes = [theta.clone(), phi.clone(), theta, phi];
    let table = Table::new(Parts { coordinates, channels: Channels::Rgb, axes, quantity, values })?;
    let mut notes = vec!["angles beyond 75° from the normal go on along the last two".to_owned()];
    if negative > 0 {
        notes.push(format!("{negative} numbers below 0 are taken as 0"));
    }
    if options.scale.is_none() && options.srgb_white.is_none() {
        notes.push("nothing says how the numbers are scaled: they are taken as they are".to_owned());
    }
    let data = Data::Table(Box::new(table));
    Ok(Measured { format: Format::Utia, quantity, description: String::new(), data, notes })
}

/// A number of the file as the options say that it is meant.
fn value(raw: f64, options: &ReadOptions) -> f64 {
    let decoded = match options.srgb_white {
        Some(white) => decoded_srgb((raw / white).max(0.0)),
        None => raw.max(0.0),
    };
    decoded * options.scale.unwrap_or(1.0)
}

/// The light of an encoded number, IEC 61966-2-1.
fn decoded_srgb(x: f64) -> f64 {
    if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) }
}
