//! Light from areas and from all around against numerical integration, and what stands in its way.
//!
//! The integrals are sums over many small lights in `f64`, written without any of the crate's own machinery but
//! the shapes themselves.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../common/mod.rs"]
mod common;

mod areas;
mod environments;
mod exact;
mod measured;
mod panes;
mod shadows;

use common::{add, empty, picture, rectangle, transparent};
use glam::{DMat4, DVec3};
use glanz_bsdf::{DirectionPair, Shape};
use glanz_color::Rgb;
use glanz_math::Vec3;
use glanz_render::{Change, PrepareOptions, Prepared, View, draw, prepare};
use glanz_scene::{Camera, Light, LightColors, LightKind, Lobe, Material, Projection, Scene};

/// A shape by name, with parameters.
fn shape(name: &str, set: &[(&str, f64)]) -> Shape {
    Shape::named(name, set).unwrap()
}

/// The lobes that errors are stated for.
fn lobes() -> Vec<(&'static str, Shape)> {
    vec![
        ("lambert", shape("lambert", &[])),
        ("oren-nayar 30°", shape("oren-nayar", &[("sigma_deg", 30.0)])),
        ("phong-normalized 20", shape("phong-normalized", &[("shininess", 20.0)])),
        ("ggx .1", shape("ggx", &[("alpha", 0.1)])),
        ("ggx .3", shape("ggx", &[("alpha", 0.3)])),
        ("ggx .6", shape("ggx", &[("alpha", 0.6)])),
        ("cook-torrance .2", shape("cook-torrance", &[("m", 0.2)])),
        ("ward .15", shape("ward", &[("alpha", 0.15)])),
        ("lambert-transmission", shape("lambert-transmission", &[])),
    ]
}

/// A white surface of one lobe at the origin that faces +Z, seen at an angle from the normal towards +X.
fn surface(shape: &Shape, degrees: f64) -> Scene {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let mut scene = empty(camera_at(DVec3::new(sin, 0.0, cos)));
    let material = Material::of_lobes("lobe", vec![Lobe::new(shape.clone(), Rgb::WHITE)]);
    add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), material, DMat4::IDENTITY);
    scene
}

/// A camera that looks at the origin from a direction.
fn camera_at(direction: DVec3) -> Camera {
    Camera {
        eye: direction * 10.0,
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Orthographic { height: 1e-4 },
    }
}

/// The value of the surface in the middle of the picture.
fn value(scene: &Scene) -> f64 {
    f64::from(picture(scene, 1, 1, &transparent()).rgb[0][0])
}

/// The value of a prepared surface for a viewer in a direction.
fn value_from(prepared: &Prepared, wo: Vec3<f64>) -> f64 {
    let camera = camera_at(DVec3::new(wo.x, wo.y, wo.z));
    let view = View::new(&camera, 1, 1).unwrap();
    f64::from(draw(prepared, &view, &transparent()).rgb[0][0])
}

/// A light of value 1.
fn white(kind: LightKind) -> Light {
    Light::new(kind, LightColors::direct(Rgb::WHITE))
}

/// f_cos of the surface's view and a light in a direction of the world.
fn lobe_value(shape: &Shape, degrees: f64, light: DVec3) -> f64 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    shape.f_cos(&DirectionPair::new(Vec3::new(sin, 0.0, cos), Vec3::new(light.x, light.y, light.z)))
}

/// The greatest error of a lobe, in parts of a scale, with the place.
#[derive(Default)]
struct Worst(f64, String);

impl Worst {
    fn note(&mut self, error: f64, place: impl FnOnce() -> String) {
        if error.abs() > self.0 {
            *self = Self(error.abs(), place());
        }
    }
}
