//! `glanz bsdf list` and `glanz bsdf show`.

use clap::Args;
use glanz_bsdf::models::info_named;
use glanz_bsdf::{Law, LightTerm, MODELS, ModelInfo, ParamInfo, Side};
use schemars::JsonSchema;
use serde::Serialize;

use crate::input::lobes::{UnitName, model_names};
use crate::print::failure::Failure;
use crate::print::{self, Format, FormatArgs, finite, line, number};

/// Options of `glanz bsdf show`.
#[derive(Args, Debug)]
pub(crate) struct ShowArgs {
    /// The model's name, from `glanz bsdf list`
    #[arg(value_name = "NAME", value_parser = model_names())]
    name: String,
    /// The unit of the formula
    #[arg(long, value_enum, value_name = "UNIT", default_value_t)]
    unit: UnitName,
    #[command(flatten)]
    format: FormatArgs,
}

impl ShowArgs {
    /// Prints what is known of the model.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let info = info_named(&self.name).map_err(|error| Failure::Usage(error.to_string()))?;
        if self.format.format == Format::Json {
            return print::json(&ModelFacts::of(info, self.unit));
        }
        let mut text = String::new();
        line(&mut text, format_args!("{}: {}", info.name, info.title));
        let name = if self.unit == UnitName::Course { "π · f_cos " } else { "f_cos    " };
        line(&mut text, format_args!("  {name}{}", formula(info, self.unit)));
        if info.formula.contains('π') && !info.delta && self.unit == UnitName::Sr {
            line(
                &mut text,
                format_args!(
                    "  unit     1/sr; --unit course shows π · f_cos, whose peak for Lambert and Phong is 1, as in pictures"
                ),
            );
        }
        line(&mut text, format_args!("  part     {}", term_name(info.term)));
        for (is, what) in kinds(info) {
            if is {
                line(&mut text, format_args!("  kind     {what}"));
            }
        }
        for param in info.params {
            let (min, max, default) = (number(param.min), number(param.max), number(param.default));
            line(
                &mut text,
                format_args!(
                    "  --set {}=…  ({}) {}; {min} to {max}, default {default}",
                    param.name, param.symbol, param.doc
                ),
            );
        }
        for law in [Law::Reciprocity, Law::Energy] {
            match info.exempt.iter().find(|(exempt, _)| *exempt == law) {
                Some((_, reason)) => line(&mut text, format_args!("  {:<12} no: {reason}", law.name())),
                None => line(&mut text, format_args!("  {:<12} yes", law.name())),
            }
        }
        for (law, reason) in
            info.exempt.iter().filter(|(law, _)| !matches!(law, Law::Reciprocity | Law::Energy))
        {
            line(&mut text, format_args!("  {:<12} no: {reason}", law.name()));
        }
        line(&mut text, format_args!("  cost     {} operations", info.operations));
        line(&mut text, format_args!("  source   {}", info.source));
        print::text(&text)
    }
}

/// The formula in a unit: without the 1/π of the classic models in that of the course.
fn formula(info: &ModelInfo, unit: UnitName) -> String {
    let pis = info.formula.matches('π').count();
    match unit {
        UnitName::Sr => info.formula.to_owned(),
        UnitName::Course if info.delta => info.formula.to_owned(),
        UnitName::Course if pis == 1 && info.formula.contains(" / π") => info.formula.replace(" / π", ""),
        UnitName::Course => format!("π · ({})", info.formula),
    }
}

fn term_name(term: LightTerm) -> &'static str {
    match term {
        LightTerm::Ambient => "ambient",
        LightTerm::Diffuse => "diffuse",
        LightTerm::Specular => "specular",
        LightTerm::Emission => "emission",
    }
}

/// Prints all models.
pub(crate) fn run(format: FormatArgs) -> Result<(), Failure> {
    if format.format == Format::Json {
        return print::json(&ListDocument {
            models: MODELS.iter().map(|info| ModelFacts::of(info, UnitName::Sr)).collect(),
        });
    }
    let mut text = format!("{:<24} {:<9} {:<12} {}\n", "name", "part", "parameters", "title");
    for info in MODELS {
        let params = info.params.iter().map(|param| param.name).collect::<Vec<_>>().join(",");
        let params = if params.is_empty() { "-" } else { &params };
        line(
            &mut text,
            format_args!("{:<24} {:<9} {params:<12} {}", info.name, term_name(info.term), info.title),
        );
    }
    print::text(&text)
}

/// What distinguishes models, and in what words.
fn kinds(info: &ModelInfo) -> [(bool, &'static str); 3] {
    [
        (info.side == Side::Transmission, "light passes through: it comes from below the surface"),
        (info.anisotropic, "anisotropic: values depend on the azimuth"),
        (info.delta, "light goes into a single direction: f_cos is 0"),
    ]
}

/// The models of reflection.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ListDocument {
    /// All models, in the order of their list
    models: Vec<ModelFacts>,
}

/// What is known of a model.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ModelFacts {
    name: &'static str,
    title: &'static str,
    /// The term of the light that it answers: ambient, diffuse, specular or emission
    part: &'static str,
    /// f_cos, the BSDF times the cosine of the light
    formula: String,
    /// The unit of the formula
    unit: &'static str,
    source: &'static str,
    /// Whether light passes through the surface
    transmission: bool,
    /// Whether values depend on the azimuth
    anisotropic: bool,
    /// Whether light goes into a single direction
    delta: bool,
    /// What a value costs, in operations
    operations: u32,
    params: Vec<ParamFacts>,
    /// The laws that the model declares to break
    exempt: Vec<ExemptFacts>,
}

/// A parameter of a model.
#[derive(Debug, Serialize, JsonSchema)]
struct ParamFacts {
    name: &'static str,
    symbol: &'static str,
    doc: &'static str,
    /// The least value; null where there is none
    min: Option<f64>,
    /// The greatest value; null where there is none
    max: Option<f64>,
    default: f64,
}

/// A law that a model declares to break.
#[derive(Debug, Serialize, JsonSchema)]
struct ExemptFacts {
    law: &'static str,
    reason: &'static str,
}

impl ModelFacts {
    fn of(info: &'static ModelInfo, unit: UnitName) -> Self {
        let param = |param: &'static ParamInfo| ParamFacts {
            name: param.name,
            symbol: param.symbol,
            doc: param.doc,
            min: finite(param.min),
            max: finite(param.max),
            default: param.default,
        };
        Self {
            name: info.name,
            title: info.title,
            part: term_name(info.term),
            formula: formula(info, unit),
            unit: unit.symbol(),
            source: info.source,
            transmission: info.side == Side::Transmission,
            anisotropic: info.anisotropic,
            delta: info.delta,
            operations: info.operations,
            params: info.params.iter().map(param).collect(),
            exempt: info.exempt.iter().map(|(law, reason)| ExemptFacts { law: law.name(), reason }).collect(),
        }
    }
}
