//! Names that are known, for messages.

pub(crate) use glanz_math::names::{did_you_mean, nearest, shown};

/// The names as a list for people, cut where it gets long.
pub(crate) fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.into_iter().collect();
    let first = names.iter().take(24).map(|name| shown(name)).collect::<Vec<_>>().join(", ");
    match names.len() {
        0 => "none".to_owned(),
        1..=24 => first,
        more => format!("{first} and {} more", more - 24),
    }
}
