//! Things by name: how names are compared, and what is said where there is no such thing.

use thiserror::Error;

/// No spectrum, observer or material goes by that name.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum UnknownName {
    /// There is none.
    #[error("there is no {kind} '{name}'{}", did_you_mean(near))]
    NotFound {
        /// What was looked for, such as `light`.
        kind: &'static str,
        /// The name as given.
        name: String,
        /// Known names that are near, the nearest first; at most three.
        near: Vec<String>,
    },
    /// The name is one with numbers in it, and those are not possible.
    #[error("{kind} '{name}': expected {expected}")]
    Parameter {
        /// What was looked for.
        kind: &'static str,
        /// The name as given.
        name: String,
        /// Which numbers are possible.
        expected: String,
    },
}

impl UnknownName {
    /// For a name that is none of `known`.
    pub(crate) fn not_found<'a>(
        kind: &'static str,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        Self::NotFound { kind, name: name.to_owned(), near: nearest(name, known) }
    }
}

/// The longest name that is looked at: a longer one is a misspelling of nothing.
const LONGEST: usize = 60;

/// The most suggestions made.
const MOST: usize = 3;

fn did_you_mean(near: &[String]) -> String {
    match near {
        [] => String::new(),
        names => format!("; did you mean '{}'?", names.join("' or '")),
    }
}

/// A name as it is compared: small letters, and a hyphen for a blank or a low line.
pub(crate) fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace([' ', '_'], "-")
}

/// The known names that are about as near as the nearest.
fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    if name.len() > LONGEST {
        return Vec::new();
    }
    let name = plain(name);
    let mut near: Vec<(usize, &str)> = known
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(&name, &plain(candidate)), candidate))
        .filter(|(distance, candidate)| distance * 2 <= candidate.chars().count())
        .collect();
    near.sort_by_key(|(distance, _)| *distance);
    let least = near.first().map_or(0, |(distance, _)| *distance);
    near.iter().take_while(|(d, _)| *d == least).take(MOST).map(|(_, name)| (*name).to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_names_are_suggested() {
        let known = ["cie1931", "cie1964", "scotopic"];
        let error = UnknownName::not_found("observer", "CIE 1931", known);
        assert_eq!(error.to_string(), "there is no observer 'CIE 1931'; did you mean 'cie1931'?");
        let error = UnknownName::not_found("observer", "eye", known);
        assert_eq!(error.to_string(), "there is no observer 'eye'");
        assert_eq!(nearest("cie1960", known), ["cie1964"]);
        assert_eq!(nearest(&"cie1931".repeat(1000), known), Vec::<String>::new());
    }
}
