//! The speed of the rasteriser on the scenes of the documentation's table, as lines of JSON.
//!
//! One sphere with a silhouette of 70 % of the picture's height, 1920×1080, Phong model, point
//! lights, drawn and developed to 8-bit RGBA: milliseconds per frame.

use std::time::Instant;

use glam::{DMat4, DVec3};
use glanz_color::Rgb;
use glanz_render::cpu::Renderer;
use glanz_render::{Develop, DrawOptions, PrepareOptions, View, prepare};
use glanz_scene::builtin::Builtin;
use glanz_scene::{
    Attenuation, Background, Camera, ClassicMaterial, Interpolation, Light, LightColors, LightKind, Object,
    Projection, Scene, Shading, Space,
};

const WIDTH: u32 = 1920;
const HEIGHT: u32 = 1080;
/// Silhouette of the sphere as a part of the height.
const SILHOUETTE: f64 = 0.7;

fn sphere_scene(slices: u32, stacks: u32, lights: usize, shading: Shading) -> Scene {
    let sphere = Builtin::Sphere { radius: 1.0, slices, stacks };
    let material = ClassicMaterial {
        ambient: Rgb([0.05, 0.01, 0.01]),
        diffuse: Rgb([0.8, 0.1, 0.1]),
        specular: Rgb::gray(0.6),
        ..ClassicMaterial::default()
    };
    let mut scene = Scene {
        meshes: vec![sphere.mesh().expect("a sphere")],
        materials: vec![material.build("red").expect("phong")],
        objects: vec![Object {
            name: "sphere".into(),
            mesh: 0,
            material: 0,
            transform: DMat4::IDENTITY,
            shading: Some(shading),
            interpolation: Some(Interpolation::Perspective),
        }],
        ..Scene::default()
    };
    for i in 0..lights {
        let angle = i as f64 * 2.399_963;
        let position = DVec3::new(3.0 * angle.cos(), 3.0 * angle.sin(), 3.5);
        scene.lights.push(Light {
            name: String::new(),
            kind: LightKind::Point { position, attenuation: Attenuation::NONE },
            colors: LightColors::direct(Rgb::gray(1.0 / lights as f32)),
            space: Space::World,
        });
    }
    // tan of the silhouette's half angle = 0.7 · tan(fov / 2), and sin of it = 1 / distance.
    let fov_y = 40f64.to_radians();
    let half = (SILHOUETTE * (0.5 * fov_y).tan()).atan();
    scene.camera = Some(Camera {
        eye: DVec3::new(0.0, 0.0, 1.0 / half.sin()),
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: Projection::Perspective { fov_y },
    });
    scene
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let quick = arguments.iter().any(|a| a == "--quick");
    // `--only "64x32 phong 1"` measures the rows whose name begins so.
    let only = arguments.iter().skip_while(|a| *a != "--only").nth(1).cloned().unwrap_or_default();
    let level = glanz_math::simd_level(std::env::var("GLANZ_SIMD").ok().as_deref()).expect("a level");
    for (slices, stacks) in [(64, 32), (1024, 512)] {
        for (shading, name) in [(Shading::Phong, "phong"), (Shading::Gouraud, "gouraud")] {
            for lights in [1, 4, 8] {
                if !format!("{slices}x{stacks} {name} {lights}").starts_with(&only) {
                    continue;
                }
                let frames = if quick { 40 } else { 200 };
                let (median, min, high, prepare_ms) = measure(slices, stacks, lights, shading, frames, level);
                println!(
                    "{{\"bench\":\"draw\",\"slices\":{slices},\"stacks\":{stacks},\"shading\":\"{name}\",\
                     \"lights\":{lights},\"threads\":{},\"median_ms\":{median:.3},\"min_ms\":{min:.3},\
                     \"p90_ms\":{high:.3},\"prepare_ms\":{prepare_ms:.1}}}",
                    rayon::current_num_threads()
                );
            }
        }
    }
}

fn measure(
    slices: u32,
    stacks: u32,
    lights: usize,
    shading: Shading,
    frames: usize,
    level: fearless_simd::Level,
) -> (f64, f64, f64, f64) {
    let scene = sphere_scene(slices, stacks, lights, shading);
    let start = Instant::now();
    let prepared = prepare(&scene, &PrepareOptions::default()).expect("a sound scene");
    let prepare_ms = start.elapsed().as_secs_f64() * 1e3;
    let view = View::new(&scene.camera.expect("a camera"), WIDTH, HEIGHT).expect("a sound view");
    let mut options = DrawOptions::new(Background::Color(Rgb([0.05, 0.05, 0.08])));
    options.level = level;
    let mut renderer = Renderer::new();
    let mut out = vec![0u8; (WIDTH * HEIGHT * 4) as usize];
    let mut times = Vec::with_capacity(frames);
    for frame in 0..frames + 5 {
        let start = Instant::now();
        renderer.draw_rgba8(&prepared, &view, &options, &Develop::default(), &mut out);
        if frame >= 5 {
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    if let Ok(path) = std::env::var("BENCH_PICTURE") {
        let mut ppm = format!("P6 {WIDTH} {HEIGHT} 255\n").into_bytes();
        ppm.extend(out.chunks(4).flat_map(|p| [p[0], p[1], p[2]]));
        std::fs::write(path, ppm).expect("a picture");
    }
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], times[0], times[times.len() * 9 / 10], prepare_ms)
}
