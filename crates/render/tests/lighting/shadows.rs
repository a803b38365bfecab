//! What stands in the way of light, and luminaires.

use std::sync::Arc;

use common::pixel_camera;
use glanz_scene::{Attenuation, Luminaire, Profile};

use super::*;

/// A floor of 16×16 m at z = 0 under a square of 4 m at z = 2, seen from straight above with a pixel per metre.
fn table_over_floor(light: LightKind, shadows: bool) -> Vec<f32> {
    let mut scene = empty(pixel_camera(16, 16));
    let white_matte = || Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::WHITE)]);
    add(&mut scene, rectangle([0.0, 0.0, 16.0, 16.0], 0.0), white_matte(), DMat4::IDENTITY);
    add(&mut scene, rectangle([6.0, 6.0, 10.0, 10.0], 2.0), white_matte(), DMat4::IDENTITY);
    scene.lights.push(white(light));
    scene.render.shadows = shadows;
    picture(&scene, 16, 16, &transparent()).rgb[0].clone()
}

fn at(plane: &[f32], x: usize, y: usize) -> f32 {
    plane[(15 - y) * 16 + x]
}

#[test]
fn a_shadow_ends_where_the_edge_of_what_casts_it_is_projected() {
    // Light at 45° from −X: the shadow of x = 6 … 10 at a height of 2 is x = 8 … 12.
    let slanted = LightKind::Directional { direction: DVec3::new(1.0, 0.0, -1.0) };
    let shadowed = table_over_floor(slanted.clone(), true);
    let free = table_over_floor(slanted, false);
    for (x, dark) in [(4, false), (10, true), (11, true), (12, false)] {
        assert_eq!(at(&shadowed, x, 8) == 0.0, dark, "{x}");
        assert!(at(&free, x, 8) > 0.5);
    }
    assert_eq!(at(&shadowed, 8, 8), at(&free, 8, 8), "the table itself is lit");
    assert_eq!(at(&shadowed, 11, 4), at(&free, 11, 4), "beside the shadow nothing changes");
}

#[test]
fn a_lamp_below_casts_no_shadow_upwards_and_one_above_a_larger_one() {
    let lamp =
        |z: f64| LightKind::Point { position: DVec3::new(8.0, 8.0, z), attenuation: Attenuation::NONE };
    let between = table_over_floor(lamp(1.0), true);
    assert!(at(&between, 8, 8) == 0.0, "the table's upper side is turned away");
    assert!(at(&between, 4, 8) > 0.0);
    // From 4 m the shadow on the floor is twice as large: 4 … 12.
    let above = table_over_floor(lamp(4.0), true);
    for (x, dark) in [(3, false), (4, true), (11, true), (12, false)] {
        assert_eq!(at(&above, x, 8) == 0.0, dark, "{x}");
    }
}

#[test]
fn a_sphere_does_not_shadow_its_own_lit_side() {
    let mut scene = empty(common::camera(6.0, 30.0));
    let matte = Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::WHITE)]);
    add(&mut scene, common::sphere(64, 32), matte, DMat4::IDENTITY);
    scene.lights.push(white(LightKind::Directional { direction: DVec3::new(-1.0, -1.0, -1.0) }));
    let plain = picture(&scene, 64, 64, &transparent());
    scene.render.shadows = true;
    let shadowed = picture(&scene, 64, 64, &transparent());
    // Within a step of facets from the terminator the flat facets are turned away already.
    let clear = plain.rgb[0].iter().zip(&shadowed.rgb[0]).filter(|(plain, _)| **plain > 0.12);
    assert!(clear.clone().count() > 500);
    assert!(clear.clone().all(|(plain, shadowed)| plain == shadowed));
}

#[test]
fn flat_things_do_not_shadow_themselves_along_their_seams() {
    let mut scene = empty(common::camera(5.0, 20.0));
    let matte = Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::WHITE)]);
    let turned = DMat4::from_axis_angle(DVec3::new(1.0, 1.0, 0.3).normalize(), 0.6);
    add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), matte, turned);
    scene.lights.push(white(LightKind::Directional { direction: DVec3::new(0.3, -0.2, -1.0) }));
    for samples in [1, 2, 4, 16] {
        let plain = picture(&scene, 80, 60, &common::sampled(samples));
        scene.render.shadows = true;
        let shadowed = picture(&scene, 80, 60, &common::sampled(samples));
        scene.render.shadows = false;
        assert_eq!(plain.rgb[0], shadowed.rgb[0], "{samples} samples");
    }
}

#[test]
fn a_luminaire_sends_what_its_profile_says() {
    let profile = Arc::new(Profile {
        c_deg: vec![0.0],
        gamma_deg: vec![0.0, 45.0, 90.0, 180.0],
        candela: vec![100.0, 400.0, 0.0, 0.0],
    });
    let mut scene = empty(pixel_camera(16, 16));
    let matte = Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::WHITE)]);
    add(&mut scene, rectangle([0.0, 0.0, 16.0, 16.0], 0.0), matte, DMat4::IDENTITY);
    let position = DVec3::new(0.5, 8.5, 4.0);
    let mut lamp = white(LightKind::Point { position, attenuation: Attenuation::NONE });
    let axis = DVec3::NEG_Z;
    lamp.luminaire = Some(Luminaire { profile: Arc::clone(&profile), axis, c0: Luminaire::c0_for(axis) });
    scene.lights.push(lamp);
    let plane = picture(&scene, 16, 16, &transparent()).rgb[0].clone();
    for x in [0usize, 2, 4, 9] {
        let gamma = (x as f64 / 4.0).atan();
        let expected = profile.at(0.0, gamma.to_degrees()) / 400.0 * gamma.cos();
        let got = f64::from(at(&plane, x, 8));
        assert!((got - expected).abs() < 1e-3, "{x}: {got} for {expected}");
    }
}

/// A ball on a table of 4 m, in the sun.
fn ball_on_a_table() -> Scene {
    let mut scene = empty(common::camera(9.0, 40.0));
    scene.camera = scene.camera.map(|camera| Camera { eye: DVec3::new(2.0, 5.0, 6.0), ..camera });
    let matte = || Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::gray(0.8))]);
    add(&mut scene, common::sphere(48, 24), matte(), DMat4::from_translation(DVec3::Y * 1.01));
    let plane = common::builtin(glanz_scene::Builtin::Plane);
    add(&mut scene, plane, matte(), DMat4::from_scale(DVec3::splat(4.0)));
    scene.lights.push(white(LightKind::Directional { direction: DVec3::new(-1.0, -1.5, -0.5) }));
    scene.render.shadows = true;
    scene
}

/// Pixels that are in light in one picture and not in the other.
fn flipped(a: &Scene, b: &Scene) -> usize {
    let drawn = |scene: &Scene| picture(scene, 160, 120, &transparent());
    let (a, b) = (drawn(a), drawn(b));
    (0..160 * 120).filter(|i| (a.rgb[0][*i] > 0.0) != (b.rgb[0][*i] > 0.0)).count()
}

#[test]
fn shadows_stay_where_something_large_is_far_away() {
    let near = ball_on_a_table();
    let mut dark = near.clone();
    dark.render.shadows = false;
    assert!(flipped(&near, &dark) > 300, "the ball has a shadow");
    for distance in [1e4, 1e6, 1e9] {
        let mut scene = near.clone();
        let matte = Material::of_lobes("matte", vec![Lobe::new(shape("lambert", &[]), Rgb::gray(0.8))]);
        let place = DVec3::new(0.2, 0.0, -0.9) * distance;
        let hill = DMat4::from_translation(place) * DMat4::from_scale(DVec3::splat(1e-3 * distance));
        add(&mut scene, common::builtin(glanz_scene::Builtin::Cube { size: 1.0 }), matte, hill);
        assert!(flipped(&near, &scene) <= 4, "at {distance} m: {}", flipped(&near, &scene));
    }
}

#[test]
fn shadows_stay_on_grounds_of_any_size() {
    let near = ball_on_a_table();
    let visible = |scene: &Scene| {
        let frame = picture(scene, 160, 120, &transparent());
        (0..160 * 120).map(|i| frame.rgb[0][i] == 0.0 && frame.alpha[i] > 0.0).collect::<Vec<_>>()
    };
    let expected = visible(&near).iter().filter(|dark| **dark).count();
    for size in [1e2, 1e4, 1e6] {
        let mut scene = near.clone();
        scene.objects[1].transform = DMat4::from_scale(DVec3::splat(size));
        let dark = visible(&scene).iter().filter(|dark| **dark).count();
        // The shadow does not end at the table's edge.
        assert!(dark >= expected && dark < expected + 800, "{size}: {dark} for {expected}");
    }
}
