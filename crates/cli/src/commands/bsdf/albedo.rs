//! `glanz bsdf albedo`: the part of the light that leaves.

use std::collections::BTreeMap;

use clap::Args;
use glanz_bsdf::{LightTerm, albedo_with};
use schemars::JsonSchema;
use serde::Serialize;

use super::model::{ModelArgs, TintFacts, params};
use crate::input::lobes::FactorArgs;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, line, number};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz bsdf albedo phong-normalized --set shininess=8 --theta 0,30,60
  glanz bsdf albedo blinn-phong-normalized --set shininess=100 --ior Au --lambda-nm 650";

/// Options of `glanz bsdf albedo`.
#[derive(Args, Debug)]
pub(crate) struct AlbedoArgs {
    #[command(flatten)]
    model: ModelArgs,

    /// Angles of the viewer from the normal, in degrees
    #[arg(long, value_name = "THETA,…", value_delimiter = ',', default_value = "0,15,30,45,60,75")]
    theta: Vec<f64>,

    /// Azimuths of the viewer, for anisotropic models, in degrees [default: 0]
    #[arg(long, value_name = "PHI,…", value_delimiter = ',', allow_hyphen_values = true)]
    phi: Vec<f64>,

    #[command(flatten)]
    factor: FactorArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// The part of the light that leaves.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The model's name
    model: &'static str,
    params: BTreeMap<&'static str, f64>,
    /// One for each angle of the viewer
    values: Vec<AlbedoFacts>,
    #[serde(flatten)]
    tint: TintFacts,
}

/// The albedo for one direction of the viewer.
#[derive(Debug, Serialize, JsonSchema)]
struct AlbedoFacts {
    theta_deg: f64,
    /// The azimuth, where --phi was given
    #[serde(skip_serializing_if = "Option::is_none")]
    phi_deg: Option<f64>,
    albedo: f64,
}

impl AlbedoArgs {
    /// Prints the albedos.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let shape = self.model.shape()?;
        let info = shape.info();
        if matches!(info.term, LightTerm::Ambient | LightTerm::Emission) {
            let name = info.name;
            return Err(Failure::Usage(format!(
                "'{name}' has no albedo: it answers to no light from a direction"
            )));
        }
        if info.delta {
            let name = info.name;
            return Err(Failure::Usage(format!(
                "'{name}' has no albedo to integrate: it sends light into a single direction"
            )));
        }
        self.check()?;
        if !self.phi.is_empty() && !info.anisotropic {
            let name = info.name;
            return Err(Failure::Usage(format!(
                "--phi has no effect on {name}: its values do not depend on the azimuth"
            )));
        }
        let factor = self.factor.factor()?;
        let azimuths = if self.phi.is_empty() { &[0.0][..] } else { &self.phi };
        let row = |theta: f64, phi: f64| {
            let f_cos = |pair: &_| factor.f_cos(&shape, pair);
            (theta, phi, albedo_with(&shape, theta.to_radians().cos(), phi.to_radians(), f_cos))
        };
        let rows: Vec<_> =
            self.theta.iter().flat_map(|theta| azimuths.iter().map(|phi| row(*theta, *phi))).collect();
        if self.format.is_json() {
            let value = |&(theta_deg, phi, albedo): &(f64, f64, f64)| {
                let phi_deg = (!self.phi.is_empty()).then_some(phi);
                AlbedoFacts { theta_deg, phi_deg, albedo }
            };
            return print::json(&Document {
                model: info.name,
                params: params(&shape),
                values: rows.iter().map(value).collect(),
                tint: TintFacts::of(&factor, self.factor.nm()),
            });
        }
        print::text(&self.table(&rows))
    }

    fn check(&self) -> Result<(), Failure> {
        if let Some(wrong) = self.theta.iter().find(|theta| !(0.0..=90.0).contains(*theta)) {
            return Err(Failure::Usage(format!(
                "--theta holds {wrong}, but must be between 0 and 90 degrees"
            )));
        }
        match self.phi.iter().find(|phi| !phi.is_finite()) {
            Some(wrong) => Err(Failure::Usage(format!("--phi holds {wrong}, but must be finite"))),
            None => Ok(()),
        }
    }

    fn table(&self, rows: &[(f64, f64, f64)]) -> String {
        let azimuths = !self.phi.is_empty();
        let mut text = if azimuths { "theta    phi  albedo\n" } else { "theta  albedo\n" }.to_owned();
        for (theta, phi, albedo) in rows {
            match azimuths {
                true => {
                    line(&mut text, format_args!("{:>5}  {:>5}  {albedo:.5}", number(*theta), number(*phi)))
                }
                false => line(&mut text, format_args!("{:>5}  {albedo:.5}", number(*theta))),
            }
        }
        text
    }
}
