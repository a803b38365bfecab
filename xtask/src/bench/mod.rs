//! How fast it draws, and how fast others do.
//!
//! Every program prints JSON lines; the tables are made here. Two kinds of line are known:
//!
//! * `{"program", "sphere", "lights", "median_ms", "min_ms", …}`: a frame of the benchmark's sphere;
//! * `{"table", "name", …numbers}`: a row of a table of that title.

mod peers;
mod report;
mod shaders;
mod turns;
mod whole;

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::workspace::Workspace;
use crate::{Failure, Result};

/// What is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Options {
    /// Fewer frames.
    pub quick: bool,
    /// The peers, too.
    pub peers: bool,
    /// The peers alone.
    pub only_peers: bool,
    /// Put the tables into `docs/BENCHMARKS.md`.
    pub write: bool,
}

/// Measures, then prints the tables.
pub(crate) fn run_all(workspace: &Workspace, options: &Options) -> Result<()> {
    let mut lines = Vec::new();
    if !options.only_peers {
        let quick = if options.quick { " -- --quick" } else { "" };
        let kernels = format!("run --release --quiet --package glanz-render --example bench{quick}");
        lines.extend(measured(&mut workspace.cargo(&kernels))?);
        lines.extend(whole::run_all(workspace, options.quick)?);
        lines.extend(shaders::run_all(workspace)?);
    }
    let mut turns = String::new();
    if options.peers || options.only_peers {
        lines.extend(peers::run_all(workspace, options.quick));
        match shaders::in_turn(workspace) {
            Ok(rows) => lines.extend(rows),
            Err(failure) => println!("!!! shaders were NOT measured in turn with llvmpipe: {failure}"),
        }
        match peers::in_turn(workspace, options.quick) {
            Ok(table) => turns = table,
            Err(failure) => println!("!!! nothing was measured in turn with llvmpipe: {failure}"),
        }
    }
    let report = report::report(workspace, &lines, options) + &turns;
    println!("\n{report}");
    if options.write {
        report::write(workspace, &report)?;
    }
    Ok(())
}

/// Runs a program and gives the JSON lines that it prints; they are shown as they come.
fn measured(command: &mut Command) -> Result<Vec<Value>> {
    let name = command.get_program().to_string_lossy().into_owned();
    let failed = |what: String| Failure::new(format!("{name}: {what}"));
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(|error| failed(error.to_string()))?;
    let stdout = child.stdout.take().expect("the pipe was asked for");
    let mut lines = Vec::new();
    for line in BufReader::new(stdout).lines() {
        let line = line.map_err(|error| failed(error.to_string()))?;
        println!("{line}");
        // What is no JSON is a remark for whoever watches.
        lines.extend(serde_json::from_str::<Value>(&line).ok().filter(Value::is_object));
    }
    let status = child.wait().map_err(|error| failed(error.to_string()))?;
    match status.success() {
        true => Ok(lines),
        false => Err(failed(format!("ended with {status}"))),
    }
}
