//! What can be wrong with a shader, and where.

use core::fmt;

/// A place in the user's text, as an editor shows it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Name of the file.
    pub file: String,
    /// Line, from 1; `#line` counts.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// First byte in the file's text.
    pub start: usize,
    /// Byte after the last one.
    pub end: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// A shader that cannot be compiled.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ShaderError {
    /// The text breaks a rule of its language.
    #[error("{}{message}", at(place))]
    Invalid {
        /// What is wrong, and what was expected.
        message: String,
        /// Where; `None` if it concerns the whole text.
        place: Option<Place>,
        /// What may help.
        hints: Vec<String>,
    },
    /// The text is right, but asks for what is not there.
    #[error("{}{message}", at(place))]
    Unsupported {
        /// What is not there.
        message: String,
        /// Where; `None` if it concerns the whole text.
        place: Option<Place>,
    },
    /// The front end that parses the text broke down. The fault is not the user's.
    #[error("the compiler failed on this text; the fault is its own, but another way to write it may pass")]
    Broken,
}

impl ShaderError {
    /// Where it is.
    pub fn place(&self) -> Option<&Place> {
        match self {
            Self::Invalid { place, .. } | Self::Unsupported { place, .. } => place.as_ref(),
            Self::Broken => None,
        }
    }
}

fn at(place: &Option<Place>) -> String {
    place.as_ref().map_or_else(String::new, |place| format!("{place}: "))
}

/// A run that did not come to its end.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RunError {
    /// A loop takes more turns than there is fuel.
    #[error("{}a loop takes more than {turns} turns", at(place))]
    EndlessLoop {
        /// The loop.
        place: Option<Place>,
        /// How many turns there were.
        turns: u32,
    },
}
