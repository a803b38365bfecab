//! ASTM E1392, the text that Cornell's goniometer writes: lines of keys, then rows of angles in radians with values.

use glanz_math::Vec3;

use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, ReadError, Readings};

/// Whether a text is one.
pub(super) fn is_astm(text: &str) -> bool {
    text.lines().take(200).any(|line| line.trim_start().starts_with("VARS"))
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let quantity = options.quantity.unwrap_or_default();
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let (mut description, mut announced) = (String::new(), None);
    let vars = loop {
        let Some((number, line)) = lines.next() else {
            return Err(ReadError::broken("there is no line VARS that names the columns"));
        };
        let (key, rest) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
        match key {
            "VARS" => break (number, rest.to_owned()),
            "NUM_POINTS" => announced = rest.trim().trim_matches('"').parse::<usize>().ok(),
            "COMMENT" | "SAMPLE" | "MATERIAL" | "SAMPLE_DESCRIPTION" if description.is_empty() => {
                rest.trim().trim_matches('"').clone_into(&mut description);
            }
            _ => {}
        }
    };
    let names: Vec<&str> = vars.1.trim().trim_matches('"').split(',').map(str::trim).collect();
    let place = |name: &str| names.iter().position(|own| own.eq_ignore_ascii_case(name));
    // With three angles the azimuth that is there is the difference.
    let [phi_i, phi_o] = ["phi_i", "phi_s"].map(place);
    let (Some(theta_i), Some(theta_o), Some(_)) = (place("theta_i"), place("theta_s"), phi_i.or(phi_o))
    else {
        let message = format!("VARS names no theta_i, theta_s and phi_s: {}", vars.1.trim());
        return Err(ReadError::at(vars.0, message));
    };
    let first = [Some(theta_i), phi_i, Some(theta_o), phi_o].into_iter().flatten().max().unwrap_or(0) + 1;
    let channels = channels(&names[first.min(names.len())..]).ok_or_else(|| {
        ReadError::at(vars.0, format!("VARS names no values behind the angles: {}", vars.1.trim()))
    })?;
    let count = channels.count();
    let mut readings = Readings::new(channels);
    let (mut negative, mut below) = (0, 0);
    for (number, line) in lines {
        let row: Result<Vec<f64>, _> = line.split(',').map(|word| word.trim().parse::<f64>()).collect();
        let row = row
            .map_err(|_| ReadError::at(number, format!("expected numbers between commas, found '{line}'")))?;
        if row.len() < first + count {
            let message = format!("expected {} numbers, found {}", first + count, row.len());
            return Err(ReadError::at(number, message));
        }
        let azimuth = |place: Option<usize>| place.map_or(0.0, |at| row[at]);
        let wi = Vec3::from_angles(row[theta_i], azimuth(phi_i));
        let wo = Vec3::from_angles(row[theta_o], azimuth(phi_o));
        if wi.z < 0.0 || wo.z < 0.0 {
            below += 1;
            continue;
        }
        let values: Vec<f32> = row[first..first + count]
            .iter()
            .map(|value| quantity.brdf(*value, wo.z).unwrap_or(f64::NAN) as f32)
            .collect();
        negative += usize::from(values.iter().any(|value| *value < 0.0));
        readings.push(wi, wo, &values);
    }
    let mut notes = Vec::new();
    if let Some(announced) = announced.filter(|n| *n != readings.len() + below) {
        notes.push(format!("NUM_POINTS is {announced}, but there are {} rows", readings.len() + below));
    }
    if negative > 0 {
        notes.push(format!("{negative} readings have negative values, which are kept"));
    }
    if below > 0 {
        notes.push(format!("{below} rows below the horizon were dropped"));
    }
    if readings.is_empty() {
        return Err(ReadError::broken("there are no rows of readings"));
    }
    Ok(Measured { format: Format::Astm, quantity, description, data: Data::Readings(readings), notes })
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
