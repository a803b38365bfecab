//! The tables that come with the crate: CSV texts written by `cargo xtask data`.

use crate::spectra::resample::Outside;
use crate::spectra::sampled::Sampled;
use crate::spectra::spectrum::Spectrum;

/// Columns over one list of wavelengths; a cell may be empty.
pub(crate) struct Table {
    names: Vec<&'static str>,
    nm: Vec<f64>,
    rows: Vec<Vec<Option<f64>>>,
}

impl Table {
    /// Reads an embedded text: comments, a line of names, lines of numbers.
    pub(crate) fn parse(text: &'static str) -> Self {
        let mut lines = lines(text);
        let names = lines.next().expect("an embedded table has a line of names").skip(1).collect();
        let mut table = Self { names, nm: Vec::new(), rows: Vec::new() };
        for mut cells in lines {
            let nm = cells.next().and_then(|cell| cell.parse().ok());
            table.nm.push(nm.expect("a row of an embedded table begins with a wavelength"));
            table.rows.push(cells.map(|cell| cell.parse().ok()).collect());
        }
        table
    }

    /// The names of the columns, without the first, which holds the wavelengths.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.names.iter().copied()
    }

    /// The points that a column gives: wavelengths in nm and values.
    pub(crate) fn points(&self, name: &str) -> Option<(Vec<f64>, Vec<f64>)> {
        let column = self.names.iter().position(|known| *known == name)?;
        let given = |(nm, row): (&f64, &Vec<Option<f64>>)| Some((*nm, row.get(column).copied().flatten()?));
        Some(self.nm.iter().zip(&self.rows).filter_map(given).unzip())
    }

    /// A column on the grid.
    pub(crate) fn spectrum(&self, name: &str, outside: Outside) -> Option<Spectrum> {
        self.sampled(name, outside)
    }

    /// A column, as it is drawn or by 1 nm.
    pub(crate) fn sampled<S: Sampled>(&self, name: &str, outside: Outside) -> Option<S> {
        let (nm, values) = self.points(name)?;
        Some(S::tabled(&nm, &values, outside).expect("an embedded column is a table"))
    }
}

/// The lines of an embedded text that are no comments, as cells.
pub(crate) fn lines(text: &'static str) -> impl Iterator<Item = std::str::Split<'static, char>> {
    text.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(','))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_cells_are_left_out_of_a_column() {
        let table = Table::parse("# about\nnm,a,b\n400,1,\n405,2,.5\n410,3,7e-1\n");
        assert_eq!(table.names().collect::<Vec<_>>(), ["a", "b"]);
        assert_eq!(table.points("b"), Some((vec![405.0, 410.0], vec![0.5, 0.7])));
        assert_eq!(table.points("c"), None);
        let b = table.spectrum("b", Outside::Hold).expect("b is there");
        assert_eq!((b.at(300.0), b.at(405.0), b.at(780.0)), (0.5, 0.5, 0.7));
    }
}
