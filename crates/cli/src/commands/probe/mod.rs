//! `glanz probe`: one pixel taken apart.

mod document;
mod drawing;
mod text;

use std::path::PathBuf;

use clap::{Args, ValueHint};
use glanz_plot::number;
use glanz_render::{Probe, Shot};
use glanz_scene::{Light, LightKind, Scene};

use crate::args::{CameraArgs, DevelopArgs, InputArgs, LookArgs, PlotTarget, SizeArgs};
use crate::input::objects::object_of;
use crate::load::More;
use crate::pipeline::Plan;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

pub(crate) use document::Document;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz probe scene.toml 320,240
  glanz probe scene.toml 320,240 100,80 --format json
  glanz probe scene.toml --object ball --uv 0.5,0.2
  glanz probe scene.toml 320,240 --plot vectors.svg

Pixels count from 0,0 at the top left. N is the shading normal, L the direction to the light, V that
to the viewer, R that of mirrored light, H the half vector; all along the world's axes. 'pi f_cos' is
the shape of a lobe with its cosine, in the unit in which a light of value 1 on a white matte surface
gives 1. Colours are linear, in the channels of the observer: those of sRGB in mode rgb.";

/// How far texture coordinates may be from those that were asked for, without a remark.
const NEAR_UV: f32 = 0.02;

/// Options of `glanz probe`.
#[derive(Args, Debug)]
pub(crate) struct ProbeArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,

    /// Pixels: column and row
    #[arg(value_name = "X,Y", value_parser = pixel, required_unless_present = "object")]
    pixels: Vec<(u32, u32)>,

    /// A point of this object, by its name or its number from 0, in place of a pixel
    #[arg(long, value_name = "NAME", requires = "uv", conflicts_with = "pixels")]
    object: Option<String>,

    /// The point's texture coordinates
    #[arg(long, value_name = "U,V", requires = "object", value_parser = uv, allow_hyphen_values = true)]
    uv: Option<[f32; 2]>,

    /// Draw N, L, V, R and H into this file, its format by its ending: .svg, .png, .pdf, .csv or .json
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Output")]
    plot: Option<PathBuf>,

    /// The light whose directions --plot draws, by its number in the scene [default: the first that reaches the point]
    #[arg(long, value_name = "NUMBER", requires = "plot", help_heading = "Output")]
    light: Option<usize>,

    #[command(flatten)]
    size: SizeArgs,
    #[command(flatten)]
    look: LookArgs,
    #[command(flatten)]
    camera: CameraArgs,
    #[command(flatten)]
    develop: DevelopArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// Parses a pixel.
fn pixel(text: &str) -> Result<(u32, u32), String> {
    let both = text.split_once(',').and_then(|(x, y)| Some((x.trim().parse().ok()?, y.trim().parse().ok()?)));
    both.ok_or_else(|| "expected the column and the row of a pixel, such as 320,240".to_owned())
}

/// Parses texture coordinates.
fn uv(text: &str) -> Result<[f32; 2], String> {
    let number = |text: &str| text.trim().parse().ok().filter(|value: &f32| value.is_finite());
    let both = text.split_once(',').and_then(|(u, v)| Some([number(u)?, number(v)?]));
    both.ok_or_else(|| "expected two texture coordinates, such as 0.5,0.2".to_owned())
}

impl ProbeArgs {
    /// Takes the pixels apart.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let target = self.plot.as_deref().map(PlotTarget::of_file).transpose()?;
        let input = self.input.load(Some(&self.camera), More::default())?;
        let plan = Plan::new(&input, self.size.size, &self.look, &self.camera, self.develop)?;
        let plan = plan.at(self.input.program.moment());
        let mut shot = plan.shot(&input.scene)?;
        let mut notes = input.notes.clone();
        let pixels = match (&self.object, self.uv) {
            (Some(object), Some(uv)) => vec![of_object(&shot, &input.scene, object, uv, &mut notes)?],
            _ => self.pixels.clone(),
        };
        let probes = pixels.iter().map(|(x, y)| Ok(shot.probe(*x, *y)?));
        let probes: Vec<Probe> = probes.collect::<Result<_, Failure>>()?;
        if let Some(target) = &target {
            let (x, y) = probes[0].pixel;
            let title = format!("{} at {x},{y}", self.input.input.display());
            target.save(&mut drawing::of(&probes[0], &input.scene, self.light, title)?)?;
        }
        if self.format.is_json() {
            return print::json(&Document::new(&probes, &input.scene, &shot, notes));
        }
        notes.iter().for_each(print::note);
        let text: Vec<_> = probes.iter().map(|probe| text::of(probe, &input.scene, &shot)).collect();
        print::text(&text.join("\n"))
    }
}

/// The pixel that shows a point of an object.
fn of_object(
    shot: &Shot,
    scene: &Scene,
    name: &str,
    uv: [f32; 2],
    notes: &mut Vec<String>,
) -> Result<(u32, u32), Failure> {
    let object = object_of(scene, name)?;
    let Some((pixel, found)) = shot.pixel_of(object, uv) else {
        let report = Report::new(format_args!("no pixel shows '{name}' with texture coordinates"));
        return Err(report.help("it is hidden, outside of the picture, or its mesh has none").into());
    };
    if (found[0] - uv[0]).hypot(found[1] - uv[1]) > NEAR_UV {
        let [u, v] = found.map(|c| number(f64::from(c)));
        notes.push(format!("the nearest point of '{name}' that is seen has the texture coordinates {u},{v}"));
    }
    Ok(pixel)
}

/// A light of the scene by its number among those that are not ambient: its number in paths such as lights.0.color, and
/// what it is. The light of `[ambient]`, which stands before the others, has none.
fn light(scene: &Scene, number: usize) -> (usize, String) {
    let is_seen = |light: &&Light| light.kind != LightKind::Ambient;
    let found = scene.lights.iter().enumerate().filter(|(_, light)| is_seen(light)).nth(number);
    let Some((index, light)) = found else { return (number, "light".to_owned()) };
    let kind = match light.kind {
        LightKind::Ambient => "ambient",
        LightKind::Directional { .. } => "directional",
        LightKind::Point { .. } => "point",
        LightKind::Spot { .. } => "spot",
        LightKind::Area { .. } => "area",
        LightKind::Environment { .. } => "environment",
    };
    let by_itself = |light: &Light| light.kind == LightKind::Ambient && light.name == "ambient";
    let index = index - usize::from(scene.lights.first().is_some_and(by_itself));
    (index, if light.name.is_empty() { kind.to_owned() } else { format!("{kind} '{}'", light.name) })
}

/// The name of a material.
fn material_name(scene: &Scene, number: usize) -> String {
    let name = scene.materials.get(number).map_or("", |material| material.name.as_str());
    if name.is_empty() { number.to_string() } else { name.to_owned() }
}
