//! What can go wrong when a file is read: one error for all readers of text and binary files, also of scenes.

use core::fmt;
use std::io;

use glanz_math::OverBudget;
use thiserror::Error;

use crate::FeatureOff;

/// Where in a file something was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of text, counted from 1.
    Line(u64),
    /// A field of a line, both counted from 1.
    Field {
        /// The line.
        line: u64,
        /// The field.
        field: u64,
    },
    /// A character of a line, both counted from 1.
    Column {
        /// The line.
        line: u64,
        /// The character.
        column: u64,
    },
    /// A byte, counted from 0.
    Byte(u64),
    /// A value inside a structured file, as `accessors[3].bufferView`.
    Path(String),
    /// One of many items, as facet 12, counted from 0.
    Item(&'static str, u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => f.write_str("the file"),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Field { line, field } => write!(f, "line {line}, field {field}"),
            Self::Column { line, column } => write!(f, "line {line}, column {column}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::Path(path) => f.write_str(path),
            Self::Item(kind, index) => write!(f, "{kind} {index}"),
        }
    }
}

/// Why a file could not be read. Every variant names the file, the place and what was expected.
#[derive(Debug, Error)]
pub enum ReadError {
    /// The operating system refused.
    #[error("{file}: {place}: expected a readable file, found: {source}")]
    Io {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// What the operating system said.
        source: io::Error,
    },
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
    /// The content is valid but needs something that this reader does not have.
    #[error("{file}: {place}: expected {expected}, found {found}, which is not supported")]
    Unsupported {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// What could have been read.
        expected: String,
        /// What is there.
        found: String,
    },
    /// The format needs a feature that this build does not have.
    #[error("{file}: {place}: {off}")]
    FeatureOff {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// The feature.
        off: FeatureOff,
    },
    /// More than the reader's limits allow, so that no file fills the memory.
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
    /// More memory than the budget has.
    #[error("{file}: {place}: {over}")]
    Memory {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// What wants how much.
        over: OverBudget,
    },
    /// A reference leaves the folder that references must stay in.
    #[error(
        "{file}: {place}: expected a path inside {root}, found '{reference}', which leaves it (--allow-outside permits that)"
    )]
    Outside {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// The path as the file gives it.
        reference: String,
        /// The folder that it leaves.
        root: String,
    },
    /// A referenced file is not there.
    #[error("{file}: {place}: expected a file '{reference}', found none")]
    Missing {
        /// The file being read.
        file: String,
        /// Where in it.
        place: Place,
        /// The path as the file gives it.
        reference: String,
    },
}

impl ReadError {
    /// The content breaks the rules of its format.
    pub fn malformed(
        file: &str,
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self::Malformed { file: file.to_owned(), place, expected: expected.into(), found: found.into() }
    }

    /// The content needs something that this reader does not have.
    pub fn unsupported(
        file: &str,
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self::Unsupported { file: file.to_owned(), place, expected: expected.into(), found: found.into() }
    }

    /// The file needs more memory than the budget has.
    pub fn memory(file: &str, place: Place, over: OverBudget) -> Self {
        Self::Memory { file: file.to_owned(), place, over }
    }

    /// The format of the file needs a feature that this build does not have.
    pub fn feature_off(file: &str, off: FeatureOff) -> Self {
        Self::FeatureOff { file: file.to_owned(), place: Place::File, off }
    }

    /// The file that the error is in.
    pub fn file(&self) -> &str {
        match self {
            Self::Io { file, .. }
            | Self::Malformed { file, .. }
            | Self::Unsupported { file, .. }
            | Self::FeatureOff { file, .. }
            | Self::TooLarge { file, .. }
            | Self::Memory { file, .. }
            | Self::Outside { file, .. }
            | Self::Missing { file, .. } => file,
        }
    }

    /// The place in the file that the error is at.
    pub fn place(&self) -> &Place {
        match self {
            Self::Io { place, .. }
            | Self::Malformed { place, .. }
            | Self::Unsupported { place, .. }
            | Self::FeatureOff { place, .. }
            | Self::TooLarge { place, .. }
            | Self::Memory { place, .. }
            | Self::Outside { place, .. }
            | Self::Missing { place, .. } => place,
        }
    }
}

/// At most this many characters of a file's text are repeated in a message or kept as a name.
const EXCERPT: usize = 40;

/// A piece of a file for a message: quoted, at most 40 characters, without control characters.
pub fn excerpt(bytes: impl AsRef<[u8]>) -> String {
    let bytes = bytes.as_ref();
    // A character takes at most four bytes; one more shows that something is left out.
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4 * (EXCERPT + 1))]);
    let mut short = clean(&text, EXCERPT);
    if text.chars().nth(EXCERPT).is_some() {
        short.push('…');
    }
    format!("'{short}'")
}

/// The first characters of a text, control characters replaced.
pub(crate) fn clean(text: &str, most: usize) -> String {
    text.chars().take(most).map(|c| if c.is_control() { '?' } else { c }).collect()
}
