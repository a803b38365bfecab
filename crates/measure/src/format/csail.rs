//! The anisotropic tables of MIT CSAIL (A. Ngan, F. Durand, W. Matusik 2005): 16 numbers, then planes of `f32` for red,
//! green and blue over θi, θo, φo − φi and φi, in cells of even steps. Numbers below 0 are no data.

use super::coordinates::Coordinates;
use super::table::{Axis, Kind, Parts, Table};
use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, ReadError};

const HEAD: usize = 64;

/// The 16 numbers at the beginning.
fn head(bytes: &[u8]) -> Option<[i32; 16]> {
    let mut numbers = [0; 16];
    let words = bytes.get(..HEAD)?.as_chunks::<4>().0;
    numbers.iter_mut().zip(words).for_each(|(number, word)| *number = i32::from_le_bytes(*word));
    Some(numbers)
}

/// The cells of θi, θo, φo − φi and φi, if the file is as long as they say.
fn sizes(bytes: &[u8]) -> Option<[usize; 4]> {
    let head = head(bytes)?;
    let sizes = [head[0], head[1], head[2], head[3]].map(|n| usize::try_from(n).unwrap_or(0));
    let count = sizes.iter().try_fold(3 * 4, |all: usize, n| all.checked_mul(*n))?;
    (head[10] == 3 && count > 0 && count.checked_add(HEAD)? == bytes.len()).then_some(sizes)
}

/// Whether the numbers at the beginning fit the length.
pub(super) fn is_csail(bytes: &[u8]) -> bool {
    sizes(bytes).is_some()
}

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Measured, ReadError> {
    let (Some(head), Some(sizes)) = (head(bytes), sizes(bytes)) else {
        return Err(ReadError::broken("the file is not as long as the numbers at its beginning say"));
    };
    if head[6] != 1 || head[7] != 0 {
        let message = "the parametrisation and the cells are to be the standard ones, 1 and 0";
        return Err(ReadError::broken(format!("{message}, and are {} and {}", head[6], head[7])));
    }
    let scale = options.scale.unwrap_or(1.0);
    let (values, holes) = values(&bytes[HEAD..], sizes, scale);
    let quantity = options.quantity.unwrap_or_default();
    let coordinates = Coordinates::SphericalDifference;
    let axes = axes(sizes, head[9] == 1);
    let table = Table::new(Parts { coordinates, channels: Channels::Rgb, axes, quantity, values })?;
    let mut notes = Vec::new();
    if holes > 0 {
        notes.push(format!("{holes} of {} cells have no data", sizes.iter().product::<usize>()));
    }
    if options.scale.is_none() {
        notes.push("nothing says how the numbers are scaled: they are taken as they are".to_owned());
    }
    let data = Data::Table(Box::new(table));
    Ok(Measured { format: Format::Csail, quantity, description: String::new(), data, notes })
}

/// The numbers in the order of the table, θi, φi, θo, difference and channel, and how many cells have none.
fn values(bytes: &[u8], [theta_i, theta_o, difference, phi_i]: [usize; 4], scale: f64) -> (Vec<f32>, usize) {
    let cells = theta_i * theta_o * difference * phi_i;
    let numbers = bytes.as_chunks::<4>().0;
    let mut values = Vec::with_capacity(3 * cells);
    let mut holes = 0;
    for node in 0..cells {
        let [d, rest] = [node % difference, node / difference];
        let [o, rest] = [rest % theta_o, rest / theta_o];
        let [p, i] = [rest % phi_i, rest / phi_i];
        let cell = p + phi_i * (d + difference * (o + theta_o * i));
        let raw = [0, 1, 2].map(|c| f64::from(f32::from_le_bytes(numbers[c * cells + cell])));
        let is_hole = raw.iter().any(|x| !x.is_finite() || *x < 0.0);
        holes += usize::from(is_hole);
        values.extend(raw.map(|x| if is_hole { f32::NAN } else { (x * scale) as f32 }));
    }
    (values, holes)
}

/// The middles of the cells; with half of the data, differences go to 180° only.
fn axes([theta_i, theta_o, difference, phi_i]: [usize; 4], is_half: bool) -> [Axis; 4] {
    let middles = |n: usize, most: f64, kind: Kind| {
        let nodes: Vec<f64> = (0..n).map(|i| (i as f64 + 0.5) * most / n as f64).collect();
        Axis::of_degrees(&nodes, kind)
    };
    [
        middles(theta_i, 90.0, Kind::Polar),
        middles(phi_i, 360.0, Kind::Azimuth),
        middles(theta_o, 90.0, Kind::Polar),
        match is_half {
            true => middles(difference, 180.0, Kind::MirroredAzimuth),
            false => middles(difference, 360.0, Kind::Azimuth),
        },
    ]
}
