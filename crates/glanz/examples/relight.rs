//! One material under several lamps: what is prepared is kept, only the light's colour is redone.
//!
//!     cargo run --example relight [-- FOLDER]
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use std::path::PathBuf;

use glanz::{ColorMode, Error, Light, Mesh, Scene, Session, color, scene::library};

fn main() -> Result<(), Error> {
    let folder = std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    let scene = Scene::new()
        .with_mesh(Mesh::builtin("sphere")?, library::material("copper")?)
        .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0; 3]).named("lamp"))
        .with_light(Light::environment([0.2; 3]).named("sky"))
        .with_mode(ColorMode::Spectral)
        .with_size(96, 96);
    let mut session = Session::new(scene)?;
    for lamp in ["D65", "A", "FL11"] {
        session.light_mut("lamp")?.set_spectrum(color::light(lamp)?);
        session.light_mut("sky")?.set_spectrum(color::light(lamp)?);
        let path = folder.join(format!("copper-{lamp}.png"));
        session.save(&path)?;
        println!("wrote {}", path.display());
    }
    Ok(())
}
