//! Data on stdout, as text or JSON, and notes on stderr.

use std::io::{self, Write};

use clap::{Args, ValueEnum};
use glanz_math::names::shown;
use serde::Serialize;

use super::document::versioned;
use super::failure::{Failure, without_number};
use super::text::harmless;
use crate::args::Target;

/// How data is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    #[default]
    Text,
    /// For programs
    Json,
}

/// The choice between text and JSON.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct FormatArgs {
    /// How data is printed on stdout
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT", help_heading = "Output")]
    pub format: Format,
}

impl FormatArgs {
    /// Whether data is printed for programs.
    pub(crate) fn is_json(self) -> bool {
        self.format == Format::Json
    }

    /// That stdout does not take both a picture and what is printed for programs.
    pub(crate) fn check_beside(self, target: &Target) -> Result<(), Failure> {
        match (self.format, target) {
            (Format::Json, Target::Stdout) => {
                let message = "stdout cannot take both the picture and --format json; name a file with -o";
                Err(Failure::Usage(message.to_owned()))
            }
            _ => Ok(()),
        }
    }
}

/// Writes all of `bytes` to stdout. That nobody reads any more is [`Failure::Closed`].
pub(crate) fn bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::Closed,
        _ => Failure::new(format_args!("cannot write to stdout: {}", without_number(&error.to_string()))),
    })
}

/// Writes text to stdout; what could steer a terminal is replaced.
pub(crate) fn text(text: &str) -> Result<(), Failure> {
    bytes(harmless(text).as_bytes())
}

/// Writes a document to stdout, as indented JSON with its version.
pub(crate) fn json(document: &impl Serialize) -> Result<(), Failure> {
    text(&format!("{:#}\n", versioned(document)))
}

/// Tells something on stderr that is no data. That nobody listens is no failure.
pub(crate) fn note(message: impl std::fmt::Display) {
    let _ = writeln!(io::stderr().lock(), "{}", harmless(&message.to_string()));
}

/// So many remarks are told one by one.
const FEW_NOTES: usize = 3;

/// Tells on stderr that not all of `input` is drawn as it says, and where to read more.
pub(crate) fn notes(input: &std::path::Path, notes: &[String]) {
    match notes {
        [] => {}
        few if few.len() <= FEW_NOTES => {
            few.iter().for_each(|only| note(format_args!("note: {}", shown(only))))
        }
        _ => note(format_args!(
            "note: {} things are ignored or changed; 'glanz info {}' lists them",
            notes.len(),
            input.display()
        )),
    }
}
