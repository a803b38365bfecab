//! `glanz schema`: the shape of scene files and of what commands print, for editors and programs.

use clap::Args;
use clap::builder::PossibleValuesParser;
use glanz_plot::PlotData;
use serde_json::Value;

use super::draw::{film, lighting_error, modes, relight, render, shade_compare};
use super::{bsdf, check, color, compare, devices, example, eye, lesson, material, measure, probe, shader};
use crate::print;
use crate::print::document::schema;
use crate::print::failure::{ErrorDocument, Failure};
use crate::print::files::SheetDocument;
use crate::print::scene_document;

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz schema > scene.schema.json
  glanz schema --of compare
  glanz schema --of error

Without --of, the schema is that of scene files. The names are those of commands; render-frames
is what 'glanz render --frames' prints, and error what a command prints that fails.";

/// A name and what makes the schema.
type Named = (&'static str, fn() -> Value);

/// Everything that has a schema, by its name.
const SCHEMAS: [Named; 59] = [
    ("scene", glanz_scene::file::schema),
    ("error", schema::<ErrorDocument>),
    ("render", schema::<render::Document>),
    ("devices", schema::<devices::Document>),
    ("render-frames", schema::<film::Document>),
    ("sweep", schema::<SheetDocument>),
    ("shade-compare", schema::<shade_compare::Document>),
    ("lighting-error", schema::<lighting_error::Document>),
    ("modes", schema::<modes::Document>),
    ("relight", schema::<relight::Document>),
    ("eye", schema::<eye::Document>),
    ("eye-mach", schema::<eye::mach::Document>),
    ("eye-population", schema::<eye::population::Document>),
    ("compare", schema::<compare::Document>),
    ("info", schema::<scene_document::Document>),
    ("probe", schema::<probe::Document>),
    ("bsdf-list", schema::<bsdf::list::ListDocument>),
    ("bsdf-show", schema::<bsdf::list::ModelFacts>),
    ("bsdf-eval", schema::<bsdf::eval::Document>),
    ("bsdf-albedo", schema::<bsdf::albedo::Document>),
    ("sheet", schema::<SheetDocument>),
    ("check", schema::<check::Document>),
    ("measure-info", schema::<measure::info::Document>),
    ("measure-appearance", schema::<measure::appearance::Document>),
    ("measure-fit", schema::<measure::fit::Document>),
    ("measure-convert", schema::<measure::convert::Document>),
    ("measure-compare", schema::<measure::compare::Document>),
    ("measure-sample", schema::<measure::convert::Document>),
    ("measure-smooth", schema::<measure::smooth::Document>),
    ("lesson-ward", schema::<lesson::ward::Document>),
    ("shader-run", schema::<shader::run::Document>),
    ("shader-check", schema::<shader::check::Document>),
    ("shader-print", schema::<shader::programs::PrintDocument>),
    ("shader-list", schema::<shader::programs::ListDocument>),
    ("shader-xray", schema::<shader::xray::Document>),
    ("shader-picture", schema::<shader::picture::Document>),
    ("shader-export", schema::<shader::export::Document>),
    ("shader-certify", schema::<shader::certify::Document>),
    ("example", schema::<example::Document>),
    ("material-list", schema::<material::list::Document>),
    ("material-show", schema::<material::show::Document>),
    ("material-sheet", schema::<SheetDocument>),
    ("color-convert", schema::<color::convert::Document>),
    ("color-spectrum", schema::<color::spectrum::Document>),
    ("color-xy", schema::<color::xy::Document>),
    ("color-wave", schema::<color::wave::Document>),
    ("color-metamers", schema::<color::metamers::Document>),
    ("color-fluorescence", schema::<color::fluorescence::Document>),
    ("color-list", schema::<color::list::Document>),
    ("color-efficiency", schema::<color::efficiency::Document>),
    ("plot", schema::<PlotData>),
    ("plot-eye", schema::<PlotData>),
    ("color-plot-spectra", schema::<PlotData>),
    ("color-plot-chromaticity", schema::<PlotData>),
    ("color-plot-cones", schema::<PlotData>),
    ("color-plot-meyer", schema::<PlotData>),
    ("color-plot-matrix", schema::<PlotData>),
    ("color-plot-tm30", schema::<PlotData>),
    ("color-plot-efficiency", schema::<PlotData>),
];

/// Options of `glanz schema`.
#[derive(Args, Debug)]
pub(crate) struct SchemaArgs {
    /// What the schema is of: scene files, or what a command prints with --format json
    #[arg(long, value_name = "NAME", default_value = "scene",
          value_parser = PossibleValuesParser::new(SCHEMAS.map(|(name, _)| name)))]
    of: String,
}

impl SchemaArgs {
    /// Prints the JSON Schema.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let found = SCHEMAS.iter().find(|(name, _)| *name == self.of);
        let (_, schema) = found.expect("the parser lets only known names through");
        print::text(&format!("{:#}\n", schema()))
    }
}
