//! From a scene to [`Prepared`].

pub(crate) mod bvh;
pub(crate) mod check;
pub(crate) mod geometry;
pub(crate) mod integrals;
pub(crate) mod lights;
pub(crate) mod materials;
pub(crate) mod means;
pub(crate) mod memory;
pub(crate) mod programs;

use std::sync::Arc;

use glanz_scene::Scene;

use super::color::fill::fill_table;
use super::data::{Mipmap, Prepared};
use super::options::{PrepareError, PrepareOptions};
use super::source::{Colors, Source};

/// Turns a scene into arrays. All work with wavelengths happens here.
///
/// # Errors
/// Where the scene cannot be drawn: an index that names nothing, a number that is not finite, an observer that
/// does not fit the colour mode.
pub fn prepare(scene: &Scene, options: &PrepareOptions) -> Result<Prepared, PrepareError> {
    check::check(scene, options)?;
    let source = Source {
        colors: Arc::new(Colors::of(scene)),
        options: options.clone(),
        first_channel: 0,
        objects: Vec::new(),
    };
    let mut prepared = Prepared {
        textures: textures(scene),
        lights: lights::prepare(&scene.lights)?,
        programs: programs::programs(scene, &options.observation, &[])?,
        source,
        ..Prepared::default()
    };
    fill_table(&mut prepared)?;
    geometry::objects::add_objects(&mut prepared, scene)?;
    if scene.render.shadows {
        prepared.bvh = Some(Arc::new(bvh::bvh(&prepared)?));
    }
    Ok(prepared)
}

/// Decoded textures with their levels.
pub(crate) fn textures(scene: &Scene) -> Vec<Arc<Mipmap>> {
    scene.textures.iter().map(|texture| Arc::new(Mipmap::new(texture))).collect()
}
