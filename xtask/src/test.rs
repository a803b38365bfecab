//! Every check of the house, one after the other.

use std::path::Path;

use crate::house::{House, Profile, run, works};
use crate::steps::{Outcome, Steps};
use crate::{Result, data, gallery, golden, reference, tour, wasm};

/// How much is checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Leave out what takes long: documentation, examples, other SIMD levels, wasm32.
    pub quick: bool,
    /// Run the later steps even after one has failed.
    pub keep_going: bool,
    /// Only the steps with this in their name.
    pub only: Option<String>,
}

/// Runs the checks, prints a summary and fails if any did.
pub fn run_all(house: &House, options: &Options) -> Result<()> {
    checks(house, options).finish()
}

fn checks(house: &House, options: &Options) -> Steps {
    let mut steps = Steps::new(options.keep_going, options.only.clone());
    steps.run("format", || format(house));
    steps.run("lint", || run(&mut house.cargo("clippy --workspace --all-targets --quiet -- -D warnings")));
    steps.run("unit and integration tests", || tests(house));
    if options.quick {
        steps.run("gold pictures, narrowest path", || golden::compare(house, golden::Paths::Narrowest));
        return steps;
    }
    steps.run("gold pictures, every path", || golden::compare(house, golden::Paths::All));
    steps.run("colours against colour-science", || {
        oracle(house, |house| {
            let glanz = house.glanz(Profile::Dev)?;
            compare(house, "colors", "requirements.txt", ("GLANZ", &glanz))
        })
    });
    steps.run("models against Mitsuba", || {
        oracle(house, |house| {
            run(&mut house.cargo("build --quiet --package glanz-bsdf --example eval"))?;
            let eval = format!("debug/examples/eval{}", std::env::consts::EXE_SUFFIX);
            compare(house, "models", "requirements-models.txt", ("GLANZ_EVAL", &house.target().join(eval)))
        })
    });
    steps.run("examples", || gallery::try_examples(house));
    steps.run("what the README shows", || tour::run(house));
    steps.run("reference of the scene file", || reference::check(house));
    steps.run("documentation tests", || run(&mut house.cargo("test --workspace --doc --quiet")));
    steps.run("documentation", || {
        run(house.cargo("doc --workspace --no-deps --quiet").env("RUSTDOCFLAGS", "-D warnings"))
    });
    steps.run("libraries without threads", || wasm::serial(house));
    steps.run("libraries for wasm32", || wasm::check(house));
    steps
}

/// The format of all Rust code, also of the packages that stand beside the workspace.
fn format(house: &House) -> Result<()> {
    run(&mut house.cargo("fmt --all -- --check"))?;
    for package in ["fuzz", "xtask/peers/euc"] {
        run(&mut house.cargo(&format!("fmt --manifest-path {package}/Cargo.toml -- --check")))?;
    }
    Ok(())
}

/// A comparison with an independent implementation, where there is a Python.
fn oracle(house: &House, comparison: impl FnOnce(&House) -> Result<()>) -> Outcome {
    if !works(house.command("python3").args(["-c", "import ensurepip, venv"])) {
        return Outcome::Skipped("there is no python3 (3.10 or newer, with venv) on this machine".to_owned());
    }
    comparison(house).into()
}

/// Runs `tests/python/test_….py` with the packages of a file beside it and the path of a program of ours.
fn compare(house: &House, what: &str, requirements: &str, (variable, ours): (&str, &Path)) -> Result<()> {
    let python =
        data::python_with(house, &format!("oracle-python-{what}"), &format!("tests/python/{requirements}"))?;
    let test = format!("tests/python/test_{what}.py");
    run(house.command(python).args(["-W", "ignore", "-m", "unittest", &test]).env(variable, ours))
}

/// The tests, with nextest; it is installed where it is missing.
fn tests(house: &House) -> Outcome {
    if !has_nextest(house) {
        println!("cargo-nextest is missing: installing it, once, which takes some minutes");
        if let Err(failure) = run(&mut house.cargo("install cargo-nextest --locked")) {
            println!("!!! {failure}");
            println!("!!! cargo-nextest could not be installed: running the slower `cargo test` instead");
            return run(&mut house.cargo("test --workspace --all-targets")).into();
        }
    }
    run(&mut house.cargo("nextest run --workspace --no-fail-fast --status-level slow")).into()
}

fn has_nextest(house: &House) -> bool {
    works(&mut house.cargo("nextest --version"))
}
