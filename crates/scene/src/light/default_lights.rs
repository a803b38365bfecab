//! Light for scenes that have none of their own.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use glanz_bsdf::LightTerm;
use glanz_color::Rgb;

use crate::stage::{coarse_studio, studio};
use crate::{EnvironmentMap, Light, LightColor, LightColors, LightKind, Material, Scene, Space, Tint};

/// Lights that a model without any gets.
///
/// ```
/// use glanz_scene::{DefaultLights, Mesh, Scene, library};
///
/// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?);
/// DefaultLights::ThreePoint.add(&mut scene);
/// assert_eq!(scene.lights.len(), 4, "a metal gets faint surroundings to mirror");
/// assert_eq!(DefaultLights::named("studio"), Some(DefaultLights::Studio));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DefaultLights {
    /// No lights.
    None,
    /// A key light, a fill light, ambient light; and faint surroundings where a surface only mirrors.
    #[default]
    ThreePoint,
    /// A room with windows, and two lights.
    Studio,
}

/// The part of the studio's light that metals mirror beside three lights.
const FAINT: f32 = 0.4;

impl DefaultLights {
    /// All of them with their names.
    pub const NAMES: [(&str, Self); 3] =
        [("none", Self::None), ("three-point", Self::ThreePoint), ("studio", Self::Studio)];

    /// Those of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(own, _)| *own == name).map(|(_, lights)| *lights)
    }

    /// Adds them to a scene.
    pub fn add(self, scene: &mut Scene) {
        match self {
            Self::None => {}
            Self::ThreePoint => {
                add_default_lights(scene);
                if scene.objects.iter().any(|object| only_mirrors(&scene.materials[object.material])) {
                    let specular = LightColor::from(Rgb::gray(FAINT));
                    let colors = LightColors { specular, ..LightColors::ambient(LightColor::BLACK) };
                    scene.lights.push(surroundings(coarse_studio(), colors));
                }
            }
            Self::Studio => {
                scene.lights.push(ambient(0.35));
                scene.lights.push(lamp("key", DVec3::new(1.0, -1.1, -1.2), 0.35));
                scene.lights.push(lamp("rim", DVec3::new(-0.9, -0.5, 1.0), 0.35));
                scene.lights.push(surroundings(studio(), LightColors::direct(Rgb::gray(1.0))));
            }
        }
    }
}

/// How much brighter than its matte part the rest of a surface is if lamps alone leave it dark but for its highlights.
const MOSTLY: f32 = 2.0;

/// Whether lamps alone leave a surface dark but for its highlights: it has hardly a matte part, or a picture says where.
fn only_mirrors(material: &Material) -> bool {
    let brightest = |term: LightTerm| {
        let lobes = material.lobes.iter().filter(|lobe| lobe.shape.info().term == term);
        lobes.map(|lobe| brightness(&lobe.tint)).fold(0.0, f32::max)
    };
    let (matte, glossy) = (brightest(LightTerm::Diffuse), brightest(LightTerm::Specular));
    glossy > MOSTLY * matte || (glossy > 0.0 && material.metal_rough_map.is_some())
}

/// About what a tint reflects at normal incidence.
fn brightness(tint: &Tint) -> f32 {
    match tint {
        Tint::Rgb(rgb) => rgb.0.into_iter().fold(0.0, f32::max),
        Tint::Schlick(at_normal) => brightness(at_normal),
        Tint::Spectrum(spectrum) => spectrum.0.iter().copied().fold(0.0, f64::max) as f32,
        Tint::Ior(ior) | Tint::Polarized(ior, _) => {
            let reflected = |eta: f64, k: f64| {
                let k2 = k * k;
                ((eta - 1.0) * (eta - 1.0) + k2) / ((eta + 1.0) * (eta + 1.0) + k2)
            };
            let middle = glanz_color::SAMPLES / 2;
            reflected(ior.eta.0[middle], ior.k.0[middle]) as f32
        }
        Tint::Reradiation(_) => 1.0,
        // A few per cent, where they are not metals.
        Tint::Film(_) | Tint::Pane(_) | Tint::Coated(_) => 0.05,
    }
}

/// Adds lights by which anything can be seen from anywhere: a key light from the upper left and a
/// weaker fill light from the right, both moving with the camera, and modest ambient light.
///
/// Meant for models without lights; scene files are taken literally. A white matte surface that faces
/// the viewer gets about 0.9. [`DefaultLights`] has others.
pub fn add_default_lights(scene: &mut Scene) {
    scene.lights.push(ambient(0.15));
    scene.lights.push(lamp("key", DVec3::new(1.0, -1.2, -1.6), 0.8));
    scene.lights.push(lamp("fill", DVec3::new(-1.5, 0.3, -1.0), 0.25));
}

fn ambient(value: f32) -> Light {
    let light = Light::new(LightKind::Ambient, LightColors::ambient(Rgb::gray(value)));
    Light { name: "ambient".to_owned(), ..light }
}

/// A directional light that moves with the camera.
fn lamp(name: &str, direction: DVec3, value: f32) -> Light {
    let light = Light::new(LightKind::Directional { direction }, LightColors::direct(Rgb::gray(value)));
    Light { name: name.to_owned(), space: Space::Camera, ..light }
}

fn surroundings(map: EnvironmentMap, colors: LightColors) -> Light {
    let map = Some(Arc::new(map));
    let light = Light::new(LightKind::Environment { map, rotation: DMat3::IDENTITY }, colors);
    Light { name: "studio".to_owned(), ..light }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glanz_bsdf::Shape;

    use crate::{Lobe, Mesh, library};

    #[test]
    fn a_white_surface_that_faces_the_viewer_is_bright_but_not_clipped() {
        let mut scene = Scene::default();
        add_default_lights(&mut scene);
        // Towards the camera, in camera space.
        let normal = DVec3::Z;
        let received = scene.lights.iter().map(|light| match light.kind {
            LightKind::Directional { direction } => {
                let cosine = -direction.normalize().dot(normal);
                light.colors.diffuse.strength() * cosine.max(0.0)
            }
            _ => light.colors.ambient.strength(),
        });
        let value: f64 = received.sum();
        assert!((0.8..1.0).contains(&value), "{value}");
    }

    #[test]
    fn what_is_hardly_matte_gets_surroundings_too() {
        let lobe = |shape: &str, value: f32| Lobe::new(Shape::named(shape, &[]).unwrap(), Rgb::gray(value));
        for (matte, glossy, expected) in
            [(0.05, 0.9, true), (0.5, 0.04, false), (0.4, 0.5, false), (0.01, 0.04, true)]
        {
            let lobes = vec![lobe("lambert", matte), lobe("ggx", glossy)];
            assert_eq!(only_mirrors(&Material::of_lobes("m", lobes)), expected, "{matte}, {glossy}");
        }
    }

    #[test]
    fn surroundings_are_for_what_mirrors_alone() {
        let lights = |material: &str, lights: DefaultLights| {
            let mesh = Mesh::builtin("sphere").unwrap();
            let mut scene = Scene::new().with_mesh(mesh, library::material(material).unwrap());
            lights.add(&mut scene);
            let is_surrounding = |light: &&Light| matches!(light.kind, LightKind::Environment { .. });
            (scene.lights.len(), scene.lights.iter().filter(is_surrounding).count())
        };
        assert_eq!(lights("gold", DefaultLights::ThreePoint), (4, 1));
        assert_eq!(lights("wall-paint-white", DefaultLights::ThreePoint), (3, 0));
        assert_eq!(lights("wall-paint-white", DefaultLights::Studio), (4, 1));
        assert_eq!(lights("gold", DefaultLights::None), (0, 0));
        assert_eq!(lights("plastic-red", DefaultLights::ThreePoint), (3, 0));
    }
}
