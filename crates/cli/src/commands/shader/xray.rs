//! `glanz shader xray`: every named value of every line of a program at a pixel or a vertex.

use clap::Args;
use glanz_math::names::shown;
use glanz_render::Xray;
use glanz_scene::Scene;
use glanz_shader::{Record, RecordKind, Source, Stage};
use schemars::JsonSchema;
use serde::Serialize;

use super::scene::{SceneArgs, line_of};
use crate::input::objects::{object_name, object_of};
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shader xray scene.toml --fs phong.frag --pixel 320,240
  glanz shader xray scene.toml --vs gouraud.vert --vertex 17 --object ball
  glanz shader xray scene.toml --fs my.frag --pixel 320,240 --format json

A line for each value that gets a name, each condition and each leap, in the order in which they happen, loops turn by
turn. The numbers are the picture's own, to the last bit, of a picture with one sample in the middle of each pixel.";

/// Options of `glanz shader xray`.
#[derive(Args, Debug)]
pub(crate) struct XrayArgs {
    #[command(flatten)]
    scene: SceneArgs,

    /// Column and row of the pixel, from 0 at the top left
    #[arg(long, value_name = "X,Y", value_parser = pixel, required_unless_present = "vertex")]
    pixel: Option<(u32, u32)>,

    /// In place of a pixel, a vertex of the object's mesh: its gl_VertexID
    #[arg(long, value_name = "NUMBER", conflicts_with = "pixel")]
    vertex: Option<u32>,

    /// The object of --vertex, by its name or its number from 0 [default: the first]
    #[arg(long, value_name = "NAME", requires = "vertex")]
    object: Option<String>,

    #[command(flatten)]
    format: FormatArgs,
}

/// Parses a pixel.
fn pixel(text: &str) -> Result<(u32, u32), String> {
    let both = text.split_once(',').and_then(|(x, y)| Some((x.trim().parse().ok()?, y.trim().parse().ok()?)));
    both.ok_or_else(|| "expected the column and the row of a pixel, such as 320,240".to_owned())
}

impl XrayArgs {
    /// Looks, and tells.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let (scene, mut shot) = self.scene.shot()?;
        let (xray, what) = match (self.pixel, self.vertex) {
            (_, Some(vertex)) => {
                let object = self.object.as_deref().map_or(Ok(0), |name| object_of(&scene, name))?;
                (shot.xray_vertex(object, vertex)?, format!("vertex {vertex}"))
            }
            (Some((x, y)), None) => (shot.xray(x, y)?, format!("pixel {x},{y}")),
            (None, None) => return Err(Failure::Usage("name a --pixel or a --vertex".to_owned())),
        };
        let Some(xray) = xray else {
            let message = match self.vertex {
                Some(vertex) => format!("the object's mesh has no vertex {vertex}"),
                None => {
                    format!("no program draws {what}: nothing is there, or an object with a material alone")
                }
            };
            return Err(Report::new(message).into());
        };
        if let Some(error) = xray.trace.error() {
            print::note(format_args!("note: {error}"));
        }
        match self.format.is_json() {
            true => print::json(&Document::new(&xray, &scene)),
            false => print::text(&text(&xray, &scene, &what)),
        }
    }
}

/// What happened, in words.
fn happened(record: &Record, lane: usize) -> String {
    let values = record.values(lane);
    match record.kind {
        RecordKind::Branch => {
            let taken = record.taken() >> lane & 1 == 1;
            format!("{} {}", record.name, if taken { "yes" } else { "no" })
        }
        RecordKind::Leave => record.name.clone(),
        RecordKind::Value => {
            let numbers: Vec<_> = values.iter().map(|value| number(*value)).collect();
            let columns = record.ty.columns.max(1);
            let joined = match (numbers.len(), columns) {
                (1, _) => numbers[0].clone(),
                (n, c) if c > 1 => {
                    let column = |column: &[String]| format!("({})", column.join(", "));
                    format!("({})", numbers.chunks(n / c).map(column).collect::<Vec<_>>().join(", "))
                }
                _ => format!("({})", numbers.join(", ")),
            };
            format!("{} = {joined}", record.name)
        }
    }
}

/// A number of single precision, as short as it is told apart.
fn number(value: f32) -> String {
    match value {
        value if value.is_nan() => "NaN".to_owned(),
        value if value.is_infinite() => (if value > 0.0 { "+inf" } else { "-inf" }).to_owned(),
        value => format!("{value}"),
    }
}

fn is_nan(record: &Record, lane: usize) -> bool {
    record.nan_lanes() >> lane & 1 == 1
}

/// For people.
fn text(xray: &Xray, scene: &Scene, what: &str) -> String {
    let stage = xray.stage.name();
    let mut text = format!("{what}, object '{}', {stage} shader", shown(&object_name(scene, xray.object)));
    if xray.source == Source::StandIn {
        text.push_str(match xray.stage {
            Stage::Vertex => " that stands in for one of yours",
            Stage::Fragment => " that shows the vertex shader's colour",
        });
    }
    text.push('\n');
    let lane = xray.lane;
    let records: Vec<_> = xray.trace.of_lane(lane).collect();
    let told: Vec<(String, String)> = records
        .iter()
        .map(|record| {
            let line = record.place.as_ref().map_or(String::new(), |place| place.line.to_string());
            (line, happened(record, lane))
        })
        .collect();
    let width = told.iter().map(|(_, what)| what.chars().count()).max().unwrap_or(0).min(60);
    let mut nan_told = false;
    for (record, (line, what)) in records.iter().zip(&told) {
        let place = record.place.as_ref();
        let source = place.and_then(|place| line_of(scene, &place.file, place.line)).unwrap_or_default();
        // Of a loop it is asked whether it ends.
        let is_loop = ["for", "while"].iter().any(|word| source.starts_with(word));
        let what = if is_loop { what.replacen("if ", "ends: ", 1) } else { what.clone() };
        let first_nan = is_nan(record, lane) && !nan_told;
        nan_told |= first_nan;
        let mark = if first_nan { "  <- the first NaN" } else { "" };
        print::line(&mut text, format_args!("{line:>5}  {what:width$}  {source}{mark}"));
    }
    if xray.trace.left_out() > 0 {
        print::line(&mut text, format_args!("and {} more, left out", xray.trace.left_out()));
    }
    text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// A program at a pixel or vertex.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    object: String,
    /// vertex or fragment
    stage: &'static str,
    /// Whether the text of the stage is the user's
    own: bool,
    /// What happened, in order
    records: Vec<RecordFacts>,
    /// How many records were too many
    left_out: usize,
    /// Why the program did not come to its end; null if it did
    error: Option<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct RecordFacts {
    /// value, branch or leave
    kind: &'static str,
    name: String,
    /// As GLSL names it
    r#type: String,
    file: Option<String>,
    line: Option<u32>,
    column: Option<u32>,
    /// Components, column by column; null for NaN and infinities, which `words` has
    values: Vec<Option<f32>>,
    /// The same in words
    words: String,
    /// Of a branch: whether it was taken
    taken: Option<bool>,
    /// How many of the 16 pixels of the block were here
    here: u32,
    /// The least and greatest number of these 16; null where there is none
    extent: Option<[f32; 2]>,
    is_nan: bool,
}

impl Document {
    fn new(xray: &Xray, scene: &Scene) -> Self {
        let records = xray.trace.of_lane(xray.lane).map(|record| RecordFacts::new(record, xray.lane));
        Self {
            object: object_name(scene, xray.object),
            stage: xray.stage.name(),
            own: xray.source == Source::Own,
            records: records.collect(),
            left_out: xray.trace.left_out(),
            error: xray.trace.error().map(ToString::to_string),
        }
    }
}

impl RecordFacts {
    fn new(record: &Record, lane: usize) -> Self {
        let place = record.place.as_ref();
        Self {
            kind: match record.kind {
                RecordKind::Value => "value",
                RecordKind::Branch => "branch",
                RecordKind::Leave => "leave",
            },
            name: record.name.clone(),
            r#type: record.ty.to_string(),
            file: place.map(|place| place.file.clone()),
            line: place.map(|place| place.line),
            column: place.map(|place| place.column),
            values: record.values(lane).into_iter().map(|v| Some(v).filter(|v| v.is_finite())).collect(),
            words: happened(record, lane),
            taken: (record.kind == RecordKind::Branch).then(|| record.taken() >> lane & 1 == 1),
            here: record.lanes.count_ones(),
            extent: record
                .extent()
                .map(|(low, high)| [low, high])
                .filter(|e| e.iter().all(|v| v.is_finite())),
            is_nan: is_nan(record, lane),
        }
    }
}
