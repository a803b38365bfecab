//! Every task of the workspace: `cargo xtask test`, `golden`, `renew`, `cases`, `gallery`, `bench`, `data`, `licenses`,
//! `advisories`.

#![expect(clippy::print_stdout, reason = "a command talks on its standard output")]

mod advisories;
mod bench;
mod cases;
mod data;
mod failure;
mod features;
mod fuzz;
mod gallery;
mod golden;
mod library_examples;
mod licenses;
mod packages;
mod picture;
mod reference;
mod renew;
mod steps;
mod test;
mod tour;
mod wasm;
mod workspace;

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use failure::{Failure, Result};
use lexopt::prelude::*;
use workspace::Workspace;

const HELP: &str = "\
The tasks of the Glanz workspace.

Usage: cargo xtask <TASK> [OPTIONS]

  test      Set up what is missing and run every check
              --quick        only format, lint, tests and gold pictures on the narrowest path
              --keep-going   do not stop at the first failure
              --only WORD    only the steps with that in their name
  golden    Compare pictures with tests/golden/, and all SIMD levels and thread counts with each other
              --renew        write the pictures anew; target/golden/diff.png shows what changed
  renew     Write anew what follows from the code: docs/MODELS.md, docs/COMMANDS.md, snapshots of the command's output
              --pictures     the gold pictures too, of models and of tests/golden/; look at them before you commit
  cases FOLDER
            Run the command on every input in FOLDER, beside the answers in each expectation.txt
  fuzz      Try the readers of files with bytes that nobody would write, by libFuzzer (needs a C++ compiler)
              --only WORD    the targets of fuzz/ with that in their name, all of them by --only ''
              --seconds N    how long each runs; 60 by default
              --seed N       where the random numbers begin; 1 by default
  gallery   Draw all examples at full size into target/gallery/, and those of the documents
              --readme       only the README's pictures
  bench     Measure drawing and print the table of docs/BENCHMARKS.md
              --peers        Mesa llvmpipe and the crate euc on the same scene, in the same run
              --only-peers   the peers alone
              --quick        fewer frames
              --write        put the tables into docs/BENCHMARKS.md
  data      Write the tables of crates/color/data from public packages (needs Python and a network)
              --check        write nothing there, only say whether they are what the script writes
  licenses  Write crates/cli/data/THIRD-PARTY.txt: the libraries of the command and their licences
              --check        write nothing, only say whether it is as it would be written, and every licence permissive
  advisories [FOLDER]
            Check the libraries of Cargo.lock against the advisories in xtask/advisories, or a folder with all of RustSec's
  help      Print this text

Example: cargo xtask test --keep-going";

/// A task with its options, as asked for on the command line.
#[derive(Debug, PartialEq)]
enum Task {
    Test(test::Options),
    Golden { renew: bool },
    Renew { pictures: bool },
    Cases { folder: PathBuf },
    Fuzz(fuzz::Options),
    Gallery { only_readme: bool },
    Bench(bench::Options),
    Data { check: bool },
    Licenses { check: bool },
    Advisories { folder: Option<PathBuf> },
    Help,
}

fn main() -> ExitCode {
    let task = match parse(std::env::args_os().skip(1)) {
        Ok(task) => task,
        Err(error) => {
            eprintln!("error: {error}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    match run(&task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(task: &Task) -> Result<()> {
    let workspace = Workspace::find();
    match task {
        Task::Test(options) => test::run_all(&workspace, options),
        Task::Golden { renew: true } => golden::renew(&workspace),
        Task::Golden { renew: false } => golden::run(&workspace),
        Task::Renew { pictures } => renew::run_all(&workspace, *pictures),
        Task::Fuzz(options) => fuzz::run_all(&workspace, options),
        Task::Cases { folder } => cases::run(&workspace, folder),
        Task::Gallery { only_readme } => gallery::run(&workspace, *only_readme),
        Task::Bench(options) => bench::run_all(&workspace, options),
        Task::Data { check: true } => data::check(&workspace),
        Task::Data { check: false } => data::renew(&workspace),
        Task::Licenses { check: true } => licenses::check(&workspace),
        Task::Licenses { check: false } => licenses::renew(&workspace),
        Task::Advisories { folder } => advisories::check(&workspace, folder.as_deref()),
        Task::Help => {
            println!("{HELP}");
            Ok(())
        }
    }
}

fn parse(args: impl IntoIterator<Item = OsString>) -> std::result::Result<Task, lexopt::Error> {
    let mut parser = lexopt::Parser::from_args(args);
    let mut name = None;
    let mut only = None;
    let mut folder = None;
    let mut flags = Vec::new();
    let mut fuzz = fuzz::Options::default();
    while let Some(arg) = parser.next()? {
        match arg {
            Short('h') | Long("help") => return Ok(Task::Help),
            Long("only") => only = Some(parser.value()?.string()?),
            Long("seconds") if name.as_deref() == Some("fuzz") => fuzz.seconds = parser.value()?.parse()?,
            Long("seed") if name.as_deref() == Some("fuzz") => fuzz.seed = parser.value()?.parse()?,
            Long(flag) => flags.push(flag.to_owned()),
            Value(value) if name.is_none() => name = Some(value.string()?),
            Value(value) if matches!(name.as_deref(), Some("cases" | "advisories")) && folder.is_none() => {
                folder = Some(PathBuf::from(value));
            }
            other => return Err(other.unexpected()),
        }
    }
    match name.as_deref() {
        Some("cases") if flags.is_empty() && only.is_none() => {
            let folder = folder.ok_or("this task needs a folder with cases")?;
            return Ok(Task::Cases { folder });
        }
        Some("fuzz") if flags.is_empty() => return Ok(Task::Fuzz(fuzz::Options { only, ..fuzz })),
        Some("advisories") if flags.is_empty() && only.is_none() => return Ok(Task::Advisories { folder }),
        _ => {}
    }
    let task = task(name.as_deref(), &mut only, &mut flags)?;
    if only.is_some() {
        return Err("this task has no option '--only'".into());
    }
    match flags.first() {
        Some(flag) => Err(format!("this task has no option '--{flag}'").into()),
        None => Ok(task),
    }
}

/// The task of that name; takes the options that it knows.
fn task(
    name: Option<&str>,
    only: &mut Option<String>,
    flags: &mut Vec<String>,
) -> std::result::Result<Task, lexopt::Error> {
    let mut take = |flag: &str| {
        let before = flags.len();
        flags.retain(|given| given != flag);
        flags.len() < before
    };
    Ok(match name {
        Some("test") => Task::Test(test::Options {
            quick: take("quick"),
            keep_going: take("keep-going"),
            only: only.take(),
        }),
        Some("golden") => Task::Golden { renew: take("renew") },
        Some("renew") => Task::Renew { pictures: take("pictures") },
        Some("gallery") => Task::Gallery { only_readme: take("readme") },
        Some("bench") => Task::Bench(bench::Options {
            quick: take("quick"),
            only_peers: take("only-peers"),
            peers: take("peers"),
            write: take("write"),
        }),
        Some("data") => Task::Data { check: take("check") },
        Some("licenses") => Task::Licenses { check: take("check") },
        None | Some("help") => Task::Help,
        Some(other) => return Err(format!("there is no task '{other}'").into()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(line: &str) -> std::result::Result<Task, String> {
        parse(line.split_whitespace().map(OsString::from)).map_err(|error| error.to_string())
    }

    #[test]
    fn options_belong_to_their_task() {
        assert_eq!(
            parsed("test --quick"),
            Ok(Task::Test(test::Options { quick: true, ..Default::default() }))
        );
        let only = Some("gold".to_owned());
        assert_eq!(parsed("test --only gold"), Ok(Task::Test(test::Options { only, ..Default::default() })));
        assert!(parsed("golden --only gold").is_err());
        assert_eq!(parsed("data --check"), Ok(Task::Data { check: true }));
        assert_eq!(parsed("advisories"), Ok(Task::Advisories { folder: None }));
        assert_eq!(parsed("advisories db"), Ok(Task::Advisories { folder: Some("db".into()) }));
        assert_eq!(parsed("golden --renew"), Ok(Task::Golden { renew: true }));
        assert_eq!(parsed("renew --pictures"), Ok(Task::Renew { pictures: true }));
        assert_eq!(parsed("test --renew"), Err("this task has no option '--renew'".to_owned()));
    }

    #[test]
    fn an_unknown_task_is_named_in_the_error() {
        assert_eq!(parsed("tset"), Err("there is no task 'tset'".to_owned()));
        assert!(parsed("test golden").is_err());
    }

    #[test]
    fn cases_have_a_folder() {
        assert_eq!(parsed("cases some/where"), Ok(Task::Cases { folder: "some/where".into() }));
        assert!(parsed("cases").is_err() && parsed("cases a b").is_err());
        assert!(parsed("golden some/where").is_err());
    }

    #[test]
    fn fuzzing_has_a_time_and_a_seed() {
        let only = Some("measure".to_owned());
        let options = fuzz::Options { only, seconds: 5, seed: 9 };
        assert_eq!(parsed("fuzz --only measure --seconds 5 --seed 9"), Ok(Task::Fuzz(options)));
        assert_eq!(parsed("fuzz"), Ok(Task::Fuzz(fuzz::Options::default())));
        assert!(parsed("fuzz --seconds soon").is_err() && parsed("test --seconds 5").is_err());
    }

    #[test]
    fn nothing_asks_for_help() {
        assert_eq!(parsed(""), Ok(Task::Help));
        assert_eq!(parsed("bench --help"), Ok(Task::Help));
    }
}
