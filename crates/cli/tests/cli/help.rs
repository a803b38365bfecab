//! What `--help`, `--version`, `schema` and `completions` print.

use crate::folder::Folder;

/// The words that lead to every command.
pub(crate) const COMMANDS: [&[&str]; 65] = [
    &[],
    &["render"],
    &["sweep"],
    &["shade-compare"],
    &["lighting-error"],
    &["compare"],
    &["modes"],
    &["relight"],
    &["eye"],
    &["info"],
    &["probe"],
    &["devices"],
    &["bsdf"],
    &["bsdf", "list"],
    &["bsdf", "show"],
    &["bsdf", "eval"],
    &["bsdf", "albedo"],
    &["sheet"],
    &["plot"],
    &["plot", "eye"],
    &["check"],
    &["material"],
    &["material", "list"],
    &["material", "show"],
    &["material", "sheet"],
    &["color"],
    &["color", "convert"],
    &["color", "spectrum"],
    &["color", "xy"],
    &["color", "wave"],
    &["color", "metamers"],
    &["color", "fluorescence"],
    &["color", "list"],
    &["color", "efficiency"],
    &["color", "plot"],
    &["color", "plot", "spectra"],
    &["color", "plot", "chromaticity"],
    &["color", "plot", "cones"],
    &["color", "plot", "meyer"],
    &["color", "plot", "matrix"],
    &["color", "plot", "tm30"],
    &["color", "plot", "efficiency"],
    &["measure"],
    &["measure", "info"],
    &["measure", "convert"],
    &["measure", "fit"],
    &["measure", "appearance"],
    &["measure", "compare"],
    &["measure", "sample"],
    &["measure", "smooth"],
    &["lesson"],
    &["lesson", "ward"],
    &["shader"],
    &["shader", "check"],
    &["shader", "list"],
    &["shader", "print"],
    &["shader", "xray"],
    &["shader", "picture"],
    &["shader", "export"],
    &["shader", "run"],
    &["shader", "certify"],
    &["example"],
    &["schema"],
    &["licenses"],
    &["completions"],
];

/// The help of the command that `words` lead to.
pub(crate) fn help(words: &[&str]) -> String {
    let folder = Folder::new();
    let run = folder.glanz(&[words, &["--help"]].concat());
    assert!(run.stderr.is_empty());
    run.text().to_owned()
}

#[test]
fn every_command_has_help_with_an_example() {
    for words in COMMANDS {
        let help = help(words);
        assert!(help.contains("Example"), "glanz {}: no example", words.join(" "));
        let example = help.split("Example").nth(1).unwrap();
        assert!(example.contains("glanz "), "glanz {}: the example shows no command", words.join(" "));
        insta::assert_snapshot!(format!("help_{}", words.join("_")).trim_end_matches('_'), help);
    }
}

/// The help of all commands on one page.
fn reference() -> String {
    let mut page = "# Commands\n\nThe help texts of `glanz`, as it prints them. A test keeps this page current; `GLANZ_RENEW_DOCS=1 \
                    cargo test -p glanz-cli` writes it anew.\n"
        .to_owned();
    for words in COMMANDS {
        let title = [&["glanz"], words].concat().join(" ");
        page += &format!("\n## {title}\n\n```text\n{}\n```\n", help(words).trim_end());
    }
    page.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
}

#[test]
fn the_page_of_commands_in_the_docs_is_current() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/COMMANDS.md");
    if std::env::var_os("GLANZ_RENEW_DOCS").is_some() {
        std::fs::write(path, reference()).unwrap();
    }
    assert!(
        std::fs::read_to_string(path).unwrap_or_default() == reference(),
        "docs/COMMANDS.md is out of date"
    );
}

#[test]
fn the_list_of_commands_above_is_complete() {
    let listed = |help: &str| -> Vec<String> {
        let commands = help.split("Commands:").nth(1).unwrap_or("").split("\n\n").next().unwrap_or("");
        let names = commands.lines().filter_map(|line| line.split_whitespace().next());
        names.filter(|name| *name != "help").map(str::to_owned).collect()
    };
    for words in COMMANDS {
        for name in listed(&help(words)) {
            let longer = [words, &[name.as_str()]].concat();
            assert!(COMMANDS.contains(&longer.as_slice()), "{}", longer.join(" "));
        }
    }
}

#[test]
fn paragraphs_are_wrapped_where_the_terminal_ends() {
    let folder = Folder::new();
    for width in [80, 100] {
        for words in COMMANDS {
            let run = folder.glanz_with(&[words, &["--help"]].concat(), &[("COLUMNS", &width.to_string())]);
            let text = run.text().split("\nExample").nth(1).unwrap_or_default().to_owned();
            for pair in text.lines().collect::<Vec<_>>().windows(2) {
                let is_paragraph = pair.iter().all(|line| !line.is_empty() && !line.starts_with(' '));
                let next = pair[1].split(' ').next().unwrap().chars().count();
                let needed = pair[0].chars().count() + 1 + next;
                assert!(!is_paragraph || needed > width, "{words:?} at {width}: {pair:?}");
            }
        }
    }
}

#[test]
fn help_has_help_too() {
    let folder = Folder::new();
    for words in [&["help", "--help"][..], &["bsdf", "help", "-h"], &["color", "plot", "help", "--help"]] {
        assert!(folder.glanz(words).text().contains("help of the given subcommand"), "{words:?}");
    }
}

#[test]
fn the_version_is_that_of_the_package() {
    let run = Folder::new().glanz(&["--version"]);
    assert_eq!(run.text(), format!("glanz {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn the_schema_names_the_tables_of_a_scene() {
    let schema = Folder::new().glanz(&["schema"]).json();
    for table in ["image", "camera", "render", "ambient", "lights", "materials", "objects"] {
        assert!(schema["properties"][table].is_object(), "{table}");
    }
}

#[test]
fn every_shell_gets_completions_that_know_the_models() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = folder.glanz(&["completions", shell]);
        assert!(run.text().contains("shade-compare"), "{shell}");
        // These two complete the names of commands and options, not the values.
        if !["powershell", "elvish"].contains(&shell) {
            assert!(run.text().contains("blinn-phong-normalized"), "{shell}");
        }
    }
}
