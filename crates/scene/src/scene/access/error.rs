//! Why a part of a scene is not found.

use thiserror::Error;

use crate::file::near::{did_you_mean, list};

/// Why a part of a scene is not found.
///
/// ```
/// use glanz_scene::{Scene, library};
///
/// let mut scene = Scene::new();
/// scene.materials = vec![library::material("gold")?, library::material("copper")?];
/// assert_eq!(
///     scene.material("gould").unwrap_err().to_string(),
///     "there is no material 'gould'; did you mean 'gold'? There are: gold, copper"
/// );
/// assert_eq!(
///     scene.material(2).unwrap_err().to_string(),
///     "there is no material 2: there are 2, counted from 0"
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum LookupError {
    /// Nothing has this name.
    #[error("there is no {kind} '{asked}'{}", known_names(asked, known))]
    Name {
        /// What was looked for: `material`, `light`, `object`, `mesh` or `lobe`.
        kind: &'static str,
        /// The name that was asked for.
        asked: String,
        /// The names that there are, in order; those that are empty are left out.
        known: Vec<String>,
    },
    /// Nothing has this number.
    #[error("there is no {kind} {asked}: there are {count}, counted from 0")]
    Number {
        /// What was looked for.
        kind: &'static str,
        /// The number that was asked for.
        asked: usize,
        /// How many there are.
        count: usize,
    },
    /// Several have this name.
    #[error("several have the name of {kind} '{asked}': ask by number for one of {}", numbers(found))]
    Several {
        /// What was looked for.
        kind: &'static str,
        /// The name that was asked for.
        asked: String,
        /// The numbers of those that have it.
        found: Vec<usize>,
    },
}

/// The nearest names, and all that there are.
pub(crate) fn known_names(asked: &str, known: &[String]) -> String {
    let names = || known.iter().map(String::as_str);
    match did_you_mean(asked, names()) {
        near if near.is_empty() => format!("; there are: {}", list(names())),
        near => format!("{near} There are: {}", list(names())),
    }
}

fn numbers(found: &[usize]) -> String {
    found.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}
