//! `glanz schema`: the shape of scene files, for editors and programs.

use crate::failure::Failure;
use crate::print;

/// Prints the JSON Schema of scene files.
pub fn run() -> Result<(), Failure> {
    print::json(&glanz_scene::file::schema())
}
