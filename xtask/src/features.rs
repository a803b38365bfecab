//! Whether the libraries compile with every choice of features, and take no crate that was not asked for.

use crate::workspace::{Workspace, run, run_quietly};
use crate::{Failure, Result};

/// The crates that know no window and no terminal.
pub(crate) const LIBRARIES: &str = "-p glanz-math -p glanz-color -p glanz-bsdf -p glanz-picture -p glanz-measure -p glanz-eye -p glanz-plot -p glanz-shader -p glanz-scene -p glanz-render -p glanz";

/// All features but threads.
pub(crate) const SERIAL: &str = "glanz/exr,glanz/gif,glanz/plot";

/// What each feature of `glanz` adds; without it none of these may be there.
const ADDED: &[(&str, &[&str])] = &[
    ("rayon", &["rayon"]),
    ("exr", &["exr"]),
    ("gif", &["gif"]),
    ("plot", &["plotters", "skrifa"]),
    ("gpu", &["wgpu"]),
];

/// The feature that is on by default, and so part of what the test compiles.
const DEFAULT: &str = "rayon";

/// What is for the command alone.
const COMMAND_ONLY: &[&str] = &["clap", "miette", "indicatif"];

/// Checks what `glanz` takes, that it compiles with each feature alone, and what it says of those that are off.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    check_dependencies(workspace, "", &[DEFAULT])?;
    check_dependencies(workspace, "--no-default-features", &[])?;
    for (feature, _) in ADDED {
        let chosen = format!("--no-default-features --features {feature}");
        check_dependencies(workspace, &chosen, &[feature])?;
        if *feature != DEFAULT {
            run(&mut workspace.cargo(&format!("check --quiet -p glanz {chosen}")))?;
        }
    }
    // The other tests run with all features: here those that are off by default are, and the errors are met.
    // Nothing is drawn: what is compiled for this alone is compiled fast.
    let mut cargo = workspace.cargo("test --quiet -p glanz --test features --config profile.dev.opt-level=0");
    run(cargo.args(["--config", "profile.dev.package.\"*\".opt-level=0"]))
}

/// Checks the libraries without rayon, with no other feature and with all others.
pub(crate) fn check_serial(workspace: &Workspace) -> Result<()> {
    run(&mut workspace.cargo(&format!("check {LIBRARIES} --no-default-features")))?;
    run(&mut workspace.cargo(&format!("check {LIBRARIES} --no-default-features --features {SERIAL}")))
}

/// Fails if `glanz` takes a crate of a feature that is not on, or lacks one of those that are.
fn check_dependencies(workspace: &Workspace, chosen: &str, on: &[&str]) -> Result<()> {
    let tree = run_quietly(
        &mut workspace.cargo(&format!("tree -p glanz {chosen} -e normal --prefix none --format {{lib}}")),
    )?;
    let tree = String::from_utf8_lossy(&tree);
    let has = |name: &&&str| tree.lines().any(|line| line.trim() == **name);
    let unasked = ADDED.iter().filter(|(feature, _)| !on.contains(feature)).flat_map(|(_, names)| *names);
    if let Some(name) = unasked.chain(COMMAND_ONLY).find(has) {
        return Err(Failure::new(format!("`glanz {chosen}` takes the crate {name}, which nothing asks for")));
    }
    let asked = ADDED.iter().filter(|(feature, _)| on.contains(feature)).flat_map(|(_, names)| *names);
    match asked.into_iter().find(|name| !has(name)) {
        Some(name) => Err(Failure::new(format!("`glanz {chosen}` does not take the crate {name}"))),
        None => Ok(()),
    }
}
