//! Fits find what readings were made of.

use glanz_bsdf::models::lambert::Lambert;
use glanz_bsdf::{Angle, DirectionPair, LayerWeight, Model, ModelInfo, ParamInfo, Shape};
use glanz_math::Vec3;
use glanz_measure::{
    Channels, Fit, FitError, FitLobe, FitOptions, Metric, Noise, Readings, fit, fit_lobes, fit_observed,
};

/// A lobe: model, parameter and its value, albedo.
type Lobe = (&'static str, &'static str, f64, f64);

fn shape((name, parameter, value, _): Lobe) -> Shape {
    match parameter {
        "" => Shape::named(name, &[]).expect("it is there"),
        parameter => Shape::named(name, &[(parameter, value)]).expect("it is in range"),
    }
}

/// All over the hemisphere, with 5 % of noise and a little everywhere.
fn readings(lobes: &[Lobe], channels: Channels) -> Readings {
    let shapes: Vec<(Shape, f64)> = lobes.iter().map(|lobe| (shape(*lobe), lobe.3)).collect();
    let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
    let (mut readings, count, mut noise) =
        (Readings::new(channels.clone()), channels.count(), Noise::new(88_172_645));
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
        for metric in Metric::ALL {
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
fn more_lobes_are_no_worse_and_their_order_does_not_matter() {
    let truth = [
        (shape(("cook-torrance", "m", 0.08, 0.0)), 0.05, 0.4),
        (shape(("beckmann", "alpha", 0.5, 0.0)), 0.2, 0.2),
        (shape(("lambert", "", 0.0, 0.0)), 0.3, 0.3),
    ];
    let data = of_function(false, Channels::Luminance, &|pair| {
        let u5 = (1.0 - pair.cos_view_half()).powi(5);
        vec![truth.iter().map(|(shape, f0, f90)| (f0 + (f90 - f0) * u5) * shape.f_cos(pair)).sum()]
    });
    let error = |models: &[&str]| fit(&data, models, &FitOptions::default()).unwrap().error;
    let counts = [1, 2, 3].map(|n| error(&[&vec!["ggx"; n][..], &["lambert"]].concat()));
    assert!(counts[1] < 0.9 * counts[0] && counts[2] <= counts[1] * (1.0 + 1e-6), "{counts:?}");
    // The narrow lobe is the one with Fresnel tints, whichever stands first.
    let orders =
        [["ggx:schlick", "ggx", "lambert"], ["ggx", "ggx:schlick", "lambert"]].map(|models| error(&models));
    assert!((orders[0] / orders[1] - 1.0).abs() < 1e-6 && orders[0] < counts[1], "{orders:?} {counts:?}");
}

#[test]
fn standard_errors_are_told_beside_lobes_that_say_nothing() {
    let data = readings(&[("ggx", "alpha", 0.2, 0.3)], Channels::Luminance);
    let alone = fit(&data, &["ggx"], &FitOptions::default()).unwrap();
    let error = |fit: &Fit, lobe: usize| fit.lobes[lobe].parameters[0].log_error;
    assert!(error(&alone, 0).is_some_and(|error| error < 2e-3));
    // Of a Phong lobe that wide there is nothing, or next to nothing, to be seen.
    let wide = FitLobe::named("phong-normalized").unwrap().searching("shininess", [1.0, 1.5]).unwrap();
    let both = fit_lobes(&data, &[FitLobe::named("ggx").unwrap(), wide], &FitOptions::default()).unwrap();
    assert!(both.lobes[1].tint[0] < 5e-3, "{both:?}");
    let (told, expected) = (error(&both, 0).unwrap(), error(&alone, 0).unwrap());
    assert!(told < 3.0 * expected, "{told} for {expected}");
    assert_eq!(error(&both, 1), None, "{both:?}");
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

/// Readings of a function of f_cos, for light from all around if `turns`, with 3 % of noise.
fn of_function(turns: bool, channels: Channels, f_cos: &dyn Fn(&DirectionPair<f64>) -> Vec<f64>) -> Readings {
    let (mut readings, mut noise) = (Readings::new(channels), Noise::new(7_218_901));
    let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
    for theta_i in [10.0, 30.0, 50.0, 70.0] {
        for phi_i in (0..if turns { 360 } else { 1 }).step_by(30) {
            for theta_o in (0..79).step_by(6) {
                for phi in (0..360).step_by(15) {
                    let (wi, wo) = (at(theta_i, f64::from(phi_i)), at(f64::from(theta_o), f64::from(phi)));
                    let values = f_cos(&DirectionPair::new(wo, wi));
                    let noisy = |x: &f64| ((x / wi.z) * (1.0 + 0.03 * noise.normal())).max(0.0) as f32;
                    readings.push(wi, wo, &values.iter().map(noisy).collect::<Vec<_>>());
                }
            }
        }
    }
    readings
}

/// The median of the relative differences between a fit and readings, of which the noise is 3 %.
fn median_error(readings: &Readings, fit: &Fit) -> f64 {
    let mut all = Vec::new();
    for i in 0..readings.len() {
        let [wi, wo] = readings.pair(i);
        let pairs = fit.brdf(wi, wo).into_iter().zip(readings.values(i));
        all.extend(pairs.map(|(fitted, read)| (fitted / f64::from(*read) - 1.0).abs()));
    }
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

#[test]
fn tints_at_normal_and_at_grazing_incidence_are_found_apart() {
    let (gloss, matte) = (shape(("cook-torrance", "m", 0.25, 0.0)), shape(("lambert", "", 0.0, 0.0)));
    let layer = |at_zero, at_grazing| LayerWeight::Schlick { angle: Angle::Half, at_zero, at_grazing };
    // What is drawn for the two tints: the shape below a layer that goes from one to the other.
    let data = of_function(false, Channels::Rgb, &|pair| {
        let value =
            |f0: f64, rho: f64| gloss.f_cos(pair) * layer(f0, 0.8).factor(pair) + rho * matte.f_cos(pair);
        vec![value(0.04, 0.3), value(0.1, 0.2), value(0.4, 0.1)]
    });
    let found = fit(&data, &["cook-torrance:schlick", "lambert"], &FitOptions::default()).unwrap();
    let lobe = &found.lobes[0];
    assert!((lobe.parameters[0].value / 0.25).ln().abs() < 0.01, "{lobe:?}");
    let near = |found: &[f64], expected: [f64; 3]| {
        found.iter().zip(expected).all(|(found, expected)| (found / expected - 1.0).abs() < 0.05)
    };
    assert!(near(&lobe.tint, [0.04, 0.1, 0.4]), "{lobe:?}");
    assert!(near(lobe.tint_at_grazing.as_deref().unwrap(), [0.8; 3]), "{lobe:?}");
    assert!(near(&found.lobes[1].tint, [0.3, 0.2, 0.1]) && found.relative < 0.03, "{found:?}");
    assert!(median_error(&data, &found) < 0.03);
    // A tint without angles cannot say it.
    let plain = fit(&data, &["cook-torrance", "lambert"], &FitOptions::default()).unwrap();
    assert!(plain.error > 1.5 * found.error && plain.lobes[0].tint_at_grazing.is_none());
}

#[test]
fn two_widths_and_the_direction_of_the_grain_are_found() {
    for (model, narrow, wide, aniso_deg) in [
        ("ward", ("alpha", 0.08), ("alpha_y", 0.2), 35.0_f64),
        ("ggx", ("alpha", 0.15), ("alpha_y", 0.3), 160.0),
        ("ashikhmin-shirley", ("nu", 200.0), ("nv", 30.0), 80.0),
    ] {
        let gloss = Shape::named(model, &[narrow, wide]).unwrap();
        let (sin, cos) = aniso_deg.to_radians().sin_cos();
        let turn = |(x, y): (f64, f64)| (cos * x + sin * y, cos * y - sin * x);
        let data = of_function(true, Channels::Luminance, &|pair| {
            let (tangent_o, tangent_i) = (turn(pair.tangent_o), turn(pair.tangent_i));
            let turned = DirectionPair { tangent_o, tangent_i, ..*pair };
            vec![0.4 * gloss.f_cos(&turned) + 0.1 * pair.cos_i / std::f64::consts::PI]
        });
        let found = fit(&data, &[&format!("{model}:aniso"), "lambert"], &FitOptions::default()).unwrap();
        let lobe = &found.lobes[0];
        let widths = [lobe.parameters[0].value, lobe.parameters[1].value];
        assert_eq!([lobe.parameters[0].name, lobe.parameters[1].name], [narrow.0, wide.0]);
        // The x axis is that of the first width, whichever is greater.
        let is_swapped = (widths[0] / narrow.1).ln().abs() > (widths[0] / wide.1).ln().abs();
        let (widths, turn) = if is_swapped { ([widths[1], widths[0]], 90.0) } else { (widths, 0.0) };
        assert!((widths[0] / narrow.1).ln().abs() < 0.02, "{model}: {lobe:?}");
        assert!((widths[1] / wide.1).ln().abs() < 0.02, "{model}: {lobe:?}");
        let off = (found.aniso_deg.unwrap() + turn - aniso_deg + 90.0).rem_euclid(180.0) - 90.0;
        assert!(off.abs() < 0.5, "{model}: {off}° off");
        assert!(lobe.parameters.iter().all(|parameter| parameter.log_error.is_some_and(|x| x < 0.01)));
        let error = median_error(&data, &found);
        assert!(error < 0.03, "{model}: {error}");
    }
    let error = FitLobe::named("cook-torrance:aniso").unwrap_err();
    assert_eq!(error.to_string(), "cook-torrance has no second width");
}

#[test]
fn two_widths_are_tried_where_readings_may_show_them_and_kept_where_they_do() {
    // Brushed at 30°, matte paint beside it.
    let brushed = Shape::named("ggx", &[("alpha", 0.1), ("alpha_y", 0.3)]).unwrap();
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let turn = |(x, y): (f64, f64)| (cos * x + sin * y, cos * y - sin * x);
    let f_cos = |pair: &DirectionPair<f64>| {
        let (tangent_o, tangent_i) = (turn(pair.tangent_o), turn(pair.tangent_i));
        let turned = DirectionPair { tangent_o, tangent_i, ..*pair };
        vec![0.4 * brushed.f_cos(&turned) + 0.1 * pair.cos_i / std::f64::consts::PI]
    };
    let data = of_function(true, Channels::Luminance, &f_cos);
    let fitted = |data: &Readings, models: &[&str]| fit(data, models, &FitOptions::default()).unwrap();
    let found = fitted(&data, &["ggx", "lambert"]);
    let forced = fitted(&data, &["ggx:aniso", "lambert"]);
    let equal = fitted(&data, &["ggx:iso", "lambert"]);
    assert_eq!((&found.lobes, found.aniso_deg, found.error), (&forced.lobes, forced.aniso_deg, forced.error));
    assert_eq!((found.isotropic_error, forced.isotropic_error), (Some(equal.error), None));
    assert!(found.error < 0.5 * equal.error, "{} rather than {}", found.error, equal.error);
    // A model with one width stays as it is.
    let single = fitted(&data, &["cook-torrance", "lambert"]);
    assert_eq!((single.aniso_deg, single.isotropic_error), (None, None));

    // Of one azimuth of the light nothing is tried, and of many nothing found where there is none.
    let round = shape(("ggx", "alpha", 0.2, 0.0));
    let isotropic = |turns: bool, models: &[&str]| {
        let data = of_function(turns, Channels::Luminance, &|pair| vec![0.4 * round.f_cos(pair)]);
        fitted(&data, models)
    };
    for turns in [false, true] {
        assert_eq!(isotropic(turns, &["ggx"]), isotropic(turns, &["ggx:iso"]), "{turns}");
    }
    let error = FitLobe::named("ggx:iso:aniso").unwrap_err();
    assert_eq!(error.to_string(), "'ggx:iso:aniso': a lobe is either aniso or iso");
}

#[test]
fn progress_of_a_fit_rises_to_its_end() {
    let data = readings(&[("ggx", "alpha", 0.2, 0.3), ("lambert", "", 0.0, 0.3)], Channels::Luminance);
    let mut parts = Vec::new();
    let options = FitOptions::default();
    let found = fit_observed(&data, &["ggx", "diffuse"], &options, &mut |part| parts.push(part)).unwrap();
    assert_eq!(found, fit(&data, &["ggx", "diffuse"], &options).unwrap());
    assert!(
        parts.len() > 3 && parts.is_sorted() && parts[0] == 0.0 && parts.last() == Some(&1.0),
        "{parts:?}"
    );
}

#[test]
fn readings_count_as_their_weights_say() {
    let (good, bad) = (("ggx", "alpha", 0.2, 0.3), ("ggx", "alpha", 0.4, 0.3));
    let [right, wrong] = [good, bad].map(|lobe| readings(&[lobe], Channels::Luminance));
    let both = |weight: f32| {
        let mut all = Readings::new(Channels::Luminance);
        for i in 0..right.len() {
            all.push(right.pair(i)[0], right.pair(i)[1], right.values(i));
            all.push_weighted(wrong.pair(i)[0], wrong.pair(i)[1], wrong.values(i), weight);
        }
        fit(&all, &["ggx"], &FitOptions::default()).unwrap()
    };
    let (even, little, none) = (both(1.0), both(1e-3), both(0.0));
    let width = |fit: &Fit| fit.lobes[0].parameters[0].value;
    assert!(width(&even) > 0.22 && (width(&little) - 0.2).abs() < 2e-3, "{even:?} {little:?}");
    assert_eq!(none.readings * 2, even.readings);
    // Those that count nothing are as if they were not there.
    let alone = fit(&right, &["ggx"], &FitOptions::default()).unwrap();
    assert_eq!(none, alone);
}

/// The root of the mean of the squares of the metric's differences, by its definition.
fn error(readings: &Readings, fit: &Fit, metric: Metric) -> f64 {
    let g = |x: f64| match metric {
        Metric::L2 => x.max(0.0),
        Metric::Log => x.max(0.0).ln_1p(),
        Metric::CubeRoot => x.max(0.0).cbrt(),
        Metric::Lightness => match x.max(0.0) * std::f64::consts::PI {
            t if t > 216.0 / 24_389.0 => 1.16 * t.cbrt() - 0.16,
            t => 24_389.0 / 2700.0 * t,
        },
        Metric::Rendered => unreachable!("it is of all channels together"),
    };
    let (mut sum, mut weights) = (0.0, 0.0);
    for i in (0..readings.len()).filter(|i| readings.pair(*i)[1].z > 80_f64.to_radians().cos()) {
        let ([wi, wo], weight) = (readings.pair(i), f64::from(readings.weight(i)));
        for (fitted, read) in fit.brdf(wi, wo).into_iter().zip(readings.values(i)) {
            sum += weight * (g(fitted * wi.z) - g(f64::from(*read) * wi.z)).powi(2);
            weights += weight;
        }
    }
    (sum / weights).sqrt()
}

#[test]
fn no_fit_nearby_is_better() {
    let even = readings(&[("ward", "alpha", 0.2, 0.2), ("lambert", "", 0.0, 0.3)], Channels::Rgb);
    let mut data = Readings::new(Channels::Rgb);
    for i in 0..even.len() {
        data.push_weighted(even.pair(i)[0], even.pair(i)[1], even.values(i), [0.2, 1.0, 3.0][i % 3]);
    }
    for metric in Metric::ALL.into_iter().filter(|metric| *metric != Metric::Rendered) {
        let options = FitOptions { metric, ..FitOptions::default() };
        let found = fit(&data, &["ward:schlick", "lambert"], &options).unwrap();
        let least = error(&data, &found, metric);
        assert!((found.error / least - 1.0).abs() < 1e-6, "{metric:?}: {} for {least}", found.error);
        let is_worse = |what: &str, change: &dyn Fn(&mut Fit, f64)| {
            for part in [-2e-3, 2e-3] {
                let mut moved = found.clone();
                change(&mut moved, part);
                let moved = error(&data, &moved, metric);
                assert!(moved > least, "{metric:?}: {what} times 1 + {part}: {moved} for {least}");
            }
        };
        is_worse("alpha", &|fit, part| {
            let shape = &mut fit.lobes[0].shape;
            *shape = shape.with("alpha", shape.get("alpha").unwrap() * (1.0 + part)).unwrap();
        });
        for c in 0..3 {
            is_worse("F0", &|fit, part| fit.lobes[0].tint[c] *= 1.0 + part);
            is_worse("the matte tint", &|fit, part| fit.lobes[1].tint[c] *= 1.0 + part);
        }
    }
}

#[test]
fn a_model_of_ones_own_is_fitted_by_the_parameter_that_is_named() {
    static INFO: ModelInfo = ModelInfo {
        name: "velvet",
        params: &[ParamInfo { name: "edge", symbol: "e", doc: "", min: 0.0, max: 10.0, default: 1.0 }],
        ..Lambert::INFO
    };
    let velvet = |edge: f64| {
        let f_cos = |params: &[f64], pair: &DirectionPair<f64>| {
            (pair.cos_o * pair.cos_i).powf(params[0]) * pair.cos_i
        };
        Shape::from_function(&INFO, &[("edge", edge)], f_cos).unwrap()
    };
    let truth = velvet(2.5);
    let data = of_function(false, Channels::Luminance, &|pair| vec![0.7 * truth.f_cos(pair)]);
    let lobe = FitLobe::of(velvet(1.0)).unwrap();
    assert_eq!(lobe.parameters().count(), 0);
    let lobe = lobe.searching("edge", [0.1, 10.0]).unwrap();
    let found = fit_lobes(&data, &[lobe], &FitOptions::default()).unwrap();
    let parameter = &found.lobes[0].parameters[0];
    assert!(parameter.name == "edge" && (parameter.value / 2.5).ln().abs() < 0.01, "{found:?}");
    assert!((found.lobes[0].tint[0] / 0.7 - 1.0).abs() < 0.01, "{found:?}");
}

#[test]
fn the_diffuse_shape_is_chosen() {
    let (gloss, matte) = (("ggx", "alpha", 0.15, 0.1), ("oren-nayar", "sigma_deg", 40.0, 0.5));
    let found =
        fit(&readings(&[gloss, matte], Channels::Luminance), &["ggx", "diffuse"], &FitOptions::default());
    let lobe = &found.unwrap().lobes[1];
    assert_eq!(lobe.shape.info().name, "oren-nayar");
    assert!((lobe.parameters[0].value - 40.0).abs() < 2.0, "{lobe:?}");
    // Where Lambert's law says as much, it is taken: it has no parameter.
    let plain = readings(&[gloss, ("lambert", "", 0.0, 0.5)], Channels::Luminance);
    let found = fit(&plain, &["ggx", "diffuse"], &FitOptions::default()).unwrap();
    assert_eq!(found.lobes[1].shape.info().name, "lambert");
}

#[cfg(feature = "rayon")]
#[test]
fn fits_are_the_same_bits_for_any_number_of_threads() {
    let some = readings(&[("ward", "alpha", 0.15, 0.2), ("lambert", "", 0.0, 0.3)], Channels::Rgb);
    let mut many = Readings::new(Channels::Rgb);
    // More than are done by one thread.
    while many.len() < 80_000 {
        (0..some.len()).for_each(|i| many.push(some.pair(i)[0], some.pair(i)[1], some.values(i)));
    }
    for metric in [Metric::CubeRoot, Metric::Rendered] {
        let options = FitOptions { metric, most_readings: usize::MAX, ..FitOptions::default() };
        let with_threads = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| fit(&many, &["ward:schlick", "lambert"], &options).unwrap())
        };
        let (one, three) = (with_threads(1), with_threads(3));
        assert!(one.readings > 65_536);
        assert_eq!(one, three);
        assert_eq!(one.error.to_bits(), three.error.to_bits());
    }
}
