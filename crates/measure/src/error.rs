//! What is wrong with a file.

/// A file that cannot be read.
///
/// ```
/// use glanz_measure::Measured;
///
/// let text = "theta_i_deg,theta_o_deg,Y\n45,0,0.2\n45,ten,0.2\n";
/// let error = Measured::read(text.as_bytes(), "tile.csv", &Default::default()).expect_err("'ten' is no number");
/// assert_eq!(error.line(), Some(3));
/// ```
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

/// A table that a format cannot hold.
///
/// ```
/// use glanz_measure::{Channels, Coordinates, Table, WriteError, write_zemax, zemax_nodes_deg};
///
/// let nodes = zemax_nodes_deg(1);
/// let table = Table::of_function(Coordinates::Specular, nodes, Channels::Rgb, &mut |_, _| vec![0.3; 3])?;
/// let error = write_zemax(&table, "").expect_err("RGB is not for Zemax");
/// assert_eq!(error.to_string(), "Zemax files have one or XYZ channels, and these data have RGB");
/// # Ok::<(), glanz_measure::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WriteError {
    /// Its channels are others.
    #[error("{format} files have {expected} channels, and these data have {found}")]
    Channels {
        /// The format.
        format: &'static str,
        /// What it holds.
        expected: &'static str,
        /// What there is.
        found: String,
    },
    /// Its angles are others.
    #[error("{format} files are tables over {expected}")]
    Coordinates {
        /// The format.
        format: &'static str,
        /// What it is over.
        expected: &'static str,
    },
}
