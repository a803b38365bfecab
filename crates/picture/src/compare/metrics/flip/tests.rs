//! Against the authors' own program: the PyPI package flip-evaluator 1.7, in f32. The numbers are those of
//! its `evaluate(reference, test, "LDR" or "HDR", applyMagma=False, parameters={"ppd": …})` for the pictures
//! of [`crate::compare::samples`].

use super::*;
use crate::compare::samples::{HEIGHT, WIDTH, codes, dot, edge, flat, light, noise, pair, ramp, sun};
use crate::compare::{CompareError, Metric, MetricOptions, Pair, Picture};

/// How far the program may be off: it works in f32 and with a matrix of colours that is rounded to five
/// digits; edges below its rounding are taken to the power ½ (it gives two values for black against white
/// that differ by 7e-6).
const PROGRAM: f64 = 3e-5;
/// The same for pictures of light, where an exposure in f32 comes first.
const PROGRAM_LIGHT: f64 = 1e-5;

/// Mean, and values at the pixels below.
type Expected = (f64, [f64; 4]);
const PLACES: [(usize, usize); 4] = [(0, 0), (20, 15), (39, 29), (18, 7)];

fn check(name: &str, map: &[f32], (mean, values): Expected, places: [(usize, usize); 4], within: f64) {
    let found: f64 = map.iter().copied().map(f64::from).sum::<f64>() / map.len() as f64;
    assert!((found - mean).abs() < within, "{name}: mean {found}, not {mean}");
    for ((x, y), expected) in places.into_iter().zip(values) {
        let found = f64::from(map[y * WIDTH + x]);
        assert!((found - expected).abs() < within, "{name} at {x}, {y}: {found}, not {expected}");
    }
}

#[test]
fn codes_differ_as_the_authors_program_says() {
    let pictures: [(&str, Picture, Picture, [Expected; 2]); 6] = [
        (
            "noise",
            noise(0),
            noise(1),
            [
                (0.478_038_2, [0.676_782_3, 0.435_725_6, 0.714_111_6, 0.850_152_7]),
                (0.747_872_3, [0.762_136_3, 0.967_952_5, 0.964_614_5, 0.979_663_4]),
            ],
        ),
        (
            "ramp",
            ramp(0),
            ramp(1),
            [
                (0.390_499_0, [0.111_476_6, 0.397_536_3, 0.897_341_8, 0.370_197_3]),
                (0.399_955_8, [0.096_285_7, 0.390_257_1, 0.957_368_9, 0.362_989_6]),
            ],
        ),
        (
            "edge",
            edge(0),
            edge(2),
            [
                (0.120_760_7, [0.0, 0.034_700_8, 0.0, 0.334_174_9]),
                (0.094_361_2, [0.0, 0.0, 0.0, 0.263_690_7]),
            ],
        ),
        (
            "dot",
            flat([128; 3]),
            dot(),
            [(0.003_584_9, [0.0, 0.378_817_2, 0.0, 0.0]), (0.002_093_9, [0.0, 0.820_974_6, 0.0, 0.0])],
        ),
        (
            "black and white",
            flat([0; 3]),
            flat([255; 3]),
            [(0.967_397_0, [0.967_391_8; 4]), (0.967_396_3, [0.967_384_4; 4])],
        ),
        (
            "ramp and edge",
            ramp(0),
            edge(0),
            [
                (0.743_326_4, [0.701_377_5, 0.735_063_4, 0.968_228_5, 0.764_374_9]),
                (0.731_419_9, [0.700_676_6, 0.698_893_0, 0.964_167_9, 0.789_666_0]),
            ],
        ),
    ];
    for (name, reference, test, expected) in pictures {
        let pair = pair(reference, test);
        for (ppd, expected) in [67.0, 30.0].into_iter().zip(expected) {
            let (map, exposures) = map(&pair, ppd).unwrap();
            assert_eq!(exposures, None);
            check(&format!("{name} at {ppd}"), &map, expected, PLACES, PROGRAM);
        }
    }
}

#[test]
fn light_differs_as_the_authors_program_says() {
    let brighter = light(|x, y, c| sun(x, y, c) * if y > 14 { 1.125 } else { 1.0 });
    let spark = light(|x, y, c| sun(x, y, c) + if (x, y) == (5, 20) { 4.0 } else { 0.0 });
    let cases: [(&str, Picture, Expected); 2] = [
        ("brighter", brighter, (0.078_269_1, [0.0, 0.136_361_1, 0.173_433_0, 0.124_383_3])),
        ("spark", spark, (0.011_151_7, [0.0, 0.0, 0.0, 0.804_408_0])),
    ];
    for (name, test, expected) in cases {
        let (map, exposures) = map(&pair(light(sun), test), DEFAULT_PPD).unwrap();
        let exposures = exposures.unwrap();
        assert_eq!(exposures.count, 8);
        assert!((exposures.start + 4.770_568_8).abs() < 1e-5, "{exposures:?}");
        assert!((exposures.stop - 2.686_726_6).abs() < 1e-5, "{exposures:?}");
        check(name, &map, expected, [(0, 0), (20, 15), (39, 29), (5, 20)], PROGRAM_LIGHT);
    }
}

#[test]
fn a_sky_without_light_has_no_exposures_without_end() {
    let lamp = light(|x, y, _| if (x, y) == (3, 4) { 0.5 } else { 0.0 });
    let exposures = Exposures::for_pair(&lamp.rgb, &lamp.rgb).unwrap();
    // The program's own ends for a picture that is black but for light of 0.5.
    assert!((exposures.start - 2.083_297_3).abs() < 1e-5 && (exposures.stop - 24.083_297_7).abs() < 1e-5);
    assert_eq!(exposures.stops().count(), 22);
    let last = exposures.stops().last().unwrap();
    assert!((last - exposures.stop).abs() < 1e-12, "{last}");
}

#[test]
fn light_of_one_luminance_has_one_exposure_and_none_has_none() {
    let (black, grey) = (light(|_, _, _| 0.0), light(|_, _, _| 0.25));
    let exposures = Exposures::for_pair(&grey.rgb, &black.rgb).unwrap();
    assert_eq!((exposures.count, exposures.start), (1, exposures.stop));
    assert_eq!(Exposures::for_pair(&black.rgb, &grey.rgb), Some(exposures));
    let (dark, none) = map(&pair(black.clone(), black.clone()), DEFAULT_PPD).unwrap();
    assert!(none.is_none() && dark.iter().all(|error| *error == 0.0));
    let (found, _) = map(&pair(black, grey), DEFAULT_PPD).unwrap();
    assert!(found.iter().all(|error| *error > 0.5));
}

/// Mean ꟻLIP.
fn mean(pair: &Pair) -> f64 {
    pair.measure(Metric::Flip, &MetricOptions::default()).unwrap().value
}

#[test]
fn identical_pictures_do_not_differ() {
    for picture in [noise(0), ramp(1), light(sun)] {
        let (map, _) = map(&pair(picture.clone(), picture), DEFAULT_PPD).unwrap();
        assert!(map.iter().all(|error| *error == 0.0));
    }
}

#[test]
fn codes_differ_the_same_in_both_directions() {
    for [a, b] in [[noise(0), noise(1)], [ramp(0), edge(0)]] {
        assert_eq!(map(&pair(a.clone(), b.clone()), 50.0), map(&pair(b, a), 50.0));
    }
}

#[test]
fn green_and_blue_are_as_far_apart_as_can_be() {
    let (map, _) = map(&pair(flat([0, 255, 0]), flat([0, 0, 255])), DEFAULT_PPD).unwrap();
    assert!(map.iter().all(|error| (1.0 - error).abs() < 1e-5), "{}", map[0]);
}

#[test]
fn a_greater_change_is_a_greater_error() {
    let changed = |by: i64| {
        mean(&pair(
            edge(0),
            codes(|x, y, c| {
                (40 + c * 30 + by) * i64::from(x + y / 2 < 18) + (200 - c * 50) * i64::from(x + y / 2 >= 18)
            }),
        ))
    };
    let errors = [0, 1, 4, 16, 64].map(changed);
    assert!(errors[0] == 0.0 && errors.is_sorted_by(|a, b| a < b), "{errors:?}");
}

#[test]
fn small_change_from_afar_is_not_seen() {
    let checkers = codes(|x, y, _| if (x + y) % 2 == 0 { 188 } else { 0 });
    let pair = pair(checkers, flat([137; 3]));
    let at =
        |ppd| pair.measure(Metric::Flip, &MetricOptions { ppd, ..MetricOptions::default() }).unwrap().value;
    assert!(at(20.0) > 2.0 * at(120.0), "{} {}", at(20.0), at(120.0));
}

#[test]
fn pixels_per_degree_have_bounds() {
    let pair = pair(dot(), dot());
    for ppd in [0.0, -1.0, 1001.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(map(&pair, ppd), Err(CompareError::PixelsPerDegree { .. })), "{ppd}");
    }
    for ppd in [1.0, 1000.0] {
        assert_eq!(map(&pair, ppd).unwrap().0, vec![0.0; WIDTH * HEIGHT]);
    }
}
