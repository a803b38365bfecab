//! `glanz modes`: one scene in several colour modes side by side, and how far they are from full spectra.

use std::collections::BTreeMap;
use std::fmt::Write;

use clap::Args;
use glanz_picture::compare::frames::{DeltaE, Developed};
use glanz_plot::{Canvas, ContactSheet};
use glanz_render::Shot;
use glanz_scene::ColorMode;
use schemars::JsonSchema;
use serde::Serialize;

use super::side_by_side::{SideBySideArgs, SpreadFacts, drawn, heat_map, rounded};
use crate::args::{InputArgs, Target};
use crate::load::Input;
use crate::pipeline;
use crate::print::failure::Failure;
use crate::print::remarked::Remarked;
use crate::print::{self, Format};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz modes scene.toml -o modes.png
  glanz modes scene.toml --modes rgb,sampled:4,sampled:8,sampled:16 --format json
  glanz modes scene.toml --modes rgb,spectral --against reference --size 160x120

Only pixels that show a surface count. ΔE00 is CIEDE2000 between the pictures before tone mapping, for the
screen's white; below 1 hardly anyone sees a difference. The lower row shows it as heat, from black (0) to
pale yellow (the number under the row).";

/// The modes that are drawn if none are named.
const DEFAULT_MODES: &str = "rgb,meyer,meyer-adapted,sampled:8,spectral";

/// Options of `glanz modes`.
#[derive(Args, Debug)]
pub(crate) struct ModesArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,

    /// The colour modes, in the order of the columns
    #[arg(long, value_name = "MODE,…", value_delimiter = ',', default_value = DEFAULT_MODES,
          value_parser = |text: &str| text.parse::<ColorMode>())]
    modes: Vec<ColorMode>,

    /// The mode that the others are compared with
    #[arg(long, value_name = "MODE", default_value = "spectral",
          value_parser = |text: &str| text.parse::<ColorMode>())]
    against: ColorMode,

    /// The ΔE00 that is the hottest colour [default: the greatest there is, at least 1]
    #[arg(long, value_name = "ΔE")]
    heat: Option<f64>,

    #[command(flatten)]
    pictures: SideBySideArgs,
}

/// A picture in one mode, and its distance from the one that counts as right.
struct Column {
    mode: ColorMode,
    picture: Developed,
    delta: DeltaE,
}

impl ModesArgs {
    /// Draws and measures.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.check()?;
        let (target, input) = self.pictures.begin(&self.input, "_modes.png", "a comparison")?;
        let (columns, remarked) = self.columns(&input)?;
        if columns.is_empty() {
            return Err(Failure::Usage("none of the --modes can be drawn for this observer".to_owned()));
        }
        let top = self.heat.unwrap_or_else(|| greatest(&columns));
        self.pictures.deliver(self.sheet(&columns, top)?, &target, &input)?;
        self.tell(&target, &columns, input.notes.into_iter().chain(remarked.tell()).collect())
    }

    /// The pictures, how far each is from the one that counts as right, and what is odd about that one.
    fn columns(&self, input: &Input) -> Result<(Vec<Column>, Remarked), Failure> {
        let ev = self.look_ev(input)?;
        let sees_otherwise = self.sees_otherwise(input);
        let others = self.modes.iter().filter(|mode| **mode != self.against);
        let mut progress = Progress::new(1 + others.count(), "pictures");
        let (right, mut shot) = self.draw(input, self.against, &mut progress)?;
        let mut remarked = Remarked::default();
        remarked.look(&mut shot, &input.scene, &drawn(&right).into(), String::new)?;
        let mut columns = Vec::with_capacity(self.modes.len());
        for &mode in &self.modes {
            if is_meyer(mode) && sees_otherwise {
                print::note(format_args!("note: mode '{mode}' is left out: it samples for cie1931 alone"));
                continue;
            }
            let is_right = mode == self.against;
            let picture = if is_right { right.clone() } else { self.draw(input, mode, &mut progress)?.0 };
            let delta = DeltaE::between(&picture.frame, &right.frame, ev);
            columns.push(Column { mode, picture, delta });
        }
        Ok((columns, remarked))
    }

    fn draw(
        &self,
        input: &Input,
        mode: ColorMode,
        progress: &mut Progress,
    ) -> Result<(Developed, Shot), Failure> {
        let mut look = self.pictures.look.clone();
        look.color.mode = Some(mode);
        if mode == ColorMode::Rgb {
            // RGB is what a screen shows, whoever looks, and under whatever white.
            (look.color.observer, look.color.white) = (None, None);
        }
        let plan = self.pictures.plan(input, &look)?.at(self.input.program.moment());
        let mut shot = plan.shot(&input.scene)?;
        let picture = pipeline::developed(&mut shot, progress)?;
        progress.step();
        Ok((picture, shot))
    }

    /// The exposure at which differences are judged.
    fn look_ev(&self, input: &Input) -> Result<f32, Failure> {
        Ok(self.pictures.develop.resolve(&input.scene.render)?.ev)
    }

    /// Whether someone else looks than the standard observer.
    fn sees_otherwise(&self, input: &Input) -> bool {
        let own = || input.scene.observer.as_ref().map(|observer| observer.name.as_str());
        self.pictures.look.color.observer.as_deref().or_else(own).is_some_and(|name| name != "cie1931")
    }

    fn check(&self) -> Result<(), Failure> {
        if self.pictures.look.color.mode.is_some() {
            return Err(Failure::Usage("--mode has no place here: --modes names those to draw".to_owned()));
        }
        if self.pictures.look.show.is_some_and(|show| !show.is_light()) {
            return Err(Failure::Usage(
                "--show must be a view of light here: the others have no colour mode".to_owned(),
            ));
        }
        match self.heat {
            Some(heat) if !(heat > 0.0 && heat.is_finite()) => {
                Err(Failure::Usage(format!("--heat is {heat}, but must be a number above 0")))
            }
            _ => Ok(()),
        }
    }

    fn sheet(&self, columns: &[Column], top: f64) -> Result<Canvas, Failure> {
        let count = columns.len();
        let first = &columns[0].picture.frame;
        let cell = (first.width, first.height);
        let numbers = columns.iter().map(|Column { delta, mode, .. }| {
            let s = delta.spread;
            match *mode == self.against {
                true => vec!["the others are compared with this".to_owned()],
                false => vec![
                    format!("dE00 mean {:.2}, median {:.2}", s.mean, s.median),
                    format!("95 % {:.2}, max {:.2}", s.p95, s.max),
                ],
            }
        });
        let captions = columns.iter().map(|_| Vec::new()).chain(numbers).collect();
        let sheet = ContactSheet {
            columns: columns.iter().map(|column| column.mode.to_string()).collect(),
            rows: vec!["picture".to_owned(), format!("dE00\n0..{}", print::number(rounded(top)))],
            captions,
            per_row: count,
            count: 2 * count,
            cell,
            ..ContactSheet::default()
        };
        let mut canvas = sheet.begin()?;
        for (index, Column { picture, delta, .. }) in columns.iter().enumerate() {
            sheet.put(&mut canvas, index, &drawn(picture));
            sheet.put(&mut canvas, count + index, &heat_map(delta, cell, top));
        }
        Ok(canvas)
    }

    fn tell(&self, target: &Target, columns: &[Column], notes: Vec<String>) -> Result<(), Failure> {
        let Target::File(path) = target else {
            print::note(table(columns, self.against).trim_end());
            return Ok(());
        };
        if self.pictures.format.format == Format::Text {
            return print::text(&table(columns, self.against));
        }
        let of = |column: &Column| (column.mode.to_string(), SpreadFacts::of(&column.delta));
        print::json(&Document {
            file: path.display().to_string(),
            against: self.against.to_string(),
            pixels: columns.first().map_or(0, |column| column.delta.pixels),
            delta_e_00: columns.iter().map(of).collect(),
            notes,
        })
    }
}

/// How far colour modes are apart.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The sheet of pictures
    file: String,
    /// The mode that the others are compared with
    against: String,
    /// How many pixels show a surface
    pixels: usize,
    /// CIEDE2000 over these pixels, by the mode
    delta_e_00: BTreeMap<String, SpreadFacts>,
    /// What was ignored or changed of the scene's file, and what is odd about the picture: black, clipped, a mistake
    notes: Vec<String>,
}

/// Whether a mode belongs to the standard observer.
fn is_meyer(mode: ColorMode) -> bool {
    matches!(mode, ColorMode::Meyer | ColorMode::MeyerAdapted)
}

/// The hottest difference, but no less than what an eye can see.
fn greatest(columns: &[Column]) -> f64 {
    columns.iter().map(|column| column.delta.spread.max).fold(1.0, f64::max)
}

/// The numbers for people.
fn table(columns: &[Column], against: ColorMode) -> String {
    let pixels = columns.first().map_or(0, |column| column.delta.pixels);
    let mut text = format!("ΔE00 to mode {against}, over the {pixels} pixels that show a surface\n");
    text.push_str("mode               mean     median       95 %        max\n");
    for Column { mode, delta, .. } in columns.iter().filter(|column| column.mode != against) {
        let s = delta.spread;
        let mode = mode.to_string();
        writeln!(text, "{mode:<14} {:>8.3} {:>10.3} {:>10.3} {:>10.3}", s.mean, s.median, s.p95, s.max)
            .expect("a string takes everything");
    }
    text
}
