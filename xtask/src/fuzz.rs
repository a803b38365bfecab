//! Fuzzing of readers, by libFuzzer: whatever the bytes are, a reader gives a whole value or one error.
//!
//! The targets are built by the stable compiler: coverage needs no more than a pass of LLVM that it has. Only sanitisers would
//! need a nightly one, and the readers are without `unsafe` code.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use crate::steps::Outcome;
use crate::workspace::{Workspace, run, run_quietly, works};
use crate::{Failure, Result};

/// The readers of files that people have from elsewhere, which every run of the checks tries.
const READERS: [&str; 9] =
    ["gltf", "obj", "ply", "stl", "texture", "environment", "profile", "picture", "scene_toml"];

/// Counters of branches and values of comparisons, as libFuzzer wants them.
const INSTRUMENTED: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares --cfg fuzzing -Cdebug-assertions -Coverflow-checks";

/// Which targets run, and for how long.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Options {
    /// Those of this name in part; without it the readers of people's files.
    pub only: Option<String>,
    /// Seconds of each.
    pub seconds: u32,
    /// Where the random numbers begin: with the same number the same inputs come first.
    pub seed: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { only: None, seconds: 60, seed: 1 }
    }
}

/// How a target ended.
struct Run {
    name: String,
    /// What libFuzzer said.
    said: String,
    passed: bool,
}

/// The step of the checks.
pub(crate) fn check(workspace: &Workspace) -> Outcome {
    if !cfg!(target_os = "linux") {
        return Outcome::Skipped("libFuzzer is built on Linux only".to_owned());
    }
    if !works(workspace.command("c++").arg("--version")) {
        return Outcome::Skipped("there is no C++ compiler, which libFuzzer is built by".to_owned());
    }
    run_all(workspace, &Options::default()).into()
}

/// Builds the targets and runs them, as many at once as there are processors; fails with the inputs that break them.
pub(crate) fn run_all(workspace: &Workspace, options: &Options) -> Result<()> {
    let names = chosen(&targets(workspace)?, options.only.as_deref())?;
    let folder = workspace.target_folder("fuzz")?;
    let host = host(workspace)?;
    let mut cargo = workspace.cargo(&format!("build --quiet --release --target {host}"));
    cargo.args(["--manifest-path", "fuzz/Cargo.toml", "--target-dir"]).arg(&folder);
    names.iter().for_each(|name| {
        cargo.args(["--bin", name]);
    });
    cargo.env("RUSTFLAGS", INSTRUMENTED).env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "2");
    run(&mut cargo)?;
    println!("{} targets, {} s each", names.len(), options.seconds);
    let programs = folder.join(host).join("release");
    let (left, done) = (Mutex::new(names.into_iter()), Mutex::new(Vec::new()));
    let at_once = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..at_once {
            scope.spawn(|| {
                while let Some(name) = { left.lock().expect("no thread panics").next() } {
                    let run = fuzz(workspace, &programs, &folder, &name, options);
                    done.lock().expect("no thread panics").push(run);
                }
            });
        }
    });
    let mut broken = Vec::new();
    for run in done.into_inner().expect("no thread panics") {
        let run = run?;
        println!("{}", line(&run));
        if !run.passed {
            println!("{}", run.said);
            broken.push(run.name);
        }
    }
    match broken.is_empty() {
        true => Ok(()),
        false => Err(Failure::new(format!(
            "inputs break {}: they are in {}",
            broken.join(", "),
            folder.join("found").display()
        ))),
    }
}

/// Runs a target on its seeds and what was found in earlier runs.
fn fuzz(workspace: &Workspace, programs: &Path, folder: &Path, name: &str, options: &Options) -> Result<Run> {
    let (corpus, found) = (folder.join("corpus").join(name), folder.join("found"));
    for made in [&corpus, &found] {
        std::fs::create_dir_all(made).map_err(Failure::during(made.display()))?;
    }
    let mut command = workspace.command(programs.join(name));
    command.arg(&corpus).arg(seeds(workspace, name)).arg(format!("-max_total_time={}", options.seconds));
    command
        .arg(format!("-seed={}", options.seed))
        .arg(format!("-artifact_prefix={}/{name}-", found.display()));
    command.args(["-timeout=20", "-rss_limit_mb=6144", "-print_final_stats=1", "-verbosity=1"]);
    let output = command.output().map_err(Failure::during(name))?;
    let said = String::from_utf8_lossy(&output.stderr);
    // The rest are lines for each input that reaches something new.
    let told = |line: &&str| !line.starts_with('#');
    let said = said.lines().filter(told).collect::<Vec<_>>().join("\n");
    Ok(Run { name: name.to_owned(), said, passed: output.status.success() })
}

/// The folder of a target's seeds.
fn seeds(workspace: &Workspace, name: &str) -> PathBuf {
    match name {
        "scene_toml" => workspace.path("examples"),
        "shader_preprocess" | "shader_rewrite" => workspace.path("fuzz/seeds/shader"),
        _ => workspace.path("fuzz/seeds").join(name),
    }
}

/// A line for a target: how often it ran.
fn line(run: &Run) -> String {
    let stat = |name: &str| {
        let value = run.said.lines().find_map(|line| line.strip_prefix(&format!("stat::{name}:")));
        value.map_or("?", str::trim)
    };
    let ended = if run.passed { "ok    " } else { "BROKEN" };
    let (runs, rate) = (stat("number_of_executed_units"), stat("average_exec_per_sec"));
    format!("  {ended} {:<20} {runs:>9} runs, {rate:>6} a second, {} MB", run.name, stat("peak_rss_mb"))
}

/// The names of all targets.
fn targets(workspace: &Workspace) -> Result<Vec<String>> {
    let path = workspace.path("fuzz/Cargo.toml");
    let manifest = std::fs::read_to_string(&path).map_err(Failure::during(path.display()))?;
    let bins = manifest.split("[[bin]]").skip(1);
    let name = |bin: &str| {
        bin.lines()
            .find_map(|line| line.strip_prefix("name = "))
            .map(|name| name.trim_matches('"').to_owned())
    };
    Ok(bins.filter_map(name).collect())
}

/// The targets with this in their names, or the readers of people's files.
fn chosen(targets: &[String], only: Option<&str>) -> Result<Vec<String>> {
    let is_chosen = |name: &&String| match only {
        Some(part) => name.contains(part),
        None => READERS.contains(&name.as_str()),
    };
    let names: Vec<String> = targets.iter().filter(is_chosen).cloned().collect();
    match names.is_empty() {
        true => Err(Failure::new(format!("no target has that name; there are {}", targets.join(", ")))),
        false => Ok(names),
    }
}

/// The machine that the compiler compiles for.
fn host(workspace: &Workspace) -> Result<String> {
    let version = run_quietly(workspace.command("rustc").arg("-vV"))?;
    let version = String::from_utf8_lossy(&version);
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned).ok_or_else(|| Failure::new("rustc -vV does not tell the host"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reader_is_a_target_and_has_seeds() {
        let workspace = Workspace::find();
        let targets = targets(&workspace).unwrap();
        for name in READERS {
            assert!(targets.iter().any(|target| target == name), "{name}");
        }
        for name in &targets {
            // The reader of any measured file begins with those of all formats.
            assert!(name == "measure" || seeds(&workspace, name).is_dir(), "{name}");
        }
    }

    #[test]
    fn targets_are_chosen_by_a_part_of_their_names() {
        let targets = ["obj", "measure_csv", "measure_rgl"].map(str::to_owned);
        assert_eq!(chosen(&targets, None).unwrap(), ["obj"]);
        assert_eq!(chosen(&targets, Some("measure")).unwrap(), ["measure_csv", "measure_rgl"]);
        assert!(chosen(&targets, Some("gif")).is_err());
    }

    #[test]
    fn a_line_tells_how_often_a_target_ran() {
        let said =
            "stat::number_of_executed_units: 1234\nstat::average_exec_per_sec:     56\nstat::peak_rss_mb: 78";
        let run = Run { name: "obj".to_owned(), said: said.to_owned(), passed: true };
        let line = line(&run);
        assert!(
            line.contains("1234 runs") && line.contains("56 a second") && line.contains("78 MB"),
            "{line}"
        );
    }
}
