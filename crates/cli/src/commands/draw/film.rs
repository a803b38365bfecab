//! `glanz render --frames`: many pictures, in many files or in one that moves.

use std::ops::Range;
use std::path::{Path, PathBuf};

use glanz_picture::output::{
    Animation, Format, Metadata, PictureData, write_apng, write_atomically, write_gif,
};
use glanz_render::{Moment, Shot};
use glanz_scene::Scene;
use schemars::JsonSchema;
use serde::Serialize;

use super::ffmpeg;
use super::render::{RenderArgs, sha256};
use crate::args::{Target, check_folder};
use crate::encode;
use crate::frames::{Template, tell_of_gif};
use crate::load::More;
use crate::pipeline::{self, Plan, turn};
use crate::print;
use crate::print::failure::Failure;
use crate::print::remarked::Remarked;
use crate::print::timings::Timings;
use crate::progress::Progress;

/// A film that was drawn.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// A file for each frame, or one that moves
    files: Vec<String>,
    /// SHA-256 of the bytes of each file
    sha256: Vec<String>,
    /// Of each frame a number for the content of its scene, as PNG and OpenEXR files carry it; with --turntable only the
    /// camera turns, which does not change it
    scene_hashes: Vec<String>,
    /// What was ignored or changed of the file, and what is odd about the frames: black, clipped, a mistake
    notes: Vec<String>,
}

/// Where the frames go.
enum Output {
    /// Each into a file of its own.
    Files(Template, Format),
    /// All into one file that moves.
    Film(PathBuf, Moving),
}

/// A file that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Moving {
    Gif,
    Apng,
    /// What the program ffmpeg writes.
    Ffmpeg,
}

/// The frames of a film, one after the other.
struct Frames<'a> {
    args: &'a RenderArgs,
    count: usize,
    /// The number of the first one.
    first: u32,
    /// The scene of the last frame, and of the next ones while nothing in it moves.
    scene: Option<(Plan, Shot, Scene)>,
    /// What the first frame's file tells beside its scene.
    notes: Vec<String>,
    remarked: Remarked,
    /// Of each frame that was drawn, the hash of its scene.
    hashes: Vec<String>,
}

impl RenderArgs {
    /// Draws all frames of `range`.
    pub(crate) fn film(&self, range: Range<u32>) -> Result<(), Failure> {
        if !self.turntable && self.animate.is_empty() {
            let message = "all frames would be the same: add --turntable or --animate PATH=FROM:TO";
            return Err(Failure::Usage(message.to_owned()));
        }
        let output = self.output()?;
        let mut frames = Frames::new(self, &range);
        let files = match &output {
            Output::Files(template, format) => self.files(range, template, *format, &mut frames)?,
            Output::Film(path, format) => vec![self.moving(path, *format, &mut frames)?],
        };
        match files.as_slice() {
            [file] => print::note(format_args!("wrote {}", file.display())),
            [first, .., last] => {
                let (count, first, last) = (files.len(), first.display(), last.display());
                print::note(format_args!("wrote {count} files, {first} to {last}"));
            }
            [] => {}
        }
        let remarks = frames.remarked.tell();
        if self.format.is_json() {
            let sha256 = files.iter().map(|file| sha256(file)).collect::<Result<_, _>>()?;
            let files = files.iter().map(|file| file.display().to_string()).collect();
            let notes = frames.notes.into_iter().chain(remarks).collect();
            return print::json(&Document { files, sha256, scene_hashes: frames.hashes, notes });
        }
        Ok(())
    }

    fn output(&self) -> Result<Output, Failure> {
        let target = self.target.named(&self.input.input, "_{frame:04}.png")?;
        let Target::File(path) = &target else {
            let message = "a film cannot go to stdout; name its files with -o 'name_{frame:04}.png'";
            return Err(Failure::Usage(message.to_owned()));
        };
        if ffmpeg::writes(path) {
            check_folder(path)?;
            return Ok(Output::Film(path.clone(), Moving::Ffmpeg));
        }
        let format = encode::format(&target)?;
        match Template::of_path(path)? {
            Some(template) => Ok(Output::Files(template, format)),
            None if format.is_animation() => {
                check_folder(path)?;
                let moving = if format == Format::Gif { Moving::Gif } else { Moving::Apng };
                Ok(Output::Film(path.clone(), moving))
            }
            None => Err(Failure::Usage(format!(
                "'{}' has no place for the number of the frame: put {{frame}} or {{frame:04}} into the name, \
                 or write a .gif or .apng, or with ffmpeg an .mp4 or .webm",
                path.display()
            ))),
        }
    }

    fn files(
        &self,
        range: Range<u32>,
        template: &Template,
        format: Format,
        frames: &mut Frames<'_>,
    ) -> Result<Vec<PathBuf>, Failure> {
        let kind = self.kind(format)?;
        let names: Vec<PathBuf> = range.map(|frame| template.name(frame)).collect();
        for name in &names {
            check_folder(name)?;
            self.target.check_free(name)?;
        }
        let mut progress = Progress::new(names.len(), "frames");
        for (index, name) in names.iter().enumerate() {
            let (_, shot) = frames.frame(index)?;
            let picture = pipeline::picture(shot, kind, &mut Timings::default(), &mut progress)?;
            let metadata = shot.metadata();
            if frames.wants(index) {
                frames.look(index, &picture)?;
            }
            picture.save(name, &metadata)?;
            progress.step();
        }
        Ok(names)
    }

    fn moving(&self, path: &Path, format: Moving, frames: &mut Frames<'_>) -> Result<PathBuf, Failure> {
        self.kind(Format::Apng)?;
        if format == Moving::Ffmpeg {
            ffmpeg::check(path)?;
        }
        if !(self.fps > 0.0 && self.fps <= 1000.0) {
            return Err(Failure::Usage(format!(
                "--fps is {}, but must be above 0 and at most 1000",
                self.fps
            )));
        }
        let count = frames.count;
        let mut progress = Progress::new(count, "frames");
        let (plan, shot) = frames.frame(0)?;
        let metadata = Metadata { entries: plan.options.makings(), ..shot.metadata() };
        let animation =
            Animation { width: plan.size().0, height: plan.size().1, frames: count, frame_s: 1.0 / self.fps };
        if format == Moving::Gif {
            tell_of_gif(&animation);
        }
        let codes = (0..count).map(|index| -> Result<Vec<u8>, Failure> {
            let (_, shot) = frames.frame(index)?;
            let canvas = pipeline::codes(shot, &mut Timings::default(), &mut progress)?;
            if frames.wants(index) {
                frames.look(index, &canvas.clone().into())?;
            }
            progress.step();
            Ok(canvas.rgba)
        });
        write_atomically(path, |out| match format {
            Moving::Ffmpeg => ffmpeg::write(out, &animation, self.fps, codes, &metadata),
            Moving::Gif => write_gif(out, &animation, codes, &metadata),
            Moving::Apng => write_apng(out, &animation, codes, &metadata),
        })?;
        Ok(path.to_owned())
    }
}

impl<'a> Frames<'a> {
    fn new(args: &'a RenderArgs, range: &Range<u32>) -> Self {
        Self {
            args,
            count: range.len(),
            first: range.start,
            scene: None,
            notes: Vec::new(),
            remarked: Remarked::default(),
            hashes: Vec::new(),
        }
    }

    /// Whether frame `index` is one of those to look at.
    fn wants(&self, index: usize) -> bool {
        Remarked::wants(index, self.count)
    }

    /// Looks at frame `index`, which was drawn last.
    fn look(&mut self, index: usize, picture: &PictureData) -> Result<(), Failure> {
        let (_, shot, scene) = self.scene.as_mut().expect("a frame was drawn");
        let number = self.first as usize + index;
        self.remarked.look(shot, scene, picture, || format!("frame {number}"))
    }

    /// How frame `index` is drawn. The file is read again only where
    /// values of the scene move.
    fn frame(&mut self, index: usize) -> Result<(&Plan, &mut Shot), Failure> {
        let animate = &self.args.animate;
        if self.scene.is_none() || !animate.is_empty() {
            let last = self.count.saturating_sub(1).max(1) as f64;
            let values: Vec<_> = animate.iter().map(|motion| motion.at(index as f64 / last)).collect();
            let input = self.args.load(More { option: "--animate", values: &values })?;
            let (plan, shot) = self.args.plan(&input)?;
            if self.scene.is_none() {
                print::notes(&self.args.input.input, &input.notes);
                self.notes = input.notes;
            }
            self.scene = Some((plan, shot, input.scene));
        }
        let (plan, shot, _) = self.scene.as_mut().expect("was read for the first frame");
        let part = if self.args.turntable { index as f64 / self.count as f64 } else { 0.0 };
        turn(shot, &plan.options.camera, part)?;
        let step = (1.0 / self.args.fps) as f32;
        let first = self.args.input.program.moment();
        let (time, frame) = (first.time + index as f32 * step, self.first + index as u32);
        shot.set_moment(Moment { time, delta: step, frame, ..first });
        if self.hashes.len() == index {
            self.hashes.extend(shot.metadata().scene_hash);
        }
        Ok((plan, shot))
    }
}
