//! What every back end needs per frame, in single precision and relative to the camera.

pub mod camera;
pub mod lights;
pub mod materials;
pub mod objects;
mod options;
pub mod program;
pub mod samples;

use glam::{DMat4, DVec3, DVec4};
use glanz_scene::{Camera, Projection};
use thiserror::Error;

pub use options::{Aovs, DebugView, DrawOptions, ExactLighting, Half, Moment};
pub use samples::{Samples, SamplesError};

/// The widest and highest picture, in pixels.
pub const MAX_SIZE: u32 = 16_384;

/// Why a camera and a size make no picture.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ViewError {
    /// The picture has no pixels, or more than can be drawn.
    #[error("a picture of {width}×{height} pixels cannot be drawn; both must be between 1 and {MAX_SIZE}")]
    Size {
        /// Asked width.
        width: u32,
        /// Asked height.
        height: u32,
    },
    /// A number of the camera is unusable.
    #[error("the camera's {what}")]
    Camera {
        /// Which number, and what it must be.
        what: &'static str,
    },
}

/// A camera and a picture size.
///
/// The rasteriser works in *eye space with world axes*: the eye is the origin, the axes are the
/// world's. So no precision is lost far from the world's origin.
///
/// ```
/// use glanz_render::View;
/// use glanz_scene::Camera;
///
/// let view = View::new(&Camera::new([0.0, 0.0, 5.0], [0.0; 3]), 320, 240)?;
/// assert_eq!(view.eye, [0.0, 0.0, 5.0]);
/// assert!(View::new(&Camera::new([0.0; 3], [0.0; 3]), 320, 240).is_err(), "it looks nowhere");
/// # Ok::<(), glanz_render::ViewError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The eye, in the world.
    pub eye: [f64; 3],
    /// Right, up and backwards, in the world.
    pub axes: [[f64; 3]; 3],
    /// Perspective or parallel.
    pub projection: Projection,
}

impl View {
    /// Checks the camera and the size.
    pub fn new(camera: &Camera, width: u32, height: u32) -> Result<Self, ViewError> {
        if !(1..=MAX_SIZE).contains(&width) || !(1..=MAX_SIZE).contains(&height) {
            return Err(ViewError::Size { width, height });
        }
        let error = |what| Err(ViewError::Camera { what });
        if !camera.eye.is_finite() || !camera.target.is_finite() || !camera.up.is_finite() {
            return error("eye, target and up must be finite numbers");
        }
        if camera.eye == camera.target {
            return error("eye and target are the same point; they must differ");
        }
        let least = Projection::FOV_MARGIN;
        match camera.projection {
            Projection::Perspective { fov_y }
                if !(least < fov_y && fov_y < core::f64::consts::PI - least) =>
            {
                return error("field of view must be above 1e-6 and below π - 1e-6 radians");
            }
            Projection::Orthographic { height } if !(height > 0.0 && height.is_finite()) => {
                return error("orthographic height must be a positive number");
            }
            _ => {}
        }
        Ok(Self {
            width,
            height,
            eye: camera.eye.to_array(),
            axes: camera.axes().map(|axis| axis.to_array()),
            projection: camera.projection,
        })
    }

    /// From world coordinates to clip coordinates in pixels: after division by w, x runs from 0 at
    /// the left edge of the picture to `width`, y from 0 at the top to `height`; w is the distance
    /// from the eye plane (1 for parallel projection), z that distance always. A matrix by columns.
    pub fn world_to_pixels(&self) -> [[f64; 4]; 4] {
        let (half_width, half_height) = (0.5 * f64::from(self.width), 0.5 * f64::from(self.height));
        let [right, up, back] = self.axes.map(DVec3::from_array);
        let row = |axis: DVec3| axis.extend(-axis.dot(DVec3::from_array(self.eye)));
        let (x, y, distance) = (row(right), row(up), -row(back));
        let w = match self.projection {
            Projection::Perspective { .. } => distance,
            Projection::Orthographic { .. } => DVec4::W,
        };
        let scale = self.pixels_per_unit();
        DMat4::from_cols(x * scale + w * half_width, w * half_height - y * scale, distance, w)
            .transpose()
            .to_cols_array_2d()
    }

    /// Pixels per metre at distance 1 (perspective) or everywhere (parallel).
    pub fn pixels_per_unit(&self) -> f64 {
        0.5 * f64::from(self.height)
            / match self.projection {
                Projection::Perspective { fov_y } => libm::tan(0.5 * fov_y),
                Projection::Orthographic { height } => 0.5 * height,
            }
    }
}
