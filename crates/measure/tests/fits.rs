//! Fits find what readings were made of.

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use glanz_measure::{Channels, Fit, FitError, FitLobe, FitOptions, Metric, Readings, fit, fit_lobes};

/// A lobe: model, parameter and its value, albedo.
type Lobe = (&'static str, &'static str, f64, f64);

fn shape((name, parameter, value, _): Lobe) -> Shape {
    match parameter {
        "" => Shape::named(name, &[]).expect("it is there"),
        parameter => Shape::named(name, &[(parameter, value)]).expect("it is in range"),
    }
}

/// Numbers of a normal distribution.
struct Noise(u64);

impl Noise {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (a, b) = (self.unit(), self.unit());
        (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }
}

/// All over the hemisphere, with 5 % of noise and a little everywhere.
fn readings(lobes: &[Lobe], channels: Channels) -> Readings {
    let shapes: Vec<(Shape, f64)> = lobes.iter().map(|lobe| (shape(*lobe), lobe.3)).collect();
    let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
    let (mut readings, count, mut noise) =
        (Readings::new(channels.clone()), channels.count(), Noise(88_172_645));
    for theta_i in [0.0, 15.0, 30.0, 45.0, 60.0, 75.0] {
        for theta_o in (0..84).step_by(3) {
            for phi in (0..360).step_by(10) {
                let (wi, wo) = (at(theta_i, 180.0), at(f64::from(theta_o), f64::from(phi)));
                let pair = DirectionPair::new(wo, wi);
                let f: f64 = shapes.iter().map(|(shape, tint)| tint * shape.f_cos(&pair) / wi.z).sum();
                // Channels are 1 to 1.3 times the first.
                let value = |c: usize| f * (1.0 + 0.3 * c as f64 / count as f64);
                let values: Vec<f32> = (0..count)
                    .map(|c| {
                        (value(c) * (1.0 + 0.05 * noise.normal()) + 2e-4 * noise.normal()).max(0.0) as f32
                    })
                    .collect();
                readings.push(wi, wo, &values);
            }
        }
    }
    readings
}

fn found(lobes: &[Lobe], channels: Channels, metric: Metric) -> Fit {
    let names: Vec<&str> = lobes.iter().map(|lobe| lobe.0).collect();
    let options = FitOptions { metric, ..FitOptions::default() };
    fit(&readings(lobes, channels), &names, &options).unwrap_or_else(|error| panic!("{lobes:?}: {error}"))
}

#[test]
fn widths_and_tints_are_found_again_in_noise() {
    for lobes in [
        [("ggx", "alpha", 0.1, 0.3), ("lambert", "", 0.0, 0.4)],
        [("ward", "alpha", 0.088, 0.15), ("lambert", "", 0.0, 0.5)],
        [("cook-torrance", "m", 0.3, 0.2), ("lambert", "", 0.0, 0.1)],
        [("phong-normalized", "shininess", 60.0, 0.4), ("lambert", "", 0.0, 0.2)],
    ] {
        for metric in [Metric::CubeRoot, Metric::Log, Metric::L2] {
            let fit = found(&lobes, Channels::Rgb, metric);
            let width = fit.lobes[0].shape.params()[0];
            let log_error = (width / lobes[0].2).ln();
            assert!(log_error.abs() < 0.02, "{lobes:?} {metric:?}: {width}");
            // The standard error tells about how far it is.
            let told = fit.lobes[0].parameters[0].log_error.expect("it is told");
            assert!(
                log_error.abs() < 5.0 * told && told < 0.02,
                "{lobes:?} {metric:?}: {log_error} ± {told}"
            );
            for (found, lobe) in fit.lobes.iter().zip(&lobes) {
                assert!(
                    (found.tint[0] / lobe.3 - 1.0).abs() < 0.04,
                    "{lobes:?} {metric:?}: {:?}",
                    found.tint
                );
                assert!((found.tint[2] / found.tint[0] - 1.2).abs() < 0.04, "{:?}", found.tint);
                assert!(found.parameters.iter().all(|parameter| !parameter.at_bound));
            }
        }
    }
}

#[test]
fn two_lobes_of_one_model_are_told_apart_in_any_number_of_channels() {
    let lobes = [("ggx", "alpha", 0.06, 0.05), ("ggx", "alpha", 0.25, 0.1), ("lambert", "", 0.0, 0.2)];
    for channels in
        [Channels::Luminance, Channels::Wavelengths((0..31).map(|i| 400.0 + 10.0 * f64::from(i)).collect())]
    {
        let fit = found(&lobes, channels, Metric::CubeRoot);
        let mut widths: Vec<f64> = fit.lobes[..2].iter().map(|lobe| lobe.shape.params()[0]).collect();
        widths.sort_by(f64::total_cmp);
        assert!((widths[0] / 0.06).ln().abs() < 0.05 && (widths[1] / 0.25).ln().abs() < 0.05, "{widths:?}");
    }
}

#[test]
fn a_lobe_that_is_not_there_has_no_tint() {
    let data = readings(&[("lambert", "", 0.0, 0.5)], Channels::Luminance);
    let fit = fit(&data, &["lambert"], &FitOptions::default()).unwrap();
    assert!((fit.lobes[0].tint[0] - 0.5).abs() < 0.005 && fit.relative < 0.03);
    // Negative tints are none.
    let less = fit_lobes(
        &readings(&[("ggx", "alpha", 0.2, 0.5)], Channels::Luminance),
        &["ggx", "lambert"].map(|name| FitLobe::named(name).unwrap()),
        &FitOptions::default(),
    )
    .unwrap();
    assert!(
        (less.lobes[0].shape.params()[0] / 0.2).ln().abs() < 0.01 && less.lobes[1].tint[0] < 2e-3,
        "{less:?}"
    );
}

#[test]
fn what_cannot_be_fitted_is_told() {
    let data = readings(&[("lambert", "", 0.0, 0.5)], Channels::Luminance);
    let fails = |models: &[&str], data: &Readings| fit(data, models, &FitOptions::default()).unwrap_err();
    assert!(matches!(fails(&["mirror"], &data), FitError::Model(_)));
    assert!(matches!(fails(&["no-such-model"], &data), FitError::Model(_)));
    assert!(matches!(fails(&[], &data), FitError::Model(_)));
    let mut few = Readings::new(Channels::Luminance);
    few.push(Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, 1.0), &[0.3]);
    assert!(matches!(fails(&["ggx"], &few), FitError::TooFew { readings: 1, .. }));
    let dark = readings(&[("lambert", "", 0.0, 0.0)], Channels::Luminance);
    let mut none = Readings::new(Channels::Luminance);
    (0..dark.len()).for_each(|i| none.push(dark.pair(i)[0], dark.pair(i)[1], &[0.0]));
    assert!(matches!(fails(&["lambert"], &none), FitError::Nothing(_)));
}
