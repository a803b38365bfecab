//! True cones beside what other programs have.

use glanz_color::colorchecker;
use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, Lab, LinearSrgb};
use glanz_eye::{BrettelOnScreen, Eye, machado};
use glanz_render::Shot;
use glanz_scene::{ColorMode, Tint};

use super::{faced, matte, unit};

/// The two sides' white and sums differ by some thousandths of a colour.
const NEAR: f64 = 0.15;

/// The mean and the greatest ΔE00 on the ColorChecker between what the eye of that name sees, and what another way makes of the picture
/// of one with all cones.
fn distance(name: &str, other: impl Fn([f64; 3]) -> [f64; 3]) -> [f64; 2] {
    let eye: Eye = name.parse().unwrap();
    let differences: Vec<f64> = colorchecker()
        .map(|(_, patch)| {
            let mut scene = faced(matte(Tint::Spectrum(std::sync::Arc::new(patch))), &unit("D65"));
            scene.render.mode = ColorMode::Spectral;
            scene.image = glanz_scene::Image { width: 4, height: 4, ..scene.image };
            let seen = |eye: Eye| {
                let mut shot = Shot::new(&scene.clone().with_eye(eye)).unwrap();
                let frame = shot.frame().unwrap();
                let [r, g, b, _] = shot.on_screen(frame).unwrap().pixel(1, 1).map(f64::from);
                [r, g, b]
            };
            let lab = |rgb| LinearSrgb(rgb).to::<Lab>();
            ciede2000(lab(seen(eye.clone())), lab(other(seen(Eye::default()))))
        })
        .collect();
    let mean = differences.iter().sum::<f64>() / differences.len() as f64;
    [mean, differences.iter().copied().fold(0.0, f64::max)]
}

fn near([found, greatest]: [f64; 2], mean: f64, most: f64, name: &str) {
    assert!(
        (found - mean).abs() < NEAR && (greatest - most).abs() < 3.0 * NEAR,
        "{name}: {found} {greatest}"
    );
}

#[test]
fn machados_matrices_are_as_far_from_true_cones_as_computed_elsewhere() {
    for (name, mean, most) in [("protan", 2.41, 9.21), ("deutan", 1.82, 7.07), ("tritan", 4.52, 12.41)] {
        let matrix = machado(name.parse::<Eye>().unwrap().cones).unwrap();
        near(distance(name, |rgb| matrix.apply(rgb)), mean, most, name);
    }
}

#[test]
fn brettels_projection_on_a_screen_is_as_far_as_computed_elsewhere() {
    for (name, mean, most) in [("protan", 1.27, 6.06), ("deutan", 1.06, 4.67), ("tritan", 1.45, 5.31)] {
        let way = BrettelOnScreen::without(name.parse::<Eye>().unwrap().cones).unwrap();
        near(distance(name, |rgb| way.apply(rgb)), mean, most, name);
    }
}
