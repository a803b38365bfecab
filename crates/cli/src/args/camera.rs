//! From where.

use clap::Args;
use glam::DVec3;
use glanz_math::names::shown;
use glanz_scene::{Camera, Projection, Scene, camera_named};

use super::values;
use crate::load::Input;
use crate::print::failure::{Failure, Report};
use crate::print::number;

/// Another camera than the scene's.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Camera")]
pub(crate) struct CameraArgs {
    /// A camera of the model by its name or its number, from 0
    #[arg(long, value_name = "NAME")]
    pub camera: Option<String>,

    /// Position of the camera
    #[arg(long, value_name = "X,Y,Z", value_parser = values::triple, allow_hyphen_values = true)]
    pub eye: Option<[f64; 3]>,

    /// The point in the middle of the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = values::triple, allow_hyphen_values = true)]
    pub target: Option<[f64; 3]>,

    /// The up direction
    #[arg(long, value_name = "X,Y,Z", value_parser = values::triple, allow_hyphen_values = true)]
    pub up: Option<[f64; 3]>,

    /// Vertical field of view of a perspective camera, in degrees
    #[arg(long, value_name = "DEGREES")]
    pub fov_deg: Option<f64>,
}

impl CameraArgs {
    /// The camera to use: the one named, or the scene's, or one that shows everything; with the
    /// numbers given instead of its own.
    pub(crate) fn resolve(
        &self,
        Input { scene, cameras, .. }: &Input,
        (width, height): (u32, u32),
    ) -> Result<Camera, Failure> {
        let mut camera = match &self.camera {
            Some(name) => find(name, cameras)?,
            None => scene.camera_or_framing(f64::from(width.max(1)) / f64::from(height.max(1))),
        };
        let vector = |given: Option<[f64; 3]>, own| given.map_or(own, DVec3::from_array);
        camera.eye = vector(self.eye, camera.eye);
        camera.target = vector(self.target, camera.target);
        camera.up = vector(self.up, camera.up);
        if !(camera.eye.is_finite() && camera.target.is_finite()) {
            return Err(too_far(scene));
        }
        if camera.up.try_normalize().is_none() {
            return Err(Failure::Usage("--up is no direction: three numbers that are not all 0".to_owned()));
        }
        if let Some(degrees) = self.fov_deg {
            if !(degrees > 0.0 && degrees < 180.0) {
                return Err(Failure::Usage(format!("--fov-deg is {degrees}, but must be between 0 and 180")));
            }
            camera.projection = Projection::Perspective { fov_y: degrees.to_radians() };
        }
        Ok(camera)
    }
}

/// That nothing shows all of a scene: it reaches farther than numbers do from where a camera would be.
fn too_far(scene: &Scene) -> Failure {
    let [least, most] =
        [scene.bounds().min, scene.bounds().max].map(|corner| corner.to_array().map(number).join(", "));
    let message = format!("the objects reach from ({least}) to ({most}): no camera shows all of them");
    let report = Report::new(message).about_scene();
    report.help("correct their transforms, or say with --eye and --target where the camera is").into()
}

/// The camera called `name`, or of that number.
fn find(name: &str, named: &[(String, Camera)]) -> Result<Camera, Failure> {
    match camera_named(name, named) {
        Some(camera) => Ok(camera),
        None if named.is_empty() => {
            Err(Failure::Usage(format!("there is no camera '{}': the file has no cameras", shown(name))))
        }
        None => {
            let known: Vec<_> = named.iter().map(|(name, _)| format!("'{}'", shown(name))).collect();
            let (name, known) = (shown(name), known.join(", "));
            Err(Failure::Usage(format!("there is no camera '{name}'; the file has: {known}")))
        }
    }
}
