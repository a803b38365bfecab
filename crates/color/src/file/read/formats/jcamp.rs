//! Spectra in JCAMP-DX, the exchange format of spectroscopy: `.jdx`, `.dx`.
//!
//! Labelled lines (`##XUNITS= NANOMETERS`), with a table of pairs (`##XYPOINTS= (XY..XY)`, `##PEAK TABLE=`) or of ordinates at equal steps
//! (`##XYDATA= (X++(Y..Y))`) from which `FIRSTX`, `LASTX` and `NPOINTS` count; one block or several. Numbers
//! are decimal; the packed forms (SQZ, DIF, DUP) are refused. Source: R. S. McDonald and P. A. Wilks, JCAMP-DX: A Standard Form
//! for Exchange of Infrared Spectra in Computer Readable Form, Applied Spectroscopy 42 (1988).

use crate::file::read::error::{clean, excerpt};
use crate::file::read::named::note;
use crate::file::read::table::{MOST_SPECTRA, stem};
use crate::file::read::text::{lines, number};
use crate::file::read::units::{MAX_NAME, Scale, is_percent};
use crate::file::read::{NamedSpectrum, Place, Quantity, ReadError};

/// Whether text is in this format.
pub(in crate::file::read) fn is_jcamp(text: &str) -> bool {
    let mut content = lines(text).map(|(_, line)| line.trim()).filter(|line| !line.is_empty());
    content.next().is_some_and(|line| line.starts_with("##") && line.contains('='))
        && lines(text).take(200).any(|(_, line)| label(line).is_some_and(|(name, _)| name == "JCAMPDX"))
}

/// A labelled line as its label, without what the standard ignores in it, and its value.
fn label(line: &str) -> Option<(String, &str)> {
    let (name, value) = line.trim().strip_prefix("##")?.split_once('=')?;
    let name = name.chars().filter(|c| !" -/_".contains(*c)).collect::<String>().to_uppercase();
    Some((name, value.split("$$").next().unwrap_or("").trim()))
}

/// The spectra of a text as the file has them, before their scale is settled.
pub(in crate::file::read) fn parse(text: &str, file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    let mut spectra = Vec::new();
    let mut block = Block::default();
    let mut table: Option<Table> = None;
    for (line, text) in lines(text) {
        if let Some((name, value)) = label(text) {
            if let Some(table) = table.take() {
                spectra.push(table.finish(&block, file, spectra.len())?);
                if spectra.len() > MOST_SPECTRA {
                    let (file, place, limit) = (file.to_owned(), Place::Line(line), MOST_SPECTRA as u64);
                    return Err(ReadError::TooLarge {
                        file,
                        place,
                        limit,
                        unit: "spectra",
                        found: limit + 1,
                    });
                }
            }
            table = block.take(&name, value, line);
        } else if let Some(table) = &mut table {
            table.line(line, text.split("$$").next().unwrap_or(""), file)?;
        }
    }
    if let Some(table) = table {
        spectra.push(table.finish(&block, file, spectra.len())?);
    }
    match spectra.is_empty() {
        true => Err(ReadError::malformed(file, Place::File, "a table of XYDATA or XYPOINTS", "none")),
        false => Ok(spectra),
    }
}

/// What the labels of a block say.
#[derive(Default)]
struct Block {
    title: String,
    x_units: String,
    y_units: String,
    x_factor: Option<f64>,
    y_factor: Option<f64>,
    first_x: Option<f64>,
    last_x: Option<f64>,
    points: Option<f64>,
}

impl Block {
    /// Takes a label; a table begins where it is that of one.
    fn take(&mut self, name: &str, value: &str, line: u64) -> Option<Table> {
        match name {
            "TITLE" => *self = Self { title: value.to_owned(), ..Self::default() },
            "XUNITS" => self.x_units = value.to_owned(),
            "YUNITS" => self.y_units = value.to_owned(),
            "XFACTOR" => self.x_factor = number(value, true),
            "YFACTOR" => self.y_factor = number(value, true),
            "FIRSTX" => self.first_x = number(value, true),
            "LASTX" => self.last_x = number(value, true),
            "NPOINTS" => self.points = number(value, true),
            "XYPOINTS" | "PEAKTABLE" => {
                return Some(Table { line, is_pairs: true, x: Vec::new(), y: Vec::new() });
            }
            "XYDATA" => {
                let is_pairs = value.replace(' ', "").to_uppercase().starts_with("(XY..XY)");
                return Some(Table { line, is_pairs, x: Vec::new(), y: Vec::new() });
            }
            _ => {}
        }
        None
    }
}

/// The numbers of a table.
struct Table {
    /// The line of its label.
    line: u64,
    is_pairs: bool,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Table {
    fn line(&mut self, line: u64, text: &str, file: &str) -> Result<(), ReadError> {
        let decimal_comma =
            !text.contains('.') && text.contains([';', '\t']) || text.matches(',').count() == 3;
        let is_separator = |c: char| c.is_whitespace() || c == ';' || (c == ',' && !decimal_comma);
        let mut numbers = Vec::new();
        for word in text.split(is_separator).filter(|word| !word.is_empty()) {
            let value = number(word.trim_end_matches(','), decimal_comma).ok_or_else(|| {
                let expected = "decimal numbers (the packed forms of JCAMP-DX are not read)";
                ReadError::malformed(file, Place::Line(line), expected, excerpt(word))
            })?;
            numbers.push(value);
        }
        match (self.is_pairs, numbers.as_slice()) {
            (_, []) => {}
            (true, pairs) if pairs.len().is_multiple_of(2) => {
                for pair in pairs.chunks_exact(2) {
                    self.x.push(pair[0]);
                    self.y.push(pair[1]);
                }
            }
            (true, other) => {
                let found = format!("{} numbers", other.len());
                return Err(ReadError::malformed(file, Place::Line(line), "pairs of X and Y", found));
            }
            // The abscissa of the first ordinate of a line is only a check.
            (false, [_, ordinates @ ..]) => self.y.extend_from_slice(ordinates),
        }
        Ok(())
    }

    fn finish(self, block: &Block, file: &str, index: usize) -> Result<NamedSpectrum, ReadError> {
        let wrong = |expected: &str, found: String| {
            Err(ReadError::malformed(file, Place::Line(self.line), expected, found))
        };
        let scale = Scale::of(&block.x_units);
        let mut notes = Vec::new();
        if scale == Scale::Unknown {
            note(
                &mut notes,
                format!("the unit {} of wavelengths is not known: taken as nm", excerpt(&block.x_units)),
            );
        }
        let x = match (self.is_pairs, block.first_x, block.last_x) {
            (true, ..) => self.x.iter().map(|x| x * block.x_factor.unwrap_or(1.0)).collect(),
            (false, Some(first), Some(last)) => steps(first, last, self.y.len()),
            _ => return wrong("FIRSTX and LASTX above XYDATA", "none".to_owned()),
        };
        if block.points.is_some_and(|told| told != self.y.len() as f64) {
            let told = block.points.unwrap_or_default();
            note(&mut notes, format!("NPOINTS is {told}, but there are {} points", self.y.len()));
        }
        let points = self.points(x, scale, block.y_factor.unwrap_or(1.0), file)?;
        let name = match block.title.as_str() {
            "" => format!("{} {}", stem(file), index + 1),
            title => clean(title, MAX_NAME),
        };
        let unit = if is_percent(&block.y_units) { "%".to_owned() } else { String::new() };
        let (nm, values) = points.into_iter().unzip();
        Ok(NamedSpectrum { name, nm, values, quantity: Quantity::of(&block.y_units), unit, notes })
    }

    /// Wavelengths in nm that rise, with their values.
    fn points(
        &self,
        x: Vec<f64>,
        scale: Scale,
        factor: f64,
        file: &str,
    ) -> Result<Vec<(f64, f64)>, ReadError> {
        let wrong = |expected: &str, found: String| {
            Err(ReadError::malformed(file, Place::Line(self.line), expected, found))
        };
        let mut points = Vec::with_capacity(x.len());
        for (x, y) in x.into_iter().zip(&self.y) {
            points.push((scale.nm(x, file, || Place::Line(self.line))?, y * factor));
        }
        if points.first().zip(points.last()).is_some_and(|(first, last)| first.0 > last.0) {
            points.reverse();
        }
        if let Some(pair) = points.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
            let found = format!("{} nm after {} nm", pair[1].0, pair[0].0);
            return wrong("abscissas that only rise or only fall", found);
        }
        match points.is_empty() {
            true => wrong("points", "none".to_owned()),
            false => Ok(points),
        }
    }
}

/// So many equal steps between both ends.
fn steps(first: f64, last: f64, count: usize) -> Vec<f64> {
    let step = (last - first) / (count.max(2) - 1) as f64;
    (0..count).map(|i| first + step * i as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::read::read_spectra;

    #[test]
    fn pairs_and_steps_are_read_from_all_blocks() {
        let text = "##TITLE= outer\n##JCAMP-DX= 5.00 $$ made up\n##BLOCKS= 2\n##TITLE= leaf\n##DATA TYPE= UV/VIS SPECTRUM\n\
                    ##XUNITS= NANOMETERS\n##YUNITS= Transmission (%)\n##XYPOINTS= (XY..XY)\n400.0, 10\n410.0, 20 $$ seen\n##END=\n\
                    ##TITLE= film\n##XUNITS= 1/CM\n##YUNITS= ABSORBANCE\n##FIRSTX= 25000\n##LASTX= 20000\n##NPOINTS= 3\n\
                    ##YFACTOR= 0.5\n##XYDATA= (X++(Y..Y))\n25000 0 2\n20000 4\n##END=\n##END=\n";
        let spectra = read_spectra(text.as_bytes(), "f").unwrap();
        assert_eq!((spectra[0].name.as_str(), spectra[0].quantity), ("leaf", Quantity::Transmittance));
        assert_eq!((&spectra[0].nm[..], &spectra[0].values[..]), (&[400.0, 410.0][..], &[0.1, 0.2][..]));
        // 10^-A of 0, 1 and 2.
        assert_eq!((spectra[1].name.as_str(), &spectra[1].values[..]), ("film", &[1.0, 0.1, 0.01][..]));
        assert_eq!((spectra[1].nm[0], spectra[1].nm[2]), (400.0, 500.0));
    }

    #[test]
    fn what_is_not_read_is_told() {
        let error = |table: &str| {
            let text =
                format!("##TITLE= a\n##JCAMP-DX= 4.24\n##XUNITS= NANOMETERS\n##YUNITS= REFLECTANCE\n{table}");
            read_spectra(text.as_bytes(), "f").unwrap_err().to_string()
        };
        assert!(error("##XYDATA= (X++(Y..Y))\n400A12B3\n").contains("line 6: expected decimal numbers"));
        assert!(error("##XYDATA= (X++(Y..Y))\n400 1 2\n").contains("expected FIRSTX and LASTX"));
        assert!(
            error("##XYPOINTS= (XY..XY)\n400 1 2\n").contains("expected pairs of X and Y, found 3 numbers")
        );
        assert!(error("##XYPOINTS= (XY..XY)\n400 1\n390 1\n410 2\n").contains("only rise or only fall"));
        assert!(error("##END=\n").contains("expected a table of XYDATA or XYPOINTS"));
    }
}
