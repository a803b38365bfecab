//! Two models of a highlight about a point of the surface, as a polar plot.
//!
//!     cargo run --features plot --example plot_lobe [-- FOLDER]
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use std::path::PathBuf;

use glanz::plot::{self, Figure};
use glanz::{Error, Shape};

fn main() -> Result<(), Error> {
    let folder = std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    let shapes = [Shape::named("phong", &[("shininess", 32.0)])?, Shape::named("ggx", &[("alpha", 0.2)])?];
    let mut lobes = plot::lobe(&shapes);
    lobes.theta_deg = vec![20.0, 60.0];
    let path = folder.join("lobes.svg");
    lobes.polar()?.save(&path)?;
    println!("wrote {}", path.display());
    Ok(())
}
