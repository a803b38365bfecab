//! Known values, round trips and refusals of the colour models.

use proptest::prelude::*;

use super::*;

/// One colour, sRGB 0.25, 0.5, 0.8, as colour-science 0.4.7 gives it (there with rounded sRGB matrices,
/// so XYZ is the start here).
const BLUE_XYZ: Xyz = Xyz([0.206_513_245_262, 0.207_494_813_884, 0.600_433_498_029]);

fn assert_near(found: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < tolerance, "{found:?} is not {expected:?} within {tolerance}");
    }
}

#[test]
fn the_cies_models_agree_with_colour_science() {
    assert_near(BLUE_XYZ.to::<XyY>().0, [0.203_573_329_4, 0.204_540_924_4, 0.207_494_813_9], 1e-10);
    assert_near(BLUE_XYZ.to::<Lab>().0, [52.674_220_415, 4.580_972_785, -45.592_703_391], 1e-9);
    assert_near(BLUE_XYZ.to::<Lch>().0, [52.674_220_415, 45.822_264_394, 275.737_595_023], 1e-9);
    assert_near(BLUE_XYZ.to::<Luv>().0, [52.674_220_415, -24.993_211_241, -70.941_520_220], 1e-8);
}

#[test]
fn the_cies_models_are_for_any_white() {
    // colour-science 0.4.7, XYZ_to_Lab and XYZ_to_Luv of 0.20654008, 0.12197225, 0.05136952 for xy 0.34570, 0.35850 (D50)
    // and 0.44757, 0.40745 (A).
    let xyz = Xyz([0.206_540_08, 0.121_972_25, 0.051_369_52]);
    let white = |x: f64, y: f64| Xyz([x / y, 1.0, (1.0 - x - y) / y]);
    let (d50, a) = (white(0.345_70, 0.358_50), white(0.447_57, 0.407_45));
    let luv_d50 = [41.527_875_294, 90.709_259_615, 7.084_552_734];
    assert_near(Lab::for_white(xyz, d50).0, [41.527_875_294, 51.193_541_738, 19.918_430_978], 1e-8);
    assert_near(Luv::for_white(xyz, d50).0, luv_d50, 1e-8);
    assert_near(Lab::for_white(xyz, a).0, [41.527_875_294, 38.480_893_046, -5.732_951_225], 1e-8);
    assert_near(Luv::for_white(xyz, a).0, [41.527_875_294, 65.451_809_401, -12.466_269_771], 1e-8);
    // On any scale of both.
    let [xyz_100, d50_100] = [xyz, d50].map(|Xyz(xyz)| Xyz(xyz.map(|v| 100.0 * v)));
    assert_near(Luv::for_white(xyz_100, d50_100).0, luv_d50, 1e-8);
}

#[test]
fn rgb_spaces_agree_with_colour_science() {
    // Its matrices are the rounded ones of the standards.
    const ROUNDED: f64 = 2e-4;
    assert_near(BLUE_XYZ.to::<Srgb>().0, [0.25, 0.5, 0.8], ROUNDED);
    assert_near(BLUE_XYZ.to::<LinearSrgb>().0, [0.050_889_7, 0.214_046_1, 0.603_832_1], ROUNDED);
    assert_near(BLUE_XYZ.to::<DisplayP3>().0, [0.313_077_4, 0.494_108_2, 0.777_348_0], ROUNDED);
    assert_near(BLUE_XYZ.to::<Rec2020>().0, [0.337_644_9, 0.442_219_4, 0.747_906_1], ROUNDED);
    assert_near(BLUE_XYZ.to::<AdobeRgb>().0, [0.346_795_2, 0.496_110_0, 0.785_331_8], ROUNDED);
    assert_near(BLUE_XYZ.to::<AcesCg>().0, [0.132_500_4, 0.207_836_1, 0.549_701_1], ROUNDED);
}

#[test]
fn oklab_agrees_with_the_first_published_digits_to_the_correction_of_its_white() {
    const CORRECTION: f64 = 1e-4;
    assert_near(BLUE_XYZ.to::<Oklab>().0, [0.592_810_8, -0.036_059_1, -0.129_810_7], CORRECTION);
    assert_near(Xyz::WHITE.to::<Oklab>().0, [1.0, 0.0, 0.0], 1e-7);
}

#[test]
fn device_models_agree_with_colour_science() {
    let blue = Srgb([0.25, 0.5, 0.8]);
    assert_near(blue.to::<Cmy>().0, [0.75, 0.5, 0.2], 1e-12);
    assert_near(blue.to::<Hls>().0, [0.590_909_090_909 * 360.0, 0.525, 0.578_947_368_421], 1e-9);
    assert_near(blue.to::<Hsv>().0, [0.590_909_090_909 * 360.0, 0.6875, 0.8], 1e-9);
    let [c, m, y, k] = blue.to::<Cmyk>().0;
    assert_near([c, m, y], [0.6875, 0.375, 0.0], 1e-12);
    assert!((k - 0.2).abs() < 1e-12);
}

#[test]
fn models_of_the_eye_are_their_matrices() {
    assert_near(BLUE_XYZ.to::<Lms>().0, [0.180_957_160_6, 0.222_503_720_0, 0.551_330_046_6], 1e-9);
    assert_near(BLUE_XYZ.to::<Ac1c2>().0, [0.210_090_147_3, 0.099_798_389_7, 0.313_822_981_5], 1e-9);
    let [a, red_green, yellow_blue] = BLUE_XYZ.to::<Opponent>().0;
    let (Lms(cones), Lms(white)) = (BLUE_XYZ.to(), Xyz::WHITE.to());
    let [l, m, s] = core::array::from_fn(|i| cones[i] / white[i]);
    assert_near([a, red_green, yellow_blue], [BLUE_XYZ.0[1], l - m, (l + m) / 2.0 - s], 1e-12);
}

#[test]
fn white_has_no_colour_in_any_model() {
    assert_near(Xyz::WHITE.to::<Lab>().0, [100.0, 0.0, 0.0], 1e-12);
    assert_near(Xyz::WHITE.to::<Luv>().0, [100.0, 0.0, 0.0], 1e-12);
    assert_near(Xyz::WHITE.to::<Srgb>().0, [1.0; 3], 1e-12);
    assert_near(Xyz::WHITE.to::<AcesCg>().0, [1.0; 3], 1e-12);
    // The matrix of the cones has five digits.
    assert_near(Xyz::WHITE.to::<Lms>().0, [1.0; 3], 1e-5);
    assert_near(Xyz::WHITE.to::<Opponent>().0, [1.0, 0.0, 0.0], 1e-15);
}

#[test]
fn greys_have_neither_hue_nor_saturation() {
    // 1 − max is rounding at white, and saturation is a quotient of two such numbers there.
    for code in [0.0, 1e-3, 0.5, 0.9999, 1.0] {
        let (Hls([h, l, s]), grey) = (Srgb([code; 3]).to(), Srgb([code; 3]));
        assert_eq!((h, s), (0.0, 0.0), "{code}");
        assert!((l - code).abs() < 1e-12);
        let Hsv([h, s, _]) = grey.to();
        assert_eq!((h, s), (0.0, 0.0), "{code}");
    }
}

#[test]
fn primaries_stand_a_third_of_the_circle_apart_on_the_double_cone() {
    for (rgb, hue) in [([1.0, 0.0, 0.0], 0.0), ([0.0, 1.0, 0.0], 120.0), ([0.0, 0.0, 1.0], 240.0)] {
        let Hls([h, l, s]) = Srgb(rgb).to();
        assert_near([libm::remainder(h - hue, 360.0), l, s], [0.0, 0.5, 1.0], 1e-6);
    }
}

#[test]
fn black_has_finite_numbers_in_every_model() {
    for model in Model::ALL {
        let numbers = model.from_xyz(Xyz([0.0; 3]));
        assert!(numbers.iter().all(|n| n.is_finite()), "{model}: {numbers:?}");
        assert_near(model.to_xyz(numbers).0, [0.0; 3], 1e-9);
    }
}

#[test]
fn saturation_is_at_most_1_next_to_white() {
    let Hls([_, _, saturation]) = Srgb([0.9999417780965207, 1.0651656808672754, 2.1187071310667087]).to();
    assert_eq!(saturation, 1.0);
}

/// What rounding and the branches of sRGB (which miss each other by 3e-8) may lose; OKLab's inverse in
/// palette is given to nine digits.
const ROUND_TRIP: f64 = 1e-6;

proptest! {
    #[test]
    fn a_colour_for_a_white_is_found_again_and_for_d65_it_is_the_models(
        rgb in prop::array::uniform3(0.0..1.0_f64),
        white in prop::array::uniform3(0.3..100.0_f64),
    ) {
        let (xyz, white) = (Srgb(rgb).to_xyz(), Xyz(white));
        for Xyz(found) in [
            Lab::for_white(xyz, white).xyz_for_white(white),
            Luv::for_white(xyz, white).xyz_for_white(white),
        ] {
            for (a, b) in found.iter().zip(xyz.0) {
                prop_assert!((a - b).abs() < 1e-9, "{found:?} is not {xyz:?}");
            }
        }
        let (lab, luv) = (Lab::for_white(xyz, Xyz::WHITE).0, Luv::for_white(xyz, Xyz::WHITE).0);
        for (a, b) in lab.into_iter().chain(luv).zip(xyz.to::<Lab>().0.into_iter().chain(xyz.to::<Luv>().0)) {
            prop_assert!((a - b).abs() < 1e-9, "{lab:?} {luv:?}");
        }
    }

    #[test]
    fn every_model_gives_back_the_colours_of_the_cube(rgb in prop::array::uniform3(0.0..1.0_f64)) {
        let Xyz(expected) = Srgb(rgb).to_xyz();
        for model in Model::ALL {
            let Xyz(found) = model.to_xyz(model.from_xyz(Xyz(expected)));
            for (a, b) in found.iter().zip(expected) {
                prop_assert!((a - b).abs() < ROUND_TRIP, "{model}: {found:?} is not {expected:?}");
            }
        }
    }

    #[test]
    fn models_without_a_gamut_give_back_colours_outside_of_it(expected in prop::array::uniform3(1e-3..4.0_f64)) {
        for model in Model::ALL.iter().filter(|model| !model.info().srgb_only) {
            let Xyz(found) = model.to_xyz(model.from_xyz(Xyz(expected)));
            for (a, b) in found.iter().zip(expected) {
                prop_assert!((a - b).abs() < 4.0 * ROUND_TRIP, "{model}: {found:?} is not {expected:?}");
            }
        }
    }

    #[test]
    fn colours_outside_of_the_cube_become_colours_of_it(rgb in prop::array::uniform3(-1.0..4.0_f64)) {
        for model in Model::ALL.iter().filter(|model| model.info().srgb_only) {
            let numbers = model.from_xyz(Srgb(rgb).to_xyz());
            for (channel, value) in model.info().channels.iter().zip(numbers) {
                let [low, high] = channel.range;
                prop_assert!((low - 1e-12..=high + 1e-12).contains(&value), "{model}: {numbers:?}");
            }
            let Srgb(found) = model.to_xyz(numbers).to();
            for (a, b) in found.iter().zip(rgb) {
                prop_assert!((a - b.clamp(0.0, 1.0)).abs() < ROUND_TRIP, "{model}: {rgb:?} became {found:?}");
            }
        }
    }

    #[test]
    fn any_numbers_convert_or_are_refused(values in prop::array::uniform4(prop::num::f64::ANY)) {
        for from in Model::ALL {
            for to in Model::ALL {
                let values = &values[..from.info().channels.len()];
                if let Ok(numbers) = convert(from.info().name, to.info().name, values) {
                    prop_assert!(numbers.iter().all(|n| n.is_finite()), "{from} {values:?} to {to}");
                }
            }
        }
    }
}

#[test]
fn colours_convert_by_name() {
    let expected = Hls([210.0, 0.4, 0.8]).to::<Ac1c2>().0;
    assert_eq!(convert("hls", "AC1C2", &[210.0, 0.4, 0.8]).unwrap(), expected);
    // A hue goes round the circle.
    let round = convert("hls", "ac1c2", &[-150.0, 0.4, 0.8]).unwrap();
    assert_near([round[0], round[1], round[2]], expected, 1e-12);
}

#[test]
fn an_unknown_model_is_refused_with_a_suggestion() {
    let error = convert("oponent", "xyz", &[0.0; 3]).unwrap_err();
    assert!(error.to_string().contains("did you mean 'opponent'?"), "{error}");
    let error = convert("q", "xyz", &[0.0; 3]).unwrap_err();
    assert!(matches!(&error, ConvertError::UnknownModel { near, .. } if near.is_empty()), "{error}");
}

#[test]
fn wrong_numbers_are_refused_with_the_channel() {
    let error = convert("cmyk", "xyz", &[0.0; 3]).unwrap_err();
    assert_eq!(error.to_string(), "colour model `cmyk` has 4 channels (C, M, Y, K), found 3 numbers");
    let error = convert("hls", "xyz", &[0.0, 1.5, 0.0]).unwrap_err();
    assert_eq!(error.to_string(), "channel L of `hls` goes from 0 to 1, found 1.5");
    assert!(convert("xyz", "lab", &[f64::NAN, 0.0, 0.0]).is_err());
    assert!(matches!(convert("xyy", "lab", &[0.3, 0.0, 1.0]), Err(ConvertError::NotFinite { .. })));
}

#[test]
fn a_colour_that_a_model_cannot_hold_is_refused() {
    let error = convert("display-p3", "hsv", &[0.0, 1.0, 0.0]).unwrap_err();
    assert!(matches!(error, ConvertError::OutOfGamut { srgb: [r, ..], .. } if r < -0.4), "{error}");
    assert!(convert("display-p3", "srgb", &[0.0, 1.0, 0.0]).is_ok());
}
