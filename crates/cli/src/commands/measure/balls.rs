//! Balls of two materials, and maps of their differences.

use glanz_color::srgb_decode_u8;
use glanz_picture::compare::{Metric, MetricOptions, Pair, Picture, Scale, Spread, heat_colors};
use glanz_plot::figure::PictureRow;
use glanz_plot::{Canvas, ContactSheet, number};
use glanz_scene::stage::MaterialStage;
use glanz_scene::{LightColor, LightKind, Material};

use crate::args::{CameraArgs, DevelopArgs, LookArgs};
use crate::load::input_of_stage;
use crate::pipeline::{self, Plan};
use crate::print::failure::Failure;
use crate::print::timings::Timings;
use crate::progress::Progress;

/// The stages, as documents call them.
const STAGES: [&str; 2] = ["lamps", "studio"];

/// Stops by which lamps alone are exposed more.
const LAMPS_EV: f64 = 1.5;

/// Samples per pixel.
const SAMPLES: u32 = 8;

/// The differences that the brightest colour of a map may stand for: the least that 95 of 100 pixels are below.
const BRIGHTEST: [f64; 4] = [1.0, 2.0, 5.0, 10.0];

/// Both balls on each stage, and the map of their differences.
pub(super) struct Balls {
    stages: Vec<Stage>,
    size: (u32, u32),
}

struct Stage {
    pictures: [Canvas; 2],
    map: Canvas,
    spread: Spread,
    /// What the brightest colour of the map stands for.
    brightest: f64,
}

/// The balls of one material, stage by stage.
#[derive(Clone)]
pub(super) struct Drawn(Vec<Canvas>);

impl Drawn {
    /// How many pictures it has.
    pub(super) const PICTURES: usize = STAGES.len();

    /// Draws them.
    pub(super) fn of(
        material: &Material,
        light: &LightColor,
        size: (u32, u32),
        progress: &mut Progress,
    ) -> Result<Self, Failure> {
        let stage = MaterialStage::new(light.clone());
        let mut draw = |name: &&str| -> Result<Canvas, Failure> {
            let mut scene = stage.scene(material.clone(), size);
            if *name == "lamps" {
                scene.lights.retain(|light| matches!(light.kind, LightKind::Directional { .. }));
                scene.render.ev += LAMPS_EV;
            }
            let input = input_of_stage(scene);
            let look = LookArgs { samples: Some(SAMPLES), ..LookArgs::default() };
            let plan = Plan::new(&input, Some(size), &look, &CameraArgs::default(), DevelopArgs::default())?;
            let mut shot = plan.shot(&input.scene)?;
            let canvas = pipeline::codes(&mut shot, &mut Timings::default(), progress)?;
            progress.step();
            Ok(canvas)
        };
        STAGES.iter().map(&mut draw).collect::<Result<_, _>>().map(Self)
    }
}

impl Balls {
    /// Of two materials, with the differences.
    pub(super) fn of([a, b]: [Drawn; 2], size: (u32, u32)) -> Result<Self, Failure> {
        let mut stages = Vec::new();
        for pictures in a.0.into_iter().zip(b.0).map(|(a, b)| [a, b]) {
            let pair = Pair::new(picture(&pictures[0]), picture(&pictures[1]), true).map_err(Failure::new)?;
            let measured = pair.measure(Metric::De2000, &MetricOptions::default()).map_err(Failure::new)?;
            let brightest = brightest(measured.spread.p95);
            let rgba = heat_colors(&measured.map, brightest);
            let map = Canvas { width: size.0 as usize, height: size.1 as usize, rgba };
            stages.push(Stage { pictures, map, spread: measured.spread, brightest });
        }
        Ok(Self { stages, size })
    }

    /// How differences are spread, on each stage.
    pub(super) fn spreads(&self) -> [(&'static str, Spread); 2] {
        [0, 1].map(|i| (STAGES[i], self.stages[i].spread))
    }

    /// All of them, for a sheet with more.
    pub(super) fn rows(self) -> Vec<PictureRow> {
        let row = |(name, stage): (&str, Stage)| {
            let ([a, b], spread) = (stage.pictures, stage.spread);
            let [mean, p95] = [spread.mean, spread.p95].map(|value| number(round(value)));
            PictureRow {
                heading: format!("Balls, {name}: ΔE₀₀ mean {mean}, 95 of 100 below {p95}"),
                pictures: vec![a, b, stage.map],
                brightest: stage.brightest,
            }
        };
        STAGES.into_iter().zip(self.stages).map(row).collect()
    }

    /// All of them in one picture.
    pub(super) fn sheet(&self, names: [&str; 2]) -> Result<Canvas, Failure> {
        let captions = STAGES.iter().zip(&self.stages).flat_map(|(name, stage)| {
            let (spread, brightest) = (stage.spread, stage.brightest);
            let map = format!("dE00 0 to {brightest}: mean {:.2}, 95 % {:.2}", spread.mean, spread.p95);
            [format!("{}, {name}", names[0]), format!("{}, {name}", names[1]), map]
        });
        let sheet = ContactSheet {
            captions: captions.map(|caption| vec![caption]).collect(),
            per_row: 3,
            count: 3 * STAGES.len(),
            cell: (self.size.0 as usize, self.size.1 as usize),
            ..ContactSheet::default()
        };
        let mut canvas = sheet.begin()?;
        for (row, stage) in self.stages.iter().enumerate() {
            for (column, picture) in stage.pictures.iter().chain([&stage.map]).enumerate() {
                sheet.put(&mut canvas, 3 * row + column, picture);
            }
        }
        Ok(canvas)
    }
}

/// What the brightest colour of a map stands for.
fn brightest(p95: f64) -> f64 {
    BRIGHTEST.into_iter().find(|top| *top >= p95).unwrap_or(BRIGHTEST[3])
}

/// To hundredths, finer than which no eye sees.
fn round(difference: f64) -> f64 {
    (difference * 100.0).round() / 100.0
}

/// A picture of codes in linear light.
fn picture(canvas: &Canvas) -> Picture {
    let channel = |c: usize| canvas.rgba.chunks(4).map(|code| srgb_decode_u8(code[c])).collect();
    Picture {
        width: canvas.width,
        height: canvas.height,
        rgb: [channel(0), channel(1), channel(2)],
        scale: Scale::Codes,
        notes: Vec::new(),
    }
}
