//! What a scene takes of memory once it is prepared and drawn, asked before any of it is taken.
//!
//! The figures are sizes of arrays, and measurements where arrays come and go; docs/SCENE.md has the measurements.

use std::collections::HashMap;

use glanz_math::MemoryBudget;
use glanz_scene::builtin::MAX_TRIANGLES;
use glanz_scene::memory::{environment_bytes, texture_bytes};
use glanz_scene::{ColorMode, LightKind, Material, Mesh, Object, Scene, Shading};

use super::geometry::clusters::vertex_count;
use super::geometry::objects::needs_tangents;
use crate::prepare::color::tint_coordinate::coordinate_of;
use crate::prepare::color::tint_table::rows;
use crate::prepare::data::{Cluster, TintCoordinate};
use crate::prepare::{PrepareError, PrepareOptions};

/// Of each triangle: corners, facet, and its part of a cluster, which has 85 triangles or more in a mesh that shares no vertex.
const TRIANGLE: u64 = 11 + size_of::<Cluster>() as u64 / 85 + 1;
/// What drawing holds of each triangle that is seen. Measured: 37 bytes.
const DRAWING: u64 = 40;
/// Beside it what is held of each at its vertices, or once, with Gouraud and flat shading; Gouraud twice where
/// three spectra are mixed. Measured: 53, 106 and 12 bytes.
const GOURAUD: u64 = 55;
const FLAT: u64 = 14;
/// Beside it with shadows: boxes and all that the builder holds of them, more than what is kept. Measured: 218 bytes.
const SHADOW: u64 = 225;
/// Position, normal and number of a vertex of a cluster.
const VERTEX: u64 = 28;
/// The three channels of an entry of the tint table, and its part of what is there per light and per material. Measured: 13.4 bytes.
const TINT: u64 = 14;
/// What drawing holds of a light and a material, where a loop of its own serves it. Measured with the table: 70 bytes for one lobe.
const LOOP: u64 = 56;
/// The same entry through each of the three spectra that textures and vertex colours mix, but in RGB.
const MIXED: u64 = 36;
/// A tint that depends on an angle: at most 32 terms.
const SERIES: u64 = 24 + 32 * TINT;

/// That a scene can be drawn within the memory of the options, before anything is made of it.
///
/// ```
/// use glanz_math::MemoryBudget;
/// use glanz_render::{PrepareOptions, check_memory};
///
/// let text = "[[objects]]\nmesh = \"sphere\"\n";
/// let scene = glanz_scene::open_str(text, "".as_ref(), &Default::default())?.scene;
/// let little = PrepareOptions { memory: MemoryBudget::of_bytes(1000), ..PrepareOptions::default() };
/// assert!(check_memory(&scene, &little).is_err());
/// assert!(check_memory(&scene, &PrepareOptions::default()).is_ok());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// # Errors
/// If it takes more: what would take how much, and which budget allows it.
pub fn check_memory(scene: &Scene, options: &PrepareOptions) -> Result<(), PrepareError> {
    memory_beside(scene, options).map(|_| ())
}

/// What the chain of an environment takes: the map up to a thousand rows, and levels of at most 512.
fn chain_bytes(width: usize, height: usize) -> u64 {
    let pixels = (width as u64).saturating_mul(height as u64);
    16 * (pixels.min(1024 * 2048) + pixels.saturating_mul(4).saturating_add(100_000).min(2_000_000))
}

/// The budget without what a scene takes of it. The scene must be valid.
///
/// # Errors
/// If it has more triangles than can be drawn, or takes more than there is; a short file can ask for any amount.
pub(crate) fn memory_beside(scene: &Scene, options: &PrepareOptions) -> Result<MemoryBudget, PrepareError> {
    let mut memory = options.memory.whole();
    let textures = scene.textures.iter().map(|texture| texture_bytes(texture.width, texture.height));
    memory.take(format_args!("{} textures", scene.textures.len()), textures.sum())?;
    let maps = scene.lights.iter().filter_map(|light| match &light.kind {
        LightKind::Environment { map: Some(map), .. } => {
            Some(environment_bytes(map.width, map.height).saturating_add(chain_bytes(map.width, map.height)))
        }
        _ => None,
    });
    memory.take("environments", maps.sum())?;
    let (lights, materials) = (scene.lights.len(), scene.materials.len());
    let what = format_args!("the tints of {lights} lights on {materials} materials");
    let mixes_spectra = options.observation.mode() != ColorMode::Rgb;
    memory.take(what, tints(scene, mixes_spectra))?;
    check_triangles(scene, mixes_spectra, &mut memory)?;
    Ok(memory)
}

/// The tint table: an entry for each pair of a light and a lobe, three more where textures mix spectra; and what drawing makes of it.
fn tints(scene: &Scene, mixes_spectra: bool) -> u64 {
    let lights: u64 = scene.lights.iter().map(|light| rows(light) as u64).sum();
    let has_cones = scene.lights.iter().any(|light| matches!(light.kind, LightKind::Spot { .. }));
    let of_material = |material: &Material| {
        let (lobes, is_curve) = (&material.lobes, |lobe| coordinate_of(lobe) != TintCoordinate::None);
        let series = if lobes.iter().any(is_curve) { SERIES } else { 0 };
        let of_lobe = TINT + if mixes_spectra { MIXED } else { 0 } + series;
        let of_light = LOOP + if has_cones { 2 * MIXED } else { 0 };
        (lobes.len() as u64).saturating_mul(of_lobe).saturating_add(of_light).saturating_mul(lights)
    };
    scene.materials.iter().map(of_material).fold(0, u64::saturating_add)
}

/// Triangles and their shadows. Vertices of clusters are counted one by one only where the most that they can
/// be matters.
fn check_triangles(
    scene: &Scene,
    mixes_spectra: bool,
    memory: &mut MemoryBudget,
) -> Result<(), PrepareError> {
    let triangles_of = |number: usize| scene.meshes[number].triangle_count() as u64;
    let numbers = || scene.objects.iter().map(|object| object.mesh);
    let triangles = numbers().map(triangles_of).fold(0, u64::saturating_add);
    if triangles > MAX_TRIANGLES {
        let what = format!("expected at most {MAX_TRIANGLES} triangles in a scene, found {triangles}");
        return Err(PrepareError::Scene { what });
    }
    let meshes: u64 = scene.meshes.iter().map(mesh_bytes).sum();
    let vertex = vertex_bytes(scene);
    let fixed =
        meshes + completed(scene) + triangles * (TRIANGLE + DRAWING + shading_bytes(scene, mixes_spectra));
    let shadows = if scene.render.shadows { triangles * SHADOW } else { 0 };
    let most = fixed.saturating_add(3 * triangles * vertex).saturating_add(shadows);
    if most <= memory.left() / 8 {
        memory.take("triangles", most)?;
        return Ok(());
    }
    let mut known = HashMap::new();
    let count = |number: usize| *known.entry(number).or_insert_with(|| vertex_count(&scene.meshes[number]));
    let vertices: u64 = numbers().map(count).sum();
    memory.take(format_args!("{triangles} triangles"), fixed + vertices * vertex)?;
    memory.take(format_args!("the shadows of {triangles} triangles"), shadows)?;
    Ok(())
}

/// What drawing holds of a triangle beside what it holds of each, by the shading that takes most.
fn shading_bytes(scene: &Scene, mixes_spectra: bool) -> u64 {
    let shading_of = |object: &Object| object.shading.unwrap_or(scene.render.shading);
    let is_any = |shading| scene.objects.iter().any(|object| shading_of(object) == shading);
    match (is_any(Shading::Gouraud), is_any(Shading::Flat)) {
        (true, _) if mixes_spectra => 2 * GOURAUD,
        (true, _) => GOURAUD,
        (false, true) => FLAT,
        (false, false) => 0,
    }
}

/// The arrays of a mesh.
fn mesh_bytes(mesh: &Mesh) -> u64 {
    let arrays = [
        size_of_val(&mesh.positions[..]),
        size_of_val(&mesh.normals[..]),
        size_of_val(&mesh.uvs[..]),
        size_of_val(&mesh.uvs2[..]),
        size_of_val(&mesh.colors[..]),
        size_of_val(&mesh.tangents[..]),
        size_of_val(&mesh.corners[..]),
        size_of_val(&mesh.face_starts[..]),
    ];
    arrays.iter().sum::<usize>() as u64
}

/// Copies of meshes that lack normals or tangents, for each of their objects, and what making one of them takes.
fn completed(scene: &Scene) -> u64 {
    let copies = scene.objects.iter().map(|object| {
        let (mesh, material) = (&scene.meshes[object.mesh], &scene.materials[object.material]);
        let vertices = mesh.positions.len() as u64;
        let normals = if mesh.normals.is_empty() { 12 * vertices } else { 0 };
        let lacks_tangents = needs_tangents(material) && mesh.tangents.is_empty() && !mesh.uvs.is_empty();
        let tangents = if lacks_tangents { 16 * vertices } else { 0 };
        if normals + tangents > 0 { mesh_bytes(mesh) + normals + tangents } else { 0 }
    });
    let (sum, most) =
        copies.fold((0_u64, 0), |(sum, most), bytes| (sum.saturating_add(bytes), bytes.max(most)));
    sum.saturating_add(most)
}

/// A vertex of a cluster: all have what any mesh has.
fn vertex_bytes(scene: &Scene) -> u64 {
    let any = |has: &dyn Fn(&Mesh) -> bool| scene.meshes.iter().any(has);
    let tangents = any(&|mesh| !mesh.tangents.is_empty()) || scene.materials.iter().any(needs_tangents);
    let optional = [
        (any(&|mesh| !mesh.uvs.is_empty()), 8),
        (any(&|mesh| !mesh.uvs2.is_empty()), 8),
        (any(&|mesh| !mesh.colors.is_empty()), 16),
        (tangents, 16),
    ];
    VERTEX + optional.iter().filter(|(is_there, _)| *is_there).map(|(_, bytes)| bytes).sum::<u64>()
}
