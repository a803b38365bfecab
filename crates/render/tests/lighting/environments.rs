//! Environments.

use std::sync::Arc;

use glam::DMat3;
use glanz_bsdf::Side;
use glanz_math::Frame;
use glanz_scene::{Background, EnvironmentMap};

use super::*;

const VIEWS: [f64; 8] = [0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 75.0, 80.0];

pub(super) fn map(value: impl Fn(DVec3) -> f64) -> Arc<EnvironmentMap> {
    let (width, height) = (256, 128);
    let pixel = |i: usize| {
        let (u, v) = ((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
        let value = value(EnvironmentMap::direction(u / width as f64, v / height as f64));
        [value as f32, value as f32 * 0.5, 0.25]
    };
    Arc::new(EnvironmentMap { width, height, pixels: (0..width * height).map(pixel).collect() })
}

pub(super) fn environment(map: Option<Arc<EnvironmentMap>>) -> Light {
    white(LightKind::Environment { map, rotation: DMat3::IDENTITY })
}

/// A bright sky with a window sixteen times as bright, and a dim ground.
pub(super) fn room(d: DVec3) -> f64 {
    let window = (d.x + 0.5).abs() < 0.25 && (d.y - 0.3).abs() < 0.2 && d.z > 0.0;
    (0.3 + 0.4 * (d.y + 0.3 * d.x)).max(0.1) + if window { 8.0 } else { 0.0 }
}

/// ∫ L f_cos dω over the pixels of the map.
pub(super) fn by_sum(map: &EnvironmentMap, shape: &Shape, degrees: f64) -> f64 {
    let mut sum = 0.0;
    for row in 0..map.height {
        let weight = map.solid_angle(row);
        for column in 0..map.width {
            let (u, v) = ((column as f64 + 0.5) / map.width as f64, (row as f64 + 0.5) / map.height as f64);
            let light = f64::from(map.pixels[row * map.width + column][0]);
            sum += weight * light * lobe_value(shape, degrees, EnvironmentMap::direction(u, v));
        }
    }
    sum
}

/// ∫ L f_cos dω by rings of half vectors, or about the refracted direction.
fn by_rings(shape: &Shape, wo: Vec3<f64>, light: impl Fn(DVec3) -> f64) -> f64 {
    const RINGS: usize = 200;
    let below = shape.info().side == Side::Transmission;
    let middle = Vec3::new(-wo.x / shape.eta(), -wo.y / shape.eta(), 0.0);
    let refracted = Frame::around(Vec3 { z: -(1.0 - middle.dot(middle)).max(0.0).sqrt(), ..middle });
    let edge = |i: usize| (i as f64 / RINGS as f64).powi(4) * core::f64::consts::PI * 0.99;
    let mut sum = 0.0;
    for i in 0..RINGS {
        let (low, high) = (edge(i), edge(i + 1));
        let ring = (low.cos() - high.cos()) * core::f64::consts::TAU / RINGS as f64;
        for k in 0..RINGS {
            let phi = (k as f64 + 0.5 * (i % 2) as f64) / RINGS as f64 * core::f64::consts::TAU;
            let d = Vec3::from_angles(0.5 * (low + high), phi);
            let cos = d.dot(wo);
            let (wi, weight) = match below {
                true => (refracted.t * d.x + refracted.b * d.y + refracted.n * d.z, ring),
                false if cos <= 0.0 => continue,
                false => (d * (2.0 * cos) - wo, ring * 4.0 * cos),
            };
            if (wi.z < 0.0) == below {
                let value = shape.f_cos(&DirectionPair::new(wo, wi)) * weight;
                sum += value * light(DVec3::new(wi.x, wi.y, wi.z));
            }
        }
    }
    sum
}

/// The room on a map, each pixel the mean of sixteen points.
fn room_map() -> Arc<EnvironmentMap> {
    let (width, height) = (1024, 512);
    let pixel = |i: usize| {
        let at = |k: usize, of: usize| (of as f64 + (k as f64 + 0.5) / 4.0) / height as f64;
        let part =
            |k: usize| room(EnvironmentMap::direction(0.5 * at(k % 4, i % width), at(k / 4, i / width)));
        [(0..16).map(part).sum::<f64>() as f32 / 16.0; 3]
    };
    Arc::new(EnvironmentMap { width, height, pixels: (0..width * height).map(pixel).collect() })
}

/// A shape, its parameters, and its greatest errors.
pub(super) type Stated = (&'static str, &'static [(&'static str, f64)], [f64; 2]);

/// The lobes that errors are stated for, from the narrowest to the widest of each kind, and the greatest errors of each for
/// views up to 80°, measured and rounded up: in parts of the mean of the room, and of areas in parts of the albedo.
pub(super) fn stated() -> Vec<Stated> {
    vec![
        ("lambert", &[], [0.008, 0.001]),
        ("lambert-transmission", &[], [0.009, 0.001]),
        ("oren-nayar", &[("sigma_deg", 20.0)], [0.014, 0.002]),
        ("oren-nayar", &[("sigma_deg", 30.0)], [0.014, 0.002]),
        ("oren-nayar", &[("sigma_deg", 60.0)], [0.022, 0.002]),
        ("ggx", &[("alpha", 0.02)], [0.077, 0.003]),
        ("ggx", &[("alpha", 0.05)], [0.03, 0.006]),
        ("ggx", &[("alpha", 0.1)], [0.039, 0.01]),
        ("ggx", &[("alpha", 0.2)], [0.041, 0.003]),
        ("ggx", &[("alpha", 0.3)], [0.069, 0.005]),
        ("ggx", &[("alpha", 0.6)], [0.039, 0.002]),
        ("ggx", &[("alpha", 1.0)], [0.009, 0.002]),
        ("cook-torrance", &[("m", 0.02)], [0.002, 0.017]),
        ("cook-torrance", &[("m", 0.05)], [0.03, 0.019]),
        ("cook-torrance", &[("m", 0.1)], [0.022, 0.017]),
        ("cook-torrance", &[("m", 0.2)], [0.005, 0.014]),
        ("cook-torrance", &[("m", 0.4)], [0.05, 0.004]),
        ("cook-torrance", &[("m", 1.0)], [0.025, 0.014]),
        ("beckmann", &[("alpha", 0.3)], [0.017, 0.008]),
        ("beckmann", &[("alpha", 1.0)], [0.04, 0.008]),
        ("ward", &[("alpha", 0.05)], [0.017, 0.024]),
        ("ward", &[("alpha", 0.15)], [0.015, 0.016]),
        ("ward", &[("alpha", 0.4)], [0.024, 0.009]),
        ("phong-normalized", &[("shininess", 1.0)], [0.013, 0.005]),
        ("phong-normalized", &[("shininess", 5.0)], [0.007, 0.009]),
        ("phong-normalized", &[("shininess", 20.0)], [0.011, 0.008]),
        ("phong-normalized", &[("shininess", 100.0)], [0.011, 0.013]),
        ("phong-normalized", &[("shininess", 1000.0)], [0.005, 0.013]),
        ("phong-normalized", &[("shininess", 5000.0)], [0.001, 0.007]),
        ("blinn-phong-normalized", &[("shininess", 10.0)], [0.004, 0.006]),
        ("blinn-phong-normalized", &[("shininess", 100.0)], [0.015, 0.014]),
        ("blinn-phong-normalized", &[("shininess", 1000.0)], [0.016, 0.019]),
        ("charlie", &[("alpha", 0.1)], [0.077, 0.021]),
        ("charlie", &[("alpha", 0.25)], [0.052, 0.009]),
        ("charlie", &[("alpha", 0.5)], [0.055, 0.006]),
        ("charlie", &[("alpha", 1.0)], [0.019, 0.006]),
        ("ggx-transmission", &[("alpha", 0.1)], [0.016, 0.004]),
        ("ggx-transmission", &[("alpha", 0.3)], [0.015, 0.01]),
        ("ggx-transmission", &[("alpha", 0.6)], [0.02, 0.006]),
        ("ashikhmin-shirley", &[("nu", 100.0), ("nv", 100.0)], [0.016, 0.017]),
        ("ggx", &[("alpha", 0.05), ("alpha_y", 0.3)], [0.124, 0.183]),
        ("ggx", &[("alpha", 0.1), ("alpha_y", 0.9)], [0.165, 0.026]),
        ("ward", &[("alpha", 0.1), ("alpha_y", 0.3)], [0.014, 0.138]),
    ]
}

#[test]
fn errors_of_a_room_with_a_window_are_as_stated() {
    let map = room_map();
    let mean = map.mean()[0];
    let (mut table, mut all_fit) = (String::new(), true);
    for (name, set, [allowed, _]) in stated() {
        let shape = shape(name, set);
        let azimuths: &[f64] = if set.len() > 1 { &[0.0, 30.0, 90.0] } else { &[0.0] };
        let below = shape.info().side == Side::Transmission;
        // What is seen through the surface is turned up.
        let turn = if below { DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0)) } else { DMat3::IDENTITY };
        let mut scene = surface(&shape, 0.0);
        scene.lights.push(white(LightKind::Environment { map: Some(Arc::clone(&map)), rotation: turn }));
        let prepared = prepare(&scene, &PrepareOptions::default()).unwrap();
        let mut worst = Worst::default();
        for (azimuth, degrees) in azimuths.iter().flat_map(|azimuth| VIEWS.map(|degrees| (azimuth, degrees)))
        {
            let wo = Vec3::from_angles(degrees.to_radians(), azimuth.to_radians());
            let expected = by_rings(&shape, wo, |d| room(turn * d));
            let got = value_from(&prepared, wo);
            worst.note((got - expected) / mean, || {
                format!("{azimuth}° {degrees}°: {got:.4} for {expected:.4}")
            });
        }
        table += &format!("{name} {set:?}: {:.4} of {allowed} at {}\n", worst.0, worst.1);
        all_fit &= worst.0 < allowed;
    }
    eprintln!("{table}");
    assert!(all_fit, "{table}");
}

#[test]
fn uniform_environments_are_the_white_furnace() {
    for (name, shape) in lobes() {
        for degrees in VIEWS {
            let expected = glanz_bsdf::albedo(&shape, degrees.to_radians().cos());
            for map in [None, Some(map(|_| 1.0))] {
                let mut scene = surface(&shape, degrees);
                scene.lights.push(environment(map));
                let got = value(&scene);
                assert!((got - expected).abs() < 2e-3, "{name}, {degrees}°: {got} for {expected}");
            }
        }
    }
}

#[test]
fn a_mirror_shows_what_is_there() {
    let ramp = |d: DVec3| 0.5 + 0.4 * d.x + 0.05 * d.y;
    for degrees in VIEWS {
        let mut scene = surface(&shape("mirror", &[]), degrees);
        scene.lights.push(environment(Some(map(ramp))));
        let (sin, cos) = degrees.to_radians().sin_cos();
        let (got, expected) = (value(&scene), ramp(DVec3::new(-sin, 0.0, cos)));
        assert!((got - expected).abs() < 1e-3, "{degrees}°: {got} for {expected}");
    }
}

#[test]
fn refraction_bends_the_line_of_sight() {
    let ramp = |d: DVec3| 0.5 + 0.4 * d.x;
    for (degrees, eta) in [(0.0_f64, 1.5), (40.0, 1.5), (70.0, 1.33)] {
        let mut scene = surface(&shape("refraction", &[("eta", eta)]), degrees);
        scene.lights.push(environment(Some(map(ramp))));
        let sin = degrees.to_radians().sin() / eta;
        let (got, expected) = (value(&scene), ramp(DVec3::new(-sin, 0.0, -(1.0 - sin * sin).sqrt())));
        assert!((got - expected).abs() < 1e-3, "{degrees}°, {eta}: {got} for {expected}");
    }
}

#[test]
fn the_background_shows_the_environment_in_their_direction() {
    let ramp = |d: DVec3| 0.5 + 0.3 * d.x + 0.1 * d.y - 0.05 * d.z;
    let mut scene = empty(common::camera(5.0, 60.0));
    scene.lights.push(environment(Some(map(ramp))));
    scene.image.background = Background::Environment;
    let mut options = transparent();
    options.background = Background::Environment;
    let frame = picture(&scene, 64, 48, &options);
    let scale = 30.0_f64.to_radians().tan() / 24.0;
    for (x, y) in [(3, 5), (32, 24), (60, 40)] {
        let ray = DVec3::new((f64::from(x) + 0.5 - 32.0) * scale, (24.0 - f64::from(y) - 0.5) * scale, -1.0);
        let got = f64::from(frame.rgb[0][(y * 64 + x) as usize]);
        assert!((got - ramp(ray.normalize())).abs() < 1e-3, "{x}, {y}: {got}");
        assert_eq!(frame.alpha[(y * 64 + x) as usize], 1.0);
    }
}

#[test]
fn turning_the_environment_turns_what_is_seen() {
    let ramp = |d: DVec3| 0.5 + 0.4 * d.x;
    let mut scene = surface(&shape("mirror", &[]), 40.0);
    let mut light = environment(Some(map(ramp)));
    let LightKind::Environment { rotation, .. } = &mut light.kind else { unreachable!() };
    *rotation = DMat3::from_rotation_z(90.0_f64.to_radians());
    scene.lights.push(light);
    // What was at +X is now at +Y, where the mirrored ray has no part.
    assert!((value(&scene) - 0.5).abs() < 1e-3);
}
