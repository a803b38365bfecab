//! `glanz shader run`: a fragment shader alone, over all pixels of a picture or of a film.

mod given;
mod output;
mod remarks;

use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use glanz_shader::{
    Language, Moment, Pictures, Program, RunError, Screen, ScreenPicture, Stage, UniformValues, is_of_a_pass,
};
use schemars::JsonSchema;
use serde::Serialize;

use self::output::Output;
use self::remarks::Remarks;
use super::check::compile;
use crate::args::{MachineArgs, TargetArgs, assignment, choices, numbers, size};
use crate::commands::draw::render::sha256;
use crate::frames;
use crate::input::shader_text::read;
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shader run toy.frag --size 640x360 -o toy.png
  glanz shader run toy.frag --size 640x360 --frames 0..60 -o toy.gif
  glanz shader run toy.frag --channel0 wood.png --mouse 320,180 --uniform speed=2
  glanz shader run toy.frag --frames 0..250 --time 4 --fps 25 -o 'toy_{frame:04}.png'

mainImage as on Shadertoy, or a main as in glslViewer. gl_FragCoord counts from the bottom left, pixel centres at .5;
inputs such as v_texcoord and uv go from 0 to 1. Filled by themselves, in both spellings and others near them: iResolution,
iTime, iTimeDelta, iFrame, iFrameRate, iMouse, iDate (2000-01-01 and the seconds since), iSampleRate, iChannelTime,
iChannelResolution, u_resolution, u_time, u_delta, u_frame, u_mouse, u_tex0Resolution. Textures repeat, have mipmaps, are
filtered linearly and stand upright: v grows upwards, as both hosts make it by turning pictures over. Values are those of
a display: they are written as they are, cut to 0 to 1; alpha counts for nothing; what is not a number is magenta. There is
one pass: a shader that reads what another pass draws is refused where the name of the texture tells it.";

/// Options of `glanz shader run`.
#[derive(Args, Debug)]
pub(crate) struct RunArgs {
    /// File of a fragment shader
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) target: TargetArgs,

    /// Width and height in pixels
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "800x600", help_heading = "Picture")]
    pub(super) size: (u32, u32),

    /// Samples in each pixel: 1, 2, 4, 8 or 16
    #[arg(long, value_name = "N", value_parser = choices::samples(), default_value = "1",
          hide_possible_values = true, help_heading = "Picture")]
    pub(super) samples: u32,

    /// Draw several pictures: FIRST..END, without END
    #[arg(long, value_name = "FIRST..END", value_parser = frames::range, help_heading = "Film")]
    pub(super) frames: Option<Range<u32>>,

    /// Frames per second, by which time goes on
    #[arg(long, value_name = "N", default_value_t = 25.0, help_heading = "Film")]
    pub(super) fps: f64,

    /// Time in seconds, of frame 0
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, help_heading = "Film")]
    pub(super) time: f64,

    /// Where the pointer is pressed, in pixels from the bottom left
    #[arg(long, value_name = "X,Y", value_parser = place, help_heading = "Program")]
    pub(super) mouse: Option<[f32; 2]>,

    /// Set a uniform: one number, or all of a vector or matrix by columns; may be repeated
    #[arg(long, value_name = "NAME=V[,V…]", value_parser = assignment, help_heading = "Program")]
    pub(super) uniform: Vec<(String, String)>,

    /// A PNG or JPEG picture for the texture of this name; of a samplerCube a panorama, six pictures between commas, or a
    /// pattern of their names such as sky_*.png; may be repeated
    #[arg(long, value_name = "NAME=FILE", value_parser = assignment, help_heading = "Program")]
    pub(super) texture: Vec<(String, String)>,

    /// A picture for iChannel0 or u_tex0
    #[arg(long, value_name = "FILE", help_heading = "Program")]
    pub(super) channel0: Option<PathBuf>,

    /// A picture for iChannel1 or u_tex1
    #[arg(long, value_name = "FILE", help_heading = "Program")]
    pub(super) channel1: Option<PathBuf>,

    /// A picture for iChannel2 or u_tex2
    #[arg(long, value_name = "FILE", help_heading = "Program")]
    pub(super) channel2: Option<PathBuf>,

    /// A picture for iChannel3 or u_tex3
    #[arg(long, value_name = "FILE", help_heading = "Program")]
    pub(super) channel3: Option<PathBuf>,

    /// #define NAME, or NAME as TEXT, in front of the shader; may be repeated
    #[arg(long, value_name = "NAME[=TEXT]", help_heading = "Program")]
    pub(super) define: Vec<String>,

    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    pub(super) format: FormatArgs,
}

/// What a shader drew.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// A file for each frame, or one that moves; none where the picture went to stdout
    files: Vec<String>,
    /// SHA-256 of the bytes of each file
    sha256: Vec<String>,
    /// What nothing fills, what is probably not meant, and what is odd about the pictures: black, not a number
    notes: Vec<String>,
}

/// A compiled shader with all that does not change from frame to frame.
struct Toy<'a> {
    args: &'a RunArgs,
    program: Program,
    pictures: Pictures,
    set: Vec<(String, Vec<f32>)>,
}

/// Two numbers.
fn place(text: &str) -> Result<[f32; 2], String> {
    let all: Vec<f32> = numbers(text)?.into_iter().map(|x| x as f32).collect();
    all.try_into().map_err(|all: Vec<f32>| format!("expected two numbers x,y, found {}", all.len()))
}

impl RunArgs {
    /// Draws.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        self.check_numbers()?;
        let output = Output::of(self)?;
        let toy = Toy::new(self)?;
        let mut remarks = Remarks::default();
        toy.remark(&mut remarks)?;
        let files = output.write(&toy, &mut remarks)?;
        match files.as_slice() {
            [file] => print::note(format_args!("wrote {}", file.display())),
            [first, .., last] => {
                let (count, first, last) = (files.len(), first.display(), last.display());
                print::note(format_args!("wrote {count} files, {first} to {last}"));
            }
            [] => {}
        }
        let notes = remarks.tell();
        if self.format.is_json() {
            let sha256 = files.iter().map(|file| sha256(file)).collect::<Result<_, _>>()?;
            let files = files.iter().map(|file| file.display().to_string()).collect();
            return print::json(&Document { files, sha256, notes });
        }
        Ok(())
    }

    fn check_numbers(&self) -> Result<(), Failure> {
        if !(self.fps > 0.0 && self.fps <= 1000.0) {
            let message = format!("--fps is {}, but must be above 0 and at most 1000", self.fps);
            return Err(Failure::Usage(message));
        }
        if !self.time.is_finite() {
            return Err(Failure::Usage(format!("--time is {}, but must be a finite number", self.time)));
        }
        Ok(())
    }

    fn defines(&self) -> Vec<(String, String)> {
        let split = |text: &String| match text.split_once('=') {
            Some((name, text)) => (name.to_owned(), text.to_owned()),
            None => (text.clone(), String::new()),
        };
        self.define.iter().map(split).collect()
    }
}

impl<'a> Toy<'a> {
    fn new(args: &'a RunArgs) -> Result<Self, Failure> {
        let program = compile(&args.file, Stage::Fragment, &args.defines())?;
        let pictures = given::pictures(args, &program)?;
        let textures = program.interface().textures.iter().zip(&pictures.0).enumerate();
        for (index, (texture, picture)) in textures {
            if picture.is_none() && program.looks_into(index) && is_of_a_pass(&texture.name) {
                let message =
                    format!("'{}' is what another pass draws, and there is one pass only", texture.name);
                let help = format!("a picture may stand for it: --texture {}=FILE", texture.name);
                return Err(Report::new(message).file(&args.file).help(help).into());
            }
        }
        let set = given::uniforms(args, &program)?;
        Ok(Self { args, program, pictures, set })
    }

    fn size(&self) -> [u32; 2] {
        [self.args.size.0, self.args.size.1]
    }

    /// The uniforms of a frame, and what nothing fills.
    fn uniforms(&self, frame: u32) -> Result<(UniformValues, Vec<String>), Failure> {
        let time = self.args.time + f64::from(frame) / self.args.fps;
        let moment = Moment {
            size: self.size(),
            time: time as f32,
            frame: if self.args.frames.is_some() { frame } else { (time * self.args.fps).max(0.0) as u32 },
            fps: self.args.fps as f32,
            mouse: self.args.mouse,
            textures: self.pictures.0.iter().map(|own| own.as_ref().map(|own| own.size())).collect(),
        };
        let mut values = self.program.uniforms();
        let mut unfilled = moment.fill(&self.program, &mut values);
        for (name, numbers) in &self.set {
            values.set(name, numbers).map_err(|error| Failure::Usage(format!("--uniform: {error}")))?;
            unfilled.retain(|own| own != name);
        }
        Ok((values, unfilled))
    }

    fn screen<'b>(&'b self, values: &'b UniformValues) -> Result<Screen<'b>, Failure> {
        let screen = Screen::new(&self.program, values, self.size());
        let screen = screen.map_err(|error| Failure::from(Report::new(error).file(&self.args.file)))?;
        let screen = screen.textures(&self.pictures).samples(self.args.samples);
        let is_wgsl = Language::of_file(&self.args.file.display().to_string()) == Language::Wgsl;
        Ok(if is_wgsl { screen.from_top() } else { screen })
    }

    /// What is known before anything is drawn.
    fn remark(&self, remarks: &mut Remarks) -> Result<(), Failure> {
        let (values, unfilled) = self.uniforms(0)?;
        let screen = self.screen(&values)?;
        remarks.program(&self.program, &self.pictures, &unfilled, &screen);
        Ok(())
    }

    /// Draws a frame.
    fn draw(&self, frame: u32, progress: &mut Progress) -> Result<ScreenPicture, Failure> {
        let (values, _) = self.uniforms(frame)?;
        let drawn = self.screen(&values)?.draw(&mut |part| progress.within(part));
        drawn.map_err(|error| failure(&error, &self.args.file))
    }
}

/// A run that did not end, at its line.
fn failure(error: &RunError, file: &Path) -> Failure {
    let RunError::EndlessLoop { place, turns } = error;
    let message =
        format!("this loop does not end: it takes more than {turns} turns for a block of 8×8 pixels");
    let Some(place) = place else { return Report::new(message).file(file).into() };
    let mut report = Report::new(message).file(Path::new(&place.file));
    report = report.place(place.line.into(), place.column.into());
    let text = read(Path::new(&place.file)).ok();
    if let Some(text) = text.filter(|text| text.get(place.start..place.end).is_some()) {
        report = report.source(&place.file, text, place.start..place.end);
    }
    report.into()
}
