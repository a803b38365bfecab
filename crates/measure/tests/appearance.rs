//! Gloss meters, multi-angle instruments and spheres.

use std::f64::consts::{FRAC_1_PI, PI};

use glanz_color::models::{Lab, Xyz};
use glanz_color::{FineSpectrum, Observer, fine_light, observer};
use glanz_math::Vec3;
use glanz_measure::{
    Channels, GlossMeter, HazeMeter, MultiAngle, flop_index, forty_five_zero, haze_of_gloss, log_haze,
    multi_angle, sphere,
};

fn white(_: Vec3<f64>, _: Vec3<f64>) -> Vec<f64> {
    vec![FRAC_1_PI]
}

/// Fresnel's reflectance of glass.
fn reflectance(n: f64, cos: f64) -> f64 {
    let inside = (n * n - 1.0 + cos * cos).sqrt();
    let (s, p) = ((cos - inside) / (cos + inside), (n * n * cos - inside) / (n * n * cos + inside));
    0.5 * (s * s + p * p)
}

/// GGX with the shadowing of correlated heights, under the Fresnel reflectance of a dielectric.
fn ggx_of(n: f64, alpha: f64) -> impl Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64> {
    move |wi, wo| {
        let half = (wi + wo).normalized();
        let a2 = alpha * alpha;
        let slope = half.z * half.z * (a2 - 1.0) + 1.0;
        let root = |w: Vec3<f64>| (a2 + (1.0 - a2) * w.z * w.z).sqrt();
        let d = a2 / (PI * slope * slope);
        let shadow = 0.5 / (wo.z * root(wi) + wi.z * root(wo));
        vec![reflectance(n, wi.dot(half)) * d * shadow]
    }
}

/// The same of the standard's glass.
fn ggx(alpha: f64) -> impl Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64> {
    ggx_of(1.567, alpha)
}

/// Glossy paint: a matte part of 0.3 below GGX of index 1.5.
fn paint() -> impl Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64> {
    let gloss = ggx_of(1.5, 0.1);
    move |wi, wo| vec![0.3 * FRAC_1_PI + gloss(wi, wo)[0]]
}

/// L* of a radiance factor.
fn lightness(factor: f64) -> f64 {
    Lab::for_white(Xyz([factor; 3]), Xyz([1.0; 3])).0[0]
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
    // By quadrature, too, but of another program (numpy, 16² × 240 000 directions for the narrow ones).
    for (alpha, expected) in [
        (0.01, [52.95, 88.41, 85.67]),
        (0.02, [25.30, 68.69, 63.51]),
        (0.05, [5.96, 34.2, 28.2]),
        (0.1, [1.62, 15.2, 11.0]),
        (0.2, [0.41, 5.03, 3.17]),
    ] {
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
        assert!((multi_angle(&mut told, 45.0, aspecular)[0] - angle).abs() < 1e-9, "{aspecular}");
    }
    assert!((multi_angle(&mut told, 15.0, 45.0)[0] + 30.0).abs() < 1e-9, "light at 15°");
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

#[test]
fn polished_glass_has_the_gloss_of_its_index() {
    // Fresnel's law, to the digits of the table of ISO 2813.
    for (n, expected) in [
        (1.40, [57.0, 71.9, 96.6]),
        (1.46, [71.8, 82.4, 98.2]),
        (1.50, [82.0, 89.1, 99.0]),
        (1.52, [87.3, 92.4, 99.3]),
        (1.54, [92.7, 95.7, 99.6]),
        (1.60, [109.1, 105.2, 100.4]),
        (1.70, [137.6, 120.3, 101.2]),
    ] {
        for (meter, expected) in
            [GlossMeter::AT_20, GlossMeter::AT_60, GlossMeter::AT_85].into_iter().zip(expected)
        {
            let gloss = meter.of_smooth(n);
            assert!((gloss - expected).abs() < 0.051, "{n} {meter:?}: {gloss}");
        }
    }
}

#[test]
fn the_geometry_of_gloss_changes_at_10_and_at_70() {
    for (gloss, angle) in [(9.9, 85.0), (10.0, 60.0), (70.0, 60.0), (70.1, 20.0)] {
        assert_eq!(GlossMeter::chosen(gloss).angle_deg, angle);
    }
}

#[test]
fn haze_is_the_tail_beside_the_highlight() {
    let haze = |meter: HazeMeter, alpha: f64| {
        let f = ggx(alpha);
        meter.haze(&mut |wi, wo| f(wi, wo))[0]
    };
    // A narrower highlight sends less beside itself, and less yet farther away.
    let [wide, narrow, least] = [0.02, 0.01, 0.005].map(|alpha| haze(HazeMeter::ISO_13803, alpha));
    assert!(wide > narrow && narrow > least, "{wide} {narrow} {least}");
    // Far out in the tail of GGX, the haze of narrow highlights goes with the square of the width.
    let [double, single] = [0.002, 0.001].map(|alpha| haze(HazeMeter::ISO_13803, alpha));
    assert!((3.6..4.0).contains(&(double / single)), "{}", double / single);
    let beside = |meter| haze(meter, 0.01);
    assert!(beside(HazeMeter::E430_A_NARROW) > 3.0 * beside(HazeMeter::E430_A_WIDE));
    assert!(log_haze(narrow) > log_haze(least) && log_haze(180.0) == 1285.0);
    assert_eq!((haze_of_gloss(80.0, 70.0), haze_of_gloss(70.0, 60.0)), (Some(10.0), None));
}

#[test]
fn paint_and_metal_have_the_flop_of_another_program() {
    let paint = paint();
    let factors = MultiAngle::SIX
        .pairs_deg
        .iter()
        .map(|(light, angle)| multi_angle(&mut |wi, wo| paint(wi, wo), *light, *angle)[0]);
    let factors: Vec<f64> = factors.collect();
    for (factor, expected) in factors.iter().zip([0.9108, 0.5493, 0.3498, 0.3059, 0.3011, 0.3007]) {
        assert!((factor - expected).abs() < 1e-4, "{factors:?}");
    }
    let flop = |f: &dyn Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64>| {
        let [a, b, c] =
            [15.0, 45.0, 110.0].map(|angle| lightness(multi_angle(&mut |wi, wo| f(wi, wo), 45.0, angle)[0]));
        flop_index(a, b, c).expect("it is brighter near the mirror direction")
    };
    assert!((flop(&paint) - 1.824).abs() < 1e-3, "{}", flop(&paint));
    // Metal: half of GGX of width 0.25 without Fresnel's law, over a dark ground.
    let metal = |wi: Vec3<f64>, wo: Vec3<f64>| {
        let half = (wi + wo).normalized();
        vec![0.03 * FRAC_1_PI + 0.5 * ggx(0.25)(wi, wo)[0] / reflectance(1.567, wi.dot(half))]
    };
    assert!((flop(&metal) - 12.50).abs() < 0.01, "{}", flop(&metal));
    assert_eq!(flop(&white), 0.0);
}

#[test]
fn a_sphere_and_45_0_see_paint_as_another_program_does() {
    let paint = paint();
    let f = &mut |wi: Vec3<f64>, wo: Vec3<f64>| paint(wi, wo);
    for (port, expected) in [(4.1, 0.3336), (8.0, 0.3207)] {
        let [all, without] = sphere(f, port);
        assert!(
            (all[0] - 0.3397).abs() < 1e-4 && (without[0] - expected).abs() < 1e-4,
            "{all:?} {without:?}"
        );
    }
    assert!((forty_five_zero(f)[0] - 0.3059).abs() < 1e-4);
}

#[test]
fn channels_have_colours_under_any_light() {
    let (a, ten) = (fine_light("A").unwrap(), observer("cie1964").unwrap());
    let channels = Channels::Wavelengths(vec![380.0, 780.0]);
    let white = channels.white(&a, &ten).unwrap();
    let grey = channels.xyz(&[0.5, 0.5], &a, &ten).unwrap();
    assert!(grey.iter().zip(white).all(|(grey, white)| (grey - 0.5 * white).abs() < 1e-12));
    // Holding the end values is what the others are of, too.
    let known = glanz_color::xyz_of_reflectance(&FineSpectrum::from_fn(|_| 0.5), &a, &ten);
    assert!(grey.iter().zip(known).all(|(grey, known)| (grey - known).abs() < 1e-12));
    // RGB know no light but their own.
    let d65 = Channels::Rgb.xyz(&[1.0; 3], &a, &ten).unwrap();
    assert!((d65[0] - 0.9505).abs() < 1e-3 && (d65[1] - 1.0).abs() < 1e-12 && !Channels::Rgb.has_spectra());
    assert_eq!(Channels::Rgb.xyz(&[0.1], &a, &ten), None);
    assert_eq!(Channels::Luminance.xyz(&[f64::NAN], &a, &Observer::default()), None);
}

#[test]
fn the_longest_list_of_angles_has_all_others() {
    for list in MultiAngle::ALL {
        assert!(
            list.pairs_deg.iter().all(|pair| MultiAngle::E2539.pairs_deg.contains(pair)),
            "{}",
            list.name
        );
    }
}
