//! What is not in this build.

use thiserror::Error;

/// A file format was asked for whose feature the crate was built without.
///
/// ```
/// let off = glanz_color::FeatureOff { format: "OpenEXR", feature: "exr" };
/// assert!(off.to_string().ends_with("without the feature `exr`; add features = [\"exr\"]"));
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{format}: Glanz was built without the feature `{feature}`; add features = [\"{feature}\"]")]
pub struct FeatureOff {
    /// The format's name.
    pub format: &'static str,
    /// The feature that it needs.
    pub feature: &'static str,
}
