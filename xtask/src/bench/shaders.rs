//! Shaders of users on the lane machine, by themselves and in turn with llvmpipe.

use serde_json::Value;

use super::{measured, peers};
use crate::Result;
use crate::workspace::{Workspace, run};

/// The course's Phong, and five lights in two loops with structs, arrays and a call.
const FILES: [&str; 2] =
    ["crates/shader/tests/shader/texts/specular.frag", "crates/shader/tests/shader/texts/loops.frag"];

/// The course's program with a loop over all kinds of lights in its fragment stage.
const COURSE: &str = "phong-330";

/// Every SIMD level, 16 and 64 lanes.
pub(super) fn run_all(workspace: &Workspace) -> Result<Vec<Value>> {
    let mut cargo = workspace.cargo("run --release --quiet --package glanz-shader --example bench --");
    measured(cargo.args(FILES).arg(COURSE))
}

/// The best level and llvmpipe, alternating in one run.
pub(super) fn in_turn(workspace: &Workspace) -> Result<Vec<Value>> {
    run(&mut workspace.cargo("build --release --quiet --package glanz-shader --example bench"))?;
    let bench = workspace.target().join(format!("release/examples/bench{}", std::env::consts::EXE_SUFFIX));
    measured(peers::moderngl_command(workspace)?.arg("xtask/peers/shaders.py").arg(bench).args(FILES))
}
