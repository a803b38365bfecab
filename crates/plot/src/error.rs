//! Why a plot cannot be made or written.

use std::path::PathBuf;

use glanz_bsdf::ParamError;
use glanz_color::UnknownName;
use glanz_picture::output::OutputError;
use thiserror::Error;

/// Why a plot cannot be made or written.
#[derive(Debug, Error)]
pub enum Error {
    /// The file cannot be written, or the page not encoded.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The name of the file ends in nothing that a page can be written as.
    #[error("the name of a plot must end in .svg, .png, .pdf, .csv or .json")]
    UnknownExtension {
        /// The name.
        path: PathBuf,
    },
    /// A model or one of its parameters is not possible.
    #[error(transparent)]
    Model(#[from] ParamError),
    /// Ambient and emitted terms have no lobe.
    #[error("'{model}' has no lobe to plot: it answers to no light from a direction")]
    NoDirection {
        /// The model's name.
        model: &'static str,
    },
    /// A mirror has no lobe of finite height.
    #[error("'{model}' has no lobe to plot: it sends light into a single direction")]
    SingleDirection {
        /// The model's name.
        model: &'static str,
    },
    /// The model is not one of microfacets.
    #[error("'{model}' has no factors D and G: it is not made of facets")]
    NoFacets {
        /// The model's name.
        model: &'static str,
    },
    /// A slice over half and difference angle knows reflection only.
    #[error("a slice shows reflection, by half vectors; light passes through '{model}'")]
    Transmission {
        /// The model's name.
        model: &'static str,
    },
    /// A lobe that is 0 in all directions has no shape.
    #[error("the lobe {lobe} is 0 in all directions: there is no body to draw")]
    EmptyLobe {
        /// The lobe's label and the direction of the viewer.
        lobe: String,
    },
    /// The viewer is not above the surface.
    #[error("theta is {theta_deg}, but must be from 0 to below 90 degrees")]
    ViewAngle {
        /// The angle from the normal, in degrees.
        theta_deg: f64,
    },
    /// The azimuth is no number.
    #[error("phi is {phi_deg}, but must be finite")]
    Azimuth {
        /// The azimuth in degrees.
        phi_deg: f64,
    },
    /// So many lobes or laws cannot be told apart.
    #[error("a plot of {found} curves cannot be read; at most {most} are drawn")]
    TooManyLobes {
        /// How many there are.
        found: usize,
        /// How many are drawn.
        most: usize,
    },
    /// So many media cannot be told apart.
    #[error("a plot of {found} media cannot be read; at most {most} are drawn")]
    TooManyMedia {
        /// How many there are.
        found: usize,
        /// How many are drawn.
        most: usize,
    },
    /// The greatest distance of a plot of attenuation.
    #[error("the distance is {distance_m} m, but must be above 0 and at most {most_m} m")]
    Distance {
        /// The distance in metres.
        distance_m: f64,
        /// The greatest that is possible.
        most_m: f64,
    },
    /// The formulas of the eye are for adults.
    #[error("an age is {age} years, but must be from {least} to {most}")]
    Age {
        /// The age in years.
        age: f64,
        /// The least that is possible.
        least: f64,
        /// The greatest that is possible.
        most: f64,
    },
    /// A formula of the eye is not for such luminances.
    #[error("a luminance is {luminance} cd/m², but must be from {least} to {most}")]
    Luminance {
        /// The luminance in cd/m².
        luminance: f64,
        /// The least that is possible.
        least: f64,
        /// The greatest that is possible.
        most: f64,
    },
    /// No eye has such a pigment.
    #[error(
        "the pigment of the eye is {pigment}, but must be from 0 (very dark) to {most} (very light blue)"
    )]
    Pigment {
        /// The number as it was given.
        pigment: f64,
        /// The greatest that is possible.
        most: f64,
    },
    /// There is no medium of that name.
    #[error(transparent)]
    UnknownMedium(#[from] UnknownName),
    /// A number that no medium has.
    #[error("a refractive index is {index}, but must be between {least} and {most}")]
    RefractiveIndex {
        /// The number as it was given.
        index: String,
        /// The least that is possible.
        least: f64,
        /// The greatest that is possible.
        most: f64,
    },
    /// The pictures of a sheet do not fit on one.
    #[error(
        "a sheet of {columns}×{rows} pictures would have {width}×{height} pixels; at most {most}×{most} are possible"
    )]
    SheetSize {
        /// Pictures in a row.
        columns: usize,
        /// Rows of pictures.
        rows: usize,
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// The greatest side in pixels.
        most: usize,
    },
    /// There are too many combinations of values.
    #[error("a sheet of more than {most} pictures is too large")]
    TooManyPictures {
        /// How many are possible.
        most: usize,
    },
}
