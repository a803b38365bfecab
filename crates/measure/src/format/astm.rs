//! ASTM E1392, the text that Cornell's goniometer writes: lines of keys, then rows of angles in radians with values.

use glanz_math::Vec3;

use super::{Data, Format, Measured, ReadOptions, text};
use crate::{Channels, ReadError, Readings};

/// Whether a text is one.
pub(super) fn is_astm(text: &str) -> bool {
    text.lines().take(200).any(|line| line.trim_start().starts_with("VARS"))
}

/// What stands above the rows.
struct Head {
    description: String,
    /// How many rows are announced.
    announced: Option<usize>,
    /// The line that names the columns: its number and its words.
    vars: (u32, String),
}

/// Where the numbers of a row are.
struct Columns {
    theta: [usize; 2],
    phi: [Option<usize>; 2],
    /// The first value.
    first: usize,
    channels: Channels,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let quantity = options.quantity.unwrap_or_default();
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let head = Head::read(&mut lines)?;
    let columns = Columns::of(&head.vars)?;
    let mut readings = Readings::new(columns.channels.clone());
    let (mut negative, mut below) = (0, 0);
    for (number, line) in lines {
        let row = columns.row(number, line)?;
        let [wi, wo] = columns.pair(&row);
        // What is no number is nowhere.
        let is_above = wi.z >= 0.0 && wo.z >= 0.0;
        if !is_above {
            below += 1;
            continue;
        }
        let value = |value: &f64| quantity.brdf(*value, wo.z).unwrap_or(f64::NAN) as f32;
        let values: Vec<f32> =
            row[columns.first..].iter().take(columns.channels.count()).map(value).collect();
        negative += usize::from(values.iter().any(|value| *value < 0.0));
        readings.push(wi, wo, &values);
    }
    if readings.is_empty() {
        return Err(ReadError::broken("there are no rows of readings"));
    }
    let mut notes = Vec::new();
    let rows = readings.len() + below;
    if let Some(announced) = head.announced.filter(|n| *n != rows) {
        notes.push(format!("NUM_POINTS is {announced}, but there are {rows} rows"));
    }
    if negative > 0 {
        notes.push(format!("{negative} readings have negative values, which are kept"));
    }
    if below > 0 {
        notes.push(format!("{below} rows below the horizon were dropped"));
    }
    let description = head.description;
    Ok(Measured { format: Format::Astm, quantity, description, data: Data::Readings(readings), notes })
}

impl Head {
    fn read<'a>(lines: &mut impl Iterator<Item = (u32, &'a str)>) -> Result<Self, ReadError> {
        let (mut description, mut announced) = (String::new(), None);
        for (number, line) in lines {
            let (key, rest) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
            let rest = rest.trim().trim_matches('"');
            match key {
                "VARS" => return Ok(Self { description, announced, vars: (number, rest.to_owned()) }),
                "NUM_POINTS" => announced = rest.parse::<usize>().ok(),
                "COMMENT" | "SAMPLE" | "SAMPLE_NAME" | "MATERIAL" | "SAMPLE_DESCRIPTION"
                    if description.is_empty() =>
                {
                    rest.clone_into(&mut description);
                }
                _ => {}
            }
        }
        Err(ReadError::broken("there is no line VARS that names the columns"))
    }
}

impl Columns {
    fn of((line, words): &(u32, String)) -> Result<Self, ReadError> {
        let names: Vec<&str> = words.split(',').map(str::trim).collect();
        let place = |name: &str| names.iter().position(|own| own.eq_ignore_ascii_case(name));
        // With three angles the azimuth that is there is the difference.
        let phi = ["phi_i", "phi_s"].map(place);
        let (Some(theta_i), Some(theta_o), Some(_)) = (place("theta_i"), place("theta_s"), phi[0].or(phi[1]))
        else {
            return Err(ReadError::at(*line, format!("VARS names no theta_i, theta_s and phi_s: {words}")));
        };
        let first =
            [Some(theta_i), Some(theta_o), phi[0], phi[1]].into_iter().flatten().max().unwrap_or(0) + 1;
        let channels = channels(&names[first.min(names.len())..]).ok_or_else(|| {
            ReadError::at(*line, format!("VARS names no values behind the angles: {words}"))
        })?;
        Ok(Self { theta: [theta_i, theta_o], phi, first, channels })
    }

    /// The numbers of a row.
    fn row(&self, number: u32, line: &str) -> Result<Vec<f64>, ReadError> {
        let row = text::row(number, line)?;
        let least = self.first + self.channels.count();
        if row.len() < least {
            return Err(ReadError::at(number, format!("expected {least} numbers, found {}", row.len())));
        }
        let mut angles = self.theta.into_iter().chain(self.phi.into_iter().flatten());
        match angles.all(|at| row[at].is_finite()) {
            true => Ok(row),
            false => Err(ReadError::at(number, "the angles of a row must be finite numbers")),
        }
    }

    /// The directions of a row, to the light and to the detector.
    fn pair(&self, row: &[f64]) -> [Vec3<f64>; 2] {
        [0, 1].map(|i| Vec3::from_angles(row[self.theta[i]], self.phi[i].map_or(0.0, |at| row[at])))
    }
}

/// What the names behind the angles are.
fn channels(names: &[&str]) -> Option<Channels> {
    let lower: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    let begins =
        |three: [&str; 3]| lower.len() >= 3 && lower.iter().zip(three).all(|(own, name)| own == name);
    if begins(["r", "g", "b"]) {
        return Some(Channels::Rgb);
    }
    if begins(["x", "y", "z"]) {
        return Some(Channels::Xyz);
    }
    let nm = |name: &String| name.trim_end_matches("nm").trim().parse::<f64>().ok();
    let list: Vec<f64> = lower.iter().map_while(nm).collect();
    if !list.is_empty() && list.windows(2).all(|pair| pair[0] < pair[1]) {
        return Some(Channels::Wavelengths(list));
    }
    lower.first().map(|_| Channels::Luminance)
}
