//! The text of pab's goniometers (Mountain), as Radiance's `pabopto2bsdf` takes it: `#intheta`, `#inphi` and `#format` tell
//! the light and the columns, then each row has θ and φ of the detector in degrees, and values. Files of several lights may
//! be joined.

use glanz_math::Vec3;

use super::{Data, Format, Measured, ReadOptions, text};
use crate::{Channels, Quantity, ReadError, Readings};

/// Whether a line names the columns or the light.
pub(super) fn is_pab(text: &str) -> bool {
    text.lines().take(200).any(|line| {
        let line = line.trim().to_lowercase();
        ["#format:", "#intheta", "#incident_angle"].iter().any(|key| line.starts_with(key))
    })
}

/// What the keys say that stand above a row.
#[derive(Default)]
struct Head {
    name: String,
    theta_i: Option<f64>,
    phi_i: f64,
    quantity: Option<Quantity>,
    is_xyz: Option<bool>,
}

pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Measured, ReadError> {
    let mut head = Head::default();
    let mut rows = Rows::default();
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        match line.strip_prefix('#') {
            Some(key) => head.key(number, key.trim())?,
            None if line.is_empty() => {}
            None => rows.push(&head, text::row(number, line)?, number, options)?,
        }
    }
    rows.finished(head, options)
}

impl Head {
    fn key(&mut self, number: u32, line: &str) -> Result<(), ReadError> {
        let (key, words) = line.split_once(|c: char| c.is_whitespace() || c == ':').unwrap_or((line, ""));
        let words = words.trim_start_matches(':').trim();
        let first = |what: &str| {
            let row = text::row(number, words)?;
            let missing = || ReadError::at(number, format!("expected {what}, found '{words}'"));
            row.first().copied().ok_or_else(missing)
        };
        match key.to_lowercase().as_str() {
            "sample_name" => words.trim_matches('"').clone_into(&mut self.name),
            "intheta" => self.theta_i = Some(first("the angle of the light")?),
            "inphi" => self.phi_i = first("the azimuth of the light")?,
            "incident_angle" => match text::row(number, words)?[..] {
                [theta, phi, ..] => (self.theta_i, self.phi_i) = (Some(theta), phi),
                _ => return Err(ReadError::at(number, "expected two angles of the light")),
            },
            "format" => self.quantity = Some(quantity(number, words)?),
            "colorimetry" => self.is_xyz = Some(words.eq_ignore_ascii_case("CIE-XYZ")),
            _ => {}
        }
        Ok(())
    }
}

fn quantity(number: u32, words: &str) -> Result<Quantity, ReadError> {
    let last = words.split_whitespace().nth(2).unwrap_or("");
    match last.to_uppercase().as_str() {
        "BRDF" | "BSDF" => Ok(Quantity::Brdf),
        "DSF" => Ok(Quantity::BrdfCos),
        "BTDF" => Err(ReadError::at(
            number,
            "the file holds transmitted light (BTDF), and only reflectance is read",
        )),
        _ => {
            let expected = "'theta phi BRDF', or BSDF or DSF in its place";
            Err(ReadError::at(number, format!("expected {expected}, found '{words}'")))
        }
    }
}

/// The rows so far.
#[derive(Default)]
struct Rows {
    readings: Option<Readings>,
    quantity: Quantity,
    /// Rows of transmitted light, and of light from below.
    through: usize,
    from_below: usize,
}

impl Rows {
    fn push(
        &mut self,
        head: &Head,
        row: Vec<f64>,
        number: u32,
        options: &ReadOptions,
    ) -> Result<(), ReadError> {
        let Some(theta_i) = head.theta_i else {
            return Err(ReadError::at(number, "#intheta or #incident_angle must stand above the first row"));
        };
        let channels = match (row.len(), head.is_xyz) {
            (3, _) => Channels::Luminance,
            (5, Some(true)) => Channels::Xyz,
            (5, _) => Channels::Rgb,
            (n, _) => {
                let message = format!("expected two angles and one or three values, found {n} numbers");
                return Err(ReadError::at(number, message));
            }
        };
        let readings = self.readings.get_or_insert_with(|| Readings::new(channels.clone()));
        if readings.channels().count() != channels.count() {
            return Err(ReadError::at(number, "the row has another number of values than those before"));
        }
        if [theta_i, head.phi_i, row[0], row[1]].iter().any(|angle| !angle.is_finite()) {
            return Err(ReadError::at(
                number,
                "the angles of the light and of the row must be finite numbers",
            ));
        }
        // Beyond 90° lies the other side.
        let up = |theta: f64, phi: f64| {
            let w = Vec3::from_angles(theta.to_radians(), phi.to_radians());
            (Vec3::new(w.x, w.y, w.z.abs()), theta.abs() > 90.0)
        };
        let ((wi, below_i), (wo, below_o)) = (up(theta_i, head.phi_i), up(row[0], row[1]));
        if below_i != below_o {
            self.through += 1;
            return Ok(());
        }
        self.from_below += usize::from(below_i);
        self.quantity = options.quantity.or(head.quantity).unwrap_or_default();
        let of = |value: &f64| self.quantity.brdf(*value, wo.z).unwrap_or(f64::NAN) as f32;
        readings.push(wi, wo, &row[2..].iter().map(of).collect::<Vec<f32>>());
        Ok(())
    }

    fn finished(self, head: Head, options: &ReadOptions) -> Result<Measured, ReadError> {
        let readings = self.readings.filter(|readings| !readings.is_empty());
        let readings = readings.ok_or_else(|| ReadError::broken("there are no rows of reflected light"))?;
        let mut notes = Vec::new();
        if self.through > 0 {
            notes.push(format!("{} rows of transmitted light were dropped", self.through));
        }
        if self.from_below > 0 {
            notes.push("light comes from below the sample, and is read as if that side lay up".to_owned());
        }
        if head.quantity.is_none() && options.quantity.is_none() {
            notes.push("nothing says what the numbers are: taken as BRDF in 1/sr".to_owned());
        }
        if readings.channels() == &Channels::Rgb {
            notes.push(
                "#colorimetry is not CIE-XYZ: three values are taken as red, green and blue".to_owned(),
            );
        }
        let (quantity, data) = (self.quantity, Data::Readings(readings));
        Ok(Measured { format: Format::Pab, quantity, description: head.name, data, notes })
    }
}
