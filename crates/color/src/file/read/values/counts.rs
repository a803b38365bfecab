//! What an instrument computed of its counts, as its own numbers show.

use super::choice::processed;
use super::named::note;
use crate::file::read::{NamedSpectrum, Quantity};
use crate::spectra::{FIRST_NM, LAST_NM};

/// The names of what is counted: the dark signal, the reference and the sample.
const NAMES: [[&str; 3]; 3] =
    [["d", "dark", "dark spectrum"], ["r", "reference", "ref"], ["s", "raw", "sample"]];

/// What an instrument may compute of the ratio (S − D) / (R − D): the formula, what it gives, its unit, its name.
type Formula = (fn(f64) -> f64, Quantity, &'static str, &'static str);

/// What instruments compute.
const FORMULAS: [Formula; 3] = [
    (|ratio| 100.0 * ratio, Quantity::Reflectance, "%", "100 (S − D) / (R − D)"),
    (|ratio| ratio, Quantity::Reflectance, "1", "(S − D) / (R − D)"),
    (|ratio| -libm::log10(ratio), Quantity::Absorbance, "", "−log10 of (S − D) / (R − D)"),
];

/// How far the numbers of a file may be from the formula, relative: they are rounded to a few digits.
const ROUNDING: f64 = 0.01;

/// The least part of the points that must follow the formula: where a reference is as dark as the dark signal, anything may stand.
const MOST: f64 = 0.9;

/// Says of a processed spectrum that names no quantity what it is, where dark signal, reference and sample stand beside it and its
/// values are (S − D) / (R − D), as a fraction or in per cent, or −log10 of that.
pub(super) fn tell_processed(spectra: &mut [NamedSpectrum]) {
    let Some(at) = processed(spectra).and_then(|found| spectra.iter().position(|one| one == found)) else {
        return;
    };
    if spectra[at].quantity != Quantity::Unknown {
        return;
    }
    let named = |names: &[&str]| {
        spectra.iter().position(|one| names.iter().any(|name| one.name.eq_ignore_ascii_case(name)))
    };
    let [Some(dark), Some(reference), Some(sample)] = NAMES.map(|names| named(&names)) else { return };
    let ratios = || {
        let counts = spectra[dark].values.iter().zip(&spectra[reference].values).zip(&spectra[sample].values);
        let ratios = counts.map(|((dark, reference), sample)| (sample - dark) / (reference - dark));
        let points = spectra[at].nm.iter().zip(&spectra[at].values).zip(ratios);
        points
            .filter(|((nm, _), _)| (FIRST_NM..=LAST_NM).contains(*nm))
            .map(|((_, value), ratio)| (*value, ratio))
    };
    let follows = |formula: fn(f64) -> f64| {
        let right = |(value, ratio): &(f64, f64)| {
            let expected = formula(*ratio);
            (value - expected).abs() <= ROUNDING * expected.abs().max(f64::MIN_POSITIVE)
        };
        let count = ratios().count();
        count > 2 && ratios().filter(right).count() as f64 >= MOST * count as f64
    };
    let Some((_, quantity, unit, formula)) = FORMULAS.into_iter().find(|(formula, ..)| follows(*formula))
    else {
        return;
    };
    let spectrum = &mut spectra[at];
    (spectrum.quantity, spectrum.unit) = (quantity, unit.to_owned());
    let text = format!("'{}' is {formula} of the counts beside it: {}", spectrum.name, quantity.words());
    note(&mut spectrum.notes, text);
}
