//! Why pictures cannot be compared.

use glanz_math::OverBudget;
use thiserror::Error;

use super::Metric;

/// Why two pictures could not be compared.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum CompareError {
    /// The sizes differ.
    #[error(
        "expected two pictures of one size, found {}×{} and {}×{} pixels",
        reference.0, reference.1, test.0, test.1
    )]
    Sizes {
        /// Width and height of the reference.
        reference: (usize, usize),
        /// Width and height of the other.
        test: (usize, usize),
    },
    /// There are fewer or more values than the size says, or none.
    #[error("expected {expected} values per channel, at least one, found {found}")]
    Values {
        /// Width times height.
        expected: usize,
        /// Values of the first channel that has another number.
        found: usize,
    },
    /// The metric works on what a screen shows only.
    #[error("{} is defined for sRGB codes, but both pictures hold light without bounds", metric.name())]
    CodesOnly {
        /// The metric.
        metric: Metric,
    },
    /// A metric takes more memory than it may.
    #[error(transparent)]
    Memory(#[from] OverBudget),
    /// The number of pixels per degree is out of bounds.
    #[error("expected {} to {} pixels per degree, found {found}", range.0, range.1)]
    PixelsPerDegree {
        /// The bounds.
        range: (f64, f64),
        /// What was given.
        found: f64,
    },
}
