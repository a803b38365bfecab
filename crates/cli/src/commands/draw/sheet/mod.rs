//! `glanz sheet`: balls of one model, in rows and columns of its parameters.

mod ball;

use clap::Args;
use clap::builder::PossibleValuesParser;
use glanz_bsdf::Shape;
use glanz_math::names::did_you_mean;
use glanz_plot::{Grid, Variation};
use glanz_scene::builtin::Builtin;

use self::ball::Ball;
use super::stage_sheet::StageSheetArgs;
use crate::args::{choices, size};
use crate::input::models::{self, models};
use crate::print::failure::Failure;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz sheet phong --vary shininess=2,8,32,128 -o row.png
  glanz sheet blinn-phong-normalized --vary shininess=8:512:5 --vary ior=Au,Cu,Al,1.5 -o sheet.png
  glanz sheet lambert --vary tint=gold,copper,0.5 --light A --mesh torus

The last --vary runs along the columns, all others along the rows, the first one slowest.
Beside the parameters of the model, ior (a metal, a glass or a refractive index: Fresnel's law)
and tint (a spectrum or a reflectance) are keys. Without --mode, sheets are drawn in spectral mode.";

/// The most columns where one value alone varies.
const DEFAULT_COLUMNS: u32 = 8;

/// Options of `glanz sheet`.
#[derive(Args, Debug)]
pub(crate) struct SheetArgs {
    /// The model's name, from `glanz bsdf list`, or a BRDF of one's own, as `glanz shader certify` takes it
    #[arg(value_name = "MODEL", value_parser = models(), hide_possible_values = true)]
    model: String,

    /// A parameter, ior or tint, and the values it takes in turn: NAME=a,b,c or NAME=start:stop:count; may be
    /// repeated
    #[arg(long, value_name = "NAME=VALUES", value_parser = crate::input::vary::variation, required = true)]
    vary: Vec<Variation>,

    /// A parameter, ior or tint for all balls, such as shininess=32; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = crate::args::assignment)]
    set: Vec<(String, String)>,

    /// The spectrum of all lamps, from `glanz color list lights` or a file [default: D65]
    #[arg(long, value_name = "NAME")]
    light: Option<String>,

    /// What is drawn in place of a ball
    #[arg(long, value_name = "MESH", value_parser = PossibleValuesParser::new(Builtin::NAMES),
          default_value = "sphere")]
    mesh: String,

    /// Width and height of each picture, in pixels
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "192x192")]
    size: (u32, u32),

    /// Samples per pixel for smooth edges
    #[arg(long, value_name = "N", value_parser = choices::samples(), default_value = "8")]
    samples: u32,

    /// Pictures per row where one value alone varies
    #[arg(long, value_name = "N", default_value_t = DEFAULT_COLUMNS,
          value_parser = clap::value_parser!(u32).range(1..=1000))]
    columns: u32,

    #[command(flatten)]
    sheet: StageSheetArgs,
}

impl SheetArgs {
    /// Draws the sheet.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let shape = models::shape(&self.model)?;
        let target = self.sheet.begin(&file_name(shape.info().name))?;
        self.check_keys(&shape)?;
        let grid = Grid { variations: &self.vary, columns: self.columns as usize, cell: self.size };
        let cells = grid.cells()?;
        let balls = cells.iter().map(|cell| self.ball(&shape, cell)).collect::<Result<Vec<_>, _>>()?;
        let stages = balls.into_iter().map(|ball| ball.input(self.size));
        let sheet = grid.sheet(cells.len());
        let canvas = self.sheet.draw(&sheet, stages, self.size, self.samples)?;
        self.sheet.deliver(canvas, &target, &cells, sheet.per_row)
    }

    /// The ball of one cell: what is varied comes before what is set.
    fn ball(&self, shape: &Shape, cell: &[(String, String)]) -> Result<Ball, Failure> {
        let values: Vec<_> = self.set.iter().chain(cell).cloned().collect();
        Ball::new(shape, &values, &self.mesh, self.light.as_deref())
    }

    /// That every key is one, and none is varied twice.
    fn check_keys(&self, shape: &Shape) -> Result<(), Failure> {
        let info = shape.info();
        let known: Vec<_> = info.params.iter().map(|param| param.name).chain(["ior", "tint"]).collect();
        let varied = self.vary.iter().map(|vary| ("--vary", vary.path.as_str()));
        let keys: Vec<_> = varied.chain(self.set.iter().map(|(key, _)| ("--set", key.as_str()))).collect();
        for (index, (option, key)) in keys.iter().enumerate() {
            if !known.contains(key) {
                let near = did_you_mean(key, known.iter().copied());
                let known = known.join(", ");
                let model = &self.model;
                return Err(Failure::Usage(format!(
                    "{option} {key}: '{model}' has no parameter '{key}' (keys are: {known}){near}"
                )));
            }
            if keys[..index].iter().any(|(_, other)| other == key) {
                return Err(Failure::Usage(format!("'{key}' is given twice")));
            }
        }
        let given = |name: &str| keys.iter().any(|(_, key)| *key == name);
        match given("ior") && given("tint") {
            true => Err(Failure::Usage("ior and tint are both given; a lobe has one of them".to_owned())),
            false => Ok(()),
        }
    }
}

/// A model's name as a file's: what no name of a file should have becomes a line.
fn file_name(model: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' };
    model.chars().map(plain).collect()
}
