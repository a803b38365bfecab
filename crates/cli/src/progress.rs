//! A progress bar, on a terminal only and only for long work.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work that takes longer than this gets a bar.
const PATIENCE: Duration = Duration::from_millis(400);

/// Progress through a number of pictures.
#[derive(Debug)]
pub struct Progress {
    total: usize,
    done: usize,
    start: Instant,
    what: &'static str,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Progress through `total` things called `what`.
    pub fn new(total: usize, what: &'static str) -> Self {
        Self { total, done: 0, start: Instant::now(), what, bar: None }
    }

    /// One more is done.
    pub fn step(&mut self) {
        self.set(self.done + 1);
    }

    /// So many are done.
    pub fn set(&mut self, done: usize) {
        self.done = done;
        if self.bar.is_none()
            && self.total > 1
            && self.start.elapsed() > PATIENCE
            && io::stderr().is_terminal()
        {
            self.bar = Some(self.new_bar());
        }
        if let Some(bar) = &self.bar {
            bar.set_position(self.done as u64);
        }
    }

    fn new_bar(&self) -> ProgressBar {
        let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} {msg}, {eta} left")
            .expect("the template is well-formed");
        let bar = ProgressBar::with_draw_target(Some(self.total as u64), ProgressDrawTarget::stderr());
        bar.with_style(style).with_message(self.what).with_elapsed(self.start.elapsed())
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
