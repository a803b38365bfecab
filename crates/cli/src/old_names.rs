//! Options under the names that they had before: they still work, with a remark that tells the new name.

use std::ffi::OsString;

use crate::print;

/// A command, the old name of an option of it, and the new one. All are aliases of clap, too.
const RENAMED: [(&[&str], &str, &str); 8] = [
    (&["color", "spectrum"], "--under", "--light"),
    (&["color", "metamers"], "--under", "--light"),
    (&["color", "fluorescence"], "--under", "--light"),
    (&["color", "efficiency"], "--under", "--light"),
    (&["color", "plot", "efficiency"], "--under", "--light"),
    (&["color", "efficiency"], "--set", "--surfaces"),
    (&["color", "plot", "efficiency"], "--set", "--surfaces"),
    (&["sweep"], "--cell", "--size"),
];

/// Tells the new names of the old ones in a command line.
pub(crate) fn tell(command: &[&str], words: &[OsString]) {
    for (new, old) in found(command, words) {
        print::note(format_args!("note: {old} is called {new} now"));
    }
}

/// The new and the old name of each option with an old one.
fn found(command: &[&str], words: &[OsString]) -> Vec<(&'static str, &'static str)> {
    let options = words.split(|word| word == "--").next().unwrap_or_default();
    let is_there = |old: &str| {
        options.iter().filter_map(|word| word.to_str()).any(|word| word.split('=').next() == Some(old))
    };
    let renamed = RENAMED.iter().filter(|(path, old, _)| *path == command && is_there(old));
    renamed.map(|(_, old, new)| (*new, *old)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_old_names_of_this_command_are_told() {
        let words = |words: &[&str]| words.iter().map(OsString::from).collect::<Vec<_>>();
        let line = words(&["glanz", "sweep", "--cell=3x3", "--", "--under"]);
        assert_eq!(found(&["sweep"], &line), [("--size", "--cell")]);
        assert_eq!(found(&["sweep"], &words(&["glanz", "sweep", "--size", "3x3"])), []);
        assert_eq!(found(&["color", "metamers"], &words(&["--under", "A"])), [("--light", "--under")]);
    }
}
