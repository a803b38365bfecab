//! What follows from the code, written anew: pages, snapshots, gold pictures.

use crate::workspace::{Workspace, run};
use crate::{Result, golden};

/// Writes anew what the tests compare the code with, and shows which files that changed.
pub(crate) fn run_all(workspace: &Workspace, pictures: bool) -> Result<()> {
    run(workspace.cargo("test --quiet --package glanz-bsdf --test page").env("GLANZ_RENEW_DOCS", "1"))?;
    run(workspace
        .cargo("test --quiet --package glanz-cli")
        .env("GLANZ_RENEW_DOCS", "1")
        .env("INSTA_UPDATE", "always"))?;
    if pictures {
        run(workspace.cargo("test --quiet --package glanz-render --test golden").env("GLANZ_RENEW", "1"))?;
        golden::renew(workspace)?;
    }
    println!("These differ from what is committed:");
    run(workspace.command("git").args(["status", "--short"]))
}
