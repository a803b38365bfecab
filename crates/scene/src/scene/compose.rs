//! Scenes made in code, a part at a time.

use glam::{DMat4, DVec3};
use glanz_color::Observer;
use glanz_eye::Viewer;

use crate::{Background, Camera, ColorMode, Light, Material, Mesh, Object, Scene};

/// Making a scene in code.
///
/// ```
/// use glanz_scene::{Camera, Light, Mesh, Scene, library};
///
/// let scene = Scene::new()
///     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
///     .with_mesh_at(Mesh::builtin("plane")?, library::material("plaster")?, [0.0, -1.0, 0.0])
///     .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]))
///     .with_camera(Camera::new([0.0, 1.0, 6.0], [0.0, 0.0, 0.0]).with_fov_deg(30.0))
///     .with_size(320, 240);
/// assert_eq!(scene.object("sphere")?.material, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl Scene {
    /// Nothing yet: no objects and no light, for a picture of 800×600 pixels in linear sRGB.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a mesh of this material where its own coordinates say, as an object of its name.
    #[must_use]
    pub fn with_mesh(self, mesh: Mesh, material: Material) -> Self {
        self.with_mesh_at(mesh, material, DVec3::ZERO)
    }

    /// Adds a mesh of this material, with its origin at `position`, as an object of its name. A material that the
    /// scene has already is not added again.
    #[must_use]
    pub fn with_mesh_at(mut self, mesh: Mesh, material: Material, position: impl Into<DVec3>) -> Self {
        let known = self.materials.iter().position(|known| *known == material);
        let material = known.unwrap_or_else(|| {
            self.materials.push(material);
            self.materials.len() - 1
        });
        let object = Object::new(self.meshes.len(), material).named(&*mesh.name).at(position);
        self.meshes.push(mesh);
        self.objects.push(object);
        self
    }

    /// Adds a light.
    #[must_use]
    pub fn with_light(mut self, light: Light) -> Self {
        self.lights.push(light);
        self
    }

    /// The same seen by this camera.
    #[must_use]
    pub fn with_camera(self, camera: Camera) -> Self {
        Self { camera: Some(camera), ..self }
    }

    /// The same in a picture of this width and height in pixels.
    #[must_use]
    pub fn with_size(mut self, width: u32, height: u32) -> Self {
        (self.image.width, self.image.height) = (width, height);
        self
    }

    /// The same before this background.
    #[must_use]
    pub fn with_background(mut self, background: Background) -> Self {
        self.image.background = background;
        self
    }

    /// The same in this colour mode.
    #[must_use]
    pub fn with_mode(mut self, mode: ColorMode) -> Self {
        self.render.mode = mode;
        self
    }

    /// The same seen by this observer, which only some colour modes leave open.
    #[must_use]
    pub fn with_observer(self, observer: Observer) -> Self {
        Self { observer: Some(observer), eye: None, ..self }
    }

    /// The same seen by an eye, which the modes with spectra leave open.
    #[must_use]
    pub fn with_eye(self, eye: impl Into<Viewer>) -> Self {
        Self { eye: Some(eye.into()), observer: None, ..self }
    }
}

impl Object {
    /// A mesh and a material of the scene, by their numbers, without a name, where the mesh's own coordinates say.
    pub fn new(mesh: usize, material: usize) -> Self {
        let (name, transform) = (String::new(), DMat4::IDENTITY);
        Self { name, mesh, material, transform, shading: None, interpolation: None, program: None }
    }

    /// The same under a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// The same with the mesh's origin at `position`.
    #[must_use]
    pub fn at(mut self, position: impl Into<DVec3>) -> Self {
        self.set_position(position);
        self
    }

    /// Moves the object so that the mesh's origin is at `position`; how it is turned and scaled stays.
    ///
    /// ```
    /// use glanz_scene::{Object, glam::{DMat4, DVec3}};
    ///
    /// let mut object = Object { transform: DMat4::from_scale(DVec3::splat(2.0)), ..Object::new(0, 0) };
    /// object.set_position([1.0, 0.0, 0.0]);
    /// assert_eq!(object.transform.transform_point3(DVec3::Y), DVec3::new(1.0, 2.0, 0.0));
    /// ```
    pub fn set_position(&mut self, position: impl Into<DVec3>) {
        self.transform.w_axis = position.into().extend(1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library;

    #[test]
    fn a_material_that_is_there_is_not_added_again() {
        let gold = || library::material("gold").unwrap();
        let ball = || Mesh::builtin("sphere").unwrap();
        let scene = Scene::new()
            .with_mesh(ball(), gold())
            .with_mesh_at(ball(), gold(), [3.0, 0.0, 0.0])
            .with_mesh(Mesh::builtin("cube").unwrap(), library::material("copper").unwrap());
        let materials: Vec<usize> = scene.objects.iter().map(|object| object.material).collect();
        assert_eq!((scene.meshes.len(), materials), (3, vec![0, 0, 1]));
        assert_eq!(scene.bounds().max.x, 4.0);
    }
}
