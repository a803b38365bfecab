use super::*;
use crate::spectra::lambda_nm;

/// Sums of a hundred rounded products.
const ROUNDING: f64 = 1e-12;

fn steps(first: f64, last: f64, step: f64) -> Vec<f64> {
    let count = ((last - first) / step).round() as usize + 1;
    (0..count).map(|i| first + step * i as f64).collect()
}

/// A smooth fluorescence, as density per nm of emission.
fn density(out: f64, input: f64) -> f64 {
    let bell = |nm: f64, peak: f64, width: f64| {
        let x = (nm - peak) / width;
        (-x * x).exp()
    };
    if out > input { 0.008 * bell(out, 560.0, 40.0) * bell(input, 450.0, 50.0) } else { 0.0 }
}

fn reflectance(nm: f64) -> f64 {
    0.3 + 0.2 * ((nm - 500.0) / 80.0).tanh()
}

/// The smooth material as an instrument with this step gives it.
fn measured(step: f64) -> Reradiation {
    let (out_nm, in_nm) = (steps(380.0, 780.0, step), steps(300.0, 780.0, step));
    let value = |out: f64, input: f64| {
        if (out - input).abs() < 0.01 { reflectance(out) } else { step * density(out, input) }
    };
    let values: Vec<f64> =
        out_nm.iter().flat_map(|&out| in_nm.iter().map(move |&input| value(out, input))).collect();
    Reradiation::from_measured(&out_nm, &in_nm, &values, step).unwrap()
}

#[test]
fn a_matrix_on_the_grid_is_taken_as_it_is() {
    let matrix = measured(5.0);
    for (out, input) in [(40, 40), (55, 30), (50, 20), (16, 16), (96, 96), (30, 55)] {
        let (a, b) = (lambda_nm(out), lambda_nm(input));
        let expected = if out == input { reflectance(a) } else { 5.0 * density(a, b) };
        assert!((matrix.get(out, input) - expected).abs() < ROUNDING, "{a} {b}");
    }
    assert_eq!(matrix.get(15, 15), 0.0);
}

#[test]
fn wider_and_narrower_bands_give_the_same_light() {
    let light = Spectrum::from_fn(|nm| 1.0 + 0.3 * (nm / 50.0).sin());
    let reference = measured(5.0).apply(&light);
    // 1 % of the greatest: the light has a period of 31 samples of the coarsest matrix's step.
    let tolerance = 0.01 * reference.max();
    for step in [1.0, 2.5, 10.0] {
        let leaving = measured(step).apply(&light);
        for ((nm, a), (_, b)) in leaving.points().zip(reference.points()) {
            // Next to the diagonal the emission begins with a step that no coarse matrix resolves.
            assert!((a - b).abs() < tolerance, "{step} nm at {nm} nm: {a} instead of {b}");
        }
    }
}

#[test]
fn a_column_keeps_its_energy() {
    // Excited at 400 nm, far from the emission, so that the whole column is smooth.
    let energy = |matrix: &Reradiation| -> f64 { (21..SAMPLES).map(|out| matrix.get(out, 20)).sum() };
    let fine = energy(&measured(5.0));
    assert!((energy(&measured(10.0)) / fine - 1.0).abs() < 1e-4);
    assert!((energy(&measured(20.0)) / fine - 1.0).abs() < 1e-2);
}

#[test]
fn light_between_two_measured_wavelengths_excites_by_the_mean_of_both() {
    let matrix = measured(10.0);
    for out in 40..SAMPLES {
        let mean = 0.5 * (matrix.get(out, 20) + matrix.get(out, 22));
        assert!((matrix.get(out, 21) - mean).abs() < 1e-9, "{}", lambda_nm(out));
    }
}

#[test]
fn noise_below_zero_is_cut_and_the_energy_of_a_column_kept() {
    let (out_nm, in_nm) = (steps(400.0, 500.0, 10.0), [350.0]);
    let mut values = [0.0; 11];
    (values[5], values[9]) = (0.2, -0.04);
    let matrix = Reradiation::from_measured(&out_nm, &in_nm, &values, 10.0).unwrap();
    let column: Vec<f64> = (0..SAMPLES).map(|out| matrix.get(out, 10)).collect();
    assert!(column.iter().all(|value| *value >= 0.0));
    assert!((column.iter().sum::<f64>() - 0.2).abs() < ROUNDING);
    // The cubic of a lone sample falls to −1/16 of it on both sides.
    assert!((column[30] - 0.1 / (1.0 + 1.0 / 16.0)).abs() < ROUNDING);
}

#[test]
fn what_is_no_matrix_is_refused() {
    let error = |out: &[f64], input: &[f64], values: &[f64], band: f64| {
        Reradiation::from_measured(out, input, values, band).unwrap_err().to_string()
    };
    let two = [400.0, 410.0];
    assert!(error(&[], &two, &[], 10.0).starts_with("expected 1 to 4096 wavelengths of emission, found 0"));
    let text = error(&[410.0, 400.0], &two, &[0.0; 4], 10.0);
    assert_eq!(text, "expected ascending wavelengths of emission in nm, found 400 after 410 (number 2)");
    assert!(error(&two, &[f64::NAN, 1.0], &[0.0; 4], 10.0).contains("found NaN after 0"));
    assert!(error(&two, &two, &[0.0; 3], 10.0).contains("expected 4 values"));
    assert!(error(&two, &two, &[0.0; 4], 0.0).contains("found 0"));
    let text = error(&two, &two, &[0.0, 0.0, 80.0, 0.0], 10.0);
    assert!(text.ends_with("found 80 at an emission of 410 nm, excitation 400 nm"), "{text}");
    assert!(error(&two, &two, &[f64::NAN; 4], 10.0).contains("found NaN"));
    assert!(error(&two, &[405.0], &[0.0; 2], 10.0).starts_with("expected the excitation 405 nm among"));
}

#[test]
fn the_parts_of_a_matrix_sum_to_it() {
    let matrix = measured(5.0);
    let (reflected, emitted) = (matrix.without_reradiation(), matrix.off_diagonal());
    let light = Spectrum::from_fn(|nm| nm / 500.0);
    let both = reflected.apply(&light) + emitted.apply(&light);
    for ((_, a), (_, b)) in both.points().zip(matrix.apply(&light).points()) {
        assert!((a - b).abs() < ROUNDING);
    }
    assert_eq!(reflected.reflectance(), matrix.reflectance());
    assert_eq!(emitted.reflectance(), Spectrum::ZERO);
}

#[test]
fn the_radiance_factor_may_exceed_1_and_is_0_without_light() {
    let matrix = Reradiation::from_fn(|out, input| if (out, input) == (50, 20) { 0.5 } else { 0.0 });
    let blue =
        Spectrum(core::array::from_fn(|i| [0.0, 1.0, 10.0][usize::from(i == 50) + 2 * usize::from(i == 20)]));
    let factor = matrix.total_radiance_factor(&blue);
    assert_eq!(factor[50], 5.0);
    assert_eq!(factor.0.iter().filter(|value| **value != 0.0).count(), 1);
}

#[test]
fn matrices_that_make_light_from_nothing_are_found() {
    assert!(Reradiation::diagonal(&Spectrum::ONE).energy().ok);
    let bright = Reradiation::diagonal(&Spectrum::constant(1.02)).energy();
    assert!(!bright.ok && bright.max_column_sum == 1.02);
    let one = |at: (usize, usize), value: f64| {
        Reradiation::from_fn(|out, input| if (out, input) == at { value } else { 0.0 }).energy()
    };
    // From 300 to 600 nm half of the energy is all of the photons.
    let all = one((60, 0), 0.5);
    assert!(all.ok && all.max_photon_sum == 1.0 && all.photons_at_nm == 300.0);
    assert!(!one((60, 0), 0.6).ok);
    let up = one((0, 60), 0.2);
    assert!(!up.ok && up.up_conversion == 0.2 && up.at_nm == 600.0);
    assert!(!one((60, 0), -0.1).ok && !one((60, 0), f64::NAN).ok);
}
