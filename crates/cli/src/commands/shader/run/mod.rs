//! `glanz shader run`: a fragment shader alone, over all pixels of a picture or of a film.

mod given;
mod output;
mod passes;
mod remarks;

use std::cell::Cell;
use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use glanz_shader::{Moment, PassError, RunError, Screen, ScreenPicture};
use schemars::JsonSchema;
use serde::Serialize;

use self::output::Output;
use self::passes::{Made, screen_failure};
use self::remarks::Remarks;
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
  glanz shader run image.frag --pass a=waves.frag,0=self --channel0 a --frames 0..100 -o waves.gif
  glanz shader run toy.frag --channel0 wood.png --mouse 320,180 --uniform speed=2
  glanz shader run toy.frag --frames 0..250 --time 4 --fps 25 -o 'toy_{frame:04}.png'

mainImage as on Shadertoy, or a main as in glslViewer. gl_FragCoord counts from the bottom left, pixel centres at .5;
inputs such as v_texcoord and uv go from 0 to 1. Filled by themselves, in both spellings and others near them: iResolution,
iTime, iTimeDelta, iFrame, iFrameRate, iMouse, iDate (2000-01-01 and the seconds since), iSampleRate, iChannelTime,
iChannelResolution, u_resolution, u_time, u_delta, u_frame, u_mouse, u_tex0Resolution. Textures repeat, have mipmaps, are
filtered linearly and stand upright: v grows upwards, as both hosts make it by turning pictures over. Values are those of
a display: they are written as they are, cut to 0 to 1; alpha counts for nothing; what is not a number is magenta.

Passes draw numbers for others, and for themselves in the next frame; a picture at a time, or a film that begins later, is
drawn from frame 0 on. They are named (--pass a=waves.frag,0=self --channel0 a), or found in the text: by lines such as
#iChannel0 \"file://waves.glsl\", \"self\" or \"file://wood.png\", with ::MinFilter, ::MagFilter and ::WrapMode, or by glslViewer's
#ifdef BUFFER_0 and DOUBLE_BUFFER_0 with u_buffer0 and u_doubleBuffer0. A texture named backbuffer is the frame before.
#iUniform declares a uniform.";

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

    /// A picture, a pass or a shader's file for iChannel0 or u_tex0; self is the picture of the frame before
    #[arg(long, value_name = "WHAT", help_heading = "Program")]
    pub(super) channel0: Option<String>,

    /// A picture, a pass or a shader's file for iChannel1 or u_tex1; self is the picture of the frame before
    #[arg(long, value_name = "WHAT", help_heading = "Program")]
    pub(super) channel1: Option<String>,

    /// A picture, a pass or a shader's file for iChannel2 or u_tex2; self is the picture of the frame before
    #[arg(long, value_name = "WHAT", help_heading = "Program")]
    pub(super) channel2: Option<String>,

    /// A picture, a pass or a shader's file for iChannel3 or u_tex3; self is the picture of the frame before
    #[arg(long, value_name = "WHAT", help_heading = "Program")]
    pub(super) channel3: Option<String>,

    /// A pass that is drawn before, and what its channels are: passes, self or files; may be repeated, in the order in which
    /// they are drawn
    #[arg(long, value_name = "NAME=FILE[,0=WHAT…]", value_parser = assignment, help_heading = "Program")]
    pub(super) pass: Vec<(String, String)>,

    /// A file in front of the texts of all passes, as Shadertoy's tab "Common" is
    #[arg(long, value_name = "FILE", help_heading = "Program")]
    pub(super) common: Option<PathBuf>,

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

/// A compiled shader with its passes.
struct Toy<'a> {
    args: &'a RunArgs,
    made: Made,
    /// The frame that comes next, where frames depend on the one before.
    next: Cell<u32>,
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
        Ok(Self { args, made: passes::passes(args)?, next: Cell::new(0) })
    }

    fn size(&self) -> [u32; 2] {
        [self.args.size.0, self.args.size.1]
    }

    fn moment(&self, frame: u32, time: f64) -> Moment {
        let (size, fps) = (self.size(), self.args.fps as f32);
        Moment { size, time: time as f32, frame, fps, mouse: self.args.mouse, textures: Vec::new() }
    }

    /// The moment of a frame, and its number as the shader counts: a picture alone is that of its time.
    fn of_frame(&self, frame: u32) -> Moment {
        let time = self.args.time + f64::from(frame) / self.args.fps;
        let number = if self.args.frames.is_some() { frame } else { (time * self.args.fps).max(0.0) as u32 };
        self.moment(number, time)
    }

    /// That of a frame before it.
    fn before(&self, frame: u32) -> Moment {
        let start = if self.args.frames.is_some() { self.args.time } else { 0.0 };
        self.moment(frame, start + f64::from(frame) / self.args.fps)
    }

    /// What is known before anything is drawn.
    fn remark(&self, remarks: &mut Remarks) -> Result<(), Failure> {
        remarks.lines(self.made.notes.iter().cloned());
        let passes = self.made.passes.borrow();
        for (number, (pass, file)) in passes.list().iter().zip(&self.made.files).enumerate() {
            let uniforms = passes.uniforms(number, &self.of_frame(0));
            let (values, unfilled) = uniforms.map_err(|error| screen_failure(&error.into(), file))?;
            let screen = Screen::new(&pass.program, &values, self.size());
            let screen = screen.map_err(|error| screen_failure(&error, file))?;
            let name = (passes.list().len() > 1).then(|| file.display().to_string());
            remarks.program(name.as_deref(), pass, &unfilled, &screen);
        }
        Ok(())
    }

    /// Draws a frame, and before it those that it depends on.
    fn draw(&self, frame: u32, progress: &mut Progress) -> Result<ScreenPicture, Failure> {
        let moment = self.of_frame(frame);
        let mut passes = self.made.passes.borrow_mut();
        let first = if passes.remembers() { self.next.get() } else { moment.frame };
        let count = f64::from(moment.frame.saturating_sub(first)) + 1.0;
        let failed = |error: PassError| match error {
            PassError::Run(error) => failure(&error, &self.args.file),
            PassError::Screen(error) => screen_failure(&error, &self.args.file),
        };
        for before in first..moment.frame {
            let mut within = |part| progress.within((f64::from(before - first) + part) / count);
            passes.skip(&self.before(before), &mut within).map_err(failed)?;
        }
        self.next.set(moment.frame + 1);
        let drawn = passes.draw(&moment, &mut |part| progress.within((count - 1.0 + part) / count));
        drawn.map_err(failed)
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
