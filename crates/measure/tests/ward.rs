//! Ward's regression on the readings of a virtual goniometer.

use std::f64::consts::{FRAC_1_PI, TAU};

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use glanz_measure::{Channels, FitError, Noise, Readings, fit_ward, spiral_about_mirror};

fn readings(alpha: [f64; 2], rho_d: f64, rho_s: f64, noise: f64) -> Readings {
    let ward = Shape::named("ward", &[("alpha", alpha[0]), ("alpha_y", alpha[1])])
        .expect("the list of models has it");
    let mut readings = Readings::new(Channels::Luminance);
    let mut random = Noise::new(1);
    for [wi, wo] in spiral_about_mirror() {
        let f = rho_d * FRAC_1_PI + rho_s * ward.f_cos(&DirectionPair::new(wo, wi)) / wi.z;
        readings.push(wi, wo, &[(f * (1.0 + noise * random.normal())) as f32]);
    }
    readings
}

#[test]
fn readings_without_noise_give_the_widths_back() {
    for alpha in [[0.05; 2], [0.1; 2], [0.2; 2], [0.088, 0.13], [0.04, 0.11]] {
        let fit = fit_ward(&readings(alpha, 0.3, 0.1, 0.0), 0, true).unwrap();
        for axis in 0..2 {
            assert!((fit.alpha[axis] / alpha[axis] - 1.0).abs() < 2e-3, "{alpha:?}: {:?}", fit.alpha);
        }
        assert!((fit.rho_s / 0.1 - 1.0).abs() < 5e-3 && (fit.rho_d / 0.3 - 1.0).abs() < 5e-3, "{alpha:?}");
        assert!(fit.r_squared > 0.9999, "{}", fit.r_squared);
    }
}

#[test]
fn three_percent_of_noise_leave_three_percent_of_the_widths() {
    for alpha in [[0.05; 2], [0.1; 2], [0.2; 2], [0.088, 0.13], [0.04, 0.11]] {
        let isotropic = alpha[0] == alpha[1];
        let fit = fit_ward(&readings(alpha, 0.3, 0.1, 0.03), 0, !isotropic).unwrap();
        for axis in 0..2 {
            assert!((fit.alpha[axis] / alpha[axis] - 1.0).abs() < 0.03, "{alpha:?}: {:?}", fit.alpha);
        }
        assert!((fit.rho_s / 0.1 - 1.0).abs() < 0.03 && (fit.rho_d / 0.3 - 1.0).abs() < 0.03, "{fit:?}");
        println!(
            "{alpha:?} -> {:.4?}, rho_s {:.4}, rho_d {:.4}, r2 {:.5}",
            fit.alpha, fit.rho_s, fit.rho_d, fit.r_squared
        );
    }
}

#[test]
fn points_lie_on_one_line_over_their_abscissa() {
    let fit = fit_ward(&readings([0.088, 0.13], 0.2, 0.1, 0.0), 0, true).unwrap();
    let slope = -1.0 / (fit.alpha[0] * fit.alpha[0]);
    for point in fit.points.iter().filter(|point| point.weight > 1e-3) {
        let line = fit.intercept() + slope * fit.abscissa(point);
        assert!((point.value - line).abs() < 0.02, "{point:?}: {line}");
    }
}

#[test]
fn what_is_no_highlight_is_none() {
    let mut few = Readings::new(Channels::Luminance);
    let up = Vec3::from_angles(0.0, 0.0);
    few.push(up, up, &[1.0]);
    assert!(matches!(fit_ward(&few, 0, false), Err(FitError::TooFew { readings: 1, .. })));
    // The brightest far from the mirror direction.
    let mut hollow = Readings::new(Channels::Luminance);
    for step in 0..100 {
        let wo = Vec3::from_angles(0.012 * f64::from(step), 0.3 * TAU * f64::from(step));
        hollow.push(up, wo, &[0.1 + 0.01 * step as f32]);
    }
    assert!(matches!(fit_ward(&hollow, 0, false), Err(FitError::Nothing(_))));
}
