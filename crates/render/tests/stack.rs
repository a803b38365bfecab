//! Everything draws on the stacks that threads commonly have: 2 MiB.
//!
//! Code that is not optimised takes many times as much, so `cargo xtask test` compiles this test without optimisation:
//!
//!     cargo test -p glanz-render --test stack --config profile.dev.opt-level=0

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::everything::{
    add_fields, add_ground, add_lamps, at, coated, glass, ground, luminaire, metal, window,
};
use common::{ALL_LAYERS, add, camera, empty, shiny, sphere};
use glam::DMat4;
use glanz_math::SimdLevel;
use glanz_render::cpu::Renderer;
use glanz_render::{
    Backend, Develop, DrawOptions, PrepareOptions, Samples, ToneMap, View, develop_with, prepare,
};
use glanz_scene::{Background, Scene};

/// What Rust gives a thread.
const COMMON_STACK: usize = 2 << 20;

/// Coats, metal, panes and glass under all kinds of light, with shadows.
fn general() -> Scene {
    let mut scene = empty(camera(3.0, 50.0));
    scene.render.shadows = true;
    add(&mut scene, sphere(12, 7), metal(), at(-0.9, 0.1, 0.0));
    add(&mut scene, sphere(12, 7), coated(), at(0.9, 0.0, -0.4));
    add(&mut scene, sphere(12, 7), glass(), at(0.3, -0.2, 0.7));
    add(&mut scene, common::rectangle([0.1, -0.7, 1.1, 0.5], 1.1), window(), DMat4::IDENTITY);
    add_ground(&mut scene, ground());
    add_fields(&mut scene);
    scene.lights.push(luminaire());
    scene
}

/// Classic materials, for which there are loops of their own.
fn classic() -> Scene {
    let mut scene = empty(camera(3.0, 50.0));
    add_lamps(&mut scene, None);
    add(&mut scene, sphere(24, 12), shiny("phong", 12.0), at(-0.6, 0.1, 0.0));
    add(&mut scene, sphere(40, 31), shiny("blinn-phong", 30.0), at(0.8, 0.0, -0.5));
    scene
}

/// Prepares, draws and develops on the stack that is there.
fn draw(scene: &Scene, level: SimdLevel) -> Vec<u8> {
    let prepared = prepare(scene, &PrepareOptions::default()).unwrap();
    let view = View::new(&scene.camera.unwrap(), 40, 30).unwrap();
    let mut renderer = Renderer::with_level(level);
    let mut bytes = vec![0; 4 * 40 * 30];
    for samples in [Samples::Four, Samples::One] {
        let options = DrawOptions { samples, ..DrawOptions::new(Background::Transparent) };
        let layers = DrawOptions { aovs: ALL_LAYERS, ..options };
        let frame = renderer.draw(&prepared, &view, &layers);
        for (tone_map, _) in ToneMap::ALL {
            let settings = Develop { tone_map, ..Develop::default() };
            let developed = develop_with(&frame, &settings, level).unwrap();
            renderer.draw_rgba8(&prepared, &view, &options, &settings, &mut bytes).unwrap();
            assert_eq!(developed, bytes);
        }
    }
    bytes
}

#[test]
fn a_thread_of_any_program_can_draw() {
    for scene in [classic(), general()] {
        let pictures = SimdLevel::available().into_iter().map(|(_, level)| {
            std::thread::scope(|scope| {
                let thread = std::thread::Builder::new().stack_size(COMMON_STACK);
                thread.spawn_scoped(scope, || draw(&scene, level)).unwrap().join().unwrap()
            })
        });
        assert!(Vec::from_iter(pictures).windows(2).all(|pair| pair[0] == pair[1]));
    }
}

#[test]
fn a_pool_of_any_program_can_draw() {
    let scene = classic();
    let pictures = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(COMMON_STACK);
        pool.build().unwrap().install(|| draw(&scene, SimdLevel::best()))
    });
    assert_eq!(pictures[0], pictures[1]);
}
