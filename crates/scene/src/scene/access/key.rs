//! What a part of a scene is asked for by.

use core::fmt;

/// A part of a scene: by its name, or by its number in its list, counted from 0.
///
/// Functions take `impl Into<Key>`: a string or a number.
///
/// ```
/// use glanz_scene::Key;
///
/// assert_eq!(Key::from("red"), Key::Name("red"));
/// assert_eq!(Key::from(2), Key::Number(2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Key<'a> {
    /// By name, as it is written.
    Name(&'a str),
    /// By number, counted from 0.
    Number(usize),
}

impl<'a> From<&'a str> for Key<'a> {
    fn from(name: &'a str) -> Self {
        Self::Name(name)
    }
}

impl<'a> From<&'a String> for Key<'a> {
    fn from(name: &'a String) -> Self {
        Self::Name(name)
    }
}

impl From<usize> for Key<'_> {
    fn from(number: usize) -> Self {
        Self::Number(number)
    }
}

impl fmt::Display for Key<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => write!(f, "'{name}'"),
            Self::Number(number) => write!(f, "{number}"),
        }
    }
}
