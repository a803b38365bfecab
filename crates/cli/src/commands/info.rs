//! `glanz info`: what is in a scene or a model.

use clap::Args;
use glanz_bsdf::LightTerm;
use glanz_render::{PrepareOptions, check_memory};

use crate::args::{InputArgs, choices};
use crate::load::More;
use crate::print::failure::Failure;
use crate::print::{self, Format, FormatArgs, Summary};

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz info model.glb
  glanz info scene.toml --format json
  glanz info scene.toml --model ward
  glanz info examples/kite.toml --vertices --matrices";

/// Options of `glanz info`.
#[derive(Args, Debug)]
pub(crate) struct InfoArgs {
    #[command(flatten)]
    input: InputArgs,

    /// Tell of the scene with this model for all highlights, as drawing commands take it
    #[arg(long, value_name = "MODEL", value_parser = choices::highlight_model(), help_heading = "Picture")]
    model: Option<String>,

    /// Tell the vertices of all meshes, with normals and colours, and the facets, with their normals
    #[arg(long)]
    vertices: bool,

    /// Tell the matrices that a vertex shader gets: view, projection, and of each object model and normals
    #[arg(long)]
    matrices: bool,

    #[command(flatten)]
    format: FormatArgs,
}

impl InfoArgs {
    /// Tells it.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let mut input = self.input.load(None, More::default())?;
        if let Some(model) = &self.model {
            let lobes = input.scene.materials.iter_mut().flat_map(|material| &mut material.lobes);
            for lobe in lobes.filter(|lobe| lobe.shape.info().term == LightTerm::Specular) {
                lobe.shape = lobe.shape.as_model(model).map_err(|error| Failure::Usage(error.to_string()))?;
            }
        }
        let options = PrepareOptions { memory: input.memory, ..PrepareOptions::default() };
        let summary = Summary {
            input: &input,
            refusal: check_memory(&input.scene, &options).err().map(|error| error.to_string()),
            path: self.input.name(),
            vertices: self.vertices,
            matrices: self.matrices,
        };
        match self.format.format {
            Format::Json => print::json(&summary.document()),
            Format::Text => print::text(&summary.text()),
        }
    }
}
