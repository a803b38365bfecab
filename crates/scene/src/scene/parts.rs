//! The whole of a scene.

use glam::DMat4;
use glanz_color::Observer;
use glanz_eye::Viewer;
use serde::{Deserialize, Serialize};

use crate::{
    Bounds, Camera, Image, Interpolation, Light, Material, Mesh, Program, RenderSettings, Shading, Texture,
};

/// A mesh put into the scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Object {
    /// A name for people; may be empty.
    pub name: String,
    /// Index in `Scene::meshes`.
    pub mesh: usize,
    /// Index in `Scene::materials`.
    pub material: usize,
    /// From mesh to world coordinates; affine.
    pub transform: DMat4,
    /// If not the scene's.
    pub shading: Option<Shading>,
    /// If not the scene's.
    pub interpolation: Option<Interpolation>,
    /// Index in `Scene::programs`, if not the scene's.
    pub program: Option<usize>,
}

/// A scene: what there is, without caches.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// All meshes.
    pub meshes: Vec<Mesh>,
    /// All textures.
    pub textures: Vec<Texture>,
    /// All materials.
    pub materials: Vec<Material>,
    /// All lights; ambient light is one without direction.
    pub lights: Vec<Light>,
    /// All objects.
    pub objects: Vec<Object>,
    /// Shaders of the user's own.
    pub programs: Vec<Program>,
    /// Index in `programs`, of what draws all objects that have no program of their own.
    pub program: Option<usize>,
    /// Where the eye is; `None` for a camera that shows everything.
    pub camera: Option<Camera>,
    /// The picture to be made.
    pub image: Image,
    /// How to draw.
    pub render: RenderSettings,
    /// Who looks, where the colour mode leaves a choice; `None` for the standard observer.
    pub observer: Option<Observer>,
    /// The eye that looks, in place of an observer, and how it looks.
    pub eye: Option<Viewer>,
    /// Whether light is in photometric units: 1 in a frame is then 1 cd/m², else the classic unit.
    pub photometric: bool,
}

impl Scene {
    /// The box around all objects, in the world.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        for object in &self.objects {
            let mesh = &self.meshes[object.mesh];
            for &corner in &mesh.corners {
                bounds.include(object.transform.transform_point3(mesh.positions[corner as usize].as_dvec3()));
            }
        }
        bounds
    }

    /// The program that draws an object; none where its material does.
    pub fn program_of(&self, object: usize) -> Option<&Program> {
        let own = self.objects.get(object)?.program.or(self.program)?;
        self.programs.get(own)
    }

    /// Lets a program draw all objects that have none of their own; in place of the one that did so before.
    pub fn set_program(&mut self, program: Program) {
        match self.program.and_then(|own| self.programs.get_mut(own)) {
            Some(own) => *own = program,
            None => {
                self.programs.push(program);
                self.program = Some(self.programs.len() - 1);
            }
        }
    }

    /// The scene's camera, or one that shows everything in a picture of this aspect ratio.
    pub fn camera_or_framing(&self, aspect: f64) -> Camera {
        self.camera.unwrap_or_else(|| Camera::framing(&self.bounds(), aspect))
    }
}
