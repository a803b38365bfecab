//! `glanz shade-compare`: flat, Gouraud and Phong shading side by side, and how far apart they are.

use std::collections::BTreeMap;
use std::fmt::Write;

use clap::Args;
use glanz_picture::compare::frames::{Developed, Difference};
use glanz_plot::{Canvas, ContactSheet};
use glanz_scene::Shading;
use schemars::JsonSchema;
use serde::Serialize;

use super::side_by_side::{SideBySideArgs, drawn};
use crate::args::{InputArgs, Target};
use crate::pipeline;
use crate::print::failure::Failure;
use crate::print::remarked::Remarked;
use crate::print::{self, Format};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shade-compare scene.toml -o three.png
  glanz shade-compare model.glb --size 400x400 --format json

Only pixels that show a surface count. Linear values are those before exposure and tone mapping,
codes are the 8-bit values of the picture, ΔE00 is the colour difference CIEDE2000 of the codes.";

/// The shadings, from the crudest to the one that the others are compared with.
const SHADINGS: [(Shading, &str, &str); 3] = [
    (Shading::Flat, "flat", "flat"),
    (Shading::Gouraud, "gouraud", "Gouraud"),
    (Shading::Phong, "phong", "Phong"),
];

/// Options of `glanz shade-compare`.
#[derive(Args, Debug)]
pub(crate) struct ShadeCompareArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,
    #[command(flatten)]
    pictures: SideBySideArgs,
}

impl ShadeCompareArgs {
    /// Draws and measures.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.pictures.look.shading.is_some() {
            let message = "--shading has no place here: all three shadings are drawn";
            return Err(Failure::Usage(message.to_owned()));
        }
        let (target, input) = self.pictures.begin(&self.input, "_shading.png", "a comparison")?;
        let plan = self.pictures.plan(&input, &self.pictures.look)?.at(self.input.program.moment());
        let mut pictures = Vec::with_capacity(SHADINGS.len());
        let mut progress = Progress::new(SHADINGS.len(), "pictures");
        let mut remarked = Remarked::default();
        for (shading, _, _) in SHADINGS {
            let mut shot = plan.shot_shaded(&input.scene, shading)?;
            let picture = pipeline::developed(&mut shot, &mut progress)?;
            if shading == Shading::Phong {
                remarked.look(&mut shot, &input.scene, &drawn(&picture).into(), String::new)?;
            }
            pictures.push(picture);
            progress.step();
        }
        drop(progress);
        let phong = pictures.last().expect("three pictures were drawn");
        let differences: Vec<_> =
            pictures[..2].iter().map(|picture| Difference::between(picture, phong)).collect();
        self.pictures.deliver(side_by_side(&pictures, &differences)?, &target, &input)?;
        self.tell(&target, &differences, input.notes.into_iter().chain(remarked.tell()).collect())
    }

    fn tell(&self, target: &Target, differences: &[Difference], notes: Vec<String>) -> Result<(), Failure> {
        let Target::File(path) = target else {
            print::note(table(differences).trim_end());
            return Ok(());
        };
        if self.pictures.format.format == Format::Text {
            return print::text(&table(differences));
        }
        let named = SHADINGS.iter().zip(differences);
        let difference = named.map(|((_, name, _), difference)| (*name, DifferenceFacts::of(difference)));
        print::json(&Document {
            file: path.display().to_string(),
            to: "phong",
            difference: difference.collect(),
            notes,
        })
    }
}

/// How far shadings are apart.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The sheet of pictures
    file: String,
    /// The shading that the others are compared with
    to: &'static str,
    /// By the shading
    difference: BTreeMap<&'static str, DifferenceFacts>,
    /// What was ignored or changed of the scene's file, and what is odd about the picture: black, clipped, a mistake
    notes: Vec<String>,
}

/// The distance of two pictures.
#[derive(Debug, Serialize, JsonSchema)]
struct DifferenceFacts {
    /// How many pixels show a surface
    pixels: usize,
    /// Before exposure and tone mapping
    linear: RmseFacts,
    /// Of the 8-bit values of the picture
    codes: RmseFacts,
    mean_delta_e_00: f64,
}

#[derive(Debug, Serialize, JsonSchema)]
struct RmseFacts {
    rmse: f64,
    max: f64,
}

impl DifferenceFacts {
    fn of(difference: &Difference) -> Self {
        Self {
            pixels: difference.pixels,
            linear: RmseFacts { rmse: difference.rmse_linear, max: difference.max_linear },
            codes: RmseFacts { rmse: difference.rmse_codes, max: difference.max_codes.into() },
            mean_delta_e_00: difference.mean_delta_e,
        }
    }
}

/// The numbers for people.
fn table(differences: &[Difference]) -> String {
    let pixels = differences.first().map_or(0, |difference| difference.pixels);
    let mut text = format!("difference to Phong shading, over the {pixels} pixels that show a surface\n");
    text.push_str("          linear RMSE   linear max   codes RMSE   codes max   mean ΔE00\n");
    for ((_, _, title), difference) in SHADINGS.iter().zip(differences) {
        let Difference { rmse_linear, max_linear, rmse_codes, max_codes, mean_delta_e, .. } = difference;
        writeln!(
            text,
            "{title:<8} {rmse_linear:>12.5} {max_linear:>12.5} {rmse_codes:>12.3} {max_codes:>11} {mean_delta_e:>11.3}"
        )
        .expect("a string takes everything");
    }
    text
}

fn side_by_side(pictures: &[Developed], differences: &[Difference]) -> Result<Canvas, Failure> {
    let size = |picture: &Developed| (picture.frame.width, picture.frame.height);
    let mut captions: Vec<_> = differences
        .iter()
        .map(|difference| {
            vec![
                format!("RMSE {:.4}, max {:.4} linear", difference.rmse_linear, difference.max_linear),
                format!("RMSE {:.2}, max {} codes", difference.rmse_codes, difference.max_codes),
            ]
        })
        .collect();
    captions.push(vec!["the others are compared with this".to_owned()]);
    let sheet = ContactSheet {
        columns: SHADINGS.iter().map(|(_, _, title)| (*title).to_owned()).collect(),
        captions,
        per_row: pictures.len(),
        count: pictures.len(),
        cell: size(&pictures[0]),
        ..ContactSheet::default()
    };
    let mut canvas = sheet.begin()?;
    for (index, picture) in pictures.iter().enumerate() {
        sheet.put(&mut canvas, index, &drawn(picture));
    }
    Ok(canvas)
}
