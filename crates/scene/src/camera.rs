//! Where the eye is.

use glam::{DMat4, DVec3, DVec4};
use serde::{Deserialize, Serialize};

use crate::Bounds;

/// How the scene is projected on the picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Projection {
    /// A pinhole with this vertical field of view, in radians.
    Perspective {
        /// Vertical field of view, in radians, between 0 and π.
        fov_y: f64,
    },
    /// Parallel rays; the picture shows this height.
    Orthographic {
        /// Height of what is seen, in metres.
        height: f64,
    },
}

impl Projection {
    /// A field of view is farther than this from 0 and from π, in radians: no picture can be drawn with another.
    pub const FOV_MARGIN: f64 = 1e-6;
}

/// A camera, looking from `eye` to `target`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Camera {
    /// Position of the eye.
    pub eye: DVec3,
    /// A point in the middle of the picture.
    pub target: DVec3,
    /// A direction that appears upright; need not be perpendicular to the view.
    pub up: DVec3,
    /// Perspective or parallel.
    pub projection: Projection,
}

/// The camera of this name among those of a file, or else the one of this number, from 0.
///
/// ```
/// use glanz_scene::{Camera, camera_named};
///
/// let front = Camera::new([0.0, 0.0, 5.0], [0.0, 0.0, 0.0]);
/// let side = Camera::new([5.0, 0.0, 0.0], [0.0, 0.0, 0.0]);
/// let cameras = [("front".to_owned(), front), ("side".to_owned(), side)];
/// assert_eq!(camera_named("side", &cameras), Some(side));
/// assert_eq!(camera_named("0", &cameras), Some(front));
/// assert_eq!(camera_named("back", &cameras), None);
/// ```
pub fn camera_named(name: &str, cameras: &[(String, Camera)]) -> Option<Camera> {
    let by_name = cameras.iter().find(|(own, _)| own == name);
    let by_number = || name.parse::<usize>().ok().and_then(|number| cameras.get(number));
    by_name.or_else(by_number).map(|(_, camera)| *camera)
}

/// Vertical field of view of a camera that Glanz chooses itself, in degrees.
const DEFAULT_FOV_DEG: f64 = 40.0;

impl Camera {
    /// A camera at `eye` that looks at `target`, +Y up, with a vertical field of view of 40°.
    ///
    /// ```
    /// use glanz_scene::{Camera, Projection};
    ///
    /// let camera = Camera::new([0.0, 0.0, 5.0], [0.0, 0.0, 0.0]);
    /// assert_eq!(camera.axes()[2].to_array(), [0.0, 0.0, 1.0]);
    /// let flat = camera.orthographic(2.0);
    /// assert_eq!(flat.projection, Projection::Orthographic { height: 2.0 });
    /// ```
    pub fn new(eye: impl Into<DVec3>, target: impl Into<DVec3>) -> Self {
        let projection = Projection::Perspective { fov_y: DEFAULT_FOV_DEG.to_radians() };
        Self { eye: eye.into(), target: target.into(), up: DVec3::Y, projection }
    }

    /// The same with this vertical field of view, in degrees.
    #[must_use]
    pub fn with_fov_deg(self, fov_deg: f64) -> Self {
        Self { projection: Projection::Perspective { fov_y: fov_deg.to_radians() }, ..self }
    }

    /// The same with parallel rays, in a picture that shows this height in metres.
    #[must_use]
    pub fn orthographic(self, height: f64) -> Self {
        Self { projection: Projection::Orthographic { height }, ..self }
    }

    /// A camera that shows all of `bounds` in a picture of this aspect ratio (width / height), from
    /// the front, a little from the right and above. Empty bounds are framed like the unit sphere.
    pub fn framing(bounds: &Bounds, aspect: f64) -> Self {
        let direction = DVec3::new(0.45, 0.35, 1.0).normalize();
        Self::framing_from(bounds, aspect, direction)
    }

    /// A camera that shows all of `bounds` and stands in direction `direction` of their centre.
    pub fn framing_from(bounds: &Bounds, aspect: f64, direction: DVec3) -> Self {
        let (center, radius) = if bounds.is_empty() {
            (DVec3::ZERO, 1.0)
        } else {
            (bounds.center(), (bounds.diagonal() * 0.5).max(1e-9))
        };
        let fov_y = DEFAULT_FOV_DEG.to_radians();
        let half_vertical = fov_y * 0.5;
        let half_horizontal = libm::atan(libm::tan(half_vertical) * aspect);
        let distance = 1.02 * radius / libm::sin(half_vertical.min(half_horizontal));
        Self {
            eye: center + direction * distance,
            target: center,
            up: DVec3::Y,
            projection: Projection::Perspective { fov_y },
        }
    }

    /// The camera's axes in the world: right, up, and backwards (from target to eye).
    ///
    /// Where `up` lies along the view direction, another one is chosen rather than failing.
    pub fn axes(&self) -> [DVec3; 3] {
        let back = (self.eye - self.target).try_normalize().unwrap_or(DVec3::Z);
        let right = self.up.cross(back).try_normalize().or_else(|| DVec3::Z.cross(back).try_normalize());
        let right = right.unwrap_or(DVec3::X);
        [right, back.cross(right), back]
    }

    /// From world coordinates to those of the camera: x to the right, y up, z backwards, the eye at 0. OpenGL's view
    /// matrix, as `lookAt` gives it; for columns.
    ///
    /// ```
    /// use glanz_scene::Camera;
    ///
    /// let view = Camera::new([0.0, 0.0, 5.0], [0.0, 0.0, 0.0]).view_matrix();
    /// assert_eq!(view.transform_point3([1.0, 2.0, 0.0].into()).to_array(), [1.0, 2.0, -5.0]);
    /// ```
    pub fn view_matrix(&self) -> DMat4 {
        let [right, up, back] = self.axes();
        let row = |axis: DVec3| axis.extend(-axis.dot(self.eye));
        DMat4::from_cols(row(right), row(up), row(back), DVec4::W).transpose()
    }

    /// From the camera's coordinates to OpenGL's clip coordinates, for a picture of this aspect ratio (width / height)
    /// and planes at these distances in metres; for columns. Glanz itself has no such planes.
    ///
    /// ```
    /// use glanz_scene::Camera;
    ///
    /// let camera = Camera::new([0.0, 0.0, 5.0], [0.0, 0.0, 0.0]).with_fov_deg(90.0);
    /// let far = camera.projection_matrix(1.0, [1.0, 10.0]).project_point3([10.0, 0.0, -10.0].into());
    /// assert!((far - glanz_scene::glam::DVec3::new(1.0, 0.0, 1.0)).length() < 1e-12);
    /// ```
    pub fn projection_matrix(&self, aspect: f64, [near, far]: [f64; 2]) -> DMat4 {
        // x and y per unit, then z and w of columns (0, 0, z, 1).
        let (y, z, w) = match self.projection {
            Projection::Perspective { fov_y } => {
                let z = [(near + far) / (near - far), 2.0 * near * far / (near - far)];
                (1.0 / libm::tan(0.5 * fov_y), z, [-1.0, 0.0])
            }
            Projection::Orthographic { height } => {
                (2.0 / height, [2.0 / (near - far), (near + far) / (near - far)], [0.0, 1.0])
            }
        };
        let column = |i: usize| DVec4::new(0.0, 0.0, z[i], w[i]);
        DMat4::from_cols(DVec4::X * (y / aspect), DVec4::Y * y, column(0), column(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_right_handed_even_when_up_is_along_the_view() {
        let mut camera = Camera::framing(&Bounds::EMPTY, 1.0);
        for up in [DVec3::Y, DVec3::Z, camera.eye, -camera.eye] {
            camera.up = up;
            let [x, y, z] = camera.axes();
            assert!((x.cross(y) - z).length() < 1e-12);
            assert!((x.length() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn both_projections_bring_what_is_in_view_into_the_cube() {
        let camera = Camera::new([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]).with_fov_deg(90.0);
        for (camera, side) in [(camera, 1.0), (camera.orthographic(6.0), 0.0)] {
            for (distance, z) in [(3.0, -1.0), (12.0, 1.0)] {
                let half = if side > 0.0 { distance } else { 3.0 };
                let matrix = camera.projection_matrix(2.0, [3.0, 12.0]);
                let corner = matrix.project_point3(DVec3::new(2.0 * half, half, -distance));
                assert!((corner - DVec3::new(1.0, 1.0, z)).length() < 1e-12, "{corner}");
            }
        }
    }
}
