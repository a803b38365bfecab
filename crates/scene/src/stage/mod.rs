//! Scenes made in code, to show one thing well: a material, or one lobe.
//!
//! ```
//! use glanz_scene::{LightColor, library, stage::MaterialStage};
//!
//! let stage = MaterialStage::new(LightColor::Rgb(glanz_color::Rgb::WHITE));
//! let gold = library::info("gold").expect("it is in the library").material();
//! let scene = stage.scene(gold, (320, 240));
//! assert_eq!(scene.objects.len(), 1);
//! ```

mod lobe;
mod material;
mod studio;

pub use lobe::LobeStage;
pub use material::MaterialStage;
pub(crate) use studio::coarse_studio;
pub use studio::studio;

use glam::{DMat4, DVec3};

use crate::{Light, LightColor, LightColors, LightKind, Object, Space};

/// A directional light that moves with the camera.
fn directional(color: &LightColor, (direction, strength): ([f64; 3], f64)) -> Light {
    let kind = LightKind::Directional { direction: DVec3::from_array(direction) };
    Light { space: Space::Camera, ..Light::new(kind, LightColors::direct(color.scaled(strength))) }
}

fn object(mesh: usize, material: usize, transform: DMat4) -> Object {
    Object {
        name: String::new(),
        mesh,
        material,
        transform,
        shading: None,
        interpolation: None,
        program: None,
    }
}
