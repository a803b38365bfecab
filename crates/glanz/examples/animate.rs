//! A lamp goes once around a torus, in a GIF.
//!
//!     cargo run --features gif --example animate [-- FOLDER]
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use std::f64::consts::TAU;
use std::path::PathBuf;

use glanz::picture::output::{Animation, Metadata, write_atomically, write_gif};
use glanz::{Error, Light, Mesh, Scene, Session, scene::library};

const FRAMES: usize = 12;

fn main() -> Result<(), Error> {
    let folder = std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    let scene = Scene::new()
        .with_mesh(Mesh::builtin("torus")?, library::material("plastic-red")?)
        .with_light(Light::point([3.0, 2.0, 0.0], [1.0; 3]).named("lamp"))
        .with_light(Light::ambient([0.2; 3]))
        .with_size(96, 72);
    let mut session = Session::new(scene)?;
    let frames = (0..FRAMES).map(|frame| -> Result<Vec<u8>, Error> {
        let (sin, cos) = (TAU * frame as f64 / FRAMES as f64).sin_cos();
        session.light_mut("lamp")?.set_position([3.0 * cos, 2.0, 3.0 * sin])?;
        Ok(session.rgba8()?)
    });
    let animation = Animation { width: 96, height: 72, frames: FRAMES, frame_s: 0.08 };
    let path = folder.join("lamp.gif");
    write_atomically(&path, |out| write_gif(out, &animation, frames, &Metadata::default()))?;
    println!("wrote {}", path.display());
    Ok(())
}
