//! From a scene to plain arrays that a back end can loop over or upload.
//!
//! All colour work happens here: what leaves is geometry, lobe shapes and the tint table.

mod build;
mod color;
mod data;

use std::sync::Arc;

use glam::DVec3;
use glanz_bsdf::{MODELS, ParamError, Shape};
use glanz_scene::{Background, Interpolation, LightKind, Mesh, Scene, Shading};
use thiserror::Error;

use build::{closed, geometry, lights, lobe_integrals, materials};
use color::quadrature::Sampling;
use color::tint_table;
use data::mipmap;

pub use build::facets::Facets;
pub use build::geometry::{Cluster, Geometry};
pub use build::lights::{EnvironmentLight, Falloff, LightShape, PreparedLight, PreparedLuminaire};
pub use build::lobe_integrals::LobeIntegrals;
pub(crate) use build::lobe_integrals::is_cosine;
pub use build::ltc::LtcTable;
pub use build::materials::{DirectLobe, MixTints, PreparedMaterial};
pub use build::polygons::Polygons;
pub use color::observation::{Observation, ObservationError, SCREEN_WHITE_CD_M2};
pub use color::tint_coordinate::TintCoordinate;
pub use color::tint_series::TintSeries;
pub use data::bvh::Bvh;
pub use data::environment_map::EnvironmentMap;
pub use data::intensity_grid::IntensityGrid;
pub use data::mipmap::Mipmap;

/// What to change of a scene on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PrepareOptions {
    /// Shading for all objects.
    pub shading: Option<Shading>,
    /// Interpolation for all objects.
    pub interpolation: Option<Interpolation>,
    /// Model for all highlights (the shape of every specular lobe), keeping their shininess.
    pub model: Option<String>,
    /// Colour mode and observer.
    pub observation: Observation,
    /// The first of the three channels of the observation that frames get.
    pub first_channel: usize,
}

/// Why a scene cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PrepareError {
    /// A mesh is malformed.
    #[error("mesh '{name}': {source}")]
    Mesh {
        /// The mesh's name.
        name: String,
        /// What is wrong.
        source: glanz_scene::MeshError,
    },
    /// The model asked for does not exist or does not fit.
    #[error(transparent)]
    Model(#[from] ParamError),
    /// The observer does not fit the colour mode or the scene.
    #[error(transparent)]
    Observation(#[from] ObservationError),
    /// A number of the scene is unusable.
    #[error("{what}")]
    Scene {
        /// Where, and what is expected.
        what: String,
    },
}

/// Which attributes the vertices of an object have beside position and normal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Attributes {
    /// Texture coordinates.
    pub uv: bool,
    /// Colours.
    pub color: bool,
    /// Tangents.
    pub tangent: bool,
}

/// An object, as the rasteriser needs it.
#[derive(Clone, Debug)]
pub struct PreparedObject {
    /// Index in [`Prepared::materials`].
    pub material: usize,
    /// Where the illumination model is evaluated.
    pub shading: Shading,
    /// How values between vertices are found.
    pub interpolation: Interpolation,
    /// The point of the world that vertex positions are relative to.
    pub anchor: DVec3,
    /// Corners of the box around the vertices, relative to the anchor.
    pub bounds: [DVec3; 2],
    /// Whether the mesh is a closed surface seen from outside, so that back faces are never seen
    /// while the eye is outside its box.
    pub closed: bool,
    /// Range of [`Geometry::clusters`].
    pub clusters: core::ops::Range<usize>,
    /// Which attributes its vertices have.
    pub attributes: Attributes,
    /// Number of the object's first facet among all facets.
    pub first_facet: u32,
    /// Facet centroids and normals, where shading is flat.
    pub facets: Option<Arc<Facets>>,
    /// Whole polygons, where interpolation follows scanlines.
    pub polygons: Option<Arc<Polygons>>,
}

/// A scene as plain arrays, ready to draw from any camera.
#[derive(Clone, Debug, Default)]
pub struct Prepared {
    /// The objects that have faces.
    pub objects: Vec<PreparedObject>,
    /// Vertices and triangles of all objects.
    pub geometry: Arc<Geometry>,
    /// Materials, each with its row of the tint table.
    pub materials: Vec<PreparedMaterial>,
    /// Lights that have a direction.
    pub lights: Vec<PreparedLight>,
    /// Decoded, mipmapped textures.
    pub textures: Vec<Arc<Mipmap>>,
    /// The number of facets of all objects.
    pub facet_count: u32,
    /// What each of the three spectra of the first surroundings gives in the channels, seen directly.
    pub environment_tint: Option<[[f32; 3]; 3]>,
    /// What keeps light from surfaces; none where nothing casts a shadow.
    pub bvh: Option<Arc<Bvh>>,
}

impl Prepared {
    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.geometry.triangle_count()
    }
}

/// Turns a scene into arrays. All colour work happens here.
pub fn prepare(scene: &Scene, options: &PrepareOptions) -> Result<Prepared, PrepareError> {
    check_references(scene)?;
    let environment = |light: &glanz_scene::Light| matches!(light.kind, LightKind::Environment { .. });
    if scene.image.background == Background::Environment && !scene.lights.iter().any(environment) {
        let what = "the background is 'environment', but no light of that kind is there".to_owned();
        return Err(PrepareError::Scene { what });
    }
    let lights = lights::prepare(scene)?;
    let (materials, environment_tint) = fill(scene, options, &lights, &[])?;
    let mut prepared = Prepared {
        textures: mipmap::prepare(&scene.textures),
        materials,
        environment_tint,
        lights,
        ..Prepared::default()
    };
    for object in &scene.objects {
        prepared.add_object(scene, object, options)?;
    }
    if scene.render.shadows {
        prepared.bvh = Some(Arc::new(Bvh::new(&prepared)));
    }
    Ok(prepared)
}

/// Materials, and what each of the three spectra of surroundings gives in the channels.
type Filled = (Vec<PreparedMaterial>, Option<[[f32; 3]; 3]>);

/// Every material with its rows of the tint table, and the channels of surroundings that are seen directly.
fn fill(
    scene: &Scene,
    options: &PrepareOptions,
    lights: &[PreparedLight],
    before: &[PreparedMaterial],
) -> Result<Filled, PrepareError> {
    if let Some(model) = &options.model {
        glanz_bsdf::models::info_named(model)?;
    }
    let sampling = Sampling::new(&options.observation, options.first_channel);
    let table = tint_table::Table::new(&sampling, scene);
    let prepare = |material| materials::prepare(material, &table, options.model.as_deref());
    let mut materials = scene.materials.iter().map(prepare).collect::<Result<Vec<_>, _>>()?;
    lobe_integrals::attach(&mut materials, lights, before);
    Ok((materials, table.environment_tint()))
}

impl Prepared {
    /// The same with the tint table filled anew: for other colours of the lights and materials, another
    /// colour mode or another observer. Geometry and textures are shared, not copied.
    ///
    /// `scene` may differ from the one that was prepared in colours only; of it only lights and materials
    /// are read.
    pub fn refilled(&self, scene: &Scene, options: &PrepareOptions) -> Result<Self, PrepareError> {
        lights::check_colors(scene)?;
        let (materials, environment_tint) = fill(scene, options, &self.lights, &self.materials)?;
        Ok(Self { materials, environment_tint, ..self.clone() })
    }
}

impl Prepared {
    fn add_object(
        &mut self,
        scene: &Scene,
        object: &glanz_scene::Object,
        options: &PrepareOptions,
    ) -> Result<(), PrepareError> {
        let source = &scene.meshes[object.mesh];
        let shading = options.shading.or(object.shading).unwrap_or(scene.render.shading);
        let interpolation =
            options.interpolation.or(object.interpolation).unwrap_or(scene.render.interpolation);
        if !object.transform.is_finite() {
            return Err(PrepareError::Scene {
                what: format!("object '{}' has a transform with numbers that are not finite", object.name),
            });
        }
        let mesh = with_needed_attributes(source, &scene.materials[object.material]);
        let placed = geometry::Placed::new(&mesh, object.transform);
        let clusters = Arc::make_mut(&mut self.geometry).append(&mesh, &placed, self.objects.len() as u32);
        let flat = shading == Shading::Flat;
        let scanline = interpolation == Interpolation::Scanline;
        let first_facet = self.facet_count;
        self.facet_count += mesh.face_count() as u32;
        self.objects.push(PreparedObject {
            material: object.material,
            shading,
            interpolation,
            anchor: placed.anchor,
            bounds: placed.bounds,
            closed: closed::is_closed(&mesh, &placed),
            clusters,
            attributes: Attributes {
                uv: !mesh.uvs.is_empty(),
                color: !mesh.colors.is_empty(),
                tangent: !mesh.tangents.is_empty(),
            },
            first_facet,
            facets: flat.then(|| Arc::new(Facets::new(&mesh, &placed))),
            polygons: scanline.then(|| Arc::new(Polygons::new(&mesh, &placed))),
        });
        Ok(())
    }
}

/// The mesh with normals, and with tangents where the material maps normals or has a lobe that asks for them.
fn with_needed_attributes<'a>(
    mesh: &'a Mesh,
    material: &glanz_scene::Material,
) -> std::borrow::Cow<'a, Mesh> {
    let mut mesh = std::borrow::Cow::Borrowed(mesh);
    if mesh.normals.is_empty() && !mesh.corners.is_empty() {
        mesh = std::borrow::Cow::Owned(mesh.into_owned().with_normals(glanz_scene::Normals::Given));
    }
    let turned = |lobe: &glanz_scene::Lobe| lobe.shape.is_anisotropic();
    let asks = material.normal_map.is_some() || material.lobes.iter().any(turned);
    if asks && mesh.tangents.is_empty() && !mesh.uvs.is_empty() {
        mesh = std::borrow::Cow::Owned(mesh.into_owned().with_tangents());
    }
    mesh
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
    for material in &scene.materials {
        let maps =
            [material.base_color, material.normal_map, material.emission_map, material.metal_rough_map];
        if maps.iter().flatten().any(|map| map.texture >= scene.textures.len()) {
            return fail(format!("material '{}' names a texture that is not there", material.name));
        }
    }
    Ok(())
}

/// `shape` with its model replaced by the one called `name`, keeping parameters of the same name.
fn with_model(shape: &Shape, name: &str) -> Result<Shape, ParamError> {
    let kept = shape.info().params.iter().zip(shape.params());
    let target = glanz_bsdf::models::info_named(name)?;
    let set: Vec<(&str, f64)> = kept
        .filter(|(param, _)| target.params.iter().any(|p| p.name == param.name))
        .map(|(param, value)| (param.name, value))
        .collect();
    debug_assert!(MODELS.iter().any(|info| info.name == target.name));
    Shape::named(name, &set)
}
