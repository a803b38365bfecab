//! A run of named, timed steps with a summary at the end.

use std::time::{Duration, Instant};

use crate::{Failure, Result};

/// How a step ended.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Outcome {
    /// All well.
    Passed,
    /// Something is wrong: what.
    Failed(String),
    /// It could not be tried on this machine: why.
    Skipped(String),
}

impl From<Result<()>> for Outcome {
    fn from(result: Result<()>) -> Self {
        match result {
            Ok(()) => Self::Passed,
            Err(failure) => Self::Failed(failure.to_string()),
        }
    }
}

/// The steps run so far.
#[derive(Default)]
pub(crate) struct Steps {
    keep_going: bool,
    only: Option<String>,
    done: Vec<(&'static str, Outcome, Duration)>,
    left_out: Vec<&'static str>,
}

impl Steps {
    /// No step yet; `keep_going` runs the later steps even after one has failed, `only` names those
    /// that are run at all by a part of their name.
    pub(crate) fn new(keep_going: bool, only: Option<String>) -> Self {
        Self { keep_going, only, ..Self::default() }
    }

    /// Runs a step, unless an earlier one failed.
    pub(crate) fn run<T: Into<Outcome>>(&mut self, name: &'static str, step: impl FnOnce() -> T) {
        if self.only.as_ref().is_some_and(|part| !name.contains(part.as_str())) {
            return;
        }
        if !self.keep_going && self.failures() > 0 {
            self.left_out.push(name);
            return;
        }
        println!("\n=== {name} ===");
        let start = Instant::now();
        let outcome = step().into();
        match &outcome {
            Outcome::Passed => {}
            Outcome::Failed(why) => println!("!!! {name} FAILED: {why}"),
            Outcome::Skipped(why) => println!("!!! {name} SKIPPED: {why}"),
        }
        self.done.push((name, outcome, start.elapsed()));
    }

    fn failures(&self) -> usize {
        self.done.iter().filter(|(_, outcome, _)| matches!(outcome, Outcome::Failed(_))).count()
    }

    /// One line per step, then one for all.
    fn summary(&self) -> String {
        let mut text = String::from("=== summary ===\n");
        for (name, outcome, time) in &self.done {
            let (mark, why) = match outcome {
                Outcome::Passed => ("ok     ", ""),
                Outcome::Failed(why) => ("FAILED ", why.as_str()),
                Outcome::Skipped(why) => ("skipped", why.as_str()),
            };
            text += &format!("  {mark} {:>7.1} s  {name}", time.as_secs_f64());
            text += &if why.is_empty() { "\n".to_owned() } else { format!(": {why}\n") };
        }
        for name in &self.left_out {
            text += &format!("  not run           {name}\n");
        }
        text
    }

    /// Prints the summary; fails if any step has.
    pub(crate) fn finish(self) -> Result<()> {
        println!("\n{}", self.summary());
        let failures = self.failures();
        if self.done.is_empty() {
            return Err(Failure::new("no step has that name"));
        }
        if failures > 0 {
            let total = self.done.len() + self.left_out.len();
            return Err(Failure::new(format!("{failures} of {total} steps failed")));
        }
        let seconds: f64 = self.done.iter().map(|(_, _, time)| time.as_secs_f64()).sum();
        println!("All {} steps are done, in {seconds:.0} s.", self.done.len());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bad() -> Outcome {
        Outcome::Failed("it broke".to_owned())
    }

    #[test]
    fn a_failure_stops_the_steps_after_it() {
        let mut steps = Steps::new(false, None);
        steps.run("first", || Outcome::Passed);
        steps.run("second", bad);
        steps.run("third", || -> Outcome { panic!("a step after a failure ran") });
        let summary = steps.summary();
        assert!(summary.contains("second: it broke"), "{summary}");
        assert!(summary.contains("not run           third"), "{summary}");
        assert!(steps.finish().is_err());
    }

    #[test]
    fn keeping_going_runs_all_and_still_fails() {
        let mut steps = Steps::new(true, None);
        let mut ran = false;
        steps.run("first", bad);
        steps.run("second", || {
            ran = true;
            Outcome::Passed
        });
        assert!(steps.finish().is_err());
        assert!(ran);
    }

    #[test]
    fn only_the_steps_asked_for_run() {
        let mut steps = Steps::new(false, Some("gold".to_owned()));
        steps.run("lint", bad);
        steps.run("gold pictures", || Outcome::Passed);
        assert_eq!(steps.done.len(), 1);
        assert!(steps.finish().is_ok());
        assert!(Steps::new(false, Some("no such".to_owned())).finish().is_err());
    }

    #[test]
    fn what_is_skipped_is_no_failure_but_is_told() {
        let mut steps = Steps::new(false, None);
        steps.run("only", || Outcome::Skipped("no such target".to_owned()));
        assert!(steps.summary().contains("skipped"));
        assert!(steps.summary().contains("no such target"));
        assert!(steps.finish().is_ok());
    }
}
