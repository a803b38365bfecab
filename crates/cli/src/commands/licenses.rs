//! `glanz licenses`: under what terms the program and its libraries may be passed on.

use clap::Args;

use crate::print;
use crate::print::failure::Failure;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz licenses
  glanz licenses > THIRD-PARTY.txt";

/// Glanz's own terms, and whose data it contains.
const OWN: &str = include_str!("../../NOTICE");

/// The libraries, written by `cargo xtask licenses`.
const LIBRARIES: &str = include_str!("../../data/THIRD-PARTY.txt");

/// Options of `glanz licenses`.
#[derive(Args, Debug)]
pub(crate) struct LicensesArgs {}

impl LicensesArgs {
    /// Prints them.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        print::text(&format!("{OWN}\n{}\n\n{LIBRARIES}", "=".repeat(80)))
    }
}
