use super::*;
use crate::lights::fine_light;
use crate::measures::chromaticity::Chromaticity;
use crate::measures::temperature::color_temperature;
use crate::observers::{Observer, observer, observers, xyz_of_light};
use crate::spectra::Sampled;
use proptest::prelude::*;

/// Rounding of some hundred sums.
const ROUNDING: f64 = 1e-9;

#[test]
fn tables_by_20_nm_are_interpolated_as_by_colour_science() {
    // colour-science 0.4.7, SpragueInterpolator.
    let nm: Vec<f64> = (0..=20).map(|i| 380.0 + 20.0 * f64::from(i)).collect();
    let value = |nm: &f64| 0.3 + 0.2 * (nm / 37.0).sin() + 0.1 * (nm / 90.0).cos();
    let values: Vec<f64> = nm.iter().map(value).collect();
    let found = FineSpectrum::from_table(&nm, &values, Outside::Hold).unwrap();
    for (nm, expected) in [
        (381.0, 0.101_343_313_709_5),
        (383.0, 0.097_541_602_845_7),
        (395.0, 0.079_400_046_861_9),
        (407.0, 0.080_460_183_008_2),
        (411.0, 0.086_334_266_134_4),
        (555.0, 0.529_338_986_216_878),
        (563.0, 0.494_425_673_503_6),
        (769.0, 0.421_472_464_608_808),
        (779.0, 0.388_741_454_910_8),
    ] {
        assert!((found.at(nm) - expected).abs() < ROUNDING, "{nm} nm: {} for {expected}", found.at(nm));
    }
    let lines = FineSpectrum::interpolated(&nm, &values, Outside::Hold, Interpolation::Lines).unwrap();
    assert_eq!(lines.at(390.0), 0.5 * (values[0] + values[1]));
}

#[test]
fn lights_of_the_cie_by_5_nm_have_their_chromaticities() {
    // colour-science 0.4.7: SpragueInterpolator to 1 nm, sums from 380 to 780 nm, uv_to_CCT_Ohno2013. For LED-B5 the CIE
    // tells 6598 K.
    for (name, x, y, cct_k) in [
        ("LED-B5", 0.311_807_3, 0.323_634_14, 6597.605),
        ("FL2", 0.372_065_21, 0.375_115_99, 4224.52),
        ("FL11", 0.380_538_88, 0.376_906_03, 3998.5),
        ("HP1", 0.532_995_8, 0.414_961_75, 1959.28),
        ("FL3.12", 0.437_667_98, 0.403_655_56, 2984.21),
    ] {
        let xy = Chromaticity::of_light(&fine_light(name).unwrap()).unwrap();
        assert!((xy.x - x).abs() < 2e-6 && (xy.y - y).abs() < 2e-6, "{name}: {xy:?}");
        let found = color_temperature(xy).unwrap();
        assert!((found.cct_k - cct_k).abs() < 0.15, "{name}: {found:?}");
    }
}

#[test]
fn the_white_of_d65_is_that_of_the_standard() {
    // ISO/CIE 11664-2: sums from 360 to 830 nm by 1 nm.
    let white = xyz_of_light(&fine_light("D65").unwrap(), &Observer::default());
    for (found, known) in white.iter().zip([0.950_47, 1.0, 1.088_83]) {
        assert!((found - known).abs() < 5e-6, "{white:?}");
    }
}

#[test]
fn finer_tables_are_summed_at_their_own_steps() {
    // A band of 2 nm width by 0.25 nm: the sum over the table of its values times the observer between its wavelengths.
    let nm: Vec<f64> = (0..=40).map(|i| 450.0 + 0.25 * f64::from(i)).collect();
    let values: Vec<f64> = nm.iter().map(|nm| (1.0 - (nm - 455.3).abs()).max(0.0)).collect();
    let found = FineSpectrum::from_table(&nm, &values, Outside::Zero).unwrap();
    let curves = Observer::default().fine_sensitivities();
    for (curve, response) in curves.iter().zip(found.responses(&Observer::default())) {
        let sum: f64 = nm.iter().zip(&values).map(|(nm, value)| 0.25 * value * curve.at(*nm)).sum();
        // The sum is by the trapezium rule, the projection exact for lines between the points.
        assert!((response / sum - 1.0).abs() < 2e-5, "{response} {sum}");
    }
    let centre: f64 = found.points().map(|(nm, value)| nm * value).sum::<f64>() / found.integral();
    assert!((centre - 455.3).abs() < 0.01, "{centre}");
}

#[test]
fn curves_of_observers_by_1_nm_are_those_by_5_nm_and_more() {
    for info in observers() {
        let observer = observer(info.name).unwrap();
        for (fine, channel) in observer.fine_sensitivities().iter().zip(&observer.channels) {
            // The table by 1 nm has 6 digits.
            for (nm, value) in channel.sensitivity.points() {
                assert!((fine.at(nm) - value).abs() < 5.1e-6 * value.max(1.0), "{} {nm} nm", info.name);
            }
        }
    }
    let camera = Observer::from_channels("camera", observer("cie1931").unwrap().channels[..2].to_vec());
    let curves = camera.fine_sensitivities();
    let known = observer("cie1931").unwrap().fine_sensitivities().into_owned();
    // Sprague's interpolation of the values by 5 nm: to 1e-4 of the CIE's by 1 nm.
    assert!(curves[0].points().all(|(nm, value)| (value - known[0].at(nm)).abs() < 1.2e-4));
}

#[test]
fn gaps_are_bridged_by_lines() {
    let nm = [400.0, 402.0, 403.5, 406.0, 500.0, 502.0, 504.5];
    let values = [0.1, 0.2, 0.4, 0.3, 0.5, 0.1, 0.2];
    let found = FineSpectrum::from_table(&nm, &values, Outside::Hold).unwrap();
    assert!((found.at(453.0) - 0.4).abs() < ROUNDING);
    assert_eq!((found.at(300.0), found.at(402.0), found.at(830.0)), (0.1, 0.2, 0.2));
}

proptest! {
    #[test]
    fn cubics_at_any_steps_are_exact(steps in prop::collection::vec(1.5..4.0_f64, 30), a in -1.0..1.0_f64) {
        let nm: Vec<f64> = steps.iter().scan(440.0, |nm, step| { *nm += step; Some(*nm) }).collect();
        let cubic = |nm: f64| { let x = (nm - 470.0) / 50.0; 2.0 + x * (a + x * (1.0 + x)) };
        let values: Vec<f64> = nm.iter().map(|nm| cubic(*nm)).collect();
        let found = FineSpectrum::from_table(&nm, &values, Outside::Zero).unwrap();
        for (at, value) in found.points().filter(|(at, _)| (nm[1]..nm[28]).contains(at)) {
            prop_assert!((value - cubic(at)).abs() < ROUNDING, "{} nm", at);
        }
    }

    #[test]
    fn values_of_a_table_are_kept(step in prop::sample::select(vec![1.0, 2.0, 5.0, 10.0, 20.0]), shift in 0.0..1.0_f64) {
        let nm: Vec<f64> = (0..20).map(|i| 400.0 + step * f64::from(i)).collect();
        let values: Vec<f64> = nm.iter().map(|nm| shift + (nm * 0.37).sin().abs()).collect();
        for interpolation in [Interpolation::Lines, Interpolation::Smooth] {
            let found = FineSpectrum::interpolated(&nm, &values, Outside::Zero, interpolation).unwrap();
            for (nm, value) in nm.iter().zip(&values) {
                prop_assert!((found.at(*nm) - value).abs() < ROUNDING);
            }
        }
    }
}
