//! A table with a pair of directions in each line, its columns known by their names.

use glanz_math::Vec3;
use glanz_math::names::did_you_mean;
use thiserror::Error;

/// Columns of angles in degrees.
const ANGLES: [&str; 4] = ["theta_o_deg", "phi_o_deg", "theta_i_deg", "phi_i_deg"];
/// Columns of unit vectors, z along the normal.
const VECTORS: [&str; 6] = ["wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z"];
/// How far a vector's length may be from 1: the rounding of three digits.
const LENGTH: f64 = 2e-3;
/// Fields longer than this are cut in messages.
const LONGEST: usize = 40;

/// Why a table cannot be used.
#[derive(Debug, Clone, PartialEq, Error)]
pub(super) enum TableError {
    /// There is not even a first line.
    #[error("expected a line with the names of columns, found an empty table")]
    Empty,
    /// A line that no table has.
    #[error("line {line}: expected at most {most} bytes, found more")]
    LongLine {
        /// The line, from 1.
        line: usize,
        /// The most bytes that it may have.
        most: u64,
    },
    /// Bytes that are no UTF-8.
    #[error("line {line}: expected text in UTF-8, found other bytes")]
    NoText {
        /// The line, from 1.
        line: usize,
    },
    /// Directions are missing, or there are both angles and vectors.
    #[error("line {line}: expected either the columns {} or {}; {found}", ANGLES.join(", "), VECTORS.join(", "))]
    Header {
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        found: String,
    },
    /// A line with another number of fields than the first.
    #[error("line {line}: expected {expected} fields as in the first line, found {found}")]
    Fields {
        /// The line, from 1.
        line: usize,
        /// How many the first line has.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A field that is not what its column says.
    #[error("line {line}, column {column} ({name}): expected {expected}, found {found}")]
    Value {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The column's name.
        name: &'static str,
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
}

impl TableError {
    /// The line that it is in, from 1.
    pub(super) fn line(&self) -> Option<usize> {
        match self {
            Self::Empty => None,
            Self::LongLine { line, .. }
            | Self::NoText { line }
            | Self::Header { line, .. }
            | Self::Fields { line, .. }
            | Self::Value { line, .. } => Some(*line),
        }
    }
}

/// Where the directions are in a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Columns {
    separator: char,
    count: usize,
    /// The names of the columns used and their numbers from 0.
    used: Vec<(&'static str, usize)>,
}

impl Columns {
    /// Finds the columns by the names in the first line.
    pub(super) fn of_header(text: &str, line: usize) -> Result<Self, TableError> {
        let separator = [',', ';', '\t'].into_iter().find(|c| text.contains(*c)).unwrap_or(',');
        let names: Vec<_> = fields(text, separator).into_iter().map(|name| name.trim().to_owned()).collect();
        let failed = |found: String| Err(TableError::Header { line, found });
        let places = |wanted: &[&'static str]| -> Vec<(&'static str, usize)> {
            let place = |name: &&'static str| Some((*name, names.iter().position(|own| own == name)?));
            wanted.iter().filter_map(place).collect()
        };
        let (angles, vectors) = (places(&ANGLES), places(&VECTORS));
        let used = match (angles.len(), vectors.len()) {
            (4, 0) => angles,
            (0, 6) => vectors,
            (0, 0) => return failed(format!("none of them is there{}", nearest(&names))),
            (4, _) | (_, 6) => return failed("there are columns of both".to_owned()),
            _ => {
                let wanted = if vectors.len() > angles.len() { &VECTORS[..] } else { &ANGLES[..] };
                let missing: Vec<_> =
                    wanted.iter().filter(|name| !names.iter().any(|own| own == *name)).copied().collect();
                return failed(format!("'{}' is missing{}", missing.join("', '"), nearest(&names)));
            }
        };
        if let Some((name, _)) =
            used.iter().find(|(name, _)| names.iter().filter(|own| own == name).count() > 1)
        {
            return failed(format!("'{name}' is there twice"));
        }
        Ok(Self { separator, count: names.len(), used })
    }

    /// What stands between fields.
    pub(super) fn separator(&self) -> char {
        self.separator
    }

    /// The directions to the viewer and to the light.
    pub(super) fn directions(&self, text: &str, line: usize) -> Result<(Vec3<f64>, Vec3<f64>), TableError> {
        let fields = fields(text, self.separator);
        if fields.len() != self.count {
            return Err(TableError::Fields { line, expected: self.count, found: fields.len() });
        }
        let wrong = |index: usize, expected: &'static str| {
            let (name, column) = self.used[index];
            let found = format!("'{}'", fields[column].trim().chars().take(LONGEST).collect::<String>());
            TableError::Value { line, column: column + 1, name, expected, found }
        };
        let mut numbers = [0.0; 6];
        for (index, (_, column)) in self.used.iter().enumerate() {
            let number = fields[*column].trim().parse::<f64>().ok().filter(|number| number.is_finite());
            numbers[index] = number.ok_or_else(|| wrong(index, "a finite number"))?;
        }
        if self.used.len() == ANGLES.len() {
            let [theta_o, phi_o, theta_i, phi_i, ..] = numbers;
            if !(0.0..=90.0).contains(&theta_o) {
                return Err(wrong(0, "0 to 90 degrees, the viewer being above the surface"));
            }
            if !(0.0..=180.0).contains(&theta_i) {
                return Err(wrong(2, "0 to 180 degrees"));
            }
            let unit = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
            return Ok((unit(theta_o, phi_o), unit(theta_i, phi_i)));
        }
        let [ox, oy, oz, ix, iy, iz] = numbers;
        let (wo, wi) = (Vec3::new(ox, oy, oz), Vec3::new(ix, iy, iz));
        let is_unit = |w: Vec3<f64>| (w.dot(w).sqrt() - 1.0).abs() <= LENGTH;
        if !is_unit(wo) {
            return Err(wrong(0, "vectors of length 1"));
        }
        if !is_unit(wi) {
            return Err(wrong(3, "vectors of length 1"));
        }
        if wo.z < 0.0 {
            return Err(wrong(2, "0 to 1, the viewer being above the surface"));
        }
        Ok((wo.normalized(), wi.normalized()))
    }
}

/// A hint for a name that is nearly one of those looked for.
fn nearest(names: &[String]) -> String {
    let known: Vec<_> = ANGLES.into_iter().chain(VECTORS).collect();
    let near = names.iter().filter(|name| !known.contains(&name.as_str())).find_map(|name| {
        let near = did_you_mean(name, known.iter().copied());
        (!near.is_empty()).then(|| format!("; '{}'{}", name, near.replacen(';', ":", 1)))
    });
    near.unwrap_or_default()
}

/// The fields of a line; separators within quotes do not part them (RFC 4180). Quotes are left out.
fn fields(text: &str, separator: char) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut quoted = false;
    for c in text.chars() {
        match c {
            '"' => quoted = !quoted,
            c if c == separator && !quoted => fields.push(String::new()),
            c => fields.last_mut().expect("begins with one field").push(c),
        }
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_found_in_any_order_among_others() {
        let header = "name,phi_i_deg,theta_i_deg,phi_o_deg,theta_o_deg";
        let columns = Columns::of_header(header, 1).unwrap();
        let (wo, wi) = columns.directions("\"a, b\",180,90,0,0", 2).unwrap();
        assert!((wo.z - 1.0).abs() < 1e-15 && (wi.x + 1.0).abs() < 1e-15);
        assert!(columns.directions("a,180,90,0", 2).is_err());
    }

    #[test]
    fn vectors_are_taken_as_they_are_but_for_rounding() {
        let columns = Columns::of_header("wo_x;wo_y;wo_z;wi_x;wi_y;wi_z", 1).unwrap();
        let (wo, wi) = columns.directions("0;0;1;0.6;0;-0.8", 2).unwrap();
        assert_eq!((wo.z, wi.x, wi.z), (1.0, 0.6, -0.8));
        for wrong in ["0;0;2;0;0;1", "0;0;1;0;0;0", "0;0;-1;0;0;1", "0;0;1;0;0;nan", "0;0;1;0;0;"] {
            assert!(columns.directions(wrong, 2).is_err(), "{wrong}");
        }
    }

    #[test]
    fn headers_without_directions_are_refused() {
        let both = [ANGLES.join(","), VECTORS.join(",")].join(",");
        for wrong in ["", "a,b", "theta_o_deg,phi_o_deg", both.as_str(), "wo_x,wo_x,wo_y,wo_z,wi_x,wi_y,wi_z"]
        {
            assert!(Columns::of_header(wrong, 1).is_err(), "{wrong}");
        }
        let error = Columns::of_header("theta_o,phi_o_deg,theta_i_deg,phi_i_deg", 1).unwrap_err();
        assert!(error.to_string().contains("'theta_o': did you mean 'theta_o_deg'?"), "{error}");
    }
}
