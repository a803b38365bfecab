//! The speed of the rasteriser on the scenes of the documentation's table, as lines of JSON.
//!
//! One sphere with a silhouette of 70 % of the picture's height, 1920×1080, Phong model, point
//! lights, drawn and developed to 8-bit RGBA: milliseconds per frame.

#![expect(clippy::print_stdout, reason = "its output is its purpose")]

mod read_back;

use std::collections::HashMap;
use std::sync::Arc;
use std::time::Instant;

use fearless_simd::Simd;
use glam::{DMat4, DVec3};
use glanz_bsdf::{DirectionPair, LightTerm, MODELS, ModelInfo, Shape};
use glanz_color::Rgb;
use glanz_math::{Lanes, SimdLevel, at_level};
use glanz_render::cpu::Renderer;
use glanz_render::{
    Backend, Change, Develop, DrawOptions, Observation, PrepareOptions, Prepared, View, prepare,
};
use glanz_scene::builtin::Builtin;
use glanz_scene::{
    Attenuation, Background, Camera, ClassicMaterial, ColorMode, Interpolation, Light, LightColor,
    LightColors, LightKind, Lobe, Material, Object, Projection, Scene, Shading, Tint, White,
};

const WIDTH: u32 = 1920;
const HEIGHT: u32 = 1080;
/// Silhouette of the sphere as a part of the height.
const SILHOUETTE: f64 = 0.7;

fn sphere_scene(slices: u32, stacks: u32, lights: usize, shading: Shading) -> Scene {
    let sphere = Builtin::Sphere { radius: 1.0, slices, stacks };
    let material = ClassicMaterial {
        ambient: Rgb([0.05, 0.01, 0.01]).into(),
        diffuse: Rgb([0.8, 0.1, 0.1]).into(),
        specular: Rgb::gray(0.6).into(),
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
            program: None,
        }],
        ..Scene::default()
    };
    for i in 0..lights {
        // Where the peers have them: on a ring before the sphere.
        let angle = core::f64::consts::TAU * (i as f64 + 0.125) / lights as f64;
        let position = DVec3::new(3.0 * angle.cos(), 3.0 * angle.sin(), 3.0);
        let kind = LightKind::Point { position, attenuation: Attenuation::NONE };
        let colors = LightColors::direct(Rgb::gray(1.0 / lights as f32));
        scene.lights.push(Light::new(kind, colors));
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

/// What the command line asks for.
struct Options {
    /// Fewer frames.
    quick: bool,
    /// `--only "64x32 phong 1"`: the rows whose name begins so.
    only: String,
    /// `--frames 5`: so many frames.
    frames: Option<usize>,
    level: SimdLevel,
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let value_of = |name: &str| arguments.iter().skip_while(|a| *a != name).nth(1);
    let asked = std::env::var("GLANZ_SIMD").ok();
    let options = Options {
        quick: arguments.iter().any(|a| a == "--quick"),
        only: value_of("--only").cloned().unwrap_or_default(),
        frames: value_of("--frames").and_then(|n| n.parse().ok()),
        level: asked.map_or(SimdLevel::best(), |name| {
            SimdLevel::named(&name).expect("a level that this machine has")
        }),
    };
    let Options { quick, only, level, .. } = &options;
    if arguments.iter().any(|a| a == "--serve") {
        return serve(*level);
    }
    spheres(&options);
    if only.is_empty() || only == "paired" {
        pairs(&options);
    }
    if only.is_empty() || only == "read back" {
        read_back::read_back(options.frames.unwrap_or(if *quick { 40 } else { 200 }), *level);
    }
    if only.is_empty() || only == "tables" {
        tables(if *quick { 20 } else { 100 });
    }
    if only.is_empty() || only == "updates" {
        updates(if *quick { 5 } else { 31 });
    }
    if only.is_empty() || only == "models" {
        models(*quick, *level);
    }
}

/// Spheres of two sizes under one, four and eight lights.
fn spheres(options: &Options) {
    let frames = options.frames.unwrap_or(if options.quick { 40 } else { 200 });
    for (slices, stacks) in [(64, 32), (1024, 512)] {
        for (shading, name) in [(Shading::Phong, "phong"), (Shading::Gouraud, "gouraud")] {
            for lights in [1, 4, 8] {
                if format!("{slices}x{stacks} {name} {lights}").starts_with(&options.only) {
                    let scene = sphere_scene(slices, stacks, lights, shading);
                    let times = frame_times(&scene, frames, options.level);
                    let threads = rayon::current_num_threads();
                    println!(
                        "{{\"program\":\"glanz\",\"sphere\":\"{slices}x{stacks}\",\"lights\":{lights},\
                         \"shading\":\"{name}\",\"threads\":{threads},\"median_ms\":{:.3},\"min_ms\":{:.3},\
                         \"max_ms\":{:.3}}}",
                        times[times.len() / 2],
                        times[0],
                        times[times.len() - 1]
                    );
                }
            }
        }
    }
}

/// Spectra against RGB, in turn.
fn pairs(options: &Options) {
    let frames = options.frames.unwrap_or(if options.quick { 100 } else { 500 });
    for lights in [1, 4] {
        let scene = sphere_scene(64, 32, lights, Shading::Phong);
        let view = View::new(&scene.camera.expect("a camera"), WIDTH, HEIGHT).expect("a sound view");
        let [rgb, same] = [ColorMode::Rgb; 2].map(|mode| Side::new(&scene, mode));
        let spectral = Side::new(&scene, ColorMode::Spectral);
        // A scene against itself: how far from 1 a ratio must be to mean anything.
        let name = |what: &str| format!("64x32 sphere, {lights} lights: {what}");
        paired(&name("rgb / rgb"), [&rgb, &same], &view, frames, options.level);
        paired(&name("spectral / rgb"), [&spectral, &rgb], &view, frames, options.level);
    }
}

/// Draws what lines on standard input ask for, so that several programs can take turns: `64x32 1 10`, ten frames of
/// that sphere with Phong shading and one light. The answer is a line with the milliseconds of each.
fn serve(level: SimdLevel) {
    let mut bench = FrameBench::new(level);
    let mut kept = HashMap::new();
    for line in std::io::stdin().lines() {
        let line = line.expect("text");
        let mut words = line.split_whitespace();
        let mut next = || words.next().expect("a sphere, a number of lights and one of frames");
        let (sphere, lights, frames) = (next(), next(), next().parse().expect("a number of frames"));
        let (prepared, view) = kept.entry(format!("{sphere} {lights}")).or_insert_with(|| {
            let (slices, stacks) = sphere.split_once('x').expect("slices and stacks");
            let [slices, stacks, lights] =
                [slices, stacks, lights].map(|n| n.parse::<u32>().expect("a number"));
            let scene = sphere_scene(slices, stacks, lights as usize, Shading::Phong);
            let view = View::new(&scene.camera.expect("a camera"), WIDTH, HEIGHT).expect("a sound view");
            (prepare(&scene, &PrepareOptions::default()).expect("a sound scene"), view)
        });
        let times: Vec<String> = (0..frames)
            .map(|_: usize| format!("{:.4}", bench.time(prepared, &Develop::default(), view)))
            .collect();
        println!("[{}]", times.join(","));
    }
}

/// Milliseconds per frame, in rising order.
fn frame_times(scene: &Scene, frames: usize, level: SimdLevel) -> Vec<f64> {
    let prepared = prepare(scene, &PrepareOptions::default()).expect("a sound scene");
    let view = View::new(&scene.camera.expect("a camera"), WIDTH, HEIGHT).expect("a sound view");
    let mut bench = FrameBench::new(level);
    let mut times: Vec<f64> =
        (0..frames + WARM_UP).map(|_| bench.time(&prepared, &Develop::default(), &view)).collect();
    times.drain(..WARM_UP);
    times.sort_by(f64::total_cmp);
    times
}

/// Frames that are drawn before any is measured.
const WARM_UP: usize = 5;

/// A renderer and its picture.
struct FrameBench {
    renderer: Renderer,
    options: DrawOptions,
    out: Vec<u8>,
}

impl FrameBench {
    fn new(level: SimdLevel) -> Self {
        let options = DrawOptions::new(Background::Color(Rgb([0.05, 0.05, 0.08])));
        Self { renderer: Renderer::with_level(level), options, out: vec![0u8; (WIDTH * HEIGHT * 4) as usize] }
    }

    /// Draws a frame; milliseconds.
    fn time(&mut self, prepared: &Prepared, develop: &Develop, view: &View) -> f64 {
        let start = Instant::now();
        let drawn = self.renderer.draw_rgba8(prepared, view, &self.options, develop, &mut self.out);
        drawn.expect("frames of this observer");
        start.elapsed().as_secs_f64() * 1e3
    }
}

/// A scene in a colour mode, and how its frames become sRGB.
struct Side {
    prepared: Prepared,
    develop: Develop,
}

impl Side {
    fn new(scene: &Scene, mode: ColorMode) -> Self {
        let observation = Observation::new(mode, None).expect("the standard observer");
        let to_screen = observation.to_screen(scene, White::D65).expect("daylight is white");
        let develop = Develop { to_screen: to_screen.and_then(|map| map.matrix()), ..Develop::default() };
        let options = PrepareOptions { observation, ..PrepareOptions::default() };
        Self { prepared: prepare(scene, &options).expect("a sound scene"), develop }
    }
}

/// How long the tint table takes to fill: 64 lights and 64 materials, half of which fluoresce.
fn tables(times: usize) {
    let mut scene = sphere_scene(16, 8, 64, Shading::Phong);
    let lamps = ["D65", "A", "FL2", "FL11", "HP1", "LED-B3", "D50", "UV365"];
    for (light, name) in scene.lights.iter_mut().zip(lamps.iter().cycle()) {
        let spectrum = glanz_color::light(name).expect("a name from the list");
        light.colors = LightColors::all(LightColor::unit(&spectrum).expect("light"));
    }
    let dyes = ["quinine", "day-glow-orange", "highlighter-yellow", "paper-brightened"];
    let dyes = dyes.map(|name| Arc::new(glanz_color::fluorescent(name).expect("a name from the list")));
    let plain = scene.materials[0].clone();
    scene.materials = (0..64)
        .map(|i| {
            let mut material = plain.clone();
            if i % 2 == 0 {
                material.lobes[1].tint = Tint::Reradiation(dyes[i / 2 % dyes.len()].clone());
            }
            material
        })
        .collect();
    let observation = Observation::new(ColorMode::Spectral, None).expect("the standard observer");
    let options = PrepareOptions { observation, ..PrepareOptions::default() };
    let mut prepared = prepare(&scene, &options).expect("a sound scene");
    let mut spent: Vec<f64> = (0..times)
        .map(|_| {
            let start = Instant::now();
            prepared.update(&scene, &[Change::Colors]).expect("a sound scene");
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    spent.sort_by(f64::total_cmp);
    println!(
        "{{\"table\":\"Filling the tint table anew, in full spectra, ms\",\"name\":\"64 lights, 64 materials, 32 of \
         them fluorescent\",\"median\":{:.2},\"min\":{:.2},\"max\":{:.2}}}",
        spent[times / 2],
        spent[0],
        spent[times - 1]
    );
}

/// Four large spheres and a small one: 1 003 000 triangles and one point light.
fn scene_of_a_million() -> Scene {
    let mut scene = sphere_scene(500, 251, 1, Shading::Phong);
    let large = scene.objects.remove(0);
    let small = Builtin::Sphere { radius: 0.2, slices: 50, stacks: 31 };
    scene.meshes.push(small.mesh().expect("a sphere"));
    scene.objects = (0..5)
        .map(|i| Object {
            mesh: usize::from(i == SMALL),
            transform: DMat4::from_translation(DVec3::new(2.5 * i as f64, 0.0, 0.0)),
            ..large.clone()
        })
        .collect();
    scene
}

/// The small sphere among the objects of [`scene_of_a_million`].
const SMALL: usize = 4;

/// What changes of a scene of a million triangles cost, beside preparing all of it, and preparing the object alone.
fn updates(times: usize) {
    let mut scene = scene_of_a_million();
    let mut prepared = prepare(&scene, &PrepareOptions::default()).expect("a sound scene");
    print_update("prepare", &mut (0..times).map(|_| time_preparing(&scene)).collect::<Vec<_>>());
    let only = |number: usize| Scene { objects: vec![scene.objects[number].clone()], ..scene.clone() };
    let (large, small) = (only(0), only(SMALL));
    print_update(
        "prepare one of 250 000",
        &mut (0..times).map(|_| time_preparing(&large)).collect::<Vec<_>>(),
    );
    print_update("prepare one of 3 000", &mut (0..times).map(|_| time_preparing(&small)).collect::<Vec<_>>());
    let changes = [
        ("moved lamp", Change::Light(0)),
        ("changed roughness", Change::Material(0)),
        ("moved object of 250 000", Change::Object(0)),
        ("moved object of 3 000", Change::Object(SMALL)),
    ];
    for (name, change) in changes {
        let mut spent: Vec<f64> = (0..times)
            .map(|i| {
                vary(&mut scene, change, i);
                let start = Instant::now();
                prepared.update(&scene, &[change]).expect("a sound scene");
                start.elapsed().as_secs_f64() * 1e3
            })
            .collect();
        print_update(name, &mut spent);
    }
}

/// Changes what the change names, otherwise each time.
fn vary(scene: &mut Scene, change: Change, i: usize) {
    let step = 1.0 + i as f64;
    match change {
        Change::Light(number) => {
            let position = DVec3::new(step, 3.0, 3.0);
            scene.lights[number].kind = LightKind::Point { position, attenuation: Attenuation::NONE };
        }
        Change::Material(number) => {
            let highlight =
                scene.materials[number].lobes.iter_mut().find(|lobe| lobe.shape.info().name == "phong");
            let shape = Shape::named("phong", &[("shininess", 10.0 + step)]).expect("a shininess in range");
            highlight.expect("a highlight").shape = shape;
        }
        Change::Object(number) => {
            scene.objects[number].transform = DMat4::from_translation(DVec3::new(0.0, 0.1 * step, 0.0));
        }
        other => unreachable!("{other:?} is not measured"),
    }
}

/// Milliseconds of preparing all of a scene.
fn time_preparing(scene: &Scene) -> f64 {
    let start = Instant::now();
    std::hint::black_box(prepare(scene, &PrepareOptions::default()).expect("a sound scene"));
    start.elapsed().as_secs_f64() * 1e3
}

fn print_update(name: &str, spent: &mut [f64]) {
    spent.sort_by(f64::total_cmp);
    println!(
        "{{\"table\":\"Updates of a scene of 1 003 000 triangles in 5 objects, ms\",\"name\":\"{name}\",\
         \"median\":{:.4},\"min\":{:.4},\"max\":{:.4}}}",
        spent[spent.len() / 2],
        spent[0],
        spent[spent.len() - 1]
    );
}

/// How much longer a frame of the first scene takes than one of the second. They take turns, so that
/// whatever else the machine does falls on both: the median of the ratios of neighbouring frames, and
/// between which values half of them lie.
fn paired(name: &str, scenes: [&Side; 2], view: &View, frames: usize, level: SimdLevel) {
    let mut bench = FrameBench::new(level);
    let mut ratios = Vec::with_capacity(frames);
    for pair in 0..frames + WARM_UP {
        // Who comes first changes too.
        let order = if pair % 2 == 0 { [0, 1] } else { [1, 0] };
        let mut times = [0.0; 2];
        for scene in order {
            let Side { prepared, develop } = scenes[scene];
            times[scene] = bench.time(prepared, develop, view);
        }
        if pair >= WARM_UP {
            ratios.push(times[0] / times[1]);
        }
    }
    ratios.sort_by(f64::total_cmp);
    let at = |part: f64| ratios[((ratios.len() - 1) as f64 * part) as usize];
    println!(
        "{{\"table\":\"Two scenes in turn: the first's time per frame over the second's\",\"name\":\"{name}\",\
         \"pairs\":{},\"median\":{:.4},\"lower quartile\":{:.4},\"upper quartile\":{:.4}}}",
        ratios.len(),
        at(0.5),
        at(0.25),
        at(0.75)
    );
}

/// Shading throughput per model, beside the limit: the same lobe alone, on numbers in cache, with 16
/// lanes and with one.
fn models(quick: bool, level: SimdLevel) {
    let answers =
        |info: &&ModelInfo| matches!(info.term, LightTerm::Diffuse | LightTerm::Specular) && !info.delta;
    for info in MODELS.iter().filter(answers) {
        let mut scene = sphere_scene(64, 32, 1, Shading::Phong);
        let shape = Shape::named(info.name, &[]).expect("a name from the list");
        let lobe = Lobe::new(shape.clone(), Rgb::gray(0.5));
        scene.materials = vec![Material::of_lobes(info.name, vec![lobe])];
        // A quad that fills the picture: all of it is shading.
        scene.meshes = vec![Builtin::Quad.mesh().expect("a quad")];
        scene.objects[0].transform = DMat4::from_scale(DVec3::new(10.0, 10.0, 1.0));
        let times = frame_times(&scene, if quick { 20 } else { 100 }, level);
        let drawn = f64::from(WIDTH * HEIGHT) / times[times.len() / 2] * 1e-3;
        let lanes = alone(quick, || at_level!(level, simd => sixteen(simd, &shape)));
        let scalar = alone(quick, || one(&shape));
        println!(
            "{{\"table\":\"Shading, one point light, 1920×1080, all threads; the lobe alone on one core\",\
             \"name\":\"{}\",\"drawn Mfragments/s\":{drawn:.0},\"lobe alone, 16 lanes, Mevals/s\":{lanes:.0},\
             \"lobe alone, scalar, Mevals/s\":{scalar:.0},\"16 lanes / scalar\":{:.2}}}",
            info.name,
            lanes / scalar
        );
    }
}

/// How many pairs of directions a measured pass goes through.
const PAIRS: usize = 4096;

/// Cosines that vary from lane to lane, all lit: by light on the side that the shape answers to.
fn cosines(shape: &Shape, i: usize) -> [f32; 3] {
    let t = (i % 64) as f32 / 64.0;
    match shape.info().side {
        glanz_bsdf::Side::Reflection => [0.3 + 0.6 * t, 0.9 - 0.5 * t, 0.2 + 0.7 * t],
        glanz_bsdf::Side::Transmission => [0.3 + 0.6 * t, -0.9 + 0.5 * t, -0.75 - 0.2 * t],
    }
}

/// Millions of evaluations per second of the fastest of several passes.
fn alone(quick: bool, pass: impl Fn() -> f32) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..if quick { 50 } else { 500 } {
        let start = Instant::now();
        std::hint::black_box(pass());
        best = best.min(start.elapsed().as_secs_f64());
    }
    PAIRS as f64 / best * 1e-6
}

#[inline(always)]
fn sixteen<S: Simd>(simd: S, shape: &Shape) -> f32 {
    let rows: [[f32; 16]; 12] =
        core::array::from_fn(|row| core::array::from_fn(|i| cosines(shape, row / 3 * 16 + i)[row % 3]));
    let mut sum = Lanes::splat(simd, 0.0);
    for pass in 0..PAIRS / 64 {
        for block in std::hint::black_box(&rows).chunks_exact(3) {
            let load = |row: &[f32; 16]| Lanes::load(simd, row);
            let pair = DirectionPair::isotropic(load(&block[0]), load(&block[1]), load(&block[2]));
            sum = sum + shape.f_cos(&pair);
        }
        std::hint::black_box(pass);
    }
    let mut out = [0.0; 16];
    sum.store(&mut out);
    out.iter().sum()
}

fn one(shape: &Shape) -> f32 {
    let pairs: [[f32; 3]; 64] = core::array::from_fn(|i| cosines(shape, i));
    let mut sum = 0.0;
    for _ in 0..PAIRS / 64 {
        for [o, i, io] in std::hint::black_box(&pairs) {
            sum += shape.f_cos(&DirectionPair::isotropic(*o, *i, *io));
        }
    }
    sum
}
