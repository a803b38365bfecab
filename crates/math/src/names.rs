//! Names as people type them: how they are compared, and which known name is meant by a misspelt one.
//!
//! ```
//! use glanz_math::names::{did_you_mean, nearest, plain};
//!
//! assert_eq!(plain("Blinn Phong"), plain("blinn-phong"));
//! assert_eq!(nearest("lambrt", ["lambert", "phong"]), ["lambert"]);
//! assert_eq!(did_you_mean("lambrt", ["lambert", "phong"]), "; did you mean 'lambert'?");
//! ```

use std::borrow::Cow;

/// The longest name that is looked at: a longer one is a misspelling of nothing, and the distance costs the
/// product of the lengths.
const LONGEST: usize = 60;

/// The most suggestions made.
const MOST: usize = 3;

/// How many letters of a known name of so many may be wrong: two of five, and one of a symbol such as `Au`.
fn most_wrong(letters: usize) -> usize {
    match letters {
        0 | 1 => 0,
        letters => (letters * 2 / 5).max(1),
    }
}

/// A name as it is compared: small letters, and a hyphen for a blank or a low line.
pub fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace([' ', '_'], "-")
}

/// A name as a message shows it: with a question mark for each control character, so that it stays in its line.
///
/// ```
/// assert_eq!(glanz_math::names::shown("left\n"), "left?");
/// ```
pub fn shown(name: &str) -> Cow<'_, str> {
    match name.contains(char::is_control) {
        true => Cow::Owned(name.chars().map(|c| if c.is_control() { '?' } else { c }).collect()),
        false => Cow::Borrowed(name),
    }
}

/// The known names that `name` is most likely a misspelling of: all that are equally near, at most three, in
/// their order. Two letters that changed places are one mistake.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    if name.len() > LONGEST {
        return Vec::new();
    }
    let name = plain(name);
    let mut near: Vec<(usize, &str)> = known
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(&name, &plain(candidate)), candidate))
        .filter(|(distance, candidate)| *distance <= most_wrong(candidate.chars().count()))
        .collect();
    let least = near.iter().map(|(distance, _)| *distance).min();
    near.retain(|(distance, _)| Some(*distance) == least);
    near.into_iter().take(MOST).map(|(_, name)| name).collect()
}

/// `; did you mean 'x' or 'y'?`, or nothing where there is no suggestion.
pub fn suggestion(near: &[impl AsRef<str>]) -> String {
    if near.is_empty() {
        return String::new();
    }
    let names: Vec<_> = near.iter().map(|name| shown(name.as_ref())).collect();
    format!("; did you mean '{}'?", names.join("' or '"))
}

/// The [`suggestion`] of the [`nearest`] known names, for the end of a message.
pub fn did_you_mean<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    suggestion(&nearest(name, known))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn misspellings_are_near_and_other_words_are_not() {
        let known = ["shininess", "specular", "diffuse"];
        assert_eq!(nearest("shinines", known), ["shininess"]);
        assert_eq!(nearest("Specular", known), ["specular"]);
        assert_eq!(nearest("difuse", known), ["diffuse"]);
        assert_eq!(nearest("colour", known), [""; 0]);
        assert_eq!(nearest("", known), [""; 0]);
        assert_eq!(nearest(&"diffuse".repeat(1000), known), [""; 0]);
    }

    #[test]
    fn two_letters_of_five_may_be_wrong() {
        assert_eq!(nearest("phung", ["phong"]), ["phong"]);
        assert_eq!(nearest("phuna", ["phong"]), ["phong"]);
        assert_eq!(nearest("phuwa", ["phong"]), [""; 0]);
        assert_eq!(nearest("gold", ["gilt", "glod", "lead"]), ["glod"]);
        assert_eq!(nearest("gulf", ["gold"]), [""; 0]);
        assert_eq!(nearest("red", ["bed", "blue"]), ["bed"]);
        assert_eq!(nearest("ed", ["bid"]), [""; 0]);
    }

    #[test]
    fn names_that_are_equally_near_are_all_suggested() {
        let known = ["neutral-8", "neutral-5", "blue"];
        assert_eq!(did_you_mean("Neutral 9", known), "; did you mean 'neutral-8' or 'neutral-5'?");
        assert_eq!(did_you_mean("velvet", known), "");
        assert_eq!(did_you_mean("Ay", ["Ag", "Cu", "Au", "C"]), "; did you mean 'Ag' or 'Au'?");
        assert_eq!(nearest("ab1", ["ab2", "ab3", "ab4", "ab5"]), ["ab2", "ab3", "ab4"]);
    }
}
