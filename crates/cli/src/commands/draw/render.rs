//! `glanz render`: a scene or a model becomes a picture.

use std::ops::Range;
use std::path::Path;

use clap::Args;
use glanz_picture::output::{Format, PictureData, PictureKind};
use glanz_render::{Encoding, Shot};
use glanz_scene::Scene;
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};

use super::watched::is_read_by;
use crate::args::{
    BitDepth, CameraArgs, DevelopArgs, DeviceArgs, InputArgs, LookArgs, MachineArgs, SizeArgs, Target,
    TargetArgs,
};
use crate::commands::shader;
use crate::encode;
use crate::frames;
use crate::load::{Input, More};
use crate::pipeline::{self, Plan};
use crate::print::failure::{Failure, Report, without_number};
use crate::print::preview::PreviewMode;
use crate::print::timings::{Stage, Timings, TimingsFacts};
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz render examples/kite.toml -o kite.png
  glanz render model.glb --preview
  glanz render scene.toml -o out.exr --size 3840x2160 --samples 8 --shading gouraud
  glanz render scene.toml --mode spectral --observer cie1964 --white scene
  glanz render scene.toml --mode spectral -o spectra.exr --spectral-exr
  glanz render spectra.exr --observer age:70 -o old.png
  glanz render scene.toml --set materials.red.shininess=64 -o shinier.png
  glanz render scene.toml --frames 0..120 --turntable -o 'spin_{frame:04}.png'
  glanz render scene.toml --frames 0..60 --turntable -o spin.gif --size 400x300
  glanz render scene.toml --watch --preview
  glanz render scene.toml --fs normals.frag -o normals.png
  glanz render scene.toml --vs my.vert --fs my.frag --uniform exposure=1.5 --watch --preview
  glanz render scene.toml --fs my.frag --device gpu -o gpu.png
  glanz render - --preview < scene.toml
  glanz render scene.toml --repeat 50 --timings --format json";

/// Options of `glanz render`.
#[derive(Args, Debug)]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub input: InputArgs,
    #[command(flatten)]
    pub target: TargetArgs,

    /// Bits per channel of a PNG
    #[arg(long, value_enum, default_value_t, value_name = "BITS", help_heading = "Output")]
    pub bit_depth: BitDepth,

    /// Write the spectrum of each pixel into the .exr, 97 wavelengths from 300 to 780 nm
    #[arg(long, help_heading = "Output")]
    pub spectral_exr: bool,

    /// Show the picture in this terminal; without -o no file is written
    #[arg(long, value_enum, value_name = "HOW", num_args = 0..=1, default_missing_value = "auto", require_equals = true,
          help_heading = "Output", conflicts_with = "frames")]
    pub preview: Option<PreviewMode>,

    /// Draw again when the scene or a file that it names changes, until Ctrl-C
    #[arg(long, help_heading = "Output", conflicts_with_all = ["frames", "repeat", "timings"])]
    pub watch: bool,

    /// Print the shaders that draw the scene, or those that would draw as its shading does, in place of a picture
    #[arg(long, help_heading = "Program", conflicts_with_all = ["watch", "frames", "preview", "output"])]
    pub ps: bool,

    #[command(flatten)]
    pub device: DeviceArgs,
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

    /// Move a value of the scene during the film, such as camera.fov_deg=20:60 or
    /// lights.0.direction=[0,0,-1]:[8,0,-1]; may be repeated
    #[arg(
        long,
        value_name = "PATH=FROM:TO",
        value_parser = frames::Motion::parse,
        requires = "frames",
        help_heading = "Film"
    )]
    pub animate: Vec<frames::Motion>,

    /// Frames per second of .gif, .apng, .mp4 and .webm
    #[arg(long, value_name = "N", default_value_t = 25.0, requires = "frames", help_heading = "Film")]
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
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.device.begin();
        let done = self.draw_all();
        self.device.end();
        done
    }

    fn draw_all(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        if self.is_picture() {
            return self.seen_picture();
        }
        match &self.frames {
            Some(range) => self.film(range.clone()),
            None if self.ps => shader::print_of(&self.load(More::default())?.scene),
            None if self.watch => self.watch(),
            None => self.still(),
        }
    }

    fn still(&self) -> Result<(), Failure> {
        let (target, kind) = self.goal()?;
        let mut timings = Timings::default();
        for _ in 1..self.repeat {
            timings.begin_run();
            self.rehearse(target.as_ref(), kind, &mut timings)?;
        }
        timings.begin_run();
        self.once(target.as_ref(), kind, timings)
    }

    /// Where the picture goes, if into a file, and what it must keep.
    pub(crate) fn goal(&self) -> Result<(Option<Target>, PictureKind), Failure> {
        let target = match &self.target.output {
            None if self.preview.is_some() => None,
            _ => Some(self.target.resolve(&self.input.input, ".png")?),
        };
        target.as_ref().map_or(Ok(()), |target| self.format.check_beside(target))?;
        let path = target.as_ref().and_then(Target::path);
        if let Some(path) = path.filter(|path| is_read_by(&self.input.input, path)) {
            let message =
                format!("the scene reads '{}': a picture there would be written over it", path.display());
            return Err(Report::new(message).file(path).help("choose another file with -o").into());
        }
        if self.preview.is_some() && self.format.is_json() {
            let message = "stdout cannot take both the --preview and --format json";
            return Err(Failure::Usage(message.to_owned()));
        }
        let kind = self.kind(target.as_ref().map_or(Ok(Format::Png), encode::format)?)?;
        Ok((target, kind))
    }

    /// Draws the picture, brings it to where it goes, and tells of it.
    pub(crate) fn once(
        &self,
        target: Option<&Target>,
        kind: PictureKind,
        mut timings: Timings,
    ) -> Result<(), Failure> {
        let (mut told, plan, mut shot, picture, scene) = self.draw(kind, &mut timings)?;
        told.remarks = shot.remarks(&scene, &picture)?.into_iter().map(|remark| remark.text).collect();
        let preview =
            self.preview.map(|mode| Ok::<_, Failure>((mode, pipeline::on_screen(&shot, &picture)?)));
        let preview = preview.transpose()?;
        if let Some(target) = target {
            timings.measure(Stage::Encode, || encode::deliver(picture, target, &shot.metadata()))?;
        }
        if let Some((mode, canvas)) = preview {
            mode.show(&canvas)?;
        }
        self.tell(target, &plan, &told, &timings)
    }

    /// All the way from the file to the bytes of the picture, which are thrown away.
    fn rehearse(
        &self,
        target: Option<&Target>,
        kind: PictureKind,
        timings: &mut Timings,
    ) -> Result<(), Failure> {
        let (_, _, shot, picture, _) = self.draw(kind, timings)?;
        if let Some(target) = target {
            let (format, metadata) = (encode::format(target)?, shot.metadata());
            timings.measure(Stage::Encode, || picture.to_bytes(format, &metadata))?;
        }
        Ok(())
    }

    /// From the file to a picture.
    fn draw(
        &self,
        kind: PictureKind,
        timings: &mut Timings,
    ) -> Result<(Told, Plan, Shot, PictureData, Scene), Failure> {
        let input = timings.measure(Stage::Load, || self.load(More::default()))?;
        let (plan, mut shot) = timings.measure(Stage::Prepare, || self.plan(&input))?;
        let picture = pipeline::picture(&mut shot, kind, timings, &mut Progress::of_one_picture())?;
        let told = Told { hash: input.scene.content_hash(), notes: input.notes, remarks: Vec::new() };
        Ok((told, plan, shot, picture, input.scene))
    }

    /// Reads the scene, with these values set.
    pub(crate) fn load(&self, values: More<'_>) -> Result<Input, Failure> {
        self.input.load(Some(&self.camera), values)
    }

    /// The scene as arrays, and how it is drawn.
    pub(crate) fn plan(&self, input: &Input) -> Result<(Plan, Shot), Failure> {
        let plan = Plan::new(input, self.size.size, &self.look, &self.camera, self.develop)?;
        let plan = plan.at(self.input.program.moment());
        let shot = plan.shot(&input.scene)?.of_scene_hash(input.scene.content_hash());
        let (shot, told) = self.device.apply(shot)?;
        told.iter().for_each(|told| print::note(format_args!("note: {told}")));
        Ok((plan, shot))
    }

    /// What the picture must keep for a file of this format.
    pub(crate) fn kind(&self, format: Format) -> Result<PictureKind, Failure> {
        if self.spectral_exr && format != Format::Exr {
            let message = "--spectral-exr needs an output that ends in .exr, such as -o spectra.exr";
            return Err(Failure::Usage(message.to_owned()));
        }
        if format == Format::Exr {
            self.check_light()?;
        }
        if self.develop.dither && self.bit_depth == BitDepth::Sixteen {
            let message =
                "--dither has no effect with --bit-depth 16; it acts where light is rounded to 8 bits";
            return Err(Failure::Usage(message.to_owned()));
        }
        match (format, self.bit_depth) {
            (Format::Exr, _) if self.spectral_exr => Ok(PictureKind::Spectrum),
            (Format::Exr, _) => Ok(PictureKind::Light),
            (Format::Png, BitDepth::Sixteen) => Ok(PictureKind::Codes16),
            (_, BitDepth::Eight) => Ok(PictureKind::Codes8),
            (_, BitDepth::Sixteen) => Err(Failure::Usage("only a .png can have --bit-depth 16".to_owned())),
        }
    }

    /// That no option is given that makes codes of light, for a file that holds the light itself. A preview has codes.
    pub(super) fn check_light(&self) -> Result<(), Failure> {
        let DevelopArgs { ev, tone_map, encoding, dither } = self.develop;
        let is_shown = self.preview.is_some();
        let given = [
            ("--encoding raw", encoding == Some(Encoding::Raw)),
            ("--bit-depth 16", self.bit_depth == BitDepth::Sixteen),
            ("--ev", ev.is_some() && !is_shown),
            ("--tone-map", tone_map.is_some() && !is_shown),
            ("--dither", dither && !is_shown),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            Some((option, _)) => Err(Failure::Usage(format!(
                "{option} is for pictures of codes; an .exr holds the linear values themselves"
            ))),
            None => Ok(()),
        }
    }

    /// Says what was done.
    fn tell(
        &self,
        target: Option<&Target>,
        plan: &Plan,
        told: &Told,
        timings: &Timings,
    ) -> Result<(), Failure> {
        if let Some(Target::File(path)) = target {
            print::note(format_args!("wrote {}", path.display()));
        }
        print::notes(&self.input.input, &told.notes);
        told.remarks.iter().for_each(|remark| print::note(format_args!("note: {remark}")));
        let stdout_is_free = target != Some(&Target::Stdout);
        if self.format.is_json() && stdout_is_free {
            let (width, height) = plan.options.size;
            return print::json(&Document {
                file: target.and_then(Target::file),
                sha256: target.and_then(Target::path).map(sha256).transpose()?,
                scene_hash: encode::scene_hash(told.hash),
                width,
                height,
                notes: told.notes.iter().chain(&told.remarks).cloned().collect(),
                timings: self.timings.then(|| timings.facts()),
            });
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

/// A picture that was drawn.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The picture's file
    file: Option<String>,
    /// SHA-256 of the bytes of the file: equal pictures of equal scenes are equal files
    sha256: Option<String>,
    /// A number for the content of the scene, as PNG and OpenEXR files carry it
    scene_hash: String,
    width: u32,
    height: u32,
    /// What was ignored or changed of the file, and what is odd about the picture: black, clipped, a mistake
    notes: Vec<String>,
    /// With --timings: how long the stages take
    timings: Option<TimingsFacts>,
}

/// SHA-256 of a file that was written.
pub(in crate::commands) fn sha256(path: &Path) -> Result<String, Failure> {
    let bytes = std::fs::read(path).map_err(|error| {
        let error = without_number(&error.to_string());
        Failure::from(Report::new(format_args!("cannot read '{}': {error}", path.display())).file(path))
    })?;
    Ok(Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect())
}

/// What a file tells beside its scene.
struct Told {
    notes: Vec<String>,
    remarks: Vec<String>,
    hash: u64,
}
