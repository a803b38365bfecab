//! `glanz schema`: the shape of scene files, for editors and programs.

use crate::cli::failure::Failure;
use crate::cli::print;

/// Prints the JSON Schema of scene files.
pub fn run() -> Result<(), Failure> {
    print::json(&glanz_scene::file::schema())
}
