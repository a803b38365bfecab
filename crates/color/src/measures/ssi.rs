//! The spectral similarity index: how alike two lights are to a camera of any kind.
//!
//! Academy of Motion Picture Arts and Sciences, "Academy Spectral Similarity Index (SSI): Overview", 2020; J. Holm et al., "A
//! cinematographic spectral similarity index", SMPTE 2016. Power from 375 to 675 nm in bands of 10 nm, each light to a sum of 1,
//! their relative differences weighted, smoothed and added; 100 is the same light, to a whole number.
//!
//! ```
//! use glanz_color::fine_light;
//! use glanz_color::ssi::similarity;
//!
//! // The light of a lamp of three bands is not that of the lamp of tungsten that it replaces.
//! assert_eq!(similarity(&fine_light("A")?, &fine_light("A")?), Some(100.0));
//! assert!(similarity(&fine_light("FL12")?, &fine_light("A")?).is_some_and(|found| found < 50.0));
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

use crate::spectra::{Outside, Sampled};

/// The bands of 10 nm, the first around 380 nm.
const BANDS: usize = 30;

/// What is added to the reference's part of a band, so that dark bands do not count too much.
const FLOOR: f64 = 1.0 / 30.0;

/// The index of a light against a reference; none for a light without power from 375 to 675 nm.
pub fn similarity<S: Sampled>(test: &S, reference: &S) -> Option<f64> {
    let (test, reference) = (bands(test)?, bands(reference)?);
    let mut differences = [0.0; BANDS + 4];
    for i in 0..BANDS {
        differences[i + 2] = weight(i) * (test[i] - reference[i]) / (reference[i] + FLOOR);
    }
    let smoothed = differences.windows(3).map(|at| 0.22 * at[0] + 0.56 * at[1] + 0.22 * at[2]);
    let sum: f64 = smoothed.map(|value| value * value).sum();
    Some((100.0 - 32.0 * sum.sqrt()).round())
}

/// The parts of the power in each band; ends of a band count half.
fn bands<S: Sampled>(light: &S) -> Option<[f64; BANDS]> {
    let light = light.to_fine(Outside::Zero);
    let band = |i: usize| {
        let first = 375.0 + 10.0 * i as f64;
        let at = |nm: u8| light.at(first + f64::from(nm));
        (at(0) + at(10)) / 2.0 + (1..10).map(at).sum::<f64>()
    };
    let bands: [f64; BANDS] = core::array::from_fn(band);
    let sum: f64 = bands.iter().sum();
    (sum > 0.0).then(|| bands.map(|power| power / sum))
}

/// How much a band counts: less at the ends, where cameras see little.
fn weight(band: usize) -> f64 {
    const FIRST: [f64; 5] = [12.0, 22.0, 32.0, 40.0, 44.0];
    match band {
        0..5 => FIRST[band] / 45.0,
        28 => 11.0 / 15.0,
        29 => 3.0 / 15.0,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::fine_light;
    use crate::spectra::FineSpectrum;

    #[test]
    fn lights_are_as_similar_as_by_colour_science() {
        // colour-science 0.4.7, spectral_similarity_index against D65, of lights by 1 nm (SpragueInterpolator).
        for (name, expected) in [
            ("FL2", 58.0),
            ("FL11", 27.0),
            ("LED-B3", 60.0),
            ("LED-B5", 60.0),
            ("LED-RGB1", 7.0),
            ("HP1", -31.0),
            ("A", 47.0),
        ] {
            let found = similarity(&fine_light(name).unwrap(), &fine_light("D65").unwrap()).unwrap();
            assert!((found - expected).abs() <= 1.0, "{name}: {found}, not {expected}");
        }
        assert_eq!(similarity(&FineSpectrum::from_fn(|_| 0.0), &fine_light("A").unwrap()), None);
    }
}
