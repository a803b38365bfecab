//! A model with its parameters, as the command line gives it.

use std::collections::BTreeMap;

use clap::Args;
use glanz_bsdf::{DirectionPair, LightTerm, Shape, Side};
use glanz_math::names::did_you_mean;
use glanz_plot::{Factor, number};
use schemars::JsonSchema;
use serde::Serialize;

use crate::args;
use crate::input::models::{self, models};
use crate::print::failure::Failure;

/// A model with its parameters.
#[derive(Args, Debug)]
pub(crate) struct ModelArgs {
    /// The model's name, from `glanz bsdf list`, or a BRDF of one's own, as `glanz shader certify` takes it
    #[arg(value_name = "NAME", value_parser = models(), hide_possible_values = true)]
    name: String,

    /// A parameter, such as shininess=32; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = args::assignment)]
    set: Vec<(String, String)>,
}

impl ModelArgs {
    /// The shape, with the parameters checked.
    pub(crate) fn shape(&self) -> Result<Shape, Failure> {
        shape_of(&self.name, &self.set)
    }
}

/// The shape of a model, with these parameters checked.
pub(crate) fn shape_of(name: &str, set: &[(String, String)]) -> Result<Shape, Failure> {
    let mut shape = models::shape(name)?;
    for (name, text) in set {
        let value = text
            .parse::<f64>()
            .map_err(|_| Failure::Usage(format!("parameter '{name}' is '{text}', but must be a number")))?;
        shape = shape.with(name, value).map_err(|error| {
            let near = match &error {
                glanz_bsdf::ParamError::UnknownParam { name, known, .. } => {
                    did_you_mean(name, known.split(", "))
                }
                _ => String::new(),
            };
            Failure::Usage(format!("{error}{near}"))
        })?;
    }
    Ok(shape)
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
    /// What that is for the pair of directions
    #[serde(skip_serializing_if = "Option::is_none")]
    tint_value: Option<f64>,
    /// The cosine at which a Fresnel tint is taken: towards the half vector, or 1 for matte lobes
    #[serde(skip_serializing_if = "Option::is_none")]
    fresnel_cosine: Option<f64>,
}

impl TintFacts {
    /// That of a factor at a wavelength; nothing where there is no factor.
    pub(super) fn of(factor: &Factor, nm: f64) -> Self {
        let name = factor.name();
        match name.is_empty() {
            true => Self::default(),
            false => Self { tint: Some(name.to_owned()), lambda_nm: Some(nm), ..Self::default() },
        }
    }

    /// The same with the factor's value for two directions.
    pub(super) fn of_pair(factor: &Factor, nm: f64, shape: &Shape, pair: &DirectionPair<f64>) -> Self {
        let facts = Self::of(factor, nm);
        if facts.tint.is_none() {
            return facts;
        }
        let cosine = matches!(factor, Factor::Fresnel(_)).then(|| shape.fresnel_cosine(pair));
        Self { tint_value: Some(factor.value(shape, pair)), fresnel_cosine: cosine, ..facts }
    }

    /// A line for people that says what the value was multiplied with; nothing where it was not.
    pub(super) fn text(&self, shape: &Shape) -> String {
        let (Some(name), Some(nm), Some(value)) = (&self.tint, self.lambda_nm, self.tint_value) else {
            return String::new();
        };
        let (value, nm) = (number(value), number(nm));
        let kind = if shape.info().side == Side::Transmission { "transmittance" } else { "reflectance" };
        let Some(cosine) = self.fresnel_cosine else {
            return format!(
                "tint   {value} is in both: {name} at {nm} nm
"
            );
        };
        let place = match shape.info().term {
            LightTerm::Specular => {
                format!(
                    "at {}° from its facets",
                    number((libm::acos(cosine).to_degrees() * 1e4).round() / 1e4)
                )
            }
            _ => "along the normal, as pictures take it for matte lobes".to_owned(),
        };
        format!(
            "tint   {value} is in both: the Fresnel {kind} of {name} at {nm} nm, {place}
"
        )
    }
}
