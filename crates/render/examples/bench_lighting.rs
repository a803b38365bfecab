//! What environments and areas cost: frames of a scene with a 1024×512 environment and four area lights.
//!
//!     cargo run --release -p glanz-render --example bench_lighting
//!
//! One JSON object per line, times in ms: the median, the least and the greatest of the frames, lamps alone, with
//! the environment, with the areas, and with both; and what preparing each takes.

#![allow(clippy::print_stdout, reason = "what a bench finds goes to the terminal")]

use std::sync::Arc;
use std::time::Instant;

use glam::{DMat3, DMat4, DVec3};
use glanz_bsdf::Shape;
use glanz_color::{Rgb, ior};
use glanz_render::{DrawOptions, Frame, PrepareOptions, View, draw, prepare};
use glanz_scene::{
    AreaShape, Background, Builtin, Camera, EnvironmentMap, Light, LightColors, LightKind, Lobe, Material,
    Object, Projection, Scene, Tint,
};

const SIZE: [u32; 2] = [1920, 1080];
const FRAMES: usize = 15;

fn main() {
    for (name, environment, areas) in [
        ("one directional light", false, 0),
        ("one directional light, environment 1024×512", true, 0),
        ("one directional light, 4 rectangles", false, 4),
        ("one directional light, environment 1024×512, 4 rectangles", true, 4),
    ] {
        measure(name, &scene(environment, areas));
    }
}

fn measure(name: &str, scene: &Scene) {
    let start = Instant::now();
    let prepared = prepare(scene, &PrepareOptions::default()).expect("the scene is whole");
    let preparing = start.elapsed().as_secs_f64() * 1e3;
    let view = View::new(&scene.camera.expect("it has a camera"), SIZE[0], SIZE[1]).expect("a view");
    let options = DrawOptions::new(Background::Color(Rgb::BLACK));
    let mut times: Vec<f64> = (0..FRAMES + 2)
        .map(|_| {
            let start = Instant::now();
            let frame: Frame = draw(&prepared, &view, &options);
            std::hint::black_box(frame);
            start.elapsed().as_secs_f64() * 1e3
        })
        .skip(2)
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "{{\"table\":\"Environments and areas, 1920×1080, all threads\",\"name\":\"{name}\",\"prepare, ms\":{preparing:.0},\
         \"ms\":{:.1},\"least\":{:.1},\"greatest\":{:.1}}}",
        times[FRAMES / 2],
        times[0],
        times[FRAMES - 1]
    );
}

/// A ball of matte and glossy gold that fills the picture's height.
fn scene(environment: bool, areas: usize) -> Scene {
    let mut lights = vec![lamp(LightKind::Directional { direction: DVec3::new(-1.0, -1.0, -1.0) })];
    if environment {
        lights.push(lamp(LightKind::Environment { map: Some(sky()), rotation: DMat3::IDENTITY }));
    }
    for i in 0..areas {
        let (sin, cos) = (i as f64 * 1.5).sin_cos();
        let position = DVec3::new(3.0 * sin, 2.0, 3.0 * cos);
        let shape = AreaShape::Rectangle { width: 1.0, height: 0.5 };
        let (direction, up) = (-position, DVec3::Y);
        lights.push(lamp(LightKind::Area { shape, position, direction, up, two_sided: false }));
    }
    let shape = |name, set: &[_]| Shape::named(name, set).expect("the model exists");
    let gold = Tint::Ior(Arc::new(ior("Au").expect("gold is there")));
    let lobes = vec![
        Lobe::new(shape("lambert", &[]), Rgb::gray(0.2)),
        Lobe::new(shape("ggx", &[("alpha", 0.2), ("multiscatter", 0.0)]), gold),
    ];
    Scene {
        meshes: vec![Builtin::Sphere { radius: 1.0, slices: 64, stacks: 32 }.mesh().expect("a sphere")],
        materials: vec![Material::of_lobes("gold", lobes)],
        lights,
        objects: vec![Object {
            name: String::new(),
            mesh: 0,
            material: 0,
            transform: DMat4::IDENTITY,
            shading: None,
            interpolation: None,
            program: None,
        }],
        camera: Some(Camera {
            eye: DVec3::new(0.0, 0.0, 3.5),
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Perspective { fov_y: 0.7 },
        }),
        ..Scene::default()
    }
}

fn lamp(kind: LightKind) -> Light {
    Light::new(kind, LightColors::direct(Rgb::WHITE))
}

fn sky() -> Arc<EnvironmentMap> {
    let (width, height) = (1024, 512);
    let pixel = |i: usize| {
        let d = EnvironmentMap::direction(
            ((i % width) as f64 + 0.5) / width as f64,
            ((i / width) as f64 + 0.5) / height as f64,
        );
        let bright = if d.dot(DVec3::new(0.5, 0.6, 0.62)) > 0.97 { 20.0 } else { 0.0 };
        [0.4 + 0.2 * d.y + bright, 0.4 + 0.3 * d.y + bright, 0.5 + 0.4 * d.y + bright].map(|c| c as f32)
    };
    Arc::new(EnvironmentMap { width, height, pixels: (0..width * height).map(pixel).collect() })
}
