//! Where the pictures go.

use std::path::{Path, PathBuf};

use glanz_picture::output::{
    Animation, Format, Metadata, PictureData, write_apng, write_atomically, write_gif,
};

use super::remarks::Remarks;
use super::{RunArgs, Toy};
use crate::args::{Target, check_folder};
use crate::commands::draw::ffmpeg;
use crate::encode;
use crate::frames::{Template, tell_of_gif};
use crate::print::failure::Failure;
use crate::progress::Progress;

/// Where the pictures go.
pub(super) enum Output {
    /// One picture.
    Picture(Target),
    /// Each frame into a file of its own.
    Files(Template),
    /// All into one file that moves.
    Film(PathBuf, Moving),
}

/// A file that moves.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Moving {
    Gif,
    Apng,
    /// What the program ffmpeg writes.
    Ffmpeg,
}

impl Output {
    /// Where the command line wants them; nothing is drawn before this is known.
    pub(super) fn of(args: &RunArgs) -> Result<Self, Failure> {
        if args.frames.is_none() {
            let target = args.target.resolve(&args.file, ".png")?;
            args.format.check_beside(&target)?;
            return match codes_format(&target)? {
                Format::Png | Format::Gif | Format::Apng => Ok(Self::Picture(target)),
                Format::Exr => Err(no_light()),
            };
        }
        let target = args.target.named(&args.file, "_{frame:04}.png")?;
        let Target::File(path) = &target else {
            let message = "a film cannot go to stdout; name its files with -o 'name_{frame:04}.png'";
            return Err(Failure::Usage(message.to_owned()));
        };
        check_folder(path)?;
        if ffmpeg::writes(path) {
            ffmpeg::check(path)?;
            return Ok(Self::Film(path.clone(), Moving::Ffmpeg));
        }
        let format = codes_format(&target)?;
        match (Template::of_path(path)?, format) {
            (_, Format::Exr) => Err(no_light()),
            (Some(template), _) => Ok(Self::Files(template)),
            (None, Format::Gif) => Ok(Self::Film(path.clone(), Moving::Gif)),
            (None, Format::Apng) => Ok(Self::Film(path.clone(), Moving::Apng)),
            (None, Format::Png) => Err(Failure::Usage(format!(
                "'{}' has no place for the number of the frame: put {{frame}} or {{frame:04}} into the name, \
                 or write a .gif or .apng, or with ffmpeg an .mp4 or .webm",
                path.display()
            ))),
        }
    }

    /// Draws and writes all of it; gives the files.
    pub(super) fn write(&self, toy: &Toy<'_>, remarks: &mut Remarks) -> Result<Vec<PathBuf>, Failure> {
        match self {
            Self::Picture(target) => {
                let codes = Frames::new(toy, remarks, 1).codes(0, 0)?;
                encode::deliver(data(toy, codes), target, &Metadata::default())?;
                Ok(target.path().map(Path::to_owned).into_iter().collect())
            }
            Self::Files(template) => files(toy, remarks, template),
            Self::Film(path, moving) => film(toy, remarks, path, *moving),
        }
    }
}

fn codes_format(target: &Target) -> Result<Format, Failure> {
    encode::format(target)
}

fn no_light() -> Failure {
    let message = "a shader alone gives the values of a display, not light: write a .png, .gif or .apng";
    Failure::Usage(message.to_owned())
}

fn data(toy: &Toy<'_>, rgba: Vec<u8>) -> PictureData {
    let [width, height] = toy.size().map(|side| side as usize);
    PictureData::Codes8 { width, height, rgba }
}

/// Frames that are drawn one after the other.
struct Frames<'a, 'b> {
    toy: &'a Toy<'b>,
    remarks: &'a mut Remarks,
    progress: Progress,
}

impl<'a, 'b> Frames<'a, 'b> {
    fn new(toy: &'a Toy<'b>, remarks: &'a mut Remarks, count: usize) -> Self {
        let progress = if count == 1 { Progress::of_one_picture() } else { Progress::new(count, "frames") };
        Self { toy, remarks, progress }
    }

    fn codes(&mut self, index: usize, frame: u32) -> Result<Vec<u8>, Failure> {
        let picture = self.toy.draw(frame, &mut self.progress)?;
        self.remarks.picture(&picture, index, frame);
        self.progress.step();
        Ok(picture.codes())
    }
}

fn files(toy: &Toy<'_>, remarks: &mut Remarks, template: &Template) -> Result<Vec<PathBuf>, Failure> {
    let range = toy.args.frames.clone().unwrap_or(0..1);
    let names: Vec<PathBuf> = range.clone().map(|frame| template.name(frame)).collect();
    for name in &names {
        check_folder(name)?;
        toy.args.target.check_free(name)?;
    }
    let mut frames = Frames::new(toy, remarks, names.len());
    for (index, (frame, name)) in range.zip(&names).enumerate() {
        let codes = frames.codes(index, frame)?;
        data(toy, codes).save(name, &Metadata::default())?;
    }
    Ok(names)
}

fn film(toy: &Toy<'_>, remarks: &mut Remarks, path: &Path, moving: Moving) -> Result<Vec<PathBuf>, Failure> {
    let range = toy.args.frames.clone().unwrap_or(0..1);
    let [width, height] = toy.size().map(|side| side as usize);
    let fps = toy.args.fps;
    let animation = Animation { width, height, frames: range.len(), frame_s: 1.0 / fps };
    if moving == Moving::Gif {
        tell_of_gif(&animation);
    }
    let mut frames = Frames::new(toy, remarks, range.len());
    let codes = range.enumerate().map(|(index, frame)| frames.codes(index, frame));
    let metadata = Metadata::default();
    write_atomically(path, |out| match moving {
        Moving::Ffmpeg => ffmpeg::write(out, &animation, fps, codes, &metadata),
        Moving::Gif => write_gif(out, &animation, codes, &metadata),
        Moving::Apng => write_apng(out, &animation, codes, &metadata),
    })?;
    Ok(vec![path.to_owned()])
}
