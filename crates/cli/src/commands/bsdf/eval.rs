//! `glanz bsdf eval`: values for directions.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_bsdf::{DirectionPair, Shape, Side};
use glanz_math::Vec3;
use glanz_plot::Factor;
use glanz_plot::reflection::Unit;
use schemars::JsonSchema;
use serde::Serialize;

use super::delta::DeltaFacts;
use super::model::{ModelArgs, TintFacts, params};
use super::table;
use crate::args;
use crate::input::lobes::{FactorArgs, UnitName};
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz bsdf eval phong --set shininess=32 --wo 30,0 --wi 45,180
  glanz bsdf eval blinn-phong --ior Cu --lambda-nm 600 --wo 30,0 --wi 45,180
  glanz bsdf eval lambert --wo 0,0 --wi 60,0 --unit course
  glanz bsdf eval mirror --ior 1.5 --wo 60,0 --wi 60,180
  glanz bsdf eval phong --directions dirs.csv -o values.csv

The columns of --directions are found by their names in the first line: theta_o_deg, phi_o_deg,
theta_i_deg and phi_i_deg, or wo_x, wo_y, wo_z, wi_x, wi_y and wi_z. All columns come back, with
f_cos and f behind them; in --unit course they are π times that, called pi_f_cos and pi_f. A Fresnel
tint is that of pictures: of highlights at the half vector, of matte lobes along the normal. Delta
lobes (mirror, refraction) have a direction and a factor in place of a value.";

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

    /// The unit of the values
    #[arg(long, value_enum, value_name = "UNIT", default_value_t)]
    unit: UnitName,

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
        if self.output.is_some() && self.directions.is_none() {
            let message = "-o is for the values of --directions; those of one pair are printed";
            return Err(Failure::Usage(message.to_owned()));
        }
        if let Some(directions) = &self.directions {
            if self.format.is_json() {
                let message = "--directions gives CSV; --format json is for one pair of directions";
                return Err(Failure::Usage(message.to_owned()));
            }
            let names = if self.unit == UnitName::Course { ["pi_f_cos", "pi_f"] } else { ["f_cos", "f"] };
            let unit = self.unit.into();
            return table::run(directions, self.output.as_deref(), names, |wo, wi| {
                values(&shape, &factor, unit, wo, wi)
            });
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
        let (to_viewer, to_light) = (direction(wo), direction(wi));
        let (f_cos, f) = values(shape, factor, self.unit.into(), to_viewer, to_light);
        let pair = DirectionPair::new(to_viewer, to_light);
        let tint = TintFacts::of_pair(factor, self.factor.nm(), shape, &pair);
        let delta = DeltaFacts::of(shape, factor, to_viewer, to_light);
        if self.format.is_json() {
            return print::json(&Document {
                model: shape.info().name,
                params: params(shape),
                unit: self.unit.symbol(),
                wo_deg: wo,
                wi_deg: wi,
                cos_i: to_light.z,
                f_cos,
                f,
                delta,
                tint,
            });
        }
        if let Some(delta) = delta {
            return print::text(&delta.text());
        }
        let side = if shape.info().side == Side::Transmission { "below" } else { "above" };
        let f = match f {
            Some(f) => self.value(f),
            None => format!("- (the light is not {side} the surface)"),
        };
        print::text(&format!("f_cos  {}\nf      {f}\n{}", self.value(f_cos), tint.text(shape)))
    }

    /// A value for people, in both units.
    fn value(&self, value: f64) -> String {
        use std::f64::consts::PI;
        match self.unit {
            _ if value == 0.0 => format!("0 {}", self.unit.symbol()),
            UnitName::Sr => format!("{} 1/sr = {} / π", number(value), number(value * PI)),
            UnitName::Course => format!("{} / (π sr) = {} 1/sr", number(value), number(value / PI)),
        }
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
    /// The BSDF times the cosine; 0 for delta lobes
    f_cos: f64,
    /// The BSDF; null where the light is on the wrong side
    f: Option<f64>,
    /// Of a delta lobe, which has no values: where its light comes from, and how much of it arrives
    #[serde(skip_serializing_if = "Option::is_none")]
    delta: Option<DeltaFacts>,
    #[serde(flatten)]
    tint: TintFacts,
}

/// BSDF times cosine, and the BSDF where the light is on its side.
fn values(shape: &Shape, factor: &Factor, unit: Unit, wo: Vec3<f64>, wi: Vec3<f64>) -> (f64, Option<f64>) {
    let f_cos = unit.scale() * factor.f_cos(shape, &DirectionPair::new(wo, wi));
    let cosine = if shape.info().side == Side::Transmission { -wi.z } else { wi.z };
    (f_cos, (cosine > LEAST_COSINE).then(|| f_cos / cosine))
}
