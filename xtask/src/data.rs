//! The colour tables of `crates/color/data`, written from public packages by a Python script.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::workspace::{Workspace, run, run_quietly};
use crate::{Failure, Result};

/// What the script needs: packages and their versions.
const REQUIREMENTS: &str = "xtask/data/requirements.txt";
/// The script; its only argument is the folder that it writes to.
const SCRIPT: &str = "xtask/data/tables.py";
/// Where the tables are kept.
const TABLES: &str = "crates/color/data";

/// Writes all tables anew.
pub(crate) fn renew(workspace: &Workspace) -> Result<()> {
    let folder = workspace.path(TABLES);
    write(workspace, &folder)?;
    println!("{} tables are in {TABLES}", tables(&folder)?.len());
    Ok(())
}

/// Writes all tables into the target folder and compares them with those that are kept.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let folder = workspace.target_folder("data-check")?;
    for name in tables(&folder)?.keys() {
        std::fs::remove_file(folder.join(name)).map_err(Failure::during(name))?;
    }
    write(workspace, &folder)?;
    let (kept, written) = (tables(&workspace.path(TABLES))?, tables(&folder)?);
    let complaints = complaints(&kept, &written);
    match complaints.is_empty() {
        true => {
            println!("{} tables are as the script writes them", kept.len());
            Ok(())
        }
        false => Err(Failure::new(format!("{TABLES} differs:\n  {}", complaints.join("\n  ")))),
    }
}

fn write(workspace: &Workspace, folder: &Path) -> Result<()> {
    run_quietly(workspace.command(python(workspace)?).arg(SCRIPT).arg(folder)).map(drop)
}

/// A Python with all that the script needs.
fn python(workspace: &Workspace) -> Result<PathBuf> {
    python_with(workspace, "data-python", REQUIREMENTS)
}

/// A Python in a folder of the target folder, with the packages of a file; made where it is missing or out of
/// date.
pub(crate) fn python_with(workspace: &Workspace, folder: &str, requirements: &str) -> Result<PathBuf> {
    let home = workspace.target().join(folder);
    let (folder, name) = if cfg!(windows) { ("Scripts", "python.exe") } else { ("bin", "python") };
    let python = home.join(folder).join(name);
    let wanted = workspace.path(requirements);
    let wanted = std::fs::read(&wanted).map_err(Failure::during(wanted.display()))?;
    let done = home.join("installed.txt");
    if std::fs::read(&done).is_ok_and(|installed| installed == wanted) {
        return Ok(python);
    }
    let system = if cfg!(windows) { "python" } else { "python3" };
    run(workspace.command(system).args(["-m", "venv"]).arg(&home))?;
    run(workspace.command(&python).args(["-m", "pip", "install", "--quiet", "-r", requirements]))?;
    std::fs::write(&done, wanted).map_err(Failure::during(done.display()))?;
    Ok(python)
}

/// The files of a folder by name.
fn tables(folder: &Path) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut tables = BTreeMap::new();
    for entry in std::fs::read_dir(folder).map_err(Failure::during(folder.display()))? {
        let path = entry.map_err(Failure::during(folder.display()))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        tables.insert(name, std::fs::read(&path).map_err(Failure::during(path.display()))?);
    }
    Ok(tables)
}

/// One sentence for each table that is not the same on both sides.
fn complaints(kept: &BTreeMap<String, Vec<u8>>, written: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let mut complaints = Vec::new();
    for (name, bytes) in kept {
        match written.get(name) {
            None => complaints.push(format!("{name}: the script does not write it")),
            Some(now) if now != bytes => complaints.push(format!("{name}: {}", first_difference(bytes, now))),
            Some(_) => {}
        }
    }
    let missing = written.keys().filter(|name| !kept.contains_key(*name));
    complaints.extend(missing.map(|name| format!("{name}: it is missing (cargo xtask data)")));
    complaints
}

fn first_difference(kept: &[u8], written: &[u8]) -> String {
    let lines = |bytes| String::from_utf8_lossy(bytes).lines().map(str::to_owned).collect::<Vec<_>>();
    let (kept, written) = (lines(kept), lines(written));
    let same = kept.iter().zip(&written).take_while(|(a, b)| a == b).count();
    let line = |lines: &[String]| lines.get(same).map_or("nothing".to_owned(), |line| format!("'{line}'"));
    format!("line {} is {}, the script writes {}", same + 1, line(&kept), line(&written))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(files: &[(&str, &str)]) -> BTreeMap<String, Vec<u8>> {
        files.iter().map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec())).collect()
    }

    #[test]
    fn every_kind_of_difference_is_told() {
        let kept = folder(&[("a", "1\n2\n"), ("b", "1"), ("c", "1")]);
        let written = folder(&[("a", "1\n3\n"), ("c", "1"), ("d", "1")]);
        assert_eq!(
            complaints(&kept, &written),
            [
                "a: line 2 is '2', the script writes '3'",
                "b: the script does not write it",
                "d: it is missing (cargo xtask data)"
            ]
        );
        assert!(complaints(&kept, &kept).is_empty());
    }

    #[test]
    fn the_script_and_its_tables_are_where_they_are_looked_for() {
        let workspace = Workspace::find();
        assert!(workspace.path(SCRIPT).is_file() && workspace.path(REQUIREMENTS).is_file());
        assert!(tables(&workspace.path(TABLES)).is_ok_and(|tables| tables.contains_key("observers.csv")));
    }
}
