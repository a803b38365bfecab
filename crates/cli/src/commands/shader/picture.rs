//! `glanz shader picture`: a value of a line of a program as a picture.

use std::collections::BTreeMap;

use clap::Args;
use glanz_picture::Frame;
use glanz_picture::output::{Metadata, PictureData};
use glanz_render::{NOT_REACHED, ValueFrame};
use schemars::JsonSchema;
use serde::Serialize;

use super::scene::SceneArgs;
use crate::args::{Target, TargetArgs, numbers};
use crate::encode;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shader picture scene.toml --fs my.frag --value cosTheta -o cosine.png
  glanz shader picture scene.toml --fs my.frag --line 14 --value R --range -1,1 -o mirrored.png
  glanz shader picture scene.toml --fs my.frag --line 14 --value cosTheta --format json

A number is grey from the least (black) to the greatest (white) that there is, or over --range; two or three are red,
green and blue over the same range. Where the value is NaN the picture is magenta, where the program did not come to the
line dark blue, where it draws nothing transparent.";

/// Options of `glanz shader picture`.
#[derive(Args, Debug)]
pub(crate) struct PictureArgs {
    #[command(flatten)]
    scene: SceneArgs,

    /// The name that the value has in the fragment shader
    #[arg(long, value_name = "NAME", required = true)]
    value: String,

    /// The line on which it gets the value [default: the last one]
    #[arg(long, value_name = "LINE")]
    line: Option<u32>,

    /// What is black and what is white [default: the least and the greatest value]
    #[arg(long, value_name = "LOW,HIGH", value_parser = range, allow_hyphen_values = true)]
    range: Option<[f32; 2]>,

    #[command(flatten)]
    target: TargetArgs,
    #[command(flatten)]
    format: FormatArgs,
}

fn range(text: &str) -> Result<[f32; 2], String> {
    let both: Result<[f64; 2], _> = numbers(text)?.try_into();
    match both {
        Ok([low, high]) if low < high => Ok([low as f32, high as f32]),
        _ => Err("expected the least and the greatest value, such as -1,1".to_owned()),
    }
}

/// NaN is magenta.
const NAN_COLOR: [u8; 4] = [255, 0, 255, 255];
/// Where the program did not come is dark blue.
const UNREACHED_COLOR: [u8; 4] = [16, 16, 64, 255];

impl PictureArgs {
    /// Draws.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let target = self.target.resolve(&self.scene.input.input, "_value.png")?;
        encode::expect_png(&target, "a value of a program")?;
        self.format.check_beside(&target)?;
        let (_, mut shot) = self.scene.shot()?;
        let found = shot.value_frame(&self.value, self.line)?;
        let seen = Seen::of(&found.frame, self.range);
        if seen.reached == 0 && seen.nan == 0 {
            return Err(self.not_met(&found));
        }
        let rgba = seen.codes(&found.frame);
        let (width, height) = (found.frame.width, found.frame.height);
        let picture = PictureData::Codes8 { width, height, rgba };
        encode::deliver(picture, &target, &Metadata::default())?;
        if let Target::File(path) = &target {
            print::note(format_args!("wrote {}", path.display()));
        }
        self.tell(&target, &seen)
    }

    /// That there is no such value, and which there are.
    fn not_met(&self, found: &ValueFrame) -> Failure {
        let line = self.line.map_or(String::new(), |line| format!(" on line {line}"));
        let names = found.met.keys().map(|(_, name)| name.as_str());
        let near = glanz_math::names::did_you_mean(&self.value, names);
        let report = Report::new(format!("no pixel has a value '{}'{line}{near}", self.value));
        let mut by_line: BTreeMap<u32, Vec<&str>> = BTreeMap::new();
        for (line, name) in found.met.keys() {
            by_line.entry(*line).or_default().push(name);
        }
        let told: Vec<_> =
            by_line.iter().map(|(line, names)| format!("{line}: {}", names.join(", "))).collect();
        match told.is_empty() {
            true => report.into(),
            false => report.help(format!("there are, by line: {}", told.join("; "))).into(),
        }
    }

    fn tell(&self, target: &Target, seen: &Seen) -> Result<(), Failure> {
        let document = Document {
            file: target.file(),
            value: self.value.clone(),
            line: self.line,
            least: Some(seen.least).filter(|v| v.is_finite()),
            greatest: Some(seen.greatest).filter(|v| v.is_finite()),
            black: seen.range[0],
            white: seen.range[1],
            pixels: seen.reached,
            nan_pixels: seen.nan,
            first_nan: seen.first_nan.map(|(x, y)| PixelFacts { x, y }),
            unreached_pixels: seen.unreached,
        };
        if self.format.is_json() {
            return print::json(&document);
        }
        let [low, high] = [seen.least, seen.greatest];
        print::note(format_args!(
            "{} is {low} to {high} over {} pixels; black is {}, white is {}",
            self.value, seen.reached, seen.range[0], seen.range[1]
        ));
        if let Some((x, y)) = seen.first_nan {
            print::note(format_args!("note: {} pixels are NaN, the first is {x},{y}", seen.nan));
        }
        if seen.unreached > 0 {
            print::note(format_args!("note: the program does not come there at {} pixels", seen.unreached));
        }
        Ok(())
    }
}

/// What the pixels of a value have.
struct Seen {
    least: f32,
    greatest: f32,
    /// What is black and what is white.
    range: [f32; 2],
    reached: usize,
    nan: usize,
    first_nan: Option<(usize, usize)>,
    unreached: usize,
}

/// What a pixel has.
enum Pixel {
    Nothing,
    Unreached,
    NaN,
    Value([f32; 3]),
}

fn pixel(frame: &Frame, at: usize) -> Pixel {
    let rgb = frame.rgb.each_ref().map(|plane| plane[at]);
    match rgb {
        _ if frame.alpha[at] == 0.0 => Pixel::Nothing,
        [first, ..] if first == NOT_REACHED => Pixel::Unreached,
        rgb if rgb.iter().any(|value| value.is_nan()) => Pixel::NaN,
        rgb => Pixel::Value(rgb),
    }
}

impl Seen {
    fn of(frame: &Frame, range: Option<[f32; 2]>) -> Self {
        let mut seen = Self {
            least: f32::INFINITY,
            greatest: f32::NEG_INFINITY,
            range: [0.0, 1.0],
            reached: 0,
            nan: 0,
            first_nan: None,
            unreached: 0,
        };
        for at in 0..frame.width * frame.height {
            match pixel(frame, at) {
                Pixel::Nothing => {}
                Pixel::Unreached => seen.unreached += 1,
                Pixel::NaN => {
                    seen.nan += 1;
                    seen.first_nan = seen.first_nan.or(Some((at % frame.width, at / frame.width)));
                }
                Pixel::Value(values) => {
                    seen.reached += 1;
                    seen.least = values.into_iter().fold(seen.least, f32::min);
                    seen.greatest = values.into_iter().fold(seen.greatest, f32::max);
                }
            }
        }
        let whole = [seen.least, seen.greatest].map(|v| v.clamp(f32::MIN, f32::MAX));
        seen.range = range.unwrap_or(if seen.reached == 0 { [0.0, 1.0] } else { whole });
        seen
    }

    /// The picture, straight codes: what is half way is half.
    fn codes(&self, frame: &Frame) -> Vec<u8> {
        let [low, high] = self.range.map(f64::from);
        let code = |value: f32| {
            let part = if high > low { (f64::from(value) - low) / (high - low) } else { 0.5 };
            (part.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
        };
        let color = |at| match pixel(frame, at) {
            Pixel::Nothing => [0; 4],
            Pixel::Unreached => UNREACHED_COLOR,
            Pixel::NaN => NAN_COLOR,
            Pixel::Value([r, g, b]) => [code(r), code(g), code(b), 255],
        };
        (0..frame.width * frame.height).flat_map(color).collect()
    }
}

/// A value of a program as a picture.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The picture's file
    file: Option<String>,
    value: String,
    /// The line that was asked for
    line: Option<u32>,
    /// The least number that a pixel has; null where that is infinite
    least: Option<f32>,
    /// The greatest
    greatest: Option<f32>,
    /// The number that is black
    black: f32,
    /// The number that is white
    white: f32,
    /// How many pixels have a number
    pixels: usize,
    /// How many are NaN
    nan_pixels: usize,
    /// The first of them
    first_nan: Option<PixelFacts>,
    /// At how many the program does not come to the line
    unreached_pixels: usize,
}

/// A pixel: its column and its row from the top left
#[derive(Debug, Serialize, JsonSchema)]
struct PixelFacts {
    x: usize,
    y: usize,
}
