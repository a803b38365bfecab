//! Things by name: what is said where there is no such thing.

pub(crate) use glanz_math::names::plain;
use glanz_math::names::{nearest, suggestion};
use thiserror::Error;

/// No spectrum, observer or material goes by that name.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum UnknownName {
    /// There is none.
    #[error("there is no {kind} '{name}'{}", suggestion(near))]
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
        let near = nearest(name, known).into_iter().map(str::to_owned).collect();
        Self::NotFound { kind, name: name.to_owned(), near }
    }
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
    }
}
