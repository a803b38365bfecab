//! `glanz lighting-error`: how far the fast way to light from areas and environments is from the exact one.

use clap::Args;
use glanz_picture::compare::frames::{DeltaE, Developed};
use glanz_plot::{Canvas, ContactSheet};
use glanz_render::LightError;
use glanz_scene::Lighting;
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
  glanz lighting-error scene.toml -o map.png
  glanz lighting-error scene.toml --light-samples 4096 --size 400x300 --format json

The scene is drawn twice, with --lighting fast and with --lighting exact, and the pictures are compared by
CIEDE2000 over the pixels that show a surface. With shadows, what hides an area or an environment in part counts,
too. The exact picture is found by --light-samples points of each light at each pixel; how far it may be off by
itself is told.";

/// Options of `glanz lighting-error`.
#[derive(Args, Debug)]
pub(crate) struct LightingErrorArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,
    /// The difference with the brightest colour of the map [default: the greatest that there is, at least 1]
    #[arg(long, value_name = "DE00", value_parser = above_zero)]
    heat: Option<f64>,
    #[command(flatten)]
    pictures: SideBySideArgs,
}

/// Parses a number above 0.
fn above_zero(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "expected a number above 0".to_owned())
}

/// Both pictures, and how far they are apart.
struct Compared {
    fast: Developed,
    exact: Developed,
    delta: DeltaE,
    /// How far the exact one may be off; none where no light has an extent.
    own: Option<LightError>,
}

impl LightingErrorArgs {
    /// Draws and measures.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let look = &self.pictures.look;
        if look.lighting.is_some() {
            let message = "--lighting has no place here: both ways are drawn";
            return Err(Failure::Usage(message.to_owned()));
        }
        if look.show.is_some_and(|show| !show.is_light()) {
            let message = "--show must be a view of light here: the others have no lighting";
            return Err(Failure::Usage(message.to_owned()));
        }
        let (target, input) = self.pictures.begin(&self.input, "_lighting.png", "a comparison")?;
        let (compared, remarked) = self.compared(&input)?;
        let top = self.heat.unwrap_or_else(|| compared.delta.spread.max.max(1.0));
        self.pictures.deliver(compared.sheet(top)?, &target, &input)?;
        let mut notes: Vec<String> = input.notes.iter().cloned().chain(remarked.tell()).collect();
        if compared.own.is_none() {
            let note = "the scene has neither areas nor environments: both ways are the same";
            print::note(format_args!("note: {note}"));
            notes.push(note.to_owned());
        }
        self.tell(&target, &compared, notes)
    }

    fn compared(&self, input: &Input) -> Result<(Compared, Remarked), Failure> {
        let mut progress = Progress::new(2, "pictures");
        let mut remarked = Remarked::default();
        let mut draw = |lighting: Lighting| -> Result<(Developed, Option<LightError>), Failure> {
            let mut look = self.pictures.look.clone();
            look.lighting = Some(lighting);
            if lighting == Lighting::Fast {
                look.light_samples = None;
            }
            let mut shot = self.pictures.plan(input, &look)?.shot(&input.scene)?;
            let picture = pipeline::developed(&mut shot, &mut progress)?;
            progress.step();
            if lighting == Lighting::Fast {
                remarked.look(&mut shot, &input.scene, &drawn(&picture).into(), String::new)?;
            }
            Ok((picture, shot.light_error()?))
        };
        let (fast, _) = draw(Lighting::Fast)?;
        let (exact, own) = draw(Lighting::Exact)?;
        let ev = self.pictures.develop.resolve(&input.scene.render)?.ev;
        let delta = DeltaE::between(&fast.frame, &exact.frame, ev);
        Ok((Compared { fast, exact, delta, own }, remarked))
    }

    fn tell(&self, target: &Target, compared: &Compared, notes: Vec<String>) -> Result<(), Failure> {
        let Target::File(path) = target else {
            print::note(compared.table().trim_end());
            return Ok(());
        };
        if self.pictures.format.format == Format::Text {
            return print::text(&compared.table());
        }
        print::json(&Document {
            file: path.display().to_string(),
            pixels: compared.delta.pixels,
            delta_e_00: SpreadFacts::of(&compared.delta),
            exact: compared.own.as_ref().map(ExactFacts::of),
            notes,
        })
    }
}

impl Compared {
    fn sheet(&self, top: f64) -> Result<Canvas, Failure> {
        let cell = (self.fast.frame.width, self.fast.frame.height);
        let spread = self.delta.spread;
        let numbers = vec![
            format!("dE00 mean {:.2}, median {:.2}", spread.mean, spread.median),
            format!("95 % {:.2}, max {:.2}", spread.p95, spread.max),
        ];
        let sheet = ContactSheet {
            columns: [
                "fast".to_owned(),
                "exact".to_owned(),
                format!("dE00 0..{}", print::number(rounded(top))),
            ]
            .into(),
            captions: vec![Vec::new(), Vec::new(), numbers],
            per_row: 3,
            count: 3,
            cell,
            ..ContactSheet::default()
        };
        let mut canvas = sheet.begin()?;
        let pictures = [drawn(&self.fast), drawn(&self.exact), heat_map(&self.delta, cell, top)];
        for (index, picture) in pictures.iter().enumerate() {
            sheet.put(&mut canvas, index, picture);
        }
        Ok(canvas)
    }

    /// The numbers for people.
    fn table(&self) -> String {
        let spread = self.delta.spread;
        let mut text = format!(
            "ΔE00 of fast to exact lighting, over the {} pixels that show a surface\n      mean     median       95 %        max\n",
            self.delta.pixels
        );
        let [mean, median, p95, max] = [spread.mean, spread.median, spread.p95, spread.max];
        text += &format!("{mean:>10.3} {median:>10.3} {p95:>10.3} {max:>10.3}\n");
        if let Some(own) = &self.own {
            text += &format!("exact: {own}\n");
        }
        text
    }
}

/// How far the fast way to light is from the exact one.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The sheet with both pictures and the map of errors
    file: String,
    /// How many pixels show a surface
    pixels: usize,
    /// CIEDE2000 over these pixels
    delta_e_00: SpreadFacts,
    /// How far the exact picture may be off by itself; null where no light has an extent
    exact: Option<ExactFacts>,
    /// What was ignored or changed of the scene's file, and what is odd about the picture: black, clipped, a mistake
    notes: Vec<String>,
}

/// How far light by points is off, by the difference of both halves of them, in parts of the mean over the surfaces.
#[derive(Debug, Serialize, JsonSchema)]
struct ExactFacts {
    /// Points of each light at each pixel
    points: u32,
    /// At so many pixels
    pixels: usize,
    /// The root of the mean square
    rms: f64,
    /// The greatest
    max: f64,
}

impl ExactFacts {
    fn of(error: &LightError) -> Self {
        let LightError { points, pixels, rms, most } = *error;
        Self { points, pixels, rms, max: most }
    }
}
