//! Two paper notes whose re-radiation was measured: the figures as published.

use crate::spectra::table::lines;

/// A measured Donaldson matrix on a grid of its own.
///
/// What light of each wavelength of incidence gives at each wavelength of emission; the diagonal is
/// ordinary reflectance. The figures are per band: a row summed over incidence, times light that is given
/// at the same wavelengths, is the light that comes back.
#[derive(Clone, Debug, PartialEq)]
pub struct PaperNote {
    /// The name, such as `paper-note-pink`.
    pub name: &'static str,
    /// The first wavelength of both axes, in nm.
    pub first_nm: f64,
    /// The step of both axes, in nm.
    pub step_nm: f64,
    /// `rows[emission][incidence]`; square, and 0 where emission would be at a shorter wavelength.
    pub rows: Vec<Vec<f64>>,
}

/// The pink and the yellow note: 380 … 780 nm by 10 nm.
///
/// Measured by Labsphere, published with A. Fichet, R. Pacanowski and A. Wilkie, "An OpenEXR Layout for
/// Spectral Images", JCGT 10(3), 2021.
pub fn paper_notes() -> Vec<PaperNote> {
    let find = |name, key| PaperNote { name, first_nm: 380.0, step_nm: 10.0, rows: rows(key) };
    vec![find("paper-note-pink", "pink"), find("paper-note-yellow", "yellow")]
}

/// The rows of a note. The file holds the lower triangle; the matrix is filled up.
fn rows(key: &str) -> Vec<Vec<f64>> {
    let mut rows: Vec<Vec<f64>> = lines(include_str!("../../data/paper_notes.csv"))
        .filter_map(|mut cells| (cells.next() == Some(key)).then_some(cells))
        .map(|cells| cells.skip(1).map(|cell| cell.parse().expect("the table holds numbers")).collect())
        .collect();
    let size = rows.len();
    rows.iter_mut().for_each(|row| row.resize(size, 0.0));
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noise of the measurement: what a column may give in excess of what comes in.
    const NOISE: f64 = 0.01;

    #[test]
    fn the_notes_are_square_triangles_that_give_no_energy_away() {
        for note in paper_notes() {
            assert_eq!(note.rows.len(), 41, "{}", note.name);
            for (out, row) in note.rows.iter().enumerate() {
                assert_eq!(row.len(), 41);
                assert!(row.iter().all(|v| (0.0..1.0).contains(v)));
                assert!(row[out] > 0.0 && row[out + 1..].iter().all(|v| *v == 0.0), "{} {out}", note.name);
            }
            for input in 0..41 {
                let given: f64 = note.rows.iter().map(|row| row[input]).sum();
                assert!(given <= 1.0 + NOISE, "{} gives {given} of column {input}", note.name);
            }
        }
    }

    #[test]
    fn the_notes_glow_where_their_names_say() {
        // Under equal energy: the total radiance factor exceeds 1 in the band of emission.
        let peak = |note: &PaperNote| {
            let totals: Vec<f64> = note.rows.iter().map(|row| row.iter().sum()).collect();
            let greatest = totals.iter().copied().fold(0.0, f64::max);
            let at = totals.iter().position(|total| *total == greatest).expect("there is a greatest");
            (greatest, note.first_nm + note.step_nm * at as f64)
        };
        let notes = paper_notes();
        let (pink, yellow) = (peak(&notes[0]), peak(&notes[1]));
        assert!(pink.0 > 1.0 && (580.0..640.0).contains(&pink.1), "{pink:?}");
        assert!(yellow.0 > 1.0 && (500.0..580.0).contains(&yellow.1), "{yellow:?}");
    }
}
