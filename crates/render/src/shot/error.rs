//! Why there is no picture.

use glanz_math::OverBudget;
use glanz_picture::ChannelError;
use glanz_picture::output::OutputError;
use glanz_scene::ColorMode;
use thiserror::Error;

use crate::prepare::{ObservationError, PrepareError};
use crate::view::{SamplesError, ViewError};

/// Why no picture can be made of a scene.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ShotError {
    /// The scene cannot be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The picture takes more memory than it may.
    #[error(transparent)]
    Memory(#[from] OverBudget),
    /// The observer, the colour mode and the white do not fit together.
    #[error(transparent)]
    Observation(#[from] ObservationError),
    /// The camera or the size of the picture is unusable.
    #[error(transparent)]
    View(#[from] ViewError),
    /// There is no pattern of so many samples.
    #[error(transparent)]
    Samples(#[from] SamplesError),
    /// A frame is not what its development is for.
    #[error(transparent)]
    Channels(#[from] ChannelError),
    /// The back end drew nothing: a program of the scene does not come to its end, or the device does not draw it.
    #[error(transparent)]
    Backend(#[from] crate::BackendError),
    /// A pixel is to be taken apart into lights and lobes that a program draws.
    #[error(
        "a program draws the pixel {x},{y}, not a material: `glanz shader xray … --pixel {x},{y}` takes it apart"
    )]
    ByProgram {
        /// The column.
        x: u32,
        /// The row.
        y: u32,
    },
    /// The names of the observer's channels cannot be those of a file of light.
    #[error("an OpenEXR file cannot hold the observer '{observer}': {what}")]
    ChannelNames {
        /// The observer.
        observer: String,
        /// What is wrong with its names.
        what: String,
    },
    /// Something of a program was asked for where none draws.
    #[error("no program draws here: name one by --fs or --vs, or by 'program' in the scene")]
    NoProgram,
    /// A buffer does not have 4 bytes for each pixel.
    #[error(
        "a picture of {width}×{height} pixels takes a buffer of {expected} bytes, 4 for each pixel, but it has {found}"
    )]
    Length {
        /// Width of the picture in pixels.
        width: u32,
        /// Height of the picture in pixels.
        height: u32,
        /// The length that is right.
        expected: usize,
        /// The buffer's.
        found: usize,
    },
    /// A pixel was asked for that the picture does not have.
    #[error("the picture has {width}×{height} pixels, counted from 0 at the top left, but not ({x}, {y})")]
    Pixel {
        /// The column.
        x: u32,
        /// The row.
        y: u32,
        /// Width of the picture in pixels.
        width: u32,
        /// Height of the picture in pixels.
        height: u32,
    },
    /// The picture does not come from the tint table, whose entries could be told.
    #[error("only pictures of light in a mode other than 'reference' can be taken apart; choose 'spectral'")]
    NoTable,
    /// A picture of spectra that an eye is to look at holds reflectances alone.
    #[error("the picture has spectra of reflectance, but none of light; light it first")]
    NoLight,
    /// Spectra were asked for where there are none.
    #[error(
        "a spectrum for each pixel needs spectra of light, but the colour mode is '{mode}'; choose 'spectral'"
    )]
    NoSpectra {
        /// The mode.
        mode: ColorMode,
    },
}

/// Why a picture is not in its file.
#[derive(Debug, Error)]
pub enum SaveError {
    /// It cannot be drawn.
    #[error(transparent)]
    Shot(#[from] ShotError),
    /// It cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}
