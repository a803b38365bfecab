//! Every check of the workspace, one after the other.

use std::path::{Path, PathBuf};

use crate::steps::{Outcome, Steps};
use crate::workspace::{Profile, WHOLE, Workspace, run, run_quietly, works};
use crate::{
    Failure, Result, advisories, data, features, fuzz, gallery, golden, library_examples, licenses, packages,
    reference, tour, wasm,
};

/// How much is checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Options {
    /// Leave out what takes long: documentation, examples, other SIMD levels, wasm32.
    pub quick: bool,
    /// Run the later steps even after one has failed.
    pub keep_going: bool,
    /// Only the steps with this in their name.
    pub only: Option<String>,
}

/// Runs the checks, prints a summary and fails if any did.
pub(crate) fn run_all(workspace: &Workspace, options: &Options) -> Result<()> {
    checks(workspace, options).finish()
}

fn checks(workspace: &Workspace, options: &Options) -> Steps {
    let mut steps = Steps::new(options.keep_going, options.only.clone());
    steps.run("format", || format(workspace));
    steps.run("lint", || {
        run(&mut workspace.cargo(&format!("clippy {WHOLE} --all-targets --quiet -- -D warnings")))
    });
    steps.run("unit and integration tests", || tests(workspace));
    if options.quick {
        steps.run("gold pictures, narrowest path", || golden::compare(workspace, golden::Paths::Narrowest));
        return steps;
    }
    steps.run("drawing without optimisation", || {
        // Dependencies stay optimised, and so are there already.
        run(&mut workspace
            .cargo(&format!("test --quiet {WHOLE} --test stack --config profile.dev.opt-level=0")))
    });
    steps.run("gold pictures, every path", || golden::compare(workspace, golden::Paths::All));
    steps.run("colours against colour-science", || {
        oracle(workspace, |workspace| {
            let glanz = workspace.glanz(Profile::Dev)?;
            compare(workspace, "colors", COLORS, ("GLANZ", &glanz))
        })
    });
    steps.run("models against Mitsuba", || {
        oracle(workspace, |workspace| {
            let eval = workspace.built("examples/eval")?;
            compare(workspace, "models", MITSUBA, ("GLANZ_EVAL", &eval))
        })
    });
    steps.run("exact light against Mitsuba", || oracle(workspace, lighting));
    steps.run("measured reflectance against Mitsuba and Radiance", || oracle(workspace, measured));
    steps.run("shaders against OpenGL", || shaders(workspace));
    steps.run("examples of the library", || library_examples::run_all(workspace));
    steps.run("examples", || gallery::try_examples(workspace));
    steps.run("what the README shows", || tour::run(workspace));
    steps.run("reference of the scene file", || reference::check(workspace));
    steps.run("documentation tests", || run(&mut workspace.cargo(&format!("test {WHOLE} --doc --quiet"))));
    steps.run("documentation", || {
        run(workspace.cargo(&format!("doc {WHOLE} --no-deps --quiet")).env("RUSTDOCFLAGS", "-D warnings"))
    });
    steps.run("licences of libraries", || licenses::check(workspace));
    steps.run("advisories", || advisories::check(workspace, None));
    steps.run("fuzzing", || fuzz::check(workspace));
    steps.run("packages", || packages::check(workspace));
    steps.run("features", || features::check(workspace));
    steps.run("libraries without threads", || features::check_serial(workspace));
    steps.run("libraries for wasm32", || wasm::check(workspace));
    steps
}

/// The format of all Rust code, also of the packages that stand beside the workspace.
fn format(workspace: &Workspace) -> Result<()> {
    run(&mut workspace.cargo("fmt --all -- --check"))?;
    for package in ["fuzz", "xtask/peers/euc"] {
        run(&mut workspace.cargo(&format!("fmt --manifest-path {package}/Cargo.toml -- --check")))?;
    }
    Ok(())
}

/// A comparison with an independent implementation, where there is a Python.
fn oracle(workspace: &Workspace, comparison: impl FnOnce(&Workspace) -> Result<()>) -> Outcome {
    if !works(workspace.command("python3").args(["-c", "import ensurepip, venv"])) {
        return Outcome::Skipped("there is no python3 (3.10 or newer, with venv) on this machine".to_owned());
    }
    comparison(workspace).into()
}

/// Areas, environments and half-shadows, as Mitsuba finds them.
fn lighting(workspace: &Workspace) -> Result<()> {
    compare(workspace, "lighting", MITSUBA, ("GLANZ_PROGRAM", &workspace.glanz(Profile::Dev)?))
}

/// Tables that the virtual goniometer writes, as Mitsuba and Radiance's library read them.
fn measured(workspace: &Workspace) -> Result<()> {
    let eval = workspace.built("examples/eval_measured")?;
    let glanz = workspace.glanz(Profile::Dev)?;
    let folder = workspace.target().join("measured");
    std::fs::create_dir_all(&folder).map_err(Failure::during(folder.display()))?;
    std::fs::copy(&eval, folder.join("eval_measured")).map_err(Failure::during(eval.display()))?;
    for (name, words) in [
        ("glossy.bsdf", "ggx --set alpha=0.15 --diffuse 0.3"),
        ("matte.bsdf", "oren-nayar"),
        ("rough.bsdf", "cook-torrance --set m=0.4"),
        ("brushed.bsdf", "ward --set alpha=0.15 --set alpha_y=0.4 --diffuse 0.3"),
        ("brushed.xml", "ward --set alpha=0.15 --set alpha_y=0.4 --diffuse 0.3"),
    ] {
        let mut sample = workspace.command(&glanz);
        sample.args(["measure", "sample"]).args(words.split(' ')).arg("-o").arg(folder.join(name));
        run_quietly(&mut sample)?;
    }
    compare(workspace, "measured", MEASURED, ("GLANZ_MEASURED", &folder))
}

/// Debian's packages for OpenGL without a screen.
const MESA: &str = "libegl1 libgl1 libgl1-mesa-dri";

/// Shaders on the lane machine against Mesa's llvmpipe, where OpenGL without a screen can be had.
fn shaders(workspace: &Workspace) -> Outcome {
    let built = oracle(workspace, |workspace| workspace.built("examples/oracle").map(drop));
    if built != Outcome::Passed {
        return built;
    }
    let python = match environment(workspace, OPENGL) {
        Ok(python) => python,
        Err(failure) => return Outcome::Skipped(format!("moderngl cannot be installed: {failure}")),
    };
    let probe = "import moderngl; moderngl.create_standalone_context(backend='egl')";
    let has_egl = || works(workspace.command(&python).args(["-c", probe]));
    if !has_egl() {
        println!("no OpenGL without a screen here: installing Debian's {MESA}");
        let mut install = workspace.command("apt-get");
        install.args(["install", "-y", "--no-install-recommends"]).args(MESA.split(' '));
        if run(&mut install).is_err() || !has_egl() {
            return Outcome::Skipped(format!("there is no EGL, and {MESA} could not be installed"));
        }
    }
    let ours = workspace.target().join(format!("debug/examples/oracle{}", std::env::consts::EXE_SUFFIX));
    compare(workspace, "shaders", OPENGL, ("GLANZ_ORACLE", &ours)).into()
}

/// An environment of Python: its name and the file with its packages, in `tests/python`.
type Packages = (&'static str, &'static str);

const COLORS: Packages = ("oracle-python-colors", "requirements.txt");
const MITSUBA: Packages = ("oracle-python-models", "requirements-models.txt");
const MEASURED: Packages = ("oracle-python-measured", "requirements-measured.txt");
const OPENGL: Packages = ("oracle-python-shaders", "requirements-shaders.txt");

/// The Python of an environment, made where it is missing.
fn environment(workspace: &Workspace, (name, requirements): Packages) -> Result<PathBuf> {
    data::python_with(workspace, name, &format!("tests/python/{requirements}"))
}

/// Runs `tests/python/test_….py` with these packages and the path of a program of ours.
fn compare(
    workspace: &Workspace,
    what: &str,
    packages: Packages,
    (variable, ours): (&str, &Path),
) -> Result<()> {
    let python = environment(workspace, packages)?;
    let test = format!("tests/python/test_{what}.py");
    run(workspace.command(python).args(["-W", "ignore", "-m", "unittest", &test]).env(variable, ours))
}

/// The tests, with nextest; it is installed where it is missing.
fn tests(workspace: &Workspace) -> Outcome {
    if !has_nextest(workspace) {
        println!("cargo-nextest is missing: installing it, once, which takes some minutes");
        if let Err(failure) = run(&mut workspace.cargo("install cargo-nextest --locked")) {
            println!("!!! {failure}");
            println!("!!! cargo-nextest could not be installed: running the slower `cargo test` instead");
            return run(&mut workspace.cargo(&format!("test {WHOLE} --all-targets"))).into();
        }
    }
    run(&mut workspace.cargo(&format!("nextest run {WHOLE} --no-fail-fast --status-level slow"))).into()
}

fn has_nextest(workspace: &Workspace) -> bool {
    works(&mut workspace.cargo("nextest --version"))
}
