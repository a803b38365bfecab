//! How far apart are a picture in linear RGB and one in full spectra? In colour differences that an eye sees.
//!
//!     cargo run --example compare
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use glanz::picture::compare::{Metric, MetricOptions, Pair, Picture, Scale};
use glanz::{ColorMode, Error, Light, Mesh, Scene, Shot, color, scene::library};

fn main() -> Result<(), Error> {
    let scene = Scene::new()
        .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
        .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0; 3]).with_spectrum(color::light("FL2")?))
        .with_size(96, 96);
    let componentwise = drawn(&scene.clone().with_mode(ColorMode::Rgb))?;
    let spectral = drawn(&scene.with_mode(ColorMode::Spectral))?;
    let pair = Pair::new(spectral, componentwise, true)?;
    let difference = pair.measure(Metric::De2000, &MetricOptions::default())?;
    println!("ΔE00: mean {:.2}, at most {:.2}", difference.spread.mean, difference.spread.max);
    assert!(difference.spread.max > 1.0, "under a lamp with lines, RGB shows another colour");
    Ok(())
}

/// Linear sRGB, as the comparison takes it.
fn drawn(scene: &Scene) -> Result<Picture, Error> {
    let mut shot = Shot::new(scene)?;
    let frame = shot.frame()?;
    let frame = shot.on_screen(frame)?;
    let (width, height, rgb) = (frame.width, frame.height, frame.rgb);
    Ok(Picture { width, height, rgb, scale: Scale::Light, notes: Vec::new() })
}
