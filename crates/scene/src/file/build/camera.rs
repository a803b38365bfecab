//! The camera.

use std::ops::Range;

use super::builder::Builder;
use crate::file::error::Problem;
use crate::file::near::{did_you_mean, list, shown};
use crate::file::tables::camera::{CameraRef, CameraTable, ProjectionName};
use crate::file::tables::values::{At, FieldOfView};
use crate::{Camera, Projection};

impl Builder {
    pub(super) fn camera(&self, camera: &At<CameraRef>) -> Result<Camera, Problem> {
        match &camera.value {
            CameraRef::Table(table) => table.build(&camera.span),
            CameraRef::Name(name) => crate::camera_named(name, &self.made.cameras).ok_or_else(|| {
                let known = || self.made.cameras.iter().map(|(name, _)| name.as_str());
                let message = format!("unknown camera '{}'{}", shown(name), did_you_mean(name, known()));
                Problem::at(&camera.span, message)
                    .help(format!("the cameras in the files of the objects are: {}", list(known())))
            }),
        }
    }
}

impl CameraTable {
    fn perspective(&self, degrees: Option<&At<FieldOfView>>) -> Result<Projection, Problem> {
        let fov_y = match (degrees, &self.fov_rad) {
            (Some(_), Some(radians)) => {
                return Err(Problem::at(&radians.span, "'fov_rad' beside 'fov_deg'"));
            }
            (None, Some(radians)) if radians.0 < std::f64::consts::PI => radians.0,
            (None, Some(radians)) => {
                return Err(Problem::at(&radians.span, "expected less than π"));
            }
            (degrees, None) => degrees.map_or(40.0, |fov| fov.0).to_radians(),
        };
        Ok(Projection::Perspective { fov_y })
    }

    fn build(&self, span: &Range<usize>) -> Result<Camera, Problem> {
        let eye = self.eye.0;
        let target = self.target.as_ref().map_or(glam::DVec3::ZERO, |target| target.0);
        // Below this the direction between them is lost in the rounding of the coordinates.
        if (eye - target).length() <= 1e-12 * eye.length().max(1.0) {
            let span = self.target.as_ref().map_or(&self.eye.span, |target| &target.span);
            return Err(Problem::at(span, "'eye' and 'target' are the same point; they must differ"));
        }
        let projection = match (self.projection, &self.fov_deg, &self.height) {
            (ProjectionName::Perspective, _, Some(height)) => {
                return Err(Problem::at(&height.span, "'height' needs projection = \"orthographic\""));
            }
            (ProjectionName::Orthographic, Some(fov), _) => {
                return Err(Problem::at(&fov.span, "an orthographic camera has no 'fov_deg'")
                    .help("'height' says how much it shows, in metres"));
            }
            (ProjectionName::Orthographic, None, None) => {
                return Err(Problem::at(span, "an orthographic camera needs 'height', which is missing"));
            }
            (ProjectionName::Orthographic, None, Some(height)) => {
                Projection::Orthographic { height: height.0 }
            }
            (ProjectionName::Perspective, fov, None) => self.perspective(fov.as_ref())?,
        };
        let up = self.up.map_or(glam::DVec3::Y, |up| up.0);
        Ok(Camera { eye, target, up, projection })
    }
}
