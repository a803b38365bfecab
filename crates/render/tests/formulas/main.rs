//! Pixels of drawn pictures equal the documents' formulas, computed here in `f64` from the scene: for
//! every kind of light, model and shading.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../common/mod.rs"]
mod common;
mod reference;

use common::{camera, empty, render_as, sphere, transparent};
use glam::{DMat4, DQuat, DVec3};
use glanz_color::Rgb;
use glanz_render::{PrepareOptions, Prepared, View, draw, prepare};
use glanz_scene::{
    Attenuation, Builtin, Camera, ClassicMaterial, Interpolation, Light, LightColors, LightKind, Mesh,
    Projection, Scene, Shading, Space,
};
use reference::{Lighting, Reference};

/// What the task asks for, in linear RGB; above 1 it is relative, as the resolution of `f32` is.
const TOLERANCE: f64 = 1e-5;
const WIDTH: usize = 40;
const HEIGHT: usize = 30;
const MODELS: [&str; 5] = ["lambert", "phong", "phong-normalized", "blinn-phong", "blinn-phong-normalized"];
const SHADINGS: [Shading; 3] = [Shading::Flat, Shading::Gouraud, Shading::Phong];

fn material(model: &str, shininess: f64) -> ClassicMaterial {
    ClassicMaterial {
        ambient: Rgb([0.3, 0.1, 0.2]).into(),
        diffuse: Rgb([0.5, 0.2, 0.1]).into(),
        specular: Rgb([0.3, 0.4, 0.35]).into(),
        emission: Rgb([0.01, 0.02, 0.03]).into(),
        shininess,
        model: model.into(),
        ..ClassicMaterial::default()
    }
}

fn light(kind: LightKind, space: Space) -> Light {
    let colors = LightColors {
        ambient: Rgb([0.25, 0.5, 0.125]).into(),
        diffuse: Rgb([0.6, 0.5, 0.4]).into(),
        specular: Rgb([0.4, 0.6, 0.7]).into(),
    };
    Light { space, ..Light::new(kind, colors) }
}

fn point(constant: f64, linear: f64, quadratic: f64) -> LightKind {
    let position = DVec3::new(1.31, 1.73, 2.37);
    LightKind::Point { position, attenuation: Attenuation { constant, linear, quadratic } }
}

fn spot(cutoff_deg: f64, exponent: f64, attenuation: Attenuation) -> LightKind {
    LightKind::Spot {
        position: DVec3::new(-1.17, 1.39, 2.63),
        direction: DVec3::new(1.0, -1.1, -2.2),
        cutoff: cutoff_deg.to_radians(),
        exponent,
        smooth_edge: None,
        attenuation,
    }
}

/// Every kind of light, with every form of attenuation, in the world and on the camera.
fn lights() -> Vec<(&'static str, Light)> {
    let directional = LightKind::Directional { direction: DVec3::new(-0.7, -1.3, -1.9) };
    let on_camera =
        LightKind::Point { position: DVec3::new(0.53, 0.47, 0.21), attenuation: Attenuation::NONE };
    let fading = Attenuation { constant: 0.5, linear: 0.25, quadratic: 0.125 };
    vec![
        ("ambient", light(LightKind::Ambient, Space::World)),
        ("directional", light(directional.clone(), Space::World)),
        ("directional on the camera", light(directional, Space::Camera)),
        ("point", light(point(1.0, 0.0, 0.0), Space::World)),
        ("point, constant 2", light(point(2.0, 0.0, 0.0), Space::World)),
        ("point, linear", light(point(0.0, 0.5, 0.0), Space::World)),
        ("point, quadratic", light(point(0.0, 0.0, 0.25), Space::World)),
        ("point, all three", light(point(0.5, 0.25, 0.125), Space::World)),
        ("point on the camera", light(on_camera, Space::Camera)),
        ("spot of 15 degrees", light(spot(15.0, 8.0, Attenuation::NONE), Space::World)),
        ("wide fading spot", light(spot(60.0, 1.5, fading), Space::World)),
        ("spot without falloff", light(spot(20.0, 0.0, Attenuation::NONE), Space::World)),
        ("spot in all directions", light(spot(180.0, 1.0, Attenuation::PHYSICAL), Space::World)),
        ("spot on the camera", light(spot(25.0, 2.0, Attenuation::NONE), Space::Camera)),
    ]
}

/// An object to be drawn, and what its pixels see.
struct Stage {
    scene: Scene,
    reference: Reference,
    two_sided: bool,
}

impl Stage {
    fn new(mesh: Mesh, camera: Camera, transform: DMat4) -> Self {
        let mut scene = empty(camera);
        common::add(&mut scene, mesh, material("phong", 8.0).build("").unwrap(), transform);
        let reference = Reference::new(&scene, WIDTH, HEIGHT);
        assert!(reference.hits.len() > WIDTH * HEIGHT / 8, "only {} pixels to compare", reference.hits.len());
        Self { scene, reference, two_sided: true }
    }

    fn prepared(&mut self, lighting: &Lighting) -> Prepared {
        self.scene.lights = lighting.lights.to_vec();
        self.scene.materials[0] = lighting.material.build("").unwrap();
        self.scene.materials[0].two_sided = lighting.two_sided;
        render_as(&mut self.scene, lighting.shading, lighting.interpolation);
        prepare(&self.scene, &PrepareOptions::default()).unwrap()
    }

    /// Draws, and compares every pixel that the reference can tell.
    fn compare(&mut self, what: &str, lighting: &Lighting) {
        let prepared = self.prepared(lighting);
        let view = View::new(&self.scene.camera.unwrap(), WIDTH as u32, HEIGHT as u32).unwrap();
        let frame = draw(&prepared, &view, &transparent());
        let mut compared = 0;
        for hit in &self.reference.hits {
            let Some(expected) = self.reference.color(hit, lighting) else { continue };
            compared += 1;
            let (x, y) = (hit.pixel % WIDTH, hit.pixel / WIDTH);
            let found = frame.pixel(x, y);
            for c in 0..3 {
                let error = (f64::from(found[c]) - expected[c]).abs();
                assert!(
                    error <= TOLERANCE * expected[c].max(1.0),
                    "{what}, {:?}, {}: channel {c} of pixel {x}, {y} is {} for {}",
                    lighting.shading,
                    lighting.material.model,
                    found[c],
                    expected[c]
                );
            }
            assert_eq!(found[3], 1.0, "{what}: pixel {x}, {y} is covered");
        }
        let usual = self.reference.hits.len() * 3 / 4;
        assert!(compared > usual, "{what}: only {compared} pixels compared, expected {usual}");
    }

    /// All models and shadings under these lights.
    fn compare_all(&mut self, what: &str, lights: &[Light], interpolation: Interpolation, shininess: f64) {
        for shading in SHADINGS {
            for model in MODELS {
                let material = &material(model, shininess);
                let two_sided = self.two_sided;
                self.compare(what, &Lighting { lights, material, two_sided, shading, interpolation });
            }
        }
    }
}

fn a_sphere() -> Stage {
    Stage::new(sphere(12, 7), camera(3.1, 42.0), DMat4::IDENTITY)
}

/// Turned, so that perspective and screen-linear interpolation differ.
fn a_quad() -> Stage {
    let turn = DMat4::from_quat(DQuat::from_rotation_y(0.6) * DQuat::from_rotation_x(-0.4));
    Stage::new(common::builtin(Builtin::Quad), camera(3.0, 45.0), turn)
}

#[test]
fn a_sphere_equals_the_formulas_under_every_light() {
    let mut stage = a_sphere();
    for (name, light) in lights() {
        stage.compare_all(name, &[light], Interpolation::Perspective, 8.0);
    }
}

#[test]
fn a_quad_equals_the_formulas_under_every_light() {
    let mut stage = a_quad();
    for (name, light) in lights() {
        stage.compare_all(name, &[light], Interpolation::Perspective, 8.0);
    }
}

#[test]
fn exponents_from_1_to_32_equal_the_formulas() {
    let (mut ball, mut quad) = (a_sphere(), a_quad());
    let light = light(point(1.0, 0.0, 0.0), Space::World);
    for shininess in [1.0, 2.0, 5.0, 16.0, 32.0] {
        ball.compare_all("sphere", core::slice::from_ref(&light), Interpolation::Perspective, shininess);
        quad.compare_all("quad", core::slice::from_ref(&light), Interpolation::Perspective, shininess);
    }
}

#[test]
fn screen_linear_interpolation_equals_the_formulas() {
    let (mut ball, mut quad) = (a_sphere(), a_quad());
    for (name, light) in lights().into_iter().filter(|(_, light)| light.space == Space::World) {
        ball.compare_all(name, core::slice::from_ref(&light), Interpolation::ScreenLinear, 8.0);
        quad.compare_all(name, core::slice::from_ref(&light), Interpolation::ScreenLinear, 8.0);
    }
}

#[test]
fn lights_add_up() {
    let all: Vec<Light> = lights().into_iter().map(|(_, light)| light).collect();
    a_sphere().compare_all("all lights", &all, Interpolation::Perspective, 8.0);
    a_quad().compare_all("all lights", &all, Interpolation::Perspective, 8.0);
}

#[test]
fn parallel_projection_equals_the_formulas() {
    let camera = Camera {
        eye: DVec3::new(2.0, 1.0, 3.0),
        target: DVec3::new(0.1, 0.0, 0.0),
        up: DVec3::new(0.1, 1.0, 0.0),
        projection: Projection::Orthographic { height: 2.3 },
    };
    let mut ball = Stage::new(sphere(12, 7), camera, DMat4::IDENTITY);
    let mut quad = Stage::new(common::builtin(Builtin::Quad), camera, DMat4::from_rotation_x(0.3));
    for (name, light) in lights() {
        ball.compare_all(name, core::slice::from_ref(&light), Interpolation::Perspective, 4.0);
        quad.compare_all(name, core::slice::from_ref(&light), Interpolation::ScreenLinear, 4.0);
    }
}

#[test]
fn back_faces_are_turned_to_the_viewer_or_get_ambient_light_only() {
    let turn = DMat4::from_quat(DQuat::from_rotation_y(2.6) * DQuat::from_rotation_x(-0.4));
    let mut stage = Stage::new(common::builtin(Builtin::Quad), camera(3.0, 45.0), turn);
    assert!(stage.reference.hits.iter().all(|hit| hit.back));
    for (name, light) in lights() {
        for two_sided in [true, false] {
            stage.two_sided = two_sided;
            let what = format!("{name}, two-sided: {two_sided}");
            stage.compare_all(&what, core::slice::from_ref(&light), Interpolation::Perspective, 8.0);
        }
    }
}

#[test]
fn the_inside_of_a_sphere_equals_the_formulas() {
    let camera = Camera { eye: DVec3::new(0.1, 0.2, 0.3), ..camera(1.0, 80.0) };
    let mut stage = Stage::new(sphere(12, 7), camera, DMat4::IDENTITY);
    let kind = LightKind::Point { position: DVec3::new(0.3, 0.2, 0.4), attenuation: Attenuation::NONE };
    stage.compare_all("inside", &[light(kind, Space::World)], Interpolation::Perspective, 8.0);
}

#[test]
fn normals_are_right_under_uneven_and_mirroring_scale() {
    let turn = DQuat::from_rotation_z(0.5) * DQuat::from_rotation_x(0.8);
    for scale in [DVec3::new(1.3, 0.5, 0.8), DVec3::new(-1.2, 0.6, 0.9), DVec3::new(-0.7, -1.0, -1.1)] {
        let place = DMat4::from_scale_rotation_translation(scale, turn, DVec3::new(0.1, -0.05, 0.1));
        let mut ball = Stage::new(sphere(12, 7), camera(3.1, 42.0), place);
        assert!(ball.reference.hits.iter().all(|hit| !hit.back));
        let mut quad = Stage::new(common::builtin(Builtin::Quad), camera(3.0, 45.0), place);
        for (name, light) in lights().into_iter().step_by(3) {
            let what = format!("{name}, scale {scale}");
            ball.compare_all(&what, core::slice::from_ref(&light), Interpolation::Perspective, 4.0);
            quad.compare_all(&what, core::slice::from_ref(&light), Interpolation::Perspective, 4.0);
        }
    }
}

#[test]
fn far_from_the_origin_pixels_are_the_same() {
    // A position that f32 alone would round to half a metre.
    let far = DVec3::new(4e6, -3e6, 2e6);
    let camera = Camera { eye: camera(3.1, 42.0).eye + far, target: far, ..camera(3.1, 42.0) };
    let mut stage = Stage::new(sphere(12, 7), camera, DMat4::from_translation(far));
    let direction = DVec3::new(-0.7, -1.3, -1.9);
    let light = light(LightKind::Directional { direction }, Space::World);
    stage.compare_all("far away", &[light], Interpolation::Perspective, 4.0);
}
