//! `glanz measure appearance`: the numbers by which engineers name an appearance.

use std::fmt::Write as _;
use std::path::Path;

use clap::Args;
use glanz_bsdf::DirectionPair;
use glanz_math::Vec3;
use glanz_measure::{Data, GlossMeter, Measured, forty_five_zero, multi_angle, sphere};
use schemars::JsonSchema;
use serde::Serialize;

use super::{ReadArgs, read};
use crate::commands::bsdf::ModelArgs;
use crate::input::lobes::FactorArgs;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz measure appearance paint.bsdf
  glanz measure appearance ggx --set alpha=0.1 --ior 1.5 --diffuse 0.3
  glanz measure appearance oren-nayar --format json

Gloss at 20, 60 and 85 degrees is 100 times the flux that the receptor of a gloss meter gets, by that of black
glass of index 1.567, integrated over the apertures of source and receptor (ISO 2813, ASTM D523). Radiance
factors are pi times the BRDF: 45/0, and those of multi-angle instruments, with light at 45 degrees and
detectors by their angle from the mirror direction towards the light. The sphere is 8/d: with all light (SCI),
and without that within 4.1 degrees of the mirror direction (SCE; ports differ from instrument to instrument,
so that number is of this port alone). Channels are those of the data, a model has one, at --lambda-nm.
60 degrees are for all surfaces; above 70 units 20 degrees, below 10 units 85 degrees tell more.";

/// Half the angle of the sphere's port, in degrees.
const PORT_DEG: f64 = 4.1;

/// Angles from the mirror direction.
const ASPECULAR_DEG: [f64; 6] = [-15.0, 15.0, 25.0, 45.0, 75.0, 110.0];

/// Options of `glanz measure appearance`.
#[derive(Args, Debug)]
pub(crate) struct AppearanceArgs {
    #[command(flatten)]
    model: ModelArgs,

    /// The albedo of a matte part that is added to a model
    #[arg(long, value_name = "ALBEDO", default_value_t = 0.0)]
    diffuse: f64,

    #[command(flatten)]
    read: ReadArgs,
    #[command(flatten)]
    factor: FactorArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// Numbers of an appearance.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The file or model
    name: String,
    /// Names of the channels
    channels: Vec<String>,
    /// Gloss units at 20°, per channel
    gloss_20: Vec<f64>,
    /// Gloss units at 60°
    gloss_60: Vec<f64>,
    /// Gloss units at 85°
    gloss_85: Vec<f64>,
    /// The radiance factor of 45°/0°
    factor_45_0: Vec<f64>,
    /// Radiance factors with light at 45°
    multi_angle: Vec<AngleFacts>,
    /// 8°/d with all light
    sphere_included: Vec<f64>,
    /// 8°/d without the light within `port_deg` of the mirror direction
    sphere_excluded: Vec<f64>,
    /// Half the angle of the port
    port_deg: f64,
}

/// A radiance factor.
#[derive(Debug, Serialize, JsonSchema)]
struct AngleFacts {
    /// From the mirror direction towards the light
    aspecular_deg: f64,
    /// πf, per channel
    factor: Vec<f64>,
}

impl AppearanceArgs {
    /// Tells them.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if !(0.0..=1.0).contains(&self.diffuse) {
            return Err(Failure::Usage(format!("--diffuse is {}, but must be from 0 to 1", self.diffuse)));
        }
        let name = self.model.name();
        let path = Path::new(name);
        let endings = ["csv", "binary", "bsdf", "astm", "txt"];
        let ending = path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        let document = match endings.contains(&ending.as_str()) {
            true => self.of_file(path)?,
            false => {
                let (shape, factor) = (self.model.shape()?, self.factor.factor()?);
                let matte = self.diffuse * core::f64::consts::FRAC_1_PI;
                document(name, vec!["Y".to_owned()], &mut |wi, wo| {
                    vec![factor.f_cos(&shape, &DirectionPair::new(wo, wi)) / wi.z.max(1e-12) + matte]
                })
            }
        };
        if self.format.is_json() {
            return print::json(&document);
        }
        print::text(&text(&document))
    }

    fn of_file(&self, path: &Path) -> Result<Document, Failure> {
        let measured = read(path, &self.read)?;
        if matches!(measured.data, Data::Readings(_)) {
            let report =
                Report::new("these numbers are integrals, and readings alone say nothing between them");
            return Err(report
                .file(path)
                .help("a .binary of MERL or a .bsdf of RGL has values everywhere")
                .into());
        }
        let count = measured.channels().count();
        let value = |measured: &Measured, wi: Vec3<f64>, wo: Vec3<f64>| {
            measured.value(wi, wo).unwrap_or_else(|| vec![0.0; count])
        };
        let name = path.display().to_string();
        Ok(document(&name, measured.channels().names(), &mut |wi, wo| value(&measured, wi, wo)))
    }
}

fn document(
    name: &str,
    channels: Vec<String>,
    f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
) -> Document {
    let [sphere_included, sphere_excluded] = sphere(f, PORT_DEG);
    let of_angle = |f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>, angle: f64| AngleFacts {
        aspecular_deg: angle,
        factor: multi_angle(f, angle),
    };
    Document {
        name: name.to_owned(),
        channels,
        gloss_20: GlossMeter::AT_20.gloss(f),
        gloss_60: GlossMeter::AT_60.gloss(f),
        gloss_85: GlossMeter::AT_85.gloss(f),
        factor_45_0: forty_five_zero(f),
        multi_angle: ASPECULAR_DEG.iter().map(|angle| of_angle(f, *angle)).collect(),
        sphere_included,
        sphere_excluded,
        port_deg: PORT_DEG,
    }
}

/// For people.
fn text(facts: &Document) -> String {
    let mut text = String::new();
    let mut line = |name: &str, values: &[f64], digits: usize| {
        let few = &values[..values.len().min(8)];
        let words: Vec<String> = few.iter().map(|value| format!("{value:>9.digits$}")).collect();
        let more = if values.len() > few.len() { "  …" } else { "" };
        writeln!(text, "{name:<16}{}{more}", words.join(" ")).expect("a string takes everything");
    };
    line("gloss 20°", &facts.gloss_20, 1);
    line("gloss 60°", &facts.gloss_60, 1);
    line("gloss 85°", &facts.gloss_85, 1);
    line("45°/0°", &facts.factor_45_0, 4);
    for angle in &facts.multi_angle {
        line(&format!("45° as {:>4}°", angle.aspecular_deg), &angle.factor, 4);
    }
    line("sphere SCI", &facts.sphere_included, 4);
    line("sphere SCE", &facts.sphere_excluded, 4);
    let names: Vec<String> = facts.channels.iter().take(8).map(|name| format!("{name:>9}")).collect();
    format!("{}\n{:<16}{}\n{text}", facts.name, "", names.join(" "))
}
