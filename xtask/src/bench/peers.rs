//! Other programs that draw the same scene: Mesa's llvmpipe and the crate euc.
//!
//! What they need is set up in the target folder.

use std::path::PathBuf;
use std::process::Command;

use serde_json::Value;

use super::{measured, turns};
use crate::Result;
use crate::workspace::{Workspace, run, works};

/// Debian's packages for OpenGL without a screen.
const MESA: &str = "libegl1 libgl1 libgl1-mesa-dri";

/// Runs both peers. One that cannot be set up is a loud line, and the other still runs.
pub(super) fn run_all(workspace: &Workspace, quick: bool) -> Vec<Value> {
    let mut lines = Vec::new();
    for (name, result) in [("llvmpipe", llvmpipe(workspace, quick)), ("euc", euc(workspace, quick))] {
        match result {
            Ok(measured) => lines.extend(measured),
            Err(failure) => println!("!!! {name} was NOT measured: {failure}"),
        }
    }
    lines
}

fn llvmpipe(workspace: &Workspace, quick: bool) -> Result<Vec<Value>> {
    measured(llvmpipe_command(workspace)?.args(quick.then_some("--quick")))
}

/// Glanz and llvmpipe in turn; a table.
pub(super) fn in_turn(workspace: &Workspace, quick: bool) -> Result<String> {
    let mut command = llvmpipe_command(workspace)?;
    command.arg("--serve");
    turns::run_all(workspace, command, quick)
}

/// The program that draws with llvmpipe, with all that it needs set up.
fn llvmpipe_command(workspace: &Workspace) -> Result<Command> {
    let mut command = moderngl_command(workspace)?;
    command.arg("xtask/peers/llvmpipe.py");
    Ok(command)
}

/// A Python that draws with llvmpipe.
pub(super) fn moderngl_command(workspace: &Workspace) -> Result<Command> {
    let python = python(workspace)?;
    let mut probe = workspace.command(&python);
    if !works(probe.args(["xtask/peers/llvmpipe.py", "--probe"])) {
        println!("no OpenGL without a screen here: installing Debian's {MESA}");
        run(workspace
            .command("apt-get")
            .args(["install", "-y", "--no-install-recommends"])
            .args(MESA.split(' ')))?;
    }
    Ok(workspace.command(&python))
}

/// A Python with moderngl and numpy, in an environment of its own.
fn python(workspace: &Workspace) -> Result<PathBuf> {
    let folder = workspace.target_folder("peers")?.join("venv");
    let python = folder.join("bin/python");
    if !works(workspace.command(&python).args(["-c", "import moderngl, numpy"])) {
        run(workspace.command("python3").args(["-m", "venv"]).arg(&folder))?;
        run(workspace.command(&python).args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "moderngl==5.13.0",
            "numpy",
        ]))?;
    }
    Ok(python)
}

fn euc(workspace: &Workspace, quick: bool) -> Result<Vec<Value>> {
    let mut command =
        workspace.cargo("run --release --quiet --manifest-path xtask/peers/euc/Cargo.toml --target-dir");
    // euc relies on fused multiply-add, which is a slow library call where the processor may lack it.
    command.env("RUSTFLAGS", "-C target-cpu=native");
    command.arg(workspace.target_folder("peers")?.join("euc")).arg("--").args(quick.then_some("--quick"));
    measured(&mut command)
}
