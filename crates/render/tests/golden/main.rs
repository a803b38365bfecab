//! Gold pictures: drawn by the path with the narrowest vectors on one thread, compared exactly; every other
//! path must give the same bits.
//!
//! There is a picture for each model of the list, so a new model has one with no line written here, and one
//! for each scene in `scenes/`. The PNG files are for people; `hashes.txt` holds what must not change: all
//! planes of the linear frame, to the last bit.
//!
//! `GLANZ_RENEW=1 cargo test -p glanz-render --test golden` writes them anew.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod hash;
mod models;
mod scenes;
mod shelf;

use glanz_math::SimdLevel;
use glanz_render::cpu::Renderer;
use glanz_render::{Aovs, Backend, DrawOptions, Frame, Observation, PrepareOptions, View, prepare};
use glanz_scene::{Background, Scene};

/// A frame and what a screen shows of it.
struct Drawn {
    frame: Frame,
    rgba: Vec<u8>,
}

/// Draws a scene as its settings ask, on the narrowest path; panics unless all other paths give the same
/// frame.
fn drawn(scene: &Scene) -> Drawn {
    let observation = Observation::new(scene.render.mode, scene.observer.clone()).unwrap();
    let to_screen = observation.to_screen(scene, scene.render.white).unwrap();
    let options = PrepareOptions { observation, ..PrepareOptions::default() };
    let prepared = prepare(scene, &options).unwrap();
    let (width, height) = (scene.image.width, scene.image.height);
    let view =
        View::new(&scene.camera_or_framing(f64::from(width) / f64::from(height)), width, height).unwrap();
    let mut background = scene.image.background;
    if let (Background::Color(color), Some(to_screen)) = (background, &to_screen) {
        background = Background::Color(glanz_color::Rgb(to_screen.channels_of(color.0)));
    }
    let aovs = Aovs { depth: true, normal: true, object: true };
    let path = |level: SimdLevel, threads: usize| {
        let options = DrawOptions {
            samples: scene.image.samples.try_into().unwrap(),
            supersample: scene.image.supersample,
            aovs,
            ..DrawOptions::new(background)
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Renderer::with_level(level).draw(&prepared, &view, &options))
    };
    let frame = path(SimdLevel::narrowest(), 1);
    for (name, level) in SimdLevel::available() {
        assert!(
            hash::of(&path(level, 3)) == hash::of(&frame),
            "level {name} with 3 threads gives other bits"
        );
    }
    let screen = match &to_screen {
        Some(to_screen) => frame.clone().on_screen(to_screen).unwrap(),
        None => frame.clone(),
    };
    let rgba = glanz_render::develop(&screen, &glanz_render::Develop::default()).unwrap();
    Drawn { frame, rgba }
}
