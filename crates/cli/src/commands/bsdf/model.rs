//! A model with its parameters, as the command line gives it.

use std::collections::BTreeMap;

use clap::Args;
use glanz_bsdf::Shape;
use glanz_math::names::did_you_mean;
use glanz_plot::Factor;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args;
use crate::input::lobes::model_names;
use crate::print::failure::Failure;

/// A model with its parameters.
#[derive(Args, Debug)]
pub(super) struct ModelArgs {
    /// The model's name, from `glanz bsdf list`
    #[arg(value_name = "NAME", value_parser = model_names())]
    name: String,

    /// A parameter, such as shininess=32; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = args::assignment)]
    set: Vec<(String, String)>,
}

impl ModelArgs {
    /// The shape, with the parameters checked.
    pub(super) fn shape(&self) -> Result<Shape, Failure> {
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
pub(super) fn params(shape: &Shape) -> BTreeMap<&'static str, f64> {
    shape.info().params.iter().map(|param| param.name).zip(shape.params()).collect()
}

/// What a lobe is multiplied with, if anything, for programs.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub(super) struct TintFacts {
    /// What the lobe is multiplied with
    #[serde(skip_serializing_if = "Option::is_none")]
    tint: Option<String>,
    /// The wavelength at which that is taken
    #[serde(skip_serializing_if = "Option::is_none")]
    lambda_nm: Option<f64>,
}

impl TintFacts {
    /// That of a factor at a wavelength; nothing where there is no factor.
    pub(super) fn of(factor: &Factor, nm: f64) -> Self {
        let name = factor.name();
        match name.is_empty() {
            true => Self::default(),
            false => Self { tint: Some(name.to_owned()), lambda_nm: Some(nm) },
        }
    }
}
