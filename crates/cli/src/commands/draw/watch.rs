//! `glanz render --watch`: draws again when a file changes.

use std::io::{self, IsTerminal};
use std::time::Instant;

use super::render::RenderArgs;
use super::watched::Watched;
use crate::args::Target;
use crate::interrupt;
use crate::load::More;
use crate::print;
use crate::print::failure::Failure;
use crate::print::timings::Timings;

impl RenderArgs {
    /// Draws again and again. What fails is told, and the last good picture stays; only what no change of a file could
    /// mend ends it.
    pub(super) fn watch(&self) -> Result<(), Failure> {
        let (target, kind) = self.goal()?;
        if self.input.is_stdin() || target == Some(Target::Stdout) || self.format.is_json() {
            let message = "--watch takes a scene from a file, and its picture goes into a file or --preview";
            return Err(Failure::Usage(message.to_owned()));
        }
        if !self.input.input.is_file() {
            return self.load(More::default()).map(drop);
        }
        interrupt::is_the_end();
        let path = target.as_ref().and_then(Target::path);
        let files = || self.input.program.files();
        let mut watched = Watched::new(&self.input.input, path, &files);
        let mut first = true;
        loop {
            watched.look();
            if self.preview.is_some() && io::stdout().is_terminal() && !first {
                // Home, and nothing below.
                print::bytes(b"\x1b[H\x1b[J")?;
            }
            let start = Instant::now();
            match self.once(target.as_ref(), kind, Timings::default()) {
                Ok(()) => print::note(format_args!(
                    "drawn in {:.2} s; watching {}, Ctrl-C ends",
                    start.elapsed().as_secs_f64(),
                    plural(watched.count())
                )),
                Err(failure @ Failure::Closed) => return Err(failure),
                Err(failure @ Failure::Usage(_)) if first => return Err(failure),
                Err(failure) => failure.tell(),
            }
            first = false;
            watched.wait();
        }
    }
}

fn plural(files: usize) -> String {
    if files == 1 { "1 file".to_owned() } else { format!("{files} files") }
}
