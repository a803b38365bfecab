//! Glanz and Mesa's llvmpipe on the same scene, in turn.
//!
//! On a machine that others use too, two programs that run one after the other are not measured under the same
//! conditions. Here each draws a batch of frames and then waits while the others draw theirs, many times over, so
//! that whatever else the machine does falls on all of them. A ratio is the median of the ratios within one round.
//!
//! Each program is asked for `SPHERE LIGHTS FRAMES` on its standard input, and answers with the milliseconds of each
//! frame as a line of JSON.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Lines, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::Value;

use crate::workspace::{Workspace, run};
use crate::{Failure, Result};

/// What is drawn: Phong shading, with these numbers of lights.
const SPHERES: [&str; 2] = ["64x32", "1024x512"];
const LIGHTS: [u32; 3] = [1, 4, 8];

/// Frames of a batch: the first are not counted, for they find the caches full of what others drew.
const UNCOUNTED: usize = 2;
const COUNTED: usize = 8;

/// A program that draws when it is asked to.
struct Player {
    name: String,
    child: Child,
    orders: ChildStdin,
    answers: Lines<BufReader<ChildStdout>>,
}

/// The milliseconds of all frames that a player drew of one scene, and the median of each round.
#[derive(Default)]
struct Times {
    frames: Vec<f64>,
    rounds: Vec<f64>,
}

/// Lets them draw in turn; gives the tables of what they took.
pub(super) fn run_all(workspace: &Workspace, llvmpipe: Command, quick: bool) -> Result<String> {
    run(&mut workspace.cargo("build --release --quiet --package glanz-render --example bench"))?;
    let bench = workspace.target().join("release/examples/bench");
    let mut players = vec![Player::start("llvmpipe, 2 threads", llvmpipe)?];
    for (level, threads) in [("avx2", 1), ("avx2", 2), ("avx512", 1), ("avx512", 2)] {
        match glanz(workspace, &bench, level, threads) {
            Ok(player) => players.push(player),
            Err(failure) => println!("!!! glanz with {level} was NOT measured: {failure}"),
        }
    }
    let rounds = if quick { 5 } else { 25 };
    let mut text = format!(
        "\n### In turn: {rounds} rounds of {COUNTED} frames of each program, Phong shading, ms per frame\n\n\
         | | lights | median | least | llvmpipe / it: median (quartiles) |\n|---|---|---|---|---|\n"
    );
    for sphere in SPHERES {
        for lights in LIGHTS {
            let times = play(&mut players, sphere, lights, rounds)?;
            for (player, own) in players.iter().zip(&times) {
                let row = row(&player.name, sphere, lights, own, &times[0]);
                print!("{row}");
                text += &row;
            }
        }
    }
    Ok(text)
}

/// Glanz at a SIMD level, with so many threads; an error where the processor does not have the level.
fn glanz(workspace: &Workspace, bench: &Path, level: &str, threads: u32) -> Result<Player> {
    let mut command = workspace.command(bench);
    command.arg("--serve").env("GLANZ_SIMD", level).env("RAYON_NUM_THREADS", threads.to_string());
    let mut player = Player::start(&format!("glanz, {level}, {threads} threads"), command)?;
    player.draw("64x32", 1, 1)?;
    Ok(player)
}

fn play(players: &mut [Player], sphere: &str, lights: u32, rounds: usize) -> Result<Vec<Times>> {
    let mut times: Vec<Times> = players.iter().map(|_| Times::default()).collect();
    for round in 0..=rounds {
        for turn in 0..players.len() {
            // Who comes first changes from round to round.
            let who = (turn + round) % players.len();
            let mut batch = players[who].draw(sphere, lights, UNCOUNTED + COUNTED)?.split_off(UNCOUNTED);
            // The first round is for warming up.
            if round > 0 {
                batch.sort_by(f64::total_cmp);
                times[who].rounds.push(quantile(&batch, 0.5));
                times[who].frames.append(&mut batch);
            }
        }
    }
    for own in &mut times {
        own.frames.sort_by(f64::total_cmp);
    }
    Ok(times)
}

fn row(name: &str, sphere: &str, lights: u32, own: &Times, other: &Times) -> String {
    let mut ratios: Vec<f64> = other.rounds.iter().zip(&own.rounds).map(|(other, own)| other / own).collect();
    ratios.sort_by(f64::total_cmp);
    let [low, median, high] = [0.25, 0.5, 0.75].map(|part| quantile(&ratios, part));
    let (middle, least) = (quantile(&own.frames, 0.5), quantile(&own.frames, 0.0));
    let mut row = String::new();
    let _ = writeln!(
        row,
        "| {sphere}: {name} | {lights} | {middle:.2} | {least:.2} | {median:.2} ({low:.2}–{high:.2}) |"
    );
    row
}

/// The value below which a part of the sorted values lies.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((last as f64 * part).round() as usize).copied().unwrap_or(f64::NAN)
}

impl Player {
    fn start(name: &str, mut command: Command) -> Result<Self> {
        let failed = Failure::during(name);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(failed)?;
        let orders = child.stdin.take().expect("the pipe was asked for");
        let answers = BufReader::new(child.stdout.take().expect("the pipe was asked for")).lines();
        Ok(Self { name: name.to_owned(), child, orders, answers })
    }

    /// Draws frames; the milliseconds of each.
    fn draw(&mut self, sphere: &str, lights: u32, frames: usize) -> Result<Vec<f64>> {
        writeln!(self.orders, "{sphere} {lights} {frames}").map_err(Failure::during(&self.name))?;
        let ended = || Failure::new(format!("{} ended early", self.name));
        let answer = self.answers.next().ok_or_else(ended)?.map_err(Failure::during(&self.name))?;
        let times: Option<Vec<f64>> = serde_json::from_str::<Value>(&answer)
            .ok()
            .and_then(|value| value.as_array()?.iter().map(Value::as_f64).collect());
        times
            .filter(|times| times.len() == frames)
            .ok_or_else(|| Failure::new(format!("{} answered '{answer}'", self.name)))
    }
}

impl Drop for Player {
    fn drop(&mut self) {
        // It ends when nobody can ask any more; should it not, it is of no further use anyway.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_the_median_of_the_rounds() {
        let own = Times { frames: vec![1.0, 2.0, 4.0], rounds: vec![1.0, 2.0, 4.0] };
        let other = Times { frames: vec![3.0, 6.0, 16.0], rounds: vec![3.0, 6.0, 16.0] };
        let row = row("glanz", "64x32", 4, &own, &other);
        assert_eq!(row, "| 64x32: glanz | 4 | 2.00 | 1.00 | 3.00 (3.00–4.00) |\n");
    }
}
