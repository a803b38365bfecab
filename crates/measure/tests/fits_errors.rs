//! Standard errors are as great as fits of other noise are apart.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use glanz_measure::{Channels, ErrorEstimate, FitOptions, Metric, Noise, Readings, fit};

/// How often noise is drawn anew: of so many the spread is known within 11 %.
const TIMES: u64 = 40;
/// How far spread and standard errors may be apart, as a factor.
const NEAR: f64 = 1.5;

/// A matte red with a highlight, all over the hemisphere: what it is at each pair of directions.
fn exact() -> Vec<([Vec3<f64>; 2], [f64; 3])> {
    let shape = |name, params: &[(&str, f64)]| Shape::named(name, params).unwrap();
    let (gloss, matte) = (shape("ggx", &[("alpha", 0.1)]), shape("lambert", &[]));
    let at =
        |theta: i32, phi: i32| Vec3::from_angles(f64::from(theta).to_radians(), f64::from(phi).to_radians());
    let lights = [15, 30, 45, 60].map(|theta| at(theta, 180));
    let detectors =
        || (0..84).step_by(4).flat_map(|theta| (0..360).step_by(15).map(move |phi| at(theta, phi)));
    let value = |[wi, wo]: [Vec3<f64>; 2]| {
        let pair = DirectionPair::new(wo, wi);
        let [gloss, matte] = [&gloss, &matte].map(|shape| shape.f_cos(&pair) / wi.z);
        [0.4, 0.1, 0.05].map(|tint| 0.3 * gloss + tint * matte)
    };
    let pairs = lights.iter().flat_map(|wi| detectors().map(|wo| [*wi, wo]));
    pairs.map(|pair| (pair, value(pair))).collect()
}

/// The spread of the logarithms of the width over fits to readings of other noise, the root of the mean square of the
/// standard errors that they tell, and how often these are sandwiches.
fn spread(metric: Metric, noise: &dyn Fn(f64, f64, &mut Noise) -> f64) -> ([f64; 2], u64) {
    let exact = exact();
    let options = FitOptions { metric, ..FitOptions::default() };
    let (mut widths, mut told, mut sandwiches) = (Vec::new(), 0.0, 0);
    for seed in 0..TIMES {
        let (mut readings, mut random) = (Readings::new(Channels::Rgb), Noise::new(seed + 1));
        for ([wi, wo], values) in &exact {
            readings.push(*wi, *wo, &values.map(|value| noise(value, wi.z, &mut random) as f32));
        }
        let found = fit(&readings, &["ggx", "lambert"], &options).unwrap();
        let width = &found.lobes[0].parameters[0];
        widths.push(width.value.ln());
        told += width.log_error.unwrap().powi(2) / TIMES as f64;
        sandwiches += u64::from(found.error_estimate == ErrorEstimate::Sandwich);
    }
    let mean = widths.iter().sum::<f64>() / TIMES as f64;
    let variance = widths.iter().map(|width| (width - mean).powi(2)).sum::<f64>() / (TIMES - 1) as f64;
    ([variance.sqrt(), told.sqrt()], sandwiches)
}

#[test]
fn of_noise_that_is_a_part_of_the_value_in_all_metrics_of_channels() {
    let noise = |value: f64, _: f64, random: &mut Noise| value * (1.0 + 0.05 * random.normal());
    for metric in [Metric::L2, Metric::Log, Metric::CubeRoot, Metric::Lightness] {
        let ([apart, told], sandwiches) = spread(metric, &noise);
        println!("{metric:?}: apart {apart}, told {told}, {sandwiches} sandwiches");
        assert!((apart / told).ln().abs() < NEAR.ln(), "{metric:?}: {apart} apart, {told} told");
        assert!(metric != Metric::L2 || sandwiches == TIMES, "{sandwiches}");
    }
}

#[test]
fn of_noise_that_channels_share() {
    let shared = std::cell::Cell::new((0, 0.0));
    // Three values in turn get one number.
    let noise = |value: f64, _: f64, random: &mut Noise| {
        let (count, last) = shared.get();
        let factor = if count % 3 == 0 { 1.0 + 0.05 * random.normal() } else { last };
        shared.set((count + 1, factor));
        value * factor
    };
    let ([apart, told], _) = spread(Metric::L2, &noise);
    println!("shared: apart {apart}, told {told}");
    assert!((apart / told).ln().abs() < NEAR.ln(), "{apart} apart, {told} told");
}

#[test]
fn of_noise_that_is_the_same_everywhere_the_profile_tells_them() {
    // Of f cos θi, which is what is fitted; no value comes near 0, below which readings are 0.
    let noise = |value: f64, cos_i: f64, random: &mut Noise| value + 0.002 * random.normal() / cos_i;
    let ([apart, told], sandwiches) = spread(Metric::L2, &noise);
    println!("even: apart {apart}, told {told}, {sandwiches} sandwiches");
    assert!((apart / told).ln().abs() < NEAR.ln(), "{apart} apart, {told} told");
    assert!(sandwiches <= 2, "{sandwiches}");
}
