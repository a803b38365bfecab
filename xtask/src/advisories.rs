//! Known faults of the libraries that the workspace builds with.

use std::path::Path;

use rustsec::advisory::{Id, Informational};
use rustsec::report::Settings;
use rustsec::{Database, Lockfile, Report};

use crate::workspace::Workspace;
use crate::{Failure, Result};

/// The advisories of the RustSec database about libraries of Cargo.lock, as of the date in its README.
const COPY: &str = "xtask/advisories";

/// What is known of libraries and stays, with the reason.
const KNOWN: &[(&str, &str)] = &[
    (
        "RUSTSEC-2024-0436",
        "paste is no longer maintained; exr needs it by pulp, to write code when it is compiled",
    ),
    ("RUSTSEC-2025-0165", "i_tree is unsound in ways that geo does not use; tests alone have it"),
];

/// Checks Cargo.lock against the copy, or against a folder with the whole database, which may be newer.
pub(crate) fn check(workspace: &Workspace, folder: Option<&Path>) -> Result<()> {
    let copy = workspace.path(COPY);
    let folder = folder.unwrap_or(&copy);
    let database = Database::open(folder).map_err(Failure::during(folder.display()))?;
    let lock = workspace.path("Cargo.lock");
    let lockfile = Lockfile::load(&lock).map_err(Failure::during(lock.display()))?;
    let settings = Settings {
        ignore: KNOWN.iter().filter_map(|(id, _)| id.parse::<Id>().ok()).collect(),
        informational_warnings: vec![
            Informational::Unmaintained,
            Informational::Unsound,
            Informational::Notice,
        ],
        ..Settings::default()
    };
    let report = Report::generate(&database, &lockfile, &settings);
    let faults = report.vulnerabilities.list.iter().map(|found| {
        let (package, advisory) = (&found.package, &found.advisory);
        format!("{} {}: {} ({})", package.name, package.version, advisory.title, advisory.id)
    });
    let warnings = report.warnings.values().flatten().map(|warning| {
        let (package, advisory) = (&warning.package, warning.advisory.as_ref());
        let title = advisory.map_or("", |advisory| &advisory.title);
        let id = advisory.map_or(String::new(), |advisory| advisory.id.to_string());
        format!("{} {}: {title} ({id})", package.name, package.version)
    });
    let found: Vec<String> = faults.chain(warnings).collect();
    println!("{} advisories about libraries of Cargo.lock were looked at", database.iter().count());
    match found.is_empty() {
        true => Ok(()),
        false => Err(Failure::new(format!("known faults of libraries:\n  {}", found.join("\n  ")))),
    }
}
