use super::*;

/// Published tables are rounded to 0.001 (where the greatest is about 100), those of D65 before values
/// between the points by 10 nm were taken.
const TABLE_ROUNDING: f64 = 0.001 / 100.0;

fn published(name: &str) -> Spectrum {
    let table = Table::parse(include_str!("../../data/lights_published.csv"));
    table.spectrum(name, Outside::Zero).expect("a published light") * (1.0 / 100.0)
}

fn difference(a: Spectrum, b: Spectrum) -> f64 {
    (a - b).map(f64::abs).max()
}

#[test]
fn formulas_give_the_published_tables() {
    for name in ["A", "D50", "D55", "D65", "D75"] {
        let found = difference(light(name).expect("a light"), published(name));
        assert!(found <= TABLE_ROUNDING, "{name}: {found}");
    }
    for name in ["D(6504)", "D6504", "d6504"] {
        // D65 is of 6503.6 K, with factors rounded to three decimals.
        assert!(difference(light(name).expect("a light"), published("D65")) <= 3e-4);
    }
}

#[test]
fn every_light_loads_and_shines() {
    for info in lights() {
        let light = light(info.example).expect("a listed light loads");
        assert!(light.is_finite() && light.0.iter().all(|v| *v >= 0.0), "{}", info.name);
        assert!(light.max() > 0.1, "{}", info.name);
        let dark = light.points().all(|(nm, value)| nm >= info.range_nm.0 || value == 0.0);
        assert!(dark, "{} shines below {} nm", info.name, info.range_nm.0);
        assert_eq!(light, super::light(&info.example.to_lowercase()).expect("small letters are fine"));
    }
    assert_eq!(TABLE.names().count(), lights().iter().filter(|i| i.source.ends_with("table")).count());
}

#[test]
fn lights_are_scaled_as_the_page_says() {
    for name in ["A", "D50", "D65", "D75", "D(10000)", "E", "blackbody(3000)"] {
        assert!((light(name).expect("a light").at(560.0) - 1.0).abs() < 1e-12, "{name}");
    }
    let photopic = kept("photopic").channels[0].sensitivity;
    let white = photopic.integral();
    for name in ["FL2", "FL3.15", "HP1", "LED-RGB1"] {
        assert!((light(name).expect("a light").dot(&photopic) / white - 1.0).abs() < 1e-12, "{name}");
    }
    assert_eq!(light("UV365").expect("a light").at(365.0), 1.0);
    assert_eq!(light("F11").expect("the older name"), light("FL11").expect("the name"));
}

#[test]
fn planck_s_law_with_the_constants_of_today_is_near_illuminant_a() {
    let found = difference(light("blackbody(2855.54)").expect("a light"), light("A").expect("a light"));
    // T = 2848 K · 1.438777 / 1.4350: the same product c₂ / T.
    assert!(found < 1e-4, "{found}");
}

#[test]
fn gaussians_keep_their_integral_however_narrow() {
    for fwhm in [0.01, 1.0, 4.0, 9.99, 10.0, 40.0] {
        let light = light(&format!("gaussian(541.3, {fwhm})")).expect("a light");
        let known = fwhm / 2.354_820_045 * (2.0 * std::f64::consts::PI).sqrt();
        assert!((light.integral() / known - 1.0).abs() < 1e-5, "{fwhm}");
    }
    assert!((light("line(546.1)").expect("a light").integral() - 1.0).abs() < 1e-12);
}

#[test]
fn a_mixture_has_equal_parts() {
    let (d65, uv) = (light("D65").expect("a light"), light("UV365").expect("a light"));
    let mixture = light("d65 + uv365").expect("a light");
    assert!((mixture.integral() / d65.integral() - 1.0).abs() < 1e-12);
    let uv_part = mixture - d65 * 0.5;
    assert!(difference(uv_part, uv * (0.5 * d65.integral() / uv.integral())) < 1e-12);
    assert!(difference(light("A+A+A").expect("a light"), light("A").expect("a light")) < 1e-12);
}

#[test]
fn wrong_names_are_told() {
    let error = |name: &str| light(name).expect_err("no light").to_string();
    assert_eq!(error("UV356"), "there is no light 'UV356'; did you mean 'UV365'?");
    assert_eq!(error("ledb1"), "there is no light 'ledb1'; did you mean 'LED-B1'?");
    assert_eq!(error("tungsten"), "there is no light 'tungsten'");
    assert_eq!(error("D(3000)"), "light 'D(3000)': expected a colour temperature of 4000 to 25000 K");
    assert_eq!(error("D26000"), "light 'D26000': expected a colour temperature of 4000 to 25000 K");
    assert!(error("blackbody(-1)").contains("500 to 1000000 K"));
    assert!(error("blackbody(3000").contains("a closing bracket, as in 'blackbody(3000)'"));
    assert!(error("gaussian(500)").contains("gaussian(nm, fwhm)"));
    assert!(error("line(NaN)").contains("300 to 780 nm"));
    assert!(error("laser(500)").contains("no light 'laser(500)'"));
    for strange in
        ["", "+", "d", "d+", "D65+", "line(", "()", "d4", "d99999999999999999999", "fl", "ſ", "D(1,2"]
    {
        assert!(light(strange).is_err(), "{strange}");
    }
    assert!(light(&["A"; 17].join("+")).is_err());
}

#[test]
fn daylight_is_never_dark_and_has_no_steps() {
    for hundreds in 40..250 {
        let cct = f64::from(hundreds) * 100.0;
        let (here, near): (Spectrum, Spectrum) = (formulas::daylight(cct), formulas::daylight(cct + 1.0));
        assert!(here.0.iter().all(|value| *value > 0.0), "{cct} K");
        assert!(difference(here, near) < 1e-3, "{cct} K");
    }
}

#[test]
fn black_bodies_and_daylight_of_a_temperature_agree_with_colour_science() {
    // colour-science 0.4.7: sd_blackbody and sd_CIE_illuminant_D_series without rounding of M1 and M2, over their values
    // at 560 nm; at 300, 400, 680 and 780 nm, and at 300, 450, 650 and 780 nm.
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 2e-6;
    for (kelvin, expected) in [
        (2000.0, [0.000_331_195_2, 0.031_549_016_4, 3.655_597_423_5, 7.146_781_191_6]),
        (2856.0, [0.009_316_474_9, 0.147_165_319_4, 1.853_821_238_0, 2.415_773_486_4]),
        (10000.0, [2.276_575_010_6, 1.827_142_127_2, 0.625_861_231_6, 0.431_831_418_5]),
    ] {
        // Its second radiation constant is the older 1.4388e7 nm K.
        let kelvin = kelvin * 1.438_776_877 / 1.4388;
        let found = planck(kelvin).expect("within the range");
        for (nm, expected) in [300.0, 400.0, 680.0, 780.0].into_iter().zip(expected) {
            assert!(near(found.at(nm), expected), "{kelvin} K, {nm} nm: {} for {expected}", found.at(nm));
        }
        assert_eq!(found, light(&format!("blackbody({kelvin})")).expect("a light"));
    }
    for (cct_k, expected) in [
        (4000.0, [0.000_099_081_3, 0.633_882_454_7, 1.186_326_124_4, 0.998_679_834_7]),
        (5000.0, [0.000_191_985_3, 0.871_980_335_3, 0.957_054_207_3, 0.783_100_676_6]),
        (25000.0, [0.000_981_375_9, 2.251_572_676_6, 0.628_784_249_7, 0.460_229_520_5]),
    ] {
        let found = daylight(cct_k).expect("within the range");
        for (nm, expected) in [300.0, 450.0, 650.0, 780.0].into_iter().zip(expected) {
            assert!(near(found.at(nm), expected), "{cct_k} K, {nm} nm: {} for {expected}", found.at(nm));
        }
        assert_eq!(found, light(&format!("D({cct_k})")).expect("a light"));
    }
}

#[test]
fn temperatures_beyond_the_range_are_refused_with_it() {
    for kelvin in [499.0, 1.1e6, f64::NAN, -5000.0] {
        let error = planck(kelvin).expect_err("out of range");
        assert_eq!(error.range_k, PLANCK_RANGE_K);
        assert!(error.to_string().contains(&format!("500 to 1000000 K, found {kelvin}")), "{error}");
    }
    for cct_k in [3999.0, 25001.0, f64::INFINITY] {
        let text = daylight(cct_k).expect_err("out of range").to_string();
        assert_eq!(text, format!("expected a colour temperature of 4000 to 25000 K, found {cct_k}"));
    }
}
