//! ANSI/IES LM-63 of 1986, 1991, 1995, 2002 and 2019, type C photometry.
//!
//! Labels and keywords come first, then `TILT=`, then numbers in fixed order, separated by white space:
//! ten of the luminaire, three of its operation, the angles γ ("vertical"), the half planes C
//! ("horizontal"), and the intensities by half planes.

use glanz_color::read::{Place, ReadError};

use super::planes::{Planes, Symmetry, increasing};
use super::source::Source;
use crate::Profile;

/// Reads a file.
pub(super) fn read(text: &str, source: &mut Source) -> Result<Profile, ReadError> {
    let (tilt, mut numbers) = header(text, source)?;
    skip_tilt(&tilt, &mut numbers, source)?;
    let lamps = numbers.take(3, "the number of lamps, their lumens and the multiplier", source)?;
    let gammas = numbers.count("the number of vertical angles", source)?;
    let planes = numbers.count("the number of horizontal angles", source)?;
    photometric_type(numbers.one("the photometric type", source)?, source)?;
    numbers.take(4, "the unit and the size of the luminaire", source)?;
    let operation = numbers.take(3, "the ballast factor, a reserved number and the watts", source)?;
    let factor = factor(text, lamps[2], &operation, source)?;
    let gamma_deg = numbers.take(gammas, "a vertical angle", source)?;
    let c_deg = numbers.take(planes, "a horizontal angle", source)?;
    let mut candela = numbers.take(gammas.saturating_mul(planes), "an intensity", source)?;
    candela.iter_mut().for_each(|value| *value *= factor);
    let symmetry = symmetry(&c_deg, source)?;
    Planes { c_deg, gamma_deg, candela, symmetry }.expand(source)
}

/// What stands after `TILT=`, and the numbers that follow.
fn header<'a>(text: &'a str, source: &Source) -> Result<(String, Numbers<'a>), ReadError> {
    let mut lines = text.lines().zip(1u64..);
    let found = lines.find_map(|(line, number)| Some((line.trim().strip_prefix("TILT=")?, number)));
    let Some((tilt, line)) = found else {
        return Err(source.malformed(Place::File, "a line that begins with TILT=", "none"));
    };
    let rest = lines.flat_map(|(text, number)| {
        let separated = text.split(|c: char| c.is_whitespace() || c == ',');
        separated.filter(|word| !word.is_empty()).map(move |word| (word, number))
    });
    Ok((tilt.trim().to_owned(), Numbers { words: Box::new(rest), line }))
}

/// Passes over how the lamp depends on the tilt of the luminaire: the intensities are of the position in
/// which they were measured.
fn skip_tilt(tilt: &str, numbers: &mut Numbers, source: &mut Source) -> Result<(), ReadError> {
    if tilt == "NONE" {
        return Ok(());
    }
    if tilt == "INCLUDE" {
        numbers.one("the lamp's geometry", source)?;
        let count = numbers.count("the number of tilt angles", source)?;
        numbers.take(count, "a tilt angle", source)?;
        numbers.take(count, "a factor of tilt", source)?;
    }
    source.notes.add("LM-63: how the lamp depends on the tilt of the luminaire is ignored");
    Ok(())
}

fn photometric_type(found: f64, source: &Source) -> Result<(), ReadError> {
    let found = match found {
        1.0 => return Ok(()),
        2.0 => "type B",
        3.0 => "type A",
        other => {
            let expected = "a photometric type of 1 (C), 2 (B) or 3 (A)";
            return Err(source.malformed(Place::File, expected, other.to_string()));
        }
    };
    Err(ReadError::unsupported(source.file, Place::File, "photometry of type C", found))
}

/// What the intensities are multiplied by.
fn factor(text: &str, multiplier: f64, operation: &[f64], source: &Source) -> Result<f64, ReadError> {
    // The second number of operation is a factor of ballast and lamp until 1995, reserved in 2002, and
    // tells how the file was made in 2019.
    let first = text.lines().next().unwrap_or_default();
    let reserved = ["LM-63-2002", "LM-63-2019"].iter().any(|edition| first.contains(edition));
    let photometric = if reserved { 1.0 } else { operation[1] };
    let factors = [
        ("candela multiplier", multiplier),
        ("ballast factor", operation[0]),
        ("ballast-lamp photometric factor", photometric),
    ];
    match factors.iter().find(|(_, factor)| *factor <= 0.0) {
        Some((name, factor)) => {
            Err(source.malformed(Place::File, format!("a {name} greater than 0"), factor.to_string()))
        }
        None => Ok(factors.iter().map(|(_, factor)| factor).product()),
    }
}

/// What the first and last half planes tell of the others.
fn symmetry(c_deg: &[f64], source: &mut Source) -> Result<Symmetry, ReadError> {
    increasing(c_deg, "around the axis", source)?;
    let (first, last) = (c_deg[0], c_deg[c_deg.len() - 1]);
    Ok(match (first, last) {
        (0.0, 0.0) => Symmetry::Round,
        (0.0, 90.0) => Symmetry::Both,
        (0.0, 180.0) => Symmetry::Across0,
        (90.0, 270.0) => Symmetry::Across90,
        (0.0, 360.0) => Symmetry::None,
        (0.0, last) if last > 180.0 && last < 360.0 => {
            source.notes.add("LM-63: the horizontal angles do not reach 360°; the circle is closed there");
            Symmetry::None
        }
        (first, last) => {
            let expected = "horizontal angles of 0, from 0° to 90°, 180° or 360°, or from 90° to 270°";
            let found = format!("from {first}° to {last}°");
            return Err(source.malformed(Place::File, expected, found));
        }
    })
}

/// The numbers of a file, with their lines.
struct Numbers<'a> {
    words: Box<dyn Iterator<Item = (&'a str, u64)> + 'a>,
    /// Where the last one stood.
    line: u64,
}

impl Numbers<'_> {
    fn one(&mut self, what: &str, source: &Source) -> Result<f64, ReadError> {
        let Some((word, line)) = self.words.next() else {
            return Err(source.malformed(Place::Line(self.line), what, "the end of the file"));
        };
        self.line = line;
        source.number(word, line, what)
    }

    fn count(&mut self, what: &str, source: &Source) -> Result<usize, ReadError> {
        let value = self.one(what, source)?;
        source.count(value, self.line, what)
    }

    /// So many numbers; memory grows with those that are there.
    fn take(&mut self, count: usize, what: &str, source: &Source) -> Result<Vec<f64>, ReadError> {
        (0..count).map(|_| self.one(what, source)).collect()
    }
}
