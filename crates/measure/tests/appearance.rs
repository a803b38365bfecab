//! Gloss meters, multi-angle instruments and spheres.

use std::f64::consts::{FRAC_1_PI, PI};

use glanz_math::Vec3;
use glanz_measure::{GlossMeter, forty_five_zero, multi_angle, sphere};

fn white(_: Vec3<f64>, _: Vec3<f64>) -> Vec<f64> {
    vec![FRAC_1_PI]
}

/// Fresnel's reflectance of glass.
fn reflectance(n: f64, cos: f64) -> f64 {
    let inside = (n * n - 1.0 + cos * cos).sqrt();
    let (s, p) = ((cos - inside) / (cos + inside), (n * n * cos - inside) / (n * n * cos + inside));
    0.5 * (s * s + p * p)
}

/// GGX with the shadowing of correlated heights, under the Fresnel reflectance of the standard's glass.
fn ggx(alpha: f64) -> impl Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64> {
    move |wi, wo| {
        let half = (wi + wo).normalized();
        let a2 = alpha * alpha;
        let slope = half.z * half.z * (a2 - 1.0) + 1.0;
        let root = |w: Vec3<f64>| (a2 + (1.0 - a2) * w.z * w.z).sqrt();
        let d = a2 / (PI * slope * slope);
        let shadow = 0.5 / (wo.z * root(wi) + wi.z * root(wo));
        vec![reflectance(1.567, wi.dot(half)) * d * shadow]
    }
}

#[test]
fn a_matte_white_has_the_gloss_of_the_receptors_size() {
    // The solid angle of the receptor by that of a hemisphere, by what the glass reflects.
    for (meter, expected) in
        [(GlossMeter::AT_20, 1.203), (GlossMeter::AT_60, 2.485), (GlossMeter::AT_85, 0.0327)]
    {
        let gloss = meter.gloss(&mut white)[0];
        assert!((gloss - expected).abs() < 0.003, "{meter:?}: {gloss}");
    }
}

#[test]
fn a_narrow_lobe_on_the_standards_glass_nears_100() {
    let gloss = |meter: GlossMeter, alpha: f64| {
        let f = ggx(alpha);
        meter.gloss(&mut |wi, wo| f(wi, wo))[0]
    };
    // What lies outside of the receptor is the tail of GGX: as 1/θ², so half as wide a lobe loses a quarter.
    let (wide, narrow) = (100.0 - gloss(GlossMeter::AT_60, 0.01), 100.0 - gloss(GlossMeter::AT_60, 0.005));
    assert!((3.3..4.3).contains(&(wide / narrow)) && narrow < 4.0, "{wide} {narrow}");
    // By quadrature, too, but of another program.
    for (alpha, expected) in
        [(0.05, [5.96, 34.2, 28.2]), (0.1, [1.62, 15.2, 11.0]), (0.2, [0.41, 5.03, 3.17])]
    {
        for (meter, expected) in
            [GlossMeter::AT_20, GlossMeter::AT_60, GlossMeter::AT_85].into_iter().zip(expected)
        {
            let gloss = gloss(meter, alpha);
            assert!((gloss - expected).abs() < 0.1, "{alpha} {meter:?}: {gloss}, expected {expected}");
        }
    }
}

#[test]
fn angles_count_from_the_mirror_direction_towards_the_light() {
    // A BRDF that tells the detector's angle, positive on the side of the mirror direction.
    let mut told = |_: Vec3<f64>, wo: Vec3<f64>| vec![wo.x.atan2(wo.z).to_degrees() / PI];
    for (aspecular, angle) in [(-15.0, 60.0), (15.0, 30.0), (45.0, 0.0), (110.0, -65.0)] {
        assert!((multi_angle(&mut told, aspecular)[0] - angle).abs() < 1e-9, "{aspecular}");
    }
    assert!((forty_five_zero(&mut white)[0] - 1.0).abs() < 1e-12);
}

#[test]
fn a_sphere_sees_all_or_all_but_the_port() {
    let [all, without] = sphere(&mut white, 4.1);
    assert!((all[0] - 1.0).abs() < 1e-4);
    // The port's part of the hemisphere, by its cosine.
    let port = (4.1_f64.to_radians()).sin().powi(2) * 8.0_f64.to_radians().cos();
    assert!((all[0] - without[0] - port).abs() < 3e-4, "{}", all[0] - without[0]);
}
