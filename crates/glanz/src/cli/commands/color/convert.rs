//! `glanz color convert`: one colour in another model.

use std::fmt::Write;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use glanz_color::models::{Model, convert};
use serde_json::json;

use crate::cli::args;
use crate::cli::failure::Failure;
use crate::cli::print::{self, FormatArgs, number};

/// Shown below the help.
pub const EXAMPLES: &str = "Examples:
  glanz color convert --from hls --to ac1c2 210,0.4,0.8
  glanz color convert --from srgb --to lab 1,0.5,0
  glanz color convert --from lab --to oklch --format json -- 50,-20,30

White is D65 in all models, and XYZ of white has Y = 1. 'glanz color list models' tells the
numbers of each model and their ranges. A colour that a model cannot hold is an error, never
another colour.";

/// Options of `glanz color convert`.
#[derive(Args, Debug)]
pub struct ConvertArgs {
    /// The model of the numbers
    #[arg(long, value_name = "MODEL", value_parser = models())]
    from: String,

    /// The model asked for
    #[arg(long, value_name = "MODEL", value_parser = models())]
    to: String,

    /// The colour: its numbers in order, between commas
    #[arg(value_name = "NUMBERS", value_parser = numbers, allow_hyphen_values = true)]
    values: Values,

    #[command(flatten)]
    format: FormatArgs,
}

/// The numbers of a colour.
#[derive(Clone, Debug)]
struct Values(Vec<f64>);

fn numbers(text: &str) -> Result<Values, String> {
    args::numbers(text).map(Values)
}

/// Parses the name of a model.
fn models() -> PossibleValuesParser {
    PossibleValuesParser::new(Model::ALL.iter().map(|model| {
        let info = model.info();
        PossibleValue::new(info.name).help(info.title)
    }))
}

impl ConvertArgs {
    /// Converts the colour.
    pub fn run(&self) -> Result<(), Failure> {
        let usage = |error: &dyn std::fmt::Display| Failure::Usage(error.to_string());
        let found = convert(&self.from, &self.to, &self.values.0).map_err(|error| usage(&error))?;
        let model = Model::from_name(&self.to).map_err(|error| usage(&error))?;
        let channels = model.info().channels;
        if self.format.is_json() {
            let named: serde_json::Map<_, _> =
                channels.iter().zip(&found).map(|(c, value)| (c.name.to_owned(), json!(value))).collect();
            return print::json(&json!({
                "from": self.from, "to": self.to, "input": self.values.0, "values": found, "channels": named,
            }));
        }
        let mut text = String::new();
        for (channel, value) in channels.iter().zip(&found) {
            writeln!(text, "{:<4} {}", channel.name, number(*value)).expect("a string takes everything");
        }
        print::text(&text)
    }
}
