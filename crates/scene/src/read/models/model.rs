//! What a reader returns.

use std::ops::Range;

use glam::DMat4;

use crate::{Camera, Light, LightKind, Material, Mesh, Object, Scene, Texture};

/// All that a file holds, with indices that count from zero within it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Meshes, each valid after [`Mesh::validate`].
    pub meshes: Vec<Mesh>,
    /// Decoded textures.
    pub textures: Vec<Texture>,
    /// Materials; at least one where there are objects.
    pub materials: Vec<Material>,
    /// Meshes put in place.
    pub objects: Vec<Object>,
    /// Lights, in the space of the model.
    pub lights: Vec<Light>,
    /// Cameras with their names, in the space of the model.
    pub cameras: Vec<(String, Camera)>,
    /// The names of the variants of its materials, one of which a reader is asked for
    /// ([`ReadOptions::variant`](super::super::ReadOptions::variant)).
    pub variants: Vec<String>,
    /// What was ignored or mapped approximately, in words for people.
    pub notes: Vec<String>,
}

impl Model {
    /// The number of triangles of all objects.
    pub fn triangle_count(&self) -> usize {
        let of_mesh: Vec<usize> = self.meshes.iter().map(Mesh::triangle_count).collect();
        self.objects.iter().fold(0, |sum: usize, object| sum.saturating_add(of_mesh[object.mesh]))
    }

    /// A scene of this model alone, seen by its first camera if it has one. No lights are added to
    /// those of the file.
    pub fn into_scene(self) -> Scene {
        Scene {
            camera: self.cameras.first().map(|(_, camera)| *camera),
            meshes: self.meshes,
            textures: self.textures,
            materials: self.materials,
            lights: self.lights,
            objects: self.objects,
            ..Scene::default()
        }
    }

    /// Puts the model's objects into a scene and returns which ones they are.
    ///
    /// `transform` goes from the model's coordinates to the world's. With `material_override`, an
    /// index in `scene.materials`, all objects get that material and the model's own materials and
    /// textures are left out. The model's lights come along only with `lights`; its cameras never.
    pub fn append_to(
        self,
        scene: &mut Scene,
        transform: DMat4,
        material_override: Option<usize>,
        lights: bool,
    ) -> Range<usize> {
        let (mesh_base, texture_base) = (scene.meshes.len(), scene.textures.len());
        let (material_base, first) = (scene.materials.len(), scene.objects.len());
        scene.meshes.extend(self.meshes);
        if material_override.is_none() {
            scene.textures.extend(self.textures);
            scene.materials.extend(self.materials.into_iter().map(|mut material| {
                material.change_textures(|map| map.texture += texture_base);
                material
            }));
        }
        scene.objects.extend(self.objects.into_iter().map(|object| Object {
            mesh: object.mesh + mesh_base,
            material: material_override.unwrap_or(object.material + material_base),
            transform: transform * object.transform,
            ..object
        }));
        if lights {
            scene.lights.extend(self.lights.into_iter().map(|light| transformed(light, &transform)));
        }
        first..scene.objects.len()
    }
}

/// The light moved by an affine map. Its strength and fading stay as they are.
fn transformed(mut light: Light, transform: &DMat4) -> Light {
    match &mut light.kind {
        LightKind::Ambient => {}
        LightKind::Directional { direction } => *direction = transform.transform_vector3(*direction),
        LightKind::Point { position, .. } => *position = transform.transform_point3(*position),
        LightKind::Spot { position, direction, .. } => {
            *position = transform.transform_point3(*position);
            *direction = transform.transform_vector3(*direction);
        }
        LightKind::Area { position, direction, up, .. } => {
            *position = transform.transform_point3(*position);
            *direction = transform.transform_vector3(*direction);
            *up = transform.transform_vector3(*up);
        }
        // At infinite distance, and no model has any.
        LightKind::Environment { .. } => {}
    }
    if let Some(luminaire) = &mut light.luminaire {
        luminaire.axis = transform.transform_vector3(luminaire.axis);
        luminaire.c0 = transform.transform_vector3(luminaire.c0);
    }
    light
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use glanz_color::Rgb;

    use super::*;
    use crate::{LightColors, TextureUse};

    fn model() -> Model {
        let mut material = Material::default_gray();
        material.base_color = Some(TextureUse::plain(0));
        let kind = LightKind::Directional { direction: DVec3::X };
        Model {
            meshes: vec![Mesh::default()],
            textures: vec![Texture::default()],
            materials: vec![material],
            objects: vec![Object {
                name: String::new(),
                mesh: 0,
                material: 0,
                transform: DMat4::from_translation(DVec3::Y),
                shading: None,
                interpolation: None,
                program: None,
            }],
            lights: vec![Light::new(kind, LightColors::direct(Rgb::gray(1.0)))],
            ..Model::default()
        }
    }

    #[test]
    fn indices_are_moved_when_a_model_is_appended() {
        let mut scene = model().into_scene();
        let added = model().append_to(&mut scene, DMat4::from_scale(DVec3::splat(2.0)), None, true);
        assert_eq!(added, 1..2);
        assert_eq!((scene.objects[1].mesh, scene.objects[1].material), (1, 1));
        assert_eq!(scene.materials[1].base_color.map(|map| map.texture), Some(1));
        assert_eq!(scene.objects[1].transform.w_axis.truncate(), DVec3::new(0.0, 2.0, 0.0));
        assert_eq!(scene.lights[1].kind, LightKind::Directional { direction: DVec3::X * 2.0 });
    }

    #[test]
    fn an_override_leaves_the_materials_of_the_model_out() {
        let mut scene = model().into_scene();
        model().append_to(&mut scene, DMat4::IDENTITY, Some(0), false);
        assert_eq!((scene.materials.len(), scene.textures.len(), scene.lights.len()), (1, 1, 1));
        assert_eq!((scene.objects[1].mesh, scene.objects[1].material), (1, 0));
    }
}
