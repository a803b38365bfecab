//! Where the picture goes.

use std::ffi::OsStr;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use glanz_picture::output::{is_own, written_file};

use super::input::STDIN;
use crate::print::failure::{Failure, Report};

/// Where the picture goes.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Output")]
pub(crate) struct TargetArgs {
    /// The picture's file, its format by its ending; - for a PNG to stdout [default: beside the
    /// input, over an older picture of Glanz, but never over another file]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,

    /// Without -o: write even over a file that is no picture of Glanz
    #[arg(long)]
    pub force: bool,
}

/// Where the picture goes, checked before any work is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// To whoever reads our output, as PNG.
    Stdout,
    /// Into this file.
    File(PathBuf),
}

impl Target {
    /// The file's path.
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
        }
    }

    /// The file's name, for programs.
    pub(crate) fn file(&self) -> Option<String> {
        self.path().map(|path| path.display().to_string())
    }
}

impl TargetArgs {
    /// Where the picture goes; without `-o` into a file beside `input`, with `ending` for its own
    /// name's: `model.glb` and `.png` make `model.png`.
    pub(crate) fn resolve(&self, input: &Path, ending: &str) -> Result<Target, Failure> {
        let target = self.named(input, ending)?;
        if let Target::File(path) = &target {
            check_folder(path)?;
            self.check_free(path)?;
        }
        Ok(target)
    }

    /// The same, with nothing asked of the file system.
    pub(crate) fn named(&self, input: &Path, ending: &str) -> Result<Target, Failure> {
        match &self.output {
            Some(path) if path == OsStr::new("-") => {
                if io::stdout().is_terminal() {
                    let message = "stdout is a terminal, which shows no PNG; add --preview or redirect it";
                    return Err(Failure::Usage(message.to_owned()));
                }
                Ok(Target::Stdout)
            }
            Some(path) => Ok(Target::File(path.clone())),
            None => Ok(Target::File(beside(input, ending))),
        }
    }

    /// That a file which the user did not name may be written.
    pub(crate) fn check_free(&self, path: &Path) -> Result<(), Failure> {
        if self.output.is_none() && !self.force && is_there(path) && !is_own(path) {
            let message = format_args!("'{}' exists already, and Glanz did not write it", path.display());
            let report = Report::new(message).file(path);
            return Err(report.help("write over it with --force, or choose another file with -o").into());
        }
        Ok(())
    }
}

/// Whether there is a file, or a link of this name to one that is not there.
fn is_there(path: &Path) -> bool {
    std::fs::symlink_metadata(path).is_ok()
}

/// The file beside `input` whose name has `ending` in place of its own.
pub(super) fn beside(input: &Path, ending: &str) -> PathBuf {
    // A scene from stdin has no name, and no folder but the current one.
    let input = if input == Path::new(STDIN) { Path::new("scene") } else { input };
    let mut name = input.file_stem().unwrap_or(OsStr::new("picture")).to_owned();
    name.push(ending);
    input.with_file_name(name)
}

/// That the folder of a file exists and the file is none.
pub(crate) fn check_folder(path: &Path) -> Result<(), Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        let report = Report::new(format_args!("cannot write '{}'", path.display())).file(path);
        return Err(report.help(format_args!("there is no folder '{}'", folder.display())).into());
    }
    if path.is_dir() {
        let report = Report::new(format_args!("cannot write '{}': it is a folder", path.display()));
        return Err(report.file(path).into());
    }
    Ok(())
}

/// That a file may be written beside the numbers, which stdout has; `option` names the file.
pub(crate) fn check_beside(option: &str, path: &Path) -> Result<(), Failure> {
    if path == Path::new("-") {
        let message = format!("stdout takes the numbers, not the file too; name a file with {option}");
        return Err(Failure::Usage(message));
    }
    check_folder(path)
}

/// That files which one command writes are not one, however their names are written; each stands behind its option.
pub(crate) fn check_apart(files: [(&str, Option<&Path>); 2]) -> Result<(), Failure> {
    let [(first, Some(a)), (second, Some(b))] = files else { return Ok(()) };
    match written_file(a)? == written_file(b)? {
        true => Err(Failure::Usage(format!("{first} and {second} name the same file"))),
        false => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_of_a_model_lies_beside_it() {
        assert_eq!(beside(Path::new("a/model.glb"), ".png"), Path::new("a/model.png"));
        assert_eq!(beside(Path::new("model.v2.glb"), "_sheet.png"), Path::new("model.v2_sheet.png"));
        assert_eq!(beside(Path::new("model"), ".png"), Path::new("model.png"));
        assert_eq!(beside(Path::new("-"), ".png"), Path::new("scene.png"));
    }
}
