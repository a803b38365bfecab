//! The command `glanz`. Data goes to stdout, everything else to stderr; the exit code is 0 when all is
//! well, 1 when the work failed, 2 when the command line makes no sense.

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

/// Draw real things under real lights, and tell how right the picture is
#[derive(Parser, Debug)]
#[command(
    name = "glanz",
    version,
    max_term_width = 100,
    after_help = "Examples:\n  \
        glanz render model.glb\n  \
        glanz render scene.toml -o picture.exr --size 3840x2160\n  \
        glanz info model.glb"
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
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    match cli.command.run(Cli::command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report::<Cli>(&cli.command.path()),
    }
}
