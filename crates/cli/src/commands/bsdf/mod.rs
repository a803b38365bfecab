//! `glanz bsdf`: the models of reflection, and their numbers.

mod albedo;
mod directions;
mod eval;
mod list;
mod table;

use clap::{Args, Subcommand};
use glanz_bsdf::Shape;
use serde_json::Value;

use crate::args;
use crate::failure::Failure;
use crate::lobes::{did_you_mean, model_names};
use crate::print::FormatArgs;

/// What to do with the models.
#[derive(Subcommand, Debug)]
pub enum BsdfCommand {
    /// All models, one per line
    #[command(after_help = "Example:\n  glanz bsdf list --format json")]
    List(FormatArgs),
    /// All that is known of one model: formula, parameters, laws, source
    #[command(after_help = "Example:\n  glanz bsdf show blinn-phong")]
    Show(list::ShowArgs),
    /// The value for one pair of directions, or for each of a table
    #[command(after_help = eval::EXAMPLES)]
    Eval(eval::EvalArgs),
    /// The part of the light that leaves, by the angle that it is seen from
    #[command(after_help = albedo::EXAMPLES)]
    Albedo(albedo::AlbedoArgs),
}

/// A model with its parameters.
#[derive(Args, Debug)]
pub struct ModelArgs {
    /// The model's name, from `glanz bsdf list`
    #[arg(value_name = "NAME", value_parser = model_names())]
    name: String,

    /// A parameter, such as shininess=32; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = args::assignment)]
    set: Vec<(String, String)>,
}

impl BsdfCommand {
    /// The subcommand's name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::List(_) => "list",
            Self::Show(_) => "show",
            Self::Eval(_) => "eval",
            Self::Albedo(_) => "albedo",
        }
    }

    /// Does it.
    pub fn run(&self) -> Result<(), Failure> {
        match self {
            Self::List(format) => list::run(*format),
            Self::Show(args) => args.run(),
            Self::Eval(args) => args.run(),
            Self::Albedo(args) => args.run(),
        }
    }
}

impl ModelArgs {
    /// The shape, with the parameters checked.
    fn shape(&self) -> Result<Shape, Failure> {
        let mut set = Vec::with_capacity(self.set.len());
        for (name, text) in &self.set {
            let value = text.parse::<f64>().map_err(|_| {
                Failure::Usage(format!("parameter '{name}' is '{text}', but must be a number"))
            })?;
            set.push((name.as_str(), value));
        }
        Shape::named(&self.name, &set).map_err(|error| {
            let near = match &error {
                glanz_bsdf::ParamError::UnknownParam { name, known, .. } => {
                    did_you_mean(name, &known.split(", ").collect::<Vec<_>>())
                }
                _ => String::new(),
            };
            Failure::Usage(format!("{error}{near}"))
        })
    }
}

fn params(shape: &Shape) -> serde_json::Map<String, Value> {
    let names = shape.info().params.iter().map(|param| param.name.to_owned());
    names.zip(shape.params().into_iter().map(Value::from)).collect()
}

/// Adds a line.
fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    use std::fmt::Write;
    writeln!(text, "{line}").expect("a string takes everything");
}
