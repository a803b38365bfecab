//! A progress bar, on a terminal only and only for long work.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work that takes longer than this gets a bar.
const PATIENCE: Duration = Duration::from_millis(400);
/// Steps of the bar for each thing: one that takes long moves the bar while it is made.
const STEPS: usize = 1000;

/// Progress through a number of things, such as pictures, and through the one that is being made. There is
/// one bar for all of it.
#[derive(Debug)]
pub(crate) struct Progress {
    total: usize,
    done: usize,
    start: Instant,
    what: &'static str,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Progress through `total` things called `what`.
    pub(crate) fn new(total: usize, what: &'static str) -> Self {
        Self { total, done: 0, start: Instant::now(), what, bar: None }
    }

    /// Progress through one picture alone.
    pub(crate) fn of_one_picture() -> Self {
        Self::new(1, "pictures")
    }

    /// One more is done.
    pub(crate) fn step(&mut self) {
        self.done += 1;
        if self.total > 1 {
            self.show(0.0);
        }
    }

    /// This part of the next one is done, 0 to 1.
    pub(crate) fn within(&mut self, part: f64) {
        self.show(part);
    }

    fn show(&mut self, part: f64) {
        // Of nothing it cannot be told how long the rest takes.
        if self.bar.is_none()
            && self.position(part) > 0
            && self.start.elapsed() > PATIENCE
            && io::stderr().is_terminal()
        {
            self.bar = Some(self.new_bar());
        }
        if let Some(bar) = &self.bar {
            bar.set_message(self.message(part, self.start.elapsed()));
            bar.set_position(self.position(part));
        }
    }

    /// Where the bar stands, in steps.
    fn position(&self, part: f64) -> u64 {
        let within = (part.clamp(0.0, 1.0) * STEPS as f64) as usize;
        (self.done * STEPS + within).min(self.total * STEPS) as u64
    }

    /// What the bar says: the things that are done, or how much of a single one, and how long the rest takes if it goes
    /// on as it went.
    fn message(&self, part: f64, taken: Duration) -> String {
        let position = self.position(part);
        let done = match self.total {
            1 => format!("{} per cent", position * 100 / STEPS as u64),
            total => format!("{}/{total} {}", self.done, self.what),
        };
        let rest = (self.total * STEPS) as u64 - position;
        let seconds = taken.as_secs_f64() * rest as f64 / position.max(1) as f64;
        format!("{done}, {} left", rounded(seconds.ceil() as u64))
    }

    fn new_bar(&self) -> ProgressBar {
        let style = ProgressStyle::with_template("{wide_bar} {msg}").expect("the template is well-formed");
        let length = Some((self.total * STEPS) as u64);
        let bar = ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr());
        bar.with_style(style).with_elapsed(self.start.elapsed())
    }
}

/// A time in its two greatest units.
fn rounded(seconds: u64) -> String {
    match seconds {
        0..60 => format!("{seconds} s"),
        60..3600 => format!("{} min {} s", seconds / 60, seconds % 60),
        _ => format!("{} h {} min", seconds / 3600, seconds % 3600 / 60),
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_of_a_frame_moves_the_bar_of_the_film() {
        let mut film = Progress::new(4, "frames");
        let mut seen = Vec::new();
        for _ in 0..4 {
            seen.extend([0.0, 0.5, 1.0].map(|part| film.position(part)));
            film.step();
        }
        assert_eq!(seen, [0, 500, 1000, 1000, 1500, 2000, 2000, 2500, 3000, 3000, 3500, 4000]);
        assert_eq!(film.message(0.0, Duration::from_secs(9)), "4/4 frames, 0 s left");
    }

    #[test]
    fn a_single_picture_is_told_in_per_cent() {
        let picture = Progress::of_one_picture();
        assert_eq!(picture.message(0.25, Duration::from_secs(30)), "25 per cent, 1 min 30 s left");
        assert_eq!(picture.message(0.001, Duration::from_millis(400)), "0 per cent, 6 min 40 s left");
        assert_eq!(picture.position(7.0), 1000);
    }
}
