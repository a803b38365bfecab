//! Whether the library crates compile for the web, where there are no threads.

use std::process::Command;

use crate::features::{LIBRARIES, SERIAL};
use crate::steps::Outcome;
use crate::workspace::{Workspace, run, run_quietly, works};

const TARGET: &str = "wasm32-unknown-unknown";

/// Checks the libraries for wasm32 with the first toolchain that has that target.
pub(crate) fn check(workspace: &Workspace) -> Outcome {
    let check = format!("check {LIBRARIES} --no-default-features --features {SERIAL} --target {TARGET}");
    let own_folder = workspace.target().join("wasm");
    let mut command = if has_target(&mut workspace.command("rustc")) {
        workspace.cargo(&check)
    } else if works(workspace.command("rustup").args(["run", "wasm", "rustc", "--version"]))
        && has_target(workspace.command("rustup").args(["run", "wasm", "rustc"]))
    {
        let mut command = workspace.command("rustup");
        command.args(["run", "wasm", "cargo"]).args(check.split_whitespace());
        // Only macros and build scripts are compiled in a check: optimising them costs more than it gains.
        command.args(["--config", "profile.dev.package.\"*\".opt-level=0"]);
        // Another compiler: it must not fight with the default one over the same folder.
        command.env_remove("RUSTC").env("CARGO_TARGET_DIR", own_folder);
        command
    } else {
        return Outcome::Skipped(format!(
            "neither the default toolchain nor one named 'wasm' has the target {TARGET} \
             (try: rustup target add {TARGET})"
        ));
    };
    run(&mut command).into()
}

/// Whether this compiler comes with a standard library for the target.
fn has_target(rustc: &mut Command) -> bool {
    let Ok(folder) = run_quietly(rustc.args(["--print", "target-libdir", "--target", TARGET])) else {
        return false;
    };
    let folder = String::from_utf8_lossy(&folder);
    let Ok(entries) = std::fs::read_dir(folder.trim()) else { return false };
    entries.flatten().any(|entry| entry.file_name().to_string_lossy().starts_with("libcore-"))
}
