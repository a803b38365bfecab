//! `glanz sweep`: a sheet of pictures in which values of the scene vary.

use clap::Args;
use serde_json::json;

use crate::cli::args::{CameraArgs, DevelopArgs, InputArgs, LookArgs, MachineArgs, Target, TargetArgs, size};
use crate::cli::encode;
use crate::cli::failure::Failure;
use crate::cli::pipeline::{Picture, Plan};
use crate::cli::print::{self, Format, FormatArgs};
use crate::cli::progress::Progress;
use crate::cli::sheet::Sheet;
use crate::cli::timings::Timings;
use crate::cli::vary::{Vary, short_names};

/// Shown after the help.
pub const EXAMPLES: &str = "\
Examples:
  glanz sweep scene.toml --vary materials.ball.shininess=1,4,16,64,256 -o row.png
  glanz sweep scene.toml --vary materials.ball.shininess=1,4,16,64,256 \\
      --vary materials.ball.specular=0:1:5 -o sheet.png
  glanz sweep scene.toml --vary render.shading=flat,gouraud,phong --cell 400x300

The last --vary runs along the columns, all others along the rows, the first one slowest.";

/// The most pictures on a sheet.
const MAX_PICTURES: usize = 10_000;
/// The most columns where one value alone varies.
const DEFAULT_COLUMNS: usize = 8;

/// Options of `glanz sweep`.
#[derive(Args, Debug)]
pub struct SweepArgs {
    #[command(flatten)]
    input: InputArgs,

    /// A value of the scene and what it takes in turn: PATH=1,4,16 or PATH=start:stop:count; may be
    /// repeated
    #[arg(long, value_name = "PATH=VALUES", value_parser = Vary::parse, required = true)]
    vary: Vec<Vary>,

    /// Width and height of each picture, in pixels
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "256x256")]
    cell: (u32, u32),

    /// Pictures per row where one value alone varies
    #[arg(long, value_name = "N", default_value_t = DEFAULT_COLUMNS as u32,
          value_parser = clap::value_parser!(u32).range(1..=1000))]
    columns: u32,

    #[command(flatten)]
    target: TargetArgs,
    #[command(flatten)]
    look: LookArgs,
    #[command(flatten)]
    camera: CameraArgs,
    #[command(flatten)]
    develop: DevelopArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl SweepArgs {
    /// Draws the sheet.
    pub fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let target = self.target.resolve(&self.input.input, "_sweep.png")?;
        encode::expect_png(&target, "a sheet")?;
        let cells = self.cells()?;
        let sheet = self.sheet(cells.len());
        let mut canvas = sheet.begin()?;
        let mut progress = Progress::new(cells.len(), "pictures");
        // The sheet is made of all its scenes.
        let mut hash = 0_u64;
        for (index, values) in cells.iter().enumerate() {
            let input = self.input.load(Some(&self.camera), values)?;
            let plan = Plan::new(&input, Some(self.cell), &self.look, &self.camera, self.develop)?;
            let prepared = plan.prepare(&input.scene)?;
            sheet.put(&mut canvas, index, &plan.codes(&prepared, &mut Timings::default())?);
            if index == 0 {
                print::notes(&self.input.input, &input.notes);
            }
            hash = hash.rotate_left(1) ^ input.hash;
            progress.step();
        }
        drop(progress);
        let size = (canvas.width, canvas.height);
        encode::deliver(Picture::Codes8(canvas), &target, &encode::metadata(hash))?;
        self.tell(&target, size, &cells)
    }

    /// What each picture sets, in the order of the sheet.
    fn cells(&self) -> Result<Vec<Vec<(String, String)>>, Failure> {
        let count = self.vary.iter().try_fold(1_usize, |count, vary| count.checked_mul(vary.values.len()));
        let count = count.filter(|count| *count <= MAX_PICTURES);
        let count = count.ok_or_else(|| {
            Failure::Usage(format!("a sheet of more than {MAX_PICTURES} pictures is too large"))
        })?;
        Ok((0..count).map(|index| self.cell_values(index)).collect())
    }

    /// What picture `index` sets: the last value runs fastest.
    fn cell_values(&self, index: usize) -> Vec<(String, String)> {
        let mut rest = index;
        let mut values: Vec<_> = self
            .vary
            .iter()
            .rev()
            .map(|vary| {
                let value = vary.values[rest % vary.values.len()].clone();
                rest /= vary.values.len();
                (vary.path.clone(), value)
            })
            .collect();
        values.reverse();
        values
    }

    fn sheet(&self, count: usize) -> Sheet {
        let paths: Vec<_> = self.vary.iter().map(|vary| vary.path.as_str()).collect();
        let names = short_names(&paths);
        let label = |which: usize, value: &str| format!("{} = {value}", names[which]);
        let cell = (self.cell.0 as usize, self.cell.1 as usize);
        if let [vary] = self.vary.as_slice() {
            let captions = vary.values.iter().map(|value| vec![label(0, value)]).collect();
            let per_row = count.min(self.columns as usize);
            return Sheet { captions, per_row, count, cell, ..Sheet::default() };
        }
        let last = self.vary.len() - 1;
        let per_row = self.vary[last].values.len();
        let columns = self.vary[last].values.iter().map(|value| label(last, value)).collect();
        let row = |index: usize| {
            let values = self.cell_values(index * per_row);
            let lines = values[..last].iter().enumerate().map(|(which, (_, value))| label(which, value));
            lines.collect::<Vec<_>>().join("\n")
        };
        let rows = (0..count / per_row).map(row).collect();
        Sheet { columns, rows, per_row, count, cell, ..Sheet::default() }
    }

    fn tell(
        &self,
        target: &Target,
        (width, height): (usize, usize),
        cells: &[Vec<(String, String)>],
    ) -> Result<(), Failure> {
        let Target::File(path) = target else {
            return Ok(());
        };
        print::note(format_args!("wrote {}", path.display()));
        if self.format.format == Format::Json {
            let cells: Vec<serde_json::Map<_, _>> = cells
                .iter()
                .map(|values| {
                    values.iter().map(|(path, value)| (path.clone(), value.clone().into())).collect()
                })
                .collect();
            let path = path.display().to_string();
            return print::json(&json!({ "file": path, "width": width, "height": height, "cells": cells }));
        }
        Ok(())
    }
}
