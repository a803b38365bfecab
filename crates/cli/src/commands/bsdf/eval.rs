//! `glanz bsdf eval`: values for directions.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_bsdf::{DirectionPair, Shape, Side};
use glanz_math::Vec3;
use glanz_plot::Factor;
use schemars::JsonSchema;
use serde::Serialize;

use super::model::{ModelArgs, TintFacts, params};
use super::table;
use crate::args;
use crate::input::lobes::FactorArgs;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz bsdf eval phong --set shininess=32 --wo 30,0 --wi 45,180
  glanz bsdf eval blinn-phong --ior Cu --lambda-nm 600 --wo 30,0 --wi 45,180
  glanz bsdf eval phong --directions dirs.csv -o values.csv

The columns of --directions are found by their names in the first line: theta_o_deg, phi_o_deg,
theta_i_deg and phi_i_deg, or wo_x, wo_y, wo_z, wi_x, wi_y and wi_z. All columns come back, with
f_cos and f behind them.";

/// The least cosine by which a value is divided.
const LEAST_COSINE: f64 = 1e-12;

/// Options of `glanz bsdf eval`.
#[derive(Args, Debug)]
pub(crate) struct EvalArgs {
    #[command(flatten)]
    model: ModelArgs,

    /// The direction to the viewer: angle from the normal and azimuth, in degrees
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true,
          required_unless_present = "directions")]
    wo: Option<[f64; 2]>,

    /// The direction to the light: angle from the normal and azimuth, in degrees; beyond 90 it is below
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true,
          required_unless_present = "directions")]
    wi: Option<[f64; 2]>,

    /// A CSV file of directions, or - for stdin
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, conflicts_with_all = ["wo", "wi"])]
    directions: Option<PathBuf>,

    /// Where the values for --directions go as CSV, or - for stdout [default: -]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "directions",
          help_heading = "Output")]
    output: Option<PathBuf>,

    #[command(flatten)]
    factor: FactorArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl EvalArgs {
    /// Prints the value, or writes the table.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let shape = self.model.shape()?;
        let factor = self.factor.factor()?;
        if let Some(directions) = &self.directions {
            if self.format.is_json() {
                let message = "--directions gives CSV; --format json is for one pair of directions";
                return Err(Failure::Usage(message.to_owned()));
            }
            return table::run(directions, self.output.as_deref(), |wo, wi| values(&shape, &factor, wo, wi));
        }
        let (Some(wo), Some(wi)) = (self.wo, self.wi) else {
            return Err(Failure::Usage("--wo and --wi are both needed".to_owned()));
        };
        if wo[0] > 90.0 {
            let theta = wo[0];
            return Err(Failure::Usage(format!(
                "--wo is {theta} degrees from the normal, but the viewer is above the surface: 0 to 90"
            )));
        }
        self.print(&shape, &factor, wo, wi)
    }

    fn print(&self, shape: &Shape, factor: &Factor, wo: [f64; 2], wi: [f64; 2]) -> Result<(), Failure> {
        let direction = |[theta, phi]: [f64; 2]| Vec3::from_angles(theta.to_radians(), phi.to_radians());
        let cos_i = direction(wi).z;
        let (f_cos, f) = values(shape, factor, direction(wo), direction(wi));
        if self.format.is_json() {
            return print::json(&Document {
                model: shape.info().name,
                params: params(shape),
                unit: "1/sr",
                wo_deg: wo,
                wi_deg: wi,
                cos_i,
                f_cos,
                f,
                tint: TintFacts::of(factor, self.factor.nm()),
            });
        }
        let side = if shape.info().side == Side::Transmission { "below" } else { "above" };
        let f = match f {
            Some(f) => format!("{} 1/sr", number(f)),
            None => format!("- (the light is not {side} the surface)"),
        };
        print::text(&format!("f_cos  {} 1/sr\nf      {f}\n", number(f_cos)))
    }
}

/// The value of a model for a pair of directions.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The model's name
    model: &'static str,
    params: BTreeMap<&'static str, f64>,
    /// The unit of f_cos and f
    unit: &'static str,
    /// Angle from the normal and azimuth of the viewer
    wo_deg: [f64; 2],
    /// Angle from the normal and azimuth of the light
    wi_deg: [f64; 2],
    /// The cosine of the light's angle from the normal
    cos_i: f64,
    /// The BSDF times the cosine
    f_cos: f64,
    /// The BSDF; null where the light is on the wrong side
    f: Option<f64>,
    #[serde(flatten)]
    tint: TintFacts,
}

/// BSDF times cosine, and the BSDF where the light is on its side.
fn values(shape: &Shape, factor: &Factor, wo: Vec3<f64>, wi: Vec3<f64>) -> (f64, Option<f64>) {
    let f_cos = factor.f_cos(shape, &DirectionPair::new(wo, wi));
    let cosine = if shape.info().side == Side::Transmission { -wi.z } else { wi.z };
    (f_cos, (cosine > LEAST_COSINE).then(|| f_cos / cosine))
}
