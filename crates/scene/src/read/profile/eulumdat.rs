//! EULUMDAT (A. Stockmar, 1990): one value a line, in fixed order.

use glanz_color::read::{Place, ReadError};

use super::planes::{Planes, Symmetry, increasing};
use super::source::Source;
use crate::Profile;

/// Lines from the report's number to the luminous area (8 to 21), which are not needed.
const DESCRIPTION: usize = 14;
/// Lines of a set of lamps: their number, type, flux, colour, colour rendering and watts.
const LAMP_SET: usize = 6;
/// Lines of the ratios for ten room indices.
const RATIOS: usize = 10;

/// Reads a file.
pub(super) fn read(text: &str, source: &mut Source) -> Result<Profile, ReadError> {
    let mut lines = Lines { lines: text.lines(), number: 0 };
    lines.skip(2, "the maker and the type of the source", source)?;
    let isym = lines.number("the symmetry, 0 to 4", source)?;
    let planes = lines.count("the number of half planes", source)?;
    lines.skip(1, "the distance of half planes", source)?;
    let gammas = lines.count("the number of angles in a half plane", source)?;
    lines.skip(1, "the distance of angles", source)?;
    let (symmetry, first, given) = symmetry(isym, planes, source)?;
    lines.skip(DESCRIPTION, "the description of the luminaire", source)?;
    let factor = factor(&mut lines, source)?;
    lines.skip(RATIOS, "the direct ratios", source)?;
    let all = lines.numbers(planes, "the angle of a half plane", source)?;
    increasing(&all, "around the axis", source)?;
    let gamma_deg = lines.numbers(gammas, "an angle in a half plane", source)?;
    let mut candela = lines.numbers(given.saturating_mul(gammas), "an intensity", source)?;
    candela.iter_mut().for_each(|value| *value *= factor);
    let c_deg = (first..first + given).map(|plane| all[plane % planes]).collect();
    Planes { c_deg, gamma_deg, candela, symmetry }.expand(source)
}

/// The symmetry, the first half plane that has intensities, and how many have.
fn symmetry(isym: f64, planes: usize, source: &Source) -> Result<(Symmetry, usize, usize), ReadError> {
    let (symmetry, parts) = match isym {
        0.0 => (Symmetry::None, 1),
        1.0 => (Symmetry::Round, 1),
        2.0 => (Symmetry::Across0, 2),
        3.0 => (Symmetry::Across90, 4),
        4.0 => (Symmetry::Both, 4),
        other => return Err(source.malformed(Place::Line(3), "a symmetry from 0 to 4", other.to_string())),
    };
    if !planes.is_multiple_of(parts) {
        let expected = format!("a number of half planes that {parts} divides, for symmetry {isym}");
        return Err(source.malformed(Place::Line(4), expected, planes.to_string()));
    }
    Ok(match symmetry {
        Symmetry::None => (symmetry, 0, planes),
        Symmetry::Round => (symmetry, 0, 1),
        Symmetry::Across0 => (symmetry, 0, planes / 2 + 1),
        // From C 270° over C 0° to C 90°.
        Symmetry::Across90 => (symmetry, planes / 4 * 3, planes / 2 + 1),
        Symmetry::Both => (symmetry, 0, planes / 4 + 1),
    })
}

/// From the cd per 1000 lm of the lamps, as the file has them, to cd.
fn factor(lines: &mut Lines, source: &mut Source) -> Result<f64, ReadError> {
    lines.skip(2, "the fractions of light below and from the luminaire", source)?;
    let conversion = lines.number("the conversion factor", source)?;
    let conversion_line = lines.number;
    if lines.number("the tilt of the luminaire when measured", source)? != 0.0 {
        source.notes.add("EULUMDAT: the luminaire was measured tilted; its angles are taken as they are");
    }
    let sets = lines.count("the number of sets of lamps", source)?;
    lines.skip(2, "the number and the type of the lamps", source)?;
    let flux = lines.number("the flux of the lamps", source)?;
    if flux <= 0.0 {
        let place = Place::Line(lines.number);
        return Err(source.malformed(place, "a flux of the lamps greater than 0 lm", flux.to_string()));
    }
    lines.skip(3, "colour and watts of the lamps", source)?;
    for _ in 1..sets {
        lines.skip(LAMP_SET, "another set of lamps", source)?;
    }
    if sets > 1 {
        source.notes.add("EULUMDAT: of several sets of lamps the first is taken");
    }
    match conversion {
        factor if factor > 0.0 => Ok(factor * flux / 1000.0),
        // Written where nobody has thought of it.
        0.0 => {
            source.notes.add("EULUMDAT: a conversion factor of 0 is taken as 1");
            Ok(flux / 1000.0)
        }
        negative => {
            let place = Place::Line(conversion_line);
            Err(source.malformed(place, "a conversion factor of at least 0", negative.to_string()))
        }
    }
}

/// The lines of a file, with how many are read.
struct Lines<'a> {
    lines: std::str::Lines<'a>,
    number: u64,
}

impl<'a> Lines<'a> {
    fn next(&mut self, what: &str, source: &Source) -> Result<&'a str, ReadError> {
        self.number += 1;
        let line = self.lines.next();
        line.ok_or_else(|| source.malformed(Place::Line(self.number), what, "the end of the file"))
    }

    fn skip(&mut self, count: usize, what: &str, source: &Source) -> Result<(), ReadError> {
        (0..count).try_for_each(|_| self.next(what, source).map(drop))
    }

    /// A number, whose decimal point may be a comma.
    fn number(&mut self, what: &str, source: &Source) -> Result<f64, ReadError> {
        let text = self.next(what, source)?.trim().replace(',', ".");
        source.number(&text, self.number, what)
    }

    fn count(&mut self, what: &str, source: &Source) -> Result<usize, ReadError> {
        let value = self.number(what, source)?;
        source.count(value, self.number, what)
    }

    /// So many numbers; memory grows with those that are there.
    fn numbers(&mut self, count: usize, what: &str, source: &Source) -> Result<Vec<f64>, ReadError> {
        (0..count).map(|_| self.number(what, source)).collect()
    }
}
