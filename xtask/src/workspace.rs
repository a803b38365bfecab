//! Where things are in the workspace, and how its programs are run.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::{Failure, Result};

/// The workspace that this program belongs to.
pub(crate) struct Workspace {
    root: PathBuf,
}

/// What every build chooses, so that they share what they compile.
pub(crate) const WHOLE: &str = "--workspace --all-features";

/// How the `glanz` command is built.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Profile {
    /// As the tests build it.
    Dev,
    /// As it is used.
    Release,
}

impl Workspace {
    /// The workspace in whose `xtask` folder this program's source lies.
    pub(crate) fn find() -> Self {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        Self { root: here.parent().expect("xtask lies in the workspace's root").to_owned() }
    }

    /// A path below the root.
    pub(crate) fn path(&self, below: impl AsRef<Path>) -> PathBuf {
        self.root.join(below)
    }

    /// The folder of everything built.
    pub(crate) fn target(&self) -> PathBuf {
        match std::env::var_os("CARGO_TARGET_DIR") {
            Some(folder) => self.root.join(folder),
            None => self.root.join("target"),
        }
    }

    /// A folder below the target folder, made if need be.
    pub(crate) fn target_folder(&self, name: &str) -> Result<PathBuf> {
        let folder = self.target().join(name);
        std::fs::create_dir_all(&folder).map_err(Failure::during(folder.display()))?;
        Ok(folder)
    }

    /// A program that will run in the root.
    pub(crate) fn command(&self, program: impl AsRef<std::ffi::OsStr>) -> Command {
        let mut command = Command::new(program);
        command.current_dir(&self.root).stdin(Stdio::null());
        command
    }

    /// Cargo with these arguments, separated by blanks.
    pub(crate) fn cargo(&self, args: &str) -> Command {
        let mut command = self.command(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.args(args.split_whitespace());
        command
    }

    /// Builds the `glanz` command and tells where it is.
    pub(crate) fn glanz(&self, profile: Profile) -> Result<PathBuf> {
        match profile {
            Profile::Dev => self.built("glanz"),
            Profile::Release => {
                run(&mut self.cargo("build --release --package glanz-cli"))?;
                self.program("release/glanz")
            }
        }
    }

    /// A program of the development build: `glanz`, or `examples/eval`.
    ///
    /// All programs and examples are built at once, with all features and what examples need, as the tests build them:
    /// whatever is chosen by itself has other features, and then dependencies are compiled again for it.
    pub(crate) fn built(&self, name: &str) -> Result<PathBuf> {
        run(&mut self.cargo(&format!("build --quiet {WHOLE} --bins --examples")))?;
        self.program(&format!("debug/{name}"))
    }

    /// A program that is built already, by its path below the target folder.
    pub(crate) fn program(&self, name: &str) -> Result<PathBuf> {
        let program = self.target().join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
        match program.is_file() {
            true => Ok(program),
            false => Err(Failure::new(format!("{} was not built", program.display()))),
        }
    }

    /// All scene files in `examples/`, in order of their names.
    pub(crate) fn examples(&self) -> Result<Vec<PathBuf>> {
        let folder = self.path("examples");
        let entries = std::fs::read_dir(&folder).map_err(Failure::during(folder.display()))?;
        let mut scenes: Vec<PathBuf> = entries
            .filter_map(|entry| Some(entry.ok()?.path()))
            .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
            .collect();
        scenes.sort();
        match scenes.is_empty() {
            true => Err(Failure::new(format!("{} holds no scene file", folder.display()))),
            false => Ok(scenes),
        }
    }
}

/// Runs a program whose output goes to ours; fails if it does.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    println!("$ {}", line(command));
    let status = command.status().map_err(Failure::during(line(command)))?;
    match status.success() {
        true => Ok(()),
        false => Err(Failure::new(format!("`{}` ended with {status}", line(command)))),
    }
}

/// Runs a program quietly; fails with what it wrote on standard error if it does.
pub(crate) fn run_quietly(command: &mut Command) -> Result<Vec<u8>> {
    let output = command.output().map_err(Failure::during(line(command)))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(Failure::new(format!("`{}` ended with {}:\n{}", line(command), output.status, said.trim_end())))
}

/// Whether a program can be started and ends well.
pub(crate) fn works(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
}

/// The command as a person would type it, without the folders of programs.
fn line(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let name = program.file_name().unwrap_or(program.as_os_str());
    let args = command.get_args().map(|arg| arg.to_string_lossy());
    std::iter::once(name.to_string_lossy()).chain(args).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_holds_the_workspace() {
        assert!(Workspace::find().path("Cargo.toml").is_file());
        assert!(Workspace::find().path("crates/math").is_dir());
    }

    #[test]
    fn a_failing_program_is_a_failure() {
        let workspace = Workspace::find();
        assert!(run_quietly(&mut workspace.cargo("no-such-subcommand-of-cargo")).is_err());
        assert!(!works(&mut workspace.command("no-such-program-anywhere")));
    }
}
