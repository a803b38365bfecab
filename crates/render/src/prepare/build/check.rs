//! What must hold of a scene before it is prepared.

use glanz_scene::builtin::MAX_TRIANGLES;
use glanz_scene::{Background, LightKind, Material, Scene};

use crate::prepare::PrepareError;

/// The most pairs of a light and a lobe: each takes 20 bytes in the table of tints.
const MAX_TINTS: u64 = 50_000_000;

/// That a scene can be drawn: every index names something, and the background exists, and it takes no more than there is.
pub(crate) fn check(scene: &Scene) -> Result<(), PrepareError> {
    check_references(scene)?;
    check_background(scene)?;
    check_amounts(scene)
}

/// That a scene has no more triangles and tints than fit into a machine; a short file can ask for any number of them.
fn check_amounts(scene: &Scene) -> Result<(), PrepareError> {
    let of_mesh: Vec<u64> = scene.meshes.iter().map(|mesh| mesh.triangle_count() as u64).collect();
    let triangles = scene.objects.iter().fold(0, |sum: u64, object| sum.saturating_add(of_mesh[object.mesh]));
    if triangles > MAX_TRIANGLES {
        let what = format!("expected at most {MAX_TRIANGLES} triangles in a scene, found {triangles}");
        return Err(PrepareError::Scene { what });
    }
    let lobes: u64 = scene.materials.iter().map(|material| material.lobes.len() as u64 + 1).sum();
    let tints = lobes.saturating_mul(scene.lights.len() as u64 + 1);
    if tints > MAX_TINTS {
        let (lights, materials) = (scene.lights.len(), scene.materials.len());
        let what = format!(
            "expected at most {MAX_TINTS} pairs of a light and a lobe, found {tints}: {lights} lights and {materials} materials"
        );
        return Err(PrepareError::Scene { what });
    }
    Ok(())
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
            return fail(format!("object '{}' names mesh {}, which is not there", object.name, object.mesh));
        }
        if object.material >= scene.materials.len() {
            let number = object.material;
            return fail(format!("object '{}' names material {number}, which is not there", object.name));
        }
    }
    scene.materials.iter().try_for_each(|material| check_material(scene, material))
}

/// Every texture of a material must be there.
pub(crate) fn check_material(scene: &Scene, material: &Material) -> Result<(), PrepareError> {
    if !has_textures(scene, material) {
        let what = format!("material '{}' names a texture that is not there", material.name);
        return Err(PrepareError::Scene { what });
    }
    Ok(())
}

/// Whether a scene has all textures that a material names.
pub(crate) fn has_textures(scene: &Scene, material: &Material) -> bool {
    let maps = [material.base_color, material.normal_map, material.emission_map, material.metal_rough_map];
    maps.iter().flatten().all(|map| map.texture < scene.textures.len())
}
