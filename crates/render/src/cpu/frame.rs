//! Everything about a frame that all its tiles share.

use glanz_bsdf::{LightTerm, Shape};
use glanz_scene::{AlphaMode, Interpolation, Shading};

use crate::cpu::shading::background::ViewBackground;
use crate::cpu::shading::polygons::PolygonView;
use crate::prepare::{
    Attributes, DirectLobe, LobeIntegrals, MixTints, PreparedLight, PreparedMaterial, PreparedObject,
    TintSeries,
};
use crate::view::camera::ViewCamera;
use crate::view::lights::ViewLights;
use crate::view::samples;
use crate::{DebugView, DrawOptions, Prepared, View};

/// How a triangle of an object takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pass {
    /// Hides what is behind it.
    Opaque,
    /// Hides where its texture is opaque enough.
    Masked,
    /// Lets through what is behind it.
    Blended,
}

/// An object seen from the eye.
#[derive(Clone, Debug)]
pub(crate) struct ObjectView {
    pub material: usize,
    pub shading: Shading,
    pub interpolation: Interpolation,
    pub pass: Pass,
    /// Whether back faces can be dropped.
    pub cull_back: bool,
    pub layout: Layout,
    /// The anchor along right, up and away from the eye.
    pub anchor: [f32; 3],
    pub polygons: Option<PolygonView>,
}

/// Where attribute groups of three values are among an object's interpolated attributes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Light of the second kind ([`crate::cpu::lighting::reflect::Reflected::plain`]), Gouraud or flat with texture.
    pub plain: Option<usize>,
    /// The first of two groups with light through the second and third spectrum that texels mix; the first
    /// spectrum is in group 0. Gouraud or flat with texture, where texels mix spectra.
    pub mix: Option<usize>,
    pub uv: Option<usize>,
    pub color: Option<usize>,
    pub tangent: Option<usize>,
    /// Vertex alpha and tangent sign.
    pub extra: Option<usize>,
    /// The number of groups; group 0 is the normal or the light.
    pub groups: usize,
}

/// What all tiles of a frame share.
pub(crate) struct FrameView<'a> {
    pub prepared: &'a Prepared,
    pub camera: ViewCamera,
    pub lights: ViewLights<'a>,
    pub materials: std::borrow::Cow<'a, [PreparedMaterial]>,
    pub objects: Vec<ObjectView>,
    pub options: &'a DrawOptions,
    pub samples: &'static [[i32; 2]],
    pub any_gouraud: bool,
    /// Whether any vertex needs light through three spectra.
    pub any_mix: bool,
}

impl<'a> FrameView<'a> {
    pub fn new(prepared: &'a Prepared, view: &View, options: &'a DrawOptions) -> Self {
        let camera = ViewCamera::new(prepared, view);
        let lights = ViewLights::new(prepared, &camera, options);
        let materials = shown_materials(prepared, options.show);
        let objects: Vec<_> = prepared
            .objects
            .iter()
            .map(|object| ObjectView::new(object, &materials, &lights, &camera, options.show))
            .collect();
        let any_gouraud = objects.iter().any(|object| object.shading == Shading::Gouraud);
        let is_mixed =
            |object: &ObjectView| object.shading == Shading::Gouraud && object.layout.mix.is_some();
        let any_mix = objects.iter().any(is_mixed);
        let samples = samples::positions(options.samples);
        Self { prepared, camera, lights, materials, objects, options, samples, any_gouraud, any_mix }
    }
}

impl FrameView<'_> {
    /// What is where nothing is.
    #[inline(always)]
    pub fn background(&self) -> ViewBackground<'_> {
        ViewBackground::new(
            self.options.background,
            &self.camera,
            &self.lights,
            self.prepared.environment_tint,
        )
    }
}

impl ObjectView {
    fn new(
        object: &PreparedObject,
        materials: &[PreparedMaterial],
        lights: &ViewLights,
        camera: &ViewCamera,
        show: DebugView,
    ) -> Self {
        let material = &materials[object.material];
        let pass = match material.alpha_mode {
            _ if material.transmittance.is_some() => Pass::Blended,
            AlphaMode::Opaque => Pass::Opaque,
            AlphaMode::Mask { .. } => Pass::Masked,
            AlphaMode::Blend => Pass::Blended,
        };
        let hidden = object.closed && pass == Pass::Opaque && camera.is_outside(object);
        let scanline = object.interpolation == Interpolation::Scanline;
        let mut view = Self {
            material: object.material,
            shading: object.shading,
            interpolation: object.interpolation,
            pass,
            cull_back: material.cull_back || hidden,
            layout: Layout::new(object, material, show),
            anchor: camera.anchor(object),
            polygons: None,
        };
        if let Some(polygons) = object.polygons.as_ref().filter(|_| scanline) {
            view.polygons = Some(PolygonView::new(polygons, object, camera, lights, material));
        }
        view
    }
}

impl Layout {
    fn new(object: &PreparedObject, material: &PreparedMaterial, show: DebugView) -> Self {
        let mut layout = Self { groups: 1, ..Self::default() };
        let mut group = |wanted: bool| {
            wanted.then(|| {
                layout.groups += 1;
                layout.groups - 1
            })
        };
        let Attributes { uv: has_uv, color: has_color, tangent: has_tangent } = object.attributes;
        let per_pixel = object.shading == Shading::Phong;
        let maps =
            [material.base_color, material.normal_map, material.emission_map, material.metal_rough_map];
        let textured = has_uv && maps.iter().any(Option::is_some);
        let turned = material.normal_map.is_some() || material.anisotropic;
        let bent = per_pixel && has_uv && has_tangent && turned;
        let plain = group(!per_pixel && textured);
        let mix = group(!per_pixel && textured && material.mix.is_some());
        group(mix.is_some());
        let uv = group(textured || has_uv && show == DebugView::Uv);
        let color = group(per_pixel && has_color);
        let tangent = group(bent);
        let extra = group(bent || has_color && material.alpha_mode != AlphaMode::Opaque);
        Self { plain, mix, uv, color, tangent, extra, ..layout }
    }
}

/// The materials as the chosen view wants them: all terms, or one, or none but a test for light.
fn shown_materials(prepared: &Prepared, show: DebugView) -> std::borrow::Cow<'_, [PreparedMaterial]> {
    let term = match show {
        DebugView::Ambient => LightTerm::Ambient,
        DebugView::Diffuse => LightTerm::Diffuse,
        DebugView::Specular => LightTerm::Specular,
        DebugView::Lit => {
            let lights = &prepared.lights;
            return prepared.materials.iter().map(|material| lit_test(material, lights)).collect();
        }
        _ => return std::borrow::Cow::Borrowed(&prepared.materials),
    };
    prepared.materials.iter().map(|material| one_term(material, term)).collect()
}

fn one_term(material: &PreparedMaterial, term: LightTerm) -> PreparedMaterial {
    let mut material = material.clone();
    let lobes = material.lobes.len().max(1);
    let mixes = material.mix.is_some();
    let left_out = |i: usize| material.lobes[i % lobes].term != term;
    let mut mix = material.mix.take().unwrap_or_default();
    for i in (0..material.tints.len()).filter(|i| left_out(*i)) {
        material.tints[i] = [0.0; 3];
        mix.tints.get_mut(i).into_iter().for_each(|tint| *tint = Default::default());
        material.series.get_mut(i).into_iter().for_each(|series| *series = TintSeries::default());
    }
    if term != LightTerm::Ambient {
        material.ambient = Default::default();
        material.spot_ambient.clear();
        material.emission = [0.0; 3];
        *mix = MixTints { tints: mix.tints, ..MixTints::default() };
    }
    material.mix = mixes.then_some(mix);
    material
}

/// A material whose value is above zero exactly where some light reaches the front of the surface.
fn lit_test(material: &PreparedMaterial, lights: &[PreparedLight]) -> PreparedMaterial {
    let shape = Shape::named("lambert", &[]).expect("lambert is in the list of models");
    PreparedMaterial {
        lobes: vec![DirectLobe::new(shape)],
        classic: true,
        tints: vec![[1.0; 3]; lights.iter().map(|light| light.shape.rows()).sum()],
        integrals: vec![LobeIntegrals::of_cosine(lights.len())],
        anisotropic: false,
        transmits: false,
        metal_rough_map: None,
        transmittance: None,
        series: Vec::new(),
        ambient: Default::default(),
        spot_ambient: Vec::new(),
        emission: [0.0; 3],
        mix: None,
        base_color: None,
        emission_map: None,
        ..material.clone()
    }
}
