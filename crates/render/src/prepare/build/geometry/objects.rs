//! Objects: their clusters, and what moving them changes.

use std::borrow::Cow;
use std::sync::Arc;

use glanz_math::names;
use glanz_scene::{Interpolation, Mesh, Object, Scene, Shading};

use super::closed::is_closed;
use super::clusters::{append, bound, place_vertex};
use super::facets::facets;
use super::placed::Placed;
use super::polygons::polygons;
use crate::prepare::data::geometry::CLUSTER_TRIANGLES;
use crate::prepare::source::ObjectSource;
use crate::prepare::{Attributes, PrepareError, Prepared, PreparedObject};

/// Puts all objects of a scene in place of those that are there.
pub(crate) fn add_objects(prepared: &mut Prepared, scene: &Scene) -> Result<(), PrepareError> {
    prepared.objects.clear();
    prepared.source.objects.clear();
    prepared.geometry = Arc::default();
    prepared.facet_count = 0;
    for object in &scene.objects {
        add_object(prepared, scene, object)?;
        check_clusters(prepared.geometry.clusters.len())?;
    }
    Ok(())
}

/// The most clusters: back ends name a triangle by 24 bits for its cluster and 7 within it.
const MAX_CLUSTERS: usize = 1 << 24;

fn check_clusters(found: usize) -> Result<(), PrepareError> {
    if found <= MAX_CLUSTERS {
        return Ok(());
    }
    let what = format!(
        "expected at most {MAX_CLUSTERS} clusters of triangles, found {found} so far: each object has one for every \
         {CLUSTER_TRIANGLES} triangles or part of them; put small objects together"
    );
    Err(PrepareError::Scene { what })
}

fn add_object(prepared: &mut Prepared, scene: &Scene, object: &Object) -> Result<(), PrepareError> {
    check_transform(object)?;
    let options = &prepared.source.options;
    let shading = options.shading.or(object.shading).unwrap_or(scene.render.shading);
    let interpolation = options.interpolation.or(object.interpolation).unwrap_or(scene.render.interpolation);
    let mesh = with_needed_attributes(&scene.meshes[object.mesh], &scene.materials[object.material]);
    let placed = Placed::new(&mesh, object.transform);
    let number = prepared.objects.len() as u32;
    let clusters = append(Arc::make_mut(&mut prepared.geometry), &mesh, &placed, number);
    let first_facet = prepared.facet_count;
    prepared.facet_count += mesh.face_count() as u32;
    prepared.objects.push(PreparedObject {
        material: object.material,
        shading,
        interpolation,
        program: object.program.or(scene.program),
        placement: object.transform.to_cols_array_2d(),
        anchor: placed.anchor.to_array(),
        bounds: placed.bounds.map(|corner| corner.to_array()),
        closed: is_closed(&mesh, &placed),
        clusters,
        attributes: Attributes {
            uv: !mesh.uvs.is_empty(),
            uv2: !mesh.uvs2.is_empty(),
            color: !mesh.colors.is_empty(),
            tangent: !mesh.tangents.is_empty(),
        },
        first_facet,
        facets: (shading == Shading::Flat).then(|| Arc::new(facets(&mesh, &placed))),
        polygons: (interpolation == Interpolation::Scanline).then(|| Arc::new(polygons(&mesh, &placed))),
    });
    let determinant = placed.determinant();
    let completed = match mesh {
        Cow::Owned(mesh) => Some(Arc::new(mesh)),
        Cow::Borrowed(_) => None,
    };
    let vertices = scene.meshes[object.mesh].positions.len();
    prepared.source.objects.push(ObjectSource { mesh: object.mesh, vertices, completed, determinant });
    Ok(())
}

/// Moves an object whose mesh, material and shading are those of before: its own vertices and clusters are made
/// anew, in their places. False where that is not enough, since the transform mirrors as it did not before.
pub(crate) fn move_object(
    prepared: &mut Prepared,
    scene: &Scene,
    number: usize,
) -> Result<bool, PrepareError> {
    let object = &scene.objects[number];
    check_transform(object)?;
    let source = prepared.source.objects[number].clone();
    let mesh = source.completed.as_deref().unwrap_or(&scene.meshes[object.mesh]);
    let placed = Placed::new(mesh, object.transform);
    let determinant = placed.determinant();
    if (determinant < 0.0) != (source.determinant < 0.0) {
        return Ok(false);
    }
    let own = &mut prepared.objects[number];
    let geometry = Arc::make_mut(&mut prepared.geometry);
    for cluster in own.clusters.clone() {
        let mut cluster_data = geometry.clusters[cluster];
        let first = cluster_data.first_vertex as usize;
        let padded = (cluster_data.vertices as usize).next_multiple_of(crate::prepare::VERTEX_ALIGN);
        (first..first + padded).for_each(|vertex| place_vertex(geometry, mesh, &placed, vertex));
        bound(geometry, &mut cluster_data);
        geometry.clusters[cluster] = cluster_data;
    }
    own.placement = object.transform.to_cols_array_2d();
    own.program = object.program.or(scene.program);
    own.anchor = placed.anchor.to_array();
    own.bounds = placed.bounds.map(|corner| corner.to_array());
    // Whether a mesh is closed does not depend on where it is, unless it is flattened.
    if determinant == 0.0 || source.determinant == 0.0 {
        own.closed = is_closed(mesh, &placed);
    }
    own.facets = own.facets.as_ref().map(|_| Arc::new(facets(mesh, &placed)));
    own.polygons = own.polygons.as_ref().map(|_| Arc::new(polygons(mesh, &placed)));
    prepared.source.objects[number].determinant = determinant;
    Ok(true)
}

fn check_transform(object: &Object) -> Result<(), PrepareError> {
    match object.transform.is_finite() {
        true => Ok(()),
        false => Err(PrepareError::Scene {
            what: format!(
                "object '{}' has a transform with numbers that are not finite",
                names::shown(&object.name)
            ),
        }),
    }
}

/// The mesh with normals, and with tangents where the material maps normals or has a lobe that asks for them.
fn with_needed_attributes<'a>(mesh: &'a Mesh, material: &glanz_scene::Material) -> Cow<'a, Mesh> {
    let mut mesh = Cow::Borrowed(mesh);
    if mesh.normals.is_empty() && !mesh.corners.is_empty() {
        mesh = Cow::Owned(mesh.into_owned().with_normals(glanz_scene::Normals::Given));
    }
    if needs_tangents(material) && mesh.tangents.is_empty() && !mesh.uvs.is_empty() {
        mesh = Cow::Owned(mesh.into_owned().with_tangents());
    }
    mesh
}

/// Whether a material maps normals or has a lobe that asks for tangents, by its shape or by a table of factors over it.
pub(crate) fn needs_tangents(material: &glanz_scene::Material) -> bool {
    let asks = |lobe: &glanz_scene::Lobe| {
        lobe.shape.is_anisotropic() || lobe.layers.iter().any(glanz_bsdf::LayerWeight::is_anisotropic)
    };
    material.normal_map.is_some() || material.lobes.iter().any(asks)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_clusters_than_names_are_refused() {
        assert!(check_clusters(MAX_CLUSTERS).is_ok());
        let error = check_clusters(MAX_CLUSTERS + 1).unwrap_err().to_string();
        assert!(error.contains("at most 16777216 clusters"), "{error}");
    }
}
