//! How far the eye sees, and how near: depth depends on nothing that is not looked at.

mod common;

use common::{ALL_LAYERS, add, camera, empty, glow, picture, rectangle, shiny, sphere};
use glam::{DMat4, DVec3};
use glanz_color::Rgb;
use glanz_picture::Frame;
use glanz_render::DrawOptions;
use glanz_scene::{Background, Scene};

fn drawn(scene: &Scene, width: u32, height: u32) -> Frame {
    picture(
        scene,
        width,
        height,
        &DrawOptions { aovs: ALL_LAYERS, ..DrawOptions::new(Background::Transparent) },
    )
}

fn bits(frame: &Frame) -> Vec<u32> {
    let planes = frame.rgb.iter().chain([&frame.alpha, &frame.depth]).chain(&frame.normal);
    planes.flatten().map(|value| value.to_bits()).collect()
}

#[test]
fn a_far_object_changes_nothing_near() {
    for far in [1e4, 1e6, 1e9, 1e12] {
        let mut scene = empty(camera(4.0, 45.0));
        add(&mut scene, sphere(32, 16), shiny("phong", 20.0), DMat4::IDENTITY);
        let alone = bits(&drawn(&scene, 80, 60));
        // Beside the picture, and behind the sphere.
        for at in [DVec3::new(far, 0.0, -0.1 * far), DVec3::new(0.0, 0.0, -far)] {
            let mut both = scene.clone();
            add(&mut both, sphere(8, 4), glow(Rgb::gray(1.0)), DMat4::from_translation(at));
            assert!(bits(&drawn(&both, 80, 60)) == alone, "an object at {at} changes the picture");
        }
    }
}

#[test]
fn ground_is_seen_from_the_feet_to_the_horizon() {
    // From 1.7 m above a plane of 2000 km, horizontally: the lower half of the picture is ground.
    const EYE: f64 = 1.7;
    let mut scene = empty(camera(1.0, 60.0));
    let place = DMat4::from_translation(DVec3::new(0.0, -EYE, 1.0))
        * DMat4::from_rotation_x(-core::f64::consts::FRAC_PI_2);
    add(&mut scene, rectangle([-1e6, -1e6, 1e6, 1e6], 0.0), glow(Rgb::gray(1.0)), place);
    let (width, height) = (64, 120);
    let frame = drawn(&scene, width, height);
    let per_unit = 0.5 * f64::from(height) / (30f64.to_radians()).tan();
    for row in 0..height {
        let below = f64::from(row) + 0.5 - 0.5 * f64::from(height);
        for column in 0..width {
            let pixel = (row * width + column) as usize;
            assert_eq!(frame.object[pixel], u32::from(below > 0.0), "row {row}");
            if below > 0.0 {
                let expected = EYE * per_unit / below;
                let found = f64::from(frame.depth[pixel]);
                assert!((found / expected - 1.0).abs() < 1e-4, "row {row}: {found} for {expected} m");
            }
        }
    }
}

#[test]
fn nothing_is_too_near_to_be_seen() {
    // A square before the eye, twice as large as what the eye sees at its distance.
    for distance in [1e-12, 1e-9, 1e-6, 1e-3, 1.0] {
        let mut scene = empty(camera(distance, 90.0));
        let half = 2.0 * distance as f32;
        add(&mut scene, rectangle([-half, -half, half, half], 0.0), glow(Rgb::gray(1.0)), DMat4::IDENTITY);
        add(
            &mut scene,
            sphere(8, 4),
            glow(Rgb::gray(0.5)),
            DMat4::from_translation(DVec3::new(0.0, 0.0, -1e3)),
        );
        let frame = drawn(&scene, 20, 20);
        let expected = distance as f32;
        let right = |d: &f32| (d / expected - 1.0).abs() < 1e-5;
        assert!(frame.depth.iter().all(right), "at {distance} m: {:?}", &frame.depth[..3]);
    }
}
