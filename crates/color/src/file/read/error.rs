//! What can go wrong when a file is read.

use core::fmt;

use thiserror::Error;

/// Where in a file something was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of text, counted from 1.
    Line(usize),
    /// A field of a line, both counted from 1.
    Field {
        /// The line.
        line: usize,
        /// The field.
        field: usize,
    },
    /// A character of a line, both counted from 1.
    Column {
        /// The line.
        line: u32,
        /// The character.
        column: u32,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => f.write_str("the file"),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Field { line, field } => write!(f, "line {line}, field {field}"),
            Self::Column { line, column } => write!(f, "line {line}, column {column}"),
        }
    }
}

/// Why a file could not be read. Every variant names the file, the place and what was expected.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ReadError {
    /// The content breaks the rules of its format.
    #[error("{file}: {place}: expected {expected}, found {found}")]
    Malformed {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// What should have been there.
        expected: String,
        /// What is there.
        found: String,
    },
    /// More than a reader takes, so that no file fills the memory.
    #[error("{file}: {place}: expected at most {limit} {unit}, found {found}")]
    TooLarge {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// The most that is allowed.
        limit: u64,
        /// What is counted.
        unit: &'static str,
        /// How much there is.
        found: u64,
    },
}

impl ReadError {
    /// The content breaks the rules of its format.
    pub(crate) fn malformed(
        file: &str,
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self::Malformed { file: file.to_owned(), place, expected: expected.into(), found: found.into() }
    }

    /// The file that the error is in.
    pub fn file(&self) -> &str {
        match self {
            Self::Malformed { file, .. } | Self::TooLarge { file, .. } => file,
        }
    }

    /// The place in the file that the error is at.
    pub fn place(&self) -> &Place {
        match self {
            Self::Malformed { place, .. } | Self::TooLarge { place, .. } => place,
        }
    }
}

/// At most this many characters of a file's text are repeated in a message or kept as a name.
const EXCERPT: usize = 40;

/// A piece of a file's text for a message: quoted, short, without control characters.
pub(crate) fn excerpt(text: &str) -> String {
    let mut short = clean(text, EXCERPT);
    if text.chars().nth(EXCERPT).is_some() {
        short.push('…');
    }
    format!("'{short}'")
}

/// The first characters of a text, control characters replaced.
pub(crate) fn clean(text: &str, most: usize) -> String {
    text.chars().take(most).map(|c| if c.is_control() { '?' } else { c }).collect()
}
