//! ALTA's text, and its numbers in binary: `#DIM`, `#PARAM_IN` and `#PARAM_OUT` say what the columns are, angles are in
//! radians.

use glanz_math::Vec3;

use super::coordinates::Coordinates;
use super::{Data, Format, Measured, ReadOptions, text};
use crate::{Channels, Quantity, ReadError, Readings};

/// Whether a line has one of the keys.
pub(super) fn is_alta(text: &str) -> bool {
    let mut lines = text.lines().take(200).map(str::trim_start);
    lines.any(|line| line.starts_with("#PARAM_IN") || line.starts_with("#DIM"))
}

/// Parametrisations that name a pair of directions, with their number of columns.
const PARAMETRISATIONS: [(&str, usize); 8] = [
    ("RUSIN_TH_PH_TD_PD", 4),
    ("RUSIN_TH_TD_PD", 3),
    ("RUSIN_TH_TD", 2),
    ("SPHERICAL_TL_PL_TV_PV", 4),
    ("ISOTROPIC_TV_TL_DPHI", 3),
    ("ISOTROPIC_TV_TL", 2),
    ("ISOTROPIC_TL_TV_PROJ_DPHI", 3),
    ("CARTESIAN", 6),
];

#[derive(Default)]
struct Head {
    dimensions: Option<[usize; 2]>,
    input: Option<(&'static str, usize)>,
    is_times_cosine: bool,
    is_xyz: bool,
    /// Columns after each value: none, a radius of confidence, or its bounds.
    intervals: usize,
    /// Rows of numbers in binary.
    samples: Option<usize>,
    is_big_endian: bool,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let mut head = Head::default();
    let mut rows = Rows::default();
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if let Some(key) = line.strip_prefix('#') {
            head.key(number, key.trim())?;
        } else if !line.is_empty() {
            rows.push(&head, number, &text::row(number, line)?, options)?;
        }
    }
    rows.measured(head.quantity(options))
}

/// How the last line of a head before numbers in binary begins.
const ENDS: [&str; 3] = ["#ALTA_END_HEADER", "#ALTA END HEADER", "#BEGIN_STREAM"];

/// The lines of a head longer than this are none.
const LONGEST_HEAD: usize = 1 << 16;

/// Whether a file has ALTA's head before numbers in binary.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(LONGEST_HEAD)];
    let lines = || head.split(|byte| *byte == b'\n').take(200);
    bytes.starts_with(b"#") && lines().any(|line| line.trim_ascii() == b"#FORMAT binary")
}

/// Rows of numbers of 64 bits after the head.
pub(super) fn read_binary(bytes: &[u8], options: &ReadOptions) -> Result<Measured, ReadError> {
    let (mut head, mut rows, mut rest, mut number) = (Head::default(), Rows::default(), bytes, 0);
    loop {
        let end = rest.iter().take(LONGEST_HEAD).position(|byte| *byte == b'\n');
        let end = end.ok_or_else(|| ReadError::broken(format!("the head must end with {}", ENDS[0])))?;
        let line = String::from_utf8_lossy(&rest[..end]).trim().to_owned();
        rest = &rest[end + 1..];
        number += 1;
        if ENDS.iter().any(|end| line.starts_with(end)) {
            break;
        }
        head.key(number, line.trim_start_matches('#').trim())?;
    }
    let columns = head.columns(number)?;
    let count =
        head.samples.ok_or_else(|| ReadError::broken("#SAMPLE_COUNT must say how many rows there are"))?;
    let bytes_of_row = 8 * columns;
    let found = rest.len() / bytes_of_row;
    if found < count {
        return Err(ReadError::broken(format!("#SAMPLE_COUNT says {count} rows, and {found} are there")));
    }
    for row in rest.chunks_exact(bytes_of_row).take(count) {
        let row: Vec<f64> = row.as_chunks::<8>().0.iter().map(|bytes| head.number(*bytes)).collect();
        rows.push(&head, number, &row, options)?;
    }
    rows.measured(head.quantity(options))
}

/// What is read of rows.
#[derive(Default)]
struct Rows {
    readings: Option<Readings>,
    /// How many were below the horizon.
    below: usize,
    /// How many had angles that are no numbers.
    nowhere: usize,
}

impl Rows {
    fn push(
        &mut self,
        head: &Head,
        number: u32,
        row: &[f64],
        options: &ReadOptions,
    ) -> Result<(), ReadError> {
        let (name, columns) = head.input(number)?;
        let channels = head.channels(number)?;
        let least = columns + channels.count();
        if row.len() < least {
            let message = format!("expected {least} numbers ({name} and values), found {}", row.len());
            return Err(ReadError::at(number, message));
        }
        let [wi, wo] = pair(name, row);
        // Numbers without a value, and those beyond all bounds, are no direction.
        let is_direction = |w: Vec3<f64>| (w.dot(w) - 1.0).abs() < 1e-6;
        if !is_direction(wi) || !is_direction(wo) {
            self.nowhere += 1;
            return Ok(());
        }
        let is_above = wi.z >= -1e-12 && wo.z >= -1e-12;
        if !is_above {
            self.below += 1;
            return Ok(());
        }
        let quantity = head.quantity(options);
        let of = |value: &f64| quantity.brdf(*value, wo.z).unwrap_or(f64::NAN) as f32;
        let values: Vec<f32> = row[columns..least].iter().map(of).collect();
        self.readings.get_or_insert_with(|| Readings::new(channels)).push(wi, wo, &values);
        Ok(())
    }

    fn measured(self, quantity: Quantity) -> Result<Measured, ReadError> {
        let readings =
            self.readings.ok_or_else(|| ReadError::broken("there are no rows above the horizon"))?;
        let told =
            |(count, what): (usize, &str)| (count > 0).then(|| format!("{count} rows {what} were dropped"));
        let dropped = [(self.below, "below the horizon"), (self.nowhere, "with angles that are no numbers")];
        let notes = dropped.into_iter().filter_map(told).collect();
        let data = Data::Readings(readings);
        Ok(Measured { format: Format::Alta, quantity, description: String::new(), data, notes })
    }
}

impl Head {
    fn key(&mut self, number: u32, line: &str) -> Result<(), ReadError> {
        let (key, words) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let words = words.trim();
        match key {
            "DIM" => {
                let sizes: Vec<usize> =
                    words.split_whitespace().map_while(|word| word.parse().ok()).take(2).collect();
                let [inputs, outputs] = sizes[..] else {
                    return Err(ReadError::at(number, format!("expected two numbers, found '{words}'")));
                };
                self.dimensions = Some([inputs, outputs]);
            }
            "PARAM_IN" => {
                let known = PARAMETRISATIONS.iter().find(|(name, _)| *name == words);
                self.input = Some(*known.ok_or_else(|| {
                    let names = PARAMETRISATIONS.map(|(name, _)| name).join(", ");
                    ReadError::at(
                        number,
                        format!("#PARAM_IN '{words}' names no pair of directions; known: {names}"),
                    )
                })?);
            }
            "PARAM_OUT" => {
                self.is_times_cosine = words.contains("COSINE_FACTOR");
                self.is_xyz = words.contains("XYZ");
            }
            "VS" => {
                let first = words.split_whitespace().next().and_then(|word| word.parse().ok());
                self.intervals = first.unwrap_or(0).min(2);
            }
            "SAMPLE_COUNT" => self.samples = words.parse().ok(),
            "ENDIAN" => self.is_big_endian = words == "big",
            "PRECISION" if words != "ieee754-double" => {
                return Err(ReadError::at(
                    number,
                    format!("expected #PRECISION ieee754-double, found '{words}'"),
                ));
            }
            _ => {}
        }
        Ok(())
    }

    fn input(&self, number: u32) -> Result<(&'static str, usize), ReadError> {
        let message = "#PARAM_IN must stand above the rows, and say what their angles are";
        self.input.ok_or_else(|| ReadError::at(number, message))
    }

    /// Numbers of a row in binary.
    fn columns(&self, number: u32) -> Result<usize, ReadError> {
        let (_, inputs) = self.input(number)?;
        Ok(inputs + self.channels(number)?.count() * (1 + self.intervals))
    }

    fn number(&self, bytes: [u8; 8]) -> f64 {
        if self.is_big_endian { f64::from_be_bytes(bytes) } else { f64::from_le_bytes(bytes) }
    }

    fn quantity(&self, options: &ReadOptions) -> Quantity {
        let said = if self.is_times_cosine { Quantity::BrdfCos } else { Quantity::Brdf };
        options.quantity.unwrap_or(said)
    }

    fn channels(&self, number: u32) -> Result<Channels, ReadError> {
        let (name, columns) = self.input.unwrap_or_default();
        match self.dimensions {
            Some([inputs, _]) if inputs != columns => {
                Err(ReadError::at(number, format!("{name} has {columns} numbers, and #DIM says {inputs}")))
            }
            Some([_, 1]) => Ok(Channels::Luminance),
            Some([_, 3]) if self.is_xyz => Ok(Channels::Xyz),
            Some([_, 3]) => Ok(Channels::Rgb),
            Some([_, n]) => Err(ReadError::at(number, format!("#DIM says {n} values, and must say 1 or 3"))),
            None => Err(ReadError::at(number, "#DIM must stand above the rows")),
        }
    }
}

/// The directions to the light and to the detector.
fn pair(name: &str, row: &[f64]) -> [Vec3<f64>; 2] {
    match name {
        "RUSIN_TH_PH_TD_PD" => Coordinates::HalfDifference.pair([row[0], row[1], row[2], row[3]]),
        "RUSIN_TH_TD_PD" => Coordinates::HalfDifference.pair([row[0], 0.0, row[1], row[2]]),
        "RUSIN_TH_TD" => Coordinates::HalfDifference.pair([row[0], 0.0, row[1], 0.0]),
        "SPHERICAL_TL_PL_TV_PV" => Coordinates::Spherical.pair([row[0], row[1], row[2], row[3]]),
        "ISOTROPIC_TV_TL_DPHI" => Coordinates::SphericalDifference.pair([row[1], 0.0, row[0], row[2]]),
        "ISOTROPIC_TV_TL" => Coordinates::SphericalDifference.pair([row[1], 0.0, row[0], 0.0]),
        "ISOTROPIC_TL_TV_PROJ_DPHI" => {
            let theta_o = libm::sqrt(row[1] * row[1] + row[2] * row[2]);
            Coordinates::SphericalDifference.pair([row[0], 0.0, theta_o, libm::atan2(row[2], row[1])])
        }
        // The viewer stands before the light.
        _ => [Vec3::new(row[3], row[4], row[5]).normalized(), Vec3::new(row[0], row[1], row[2]).normalized()],
    }
}
