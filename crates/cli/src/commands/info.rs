//! `glanz info`: what is in a scene or a model.

use clap::Args;

use crate::args::InputArgs;
use crate::print::failure::Failure;
use crate::print::{self, Format, FormatArgs, Summary};

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz info model.glb
  glanz info scene.toml --format json
  glanz info examples/kite.toml --vertices";

/// Options of `glanz info`.
#[derive(Args, Debug)]
pub(crate) struct InfoArgs {
    #[command(flatten)]
    input: InputArgs,

    /// Tell the vertices of all meshes, with normals and colours, and the facets, with their normals
    #[arg(long)]
    vertices: bool,

    #[command(flatten)]
    format: FormatArgs,
}

impl InfoArgs {
    /// Tells it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let input = self.input.load(None, &[])?;
        let summary = Summary { input: &input, path: self.input.name(), vertices: self.vertices };
        match self.format.format {
            Format::Json => print::json(&summary.document()),
            Format::Text => print::text(&summary.text()),
        }
    }
}
