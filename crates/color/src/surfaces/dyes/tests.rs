use super::*;
use crate::lights::light;
use proptest::prelude::*;

/// Where a spectrum is greatest, in nm.
fn top(spectrum: &Spectrum, from_nm: f64) -> f64 {
    let within = spectrum.points().filter(|(nm, _)| *nm >= from_nm);
    within.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(nm, _)| nm).unwrap()
}

#[test]
fn dyes_absorb_and_emit_where_they_are_known_to() {
    // Absorption and emission maxima as PhotochemCAD and, of the brightener, McNamara et al. tell them.
    for (name, absorption_nm, emission_nm) in [
        ("pyranine", 454.0, 512.0),
        ("fluorescein", 500.0, 540.0),
        ("coumarin-6", 456.0, 500.0),
        ("rhodamine-6g", 530.0, 552.0),
        ("rhodamine-b", 543.0, 565.0),
        ("quinine-sulphate", 347.0, 451.0),
        ("brightener-28", 349.0, 432.0),
    ] {
        let dye = dye(name).unwrap();
        assert!((top(dye.absorption(), 330.0) - absorption_nm).abs() <= 4.0, "{name}");
        assert!((top(&dye.photons, 300.0) - emission_nm).abs() <= 5.0, "{name}");
    }
    assert_eq!(dyes().len(), 7);
    assert!(dye("pyranin").unwrap_err().to_string().contains("did you mean 'pyranine'?"));
}

#[test]
fn layers_obey_the_conservation_of_energy() {
    for info in dyes() {
        for absorbance in [0.0, 0.3, 1.3, 10.0] {
            let report = dye(info.name).unwrap().over(&Spectrum::ONE, absorbance).unwrap().energy();
            assert!(report.ok, "{} {absorbance}: {report:?}", info.name);
        }
    }
}

#[test]
fn a_thick_layer_emits_further_to_the_red() {
    let dye = dye("rhodamine-b").unwrap();
    let centre = |absorbance| {
        let glow = dye.over(&Spectrum::ONE, absorbance).unwrap().off_diagonal();
        let sent = glow.apply(&light("line(500)").unwrap());
        sent.points().map(|(nm, value)| nm * value).sum::<f64>() / sent.0.iter().sum::<f64>()
    };
    assert!(centre(3.0) > centre(0.3) + 5.0);
}

#[test]
fn what_is_no_dye_is_refused() {
    let band = |from: f64, to: f64| Spectrum::from_fn(|nm| if (from..to).contains(&nm) { 1.0 } else { 0.0 });
    let (blue, green) = (band(420.0, 480.0), band(500.0, 560.0));
    assert!(Dye::from_spectra(&blue, &green, 0.9).is_ok());
    let text = |found: Result<Dye, DyeError>| found.unwrap_err().to_string();
    assert!(text(Dye::from_spectra(&green, &blue, 0.9)).contains("exchanged"));
    assert!(text(Dye::from_spectra(&blue, &green, 90.0)).contains("from 0 to 1, found 90"));
    assert!(text(Dye::from_spectra(&Spectrum::ZERO, &green, 0.9)).contains("an excitation"));
    assert!(text(Dye::from_spectra(&blue, &(green * -1.0), 0.9)).contains("an emission"));
    let dye = Dye::from_spectra(&blue, &green, 0.9).unwrap();
    assert!(matches!(dye.over(&Spectrum::constant(1.2), 1.0), Err(DyeError::Base { .. })));
    assert!(matches!(dye.over(&Spectrum::ONE, -1.0), Err(DyeError::Range { .. })));
}

proptest! {
    #[test]
    fn spectra_on_any_scale_give_the_same_dye(scale in 1e-6..1e6_f64, absorbance in 0.0..5.0_f64) {
        let dye = dye("pyranine").unwrap();
        let again = Dye::from_spectra(&(*dye.absorption() * scale), &(dye.emission() * scale), 1.0).unwrap();
        let (a, b) = (dye.over(&Spectrum::ONE, absorbance).unwrap(), again.over(&Spectrum::ONE, absorbance).unwrap());
        for out in 0..SAMPLES {
            for input in 0..SAMPLES {
                prop_assert!((a.get(out, input) - b.get(out, input)).abs() < 1e-12);
            }
        }
    }
}
