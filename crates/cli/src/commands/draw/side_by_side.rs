//! What commands share that draw one scene several times, side by side.

use clap::Args;
use glanz_picture::compare::frames::{DeltaE, Developed};
use glanz_picture::compare::{Spread, heat_colors};
use glanz_plot::Canvas;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::{
    CameraArgs, ColorArgs, DevelopArgs, InputArgs, LookArgs, MachineArgs, SizeArgs, Target, TargetArgs,
};
use crate::encode;
use crate::load::{Input, More};
use crate::pipeline::Plan;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Where the pictures go, and how each is drawn and developed.
#[derive(Args, Debug)]
pub(super) struct SideBySideArgs {
    #[command(flatten)]
    pub target: TargetArgs,
    #[command(flatten)]
    pub size: SizeArgs,
    #[command(flatten)]
    pub look: LookArgs,
    #[command(flatten)]
    pub camera: CameraArgs,
    #[command(flatten)]
    pub develop: DevelopArgs,
    #[command(flatten)]
    pub machine: MachineArgs,
    #[command(flatten)]
    pub format: FormatArgs,
}

/// A picture's codes.
pub(super) fn drawn(picture: &Developed) -> Canvas {
    let (width, height) = (picture.frame.width, picture.frame.height);
    Canvas { width, height, rgba: picture.codes.clone() }
}

/// The map in false colours, `top` the hottest.
pub(super) fn heat_map(delta: &DeltaE, (width, height): (usize, usize), top: f64) -> Canvas {
    Canvas { width, height, rgba: heat_colors(&delta.map, top) }
}

/// Two digits are enough for a scale.
pub(super) fn rounded(top: f64) -> f64 {
    (top * 100.0).round() / 100.0
}

/// How CIEDE2000 is spread over the pixels that show a surface.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct SpreadFacts {
    mean: f64,
    median: f64,
    p95: f64,
    max: f64,
}

impl SpreadFacts {
    pub(super) fn of(delta: &DeltaE) -> Self {
        let Spread { mean, median, p95, max } = delta.spread;
        Self { mean, median, p95, max }
    }
}

impl SideBySideArgs {
    /// Where the pictures go, without `-o` beside the scene with this ending, and the scene. `what` they are is said
    /// where they cannot be written.
    pub(super) fn begin(
        &self,
        input: &InputArgs,
        ending: &str,
        what: &str,
    ) -> Result<(Target, Input), Failure> {
        self.machine.apply()?;
        let target = self.target.resolve(&input.input, ending)?;
        encode::expect_png(&target, what)?;
        self.format.check_beside(&target)?;
        let scene = input.load(Some(&self.camera), More::default())?;
        print::notes(&input.input, &scene.notes);
        Ok((target, scene))
    }

    /// How a picture is drawn, with this look in place of that of the command line.
    pub(super) fn plan(&self, input: &Input, look: &LookArgs) -> Result<Plan, Failure> {
        Plan::new(input, self.size.size, look, &self.camera, self.develop)
    }

    /// Brings the pictures, on one sheet, to where they go, and says so.
    pub(super) fn deliver(&self, sheet: Canvas, target: &Target, input: &Input) -> Result<(), Failure> {
        // How the pictures were made does not depend on their colours, of which each has its own.
        let look = LookArgs { color: ColorArgs::default(), ..self.look.clone() };
        let makings = self.plan(input, &look)?.options.makings();
        let metadata = encode::metadata_of_sheet(input.scene.content_hash(), makings);
        encode::deliver(sheet.into(), target, &metadata)?;
        if let Target::File(path) = target {
            print::note(format_args!("wrote {}", path.display()));
        }
        Ok(())
    }
}
