//! Measured reflectances by name: the ColorChecker and test samples of colour rendering.
//!
//! Below the first and above the last wavelength measured the value there is held. That says nothing of
//! real ultraviolet reflectance: many pigments and all papers absorb there.

use std::sync::LazyLock;

use crate::names::{UnknownName, plain};
use crate::spectra::table::Table;
use crate::spectra::{FineSpectrum, Outside, Sampled, Spectrum};

/// What is known about a reflectance.
#[derive(Clone, Debug, PartialEq)]
pub struct ReflectanceInfo {
    /// The name as [`reflectance`] knows it.
    pub name: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// Where its numbers come from.
    pub source: &'static str,
    /// The wavelengths in nm that were measured; beyond them the values at the ends are held.
    pub range_nm: (f64, f64),
}

static CHECKER: LazyLock<Table> = LazyLock::new(|| Table::parse(include_str!("../../data/colorchecker.csv")));
static SAMPLES: LazyLock<Table> = LazyLock::new(|| Table::parse(include_str!("../../data/samples.csv")));

/// The reflectance of a sample, 0 … 1, on the grid; [`reflectances`] lists the names.
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn reflectance(name: &str) -> Result<Spectrum, UnknownName> {
    sampled(name)
}

/// The same by 1 nm, for numbers: the table interpolated (Sprague, CIE 167:2005).
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn fine_reflectance(name: &str) -> Result<FineSpectrum, UnknownName> {
    sampled(name)
}

/// A reflectance, as it is drawn or by 1 nm.
fn sampled<S: Sampled>(name: &str) -> Result<S, UnknownName> {
    let wanted = plain(name);
    let found = |table: &Table| table.sampled(&wanted, Outside::Hold);
    found(&CHECKER).or_else(|| found(&SAMPLES)).ok_or_else(|| {
        UnknownName::not_found("reflectance", name.trim(), reflectances().iter().map(|info| info.name))
    })
}

/// All reflectances by name.
pub fn reflectances() -> &'static [ReflectanceInfo] {
    static LIST: LazyLock<Vec<ReflectanceInfo>> = LazyLock::new(|| {
        let checker =
            CHECKER.names().map(|name| info(&CHECKER, name, "a patch of the ColorChecker", CHECKER_SOURCE));
        let samples = SAMPLES.names().zip(SAMPLE_TITLES).map(|(name, title)| {
            info(&SAMPLES, name, title, if name.starts_with("tcs") { TCS_SOURCE } else { VS_SOURCE })
        });
        checker.chain(samples).collect()
    });
    &LIST
}

/// The 24 patches of the ColorChecker, row by row from dark skin to black, with their names.
///
/// ```
/// use glanz_color::colorchecker;
///
/// assert_eq!(colorchecker().count(), 24);
/// let (name, white) = colorchecker().nth(18).expect("the first patch of the last row");
/// assert_eq!(name, "white-9.5");
/// assert!((white.at(550.0) - 0.9).abs() < 0.02);
/// ```
pub fn colorchecker() -> impl Iterator<Item = (&'static str, Spectrum)> {
    CHECKER.names().map(|name| {
        (name, CHECKER.spectrum(name, Outside::Hold).expect("a table has the columns that it names"))
    })
}

fn info(table: &Table, name: &'static str, title: &'static str, source: &'static str) -> ReflectanceInfo {
    let (nm, _) = table.points(name).expect("a table has the columns that it names");
    ReflectanceInfo { name, title, source, range_nm: (nm[0], nm[nm.len() - 1]) }
}

const CHECKER_SOURCE: &str = "ISO 17321-1:2012, as measured by N. Ohta, 1997";
const TCS_SOURCE: &str = "CIE 13.3-1995 (tcs15: CIE, 2024)";
const VS_SOURCE: &str = "colour quality scale 9.0, W. Davis and Y. Ohno (NIST), 2010";

/// What the samples are, with their approximate Munsell notations, in the order of the table.
const SAMPLE_TITLES: [&str; 30] = [
    "light greyish red, 7.5R 6/4",
    "dark greyish yellow, 5Y 6/4",
    "strong yellow green, 5GY 6/8",
    "moderate yellowish green, 2.5G 6/6",
    "light bluish green, 10BG 6/4",
    "light blue, 5PB 6/8",
    "light violet, 2.5P 6/8",
    "light reddish purple, 10P 6/8",
    "strong red, 4.5R 4/13",
    "strong yellow, 5Y 8/10",
    "strong green, 4.5G 5/8",
    "strong blue, 3PB 3/11",
    "light yellowish pink (light skin), 5YR 8/4",
    "moderate olive green (leaf), 5GY 4/4",
    "Japanese skin, 1YR 6/4",
    "saturated red, 5R 4/14",
    "saturated orange red, 10R 6/12",
    "saturated orange, 7.5YR 7/12",
    "saturated yellow, 5Y 8/12",
    "saturated yellow green, 2.5GY 8/10",
    "saturated green, 7.5GY 7/10",
    "saturated green, 2.5G 6/12",
    "saturated bluish green, 2.5BG 6/10",
    "saturated blue green, 10BG 6/8",
    "saturated blue, 7.5B 5/10",
    "saturated purplish blue, 2.5PB 4/10",
    "saturated purplish blue, 7.5PB 4/12",
    "saturated purple, 5P 5/10",
    "saturated red purple, 2.5RP 6/12",
    "saturated purplish red, 7.5RP 5/12",
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use crate::observers::{Observer, xyz_of_reflectance};

    #[test]
    fn every_reflectance_loads_and_reflects_no_more_than_it_gets() {
        assert_eq!(SAMPLES.names().count(), SAMPLE_TITLES.len());
        assert_eq!(reflectances().len(), 24 + 30);
        for info in reflectances() {
            let spectrum = reflectance(info.name).expect("a listed reflectance loads");
            assert!(spectrum.0.iter().all(|v| (0.0..=1.0).contains(v)), "{}", info.name);
            assert_eq!(spectrum.at(300.0), spectrum.at(info.range_nm.0), "{}", info.name);
        }
        assert_eq!(reflectance("Dark Skin"), reflectance("dark-skin"));
        let error = reflectance("neutral-9").expect_err("no such patch").to_string();
        assert!(error.contains("did you mean 'neutral-8' or 'neutral-5'?"), "{error}");
    }

    #[test]
    fn the_patches_of_the_checker_have_the_luminance_of_their_names() {
        let patches: Vec<_> = colorchecker().collect();
        assert_eq!((patches.len(), patches[0].0, patches[23].0), (24, "dark-skin", "black-2"));
        let c = light("C").expect("a light");
        // The number in the name of a grey is its Munsell value V, defined under C by Y / Ymax of magnesium
        // oxide (97.5 % of the perfect diffuser); made and measured to a few hundredths of that.
        for (name, luminance) in
            [("white-9.5", 0.900), ("neutral-8", 0.591), ("neutral-6.5", 0.362), ("neutral-5", 0.198)]
        {
            let spectrum = reflectance(name).expect("a patch");
            let [_, y, _] = xyz_of_reflectance(&spectrum, &c, &Observer::default());
            assert!((y / luminance - 1.0).abs() < 0.05, "{name}: {y}");
        }
    }
}
