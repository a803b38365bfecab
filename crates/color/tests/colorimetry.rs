//! Lights and observers against those of the independent crate `colorimetry`, which has its own copy of
//! CIE's tables: 380 … 780 nm by 1 nm.

use colorimetry::illuminant::CieIlluminant::{self, *};
use colorimetry::observer::Observer as Theirs;
use colorimetry::traits::Light;
use glanz_color::{Observer, Spectrum, light, observer, xyz_of_light};

const SMOOTH: [(&str, CieIlluminant); 3] = [("A", A), ("D50", D50), ("D65", D65)];

const LEDS: [(&str, CieIlluminant); 9] = [
    ("LED-B1", LED_B1),
    ("LED-B2", LED_B2),
    ("LED-B3", LED_B3),
    ("LED-B4", LED_B4),
    ("LED-B5", LED_B5),
    ("LED-BH1", LED_BH1),
    ("LED-RGB1", LED_RGB1),
    ("LED-V1", LED_V1),
    ("LED-V2", LED_V2),
];

const FLUORESCENT: [(&str, CieIlluminant); 27] = [
    ("FL1", F1),
    ("FL2", F2),
    ("FL3", F3),
    ("FL4", F4),
    ("FL5", F5),
    ("FL6", F6),
    ("FL7", F7),
    ("FL8", F8),
    ("FL9", F9),
    ("FL10", F10),
    ("FL11", F11),
    ("FL12", F12),
    ("FL3.1", F3_1),
    ("FL3.2", F3_2),
    ("FL3.3", F3_3),
    ("FL3.4", F3_4),
    ("FL3.5", F3_5),
    ("FL3.6", F3_6),
    ("FL3.7", F3_7),
    ("FL3.8", F3_8),
    ("FL3.9", F3_9),
    ("FL3.10", F3_10),
    ("FL3.11", F3_11),
    ("FL3.12", F3_12),
    ("FL3.13", F3_13),
    ("FL3.14", F3_14),
    ("FL3.15", F3_15),
];

/// Their values at the grid's wavelengths from 380 nm; 0 below.
fn on_grid(theirs: &CieIlluminant) -> Spectrum {
    let spectrum = theirs.spectrum();
    Spectrum::from_fn(|nm| if nm < 380.0 { 0.0 } else { spectrum.as_array()[(nm - 380.0) as usize] })
}

/// The greatest difference at the grid's wavelengths from 380 nm that `counts`, after ours is scaled to
/// theirs by the middle ratio of all.
fn difference(name: &str, theirs: &CieIlluminant, counts: impl Fn(f64) -> bool) -> f64 {
    let (ours, theirs) = (light(name).expect("a light"), on_grid(theirs));
    let mut ratios: Vec<f64> =
        theirs.0.iter().zip(ours.0).map(|(b, a)| b / a).filter(|r| r.is_finite()).collect();
    ratios.sort_by(f64::total_cmp);
    let scale = ratios[ratios.len() / 2];
    let seen = ours.points().zip(theirs.0).filter(|((nm, _), _)| *nm >= 380.0 && counts(*nm));
    seen.map(|((_, a), b)| (a * scale - b).abs()).fold(0.0, f64::max)
}

#[test]
fn smooth_lights_are_the_same_at_every_wavelength() {
    for (name, theirs) in SMOOTH {
        // Their tables are of 100 at 560 nm, rounded to 0.001 or finer.
        let found = difference(name, &theirs, |_| true);
        assert!(found < 0.003, "{name}: {found}");
    }
}

#[test]
fn leds_are_the_same_to_the_digits_of_the_coarser_table() {
    for (name, theirs) in LEDS {
        let found = difference(name, &theirs, |_| true);
        assert!(found < 0.0125, "{name}: {found}");
    }
}

#[test]
fn fluorescent_lamps_are_the_same_away_from_the_lines_of_mercury() {
    // By 1 nm the lines are lines, by 5 nm they are shared by the samples beside them.
    let lines = [404.7, 435.8, 546.1, 578.0];
    for (name, theirs) in &FLUORESCENT[..9] {
        let found = difference(name, theirs, |nm| lines.iter().all(|line| (nm - line).abs() > 7.5));
        assert!(found < 1e-9, "{name}: {found}");
    }
}

#[test]
fn fluorescent_lamps_have_the_same_colour() {
    let mut worst = 0f64;
    for (name, theirs) in &FLUORESCENT {
        let [x, y, z] = xyz_of_light(&light(name).expect("a light"), &Observer::default());
        let theirs = Theirs::Cie1931.xyz_cie_table(theirs, None).chromaticity().to_array();
        let apart = (x / (x + y + z) - theirs[0]).abs().max((y / (x + y + z) - theirs[1]).abs());
        worst = worst.max(apart);
    }
    // Their tables by 1 nm are made so that sums are those by 5 nm.
    assert!(worst < 1e-9, "{worst}");
}

#[test]
fn observers_are_the_same_at_every_wavelength() {
    let pairs = [
        ("cie1931", Theirs::Cie1931),
        ("cie1964", Theirs::Cie1964),
        ("cie2015-2", Theirs::Cie2015),
        ("cie2015-10", Theirs::Cie2015_10),
    ];
    for (name, theirs) in pairs {
        let ours = observer(name).expect("an observer");
        for nm in (380..=780).step_by(5) {
            let xyz = theirs.xyz_at_wavelength(nm).expect("a wavelength that they have").to_array();
            let found: Vec<f64> = ours.channels.iter().map(|c| c.sensitivity.at(nm as f64)).collect();
            assert_eq!(found, xyz, "{name} at {nm} nm");
        }
    }
}
