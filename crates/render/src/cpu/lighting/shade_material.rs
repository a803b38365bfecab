//! What the CPU decides once per frame: which materials and lights its fast path serves.

use std::borrow::Cow;
use std::ops::Deref;

use glanz_bsdf::{LayerWeight, Shape};
use glanz_scene::Metalness;

use crate::cpu::lighting::exact::{ExactPoints, Proposal};
use crate::cpu::lighting::inlined_models::is_inlined;
use crate::prepare::{DirectLobe, PreparedMaterial, TintCoordinate};
use crate::view::ExactLighting;
use crate::view::lights::{ViewLight, ViewLights};

/// A material, and how the CPU evaluates it.
pub(crate) struct ShadeMaterial<'a> {
    data: Cow<'a, PreparedMaterial>,
    /// Eligible for the fast path: no layers, no per-pixel roughness, no transmission, inlined shapes.
    pub fast_path: bool,
    /// Of each lobe whether its shape is that of the lobe before, so that its value is known already.
    pub repeats: Vec<bool>,
    /// Whether tables of factors are layers of lobes, so that several lobes look up the same.
    pub has_tables: bool,
    /// Where its lobes send most, if extended lights are found by points.
    pub proposals: Vec<Proposal>,
}

impl<'a> ShadeMaterial<'a> {
    /// The materials of a frame whose extended lights are found by points, or not.
    pub(crate) fn all(materials: Cow<'a, [PreparedMaterial]>, is_exact: bool) -> Vec<Self> {
        let mut all: Vec<Self> = match materials {
            Cow::Borrowed(materials) => materials.iter().map(|data| Self::new(Cow::Borrowed(data))).collect(),
            Cow::Owned(materials) => materials.into_iter().map(|data| Self::new(Cow::Owned(data))).collect(),
        };
        if is_exact {
            all.iter_mut().for_each(|material| material.proposals = Proposal::all(&material.data.lobes));
        }
        all
    }

    fn new(data: Cow<'a, PreparedMaterial>) -> Self {
        let says_more = data.metal_rough_map.is_some()
            || data.occlusion.is_some()
            || data.ambient_metalness != Metalness::Any;
        let fast_path = data.lobes.iter().all(is_simple) && !says_more;
        let like = |a: &DirectLobe, b: &DirectLobe| a.shape == b.shape && a.roughness == b.roughness;
        let pairs = data.lobes.windows(2).map(|pair| like(&pair[0], &pair[1]));
        let repeats = std::iter::once(false).chain(pairs).collect();
        let mut layers = data.lobes.iter().flat_map(|lobe| &lobe.layers);
        let has_tables = layers.any(|layer| matches!(layer, LayerWeight::Table { .. }));
        Self { data, fast_path, repeats, has_tables, proposals: Vec::new() }
    }
}

impl Deref for ShadeMaterial<'_> {
    type Target = PreparedMaterial;
    fn deref(&self) -> &PreparedMaterial {
        &self.data
    }
}

/// Whether the fast path evaluates a lobe. It passes over whole blocks that no light reaches from the front, so
/// light from behind is none of its business.
fn is_simple(lobe: &DirectLobe) -> bool {
    let bare = lobe.layers.is_empty() && lobe.metalness == Metalness::Any && lobe.masks.is_empty();
    // A model of a program's own may say the same of itself, but the loop does not hold it.
    let listed = !matches!(lobe.shape, Shape::Custom(_));
    bare && listed
        && is_inlined(lobe.shape.info())
        && !matches!(lobe.coordinate, TintCoordinate::CoatPath { .. })
}

/// The lights of a frame, and whether the fast path serves them.
pub(crate) struct ShadeLights<'a> {
    view: ViewLights<'a>,
    /// Punctual lights without luminaires and shadows alone.
    pub fast_path: bool,
    /// The points by which extended lights are found, if they are.
    pub exact: Option<ExactPoints>,
}

impl<'a> ShadeLights<'a> {
    pub(crate) fn new(view: ViewLights<'a>, exact: Option<ExactLighting>) -> Self {
        let simple = |light: &ViewLight| {
            matches!(light, ViewLight::Directional { .. } | ViewLight::Point { luminaire: None, .. })
        };
        let fast_path = view.bvh.is_none() && view.list.iter().all(simple);
        let exact = exact.filter(|_| view.list.iter().any(is_extended));
        let exact = exact.map(|exact| ExactPoints::new(exact, &view.list));
        Self { view, fast_path, exact }
    }

    /// With rims of cones as wide as pixels of this width; see [`ViewLights::pixel`].
    pub(crate) fn with_pixel(mut self, pixel: Option<[f32; 2]>) -> Self {
        self.view.pixel = pixel;
        self
    }
}

/// Whether light comes from more than one direction.
fn is_extended(light: &ViewLight) -> bool {
    matches!(light, ViewLight::Area(_) | ViewLight::Environment { .. })
}

impl<'a> Deref for ShadeLights<'a> {
    type Target = ViewLights<'a>;
    fn deref(&self) -> &ViewLights<'a> {
        &self.view
    }
}
