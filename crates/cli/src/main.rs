//! The command `glanz`. Data goes to stdout, everything else to stderr; [`print::failure`] has the exit codes.

mod args;
mod commands;
mod encode;
mod frames;
mod input;
mod interrupt;
mod load;
mod old_names;
mod panics;
mod pipeline;
mod print;
mod progress;
mod reflow;

use std::ffi::OsString;
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::{Command, CommandFactory, FromArgMatches, Parser};

use glanz_picture::output::note_input;

use crate::print::Format;
use crate::print::failure::{Failure, wrong_use};

/// Shown after the help.
const EXAMPLES: &str = "\
Examples:
  glanz render model.glb
  glanz render scene.toml -o picture.exr --size 3840x2160
  glanz info model.glb";

/// Shown after the examples.
const VARIABLES: &str = "\
Environment:
  GLANZ_SIMD  The instructions that draw: sse2, avx2, avx512, neon, simd128 or scalar [default: the
              best that the processor has]; pictures are the same bytes with each";

/// Draw real things under real lights, and tell how right the picture is
#[derive(Parser, Debug)]
#[command(
    name = "glanz",
    version,
    max_term_width = 100,
    after_help = format!("{EXAMPLES}\n\n{VARIABLES}\n\n{}", print::failure::EXIT_CODES)
)]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
}

fn main() -> ExitCode {
    interrupt::prepare();
    panics::prepare();
    let words = of_course(of_help(std::env::args_os().collect()));
    let format = format_of(&words);
    keep_inputs(&words);
    let parsed = root().try_get_matches_from(&words).and_then(|matches| Cli::from_arg_matches(&matches));
    let cli = match parsed {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return wrong_use(&error, format),
        Err(help) => {
            return match help.print().and_then(|()| std::io::stdout().flush()) {
                Ok(()) => ExitCode::SUCCESS,
                // A closed stdout leaves nobody to tell.
                Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
                Err(error) => Failure::new(format_args!("stdout: {error}")).report::<Cli>(&[], format),
            };
        }
    };
    old_names::tell(&cli.command.path(), &words);
    let done = panics::caught(|| cli.command.run(root));
    interrupt::settle();
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report::<Cli>(&cli.command.path(), format),
    }
}

/// Options whose values are files that are written.
const OUTPUTS: [&str; 6] = ["-o", "--output", "--csv", "--plot", "--report", "--sheet"];

/// Has the files that the words name kept, but for those that are written: what is read is not written over.
fn keep_inputs(words: &[OsString]) {
    // The command `example` writes files of the names that it is given.
    if words.get(1).is_some_and(|command| command == "example") {
        return;
    }
    glanz_picture::output::keep_inputs();
    let before = std::iter::once(None).chain(words.iter().map(Some));
    for (before, word) in before.zip(words).skip(1) {
        let is_output = before.is_some_and(|before| OUTPUTS.iter().any(|option| before == option));
        if is_output || word.to_str().is_some_and(|word| word.starts_with('-')) {
            continue;
        }
        note_input(Path::new(word));
        // Of values such as picture=t.png.
        if let Some((_, file)) = word.to_str().and_then(|word| word.split_once('=')) {
            note_input(Path::new(file));
        }
    }
}

/// The whole command line.
fn root() -> Command {
    reflow::reflowed(Cli::command())
}

/// `help` has no options: what asks for its help asks for `help help`.
fn of_help(mut words: Vec<OsString>) -> Vec<OsString> {
    if let [.., command, option] = words.as_mut_slice()
        && command == "help"
        && (option == "--help" || option == "-h")
    {
        *option = "help".into();
    }
    words
}

/// Options as the courses' own programs have them, with one dash: `-vs FILE`, `-fs FILE`, `-ps`.
fn of_course(mut words: Vec<OsString>) -> Vec<OsString> {
    let end = words.iter().position(|word| word == "--").unwrap_or(words.len());
    for word in &mut words[..end] {
        for option in ["-vs", "-fs", "-ps"] {
            if word == option {
                *word = format!("-{option}").into();
            }
        }
    }
    words
}

/// How errors are told. Found in the words themselves, for command lines that make no sense as a whole.
fn format_of(words: &[OsString]) -> Format {
    let options = words.split(|word| word == "--").next().unwrap_or_default();
    let is_json = options.iter().any(|word| word == "--format=json")
        || options.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json");
    if is_json { Format::Json } else { Format::Text }
}
