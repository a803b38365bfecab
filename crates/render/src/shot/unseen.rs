//! Why surfaces are not seen, wherever the camera stands.

use glam::{DMat3, DVec3};
use glanz_scene::{AlphaMode, Camera, Object, Projection, Scene};

/// The sizes of scenes in metres whose facets have normals and areas in `f32`.
const SMALLEST: f64 = 1e-9;
const LARGEST: f64 = 1e37;

/// What all surfaces have in common for which none of them is seen, if it is that.
pub(super) fn reason(scene: &Scene, camera: &Camera) -> Option<&'static str> {
    let is_drawn = |object: &Object| {
        let material = &scene.materials[object.material];
        !(material.opacity <= 0.0 && material.alpha_mode == AlphaMode::Blend)
    };
    let drawn: Vec<&Object> = scene.objects.iter().filter(|object| is_drawn(object)).collect();
    if drawn.is_empty() {
        return Some("nothing is seen: all materials are fully transparent (opacity 0)");
    }
    let is_cut_out = |object: &&Object| {
        let material = &scene.materials[object.material];
        matches!(material.alpha_mode, AlphaMode::Mask { cutoff } if cutoff > material.opacity.max(0.0))
    };
    let all_are_cut_out = drawn.iter().all(is_cut_out);
    let (mut facets, mut backs) = (0_u64, 0_u64);
    for object in drawn {
        let culled = scene.materials[object.material].cull_back;
        for facet in facets_of(scene, object) {
            facets += 1;
            backs += u64::from(culled && is_back(camera, facet));
        }
    }
    let size = scene.bounds().diagonal();
    match (facets, backs) {
        _ if all_are_cut_out => Some(
            "nothing is seen: the alpha of no material reaches its alpha_cutoff; below it nothing is drawn",
        ),
        _ if !(SMALLEST..=LARGEST).contains(&size) => Some(
            "nothing is seen: the scene is smaller than 1e-9 m or larger than 1e37 m, which 32-bit numbers do not hold; \
             scale it",
        ),
        (0, _) => Some("nothing is seen: no facet has an area"),
        (facets, backs) if facets == backs => Some(
            "nothing is seen: all facets show their backs, which their materials do not draw (cull_back, in glTF \
             doubleSided = false); look from the other side",
        ),
        _ => None,
    }
}

/// A corner of each facet with an area, and its normal, in the world.
fn facets_of(scene: &Scene, object: &Object) -> impl Iterator<Item = (DVec3, DVec3)> {
    let mesh = &scene.meshes[object.mesh];
    let mirrored = DMat3::from_mat4(object.transform).determinant() < 0.0;
    let sign = if mirrored { -1.0 } else { 1.0 };
    mesh.triangles().filter_map(move |triangle| {
        let at = |i: u32| object.transform.transform_point3(mesh.positions[i as usize].as_dvec3());
        let [a, b, c] = triangle.map(at);
        let normal = (b - a).cross(c - a) * sign;
        (normal.is_finite() && normal != DVec3::ZERO).then_some((a, normal))
    })
}

fn is_back(camera: &Camera, (point, normal): (DVec3, DVec3)) -> bool {
    let towards = match camera.projection {
        Projection::Perspective { .. } => camera.eye - point,
        Projection::Orthographic { .. } => camera.eye - camera.target,
    };
    normal.dot(towards) <= 0.0
}

#[cfg(test)]
mod tests {
    use glam::DMat4;
    use glanz_scene::{Material, Mesh};

    use super::*;

    fn scene(change: impl Fn(&mut Material), scale: DVec3) -> Scene {
        let mut material = Material::default_gray();
        change(&mut material);
        let mut scene = Scene::new().with_mesh(Mesh::builtin("quad").unwrap(), material);
        scene.objects[0].transform = DMat4::from_scale(scale);
        scene
    }

    fn camera(z: f64, projection: Projection) -> Camera {
        Camera { eye: DVec3::new(0.0, 0.0, z), target: DVec3::ZERO, up: DVec3::Y, projection }
    }

    #[test]
    fn backs_transparency_and_no_area_are_told() {
        let perspective = Projection::Perspective { fov_y: 0.7 };
        let one_sided = |material: &mut Material| material.cull_back = true;
        for projection in [perspective, Projection::Orthographic { height: 4.0 }] {
            let (front, back) = (camera(3.0, projection), camera(-3.0, projection));
            let plain = scene(one_sided, DVec3::ONE);
            assert_eq!(reason(&plain, &front), None);
            assert!(reason(&plain, &back).is_some_and(|why| why.contains("show their backs")));
            // A mirrored object keeps its front.
            let mirrored = scene(one_sided, DVec3::new(-1.0, 1.0, 1.0));
            assert_eq!(reason(&mirrored, &front), None);
            assert!(reason(&mirrored, &back).is_some());
            assert_eq!(reason(&scene(|_| (), DVec3::ONE), &back), None);
        }
        let front = camera(3.0, perspective);
        let clear =
            |material: &mut Material| (material.opacity, material.alpha_mode) = (0.0, AlphaMode::Blend);
        let cut = |material: &mut Material| material.alpha_mode = AlphaMode::Mask { cutoff: 1.5 };
        assert!(reason(&scene(cut, DVec3::ONE), &front).is_some_and(|why| why.contains("alpha_cutoff")));
        assert!(reason(&scene(clear, DVec3::ONE), &front).is_some_and(|why| why.contains("transparent")));
        let flat = DVec3::new(1.0, 0.0, 1.0);
        assert!(reason(&scene(|_| (), flat), &front).is_some_and(|why| why.contains("area")));
        for size in [1e-13, 1e38] {
            let why = reason(&scene(|_| (), DVec3::splat(size)), &front);
            assert!(why.is_some_and(|why| why.contains("smaller than 1e-9 m or larger")), "{size}");
        }
    }
}
