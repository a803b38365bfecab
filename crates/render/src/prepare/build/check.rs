//! What must hold of a scene before it is prepared.

use glanz_math::names;
use glanz_scene::{Background, LightKind, Material, Scene};

use super::memory;
use crate::prepare::{PrepareError, PrepareOptions};

/// That a scene can be drawn: every index names something, and the background exists, and there is memory for it.
pub(crate) fn check(scene: &Scene, options: &PrepareOptions) -> Result<(), PrepareError> {
    check_references(scene)?;
    check_background(scene)?;
    memory::check_memory(scene, options)
}

/// Where the background is to be the environment, one must be there.
pub(crate) fn check_background(scene: &Scene) -> Result<(), PrepareError> {
    let environment = |light: &glanz_scene::Light| matches!(light.kind, LightKind::Environment { .. });
    if scene.image.background == Background::Environment && !scene.lights.iter().any(environment) {
        let what = "the background is 'environment', but no light of that kind is there".to_owned();
        return Err(PrepareError::Scene { what });
    }
    Ok(())
}

/// Every index of the scene must name something.
fn check_references(scene: &Scene) -> Result<(), PrepareError> {
    for mesh in &scene.meshes {
        mesh.validate().map_err(|source| PrepareError::Mesh { name: mesh.name.clone(), source })?;
    }
    let fail = |what: String| Err(PrepareError::Scene { what });
    for object in &scene.objects {
        if object.mesh >= scene.meshes.len() {
            let (name, number) = (names::shown(&object.name), object.mesh);
            return fail(format!("object '{name}' names mesh {number}, which is not there"));
        }
        if object.material >= scene.materials.len() {
            let (name, number) = (names::shown(&object.name), object.material);
            return fail(format!("object '{name}' names material {number}, which is not there"));
        }
    }
    scene.materials.iter().try_for_each(|material| check_material(scene, material))
}

/// Every texture of a material must be there.
pub(crate) fn check_material(scene: &Scene, material: &Material) -> Result<(), PrepareError> {
    if !has_textures(scene, material) {
        let what = format!("material '{}' names a texture that is not there", names::shown(&material.name));
        return Err(PrepareError::Scene { what });
    }
    Ok(())
}

/// Whether a scene has all textures that a material names.
pub(crate) fn has_textures(scene: &Scene, material: &Material) -> bool {
    material.textures().all(|map| map.texture < scene.textures.len())
}
