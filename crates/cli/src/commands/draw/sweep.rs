//! `glanz sweep`: a sheet of pictures in which values of the scene vary.

use clap::Args;
use glanz_plot::{Grid, Variation};

use crate::args::{CameraArgs, DevelopArgs, InputArgs, LookArgs, MachineArgs, TargetArgs, size};
use crate::encode;
use crate::load::More;
use crate::pipeline::{self, Plan};
use crate::print::failure::Failure;
use crate::print::files::tell_sheet;
use crate::print::remarked::Remarked;
use crate::print::timings::Timings;
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz sweep scene.toml --vary materials.ball.shininess=1,4,16,64,256 -o row.png
  glanz sweep scene.toml --vary materials.ball.shininess=1,4,16,64,256 \\
      --vary materials.ball.specular=0:1:5 -o sheet.png
  glanz sweep scene.toml --vary render.shading=flat,gouraud,phong --size 400x300

The last --vary runs along the columns, all others along the rows, the first one slowest.";

/// The most columns where one value alone varies.
const DEFAULT_COLUMNS: usize = 8;

/// Options of `glanz sweep`.
#[derive(Args, Debug)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,

    /// A value of the scene and what it takes in turn: PATH=1,4,16 or PATH=start:stop:count; may be
    /// repeated
    #[arg(long, value_name = "PATH=VALUES", value_parser = crate::input::vary::variation, required = true)]
    vary: Vec<Variation>,

    /// Width and height of each picture, in pixels
    #[arg(long, alias = "cell", value_name = "WxH", value_parser = size, default_value = "256x256")]
    size: (u32, u32),

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
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let target = self.target.resolve(&self.input.input, "_sweep.png")?;
        encode::expect_png(&target, "a sheet")?;
        self.format.check_beside(&target)?;
        let cells = self.grid().cells()?;
        let sheet = self.grid().sheet(cells.len());
        let mut canvas = sheet.begin()?;
        let mut progress = Progress::new(cells.len(), "pictures");
        // The sheet is made of all its scenes.
        let (mut hash, mut made) = (0_u64, Vec::new());
        let (mut remarked, mut notes) = (Remarked::default(), Vec::new());
        for (index, values) in cells.iter().enumerate() {
            let input = self.input.load(Some(&self.camera), More { option: "--vary", values })?;
            let plan = Plan::new(&input, Some(self.size), &self.look, &self.camera, self.develop)?;
            let plan = plan.at(self.input.program.moment());
            let mut shot = plan.shot(&input.scene)?;
            let codes = pipeline::codes(&mut shot, &mut Timings::default(), &mut progress)?;
            sheet.put(&mut canvas, index, &codes);
            remarked.look(&mut shot, &input.scene, &codes.into(), || setting(values))?;
            if index == 0 {
                print::notes(&self.input.input, &input.notes);
                notes = input.notes;
            }
            made = plan.options.makings();
            hash = hash.rotate_left(1) ^ input.scene.content_hash();
            progress.step();
        }
        drop(progress);
        let size = (canvas.width, canvas.height);
        encode::deliver(canvas.into(), &target, &encode::metadata_of_sheet(hash, made))?;
        notes.extend(remarked.tell());
        tell_sheet(&target, size, &cells, sheet.per_row, (self.format, notes))
    }

    fn grid(&self) -> Grid<'_> {
        Grid { variations: &self.vary, columns: self.columns as usize, cell: self.size }
    }
}

/// What a picture of the sheet sets, as words.
fn setting(values: &[(String, String)]) -> String {
    let words: Vec<_> = values.iter().map(|(path, value)| format!("{path}={value}")).collect();
    words.join(" ")
}
