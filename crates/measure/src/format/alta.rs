//! The text of ALTA: `#DIM`, `#PARAM_IN` and `#PARAM_OUT` say what the columns are, angles are in radians.

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
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let mut head = Head::default();
    let mut readings: Option<Readings> = None;
    let mut below = 0;
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if let Some(key) = line.strip_prefix('#') {
            head.key(number, key.trim())?;
            continue;
        }
        if line.is_empty() {
            continue;
        }
        let (name, columns) = head.input.ok_or_else(|| {
            ReadError::at(number, "#PARAM_IN must stand above the rows, and say what their angles are")
        })?;
        let channels = head.channels(number)?;
        let row = text::row(number, line)?;
        let least = columns + channels.count();
        if row.len() < least {
            let message = format!("expected {least} numbers ({name} and values), found {}", row.len());
            return Err(ReadError::at(number, message));
        }
        let [wi, wo] = pair(name, &row);
        let is_above = wi.z >= -1e-12 && wo.z >= -1e-12;
        if !is_above {
            below += 1;
            continue;
        }
        let quantity = head.quantity(options);
        let of = |value: &f64| quantity.brdf(*value, wo.z).unwrap_or(f64::NAN) as f32;
        let values: Vec<f32> = row[columns..least].iter().map(of).collect();
        readings.get_or_insert_with(|| Readings::new(channels)).push(wi, wo, &values);
    }
    let readings = readings.ok_or_else(|| ReadError::broken("there are no rows above the horizon"))?;
    let notes = if below > 0 { vec![format!("{below} rows below the horizon were dropped")] } else { vec![] };
    let (quantity, data) = (head.quantity(options), Data::Readings(readings));
    Ok(Measured { format: Format::Alta, quantity, description: String::new(), data, notes })
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
            _ => {}
        }
        Ok(())
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
