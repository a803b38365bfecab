//! The command `glanz`. Data goes to stdout, everything else to stderr; [`print::failure`] has the exit codes.

mod args;
mod commands;
mod encode;
mod frames;
mod input;
mod load;
mod pipeline;
mod print;
mod progress;

use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use crate::print::failure::Failure;

/// Shown after the help.
const EXAMPLES: &str = "\
Examples:
  glanz render model.glb
  glanz render scene.toml -o picture.exr --size 3840x2160
  glanz info model.glb";

/// Draw real things under real lights, and tell how right the picture is
#[derive(Parser, Debug)]
#[command(
    name = "glanz",
    version,
    max_term_width = 100,
    after_help = format!("{EXAMPLES}\n\n{}", print::failure::EXIT_CODES)
)]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
}

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // A closed stdout or stderr leaves nobody to tell.
            let _ = error.print();
            return ExitCode::from(match error.use_stderr() {
                true => Failure::Usage(String::new()).code(),
                false => 0,
            });
        }
    };
    match cli.command.run(Cli::command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report::<Cli>(&cli.command.path()),
    }
}
