//! Draws a scene file, or a scene made here, into a picture.
//!
//!     cargo run --example render                         # gold.png in the folder for temporary files
//!     cargo run --example render -- FOLDER               # gold.png there
//!     cargo run --example render -- FOLDER scene.toml    # the picture of a scene file or a model
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use std::path::PathBuf;

use glanz::{Camera, ColorMode, Error, Light, Mesh, Scene, Shot, scene::library};

fn main() -> Result<(), Error> {
    let mut arguments = std::env::args_os().skip(1);
    let folder = arguments.next().map_or_else(std::env::temp_dir, PathBuf::from);
    let scene = match arguments.next() {
        Some(path) => glanz::load(PathBuf::from(path))?,
        None => gold_ball()?,
    };
    let path = folder.join("gold.png");
    Shot::new(&scene)?.save(&path)?;
    println!("wrote {}", path.display());
    Ok(())
}

fn gold_ball() -> Result<Scene, Error> {
    Ok(Scene::new()
        .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
        .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]).attached_to_camera())
        .with_light(Light::environment([0.3, 0.3, 0.3]))
        .with_camera(Camera::new([0.0, 1.0, 5.0], [0.0, 0.0, 0.0]).with_fov_deg(30.0))
        .with_mode(ColorMode::Spectral)
        .with_size(160, 120))
}
