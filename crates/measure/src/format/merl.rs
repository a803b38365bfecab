//! MERL's tables: 90 × 90 × 180 cells of half and difference angles, three planes of `f64`.
//!
//! The cells are those of the look-up that came with the data; a value is 1500, 1500/1.15 or 1500/1.66 times the BRDF.
//! Where nothing was measured, numbers are negative.

use core::f64::consts::{FRAC_PI_2, PI};

use glanz_math::Vec3;

use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, Quantity, ReadError, Readings};

/// Cells of θh, θd and φd.
const SIZE: [usize; 3] = [90, 90, 180];
const CELLS: usize = SIZE[0] * SIZE[1] * SIZE[2];
/// From the numbers to BRDF.
const SCALE: [f64; 3] = [1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0];
const BYTES: usize = 12 + CELLS * 3 * 8;

/// A table of an isotropic BRDF in RGB, in 1/sr.
#[derive(Clone, Debug, PartialEq)]
pub struct Merl {
    /// The numbers of the file, plane by plane.
    raw: Vec<f64>,
    quantity: Quantity,
}

/// Whether the dimensions stand at the beginning.
pub(super) fn is_merl(bytes: &[u8]) -> bool {
    dimensions(bytes).is_some_and(|dims| dims == SIZE) || bytes.len() == BYTES
}

fn dimensions(bytes: &[u8]) -> Option<[usize; 3]> {
    let word = |i: usize| Some(u32::from_le_bytes(bytes.get(4 * i..4 * i + 4)?.try_into().ok()?) as usize);
    Some([word(0)?, word(1)?, word(2)?])
}

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Measured, ReadError> {
    if dimensions(bytes) != Some(SIZE) {
        let [a, b, c] = dimensions(bytes).unwrap_or_default();
        return Err(ReadError::broken(format!(
            "the table has {a} × {b} × {c} cells, and MERL's have 90 × 90 × 180"
        )));
    }
    if bytes.len() < BYTES {
        return Err(ReadError::broken(format!("the file ends after {} of {BYTES} bytes", bytes.len())));
    }
    let quantity = options.quantity.unwrap_or_default();
    let numbers = bytes[12..BYTES].as_chunks::<8>().0;
    let table = Merl { raw: numbers.iter().map(|eight| f64::from_le_bytes(*eight)).collect(), quantity };
    let holes = (0..CELLS).filter(|cell| table.of_cell(*cell).is_none()).count();
    let below = (0..CELLS).filter(|cell| is_below(*cell)).count();
    let mut notes = Vec::new();
    if bytes.len() > BYTES {
        notes.push(format!("{} bytes behind the table were not read", bytes.len() - BYTES));
    }
    if holes > 0 {
        notes.push(format!("{holes} of {CELLS} cells have no data; {below} lie below the horizon"));
    }
    let data = Data::Merl(table);
    Ok(Measured { format: Format::Merl, quantity, description: String::new(), data, notes })
}

/// The directions to the light and to the detector in the middle of a cell, the half vector in the plane of x.
fn centre(cell: usize) -> [Vec3<f64>; 2] {
    let [h, d, p] = [cell / (SIZE[1] * SIZE[2]), cell / SIZE[2] % SIZE[1], cell % SIZE[2]];
    let part = (h as f64 + 0.5) / 90.0;
    let theta_h = part * part * FRAC_PI_2;
    let theta_d = (d as f64 + 0.5).to_radians();
    let phi_d = (p as f64 + 0.5).to_radians();
    let difference = Vec3::from_angles(theta_d, phi_d);
    let half = Vec3::from_angles(theta_h, 0.0);
    // Turned about y, so that z goes to the half vector.
    let (sin, cos) = (half.x, half.z);
    let wi = Vec3::new(
        cos * difference.x + sin * difference.z,
        difference.y,
        cos * difference.z - sin * difference.x,
    );
    let wo = half * (2.0 * wi.dot(half)) - wi;
    [wi, wo]
}

/// The middles of cells above the horizon.
pub(crate) fn cells() -> Vec<[Vec3<f64>; 2]> {
    (0..CELLS).filter(|cell| !is_below(*cell)).map(centre).collect()
}

fn is_below(cell: usize) -> bool {
    let [wi, wo] = centre(cell);
    wi.z <= 0.0 || wo.z <= 0.0
}

impl Merl {
    /// A table of a function: `f` gives the BRDF in RGB for a direction to the light and one to the detector. Cells below
    /// the horizon have none.
    pub fn of(f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> [f64; 3]) -> Self {
        let mut raw = vec![-1.0; 3 * CELLS];
        for cell in 0..CELLS {
            let [wi, wo] = centre(cell);
            if wi.z > 0.0 && wo.z > 0.0 {
                let value = f(wi, wo);
                (0..3).for_each(|c| raw[c * CELLS + cell] = value[c] / SCALE[c]);
            }
        }
        Self { raw, quantity: Quantity::Brdf }
    }

    /// The BRDF of a cell; nothing where one channel is below 0, which says that there is none.
    fn of_cell(&self, cell: usize) -> Option<[f64; 3]> {
        let raw = [0, 1, 2].map(|c| self.raw[c * CELLS + cell]);
        if raw.iter().any(|value| !value.is_finite() || *value < 0.0) {
            return None;
        }
        let [_, wo] = centre(cell);
        let value = |c: usize| self.quantity.brdf(raw[c] * SCALE[c], wo.z);
        Some([value(0)?, value(1)?, value(2)?])
    }

    /// The cell of a pair of directions: its numbers of θh, θd and φd.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::Merl;
    ///
    /// let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
    /// assert_eq!(Merl::cell(at(30.3, 10.0), at(41.2, 170.0)), [28, 35, 51]);
    /// ```
    pub fn cell(wi: Vec3<f64>, wo: Vec3<f64>) -> [usize; 3] {
        let half = (wi + wo).normalized();
        let around = libm::sqrt(half.x * half.x + half.y * half.y);
        let theta_h = libm::atan2(around, half.z);
        // Turned back about z, then about y.
        let (c, s) = if around > 0.0 { (half.x / around, half.y / around) } else { (1.0, 0.0) };
        let turned = Vec3::new(c * wi.x + s * wi.y, c * wi.y - s * wi.x, wi.z);
        let x = half.z * turned.x - around * turned.z;
        let z = around * turned.x + half.z * turned.z;
        let theta_d = libm::atan2(libm::sqrt(x * x + turned.y * turned.y), z);
        let mut phi_d = libm::atan2(turned.y, x);
        if phi_d < 0.0 {
            phi_d += PI;
        }
        let h = libm::sqrt((theta_h / FRAC_PI_2).max(0.0)) * 90.0;
        let of = |value: f64, n: usize| (value as usize).min(n - 1);
        [of(h, 90), of(theta_d / FRAC_PI_2 * 90.0, 90), of(phi_d / PI * 180.0, 180)]
    }

    /// The BRDF of the cell that a pair of directions falls into, in RGB; nothing below the horizon and where the cell has
    /// none.
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<[f64; 3]> {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return None;
        }
        let [h, d, p] = Self::cell(wi, wo);
        self.of_cell((h * SIZE[1] + d) * SIZE[2] + p)
    }

    /// The readings in the middle of all cells that have one, above the horizon.
    pub(crate) fn readings(&self) -> Readings {
        let mut readings = Readings::new(Channels::Rgb);
        for cell in 0..CELLS {
            let [wi, wo] = centre(cell);
            if let Some(value) = self.of_cell(cell).filter(|_| wi.z > 0.0 && wo.z > 0.0) {
                readings.push(wi, wo, &value.map(|value| value as f32));
            }
        }
        readings
    }
}

/// The bytes of a MERL file: those of a file that was read are the same.
pub fn write_merl(table: &Merl) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(BYTES);
    SIZE.iter().for_each(|n| bytes.extend((*n as u32).to_le_bytes()));
    table.raw.iter().for_each(|number| bytes.extend(number.to_le_bytes()));
    bytes
}
