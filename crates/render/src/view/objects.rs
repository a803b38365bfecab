//! How the objects of a scene take part in a frame.
//!
//! ```
//! use glanz_render::view::camera::ViewCamera;
//! use glanz_render::view::objects::{Pass, ViewObject};
//! use glanz_render::{PrepareOptions, View, prepare};
//! use glanz_scene::{Camera, Light, Material, Mesh, Scene};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("sphere")?, Material::default_gray())
//!     .with_light(Light::point([0.0, 0.0, 3.0], [1.0; 3]));
//! let prepared = prepare(&scene, &PrepareOptions::default())?;
//! let view = View::new(&Camera::new([0.0, 0.0, 5.0], [0.0; 3]), 64, 48)?;
//! let camera = ViewCamera::new(&prepared, &view);
//! let seen = ViewObject::new(&prepared.objects[0], &prepared.materials[0], &camera);
//! assert_eq!(seen.pass, Pass::Opaque);
//! assert!(seen.cull_back, "nobody sees the inside of a closed sphere");
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

use glanz_scene::AlphaMode;

use super::camera::ViewCamera;
use crate::prepare::{PreparedMaterial, PreparedObject};

/// How a triangle of an object takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Hides what is behind it.
    Opaque,
    /// Hides where its texture is opaque enough.
    Masked,
    /// Lets through what is behind it.
    Blended,
}

/// An object seen from the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewObject {
    /// How its triangles take part.
    pub pass: Pass,
    /// Whether back faces can be dropped: nobody sees them, or the material asks for it.
    pub cull_back: bool,
    /// The object's anchor along right, up and away from the camera.
    pub anchor: [f32; 3],
    /// Triangles that come nearer than this many metres may have depths that differ too much to be interpolated from any
    /// corner in single precision: from their farthest only.
    pub steep: f32,
}

/// The part of an object's greatest distance below which its triangles may be steep.
const STEEP: f64 = 1e-5;

impl ViewObject {
    /// An object of this material.
    pub fn new(object: &PreparedObject, material: &PreparedMaterial, camera: &ViewCamera) -> Self {
        let pass = match material.alpha_mode {
            _ if material.transmittance.is_some() => Pass::Blended,
            AlphaMode::Opaque => Pass::Opaque,
            AlphaMode::Mask { .. } => Pass::Masked,
            AlphaMode::Blend => Pass::Blended,
        };
        let hidden = object.closed && pass == Pass::Opaque && camera.is_outside(object);
        let [_, farthest] = camera.range_of(object);
        let steep = if camera.perspective { (farthest * STEEP) as f32 } else { 0.0 };
        Self {
            pass,
            cull_back: material.cull_back || hidden,
            anchor: camera.anchor(object),
            steep: steep.max(camera.near),
        }
    }
}
