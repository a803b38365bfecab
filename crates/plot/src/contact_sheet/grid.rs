//! Grids: a picture for every combination of values, in rows and columns.

use super::sheet::ContactSheet;
use crate::{Error, number};

/// Names that say little without what they are of.
const GENERIC: [&str; 6] = ["color", "spectrum", "intensity", "file", "name", "size"];
/// The most pictures on a sheet.
const MAX_PICTURES: usize = 10_000;

/// A value of a scene that takes several values in turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Variation {
    /// The value's path, such as `materials.red.shininess`.
    pub path: String,
    /// Its values, as they would be written in the scene.
    pub values: Vec<String>,
}

/// Every combination of values; the last one runs along the columns.
///
/// ```
/// use glanz_plot::{Grid, Variation};
///
/// let vary = |path: &str, values: &[&str]| Variation {
///     path: path.to_owned(),
///     values: values.iter().map(|value| (*value).to_owned()).collect(),
/// };
/// let variations = [vary("m.ball.shininess", &["8", "32"]), vary("m.ball.specular", &["0", "0.5", "1"])];
/// let grid = Grid { variations: &variations, columns: 8, cell: (64, 64) };
/// assert_eq!(grid.cells()?.len(), 6);
/// assert_eq!(grid.sheet(6).columns, ["specular = 0", "specular = 0.5", "specular = 1"]);
/// # Ok::<_, glanz_plot::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a> {
    /// What varies.
    pub variations: &'a [Variation],
    /// Pictures per row where one value alone varies.
    pub columns: usize,
    /// Width and height of each picture, in pixels.
    pub cell: (u32, u32),
}

impl Grid<'_> {
    /// What each picture sets, in the order of the sheet.
    ///
    /// # Errors
    /// [`Error::TooManyPictures`].
    pub fn cells(&self) -> Result<Vec<Vec<(String, String)>>, Error> {
        let count = self
            .variations
            .iter()
            .try_fold(1_usize, |count, variation| count.checked_mul(variation.values.len()));
        let count = count.filter(|count| *count <= MAX_PICTURES);
        let count = count.ok_or(Error::TooManyPictures { most: MAX_PICTURES })?;
        Ok((0..count).map(|index| self.values(index)).collect())
    }

    /// What picture `index` sets: the last value runs fastest.
    fn values(&self, index: usize) -> Vec<(String, String)> {
        let mut rest = index;
        let mut values: Vec<_> = self
            .variations
            .iter()
            .rev()
            .map(|variation| {
                let value = variation.values[rest % variation.values.len()].clone();
                rest /= variation.values.len();
                (variation.path.clone(), value)
            })
            .collect();
        values.reverse();
        values
    }

    /// The sheet of `count` pictures: captions where one value varies, else labels at rows and columns.
    pub fn sheet(&self, count: usize) -> ContactSheet {
        let paths: Vec<_> = self.variations.iter().map(|variation| variation.path.as_str()).collect();
        let names = short_names(&paths);
        let shown: Vec<_> = self.variations.iter().map(|variation| short_values(&variation.values)).collect();
        let label = |which: usize, value: &str| {
            let place = self.variations[which].values.iter().position(|own| own == value);
            let value = place.map_or(value, |place| shown[which][place].as_str());
            format!("{} = {value}", names[which])
        };
        let cell = (self.cell.0 as usize, self.cell.1 as usize);
        if let [variation] = self.variations {
            let captions = variation.values.iter().map(|value| vec![label(0, value)]).collect();
            let per_row = count.min(self.columns);
            return ContactSheet { captions, per_row, count, cell, ..ContactSheet::default() };
        }
        let last = self.variations.len() - 1;
        let per_row = self.variations[last].values.len();
        let columns = self.variations[last].values.iter().map(|value| label(last, value)).collect();
        let row = |index: usize| {
            let values = self.values(index * per_row);
            let lines = values[..last].iter().enumerate().map(|(which, (_, value))| label(which, value));
            lines.collect::<Vec<_>>().join("\n")
        };
        let rows = (0..count / per_row).map(row).collect();
        ContactSheet { columns, rows, per_row, count, cell, ..ContactSheet::default() }
    }
}

/// The shortest ends of the paths that tell them apart: `shininess` and `specular`, but
/// `a.shininess` and `b.shininess`.
fn short_names(paths: &[&str]) -> Vec<String> {
    let end = |path: &str, parts: usize| {
        let all: Vec<_> = path.split('.').collect();
        all[all.len().saturating_sub(parts)..].join(".")
    };
    let longest = paths.iter().map(|path| path.split('.').count()).max().unwrap_or(1);
    let distinct = |parts: &usize| {
        let mut ends: Vec<_> = paths.iter().map(|path| end(path, *parts)).collect();
        ends.sort();
        ends.windows(2).all(|pair| pair[0] != pair[1])
    };
    let parts = (1..=longest).find(distinct).unwrap_or(longest);
    paths.iter().map(|path| end(path, parts.max(least_parts(path)))).collect()
}

/// How many of its last parts a path needs to be understood: a colour or a number is one of something.
fn least_parts(path: &str) -> usize {
    let parts: Vec<_> = path.split('.').rev().collect();
    let says_little = |part: &&str| GENERIC.contains(part) || part.parse::<usize>().is_ok();
    let generic = parts.iter().take_while(|part| says_little(part)).count();
    (generic + 1).min(parts.len())
}

/// Values as labels have them: numbers in as few digits as tell them apart, but not less than three.
fn short_values(values: &[String]) -> Vec<String> {
    let rounded = |digits: usize| -> Vec<String> {
        let short = |text: &String| match text.parse::<f64>() {
            Ok(value) if value.is_finite() && text.len() > 6 => shortened(value, digits),
            _ => text.clone(),
        };
        values.iter().map(short).collect()
    };
    let distinct = |texts: &[String]| {
        let of = |texts: &[String]| texts.iter().cloned().collect::<std::collections::BTreeSet<_>>().len();
        of(texts) == of(values)
    };
    (3..=5).map(rounded).find(|texts| distinct(texts)).unwrap_or_else(|| values.to_vec())
}

/// A number in so many significant digits, without zeros at its end.
fn shortened(value: f64, digits: usize) -> String {
    let scale = libm::exp10(digits as f64 - 1.0 - libm::floor(libm::log10(value.abs().max(1e-300))));
    number((value * scale).round() / scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_names_are_as_short_as_tells_them_apart() {
        assert_eq!(short_names(&["m.ball.shininess", "m.ball.specular"]), ["shininess", "specular"]);
        assert_eq!(short_names(&["m.a.n", "m.b.n"]), ["a.n", "b.n"]);
        assert_eq!(short_names(&["n", "m.n"]), ["n", "m.n"]);
        assert_eq!(short_names(&["same.n", "same.n"]), ["same.n", "same.n"]);
    }

    #[test]
    fn a_name_that_says_little_has_what_it_is_of() {
        assert_eq!(short_names(&["ambient.color"]), ["ambient.color"]);
        assert_eq!(short_names(&["lights.0.direction.1"]), ["direction.1"]);
        assert_eq!(short_names(&["lights.0.color", "m.ball.shininess"]), ["lights.0.color", "shininess"]);
    }

    #[test]
    fn numbers_in_labels_are_short_but_not_the_same() {
        let short =
            |values: &[&str]| short_values(&values.iter().map(|v| (*v).to_owned()).collect::<Vec<_>>());
        assert_eq!(short(&["0", "0.333333", "0.666667", "1"]), ["0", "0.333", "0.667", "1"]);
        assert_eq!(short(&["0.123412", "0.123456"]), ["0.1234", "0.1235"]);
        assert_eq!(short(&["[1, 0.333333, 0]", "phong"]), ["[1, 0.333333, 0]", "phong"]);
    }
}
