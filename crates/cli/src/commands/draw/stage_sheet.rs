//! What commands share that draw a sheet of balls on stages.

use std::path::Path;

use clap::Args;
use glanz_plot::{Canvas, ContactSheet};

use crate::args::{CameraArgs, ColorArgs, DevelopArgs, LookArgs, MachineArgs, Target, TargetArgs};
use crate::encode;
use crate::load::Input;
use crate::pipeline::{self, Plan};
use crate::print::FormatArgs;
use crate::print::failure::Failure;
use crate::print::files::tell_sheet;
use crate::print::timings::Timings;
use crate::progress::Progress;

/// Where the sheet goes, and how its pictures are coloured and developed.
#[derive(Args, Debug)]
pub(crate) struct StageSheetArgs {
    #[command(flatten)]
    target: TargetArgs,
    #[command(flatten)]
    color: ColorArgs,
    #[command(flatten)]
    develop: DevelopArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl StageSheetArgs {
    /// Where the sheet goes; without `-o` into a file of this name.
    pub(crate) fn begin(&self, name: &str) -> Result<Target, Failure> {
        self.machine.apply()?;
        let target = self.target.resolve(Path::new(name), "_sheet.png")?;
        encode::expect_png(&target, "a sheet")?;
        self.format.check_beside(&target)?;
        Ok(target)
    }

    /// Draws each stage, in this size and with so many samples per pixel, into a cell of the sheet.
    pub(crate) fn draw(
        &self,
        sheet: &ContactSheet,
        stages: impl Iterator<Item = Result<Input, Failure>>,
        size: (u32, u32),
        samples: u32,
    ) -> Result<Canvas, Failure> {
        let mut canvas = sheet.begin()?;
        let look = LookArgs { samples: Some(samples), color: self.color.clone(), ..LookArgs::default() };
        let camera = CameraArgs::default();
        let mut progress = Progress::new(sheet.count, "pictures");
        for (index, stage) in stages.enumerate() {
            let input = stage?;
            let plan = Plan::new(&input, Some(size), &look, &camera, self.develop)?;
            let mut shot = plan.shot(&input.scene)?;
            let codes = pipeline::codes(&mut shot, &mut Timings::default(), &mut progress)?;
            sheet.put(&mut canvas, index, &codes);
            progress.step();
        }
        Ok(canvas)
    }

    /// Brings the sheet to where it goes, and tells what each of its cells sets.
    pub(crate) fn deliver(
        &self,
        sheet: Canvas,
        target: &Target,
        cells: &[Vec<(String, String)>],
        per_row: usize,
    ) -> Result<(), Failure> {
        let size = (sheet.width, sheet.height);
        encode::deliver(sheet.into(), target, &encode::metadata(0))?;
        tell_sheet(target, size, cells, per_row, (self.format, Vec::new()))
    }
}
