//! The example programs of the library: each must run, and the files that it tells of must be there.

use std::path::Path;

use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// Builds and runs all examples of the library, with a folder for what they write.
pub(crate) fn run_all(workspace: &Workspace) -> Result<()> {
    let sources = workspace.path("crates/glanz/examples");
    let folder = workspace.target_folder("library-examples")?;
    let entries = std::fs::read_dir(&sources).map_err(Failure::during(sources.display()))?;
    let mut names: Vec<_> =
        entries.filter_map(|entry| Some(entry.ok()?.path().file_stem()?.to_owned())).collect();
    names.sort();
    workspace.glanz(Profile::Dev)?;
    for name in &names {
        let name = name.to_string_lossy();
        let mut command = workspace.command(workspace.program(&format!("debug/examples/{name}"))?);
        // Those that write nothing take a model's name, or nothing.
        if !matches!(&*name, "certify" | "compare") {
            command.arg(&folder);
        }
        let said = run_quietly(&mut command)?;
        check_files(&name, &String::from_utf8_lossy(&said))?;
    }
    println!("{} examples run", names.len());
    Ok(())
}

/// Each line `wrote PATH` must be true.
fn check_files(example: &str, said: &str) -> Result<()> {
    for path in said.lines().filter_map(|line| line.strip_prefix("wrote ")) {
        if !Path::new(path).metadata().is_ok_and(|file| file.len() > 0) {
            return Err(Failure::new(format!(
                "the example {example} says that it wrote {path}, but did not"
            )));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_not_there_is_told() {
        let error = check_files("render", "hello\nwrote /no/such/file.png\n").expect_err("there is none");
        assert!(error.to_string().contains("/no/such/file.png"));
        assert!(check_files("certify", "nothing is written").is_ok());
    }
}
