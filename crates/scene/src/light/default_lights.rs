//! Light for scenes that have none of their own.

use glam::DVec3;
use glanz_color::Rgb;

use crate::{Light, LightColors, LightKind, Scene, Space};

/// Adds lights by which anything can be seen from anywhere: a key light from the upper left and a
/// weaker fill light from the right, both moving with the camera, and modest ambient light.
///
/// Meant for models without lights; scene files are taken literally. A white matte surface that faces
/// the viewer gets about 0.9.
pub fn add_default_lights(scene: &mut Scene) {
    let lamp = |name: &str, direction: DVec3, value: f32| Light {
        name: name.to_owned(),
        space: Space::Camera,
        ..Light::new(LightKind::Directional { direction }, LightColors::direct(Rgb::gray(value)))
    };
    scene.lights.push(Light {
        name: "ambient".to_owned(),
        ..Light::new(LightKind::Ambient, LightColors::ambient(Rgb::gray(0.15)))
    });
    scene.lights.push(lamp("key", DVec3::new(1.0, -1.2, -1.6), 0.8));
    scene.lights.push(lamp("fill", DVec3::new(-1.5, 0.3, -1.0), 0.25));
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
