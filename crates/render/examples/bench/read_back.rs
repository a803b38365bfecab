//! What it takes to have a picture as linear planes, beside drawing it into an 8-bit buffer.

use std::time::Instant;

use glanz_math::SimdLevel;
use glanz_picture::ToScreen;
use glanz_render::{
    Aovs, Backend, Develop, DrawOptions, Frame, Observation, PrepareOptions, Prepared, View, develop, prepare,
};
use glanz_scene::{ColorMode, Scene, Shading, White};

use super::{FrameBench, HEIGHT, WARM_UP, WIDTH, sphere_scene};

/// Everything that a frame can hold.
const ALL: Aovs = Aovs { depth: true, normal: true, object: true };

/// The ways to have the picture; each frame is drawn by all of them, one after the other, so that whatever else the
/// machine does falls on all.
const WAYS: [&str; 7] = [
    "8-bit buffer",
    "frame, kept",
    "frame, new",
    "frame with depth, normals, ids, kept",
    "frame with depth, normals, ids, new",
    "a frame of XYZ to the screen",
    "a frame of XYZ developed",
];

/// Times every way in turn.
pub(super) fn read_back(frames: usize, level: SimdLevel) {
    let scene = sphere_scene(64, 32, 1, Shading::Phong);
    let mut rounds: Vec<[f64; WAYS.len()]> = Vec::with_capacity(frames);
    let mut round = Round::new(&scene, level);
    for _ in 0..frames + WARM_UP {
        rounds.push(round.time());
    }
    rounds.drain(..WARM_UP);
    for (way, name) in WAYS.iter().enumerate() {
        let mut spent: Vec<f64> = rounds.iter().map(|round| round[way]).collect();
        let mut ratios: Vec<f64> = rounds.iter().map(|round| round[way] / round[0]).collect();
        spent.sort_by(f64::total_cmp);
        ratios.sort_by(f64::total_cmp);
        println!(
            "{{\"table\":\"Reading back, 64x32 sphere, 1 light, 1920×1080, in turn, ms\",\"name\":\"{name}\",\
             \"median\":{:.2},\"min\":{:.2},\"max\":{:.2},\"over the first\":{:.2}}}",
            spent[frames / 2],
            spent[0],
            spent[frames - 1],
            ratios[frames / 2],
        );
    }
}

/// One frame by each way.
struct Round {
    bench: FrameBench,
    xyz: FrameBench,
    view: View,
    prepared: Prepared,
    prepared_xyz: Prepared,
    to_screen: ToScreen,
    develop_xyz: Develop,
    kept: Frame,
    kept_all: Frame,
}

impl Round {
    fn new(scene: &Scene, level: SimdLevel) -> Self {
        let observation = Observation::new(ColorMode::Spectral, None).expect("the standard observer");
        let to_screen = observation.to_screen(scene, White::D65).expect("daylight is white");
        let to_screen = to_screen.expect("XYZ is not the screen's");
        let options = PrepareOptions { observation, ..PrepareOptions::default() };
        Self {
            bench: FrameBench::new(level),
            xyz: FrameBench::new(level),
            view: View::new(&scene.camera.expect("a camera"), WIDTH, HEIGHT).expect("a sound view"),
            prepared: prepare(scene, &PrepareOptions::default()).expect("a sound scene"),
            prepared_xyz: prepare(scene, &options).expect("a sound scene"),
            develop_xyz: Develop { to_screen: to_screen.matrix(), ..Develop::default() },
            to_screen,
            kept: Frame::default(),
            kept_all: Frame::default(),
        }
    }

    fn time(&mut self) -> [f64; WAYS.len()] {
        let (bench, view, prepared) = (&mut self.bench, &self.view, &self.prepared);
        let options = bench.options;
        let with_all = DrawOptions { aovs: ALL, ..options };
        let codes = bench.time(prepared, &Develop::default(), view);
        let kept = milliseconds(|| bench.renderer.draw_into(prepared, view, &options, &mut self.kept));
        let new = milliseconds(|| bench.renderer.draw(prepared, view, &options));
        let kept_all =
            milliseconds(|| bench.renderer.draw_into(prepared, view, &with_all, &mut self.kept_all));
        let new_all = milliseconds(|| bench.renderer.draw(prepared, view, &with_all));
        let frame = self.xyz.renderer.draw(&self.prepared_xyz, view, &options);
        let developed = milliseconds(|| develop(&frame, &self.develop_xyz).expect("XYZ"));
        let to_screen = milliseconds(|| frame.on_screen(&self.to_screen).expect("XYZ"));
        [codes, kept, new, kept_all, new_all, to_screen, developed]
    }
}

/// How long some work takes, until its result is dropped.
fn milliseconds<T>(work: impl FnOnce() -> T) -> f64 {
    let start = Instant::now();
    drop(std::hint::black_box(work()));
    start.elapsed().as_secs_f64() * 1e3
}
