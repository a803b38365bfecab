//! `glanz render --frames`: many pictures, in many files or in one that moves.

use std::ops::Range;
use std::path::{Path, PathBuf};

use glanz_render::Prepared;
use serde_json::json;

use super::render::RenderArgs;
use crate::cli::args::{Target, check_folder};
use crate::cli::encode::{self, FileKind, Film};
use crate::cli::failure::Failure;
use crate::cli::frames::Template;
use crate::cli::pipeline::Plan;
use crate::cli::print::{self, Format};
use crate::cli::progress::Progress;
use crate::cli::timings::Timings;

/// Where the frames go.
enum Output {
    /// Each into a file of its own.
    Files(Template, FileKind),
    /// All into one file that moves.
    Film(PathBuf, FileKind),
}

impl RenderArgs {
    /// Draws all frames of `range`.
    pub fn film(&self, range: Range<u32>) -> Result<(), Failure> {
        if !self.turntable && self.animate.is_empty() {
            let message = "all frames would be the same: add --turntable or --animate PATH=FROM:TO";
            return Err(Failure::Usage(message.to_owned()));
        }
        let output = self.output()?;
        let files = match &output {
            Output::Files(template, file) => self.files(range, template, *file)?,
            Output::Film(path, file) => vec![self.moving(range, path, *file)?],
        };
        match files.as_slice() {
            [file] => print::note(format_args!("wrote {}", file.display())),
            [first, .., last] => {
                print::note(format_args!(
                    "wrote {} files, {} to {}",
                    files.len(),
                    first.display(),
                    last.display()
                ));
            }
            [] => {}
        }
        if self.format.format == Format::Json {
            let files: Vec<_> = files.iter().map(|file| file.display().to_string()).collect();
            return print::json(&json!({ "files": files }));
        }
        Ok(())
    }

    fn output(&self) -> Result<Output, Failure> {
        let path = match self.target.named(&self.input.input, "_{frame:04}.png")? {
            Target::Stdout => {
                let message = "a film cannot go to stdout; name its files with -o 'name_{frame:04}.png'";
                return Err(Failure::Usage(message.to_owned()));
            }
            Target::File(path) => path,
        };
        let file = encode::file_kind(&Target::File(path.clone()))?;
        if file.moves() {
            check_folder(&path)?;
            return Ok(Output::Film(path, file));
        }
        let template = Template::parse(&path.to_string_lossy()).ok_or_else(|| {
            Failure::Usage(format!(
                "'{}' has no place for the number of the frame: put {{frame}} or {{frame:04}} into the name, \
                 or write a .gif or .apng",
                path.display()
            ))
        })?;
        Ok(Output::Files(template, file))
    }

    fn files(&self, range: Range<u32>, template: &Template, file: FileKind) -> Result<Vec<PathBuf>, Failure> {
        let kind = self.kind(file)?;
        let names: Vec<PathBuf> = range.clone().map(|frame| template.name(frame).into()).collect();
        for name in &names {
            check_folder(name)?;
            self.target.check_free(name)?;
        }
        let mut timings = Timings::default();
        let mut index = 0;
        self.each_frame(range, |plan, prepared, hash| {
            let picture = plan.picture(prepared, kind, &mut timings);
            encode::write(&names[index], &encode::still(&picture, file, hash)?)?;
            index += 1;
            Ok(())
        })?;
        Ok(names)
    }

    fn moving(&self, range: Range<u32>, path: &Path, file: FileKind) -> Result<PathBuf, Failure> {
        self.kind(file)?;
        if !(self.fps > 0.0 && self.fps <= 1000.0) {
            return Err(Failure::Usage(format!(
                "--fps is {}, but must be above 0 and at most 1000",
                self.fps
            )));
        }
        let mut film = None;
        let count = range.len() as u32;
        self.each_frame(range, |plan, prepared, _| {
            let canvas = plan.codes(prepared, &mut Timings::default());
            let film = match &mut film {
                Some(film) => film,
                none => none.insert(Film::new(file, (canvas.width, canvas.height), count, self.fps)?),
            };
            film.add(canvas)
        })?;
        let bytes = film.expect("a range has a frame").finish()?;
        encode::write(path, &bytes)?;
        Ok(path.to_owned())
    }

    /// Prepares each frame and hands it to `use_frame`. The scene is read again for each frame only
    /// where its values move.
    fn each_frame(
        &self,
        range: Range<u32>,
        mut use_frame: impl FnMut(&Plan, &Prepared, u64) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let count = range.len();
        let mut progress = Progress::new(count, "frames");
        let mut scene = None;
        for index in 0..count {
            if scene.is_none() || !self.animate.is_empty() {
                let last = count.saturating_sub(1).max(1) as f64;
                let values: Vec<_> =
                    self.animate.iter().map(|motion| motion.at(index as f64 / last)).collect();
                let input = self.load(&values)?;
                let (plan, prepared) = self.plan(&input)?;
                if index == 0 {
                    print::notes(&self.input.input, &input.notes);
                }
                scene = Some((plan, prepared, input.hash));
            }
            let (plan, prepared, hash) = scene.as_ref().expect("was read for the first frame");
            if self.turntable {
                use_frame(&plan.turned(index as f64 / count as f64)?, prepared, *hash)?;
            } else {
                use_frame(plan, prepared, *hash)?;
            }
            progress.step();
        }
        Ok(())
    }
}
