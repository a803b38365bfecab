//! The hard rim of a spot's cone is as smooth as the edge of a surface, and what a pixel's probe tells is the pixel.

#![allow(clippy::expect_used, reason = "a test")]

use glanz_render::{Frame, Samples, Shot, ShotOptions, glam};
use glanz_scene::{Attenuation, Camera, Light, LightColors, LightKind, Material, Mesh, Scene};

/// A floor that fills the picture, and a spot that lights a part of it.
fn scene(cutoff_deg: f64, exponent: f64) -> Scene {
    let spot = LightKind::Spot {
        position: glam::DVec3::new(0.4, 2.0, 0.3),
        direction: glam::DVec3::new(-0.2, -1.0, 0.1),
        cutoff: cutoff_deg.to_radians(),
        exponent,
        smooth_edge: None,
        attenuation: Attenuation::NONE,
    };
    let floor = Mesh::builtin("plane").expect("it is in the list");
    let mut scene = Scene::new().with_mesh(floor, Material::default_gray()).with_size(96, 72);
    scene.objects[0].transform = glam::DMat4::from_scale(glam::DVec3::splat(40.0));
    scene.lights.push(Light::new(spot, LightColors::direct([1.0; 3])));
    scene.camera = Some(Camera::new([0.0, 2.0, 3.0], [0.0, 0.0, 0.0]));
    scene
}

fn shot(scene: &Scene, samples: Samples, supersample: bool) -> Shot {
    let mut options = ShotOptions::of(scene).expect("it can be drawn");
    (options.draw.samples, options.draw.supersample) = (samples, supersample);
    Shot::with(scene, options).expect("it can be drawn")
}

fn frame(scene: &Scene, samples: Samples, supersample: bool) -> Frame {
    shot(scene, samples, supersample).frame().expect("it is drawn")
}

/// Of the red plane: the root of the mean squared difference, and the greatest.
fn apart(a: &Frame, b: &Frame) -> (f32, f32) {
    let differences = || a.rgb[0].iter().zip(&b.rgb[0]).map(|(a, b)| (a - b).abs());
    let mean = differences().map(|d| d * d).sum::<f32>() / a.rgb[0].len() as f32;
    (mean.sqrt(), differences().fold(0.0, f32::max))
}

#[test]
fn a_hard_rim_is_that_of_many_samples() {
    for (cutoff, exponent) in [(15.0, 0.0), (25.0, 8.0)] {
        let scene = scene(cutoff, exponent);
        let right = frame(&scene, Samples::Sixteen, true);
        let most = right.rgb[0].iter().copied().fold(0.0, f32::max);
        let (hard, _) = apart(&frame(&scene, Samples::One, false), &right);
        let (smooth, worst) = apart(&frame(&scene, Samples::Four, false), &right);
        assert!(hard > 0.01 * most, "the rim is in the picture: {hard} of {most}");
        assert!(smooth < 0.25 * hard, "cutoff {cutoff}: {smooth} instead of {hard}");
        assert!(worst < 0.2 * most, "cutoff {cutoff}: {worst} of {most}");
    }
}

#[test]
fn a_cone_of_half_a_turn_is_a_point_light() {
    let spot = scene(180.0, 0.0);
    let mut point = spot.clone();
    let position = glam::DVec3::new(0.4, 2.0, 0.3);
    point.lights[0].kind = LightKind::Point { position, attenuation: Attenuation::NONE };
    assert_eq!(frame(&spot, Samples::Four, false).rgb, frame(&point, Samples::Four, false).rgb);
}

#[test]
fn the_probe_of_a_pixel_on_the_rim_is_the_pixel() {
    let mut shot = shot(&scene(20.0, 2.0), Samples::Four, false);
    let picture = shot.frame().expect("it is drawn");
    let (mut partly, mut edges) = (0, 0);
    let places = (0..96).flat_map(|x| [20, 28, 36, 44, 52].map(|y| (x, y)));
    for (x, y) in places {
        let probe = shot.probe(x, y).expect("it is in the picture");
        let surface = probe.surface.expect("the floor is everywhere");
        let [light, middle] = [surface.light[0], probe.middle[0]];
        assert!((light - middle).abs() <= 1e-6, "{x} {y}: {light} for {middle}");
        edges += u32::from((light - picture.rgb[0][(y * 96 + x) as usize]).abs() > 1e-6);
        let cone = surface.points[0].lights[0].arrival.expect("of a lamp").cone.expect("of a spot");
        partly += u32::from(cone > 0.0 && cone < 20_f32.to_radians().cos().powi(2) * 0.98);
    }
    // A pixel on the diagonal between the triangles is shaded once for each of them.
    assert!(edges <= 5, "the picture is that of the middles of its pixels: {edges}");
    assert!(partly >= 4, "the rows cross the rim: {partly}");
}
