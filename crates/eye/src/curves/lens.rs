//! The density of the crystalline lens by age, by two standards that do not agree.

use std::sync::LazyLock;

use libm::exp;

use super::within;

/// The density of the lens by CIE 170-1:2006: D = D1·(1 + 0.02(A − 32)) + D2 up to 60 years, D1·(1.56 + 0.0667(A − 60)) + D2 from there.
///
/// **Parameters** `nm` the wavelength, 390 to 780 nm, linear between the table's 5 nm; `age` A in years, 5 to 100. Transmittance is
/// 10^−D.
/// **Limits** the standard holds for 20 to 80 years, beyond them the formula is carried on; the growth has a kink at 60 years; it is that of the standard observer's cones, for whom A is 32.
/// **Source** J. Pokorny, V. C. Smith and M. Lutze, Applied Optics 26(8), 1987; table: `data/media.csv`.
///
/// ```
/// let transmittance = |age: f64| libm::pow(10.0, -glanz_eye::curves::lens_density_cie170(450.0, age));
/// assert!((transmittance(20.0) - 0.6297).abs() < 5e-5 && (transmittance(80.0) - 0.1768).abs() < 5e-5);
/// ```
pub fn lens_density_cie170(nm: f64, age: f64) -> f64 {
    static TABLE: LazyLock<Vec<[f64; 3]>> = LazyLock::new(table);
    let age = within(age, 5.0, 100.0);
    let growth = if age <= 60.0 { 1.0 + 0.02 * (age - 32.0) } else { 1.56 + 0.0667 * (age - 60.0) };
    let nm = within(nm, TABLE[0][0], TABLE[TABLE.len() - 1][0]);
    let after = TABLE.partition_point(|row| row[0] < nm).max(1);
    let ([from, a1, a2], [to, b1, b2]) = (TABLE[after - 1], TABLE[after]);
    let part = (nm - from) / (to - from);
    (a1 + part * (b1 - a1)) * growth + a2 + part * (b2 - a2)
}

/// Wavelengths with the density that grows with age, at 32 years, and the density that does not.
fn table() -> Vec<[f64; 3]> {
    let text = include_str!("../../data/media.csv");
    let rows = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    let number = |cell: &str| cell.parse::<f64>().expect("the table holds numbers");
    let row = |line: &str| {
        let cells: Vec<_> = line.split(',').map(number).collect();
        [cells[0], cells[5], cells[6]]
    };
    rows.map(row).collect()
}

/// The density of the lens, cornea and humours by CIE 203:2012.
///
/// **Formula** (0.15 + 0.000031A²)(400/λ)⁴ + 14.19·10.68·exp(−[0.057(λ − 273)]²) + (1.05 − 0.000063A²)·2.13·exp(−[0.029(λ − 370)]²) +
/// (0.059 + 0.000186A²)·11.95·exp(−[0.021(λ − 325)]²) + (0.016 + 0.000132A²)·1.43·exp(−[0.008(λ − 325)]²) + 0.06.
/// **Parameters** `nm` the wavelength λ, 300 to 780 nm; `age` A in years, 1 to 100. Transmittance is 10^−D.
/// **Limits** the formula of J. van de Kraats and D. van Norren, 2007, has other constants; they are not mixed here.
/// **Source** CIE 203:2012, with its corrigendum, as restated in implementations; its text was not at hand.
///
/// ```
/// let transmittance = |age: f64| libm::pow(10.0, -glanz_eye::curves::lens_density_cie203(450.0, age));
/// assert!((transmittance(20.0) - 0.6177).abs() < 5e-5 && (transmittance(80.0) - 0.1771).abs() < 5e-5);
/// ```
pub fn lens_density_cie203(nm: f64, age: f64) -> f64 {
    let (nm, age) = (within(nm, 300.0, 780.0), within(age, 1.0, 100.0));
    let squared = age * age;
    let band = |rate: f64, center: f64| {
        let x = rate * (nm - center);
        exp(-x * x)
    };
    let ratio = 400.0 / nm;
    (0.15 + 0.000_031 * squared) * ratio * ratio * ratio * ratio
        + 14.19 * 10.68 * band(0.057, 273.0)
        + (1.05 - 0.000_063 * squared) * 2.13 * band(0.029, 370.0)
        + (0.059 + 0.000_186 * squared) * 11.95 * band(0.021, 325.0)
        + (0.016 + 0.000_132 * squared) * 1.43 * band(0.008, 325.0)
        + 0.06
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    /// The wavelengths of the check values, in nm.
    const NM: [f64; 5] = [420.0, 450.0, 500.0, 550.0, 650.0];

    #[test]
    fn the_lens_of_cie_170_has_its_transmittances() {
        // eye.md 8–17.
        for (age, known) in [
            (20.0, ["0.2391", "0.6297", "0.7642", "0.8605", "0.9945"]),
            (80.0, ["0.0292", "0.1768", "0.3591", "0.5643", "0.9790"]),
        ] {
            for (nm, known) in NM.into_iter().zip(known) {
                assert_digits(libm::pow(10.0, -lens_density_cie170(nm, age)), known);
            }
        }
        // eye.md §2: the density at 390 nm and 32 years.
        assert_digits(lens_density_cie170(390.0, 32.0), "2.5122");
    }

    #[test]
    fn the_lens_of_cie_203_has_its_transmittances() {
        // REFERENCE.md, CIE 203:2012.
        for (age, known) in [
            (20.0, ["0.2849", "0.6177", "0.7238", "0.7775", "0.8253"]),
            (80.0, ["0.0328", "0.1771", "0.4206", "0.6228", "0.7738"]),
        ] {
            for (nm, known) in NM.into_iter().zip(known) {
                assert_digits(libm::pow(10.0, -lens_density_cie203(nm, age)), known);
            }
        }
    }

    #[test]
    fn the_two_standards_age_differently() {
        // eye.md §2: what 32 years add up to 70 and up to 60, at 450 and 550 nm.
        let grown = |density: fn(f64, f64) -> f64, nm: f64, age: f64| density(nm, age) - density(nm, 32.0);
        assert_digits(grown(lens_density_cie203, 450.0, 70.0), "0.3505");
        assert_digits(grown(lens_density_cie203, 550.0, 70.0), "0.0623");
        assert_digits(grown(lens_density_cie170, 450.0, 70.0), "0.3172");
        assert_digits(grown(lens_density_cie170, 550.0, 70.0), "0.1054");
        assert_digits(grown(lens_density_cie203, 450.0, 60.0), "0.233");
        assert_digits(grown(lens_density_cie203, 550.0, 60.0), "0.041");
        assert_digits(grown(lens_density_cie170, 450.0, 60.0), "0.145");
        assert_digits(grown(lens_density_cie170, 550.0, 60.0), "0.048");
    }

    #[test]
    fn between_the_rows_of_the_table_the_density_is_linear() {
        let [a, middle, b] = [400.0, 402.5, 405.0].map(|nm| lens_density_cie170(nm, 32.0));
        assert!((middle - 0.5 * (a + b)).abs() < 1e-15);
        assert_eq!(lens_density_cie170(300.0, 32.0), lens_density_cie170(390.0, 32.0));
    }
}
