//! Spectra, fluorescence, refractive indices and physical units in scene files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::PI;

use glanz_color::{Spectrum, fluorescent, light, reflectance, rgb_spectra};

use super::{parse, scene};
use crate::{Attenuation, ColorMode, LightColor, LightKind, Scene, Tint, White};

/// Rounding of a scale and of sums over the grid.
const ROUNDING: f64 = 1e-12;

fn lamp(keys: &str) -> Scene {
    scene(&format!("[[lights]]\nkind = 'directional'\ndirection = [0, 0, -1]\nambient = 0\n{keys}\n"))
}

fn sent(scene: &Scene) -> Spectrum {
    match &scene.lights[0].colors.diffuse {
        LightColor::Spectrum(spectrum) => **spectrum,
        LightColor::Rgb(rgb) => panic!("a spectrum, not {rgb:?}"),
    }
}

fn diffuse(value: &str) -> Tint {
    scene(&format!("[materials.m]\ndiffuse = {value}")).materials[0].lobes[0].tint.clone()
}

fn assert_parallel(found: &Spectrum, expected: &Spectrum, what: &str) {
    let ratio = found.max() / expected.max();
    for (a, b) in found.0.iter().zip(&expected.0) {
        assert!((a - b * ratio).abs() <= ROUNDING * found.max(), "{what}: {a} for {}", b * ratio);
    }
}

fn error(text: &str) -> String {
    let error = parse(text).expect_err(text);
    assert!(error.span.is_some(), "{error}");
    error.message
}

#[test]
fn a_lamp_of_any_spectrum_has_the_luminance_1() {
    let named = [
        ("spectrum = 'A'", "A"),
        ("spectrum = 'fl11'", "FL11"),
        ("spectrum = { blackbody = 2856 }", "blackbody(2856)"),
        ("spectrum = { gaussian = [550, 20] }", "gaussian(550,20)"),
        ("color = { line = 589 }", "line(589)"),
        ("color = { spectrum = 'D(5000)' }", "D(5000)"),
    ];
    for (keys, name) in named {
        let found = sent(&lamp(keys));
        assert_parallel(&found, &light(name).unwrap(), name);
        assert!((rgb_spectra::luminance(&found) - 1.0).abs() < ROUNDING, "{name}");
    }
    let double = sent(&lamp("spectrum = { spectrum = 'A', scale = 0.5 }\nintensity = 4"));
    assert!((rgb_spectra::luminance(&double) - 2.0).abs() < ROUNDING);
}

#[test]
fn black_light_has_the_power_of_daylight() {
    let found = sent(&lamp("spectrum = 'UV365'"));
    assert!((found.integral() / rgb_spectra::daylight().integral() - 1.0).abs() < ROUNDING);
    assert!(rgb_spectra::luminance(&found) < 1e-3);
}

#[test]
fn spectra_come_from_numbers_and_from_files() {
    let Tint::Spectrum(found) = diffuse("{ nm = [400, 500, 700], value = [0.2, 0.6, 0.4] }") else {
        panic!("a spectrum")
    };
    for (nm, expected) in [(300.0, 0.2), (450.0, 0.4), (500.0, 0.6), (600.0, 0.5), (780.0, 0.4)] {
        assert!((found.at(nm) - expected).abs() < ROUNDING, "{nm} nm: {}", found.at(nm));
    }
    let Tint::Spectrum(found) = diffuse("{ file = 'data/metamer-a.csv', scale = 0.5 }") else {
        panic!("a spectrum")
    };
    assert!(found.at(540.0) > 0.2 && found.at(540.0) < 0.3, "half of about 0.5");
    assert_eq!(diffuse("{ spectrum = 'orange' }"), Tint::Spectrum(reflectance("orange").unwrap().into()));
}

#[test]
fn a_lamp_sends_nothing_beyond_its_table_and_a_surface_is_held() {
    let lamp = parse(
        "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\nspectrum = { nm = [400, 700], value = [1, 1] }",
    );
    let loaded = lamp.unwrap();
    let found = sent(&loaded.scene);
    assert!(found.at(350.0) == 0.0 && found.at(550.0) > 0.0 && found.at(750.0) == 0.0);
    assert!(loaded.notes[0].contains("sends nothing beyond"), "{:?}", loaded.notes);
    let Tint::Spectrum(held) = diffuse("{ nm = [400, 700], value = [0.3, 0.6] }") else {
        panic!("a spectrum")
    };
    assert!((held.at(310.0) - 0.3).abs() < ROUNDING && (held.at(770.0) - 0.6).abs() < ROUNDING);
    let sky = scene("[ambient]\nspectrum = 'A'\n");
    assert!(matches!(sky.lights[0].colors.ambient, LightColor::Spectrum(_)));
}

#[test]
fn surfaces_glow_and_metals_shine() {
    let matrix = fluorescent("quinine").unwrap();
    assert_eq!(diffuse("{ reradiation = 'quinine' }"), Tint::Reradiation(matrix.into()));
    let Tint::Ior(gold) = diffuse("{ ior = 'Au' }") else { panic!("a refractive index") };
    assert!(gold.k.at(600.0) > 2.0);
    let Tint::Ior(glass) = diffuse("{ ior = 1.5 }") else { panic!("a refractive index") };
    assert_eq!((glass.eta.at(555.0), glass.k.at(555.0)), (1.5, 0.0));
}

#[test]
fn physical_units_give_the_luminance_of_white_paper() {
    let luminance = |text: &str| {
        let scene = scene(text);
        assert!(scene.photometric);
        (rgb_spectra::luminance(&sent(&scene)), scene.lights[0].kind.clone())
    };
    let sun =
        "[[lights]]\nkind = 'directional'\ndirection = [0, -1, 0]\nspectrum = 'D65'\nilluminance_lx = 1000";
    assert!((luminance(sun).0 - 1000.0 / PI).abs() < 1e-9);
    let lamp = "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\nspectrum = 'A'\nluminous_intensity_cd = 60";
    let (value, kind) = luminance(lamp);
    assert!((value - 60.0 / PI).abs() < 1e-9);
    assert!(matches!(kind, LightKind::Point { attenuation: Attenuation::PHYSICAL, .. }));
    // 1 W/sr at 555 nm is 683 cd to the rounding of V(555 nm), which is 1.
    let green = "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\nspectrum = { line = 555 }\nradiant_intensity_w_sr = 1";
    assert!((luminance(green).0 - 683.0 / PI).abs() < 0.01);
    let sky = scene("[ambient]\ncolor = [0.2, 0.4, 0.8]\nluminance_cd_m2 = 3000");
    let LightColor::Rgb(rgb) = sky.lights[0].colors.ambient else { panic!("RGB stays RGB") };
    assert!((rgb.luminance() - 3000.0).abs() < 0.01 && sky.photometric);
    let glow = scene("[materials.m]\nemission = { spectrum = 'A', luminance_cd_m2 = 500 }");
    let Tint::Spectrum(own) = &glow.materials[0].lobes[0].tint else { panic!("a spectrum") };
    assert!((rgb_spectra::luminance(own) - 500.0).abs() < 1e-9 && glow.photometric);
}

#[test]
fn units_are_never_mixed() {
    let classic = "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\n";
    let physical = "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\nluminous_intensity_cd = 5\n";
    for text in [
        format!("{classic}{physical}"),
        format!("{physical}[ambient]\ncolor = 0.1\n"),
        format!("{physical}[materials.m]\nemission = [1, 0, 0]\n"),
        format!("{physical}[materials.m]\nemission = {{ spectrum = 'A' }}\n"),
    ] {
        assert_eq!(error(&text), "light in classic units beside light in lx, cd, W/sr or cd/m²");
    }
    assert!(!scene(classic).photometric && scene(physical).photometric);
}

#[test]
fn of_several_spectra_in_a_file_one_is_taken_and_told() {
    let table = "nm,red reflectance,blue reflectance\n400,0.1,0.5\n700,0.6,0.1\n";
    let colors = |more: &str| format!("[materials.m]\ndiffuse = {{ file = 'two.csv'{more} }}\n");
    let load = |more: &str| {
        let scratch = super::Scratch::new(
            "several",
            &[("scenes/two.csv", table), ("scenes/scene.toml", &colors(more))],
        );
        let loaded = scratch.load(false).unwrap_or_else(|error| panic!("{error}"));
        let Tint::Spectrum(own) = &loaded.scene.materials[0].lobes[0].tint else { panic!("a spectrum") };
        (own.at(700.0), loaded.notes)
    };
    let (red, notes) = load("");
    assert!((red - 0.6).abs() < 1e-6, "{red}");
    let told = "'two.csv' holds 2 spectra: 'red reflectance' is taken, the first; 'column' takes another: blue \
                reflectance";
    assert_eq!(notes[0], told);
    let (blue, notes) = load(", column = 2");
    assert!(
        (blue - 0.1).abs() < 1e-6 && !notes.iter().any(|note| note.contains("holds 2")),
        "{blue} {notes:?}"
    );
}

#[test]
fn what_is_no_colour_says_what_would_be() {
    let material = |value: &str| format!("[materials.m]\ndiffuse = {value}\n");
    let light = |keys: &str| format!("[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\n{keys}\n");
    let cases = [
        (material("{ spectrum = 'orang' }"), "there is no reflectance 'orang'; did you mean 'orange'?"),
        (material("{ spectrum = 'D65' }"), "a surface needs a reflectance, found a light source"),
        (material("{ blackbody = 3000 }"), "a surface needs a reflectance, found a light source"),
        (material("{ }"), "a table in place of a colour names no function of wavelength"),
        (
            material("{ ior = 'Au', spectrum = 'orange' }"),
            "'spectrum' and 'ior' in one table: only one can be the colour",
        ),
        (material("{ nm = [400, 500] }"), "'nm' and 'value' need each other; one of them is missing"),
        (material("{ nm = [400, 500], value = [0.1, -0.2] }"), "expected values of at least 0, found -0.2"),
        (material("{ ior = 0.5 }"), "expected an index of refraction between 1.05 and 20, found 0.5"),
        (material("{ ior = 'Au', scale = 2 }"), "Fresnel reflection has no 'scale'"),
        (material("{ file = 'data/nothing.csv' }"), "there is no file 'data/nothing.csv'"),
        (
            material("{ file = 'data/metamer-a.csv', column = 'x' }"),
            "'data/metamer-a.csv' has no spectrum of that name",
        ),
        (
            material("{ file = 'data/metamer-a.csv', column = 7 }"),
            "'data/metamer-a.csv' has no spectrum of that number",
        ),
        (material("{ spectrum = 'orange', as = 'light' }"), "'as' needs 'file'"),
        (material("{ spectrum = 'orange', unit = 'um' }"), "'unit' needs 'file'"),
        (material("{ spectrum = 'orange', pixel = [3, 4] }"), "'pixel' needs 'file'"),
        (material("{ spectrum = 'orange', scale = 'percent' }"), "a word as 'scale' needs 'file'"),
        (light("spectrum = 'FL99'"), "there is no light 'FL99'"),
        (light("spectrum = 'orange'"), "a lamp needs light, found a reflectance"),
        (light("color = { ior = 'Au' }"), "a lamp needs light, found what surfaces do with light"),
        (light("spectrum = 'A'\ncolor = 1"), "'spectrum' beside 'color': only one can be the colour"),
        (light("spectrum = { nm = [400, 500], value = [0, 0] }"), "there is no light in this spectrum"),
        (
            light("spectrum = { file = 'data/metamer-a.csv' }"),
            "a lamp needs light, found a reflectance or transmittance in the file",
        ),
        (light("spectrum = 'UV365'\nluminous_intensity_cd = 5"), "light that the eye hardly sees"),
        (
            light("spectrum = { nm = [0.4, 0.7], value = [1, 1] }"),
            "expected wavelengths in nm, some between 300 and 780, found 0.4 to 0.7",
        ),
        (material("{ nm = [900, 1000], value = [1, 1] }"), "expected wavelengths in nm, some between"),
        ("[ambient]\ncolor = 1\nspectrum = 'A'\n".to_owned(), "'spectrum' beside 'color'"),
        (light("illuminance_lx = 3"), "a point light has no 'illuminance_lx'"),
        (
            light("luminous_intensity_cd = 3\nintensity = 2"),
            "'intensity' beside 'luminous_intensity_cd': one says how strong a light is",
        ),
        (
            light("luminous_intensity_cd = 3\nattenuation = { linear = 1 }"),
            "'luminous_intensity_cd' fades by the inverse square law",
        ),
        (
            light("spectrum = { line = 310 }\nluminous_intensity_cd = 3"),
            "light that the eye hardly sees cannot be given in photometric units",
        ),
        ("[render]\nobserver = 'cie1932'\n".to_owned(), "there is no observer 'cie1932'"),
        ("[render]\nmode = 'spectra'\n".to_owned(), "expected a colour mode"),
        ("[render]\nmode = 'sampled:0'\n".to_owned(), "expected between 1 and 97 wavelengths"),
        ("[render]\nwhite = 'blue'\n".to_owned(), "expected one of D65, scene, light, none, found 'blue'"),
    ];
    for (text, expected) in cases {
        let message = error(&text);
        assert!(message.starts_with(expected), "{text}{message}\n{expected}");
    }
}

#[test]
fn the_look_of_colour_is_read() {
    let text = "[render]\nmode = 'sampled:12'\nwhite = 'scene'\nobserver = 'lms2'\n";
    let scene = scene(text);
    assert_eq!((scene.render.mode, scene.render.white), (ColorMode::Sampled(12), White::Scene));
    assert_eq!(scene.observer.unwrap().channels.len(), 3);
    let plain = super::scene("");
    assert_eq!((plain.render.mode, plain.observer), (ColorMode::Rgb, None));
}

#[test]
fn a_reflectance_above_1_is_told() {
    let loaded = parse("[materials.m]\ndiffuse = { spectrum = 'orange', scale = 3 }").unwrap();
    assert!(loaded.notes[0].contains("more light than arrives"), "{:?}", loaded.notes);
    let spectrum = parse("[materials.m]\ndiffuse = { file = 'data/metamer-a.csv' }").unwrap();
    assert!(spectrum.notes.is_empty(), "{:?}", spectrum.notes);
}
