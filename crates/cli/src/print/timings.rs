//! How long the stages of a picture take.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Instant;

use schemars::JsonSchema;
use serde::Serialize;

/// The stages, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    /// From files to a scene.
    Load,
    /// From a scene to arrays.
    Prepare,
    /// From arrays to light, or straight to codes.
    Draw,
    /// From light to codes.
    Develop,
    /// From codes to the bytes of a file.
    Encode,
}

const STAGES: [(Stage, &str); 5] = [
    (Stage::Load, "load"),
    (Stage::Prepare, "prepare"),
    (Stage::Draw, "draw"),
    (Stage::Develop, "develop"),
    (Stage::Encode, "encode"),
];

/// How long the stages of a picture take.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TimingsFacts {
    /// How often everything was done
    runs: usize,
    unit: &'static str,
    /// By the name of the stage; null for one that was done together with the one before it
    stages: BTreeMap<&'static str, Option<StageFacts>>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct StageFacts {
    median: f64,
    min: f64,
}

/// Milliseconds of every stage of every run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Timings {
    runs: Vec<[Option<f64>; STAGES.len()]>,
}

impl Timings {
    /// Begins the next run.
    pub(crate) fn begin_run(&mut self) {
        self.runs.push([None; STAGES.len()]);
    }

    /// Does `work` and adds its time to `stage` of the current run.
    pub(crate) fn measure<T>(&mut self, stage: Stage, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        let elapsed = start.elapsed().as_secs_f64() * 1e3;
        if self.runs.is_empty() {
            self.begin_run();
        }
        let run = self.runs.last_mut().expect("a run has begun");
        *run[stage as usize].get_or_insert(0.0) += elapsed;
        result
    }

    /// A table for people. A stage that was done together with the one before it has a dash.
    pub(crate) fn text(&self) -> String {
        let runs = self.runs.len();
        let mut text = format!("ms over {runs} {}\n", if runs == 1 { "run" } else { "runs" });
        text.push_str("stage        median       min\n");
        for (name, summary) in self.rows() {
            match summary {
                Some((median, min)) => writeln!(text, "{name:<8} {median:>10.3} {min:>9.3}"),
                None => writeln!(text, "{name:<8} {:>10} {:>9}", "-", "-"),
            }
            .expect("a string takes everything");
        }
        text
    }

    /// The same for programs; `null` for a stage that was done together with the one before it.
    pub(crate) fn facts(&self) -> TimingsFacts {
        let stage = |(median, min)| StageFacts { median: round(median), min: round(min) };
        let stages = self.rows().into_iter().map(|(name, summary)| (name, summary.map(stage)));
        TimingsFacts { runs: self.runs.len(), unit: "ms", stages: stages.collect() }
    }

    /// Every stage and the total, with median and minimum.
    fn rows(&self) -> Vec<(&'static str, Option<(f64, f64)>)> {
        let of = |values: Vec<f64>| summary(values);
        let mut rows: Vec<_> = STAGES
            .iter()
            .map(|&(stage, name)| {
                (name, of(self.runs.iter().filter_map(|run| run[stage as usize]).collect()))
            })
            .collect();
        let totals = self.runs.iter().map(|run| run.iter().flatten().sum()).collect();
        rows.push(("total", of(totals)));
        rows
    }
}

/// Median and minimum; `None` of nothing.
fn summary(mut values: Vec<f64>) -> Option<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    let (low, high) = (values.len().checked_sub(1)? / 2, values.len() / 2);
    Some((0.5 * (values[low] + values[high]), values[0]))
}

/// To the microsecond.
fn round(ms: f64) -> f64 {
    (ms * 1e3).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_of_an_even_number_is_the_mean_of_the_middle_two() {
        assert_eq!(summary(vec![4.0, 1.0, 3.0, 10.0]), Some((3.5, 1.0)));
        assert_eq!(summary(vec![2.0, 9.0, 5.0]), Some((5.0, 2.0)));
        assert_eq!(summary(vec![]), None);
    }

    #[test]
    fn times_of_one_stage_in_one_run_add_up() {
        let mut timings = Timings::default();
        timings.begin_run();
        timings.measure(Stage::Draw, || ());
        timings.measure(Stage::Draw, || ());
        timings.begin_run();
        timings.measure(Stage::Draw, || ());
        let facts = timings.facts();
        assert_eq!(facts.runs, 2);
        assert!(facts.stages["draw"].is_some() && facts.stages["develop"].is_none());
    }
}
