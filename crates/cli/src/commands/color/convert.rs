//! `glanz color convert`: one colour in another model.

use std::collections::BTreeMap;
use std::fmt::Write;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use glanz_color::models::{Channel, Limit, Model, convert};
use schemars::JsonSchema;
use serde::Serialize;

use crate::args;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color convert --from hls --to ac1c2 210,0.4,0.8
  glanz color convert --from srgb --to lab 1,0.5,0
  glanz color convert --from srgb --to oklch '#ff8000'
  glanz color convert --from lab --to oklch --format json -- 50,-20,30

White is D65 in all models, and XYZ of white has Y = 1. 'glanz color list models' tells the
numbers of each model and their ranges. A colour that a model cannot hold is an error, never
another colour.";

/// Options of `glanz color convert`.
#[derive(Args, Debug)]
pub(crate) struct ConvertArgs {
    /// The model of the numbers
    #[arg(long, value_name = "MODEL", value_parser = models())]
    from: String,

    /// The model asked for
    #[arg(long, value_name = "MODEL", value_parser = models())]
    to: String,

    /// The colour: its numbers in order, between commas; of sRGB also #ff8000
    #[arg(value_name = "NUMBERS", value_parser = numbers, allow_hyphen_values = true)]
    values: Values,

    #[command(flatten)]
    format: FormatArgs,
}

/// A colour in another model.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The model of the numbers
    from: String,
    /// The model asked for
    to: String,
    /// The numbers in the first model
    input: Vec<f64>,
    /// The numbers in the second model
    values: Vec<f64>,
    /// The same by the names of the channels
    channels: BTreeMap<&'static str, f64>,
}

/// The numbers of a colour.
#[derive(Clone, Debug)]
struct Values(Vec<f64>);

fn numbers(text: &str) -> Result<Values, String> {
    match text.strip_prefix('#') {
        Some(digits) => hexadecimal(digits),
        None => args::numbers(text).map(Values),
    }
}

/// The three numbers of `ff8000` or `f80`, from 0 to 1.
fn hexadecimal(digits: &str) -> Result<Values, String> {
    let wrong = || format!("'#{digits}': expected six digits from 0 to f behind the #, or three");
    let width = match digits.len() {
        6 => 2,
        3 => 1,
        _ => return Err(wrong()),
    };
    let most = if width == 2 { 255.0 } else { 15.0 };
    let value = |at: usize| {
        let part = digits
            .get(at * width..(at + 1) * width)
            .filter(|part| part.chars().all(|c| c.is_ascii_hexdigit()));
        part.and_then(|part| u8::from_str_radix(part, 16).ok()).map(|value| f64::from(value) / most)
    };
    (0..3).map(value).collect::<Option<Vec<f64>>>().map(Values).ok_or_else(wrong)
}

/// Beyond this a number is meant on another scale: no display is ten times as bright as its white.
const ANOTHER_SCALE: f64 = 10.0;

/// The channels whose number 1 is white, and the scale on which people give it otherwise: 255 of a device, 100 of X, Y, Z and
/// of lightness.
fn other_scale(model: &str, channels: &[Channel]) -> Option<f64> {
    match model {
        "xyz" | "xyy" | "oklab" | "oklch" => Some(100.0),
        _ => channels.iter().all(|channel| channel.range == [0.0, 1.0]).then_some(255.0),
    }
}

/// Numbers up to 255 or 100 where 1 is white are a mistake, and no colour.
fn check_scale(model: &str, values: &[f64]) -> Result<(), Failure> {
    let info = Model::from_name(model).map_err(|error| Failure::Usage(error.to_string()))?.info();
    let Some(scale) = other_scale(info.name, info.channels) else { return Ok(()) };
    let is_hue = |at: usize| info.channels.get(at).is_some_and(|channel| channel.limit == Limit::Cyclic);
    let is_far = |(at, value): &(usize, &f64)| **value > ANOTHER_SCALE && !is_hue(*at);
    let Some((_, value)) = values.iter().enumerate().find(is_far) else { return Ok(()) };
    let is_scaled = |at: usize| match info.name {
        "xyy" => at == 2,
        "oklab" | "oklch" => !is_hue(at),
        _ => true,
    };
    let scaled = |(at, value): (usize, &f64)| number(if is_scaled(at) { value / scale } else { *value });
    let scaled: Vec<_> = values.iter().enumerate().map(scaled).collect();
    Err(Failure::Usage(format!(
        "{} of {model} is on another scale: 1 is white; from 0 to {scale} it would be {}",
        number(*value),
        scaled.join(",")
    )))
}

/// Says of what was given that no surface and no display has it.
fn note_given(model: &str, channels: &[Channel], values: &[f64]) {
    let is_device =
        channels.iter().all(|channel| channel.range == [0.0, 1.0]) && model != "xyy" && model != "lms";
    let tells = |channel: &Channel| is_device || matches!(channel.name, "L" | "L*" | "Y");
    let outside = channels.iter().zip(values).filter(|(channel, value)| {
        let [low, high] = channel.range;
        let high = if channel.name == "Y" { 1.0 } else { high };
        let slack = OUTSIDE * high.abs().max(1.0);
        tells(channel) && high.is_finite() && !(low - slack..=high + slack).contains(*value)
    });
    let outside: Vec<_> =
        outside.map(|(channel, value)| format!("{} {}", channel.name, number(*value))).collect();
    if !outside.is_empty() {
        let what =
            if is_device { "no display shows it" } else { "it is darker than black or brighter than white" };
        print::note(format_args!("note: {model} was given with {}: {what}", outside.join(", ")));
    }
}

/// Parses the name of a model.
fn models() -> PossibleValuesParser {
    PossibleValuesParser::new(Model::ALL.iter().map(|model| {
        let info = model.info();
        PossibleValue::new(info.name).help(info.title)
    }))
}

impl ConvertArgs {
    /// Converts the colour.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let usage = |error: &dyn std::fmt::Display| Failure::Usage(error.to_string());
        check_scale(&self.from, &self.values.0)?;
        let found = convert(&self.from, &self.to, &self.values.0).map_err(|error| usage(&error))?;
        let given = Model::from_name(&self.from).map_err(|error| usage(&error))?;
        note_given(given.info().name, given.info().channels, &self.values.0);
        let model = Model::from_name(&self.to).map_err(|error| usage(&error))?;
        let channels = model.info().channels;
        let found = settled(channels, found);
        note_outside(&self.to, channels, &found);
        if self.format.is_json() {
            return print::json(&Document {
                from: self.from.clone(),
                to: self.to.clone(),
                input: self.values.0.clone(),
                channels: channels.iter().map(|channel| channel.name).zip(found.iter().copied()).collect(),
                values: found,
            });
        }
        let mut text = String::new();
        for (channel, value) in channels.iter().zip(&found) {
            writeln!(text, "{:<4} {}", channel.name, number(*value)).expect("a string takes everything");
        }
        print::text(&text)
    }
}

/// Numbers below this part of a channel's range are the rounding of matrices, which have some ten digits.
const ROUNDING: f64 = 1e-9;
/// Chroma and saturation below this are those of a grey, whose hue means nothing: the matrices of OKLab give
/// greys up to 1e-7.
const GREY: f64 = 1e-6;
/// How far outside of its range a channel may lie without a remark, by the rounding of printed numbers.
const OUTSIDE: f64 = 1e-6;

/// The numbers without the noise of rounding: 0 where they are next to it, no hue where there is no chroma.
fn settled(channels: &[Channel], mut values: Vec<f64>) -> Vec<f64> {
    let span = |channel: &Channel| channel.range[1].min(100.0) - channel.range[0].max(-100.0);
    let is_grey = channels.iter().zip(&values).any(|(channel, value)| {
        let tells_hue = matches!(channel.name, "C" | "C*" | "S");
        tells_hue && value.abs() <= GREY * if channel.name == "C*" { 100.0 } else { 1.0 }
    });
    let has_hue = channels.iter().any(|channel| channel.limit == Limit::Cyclic);
    for (channel, value) in channels.iter().zip(&mut values) {
        let is_of_grey = has_hue
            && is_grey
            && (channel.limit == Limit::Cyclic || matches!(channel.name, "C" | "C*" | "S"));
        let rounding = if matches!(channel.name, "a" | "b") { GREY } else { ROUNDING * span(channel) };
        if is_of_grey || value.abs() <= rounding {
            *value = 0.0;
        }
    }
    values
}

/// Says where a colour lies outside of what a device of the model shows.
fn note_outside(model: &str, channels: &[Channel], values: &[f64]) {
    let is_device = channels.iter().all(|c| c.range == [0.0, 1.0]) && !matches!(model, "xyy" | "lms");
    let outside = channels.iter().zip(values).filter(|(_, v)| !(-OUTSIDE..=1.0 + OUTSIDE).contains(*v));
    let outside: Vec<_> = outside.map(|(c, value)| format!("{} {}", c.name, number(*value))).collect();
    if is_device && !outside.is_empty() {
        let list = outside.join(", ");
        print::note(format_args!("note: {model} cannot show this colour: {list} outside of 0 to 1"));
    }
}
