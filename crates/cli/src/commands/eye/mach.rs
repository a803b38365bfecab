//! Mach bands along a row of the picture: what is there, and what cells with a centre and a surround answer.

use std::str::FromStr;

use glanz_eye::MachProfile;
use glanz_eye::curves::CenterSurround;
use glanz_plot::chart::LineChart;
use glanz_plot::page::curve_color;
use glanz_plot::{Axis, Curve, Lang};
use glanz_render::Aovs;
use glanz_scene::Shading;
use schemars::JsonSchema;
use serde::Serialize;

use super::EyeArgs;
use crate::args::{LookArgs, PlotTarget};
use crate::input::picture::PictureInput;
use crate::load::Input;
use crate::pipeline::Plan;
use crate::print;
use crate::print::failure::Failure;
use crate::progress::Progress;

/// A row of the picture: `y=250`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Row(pub usize);

impl FromStr for Row {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = text.trim().strip_prefix("y=").unwrap_or(text.trim()).parse();
        number.map(Self).map_err(|_| "expected the row of the picture, such as y=250".to_owned())
    }
}

/// The shadings, and what they are called.
const SHADINGS: [(Shading, &str); 3] =
    [(Shading::Flat, "flat"), (Shading::Gouraud, "Gouraud"), (Shading::Phong, "Phong")];

/// A row of one shading.
struct Shaded {
    name: &'static str,
    profile: MachProfile,
    /// The number of the object in each column, 0 for none.
    object: Vec<u32>,
}

impl Shaded {
    /// Whether a column, as far as a cell sees, shows one object alone: its bands are of shading, not of an outline.
    fn is_inside(&self, x: usize, px_per_deg: f64) -> bool {
        let reach = (3.0 * CenterSurround::P_CELL.surround_deg * px_per_deg).ceil() as usize;
        let last = self.object.len().saturating_sub(1);
        let around = &self.object[x.saturating_sub(reach)..=(x + reach).min(last)];
        around.iter().all(|object| *object != 0 && *object == around[0])
    }
}

/// The least logarithm that the plot shows: a hundredth of the greatest luminance is black on paper.
const LEAST: f64 = -2.0;

/// The Mach bands of a row.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The plot
    file: String,
    /// The row, from the top
    y: usize,
    /// Pixels per degree of sight
    px_per_deg: f64,
    /// How many times as high as predicted bands are drawn
    gain: f64,
    /// For flat, Gouraud and Phong shading
    shadings: Vec<ShadingFacts>,
    /// What was ignored or changed of the scene's file
    notes: Vec<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ShadingFacts {
    shading: &'static str,
    /// From left to right
    bands: Vec<BandFacts>,
}

/// A place that is seen brighter, or darker below 0, than it is.
#[derive(Debug, Serialize, JsonSchema)]
struct BandFacts {
    /// The column
    x: usize,
    /// The same in degrees from the middle of the picture
    degrees: f64,
    /// By how much brighter, in per cent of luminance, without gain
    percent: f64,
    /// Whether it lies within a surface; else it is of an outline
    inside: bool,
}

impl EyeArgs {
    /// Plots the Mach bands of a row.
    pub(super) fn mach(&self, row: Row) -> Result<(), Failure> {
        let Some(path) = &self.target.output else {
            return Err(Failure::Usage(
                "--mach is a plot: name its file with -o, such as -o mach.svg".to_owned(),
            ));
        };
        let target = PlotTarget::of_file(path)?;
        if !(self.eyes.gain > 0.0 && self.eyes.gain <= 1e4) {
            let gain = self.eyes.gain;
            return Err(Failure::Usage(format!("--gain is {gain}, but must be above 0 and at most 10000")));
        }
        if PictureInput::is_named(&self.input.input) {
            let message =
                "--mach draws a scene flat, by Gouraud and by Phong; a picture has one shading already";
            return Err(Failure::Usage(message.to_owned()));
        }
        let input = self.input.load(Some(&self.camera), crate::load::More::default())?;
        print::notes(&self.input.input, &input.notes);
        let (shaded, px_per_deg) = self.shaded(&input, row)?;
        target.save(&mut chart(&shaded, row, px_per_deg, self.eyes.gain))?;
        self.tell_bands(&shaded, row, px_per_deg, input.notes)
    }

    fn shaded(&self, input: &Input, Row(y): Row) -> Result<(Vec<Shaded>, f64), Failure> {
        let look = LookArgs {
            samples: self.picture.samples,
            background: self.picture.background,
            ..LookArgs::default()
        };
        let plan = Plan::new(input, self.size.size, &look, &self.camera, self.develop)?;
        let plan = plan.at(self.input.program.moment());
        let (width, height) = plan.size();
        if y >= height {
            let message = format!("--mach: the picture has rows 0 to {}, but not {y}", height - 1);
            return Err(Failure::Usage(message));
        }
        let mut progress = Progress::new(SHADINGS.len(), "pictures");
        let (mut shaded, mut px_per_deg) = (Vec::new(), 1.0);
        for (shading, name) in SHADINGS {
            let mut shot = plan.shot_shaded(&input.scene, shading)?;
            let aovs = Aovs { object: true, ..Aovs::default() };
            let frame = shot.frame_in_steps(aovs, &mut |_| ())?;
            let screen = shot.on_screen(frame)?;
            px_per_deg = self.eyes.px_per_deg.unwrap_or_else(|| shot.px_per_deg());
            let luminance: Vec<f32> = (0..screen.alpha.len())
                .map(|i| 0.2126 * screen.rgb[0][i] + 0.7152 * screen.rgb[1][i] + 0.0722 * screen.rgb[2][i])
                .collect();
            let profile =
                MachProfile::new(&luminance, width, y, px_per_deg, CenterSurround::P_CELL, self.eyes.gain);
            let object = screen.object[y * width..(y + 1) * width].to_vec();
            shaded.push(Shaded { name, profile, object });
            progress.step();
        }
        Ok((shaded, px_per_deg))
    }

    fn tell_bands(
        &self,
        shaded: &[Shaded],
        Row(y): Row,
        px_per_deg: f64,
        notes: Vec<String>,
    ) -> Result<(), Failure> {
        let facts = |shaded: &Shaded| {
            let Shaded { name, profile, .. } = shaded;
            let middle = profile.log.len() as f64 / 2.0;
            let band = |band: &glanz_eye::MachBand| BandFacts {
                x: band.x,
                degrees: (band.x as f64 + 0.5 - middle) / px_per_deg,
                percent: 100.0 * (libm::pow(10.0, band.height) - 1.0),
                inside: shaded.is_inside(band.x, px_per_deg),
            };
            ShadingFacts { shading: name, bands: profile.bands(self.eyes.gain).iter().map(band).collect() }
        };
        let shadings: Vec<ShadingFacts> = shaded.iter().map(facts).collect();
        let file = self.target.output.as_ref().map_or(String::new(), |path| path.display().to_string());
        if self.format.is_json() {
            return print::json(&Document { file, y, px_per_deg, gain: self.eyes.gain, shadings, notes });
        }
        let line = |ShadingFacts { shading, bands }: &ShadingFacts| {
            let inside = bands.iter().filter(|band| band.inside);
            let (count, highest) =
                inside.fold((0, 0.0_f64), |(n, most), band| (n + 1, most.max(band.percent.abs())));
            format!(
                "{shading:<8} {count:>3} bands within surfaces, the highest {highest:.1} % of luminance
"
            )
        };
        print::text(&shadings.iter().map(line).collect::<String>())
    }
}

/// The three shadings in one plot: the logarithm of luminance dashed, what is seen in full lines; the luminance of Phong shading itself.
fn chart(shaded: &[Shaded], Row(y): Row, px_per_deg: f64, gain: f64) -> LineChart {
    let points =
        |values: &[f64]| values.iter().enumerate().map(|(x, v)| (x as f64 + 0.5, *v)).collect::<Vec<_>>();
    let mut curves = Vec::new();
    if let Some(Shaded { profile, .. }) = shaded.last() {
        let most = profile.luminance.iter().fold(1e-30_f64, |most, v| most.max(*v));
        let parts: Vec<f64> = profile.luminance.iter().map(|v| v / most).collect();
        let name = "luminance, in parts of the greatest (Phong)".to_owned();
        curves.push(Curve { name, points: points(&parts), color: [0x8a, 0x93, 0x9e], dash: None });
    }
    for (index, Shaded { name, profile, .. }) in shaded.iter().enumerate() {
        // Apart by half a decade, so that they do not cover each other.
        let apart = |values: &[f64]| -> Vec<f64> {
            // Bands of outlines are far higher than what is looked for: they are cut.
            values.iter().map(|v| v.clamp(LEAST, 1.0) - 0.5 * index as f64).collect()
        };
        let color = curve_color(index);
        let seen = format!("{name}: predicted");
        curves.push(Curve { name: seen, points: points(&apart(&profile.seen)), color, dash: None });
        let log = format!("{name}: logarithm");
        curves.push(Curve { name: log, points: points(&apart(&profile.log)), color, dash: Some((4.0, 3.0)) });
    }
    let values = curves.iter().flat_map(|curve| curve.points.iter().map(|(_, v)| *v));
    let (least, most) = values.fold((0.0_f64, 1.0_f64), |(least, most), v| (least.min(v), most.max(v)));
    let width = shaded.first().map_or(1, |shaded| shaded.profile.log.len());
    LineChart {
        title: format!("Mach bands along row {y}, bands {gain} times as high"),
        subtitle: format!(
            "{px_per_deg:.0} pixels per degree; P cells, centre 0.021°, surround 0.127° (σ); shadings half a decade apart"
        ),
        x: Axis::exact("column in pixels", (0.0, width as f64), 10),
        y: Axis::round("luminance in decades, and in parts", (least, most), 8),
        curves,
        marks: Vec::new(),
        lang: Lang::En,
    }
}
