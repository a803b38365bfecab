//! Numbers that a pencil or another program finds.

use proptest::prelude::*;

use super::samples::{HEIGHT, WIDTH, dot, edge, flat, greys, light, noise, pair, picture, ramp, sun};
use super::*;

fn measure(pair: &Pair, metric: Metric) -> Measurement {
    pair.measure(metric, &MetricOptions::default()).unwrap()
}

fn value(pair: &Pair, metric: Metric) -> f64 {
    measure(pair, metric).value
}

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found} is not {expected}");
}

/// Codes go through f32 twice: decoded by the reader, encoded by the metric.
const ROUND_TRIP: f64 = 1e-6;
/// Light in f32 moves a colour difference by its sixth digit.
const COLORS_IN_F32: f64 = 1e-4;

#[test]
fn the_error_of_two_codes_is_their_difference() {
    let pair = pair(greys(&[0.5, 0.25]), greys(&[0.5, 0.75]));
    let rmse = measure(&pair, Metric::Rmse);
    // One of two pixels is off by ½ in every channel: √(½·¼).
    near(rmse.value, 0.125_f64.sqrt(), ROUND_TRIP);
    near(f64::from(rmse.map[1]), 0.5, ROUND_TRIP);
    near(f64::from(rmse.map[0]), 0.0, 0.0);
    // 10 log₁₀ 8 decibels.
    near(value(&pair, Metric::Psnr), 9.030_899_869_919_436, 1e-5);
}

#[test]
fn the_error_of_one_channel_counts_a_third() {
    let black = picture((1, 1), [vec![0.0], vec![0.0], vec![0.0]], Scale::Light);
    let red = picture((1, 1), [vec![3.0], vec![0.0], vec![0.0]], Scale::Light);
    let pair = pair(black, red);
    // Light is not clipped: √(9/3), and the peak stays 1.
    near(value(&pair, Metric::Rmse), 3.0_f64.sqrt(), 1e-12);
    near(value(&pair, Metric::Psnr), -10.0 * 3.0_f64.log10(), 1e-12);
}

#[test]
fn black_and_white_are_a_hundred_apart() {
    let pair = pair(greys(&[0.0, 1.0]), greys(&[1.0, 1.0]));
    let found = measure(&pair, Metric::De2000);
    // L* 0 and 100: S_L is 1 in the middle, 50.
    near(f64::from(found.map[0]), 100.0, 1e-4);
    near(found.value, 50.0, 1e-4);
    near(found.spread.median, 50.0, 1e-4);
    near(found.spread.max, 100.0, 1e-4);
}

#[test]
fn ssim_of_two_greys_is_that_of_their_means() {
    let pair = pair(flat([0; 3]), flat([255; 3]));
    // No variance: (2·0·1 + C₁)/(0 + 1 + C₁) with C₁ = 1e-4.
    near(value(&pair, Metric::Ssim), 1e-4 / 1.0001, 1e-6);
    let single = samples::pair(greys(&[0.2]), greys(&[0.8]));
    near(value(&single, Metric::Ssim), (2.0 * 0.16 + 1e-4) / (0.04 + 0.64 + 1e-4), 1e-6);
}

#[test]
fn ssim_rmse_and_colour_difference_are_as_other_programs_say() {
    // scikit-image 0.26.0: structural_similarity(gaussian_weights=True, sigma=1.5, data_range=1,
    // use_sample_covariance=False) of 0.299 R + 0.587 G + 0.114 B, and its value at pixel 20, 15;
    // colour-science 0.4.7: delta_E, CIE 2000, with normalised_primary_matrix of sRGB; mean, 95th percentile.
    let cases = [
        (noise(0), noise(1), [0.002_952_440, -0.427_237_606], 0.423_317_727, [51.747_521, 89.902_543]),
        (ramp(0), ramp(1), [0.986_209_287, 0.999_468_946], 0.176_914_474, [18.434_933, 29.447_768]),
        (edge(0), edge(2), [0.742_961_428, 1.0], 0.090_564_748, [2.492_959, 2.492_959]),
        (flat([128; 3]), dot(), [0.929_182_416, 0.052_174_867], 0.014_377_154, [0.027_699, 0.0]),
        (ramp(0), edge(0), [0.373_411_726, 0.406_684_946], 0.251_864_727, [30.306_052, 50.254_381]),
    ];
    for (reference, test, [ssim, here], rmse, [mean, p95]) in cases {
        let pair = pair(reference, test);
        let found = measure(&pair, Metric::Ssim);
        near(found.value, ssim, 1e-5);
        near(1.0 - f64::from(found.map[15 * WIDTH + 20]), here, 1e-5);
        near(value(&pair, Metric::Rmse), rmse, ROUND_TRIP);
        let found = measure(&pair, Metric::De2000);
        near(found.value, mean, COLORS_IN_F32);
        near(found.spread.p95, p95, COLORS_IN_F32);
    }
}

#[test]
fn identical_pictures_have_no_error_at_all() {
    for picture in [noise(0), dot(), light(sun)] {
        let pair = pair(picture.clone(), picture);
        for metric in pair.metrics() {
            let found = measure(&pair, metric);
            let expected = match metric {
                Metric::Psnr => f64::INFINITY,
                Metric::Ssim => 1.0,
                _ => 0.0,
            };
            assert_eq!(found.value, expected, "{}", metric.name());
            assert_eq!(found.spread, Spread::default(), "{}", metric.name());
        }
    }
}

#[test]
fn every_metric_but_flip_of_light_is_symmetric() {
    for [a, b] in [[noise(0), noise(1)], [ramp(0), edge(0)]] {
        let (there, back) = (pair(a.clone(), b.clone()), pair(b, a));
        for metric in Metric::ALL {
            assert_eq!(measure(&there, metric).map, measure(&back, metric).map, "{}", metric.name());
        }
    }
}

#[test]
fn a_greater_change_is_a_greater_error() {
    let changed = |by: f32| pair(greys(&[0.5; 16]), greys(&[0.5, 0.5 + by].repeat(8)));
    for metric in Metric::ALL {
        let sign = if metric.grows_with_likeness() { -1.0 } else { 1.0 };
        let errors = [0.0, 0.01, 0.05, 0.2, 0.4].map(|by| sign * value(&changed(by), metric));
        assert!(errors.is_sorted_by(|a, b| a < b), "{}: {errors:?}", metric.name());
    }
}

#[test]
fn light_beside_codes_is_what_a_screen_shows() {
    let bright = light(|_, _, _| 7.0);
    let shown = pair(bright.clone(), flat([255; 3]));
    assert_eq!((shown.scale(), value(&shown, Metric::Rmse)), (Scale::Codes, 0.0));
    let both = pair(bright.clone(), light(|_, _, _| 1.0));
    assert_eq!((both.scale(), value(&both, Metric::Rmse)), (Scale::Light, 6.0));
    let as_shown = Pair::new(bright, light(|_, _, _| 1.0), true).unwrap();
    assert_eq!((as_shown.scale(), value(&as_shown, Metric::Rmse)), (Scale::Codes, 0.0));
}

#[test]
fn ssim_is_for_codes_only() {
    let pair = pair(light(sun), light(sun));
    assert!(pair.metrics().all(|metric| metric != Metric::Ssim));
    let error = pair.measure(Metric::Ssim, &MetricOptions::default()).unwrap_err();
    assert_eq!(error, CompareError::CodesOnly { metric: Metric::Ssim });
}

#[test]
fn pictures_that_do_not_fit_are_one_error() {
    let error = Pair::new(greys(&[0.1, 0.2]), dot(), false).unwrap_err();
    assert_eq!(error.to_string(), "expected two pictures of one size, found 2×1 and 40×30 pixels");
    let mut short = dot();
    short.rgb[1].pop();
    let error = Pair::new(dot(), short, false).unwrap_err();
    assert_eq!(error, CompareError::Values { expected: WIDTH * HEIGHT, found: WIDTH * HEIGHT - 1 });
    let none = picture((0, 0), Default::default(), Scale::Codes);
    assert!(Pair::new(none.clone(), none, false).is_err());
}

proptest! {
    #[test]
    fn any_light_has_finite_errors_within_bounds(
        values in prop::collection::vec(prop_oneof![-1e30_f32..1e30, -2.0_f32..2.0, Just(f32::MAX), Just(0.0)], 24),
    ) {
        let planes = |values: &[f32]| [0, 4, 8].map(|i: usize| values[i..i + 4].to_vec());
        let of = |values, scale| picture((2, 2), planes(values), scale);
        for scale in [Scale::Light, Scale::Codes] {
            let pair = Pair::new(of(&values[..12], scale), of(&values[12..], scale), false).unwrap();
            for metric in pair.metrics() {
                let found = measure(&pair, metric);
                prop_assert!(found.map.iter().all(|error| *error >= 0.0 || metric == Metric::Ssim), "{:?}", found);
                prop_assert!(!found.value.is_nan());
                let finite = scale == Scale::Codes || metric == Metric::Flip;
                prop_assert!(!finite || found.map.iter().all(|error| error.is_finite()), "{:?}", found);
                prop_assert!(metric != Metric::Flip || found.spread.max <= 1.0);
            }
        }
    }
}
