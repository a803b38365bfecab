//! Fits by differences of colour.

use glanz_bsdf::{DirectionPair, Shape};
use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, D65_XYZ, Lab, LinearSrgb, Xyz};
use glanz_math::Vec3;
use glanz_measure::{Channels, Fit, FitOptions, Metric, Noise, Readings, fit};

const MOST_THETA_DEG: f64 = 80.0;

/// A red satin that no single lobe of the list is: two highlights, of which the wider is red, and 2 % of noise.
fn satin(channels: &Channels) -> Readings {
    let shape = |name: &str, params: &[(&str, f64)]| Shape::named(name, params).expect("it is in range");
    let lobes = [
        (shape("ggx", &[("alpha", 0.12)]), [0.05, 0.05, 0.05]),
        (shape("ggx", &[("alpha", 0.4)]), [0.2, 0.04, 0.03]),
        (shape("oren-nayar", &[("sigma_deg", 30.0)]), [0.3, 0.05, 0.08]),
    ];
    let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
    let (mut readings, mut noise) = (Readings::new(channels.clone()), Noise::new(5));
    for theta_i in [0.0, 20.0, 40.0, 60.0] {
        for theta_o in (0..79).step_by(3) {
            for phi in (0..360).step_by(15) {
                let (wi, wo) = (at(theta_i, 180.0), at(f64::from(theta_o), f64::from(phi)));
                let pair = DirectionPair::new(wo, wi);
                let mut rgb = [0.0; 3];
                for (shape, tint) in &lobes {
                    let value = shape.f_cos(&pair) / wi.z;
                    rgb.iter_mut().zip(tint).for_each(|(sum, tint)| *sum += value * tint);
                }
                let noisy = rgb.map(|value| value * (1.0 + 0.02 * noise.normal()));
                let values: &[f64] = if *channels == Channels::Rgb { &noisy } else { &noisy[..1] };
                readings.push(wi, wo, &values.iter().map(|value| *value as f32).collect::<Vec<_>>());
            }
        }
    }
    readings
}

/// ΔE00 of each reading, by its definition: f cosθi of linear sRGB, or of a grey, white being 1/π.
fn differences(readings: &Readings, fit: &Fit) -> Vec<f64> {
    let lab = |values: Vec<f64>, cos_i: f64| {
        let seen: Vec<f64> = values.iter().map(|value| value * cos_i * std::f64::consts::PI).collect();
        let xyz = match seen[..] {
            [r, g, b] => LinearSrgb([r, g, b]).to_xyz().0,
            [y] => D65_XYZ.map(|white| white * y),
            _ => panic!("one or three channels"),
        };
        Lab::for_white(Xyz(xyz.map(|value| value.max(0.0))), Xyz(D65_XYZ))
    };
    let counts = |i: &usize| readings.pair(*i)[1].z > MOST_THETA_DEG.to_radians().cos();
    let of = |i: usize| {
        let [wi, wo] = readings.pair(i);
        let read = readings.values(i).iter().map(|value| f64::from(*value)).collect();
        ciede2000(lab(read, wi.z), lab(fit.brdf(wi, wo), wi.z))
    };
    (0..readings.len()).filter(counts).map(of).collect()
}

fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

fn fitted(readings: &Readings, metric: Metric) -> Fit {
    let options = FitOptions { metric, most_theta_deg: MOST_THETA_DEG, ..FitOptions::default() };
    fit(readings, &["ggx:schlick", "lambert"], &options).expect("there are enough readings")
}

#[test]
fn rendered_fits_look_more_alike_than_those_of_other_metrics() {
    for channels in [Channels::Rgb, Channels::Luminance] {
        let readings = satin(&channels);
        let error = |metric: Metric| {
            let found = fitted(&readings, metric);
            let all = differences(&readings, &found);
            for (own, exact) in found.delta_e(&readings, &FitOptions::default()).iter().zip(&all) {
                assert!((own - exact).abs() < 1e-6, "{own} for {exact}");
            }
            root_mean_square(&all)
        };
        let found = fitted(&readings, Metric::Rendered);
        let own = error(Metric::Rendered);
        assert!((found.error / own - 1.0).abs() < 1e-6, "{} for {own}", found.error);
        for metric in Metric::ALL.into_iter().filter(|metric| *metric != Metric::Rendered) {
            let other = error(metric);
            println!("{channels}, {metric:?}: {other}; rendered {own}");
            assert!(own < other, "{channels}, {metric:?}: {own} for {other}");
        }
    }
}

#[test]
fn no_rendered_fit_nearby_is_better() {
    // So far that the curvature of the sum of squares shows, and not its rounding.
    const PARTS: [f64; 2] = [-2e-3, 2e-3];
    for channels in [Channels::Rgb, Channels::Luminance] {
        let readings = satin(&channels);
        let found = fitted(&readings, Metric::Rendered);
        let least = root_mean_square(&differences(&readings, &found));
        let is_worse = |what: &str, change: &dyn Fn(&mut Fit, f64)| {
            for part in PARTS {
                let mut moved = found.clone();
                change(&mut moved, part);
                let moved = root_mean_square(&differences(&readings, &moved));
                assert!(moved > least, "{channels}: {what} times 1 + {part}: {moved} for {least}");
            }
        };
        is_worse("alpha", &|fit, part| {
            let shape = &mut fit.lobes[0].shape;
            *shape = shape.with("alpha", shape.get("alpha").unwrap() * (1.0 + part)).unwrap();
        });
        for c in 0..channels.count() {
            is_worse("F0", &|fit, part| fit.lobes[0].tint[c] *= 1.0 + part);
            is_worse("the matte tint", &|fit, part| fit.lobes[1].tint[c] *= 1.0 + part);
        }
        let told = found.lobes[0].parameters[0].log_error.expect("it is told");
        assert!(told > 1e-4 && told < 0.05, "{told}");
    }
}

#[test]
fn spectra_of_rendered_fits_have_the_colours_that_were_read() {
    // A yellow, without noise: its spectrum comes back, though many others have its colour.
    let nm: Vec<f64> = (0..31).map(|i| 400.0 + 10.0 * f64::from(i)).collect();
    let yellow: Vec<f64> = nm.iter().map(|nm| 0.05 + 0.6 / (1.0 + ((520.0 - nm) / 15.0).exp())).collect();
    let gloss = Shape::named("ggx", &[("alpha", 0.2)]).unwrap();
    let mut readings = Readings::new(Channels::Wavelengths(nm));
    for theta_i in [10.0_f64, 40.0, 65.0] {
        for theta_o in -75..=75 {
            let wi = Vec3::from_angles(theta_i.to_radians(), std::f64::consts::PI);
            let wo = Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0);
            let highlight = 0.06 * gloss.f_cos(&DirectionPair::new(wo, wi)) / wi.z;
            let value = |rho: &f64| (highlight + rho / std::f64::consts::PI) as f32;
            readings.push(wi, wo, &yellow.iter().map(value).collect::<Vec<_>>());
        }
    }
    let options = FitOptions { metric: Metric::Rendered, ..FitOptions::default() };
    let found = fit(&readings, &["ggx", "lambert"], &options).unwrap();
    // Readings are rounded to f32, 6e-8 of each.
    assert!(found.error < 1e-4, "{found:?}");
    assert!((found.lobes[0].parameters[0].value / 0.2 - 1.0).abs() < 1e-4, "{found:?}");
    for (tint, rho) in found.lobes[1].tint.iter().zip(&yellow) {
        assert!((tint / rho - 1.0).abs() < 1e-3, "{tint} for {rho}");
    }
}

#[test]
fn grey_in_three_channels_is_fitted_as_grey() {
    let one = satin(&Channels::Luminance);
    let mut three = Readings::new(Channels::Rgb);
    (0..one.len()).for_each(|i| three.push(one.pair(i)[0], one.pair(i)[1], &[one.values(i)[0]; 3]));
    let [one, three] = [&one, &three].map(|readings| fitted(readings, Metric::Rendered));
    // Both are at one minimum, told to the last digits that steps leave.
    assert!((one.error / three.error - 1.0).abs() < 1e-4, "{one:?} {three:?}");
    for (one, three) in one.lobes.iter().zip(&three.lobes) {
        assert!(three.tint.iter().all(|tint| (tint / one.tint[0] - 1.0).abs() < 5e-3), "{one:?} {three:?}");
    }
}
