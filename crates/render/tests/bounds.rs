//! Extreme scenes: whatever model, parameters, lens and light, a pixel is what its model gives in double precision.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::{
    ALL_LAYERS, Random, add, assert_sane, empty, light, picture, rectangle, render_as, shiny, sphere,
};
use core::f64::consts::PI;
use glam::{DMat4, DVec3};
use glanz_bsdf::{DirectionPair, LightTerm, MODELS, ModelInfo, Shape, Side};
use glanz_color::Rgb;
use glanz_math::Vec3;
use glanz_picture::Frame;
use glanz_render::DrawOptions;
use glanz_scene::{Background, Camera, Interpolation, LightKind, Lobe, Material, Projection, Scene, Shading};

const WIDTH: u32 = 24;
const HEIGHT: u32 = 16;
/// How far directions in single precision may be off.
const STEP: f64 = 4e-7;

/// A number from 1 to ten to a power, evenly in its logarithm.
fn power(random: &mut Random, low: f64, high: f64) -> f64 {
    10f64.powf(random.between(low, high))
}

/// The model with each parameter at its least, its greatest, or between; none where they do not fit together.
fn shape(info: &ModelInfo, random: &mut Random) -> Option<Shape> {
    let set: Vec<(&str, f64)> = info
        .params
        .iter()
        .map(|param| {
            let value = match (random.unit() * 4.0) as u32 {
                0 => param.min,
                1 => param.max,
                _ => random.between(param.min, param.max),
            };
            (param.name, value)
        })
        .collect();
    Shape::named(info.name, &set).ok()
}

/// A direction of this height above the plane, towards ±x as the sign has it and hardly beside it.
fn direction(elevation_deg: f64, sign: f64, random: &mut Random) -> DVec3 {
    let (sin, cos) = elevation_deg.to_radians().sin_cos();
    let azimuth = random.between(-0.01, 0.01);
    DVec3::new(sign * cos * azimuth.cos(), cos * azimuth.sin(), sin)
}

/// The way from the surface to the eye, of a pixel.
fn to_eye(camera: &Camera, x: u32, y: u32) -> DVec3 {
    let Projection::Perspective { fov_y } = camera.projection else { unreachable!("all are perspective") };
    let back = (camera.eye - camera.target).normalize();
    let right = camera.up.cross(back).normalize();
    let up = back.cross(right);
    let scale = 2.0 * (0.5 * fov_y).tan() / f64::from(HEIGHT);
    let across = (f64::from(x) + 0.5 - 0.5 * f64::from(WIDTH)) * scale;
    let along = (0.5 * f64::from(HEIGHT) - f64::from(y) - 0.5) * scale;
    (back - right * across - up * along).normalize()
}

/// Between what values a pixel may be, as its directions in single precision may be off.
fn bounds(shape: &Shape, wo: DVec3, wi: DVec3) -> [f64; 2] {
    let [mut least, mut most] = [f64::INFINITY, 0.0];
    for i in 0..27 {
        let step =
            DVec3::new(f64::from(i % 3) - 1.0, f64::from(i / 3 % 3) - 1.0, f64::from(i / 9) - 1.0) * STEP;
        let near = wo + step;
        if near.z <= 0.0 {
            least = 0.0;
            continue;
        }
        let vector = |v: DVec3| Vec3::new(v.x, v.y, v.z);
        let value = PI * shape.f_cos(&DirectionPair::new(vector(near.normalize()), vector(wi)));
        least = f64::min(least, value);
        most = f64::max(most, value);
    }
    [least, most]
}

#[test]
fn lobes_under_grazing_lights_are_what_they_are_in_double_precision() {
    let mut random = Random(77);
    let lit = |info: &&ModelInfo| {
        matches!(info.term, LightTerm::Diffuse | LightTerm::Specular)
            && info.side == Side::Reflection
            && !info.delta
    };
    let mut compared = 0;
    for info in MODELS.iter().filter(lit) {
        for _ in 0..30 {
            let Some(shape) = shape(info, &mut random) else { continue };
            let [eye_deg, light_deg] = [0, 1].map(|_| power(&mut random, -1.0, 1.9));
            let (eye, wi) = (direction(eye_deg, -1.0, &mut random), direction(light_deg, 1.0, &mut random));
            let camera = Camera {
                eye,
                target: DVec3::ZERO,
                up: DVec3::Z,
                projection: Projection::Perspective { fov_y: power(&mut random, -1.0, 2.0).to_radians() },
            };
            let mut scene = empty(camera);
            let material = Material::of_lobes("m", vec![Lobe::new(shape.clone(), Rgb::gray(1.0))]);
            add(&mut scene, rectangle([-1e4, -1e4, 1e4, 1e4], 0.0), material, DMat4::IDENTITY);
            scene.lights.push(light(LightKind::Directional { direction: -wi }, Rgb::gray(1.0)));
            let options = DrawOptions::new(Background::Transparent);
            let frame = picture(&scene, WIDTH, HEIGHT, &options);
            let what = format!("{shape:?}, eye {eye_deg}°, light {light_deg}°");
            assert_sane(&frame, &what);
            for i in (0..(WIDTH * HEIGHT) as usize).filter(|i| frame.alpha[*i] == 1.0) {
                let (x, y) = (i as u32 % WIDTH, i as u32 / WIDTH);
                let wo = to_eye(&camera, x, y);
                if wo.z < 1e-4 {
                    continue;
                }
                let [least, most] = bounds(&shape, wo, wi);
                let found = f64::from(frame.rgb[0][i]);
                let within = 0.98 * least - 1e-5 <= found && found <= 1.02 * most + 1e-5;
                assert!(
                    within,
                    "{what}, fov {:?}, pixel {x}, {y}: {found} for {least} to {most}",
                    camera.projection
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 50_000, "{compared}");
}

fn ball(shading: Shading) -> (Scene, Frame) {
    let mut scene = empty(common::camera(4.0, 30.0));
    add(&mut scene, sphere(24, 12), shiny("phong", 8.0), DMat4::from_rotation_y(0.3));
    scene.lights.push(light(LightKind::Directional { direction: DVec3::NEG_ONE }, Rgb::gray(1.0)));
    render_as(&mut scene, shading, Interpolation::Perspective);
    let options = DrawOptions { aovs: ALL_LAYERS, ..DrawOptions::new(Background::Transparent) };
    let frame = picture(&scene, 90, 70, &options);
    (scene, frame)
}

#[test]
fn the_plane_of_normals_is_there_in_every_shading() {
    let [flat, gouraud, phong] =
        [Shading::Flat, Shading::Gouraud, Shading::Phong].map(|shading| ball(shading).1);
    let normal = |frame: &Frame, i: usize| {
        DVec3::new(
            f64::from(frame.normal[0][i]),
            f64::from(frame.normal[1][i]),
            f64::from(frame.normal[2][i]),
        )
    };
    let mut seen = 0;
    for i in (0..phong.alpha.len()).filter(|i| phong.alpha[*i] > 0.0) {
        // Between vertices the normal is the same, however light is found.
        assert!((normal(&gouraud, i) - normal(&phong, i)).length() < 1e-6, "pixel {i}");
        let facet = normal(&flat, i);
        assert!((facet.length() - 1.0).abs() < 1e-6, "pixel {i}");
        // Facets of 15° turn by less than 11° to their corners.
        assert!(facet.angle_between(normal(&phong, i)).to_degrees() < 11.0, "pixel {i}");
        seen += 1;
    }
    assert!(seen > 1500, "{seen}");
    // A facet has one normal: neighbours mostly have the same.
    let same = (1..flat.alpha.len())
        .filter(|i| flat.alpha[*i] > 0.0 && normal(&flat, *i) == normal(&flat, i - 1))
        .count();
    assert!(same > seen / 2, "{same} of {seen}");
}

#[test]
fn the_plane_of_normals_changes_no_colour() {
    for shading in [Shading::Flat, Shading::Gouraud] {
        let (scene, with) = ball(shading);
        let without = picture(&scene, 90, 70, &DrawOptions::new(Background::Transparent));
        assert_eq!(with.rgb, without.rgb, "{shading:?}");
    }
}
