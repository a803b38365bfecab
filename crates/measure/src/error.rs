//! What is wrong with a file.

/// A file that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReadError {
    /// Nothing says what it is.
    #[error("this is no file of measured reflectance that is known: {0}")]
    Unknown(String),
    /// It ends too early or holds what it must not.
    #[error("{message}")]
    Broken {
        /// What is wrong.
        message: String,
        /// The line, counted from 1, of a text.
        line: Option<u32>,
    },
}

impl ReadError {
    pub(crate) fn broken(message: impl Into<String>) -> Self {
        Self::Broken { message: message.into(), line: None }
    }

    pub(crate) fn at(line: u32, message: impl Into<String>) -> Self {
        Self::Broken { message: message.into(), line: Some(line) }
    }

    /// The line of a text that is wrong, counted from 1.
    pub fn line(&self) -> Option<u32> {
        match self {
            Self::Broken { line, .. } => *line,
            Self::Unknown(_) => None,
        }
    }
}
