//! `glanz render`: a scene or a model becomes a picture.

use std::ops::Range;

use clap::Args;
use glanz_render::{Prepared, View, prepare};
use serde_json::json;

use crate::cli::args::{
    BitDepth, CameraArgs, DevelopArgs, InputArgs, LookArgs, MachineArgs, SizeArgs, Target, TargetArgs,
};
use crate::cli::encode::{self, FileKind};
use crate::cli::failure::Failure;
use crate::cli::frames;
use crate::cli::load::Input;
use crate::cli::pipeline::{Kind, Picture, Plan};
use crate::cli::preview;
use crate::cli::print::{self, Format, FormatArgs};
use crate::cli::timings::{Stage, Timings};

/// Shown after the help.
pub const EXAMPLES: &str = "\
Examples:
  glanz render examples/kite.toml -o kite.png
  glanz render model.glb --preview
  glanz render scene.toml -o out.exr --size 3840x2160 --samples 8 --shading gouraud
  glanz render scene.toml --set materials.red.shininess=64 -o shinier.png
  glanz render scene.toml --frames 0..120 --turntable -o 'spin_{frame:04}.png'
  glanz render scene.toml --frames 0..60 --turntable -o spin.gif --size 400x300
  glanz render scene.toml --repeat 50 --timings --format json";

/// Options of `glanz render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub target: TargetArgs,

    /// Bits per channel of a PNG
    #[arg(long, value_enum, default_value_t, value_name = "BITS", help_heading = "Output")]
    pub bit_depth: BitDepth,

    /// Show the picture in this terminal; without -o no file is written
    #[arg(long, help_heading = "Output", conflicts_with = "frames")]
    pub preview: bool,

    #[command(flatten)]
    pub size: SizeArgs,
    #[command(flatten)]
    pub look: LookArgs,
    #[command(flatten)]
    pub camera: CameraArgs,
    #[command(flatten)]
    pub develop: DevelopArgs,

    /// Draw several pictures: FIRST..END, without END
    #[arg(long, value_name = "FIRST..END", value_parser = frames::range, help_heading = "Film")]
    pub frames: Option<Range<u32>>,

    /// Turn the camera once around its target during the film
    #[arg(long, requires = "frames", help_heading = "Film")]
    pub turntable: bool,

    /// Move a value of the scene during the film, such as camera.fov_deg=20:60; may be repeated
    #[arg(
        long,
        value_name = "PATH=FROM:TO",
        value_parser = frames::Motion::parse,
        requires = "frames",
        help_heading = "Film"
    )]
    pub animate: Vec<frames::Motion>,

    /// Frames per second of .gif and .apng
    #[arg(long, value_name = "N", default_value_t = 25.0, help_heading = "Film")]
    pub fps: f64,

    /// Do everything so many times, to measure it
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        value_parser = clap::value_parser!(u32).range(1..=100_000),
        help_heading = "Measuring",
        conflicts_with = "frames"
    )]
    pub repeat: u32,

    /// Print how long each stage takes
    #[arg(long, help_heading = "Measuring", conflicts_with = "frames")]
    pub timings: bool,

    #[command(flatten)]
    pub machine: MachineArgs,
    #[command(flatten)]
    pub format: FormatArgs,
}

impl RenderArgs {
    /// Draws.
    pub fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        match &self.frames {
            Some(range) => self.film(range.clone()),
            None => self.still(),
        }
    }

    fn still(&self) -> Result<(), Failure> {
        let only_preview = self.preview && self.target.output.is_none();
        let target = match only_preview {
            true => None,
            false => Some(self.target.resolve(&self.input.input, ".png")?),
        };
        let file = target.as_ref().map_or(Ok(FileKind::Png), encode::file_kind)?;
        let kind = self.kind(file)?;
        let mut timings = Timings::default();
        let mut last = None;
        for _ in 0..self.repeat {
            timings.begin_run();
            // The last run's picture is given back first, so that memory is needed once.
            drop(last.take());
            last = Some(self.once(file, kind, !only_preview, &mut timings)?);
        }
        let made = last.expect("repeats at least once");
        match &target {
            Some(Target::Stdout) => print::bytes(&made.bytes)?,
            Some(Target::File(path)) => encode::write(path, &made.bytes)?,
            None => {}
        }
        if self.preview {
            print::text(&preview::half_blocks(&made.plan.on_screen(&made.picture), preview::columns()))?;
        }
        self.tell(target.as_ref(), &made, &timings)
    }

    /// Goes all the way from the file to the bytes of the picture.
    fn once(
        &self,
        file: FileKind,
        kind: Kind,
        encoded: bool,
        timings: &mut Timings,
    ) -> Result<Made, Failure> {
        let input = timings.measure(Stage::Load, || self.load(&[]))?;
        let (plan, prepared) = timings.measure(Stage::Prepare, || self.plan(&input))?;
        let picture = plan.picture(&prepared, kind, timings);
        let bytes = match encoded {
            true => timings.measure(Stage::Encode, || encode::still(&picture, file, input.hash))?,
            false => Vec::new(),
        };
        Ok(Made { notes: input.notes, plan, picture, bytes })
    }

    /// Reads the scene, with these values set.
    pub fn load(&self, values: &[(String, String)]) -> Result<Input, Failure> {
        self.input.load(Some(&self.camera), values)
    }

    /// The scene as arrays, and how it is drawn.
    pub fn plan(&self, input: &Input) -> Result<(Plan, Prepared), Failure> {
        let plan = Plan::new(input, self.size.size, &self.look, &self.camera, self.develop)?;
        let prepared = prepare(&input.scene, &self.look.prepare_options())?;
        Ok((plan, prepared))
    }

    /// What the picture must keep for a file of this kind.
    pub fn kind(&self, file: FileKind) -> Result<Kind, Failure> {
        match (file, self.bit_depth) {
            (FileKind::Exr, _) => Ok(Kind::Light),
            (FileKind::Png, BitDepth::Sixteen) => Ok(Kind::Codes16),
            (_, BitDepth::Eight) => Ok(Kind::Codes8),
            (_, BitDepth::Sixteen) => Err(Failure::Usage("only a .png can have --bit-depth 16".to_owned())),
        }
    }

    /// Says what was done.
    fn tell(&self, target: Option<&Target>, made: &Made, timings: &Timings) -> Result<(), Failure> {
        if let Some(Target::File(path)) = target {
            print::note(format_args!("wrote {}", path.display()));
        }
        print::notes(&self.input.input, &made.notes);
        let stdout_is_free = target != Some(&Target::Stdout);
        if self.format.format == Format::Json && stdout_is_free {
            let file = match target {
                Some(Target::File(path)) => Some(path.display().to_string()),
                _ => None,
            };
            let View { width, height, .. } = made.plan.view;
            return print::json(&json!({
                "file": file, "width": width, "height": height, "notes": made.notes,
                "timings": self.timings.then(|| timings.json()),
            }));
        }
        match (self.timings, stdout_is_free) {
            (true, true) => print::text(&timings.text()),
            (true, false) => {
                print::note(timings.text().trim_end());
                Ok(())
            }
            (false, _) => Ok(()),
        }
    }
}

/// A finished picture.
struct Made {
    notes: Vec<String>,
    plan: Plan,
    picture: Picture,
    bytes: Vec<u8>,
}
