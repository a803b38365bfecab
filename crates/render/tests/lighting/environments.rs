//! Environments.

use std::sync::Arc;

use glam::DMat3;
use glanz_scene::{Background, EnvironmentMap};

use super::*;

const VIEWS: [f64; 4] = [0.0, 30.0, 60.0, 75.0];

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

/// The stated errors, in parts of what the map gives on average, for views up to 60° and at 75°: measured, rounded up.
/// The harmonics err little. Lobes are blurred as for a viewer above, where they are round; seen from the side they
/// are narrower across, and a window sixteen times as bright as its wall that is beside the lobe then counts
/// too much.
fn allowed(name: &str) -> [f64; 2] {
    match name {
        "lambert" | "lambert-transmission" => [0.012, 0.012],
        "oren-nayar 30°" => [0.19, 0.24],
        "phong-normalized 20" => [0.05, 0.06],
        "ggx .1" => [0.5, 0.12],
        "ggx .3" => [0.53, 0.82],
        "ggx .6" => [0.14, 0.09],
        "cook-torrance .2" => [0.62, 0.68],
        "ward .15" => [0.36, 0.1],
        other => panic!("no error is stated for {other}"),
    }
}

#[test]
fn errors_of_a_room_with_a_window_are_as_stated() {
    let map = map(room);
    let (mut table, mut all_fit) = (String::new(), true);
    for (name, shape) in lobes() {
        let mut worst = [Worst::default(), Worst::default()];
        for degrees in VIEWS {
            let mut scene = surface(&shape, degrees);
            scene.lights.push(environment(Some(Arc::clone(&map))));
            let (got, expected) = (value(&scene), by_sum(&map, &shape, degrees));
            let error = (got - expected) / map.mean()[0];
            let flat = usize::from(degrees > 60.0);
            worst[flat].note(error, || format!("{degrees}°: {got:.4} for {expected:.4}"));
        }
        table +=
            &format!("{name}: {:.4} at {}; {:.4} at {}\n", worst[0].0, worst[0].1, worst[1].0, worst[1].1);
        let fits = worst.iter().zip(allowed(name)).all(|(worst, allowed)| worst.0 < allowed);
        all_fit &= fits;
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

/// The room on a map of so many rows, each pixel the mean of sixteen points.
fn room_map(height: usize) -> Arc<EnvironmentMap> {
    let width = 2 * height;
    let pixel = |i: usize| {
        let mut sum = 0.0;
        for k in 0..16 {
            let (u, v) = ((i % width) as f64 + (k % 4) as f64 * 0.25 + 0.125, (i / width) as f64 + (k / 4) as f64 * 0.25 + 0.125);
            sum += room(EnvironmentMap::direction(u / width as f64, v / height as f64)) / 16.0;
        }
        [sum as f32; 3]
    };
    Arc::new(EnvironmentMap { width, height, pixels: (0..width * height).map(pixel).collect() })
}

/// ∫ L f_cos dω by rings about the mirrored (or refracted) direction, as half vectors or as they are.
fn by_rings(shape: &Shape, degrees: f64, azimuth: f64, light: impl Fn(DVec3) -> f64) -> f64 {
    let below = shape.info().side == glanz_bsdf::Side::Transmission;
    let wo = Vec3::from_angles(degrees.to_radians(), azimuth.to_radians());
    let (n, m) = (300, 300);
    let mut sum = 0.0;
    for i in 0..n {
        let edge = |i: usize| (i as f64 / n as f64).powi(4) * core::f64::consts::PI * 0.99;
        let (low, high) = (edge(i), edge(i + 1));
        let theta = 0.5 * (low + high);
        let ring = (low.cos() - high.cos()) * 2.0 * core::f64::consts::PI / m as f64;
        for k in 0..m {
            let phi = (k as f64 + 0.5 * (i % 2) as f64) / m as f64 * 2.0 * core::f64::consts::PI;
            let d = Vec3::from_angles(theta, phi);
            let (wi, weight) = if below {
                let sine = degrees.to_radians().sin() / shape.eta();
                let z = Vec3::new(-wo.x / shape.eta(), -wo.y / shape.eta(), -(1.0 - sine * sine).max(0.0).sqrt()).normalized();
                let f = glanz_math::Frame::around(z);
                (f.t * d.x + f.b * d.y + f.n * d.z, ring)
            } else {
                // Half vectors.
                let cos = d.dot(wo);
                if cos <= 0.0 { continue; }
                (d * (2.0 * cos) - wo, ring * 4.0 * cos)
            };
            if (wi.z > 0.0) == below { continue; }
            let value = shape.f_cos(&DirectionPair::new(wo, wi)) * weight;
            if value > 0.0 {
                sum += value * light(DVec3::new(wi.x, wi.y, wi.z));
            }
        }
    }
    sum
}

pub(super) fn all_lobes() -> Vec<(String, Shape)> {
    let mut all: Vec<(String, Shape)> = Vec::new();
    let mut push = |name: &str, key: &str, values: &[f64]| {
        for value in values {
            match Shape::named(name, &[(key, *value)]) {
                Ok(shape) => all.push((format!("{name} {value}"), shape)),
                Err(error) => eprintln!("{name}: {error}"),
            }
        }
    };
    push("ggx", "alpha", &[0.02, 0.05, 0.1, 0.2, 0.3, 0.6, 1.0]);
    push("cook-torrance", "m", &[0.02, 0.05, 0.1, 0.2, 0.4, 1.0]);
    push("beckmann", "alpha", &[0.3, 1.0]);
    push("ward", "alpha", &[0.05, 0.15, 0.4]);
    push("phong-normalized", "shininess", &[1.0, 5.0, 20.0, 100.0, 1000.0, 5000.0]);
    push("blinn-phong-normalized", "shininess", &[1.0, 10.0, 100.0, 1000.0, 5000.0]);
    push("ashikhmin-shirley", "nu", &[10.0, 100.0, 1000.0]);
    push("charlie", "alpha", &[0.1, 0.25, 0.5, 1.0]);
    push("oren-nayar", "sigma_deg", &[20.0, 30.0, 60.0]);
    push("ggx-transmission", "alpha", &[0.1, 0.3, 0.6]);
    push("lambert-transmission", "x", &[]);
    all.push(("lambert".into(), shape("lambert", &[])));
    all.push(("ggx .05x.3".into(), shape("ggx", &[("alpha", 0.05), ("alpha_y", 0.3)])));
    all.push(("ggx .1x.9".into(), shape("ggx", &[("alpha", 0.1), ("alpha_y", 0.9)])));
    all.push(("ward .1x.3".into(), shape("ward", &[("alpha", 0.1), ("alpha_y", 0.3)])));
    all
}

#[test]
#[ignore]
fn table() {
    let map = room_map(512);
    let mean = map.mean()[0];
    let all = all_lobes();
    let only = std::env::var("ONLY").unwrap_or_default();
    for (name, shape) in all {
        if !name.starts_with(&only) { continue; }
        let mut line = format!("{name:<28}");
        let mut worst = 0.0f64;
        let azimuths: &[f64] = if shape.is_anisotropic() && name.contains('x') { &[0.0, 30.0, 60.0, 90.0] } else { &[0.0] };
        for azimuth in azimuths {
            for degrees in [0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 75.0, 80.0] {
                let mut scene = surface(&shape, degrees);
                let eye = Vec3::from_angles(f64::to_radians(degrees), azimuth.to_radians());
                scene.camera.as_mut().unwrap().eye = DVec3::new(eye.x, eye.y, eye.z) * 10.0;
                scene.lights.push(environment(Some(Arc::clone(&map))));
                let start = std::time::Instant::now();
                let got = value(&scene);
                if degrees == 0.0 && *azimuth == 0.0 { line += &format!(" {:5.1} ms", start.elapsed().as_secs_f64() * 1e3); }
                if std::env::var("DEBUG").is_ok() { eprintln!("{degrees}: {got} {} albedo {}", by_rings(&shape, degrees, *azimuth, room), by_rings(&shape, degrees, *azimuth, |_| 1.0)); }
                let error = (got - by_rings(&shape, degrees, *azimuth, room)) / mean;
                let azi = if *azimuth == 0.0 && degrees == 80.0 { " |" } else { "" };
                worst = worst.max(error.abs());
                line += &format!(" {error:7.3}{azi}");
            }
        }
        eprintln!("{line} worst {worst:.3}");
    }
}
