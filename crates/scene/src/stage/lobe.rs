//! The scene that shows one lobe: a mesh under a few directional lights.

use glam::{DMat4, DVec3};
use glanz_bsdf::{LightTerm, Shape, Side};
use glanz_color::Rgb;

use super::{directional, object};
use crate::builtin::{Builtin, BuiltinError};
use crate::{
    Background, Camera, ColorMode, Image, Light, LightColor, LightColors, LightKind, Lobe, Material,
    Projection, RenderSettings, Scene, Tint, ToneMap,
};

/// The background, linear.
const BACKGROUND: Rgb = Rgb([0.045, 0.045, 0.05]);
/// Vertical field of view, in degrees: narrow, so that a ball at the edge of a sheet looks round.
const FOV_DEG: f64 = 20.0;
/// The part of the picture's half height that the mesh fills.
const FILLED: f64 = 0.92;
/// Directions of the lights and how strong they are: a key light from the upper left, a rim light from behind on the
/// right which shows grazing reflection, and a weak one from below.
const LIGHTS: [([f64; 3], f64); 3] =
    [([1.0, -1.1, -1.2], 0.9), ([-1.3, -0.25, 1.0], 0.7), ([-0.6, 1.0, -0.8], 0.2)];
/// The same for transmission: from behind, left, right and above.
const LIGHTS_BEHIND: [([f64; 3], f64); 3] =
    [([0.6, -0.5, 1.0], 0.9), ([-0.9, 0.2, 1.0], 0.6), ([0.0, -1.0, 0.3], 0.5)];
/// Ambient light, for lobes that respond to nothing else.
const AMBIENT: f64 = 0.6;

/// One lobe on a mesh, for pictures of models that can be compared: spectral, tone mapped.
///
/// Lobes that are a delta function (mirror, refraction) stay black: the lights are directional.
#[derive(Clone, Debug)]
pub struct LobeStage {
    /// The directional part of the lobe.
    pub shape: Shape,
    /// Its coloured part.
    pub tint: Tint,
    /// What it is shown on; spheres and tori are made finer.
    pub mesh: Builtin,
    /// The colour of the lights.
    pub light: LightColor,
}

impl LobeStage {
    /// The scene, for pictures of this width and height.
    ///
    /// # Errors
    /// Where the mesh cannot be made of its parameters.
    pub fn scene(&self, (width, height): (u32, u32)) -> Result<Scene, BuiltinError> {
        let mut mesh = finer(self.mesh).mesh()?;
        if self.shape.info().anisotropic && mesh.tangents.is_empty() {
            mesh = mesh.with_tangents();
        }
        let center = mesh.bounds().center();
        let radius = mesh.positions.iter().map(|p| p.as_dvec3().distance(center)).fold(1e-9, f64::max);
        let lobe = Lobe::new(self.shape.clone(), self.tint.clone());
        Ok(Scene {
            meshes: vec![mesh],
            materials: vec![Material::of_lobes("ball", vec![lobe])],
            lights: self.lights(),
            objects: vec![object(0, 0, DMat4::IDENTITY)],
            camera: Some(camera(center, radius, f64::from(width) / f64::from(height))),
            image: Image { width, height, background: Background::Color(BACKGROUND), ..Image::default() },
            render: RenderSettings {
                mode: ColorMode::Spectral,
                tone_map: ToneMap::KhronosNeutral,
                ..RenderSettings::default()
            },
            ..Scene::default()
        })
    }

    fn lights(&self) -> Vec<Light> {
        let lights = match (self.shape.info().term, self.shape.info().side) {
            (LightTerm::Ambient | LightTerm::Emission, _) => {
                let colors = LightColors::ambient(self.light.scaled(AMBIENT));
                return vec![Light { name: "ambient".to_owned(), ..Light::new(LightKind::Ambient, colors) }];
            }
            (_, Side::Reflection) => LIGHTS,
            (_, Side::Transmission) => LIGHTS_BEHIND,
        };
        lights.into_iter().map(|light| directional(&self.light, light)).collect()
    }
}

/// A camera before a mesh, a little above it.
fn camera(target: DVec3, radius: f64, aspect: f64) -> Camera {
    let half = 0.5 * FOV_DEG.to_radians();
    let narrower = half.min(libm::atan(libm::tan(half) * aspect));
    let distance = radius / libm::sin(libm::atan(FILLED * libm::tan(narrower)));
    let eye = target + DVec3::new(0.0, 0.3, 1.0).normalize() * distance;
    let projection = Projection::Perspective { fov_y: 2.0 * half };
    Camera { eye, target, up: DVec3::Y, projection }
}

/// A mesh whose outline has no corners in a picture of a few hundred pixels.
fn finer(mesh: Builtin) -> Builtin {
    match mesh {
        Builtin::Sphere { radius, .. } => Builtin::Sphere { radius, slices: 192, stacks: 96 },
        Builtin::Torus { major, minor, .. } => Builtin::Torus { major, minor, segments: 192, sides: 96 },
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_comes_from_behind_where_the_lobe_transmits() {
        let stage = |model: &str| LobeStage {
            shape: Shape::named(model, &[]).expect("it is listed"),
            tint: Tint::Rgb(Rgb::WHITE),
            mesh: Builtin::Quad,
            light: LightColor::Rgb(Rgb::WHITE),
        };
        let directions = |model: &str| {
            let scene = stage(model).scene((16, 16)).expect("a quad has no parameters");
            scene
                .lights
                .iter()
                .filter(
                    |light| matches!(light.kind, LightKind::Directional { direction } if direction.z > 0.0),
                )
                .count()
        };
        assert_eq!(
            (directions("lambert"), directions("lambert-transmission"), directions("ambient")),
            (1, 3, 0)
        );
    }
}
