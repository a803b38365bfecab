//! The licences of the libraries that the command contains, as one file that it can print.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

use crate::workspace::{Workspace, run_quietly};
use crate::{Failure, Result};

/// The file, which the command `glanz licenses` prints.
const FILE: &str = "crates/cli/data/THIRD-PARTY.txt";

/// Licences that a library of the command may have; of several one is enough.
const ALLOWED: &[&str] = &[
    "MIT",
    "MIT-0",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "ISC",
    "Zlib",
    "0BSD",
    "Unlicense",
    "CC0-1.0",
    "Unicode-3.0",
];

/// Beginnings of names of files with licences, in capitals.
const NAMES: &[&str] = &["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE", "COPYRIGHT"];

/// A library of the command.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Library {
    name: String,
    version: String,
    license: String,
    /// Name and text of its files with licences.
    texts: Vec<(String, String)>,
}

/// Writes the file anew.
pub(crate) fn renew(workspace: &Workspace) -> Result<()> {
    let path = workspace.path(FILE);
    std::fs::write(&path, text(&libraries(workspace)?)).map_err(Failure::during(path.display()))?;
    println!("{FILE}");
    Ok(())
}

/// Checks that every library has a licence which lets it be shipped, and that the file is as it would be written.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let libraries = libraries(workspace)?;
    let refused: Vec<String> = libraries
        .iter()
        .filter(|library| !is_allowed(&library.license))
        .map(|Library { name, version, license, .. }| format!("{name} {version}: '{license}'"))
        .collect();
    if !refused.is_empty() {
        return Err(Failure::new(format!("libraries with other licences:\n  {}", refused.join("\n  "))));
    }
    let path = workspace.path(FILE);
    let kept = std::fs::read_to_string(&path).map_err(Failure::during(path.display()))?;
    match kept == text(&libraries) {
        true => {
            println!("{} libraries, each with a permissive licence", libraries.len());
            Ok(())
        }
        false => Err(Failure::new(format!("{FILE} is out of date: cargo xtask licenses"))),
    }
}

/// Whether one of the licences of an SPDX expression is allowed; all of those joined by AND.
fn is_allowed(license: &str) -> bool {
    let plain = license.replace(['(', ')'], "").replace('/', " OR ");
    plain.split(" AND ").all(|part| part.split(" OR ").any(|one| ALLOWED.contains(&one.trim())))
}

/// The libraries of the command, for all systems, without our own.
fn libraries(workspace: &Workspace) -> Result<Vec<Library>> {
    let tree = "tree -p glanz-cli -e normal --target all --prefix none --format {p}";
    let tree = run_quietly(&mut workspace.cargo(tree))?;
    let tree = String::from_utf8_lossy(&tree).into_owned();
    let shipped: BTreeSet<(&str, &str)> = tree.lines().filter_map(name_and_version).collect();
    let metadata = run_quietly(&mut workspace.cargo("metadata --format-version 1"))?;
    let metadata: Value = serde_json::from_slice(&metadata).map_err(Failure::during("cargo metadata"))?;
    let mut libraries = Vec::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let text = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
        let (name, version) = (text("name"), text("version"));
        if package["source"].is_null() || !shipped.contains(&(name.as_str(), version.as_str())) {
            continue;
        }
        let manifest = text("manifest_path");
        let folder = Path::new(&manifest).parent().unwrap_or(Path::new(""));
        libraries.push(Library { license: text("license"), texts: texts(folder)?, name, version });
    }
    libraries.sort();
    Ok(libraries)
}

/// Name and version of a line such as `serde v1.0.2 (proc-macro)`.
fn name_and_version(line: &str) -> Option<(&str, &str)> {
    let mut words = line.split_whitespace();
    Some((words.next()?, words.next()?.strip_prefix('v')?))
}

/// The files of a package with licences.
fn texts(folder: &Path) -> Result<Vec<(String, String)>> {
    let mut texts = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(Failure::during(folder.display()))? {
        let path = entry.map_err(Failure::during(folder.display()))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let capitals = name.to_uppercase();
        if path.is_file() && NAMES.iter().any(|begin| capitals.starts_with(begin)) {
            let bytes = std::fs::read(&path).map_err(Failure::during(path.display()))?;
            texts.push((name, tidy(&String::from_utf8_lossy(&bytes))));
        }
    }
    texts.sort();
    Ok(texts)
}

/// A text without blanks at ends of lines and empty lines around it, so that equal ones are the same.
fn tidy(text: &str) -> String {
    let lines: Vec<&str> = text.trim_start_matches('\u{feff}').lines().map(str::trim_end).collect();
    lines.join("\n").trim_matches('\n').to_owned()
}

/// The file: a list of the libraries, then each text once with those that it is of.
fn text(libraries: &[Library]) -> String {
    let mut file = String::from(
        "The command glanz contains these libraries, each under the licence that stands beside it.\nTheir texts follow, each once.\n\n",
    );
    let mut texts: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for Library { name, version, license, texts: own } in libraries {
        let remark = if own.is_empty() { "; its package holds no text" } else { "" };
        writeln!(file, "{name} {version}: {license}{remark}").expect("a string takes everything");
        for (file_name, text) in own {
            texts.entry(text).or_default().push(format!("{name} {version} ({file_name})"));
        }
    }
    // Texts in the order of the libraries that they are of first.
    let mut texts: Vec<(Vec<String>, &str)> = texts.into_iter().map(|(text, of)| (of, text)).collect();
    texts.sort();
    for (of, text) in texts {
        let line = "-".repeat(80);
        write!(file, "\n{line}\n{}\n\n{text}\n", of.join(", ")).expect("a string takes everything");
    }
    file
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_allowed_licence_of_several_is_enough_and_all_that_are_joined_are_asked() {
        for good in ["MIT", "MIT OR GPL-3.0", "(MIT OR Apache-2.0) AND Unicode-3.0", "Apache-2.0/MIT"] {
            assert!(is_allowed(good), "{good}");
        }
        for bad in ["GPL-3.0", "MIT AND GPL-3.0", "", "LGPL-2.1 OR MPL-2.0"] {
            assert!(!is_allowed(bad), "{bad}");
        }
    }

    #[test]
    fn a_text_that_two_libraries_have_stands_once() {
        let library = |name: &str, text: &str| Library {
            name: name.to_owned(),
            version: "1.0.0".to_owned(),
            license: "MIT".to_owned(),
            texts: vec![("LICENSE".to_owned(), tidy(text))],
        };
        let file =
            text(&[library("a", "\nPermission \r\nis granted\n"), library("b", "Permission\nis granted")]);
        assert_eq!(file.matches("Permission\nis granted").count(), 1);
        assert!(file.contains("a 1.0.0 (LICENSE), b 1.0.0 (LICENSE)"), "{file}");
        assert_eq!(name_and_version("serde v1.0.2 (proc-macro)"), Some(("serde", "1.0.2")));
    }
}
