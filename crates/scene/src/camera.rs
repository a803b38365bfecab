//! Where the eye is.

use glam::DVec3;
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
}
