//! The whole of a scene.

use glam::DMat4;
use glanz_color::{Observer, Rgb};

use crate::{Bounds, Camera, ColorMode, Light, Material, Mesh, Texture, White};

/// Where the illumination model is evaluated, and what is interpolated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shading {
    /// Once per facet: at its centroid, with its own normal.
    Flat,
    /// At the vertices; values are interpolated.
    Gouraud,
    /// At each pixel, with the interpolated normal.
    #[default]
    Phong,
}

/// How values between vertices are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Linear on the surface in space: right under perspective.
    #[default]
    Perspective,
    /// Linear on the screen, over triangles.
    ScreenLinear,
    /// The scheme of 1971: along the edges of the whole polygon, then along the scanline.
    Scanline,
}

/// What is where nothing is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// A linear colour.
    Color(Rgb),
    /// Nothing: alpha 0.
    Transparent,
    /// The first light of the scene that is an environment.
    Environment,
}

/// The picture to be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Coverage samples per pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// Shade every sample rather than once per pixel and surface.
    pub supersample: bool,
    /// Where nothing is.
    pub background: Background,
}

impl Default for Image {
    fn default() -> Self {
        Self {
            width: 800,
            height: 600,
            samples: 4,
            supersample: false,
            background: Background::Color(Rgb([0.05, 0.05, 0.08])),
        }
    }
}

/// How to draw what does not say otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RenderSettings {
    /// For objects that name none.
    pub shading: Shading,
    /// For objects that name none.
    pub interpolation: Interpolation,
    /// How colour is treated.
    pub mode: ColorMode,
    /// The white that becomes the screen's.
    pub white: White,
    /// Whether surfaces stand in each other's light. The classic models know no shadows.
    pub shadows: bool,
}

/// A mesh put into the scene.
#[derive(Clone, Debug, PartialEq)]
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
}

/// A scene: what there is, without caches.
#[derive(Clone, Debug, Default, PartialEq)]
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
    /// Where the eye is; `None` for a camera that shows everything.
    pub camera: Option<Camera>,
    /// The picture to be made.
    pub image: Image,
    /// How to draw.
    pub render: RenderSettings,
    /// Who looks, where the colour mode leaves a choice; `None` for the standard observer.
    pub observer: Option<Observer>,
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

    /// The scene's camera, or one that shows everything in a picture of this aspect ratio.
    pub fn camera_or_framing(&self, aspect: f64) -> Camera {
        self.camera.unwrap_or_else(|| Camera::framing(&self.bounds(), aspect))
    }
}
