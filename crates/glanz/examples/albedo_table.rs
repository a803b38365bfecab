//! How much light a rough metal sends back: a table over roughness and the angle of view, as CSV.
//!
//!     cargo run --example albedo_table [-- FOLDER]
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use std::fmt::Write;
use std::path::PathBuf;

use glanz::bsdf::albedo;
use glanz::{Error, Shape};

const ANGLES_DEG: [f64; 6] = [0.0, 30.0, 45.0, 60.0, 75.0, 85.0];

fn main() -> Result<(), Error> {
    let folder = std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    let single = Shape::named("ggx", &[("multiscatter", 0.0)])?;
    let mut csv = format!("alpha,{}\n", ANGLES_DEG.map(|angle| angle.to_string()).join(","));
    for alpha in [0.1, 0.2, 0.4, 0.6, 0.8, 1.0] {
        let shape = single.with("alpha", alpha)?;
        let row = ANGLES_DEG.map(|angle| format!("{:.4}", albedo(&shape, angle.to_radians().cos())));
        writeln!(csv, "{alpha},{}", row.join(",")).expect("a string takes everything");
    }
    let path = folder.join("albedo.csv");
    std::fs::write(&path, &csv)?;
    print!("{csv}");
    println!("wrote {}", path.display());
    Ok(())
}
