//! `glanz bsdf`: the models of reflection, and their numbers.

use std::fmt::Write;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, Subcommand};
use glanz_bsdf::models::info_named;
use glanz_bsdf::{Law, MODELS, ModelInfo, Pair, Part, Shape};
use glanz_math::Vec3;
use serde_json::{Value, json};

use crate::cli::args;
use crate::cli::failure::Failure;
use crate::cli::print::{self, Format, FormatArgs, number};

/// The least cosine by which a value is divided.
const LEAST_COSINE: f64 = 1e-12;

/// What to do with the models.
#[derive(Subcommand, Debug)]
pub enum BsdfCommand {
    /// All models, one per line
    #[command(after_help = "Example:\n  glanz bsdf list --format json")]
    List(FormatArgs),
    /// All that is known of one model: formula, parameters, laws, source
    #[command(after_help = "Example:\n  glanz bsdf show blinn-phong")]
    Show(ShowArgs),
    /// The value for one pair of directions
    #[command(after_help = "Example:\n  glanz bsdf eval phong --set shininess=32 --wo 30,0 --wi 45,180")]
    Eval(EvalArgs),
    /// The part of the light that leaves, by the angle that it is seen from
    #[command(
        after_help = "Example:\n  glanz bsdf albedo phong-normalized --set shininess=8 --theta 0,30,60"
    )]
    Albedo(AlbedoArgs),
}

/// Options of `glanz bsdf show`.
#[derive(Args, Debug)]
pub struct ShowArgs {
    /// The model's name, from `glanz bsdf list`
    #[arg(value_name = "NAME", value_parser = names())]
    name: String,
    #[command(flatten)]
    format: FormatArgs,
}

/// A model with its parameters.
#[derive(Args, Debug)]
pub struct ModelArgs {
    /// The model's name, from `glanz bsdf list`
    #[arg(value_name = "NAME", value_parser = names())]
    name: String,

    /// A parameter, such as shininess=32; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = args::assignment)]
    set: Vec<(String, String)>,
}

/// Options of `glanz bsdf eval`.
#[derive(Args, Debug)]
pub struct EvalArgs {
    #[command(flatten)]
    model: ModelArgs,

    /// The direction to the viewer: angle from the normal and azimuth, in degrees
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true)]
    wo: [f64; 2],

    /// The direction to the light: angle from the normal and azimuth, in degrees
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true)]
    wi: [f64; 2],

    #[command(flatten)]
    format: FormatArgs,
}

/// Options of `glanz bsdf albedo`.
#[derive(Args, Debug)]
pub struct AlbedoArgs {
    #[command(flatten)]
    model: ModelArgs,

    /// Angles of the viewer from the normal, in degrees
    #[arg(long, value_name = "THETA,…", value_delimiter = ',', default_value = "0,15,30,45,60,75")]
    theta: Vec<f64>,

    #[command(flatten)]
    format: FormatArgs,
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
            Self::List(format) => list(*format),
            Self::Show(args) => show(args),
            Self::Eval(args) => eval(args),
            Self::Albedo(args) => albedo(args),
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
        Shape::named(&self.name, &set).map_err(|error| Failure::Usage(error.to_string()))
    }
}

/// Parses the name of a model.
fn names() -> PossibleValuesParser {
    PossibleValuesParser::new(MODELS.iter().map(|info| PossibleValue::new(info.name).help(info.title)))
}

fn part_name(part: Part) -> &'static str {
    match part {
        Part::Ambient => "ambient",
        Part::Diffuse => "diffuse",
        Part::Specular => "specular",
        Part::Emission => "emission",
    }
}

fn law_name(law: Law) -> &'static str {
    match law {
        Law::Reciprocity => "reciprocity",
        Law::Energy => "energy",
    }
}

fn list(format: FormatArgs) -> Result<(), Failure> {
    if format.format == Format::Json {
        return print::json(&MODELS.iter().map(describe).collect());
    }
    let mut text = format!("{:<24} {:<9} {:<12} {}\n", "name", "part", "parameters", "title");
    for info in MODELS {
        let params = info.params.iter().map(|param| param.name).collect::<Vec<_>>().join(",");
        let params = if params.is_empty() { "-" } else { &params };
        line(
            &mut text,
            format_args!("{:<24} {:<9} {params:<12} {}", info.name, part_name(info.part), info.title),
        );
    }
    print::text(&text)
}

fn show(args: &ShowArgs) -> Result<(), Failure> {
    let info = info_named(&args.name).map_err(|error| Failure::Usage(error.to_string()))?;
    if args.format.format == Format::Json {
        return print::json(&describe(info));
    }
    let mut text = String::new();
    line(&mut text, format_args!("{}: {}", info.name, info.title));
    line(&mut text, format_args!("  f_cos    {}", info.formula));
    line(&mut text, format_args!("  part     {}", part_name(info.part)));
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
            Some((_, reason)) => line(&mut text, format_args!("  {:<12} no: {reason}", law_name(law))),
            None => line(&mut text, format_args!("  {:<12} yes", law_name(law))),
        }
    }
    line(&mut text, format_args!("  source   {}", info.source));
    print::text(&text)
}

fn describe(info: &ModelInfo) -> Value {
    let params = info.params.iter().map(|param| {
        json!({
            "name": param.name, "symbol": param.symbol, "doc": param.doc,
            "min": param.min, "max": param.max, "default": param.default,
        })
    });
    let exempt = info.exempt.iter().map(|(law, reason)| json!({ "law": law_name(*law), "reason": reason }));
    json!({
        "name": info.name, "title": info.title, "part": part_name(info.part), "formula": info.formula,
        "source": info.source, "params": params.collect::<Vec<_>>(), "exempt": exempt.collect::<Vec<_>>(),
    })
}

fn params(shape: &Shape) -> serde_json::Map<String, Value> {
    let names = shape.info().params.iter().map(|param| param.name.to_owned());
    names.zip(shape.params().into_iter().map(Value::from)).collect()
}

fn direction([theta, phi]: [f64; 2]) -> Vec3<f64> {
    Vec3::from_angles(theta.to_radians(), phi.to_radians())
}

fn eval(args: &EvalArgs) -> Result<(), Failure> {
    let shape = args.model.shape()?;
    let (wo, wi) = (direction(args.wo), direction(args.wi));
    let f_cos = shape.f_cos(&Pair::new(wo, wi));
    let f = (wi.z > LEAST_COSINE).then(|| f_cos / wi.z);
    if args.format.format == Format::Json {
        return print::json(&json!({
            "model": shape.info().name, "params": params(&shape), "unit": "1/sr",
            "wo_deg": args.wo, "wi_deg": args.wi, "cos_i": wi.z, "f_cos": f_cos, "f": f,
        }));
    }
    let f = f.map_or("- (the light is not above the surface)".to_owned(), |f| format!("{} 1/sr", number(f)));
    print::text(&format!("f_cos  {} 1/sr\nf      {f}\n", number(f_cos)))
}

fn albedo(args: &AlbedoArgs) -> Result<(), Failure> {
    let shape = args.model.shape()?;
    let info = shape.info();
    if matches!(info.part, Part::Ambient | Part::Emission) {
        let name = info.name;
        return Err(Failure::Usage(format!(
            "'{name}' has no albedo: it answers to no light from a direction"
        )));
    }
    if let Some(wrong) = args.theta.iter().find(|theta| !(0.0..=90.0).contains(*theta)) {
        return Err(Failure::Usage(format!("--theta holds {wrong}, but must be between 0 and 90 degrees")));
    }
    let rows: Vec<_> = args
        .theta
        .iter()
        .map(|&theta| (theta, glanz_bsdf::albedo(&shape, theta.to_radians().cos())))
        .collect();
    if args.format.format == Format::Json {
        let values: Vec<_> =
            rows.iter().map(|(theta, albedo)| json!({ "theta_deg": theta, "albedo": albedo })).collect();
        return print::json(&json!({ "model": info.name, "params": params(&shape), "values": values }));
    }
    let mut text = "theta  albedo\n".to_owned();
    for (theta, albedo) in rows {
        line(&mut text, format_args!("{:>5}  {albedo:.5}", number(theta)));
    }
    print::text(&text)
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
