//! Balls of two materials, and maps of their differences.

use glanz_color::srgb_decode_u8;
use glanz_picture::compare::{Metric, MetricOptions, Pair, Picture, Scale, Spread, heat_colors};
use glanz_plot::{Canvas, ContactSheet};
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

/// The difference that the hottest colour stands for.
const HOTTEST: f64 = 10.0;

/// Both balls on each stage, and the map of their differences.
pub(super) struct Balls {
    stages: Vec<([Canvas; 2], Canvas, Spread)>,
    size: (u32, u32),
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
            let rgba = heat_colors(&measured.map, HOTTEST);
            let map = Canvas { width: size.0 as usize, height: size.1 as usize, rgba };
            stages.push((pictures, map, measured.spread));
        }
        Ok(Self { stages, size })
    }

    /// How differences are spread, on each stage.
    pub(super) fn spreads(&self) -> [(&'static str, Spread); 2] {
        [0, 1].map(|i| (STAGES[i], self.stages[i].2))
    }

    /// All of them in one picture.
    pub(super) fn sheet(&self, names: [&str; 2]) -> Result<Canvas, Failure> {
        let captions = STAGES.iter().zip(&self.stages).flat_map(|(stage, (_, _, spread))| {
            let map = format!("dE00: mean {:.2}, 95 % {:.2}", spread.mean, spread.p95);
            [format!("{}, {stage}", names[0]), format!("{}, {stage}", names[1]), map]
        });
        let sheet = ContactSheet {
            captions: captions.map(|caption| vec![caption]).collect(),
            per_row: 3,
            count: 3 * STAGES.len(),
            cell: (self.size.0 as usize, self.size.1 as usize),
            ..ContactSheet::default()
        };
        let mut canvas = sheet.begin()?;
        for (row, (pictures, map, _)) in self.stages.iter().enumerate() {
            for (column, picture) in pictures.iter().chain([map]).enumerate() {
                sheet.put(&mut canvas, 3 * row + column, picture);
            }
        }
        Ok(canvas)
    }
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
