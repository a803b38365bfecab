//! Round trips and laws of spectra from RGB.

use proptest::prelude::*;

use super::*;

/// What `JakobHanika` states.
const ROUND_TRIP: f64 = 1e-6;

fn greatest_difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

#[test]
fn the_perfect_diffuser_is_white() {
    assert!(greatest_difference(rgb_of_reflectance(&Spectrum::ONE).0, [1.0; 3]) < 1e-12);
}

#[test]
fn every_colour_of_a_grid_over_the_cube_comes_back_from_its_smooth_spectrum() {
    const STEPS: usize = 8;
    let at = |i: usize| i as f64 / STEPS as f64;
    for i in 0..(STEPS + 1).pow(3) {
        let rgb = [at(i % (STEPS + 1)), at(i / (STEPS + 1) % (STEPS + 1)), at(i / (STEPS + 1).pow(2))];
        let fit = JakobHanika::fit(LinearSrgb(rgb)).unwrap();
        let found = rgb_of_reflectance(&fit.spectrum()).0;
        assert!(greatest_difference(found, rgb) < ROUND_TRIP, "{rgb:?} became {found:?}");
        assert!(fit.spectrum().0.iter().all(|s| (0.0..=1.0).contains(s)), "{rgb:?}");
    }
}

#[test]
fn greys_are_constant() {
    for grey in [0.0, 0.18, 0.5, 1.0] {
        let spectrum = JakobHanika::fit(LinearSrgb([grey; 3])).unwrap().spectrum();
        assert!(spectrum.0.iter().all(|s| (s - grey).abs() < 1e-12), "{grey}: {spectrum:?}");
    }
}

#[test]
fn smooth_spectra_have_no_kink_at_the_ends_of_the_visible() {
    let fit = JakobHanika::fit(LinearSrgb([0.7, 0.2, 0.1])).unwrap();
    for (before, here) in (300..780).map(|nm| (fit.at(nm as f64), fit.at(nm as f64 + 1.0))) {
        assert!((before - here).abs() < 0.02, "{before} and {here}");
    }
}

#[test]
fn bright_colours_are_scaled_and_negative_ones_refused() {
    let lamp = LinearSrgb([12.0, 3.0, 0.5]);
    let fit = JakobHanika::fit(lamp).unwrap();
    assert_eq!(fit.scale, 24.0);
    assert!(greatest_difference(rgb_of_reflectance(&fit.spectrum()).0, lamp.0) < 24.0 * ROUND_TRIP);
    for rgb in [[-0.1, 0.5, 0.5], [f64::NAN, 0.0, 0.0], [f64::INFINITY, 0.0, 0.0], [f64::MAX; 3]] {
        assert!(matches!(JakobHanika::fit(LinearSrgb(rgb)), Err(UpsampleError::OutOfGamut(_))), "{rgb:?}");
    }
}

#[test]
fn a_light_of_rgb_1_is_d65() {
    let d65 = light("D65").unwrap();
    let found = JakobHanika::fit(LinearSrgb([1.0; 3])).unwrap().light();
    assert!(found.0.iter().zip(d65.0).all(|(a, b)| (a - b).abs() < 1e-12));
}

#[test]
fn the_basis_sums_to_one_and_is_a_set_of_reflectances() {
    let [r, g, b] = *mallett_yuksel_basis();
    for i in 0..crate::SAMPLES {
        assert!((r[i] + g[i] + b[i] - 1.0).abs() < 1e-14);
        assert!(
            [r[i], g[i], b[i]].iter().all(|s| (0.0..=1.0).contains(s)),
            "{i}: {} {} {}",
            r[i],
            g[i],
            b[i]
        );
    }
}

#[test]
fn the_basis_has_exactly_the_colours_of_the_primaries() {
    for (i, spectrum) in mallett_yuksel_basis().iter().enumerate() {
        let mut primary = [0.0; 3];
        primary[i] = 1.0;
        assert!(greatest_difference(rgb_of_reflectance(spectrum).0, primary) < 1e-12);
    }
}

proptest! {
    #[test]
    fn every_colour_of_the_cube_comes_back_from_its_smooth_spectrum(
        rgb in prop::array::uniform3(prop_oneof![0.0..1.0_f64, 0.0..1e-3_f64, 0.999..1.0_f64])
    ) {
        let fit = JakobHanika::fit(LinearSrgb(rgb)).expect("a colour of the cube");
        let found = rgb_of_reflectance(&fit.spectrum()).0;
        prop_assert!(greatest_difference(found, rgb) < ROUND_TRIP, "{rgb:?} became {found:?}");
    }
}
