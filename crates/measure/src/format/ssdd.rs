//! SSDD, the surface scattering distribution data of libbsdf: keys with words, then a value or a row of them for each node,
//! as text or as `f32`.

use super::coordinates::Coordinates;
use super::table::{Axis, Kind, Parts, Table};
use super::{Data, Format, Measured, ReadOptions, text};
use crate::{Channels, ReadError};

/// Whether the file begins with a version, and has a type of data.
pub(super) fn is_ssdd(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let mut lines = head.lines().map(|line| line.trim_start_matches('\u{feff}').trim());
    lines
        .find(|line| !line.is_empty() && !line.starts_with('#'))
        .is_some_and(|line| line.starts_with("VERSION"))
        && head.contains("DATA_TYPE")
}

/// Lines of a file that may have binary numbers in it.
struct Lines<'a> {
    rest: &'a [u8],
    line: u32,
}

impl<'a> Lines<'a> {
    /// The next line that says something, without its comment.
    fn next(&mut self) -> Option<String> {
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|byte| *byte == b'\n');
            let (line, rest): (&'a [u8], &'a [u8]) = match end {
                Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
                None => (self.rest, &[]),
            };
            (self.rest, self.line) = (rest, self.line + 1);
            let line = String::from_utf8_lossy(line);
            let words = line.trim_start_matches('\u{feff}').trim();
            let words =
                if words.starts_with('#') { "" } else { words.split(" # ").next().unwrap_or("").trim() };
            if !words.is_empty() {
                return Some(words.to_owned());
            }
        }
        None
    }
}

/// The keys above a table.
#[derive(Default)]
struct Head {
    data_type: String,
    name: String,
    model: String,
    wavelengths: Vec<f64>,
    parameters: String,
    reductions: String,
    lists: [Vec<f64>; 5],
}

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Measured, ReadError> {
    let mut lines = Lines { rest: bytes, line: 0 };
    let mut notes = Vec::new();
    let mut found: Option<(Head, Vec<f32>)> = None;
    while let Some((head, is_binary)) = Head::read(&mut lines)? {
        let values = head.values(&mut lines, is_binary)?;
        if head.data_type == "brdf" && found.is_none() {
            found = Some((head, values));
        } else {
            notes.push(format!("data of the type '{}' were not read", head.data_type));
        }
    }
    let Some((head, values)) = found else {
        return Err(ReadError::broken("the file has no data of the type brdf, and only reflectance is read"));
    };
    let quantity = options.quantity.unwrap_or_default();
    let description = head.name.clone();
    let data = Data::Table(Box::new(head.table(values, quantity)?));
    Ok(Measured { format: Format::Ssdd, quantity, description, data, notes })
}

impl Head {
    /// The keys up to the data, and whether these are binary; nothing at the end of the file.
    fn read(lines: &mut Lines) -> Result<Option<(Self, bool)>, ReadError> {
        let mut head = Self::default();
        while let Some(line) = lines.next() {
            let (key, words) = line.split_once(char::is_whitespace).unwrap_or((&line, ""));
            let words = words.trim();
            match key {
                "VERSION" if !words.starts_with("0.") => {
                    return Err(ReadError::at(lines.line, format!("version {words} is not known, only 0.x")));
                }
                "DATA_TYPE" => words.clone_into(&mut head.data_type),
                "NAME" => words.clone_into(&mut head.name),
                "COLOR_MODEL" => words.clone_into(&mut head.model),
                "WAVELENGTH_LIST" => head.wavelengths = text::row(lines.line, words)?,
                "PARAM_TYPE" => words.clone_into(&mut head.parameters),
                "REDUCTION_TYPE" => words.clone_into(&mut head.reductions),
                "PARAM0_LIST" => head.lists[0] = text::row(lines.line, words)?,
                "PARAM1_LIST" => head.lists[1] = text::row(lines.line, words)?,
                "PARAM2_LIST" => head.lists[2] = text::row(lines.line, words)?,
                "PARAM3_LIST" => head.lists[3] = text::row(lines.line, words)?,
                "PARAM4_LIST" => head.lists[4] = text::row(lines.line, words)?,
                "DATA" => return head.finished(lines.line, words).map(Some),
                _ if head.data_type.is_empty() || key.chars().all(|c| c.is_ascii_uppercase() || c == '_') => {
                }
                _ => return Err(ReadError::at(lines.line, format!("expected a key, found '{line}'"))),
            }
        }
        match head.data_type.is_empty() {
            true => Ok(None),
            false => Err(ReadError::at(lines.line, "the file ends before the key DATA")),
        }
    }

    fn finished(mut self, line: u32, mode: &str) -> Result<(Self, bool), ReadError> {
        if self.data_type.is_empty() || self.lists[0].is_empty() {
            return Err(ReadError::at(line, "DATA must stand below DATA_TYPE and PARAM0_LIST"));
        }
        // What is left out has one node.
        self.lists[1..4].iter_mut().filter(|list| list.is_empty()).for_each(|list| list.push(0.0));
        match mode {
            "ascii" => Ok((self, false)),
            "binary" => Ok((self, true)),
            _ => Err(ReadError::at(line, format!("expected DATA ascii or DATA binary, found '{mode}'"))),
        }
    }

    fn channels(&self, line: u32) -> Result<Channels, ReadError> {
        match self.model.as_str() {
            "monochrome" => Ok(Channels::Luminance),
            "rgb" => Ok(Channels::Rgb),
            "xyz" => Ok(Channels::Xyz),
            "spectrum" if self.wavelengths.windows(2).all(|pair| pair[0] < pair[1]) => {
                Ok(Channels::Wavelengths(self.wavelengths.clone()))
            }
            "spectrum" => Err(ReadError::at(line, "the wavelengths of WAVELENGTH_LIST must ascend")),
            other => {
                let expected = "monochrome, rgb, xyz or spectrum";
                Err(ReadError::at(line, format!("COLOR_MODEL is '{other}', and must be {expected}")))
            }
        }
    }

    /// The numbers in the order of the file: the first angle varies most quickly, then come the channels.
    fn values(&self, lines: &mut Lines, is_binary: bool) -> Result<Vec<f32>, ReadError> {
        let channels = self.channels(lines.line)?.count();
        let sizes = self.lists[..4].iter().map(Vec::len);
        let nodes = sizes.fold(1_usize, usize::saturating_mul);
        if is_binary {
            let count = nodes.saturating_mul(channels).saturating_mul(4);
            let Some((numbers, rest)) = lines.rest.split_at_checked(count) else {
                let message = format!("the file ends after {} of {count} bytes of data", lines.rest.len());
                return Err(ReadError::at(lines.line, message));
            };
            lines.rest = rest;
            return Ok(numbers.as_chunks::<4>().0.iter().map(|four| f32::from_le_bytes(*four)).collect());
        }
        let mut values = Vec::new();
        for node in 0..nodes {
            let Some(line) = lines.next() else {
                return Err(ReadError::at(
                    lines.line,
                    format!("the file ends after {node} of {nodes} values"),
                ));
            };
            let row = text::row(lines.line, &line)?;
            if row.len() != channels {
                let message = format!("expected {channels} numbers, found {}", row.len());
                return Err(ReadError::at(lines.line, message));
            }
            values.extend(row.iter().map(|value| *value as f32));
        }
        Ok(values)
    }

    fn table(self, values: Vec<f32>, quantity: crate::Quantity) -> Result<Table, ReadError> {
        let channels = self.channels(1)?;
        let coordinates = match self.parameters.as_str() {
            "spherical_coordinate_system" => Coordinates::Spherical,
            "specular_coordinate_system" => Coordinates::Specular,
            "half_difference_coordinate_system" => Coordinates::HalfDifference,
            other => return Err(ReadError::broken(format!("PARAM_TYPE '{other}' is not known"))),
        };
        if self.lists[4].iter().any(|offset| *offset != 0.0) {
            return Err(ReadError::broken("offsets from the mirror direction (PARAM4_LIST) are not read"));
        }
        let is_mirrored = self.reductions.contains("bilateral_symmetry");
        let is_reciprocal =
            self.reductions.contains("reciprocity") && coordinates == Coordinates::HalfDifference;
        let around = match (is_mirrored, is_reciprocal) {
            (false, false) => Kind::Azimuth,
            (true, false) => Kind::MirroredAzimuth,
            (false, true) => Kind::ReciprocalAzimuth,
            (true, true) => Kind::MirroredReciprocalAzimuth,
        };
        let kinds = [Kind::Polar, Kind::Azimuth, Kind::Polar, around];
        let axes = [0, 1, 2, 3].map(|axis| Axis::of_degrees(&self.lists[axis], kinds[axis]));
        let values = reversed(&values, [0, 1, 2, 3].map(|axis| self.lists[axis].len()), channels.count());
        Table::new(Parts { coordinates, channels, axes, quantity, values })
    }
}

/// The numbers with the last angle varying most quickly.
fn reversed(values: &[f32], [a, b, c, d]: [usize; 4], count: usize) -> Vec<f32> {
    let mut turned = Vec::with_capacity(values.len());
    for node in 0..a * b * c * d {
        let [l, rest] = [node % d, node / d];
        let [k, rest] = [rest % c, rest / c];
        let [j, i] = [rest % b, rest / b];
        let at = i + a * (j + b * (k + c * l));
        turned.extend_from_slice(&values[at * count..(at + 1) * count]);
    }
    turned
}
