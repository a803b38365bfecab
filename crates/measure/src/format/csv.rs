//! Tables with named columns.

use std::collections::HashMap;

use glanz_math::Vec3;

use super::{Data, Format, Measured, ReadOptions};
use crate::{Channels, Quantity, ReadError, Readings};

/// Where the directions of a row are.
enum Directions {
    /// Columns of angles in degrees or radians: light and detector, from the normal and around it; without azimuths the
    /// light's is 180°, so that the mirror direction lies at 0°.
    Angles { columns: [Option<usize>; 4], unit: Unit },
    /// Columns of x, y and z.
    Vectors([usize; 6]),
}

/// What angles are counted in.
#[derive(Clone, Copy, PartialEq)]
enum Unit {
    Degrees,
    Radians,
    /// The names do not say it.
    Unknown,
}

/// Columns of one of the angles: the number among the four, its names.
const ANGLES: [(usize, &[&str]); 4] = [
    (0, &["theta_i", "thetai", "theta_in", "incident_theta", "aoi", "angle_of_incidence"]),
    (1, &["phi_i", "phii", "phi_in", "incident_phi"]),
    (2, &["theta_o", "thetao", "theta_out", "theta_s", "theta_r", "theta_v", "view_theta"]),
    (3, &["phi_o", "phio", "phi_out", "phi_s", "phi_r", "phi_v", "view_phi"]),
];

/// Reads a table. Lines with `#` are comments; `# quantity reflectance_factor` says what the numbers are. A column `weight` says
/// how much a reading counts in fits.
pub(super) fn read(text: &str, name: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let said = said_quantity(text)?;
    let mut reader = reader(text);
    let head: Vec<String> =
        reader.headers().map_err(|error| wrong(&error))?.iter().map(str::to_owned).collect();
    let line = (reader.position().line() as u32).saturating_sub(1).max(1);
    let mut table = Table::of(&head, name, line, options.quantity.or(said).unwrap_or_default())?;
    let mut notes = Vec::new();
    notes.extend(table.settle_unit(text));
    let mut readings = Readings::new(table.channels.clone());
    let (mut below, mut unknown) = (0, 0);
    for record in reader.records() {
        let record = record.map_err(|error| wrong(&error))?;
        match table.row(&record)? {
            Row::Reading(wi, wo, values, weight) => readings.push_weighted(wi, wo, &values, weight),
            Row::Below => below += 1,
            Row::Unknown => unknown += 1,
        }
    }
    if readings.is_empty() {
        return Err(ReadError::broken("the table has no rows of readings"));
    }
    if options.quantity.is_none() && said.is_none() {
        notes.push("nothing says what the numbers are: taken as BRDF in 1/sr".to_owned());
    }
    for (count, what) in [(below, "below the horizon"), (unknown, "without a direction or a value")] {
        if count > 0 {
            notes.push(format!("{count} rows {what} were dropped"));
        }
    }
    let (quantity, description) = (table.quantity, comment(text));
    Ok(Measured { format: Format::Csv, quantity, description, data: Data::Readings(readings), notes })
}

/// A table's columns, and what they mean.
struct Table<'a> {
    head: &'a [String],
    directions: Directions,
    channels: Channels,
    /// The columns of the channels.
    columns: Vec<usize>,
    /// The column that says how much a reading counts.
    weight: Option<usize>,
    quantity: Quantity,
}

/// A row of a table.
enum Row {
    Reading(Vec3<f64>, Vec3<f64>, Vec<f32>, f32),
    /// Light or detector is below the horizon.
    Below,
    /// There is no direction or no value.
    Unknown,
}

impl<'a> Table<'a> {
    fn of(head: &'a [String], name: &str, line: u32, quantity: Quantity) -> Result<Self, ReadError> {
        let directions = directions(head).ok_or_else(|| match head.len() {
            0 | 1 => ReadError::Unknown(format!("'{name}' is neither binary nor a table")),
            _ => {
                let expected = "theta_i_deg and theta_o_deg (phi_i_deg, phi_o_deg), or wi_x to wo_z";
                let found = head.join(", ");
                ReadError::at(line, format!("no columns of directions: expected {expected}, found {found}"))
            }
        })?;
        let (channels, columns) = channels(head).ok_or_else(|| {
            let expected = "r, g, b, or X, Y, Z, or wavelengths such as 550nm, or Y";
            ReadError::at(line, format!("no columns of values: expected {expected}"))
        })?;
        let weight = head.iter().position(|name| name == "weight");
        Ok(Self { head, directions, channels, columns, weight, quantity })
    }

    /// Decides on the unit of angles where the names do not say it, and tells what was decided.
    fn settle_unit(&mut self, text: &str) -> Option<String> {
        let Directions::Angles { columns, unit: unit @ Unit::Unknown } = &mut self.directions else {
            return None;
        };
        let most = most_theta(text, columns);
        let is_radians = (0.2..1.6).contains(&most);
        *unit = if is_radians { Unit::Radians } else { Unit::Degrees };
        is_radians
            .then(|| format!("no angle is above {most}: taken as radians; names with _deg or _rad say it"))
    }

    fn row(&self, record: &::csv::StringRecord) -> Result<Row, ReadError> {
        let line = record.position().map_or(0, |at| at.line() as u32);
        let number = |column: usize| number(record, column, self.head, line);
        let [wi, wo] = pair(&self.directions, &number)?;
        if wi.z < 0.0 || wo.z < 0.0 {
            return Ok(Row::Below);
        }
        let mut values = Vec::with_capacity(self.columns.len());
        for column in &self.columns {
            values.push(self.quantity.brdf(number(*column)?, wo.z).unwrap_or(f64::NAN) as f32);
        }
        let is_unknown =
            !wi.dot(wi).is_finite() || !wo.dot(wo).is_finite() || values.iter().all(|value| value.is_nan());
        if is_unknown {
            return Ok(Row::Unknown);
        }
        Ok(Row::Reading(wi, wo, values, self.weight_of(&number, line)?))
    }

    /// What the row says of its weight; 1 where it says nothing.
    fn weight_of(
        &self,
        number: &dyn Fn(usize) -> Result<f64, ReadError>,
        line: u32,
    ) -> Result<f32, ReadError> {
        let Some(column) = self.weight else { return Ok(1.0) };
        match number(column)? {
            weight if weight.is_nan() => Ok(1.0),
            weight if weight >= 0.0 && (weight as f32).is_finite() => Ok(weight as f32),
            weight => {
                Err(ReadError::at(line, format!("column 'weight': expected 0 or more, found {weight}")))
            }
        }
    }
}

/// What the table says that its numbers are.
fn said_quantity(text: &str) -> Result<Option<Quantity>, ReadError> {
    let mut comments = text.lines().filter_map(|line| line.trim().strip_prefix('#'));
    let Some(word) = comments.find_map(|words| words.trim().strip_prefix("quantity")) else {
        return Ok(None);
    };
    let word = word.trim().trim_start_matches([':', '=']).trim();
    let found = Quantity::named(word).ok_or_else(|| {
        ReadError::broken(format!("'{word}' is no quantity: expected brdf, brdf_cos or reflectance_factor"))
    });
    found.map(Some)
}

fn wrong(error: &::csv::Error) -> ReadError {
    let line = error.position().map(|at| at.line() as u32);
    ReadError::Broken { message: format!("the table cannot be read: {error}"), line }
}

/// The first comment that is no key.
fn comment(text: &str) -> String {
    let mut comments = text.lines().filter_map(|line| line.trim().strip_prefix('#')).map(str::trim);
    comments.find(|words| !words.is_empty() && !words.starts_with("quantity")).unwrap_or_default().to_owned()
}

fn reader(text: &str) -> ::csv::Reader<&[u8]> {
    ::csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(::csv::Trim::All)
        .delimiter(delimiter(text))
        .flexible(true)
        .from_reader(text.trim_start_matches('\u{feff}').as_bytes())
}

/// The greatest angle from the normal in a table.
fn most_theta(text: &str, columns: &[Option<usize>; 4]) -> f64 {
    let records = reader(text).into_records().flatten();
    let angles = records.flat_map(|record| {
        let number = |column: Option<usize>| record.get(column?)?.replace(',', ".").parse::<f64>().ok();
        [number(columns[0]), number(columns[2])]
    });
    angles.flatten().fold(0.0, |most: f64, angle| most.max(angle.abs()))
}

/// What stands between columns: what the first row has most of.
fn delimiter(text: &str) -> u8 {
    let row = text
        .lines()
        .find(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#'))
        .unwrap_or("");
    let count = |c: char| row.matches(c).count();
    [(';', count(';')), ('\t', count('\t')), (',', count(','))]
        .into_iter()
        .max_by_key(|(_, n)| *n)
        .map_or(b',', |(c, _)| c as u8)
}

fn directions(head: &[String]) -> Option<Directions> {
    let place: HashMap<String, usize> =
        head.iter().enumerate().map(|(i, name)| (name.to_lowercase(), i)).collect();
    let vector = ["wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"].map(|name| place.get(name).copied());
    if let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] = vector {
        return Some(Directions::Vectors([a, b, c, d, e, f]));
    }
    let mut columns = [None; 4];
    let mut unit = Unit::Unknown;
    for (angle, names) in ANGLES {
        for name in names {
            for (suffix, said) in [("_deg", Unit::Degrees), ("", Unit::Unknown), ("_rad", Unit::Radians)] {
                if let (None, Some(column)) = (columns[angle], place.get(&format!("{name}{suffix}"))) {
                    columns[angle] = Some(*column);
                    unit = if said == Unit::Unknown { unit } else { said };
                }
            }
        }
    }
    (columns[0].is_some() && columns[2].is_some()).then_some(Directions::Angles { columns, unit })
}

/// What the other columns are, and where.
fn channels(head: &[String]) -> Option<(Channels, Vec<usize>)> {
    let find = |names: [&str; 3]| {
        let all = names.map(|name| head.iter().position(|own| own == name));
        all.into_iter().collect::<Option<Vec<usize>>>()
    };
    for (names, channels) in
        [(["r", "g", "b"], Channels::Rgb), (["R", "G", "B"], Channels::Rgb), (["X", "Y", "Z"], Channels::Xyz)]
    {
        if let Some(columns) = find(names) {
            return Some((channels, columns));
        }
    }
    let nm = |name: &String| {
        name.trim_end_matches("nm").trim().parse::<f64>().ok().filter(|nm| (100.0..4000.0).contains(nm))
    };
    let mut all: Vec<(f64, usize)> =
        head.iter().enumerate().filter_map(|(i, name)| Some((nm(name)?, i))).collect();
    if !all.is_empty() {
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (list, columns) = all.into_iter().unzip();
        return Some((Channels::Wavelengths(list), columns));
    }
    let one = ["Y", "y", "value", "brdf", "f", "f_cos", "luminance"];
    let column = head.iter().position(|name| one.contains(&name.as_str()))?;
    Some((Channels::Luminance, vec![column]))
}

fn number(record: &::csv::StringRecord, column: usize, head: &[String], line: u32) -> Result<f64, ReadError> {
    let text = record.get(column).unwrap_or("");
    if text.is_empty() || text.eq_ignore_ascii_case("nan") {
        return Ok(f64::NAN);
    }
    // Decimal commas come with other signs between columns.
    let value = text.parse::<f64>().or_else(|_| text.replace(',', ".").parse::<f64>());
    value.map_err(|_| {
        ReadError::at(line, format!("column '{}': expected a number, found '{text}'", head[column]))
    })
}

fn pair(
    directions: &Directions,
    number: &dyn Fn(usize) -> Result<f64, ReadError>,
) -> Result<[Vec3<f64>; 2], ReadError> {
    match directions {
        Directions::Vectors(columns) => {
            let mut all = [0.0; 6];
            for (value, column) in all.iter_mut().zip(columns) {
                *value = number(*column)?;
            }
            let [a, b, c, d, e, f] = all;
            Ok([Vec3::new(a, b, c).normalized(), Vec3::new(d, e, f).normalized()])
        }
        Directions::Angles { columns, unit } => {
            let to_radians = if *unit == Unit::Radians { 1.0 } else { core::f64::consts::PI / 180.0 };
            let of = |at: usize, default: f64| match columns[at] {
                Some(column) => Ok(number(column)? * to_radians),
                None => Ok(default),
            };
            let phi_i = of(1, core::f64::consts::PI)?;
            Ok([Vec3::from_angles(of(0, 0.0)?, phi_i), Vec3::from_angles(of(2, 0.0)?, of(3, 0.0)?)])
        }
    }
}

/// A table of readings, as [`Measured::read`] takes it.
///
/// Angles are in degrees, from the normal and around it; the values are what `quantity` says, which the first line tells.
/// Where a weight is not 1, the last column is that of weights.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Measured, Quantity, Readings, write_csv};
///
/// let mut readings = Readings::new(Channels::Luminance);
/// readings.push(Vec3::from_angles(0.5, std::f64::consts::PI), Vec3::from_angles(0.2, 0.0), &[0.25]);
/// let text = write_csv(&readings, Quantity::RadianceFactor, "a tile");
/// let again = Measured::read(text.as_bytes(), "tile.csv", &Default::default())?;
/// assert_eq!(again.quantity, Quantity::RadianceFactor);
/// assert!((again.readings().values(0)[0] - 0.25).abs() < 1e-6);
/// # Ok::<(), glanz_measure::ReadError>(())
/// ```
pub fn write_csv(readings: &Readings, quantity: Quantity, description: &str) -> String {
    let mut text = String::new();
    for line in description.lines() {
        text += &format!("# {}\n", line.trim());
    }
    text += &format!("# quantity {}\ntheta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,", quantity.name());
    text += &readings.channels().names().join(",");
    text += if readings.has_weights() { ",weight\n" } else { "\n" };
    for index in 0..readings.len() {
        let [wi, wo] = readings.pair(index);
        let [ti, pi] = angles(wi);
        let [to, po] = angles(wo);
        text += &format!("{ti},{pi},{to},{po}");
        for value in readings.values(index) {
            text += &format!(",{}", quantity.of_brdf(f64::from(*value), wo.z) as f32);
        }
        if readings.has_weights() {
            text += &format!(",{}", readings.weight(index));
        }
        text.push('\n');
    }
    text
}

/// Degrees from the normal and around it, to a millionth, which no goniometer resolves.
fn angles(w: Vec3<f64>) -> [f64; 2] {
    let round = |radians: f64| (radians.to_degrees() * 1e6).round() / 1e6 + 0.0;
    [round(libm::atan2(libm::sqrt(w.x * w.x + w.y * w.y), w.z)), round(libm::atan2(w.y, w.x))]
}
