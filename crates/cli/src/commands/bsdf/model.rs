//! A model with its parameters, as the command line gives it.

use clap::Args;
use glanz_bsdf::Shape;
use glanz_math::names::did_you_mean;
use serde_json::Value;

use crate::args;
use crate::input::lobes::model_names;
use crate::print::failure::Failure;

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

impl ModelArgs {
    /// The shape, with the parameters checked.
    pub fn shape(&self) -> Result<Shape, Failure> {
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
                    did_you_mean(name, known.split(", "))
                }
                _ => String::new(),
            };
            Failure::Usage(format!("{error}{near}"))
        })
    }
}

/// The parameters for programs.
pub fn params(shape: &Shape) -> serde_json::Map<String, Value> {
    let names = shape.info().params.iter().map(|param| param.name.to_owned());
    names.zip(shape.params().into_iter().map(Value::from)).collect()
}
