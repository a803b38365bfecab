//! What the values of a file are, and on which scale: decided once, when all that a file says is known.

use super::counts::tell_processed;
use super::named::note;
use super::units::{Scale, is_percent, photons};
use crate::file::read::{NamedSpectrum, PowerUnit, Quantity};
use crate::spectra::units::photon_energy_j;

/// What is known of a file beside its bytes.
///
/// ```
/// use glanz_color::read::{Quantity, ReadOptions, ValueScale, read_spectra_with};
///
/// // A table that says nothing: whoever measured it knows that it is a reflectance in per cent.
/// let file = "400 1.5\n500 1.6\n";
/// let options = ReadOptions {
///     quantity: Some(Quantity::Reflectance),
///     scale: Some(ValueScale::Percent),
///     ..ReadOptions::default()
/// };
/// let black = &read_spectra_with(file.as_bytes(), "black.txt", &options)?[0];
/// assert_eq!(black.values, [0.015, 0.016]);
/// # Ok::<(), glanz_color::read::ReadError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// What the values are, whatever the file says.
    pub quantity: Option<Quantity>,
    /// What the values are where the file does not say.
    pub default_quantity: Option<Quantity>,
    /// The unit of the wavelengths, whatever the file says.
    pub unit: Option<Scale>,
    /// The scale of the values, whatever the file says.
    pub scale: Option<ValueScale>,
    /// Of a spectral picture, the column and row of the pixel, from 0 at the top left; that in the middle if it is `None`.
    pub pixel: Option<(usize, usize)>,
}

/// On which scale values are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ValueScale {
    /// 1 is all light.
    Fraction,
    /// 100 is all light.
    Percent,
    /// This value is all light, or the unit.
    Whole(f64),
}

impl ValueScale {
    fn divisor(self) -> f64 {
        match self {
            Self::Fraction => 1.0,
            Self::Percent => 100.0,
            Self::Whole(value) => value,
        }
    }
}

/// Fractions of light beyond this are in per cent: even fluorescent materials hardly give back twice the
/// light of a wavelength, and a table in per cent stays below it only for black.
const GREATEST_SHARE: f64 = 2.0;

/// Per cent of light beyond this are none: the values are on another scale.
const GREATEST_PERCENT: f64 = 200.0;

/// Units that say that 1 is all light.
const FRACTIONS: [&str; 6] = ["1", "fraction", "-", "0-1", "0..1", "ratio"];

/// Brings the values of a file to fractions of light, or to power by wavelength.
///
/// `file` is the file's name: where nothing else says what all its spectra are of, that may.
pub(in crate::file::read) fn settle(spectra: &mut [NamedSpectrum], options: &ReadOptions, file: &str) {
    tell_processed(spectra);
    if options.quantity.is_none() && options.default_quantity.is_none() {
        tell_by_name(spectra, file);
    }
    for spectrum in &mut *spectra {
        match (options.quantity, options.default_quantity) {
            (Some(quantity), _) => spectrum.quantity = quantity,
            (None, Some(quantity)) if spectrum.quantity == Quantity::Unknown => spectrum.quantity = quantity,
            _ => {}
        }
    }
    if options.quantity.is_none() && options.scale.is_none() {
        spectra.iter_mut().for_each(ask_of_percent);
    }
    match options.scale {
        Some(scale) => divide(spectra, |_| true, scale.divisor()),
        None => settle_shares(spectra),
    }
    spectra.iter_mut().for_each(settle_absorbance);
    spectra.iter_mut().for_each(settle_photons);
}

/// What a file's name says of spectra of which nothing else says it.
fn tell_by_name(spectra: &mut [NamedSpectrum], file: &str) {
    let quantity = Quantity::of_file(file);
    if quantity == Quantity::Unknown || spectra.iter().any(|one| one.quantity != Quantity::Unknown) {
        return;
    }
    for spectrum in spectra {
        spectrum.quantity = quantity;
        let text = format!("{} by the file's name (--as, or as, says it otherwise)", quantity.words());
        note(&mut spectrum.notes, text);
    }
}

fn divide(spectra: &mut [NamedSpectrum], which: impl Fn(&NamedSpectrum) -> bool, divisor: f64) {
    for spectrum in spectra.iter_mut().filter(|spectrum| which(spectrum)) {
        spectrum.values.iter_mut().for_each(|value| *value /= divisor);
        if is_percent(&spectrum.unit) {
            spectrum.unit.clear();
        }
    }
}

/// Turns per cent to fractions where a file says so, or where fractions of light exceed 2. All spectra of a file whose scale
/// is not said are judged together, for a black sample in per cent looks like a grey one; but those that can be neither, such as
/// an instrument's counts, say nothing of the others, and are refused where they are used.
fn settle_shares(spectra: &mut [NamedSpectrum]) {
    let is_share = |spectrum: &NamedSpectrum| {
        spectrum.quantity.is_ratio() || (spectrum.quantity == Quantity::Unknown && is_percent(&spectrum.unit))
    };
    let is_said = |spectrum: &NamedSpectrum| is_percent(&spectrum.unit) || is_fraction(&spectrum.unit);
    let judged = |spectrum: &NamedSpectrum| {
        is_share(spectrum) && !is_said(spectrum) && spectrum.within_band() <= GREATEST_PERCENT
    };
    let greatest =
        spectra.iter().filter(|one| judged(one)).map(NamedSpectrum::within_band).fold(0.0, f64::max);
    for spectrum in spectra.iter_mut().filter(|one| is_share(one) && is_percent(&one.unit)) {
        if spectrum.quantity == Quantity::Unknown {
            note(&mut spectrum.notes, "values in per cent, given as fractions");
        }
    }
    if greatest > GREATEST_SHARE {
        for spectrum in spectra.iter_mut().filter(|one| judged(one)) {
            note(&mut spectrum.notes, format!("fractions of light up to {greatest} taken as per cent"));
        }
        divide(spectra, judged, 100.0);
    }
    divide(spectra, |spectrum| is_share(spectrum) && is_percent(&spectrum.unit), 100.0);
}

fn is_fraction(unit: &str) -> bool {
    FRACTIONS.contains(&unit.trim().to_lowercase().as_str())
}

/// A logarithm has no per cent: what calls itself an absorbance in per cent is likely the share that is absorbed.
fn ask_of_percent(spectrum: &mut NamedSpectrum) {
    if spectrum.quantity == Quantity::Absorbance && is_percent(&spectrum.unit) {
        spectrum.quantity = Quantity::Unknown;
        let text = "an absorbance in per cent is no logarithm, and likely an absorptance: what it is must be said (--as)";
        note(&mut spectrum.notes, text);
    }
}

/// An absorbance A as the transmittance 10^−A.
fn settle_absorbance(spectrum: &mut NamedSpectrum) {
    if spectrum.quantity == Quantity::Absorbance {
        // Whoever says that it is a logarithm means hundredths of it.
        divide(core::slice::from_mut(spectrum), |one| is_percent(&one.unit), 100.0);
        spectrum.quantity = Quantity::Transmittance;
        spectrum.values.iter_mut().for_each(|value| *value = libm::exp10(-*value));
        note(&mut spectrum.notes, "an absorbance A, given as the transmittance 10^-A");
    }
}

/// Photons as power: each has h c / λ.
fn settle_photons(spectrum: &mut NamedSpectrum) {
    let Some(count) = photons(&spectrum.unit).filter(|_| !spectrum.quantity.is_ratio()) else { return };
    for (value, nm) in spectrum.values.iter_mut().zip(&spectrum.nm) {
        *value *= count * photon_energy_j(*nm);
    }
    let rest = spectrum.unit.split_once(['/', ' ', '·', '.', '*']).map_or("", |(_, rest)| rest);
    // Per second: a watt is a joule in each.
    let rest: Vec<_> = rest
        .split(['/', ' ', '·', '.', '*'])
        .filter(|part| !part.is_empty() && !["s", "s-1", "s⁻¹", "s^-1"].contains(part))
        .collect();
    let separator = if spectrum.unit.contains('/') { "/" } else { " " };
    let unit = format!("W{separator}{}", rest.join(separator));
    note(&mut spectrum.notes, format!("photons in {} converted to power", spectrum.unit));
    spectrum.unit = if PowerUnit::parse(&unit).is_some() { unit } else { String::new() };
    spectrum.quantity = Quantity::Light;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spectrum(quantity: Quantity, unit: &str, values: &[f64]) -> NamedSpectrum {
        let nm = (0..values.len()).map(|i| 400.0 + 100.0 * i as f64).collect();
        NamedSpectrum { nm, values: values.to_vec(), quantity, unit: unit.to_owned(), ..Default::default() }
    }

    fn settled(one: NamedSpectrum, options: ReadOptions) -> NamedSpectrum {
        let mut spectra = [one];
        settle(&mut spectra, &options, "f");
        let [one] = spectra;
        one
    }

    #[test]
    fn the_scale_is_that_which_is_said_and_else_that_of_the_values() {
        let plain = ReadOptions::default();
        let share =
            |unit, values: &[f64]| settled(spectrum(Quantity::Reflectance, unit, values), plain).values;
        assert_eq!(share("", &[0.5, 1.2]), [0.5, 1.2]);
        assert_eq!(share("", &[5.0, 50.0]), [0.05, 0.5]);
        assert_eq!(share("8/d", &[5.0, 50.0]), [0.05, 0.5]);
        assert_eq!(share("%", &[0.5, 1.0]), [0.005, 0.01]);
        assert_eq!(share("1", &[0.5, 3.0]), [0.5, 3.0]);
        let unknown = settled(spectrum(Quantity::Unknown, "", &[5.0, 50.0]), plain);
        assert_eq!(unknown.values, [5.0, 50.0], "what it is may be known later");
        let whole = ReadOptions { scale: Some(ValueScale::Whole(255.0)), ..plain };
        assert_eq!(settled(spectrum(Quantity::Reflectance, "", &[255.0, 51.0]), whole).values, [1.0, 0.2]);
        // Counts beside a reflectance do not count, and are no reflectance.
        let counts = spectrum(Quantity::Reflectance, "", &[255.0, 3.0]);
        let mut both = [counts, spectrum(Quantity::Reflectance, "", &[0.5, 1.0])];
        settle(&mut both, &plain, "f");
        assert_eq!(both[1].values, [0.5, 1.0]);
        let error = both[0].to_spectrum(None).unwrap_err();
        assert!(error.to_string().contains("which value is all light"), "{error}");
    }

    #[test]
    fn what_is_said_from_outside_comes_first() {
        let said = ReadOptions { quantity: Some(Quantity::Light), ..Default::default() };
        let lamp = settled(spectrum(Quantity::Reflectance, "", &[5.0, 50.0]), said);
        assert_eq!((lamp.quantity, &lamp.values[..]), (Quantity::Light, &[5.0, 50.0][..]));
        let wanted = ReadOptions { default_quantity: Some(Quantity::Reflectance), ..Default::default() };
        assert_eq!(settled(spectrum(Quantity::Unknown, "", &[5.0, 50.0]), wanted).values, [0.05, 0.5]);
        assert_eq!(settled(spectrum(Quantity::Light, "", &[5.0, 50.0]), wanted).quantity, Quantity::Light);
    }

    #[test]
    fn an_absorbance_in_per_cent_is_asked_for() {
        let filter = || spectrum(Quantity::Absorbance, "%", &[10.0, 50.0]);
        let wanted = ReadOptions { default_quantity: Some(Quantity::Reflectance), ..Default::default() };
        let asked = settled(filter(), wanted);
        assert_eq!(asked.quantity, Quantity::Unknown);
        assert!(asked.notes[0].contains("likely an absorptance"), "{:?}", asked.notes);
        let said = ReadOptions { quantity: Some(Quantity::Absorptance), ..Default::default() };
        assert_eq!(settled(filter(), said).values, [0.1, 0.5]);
        let said = ReadOptions { quantity: Some(Quantity::Absorbance), ..Default::default() };
        assert_eq!(settled(filter(), said).values, [libm::exp10(-0.1), libm::exp10(-0.5)]);
    }

    #[test]
    fn absorbance_and_photons_become_what_is_computed_with() {
        let plain = ReadOptions::default();
        let filter = settled(spectrum(Quantity::Absorbance, "", &[0.0, 1.0, 3.0]), plain);
        assert_eq!((filter.quantity, &filter.values[..]), (Quantity::Transmittance, &[1.0, 0.1, 0.001][..]));
        // 1 µmol of photons of 555 nm has 0.2155 J.
        let mut lamp = spectrum(Quantity::Light, "µmol/m2/s/nm", &[1.0]);
        lamp.nm[0] = 555.0;
        let lamp = settled(lamp, plain);
        assert!((lamp.values[0] - 0.215_55).abs() < 1e-4, "{}", lamp.values[0]);
        assert_eq!(lamp.unit, "W/m2/nm");
    }
}
