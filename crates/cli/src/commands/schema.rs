//! `glanz schema`: the shape of scene files, for editors and programs.

use crate::print;
use crate::print::failure::Failure;

/// Prints the JSON Schema of scene files.
pub fn run() -> Result<(), Failure> {
    print::json(&glanz_scene::file::schema())
}
