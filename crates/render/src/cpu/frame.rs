//! Everything about a frame that all its tiles share.

use crate::cpu::lighting::matte_highlight::MatteHighlight;
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::cpu::probe::Record;
use crate::cpu::program::{ObjectProgram, Programs};
use crate::cpu::shading::polygons::PolygonView;
use crate::prepare::{Attributes, Prepared, PreparedMaterial, PreparedObject};
use crate::view::camera::ViewCamera;
use crate::view::lights::{ViewLights, pixel_width};
use crate::view::materials::shown_materials;
use crate::view::objects::{Pass, ViewObject};
use crate::view::{DebugView, DrawOptions, View, samples};
use glanz_scene::{AlphaMode, Interpolation, Shading};

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
    /// See [`ViewObject::steep`].
    pub steep: f32,
    pub polygons: Option<PolygonView>,
    /// Whether a program draws it in place of its material.
    pub program: bool,
    /// Whether the program says where its vertices are.
    pub placed_by_program: bool,
    /// Whether the program says how deep its fragments are.
    pub depth_by_program: bool,
    /// Whether its colours need neither textures nor vertex colours nor a special view.
    pub simple: bool,
}

/// Where attribute groups of three values are among an object's interpolated attributes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Light of the second kind ([`crate::cpu::lighting::point::Reflected::plain`]), Gouraud or flat with texture.
    pub plain: Option<usize>,
    /// The first of two groups with light through the second and third spectrum that texels mix; the first
    /// spectrum is in group 0. Gouraud or flat with texture, where texels mix spectra.
    pub mix: Option<usize>,
    /// The normal that is kept beside light which is not found per pixel.
    pub normal: Option<usize>,
    pub uv: Option<usize>,
    /// The second set of texture coordinates.
    pub uv2: Option<usize>,
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
    pub lights: ShadeLights<'a>,
    pub materials: Vec<ShadeMaterial<'a>>,
    /// Of each material the loop for a matte lobe and a highlight, if that is all that it is.
    pub loops: Vec<Option<MatteHighlight>>,
    pub objects: Vec<ObjectView>,
    pub options: &'a DrawOptions,
    /// What a frame holds in place of light, if that is wanted.
    pub record: Option<Record>,
    pub samples: &'static [[i32; 2]],
    pub any_gouraud: bool,
    /// Whether any vertex needs light through three spectra.
    pub any_mix: bool,
    /// The programs of objects that are drawn by such.
    pub programs: Option<Programs<'a>>,
}

impl<'a> FrameView<'a> {
    pub(super) fn new(
        prepared: &'a Prepared,
        view: &View,
        options: &'a DrawOptions,
        programs: Option<Programs<'a>>,
    ) -> Self {
        let camera = ViewCamera::new(prepared, view);
        let lights = ShadeLights::new(ViewLights::new(prepared, &camera, options), options.exact);
        let materials = ShadeMaterial::all(shown_materials(prepared, options.show), options.exact.is_some());
        let loops = materials.iter().map(|material| MatteHighlight::new(material, &lights)).collect();
        let mut objects: Vec<_> = prepared
            .objects
            .iter()
            .map(|object| ObjectView::new(object, &materials, &lights, &camera, options))
            .collect();
        for (number, object) in objects.iter_mut().enumerate() {
            if let Some(program) = programs.and_then(|programs| programs.all.of(number)) {
                object.draw_by(program, materials[object.material].cull_back);
            }
        }
        let any_gouraud = objects.iter().any(|object| object.shading == Shading::Gouraud);
        let is_mixed =
            |object: &ObjectView| object.shading == Shading::Gouraud && object.layout.mix.is_some();
        let any_mix = objects.iter().any(is_mixed);
        let samples = samples::positions(options.samples);
        Self {
            prepared,
            camera,
            lights,
            materials,
            loops,
            objects,
            options,
            record: None,
            samples,
            any_gouraud,
            any_mix,
            programs,
        }
    }

    /// The same with the rims of cones as these options have them.
    pub(super) fn with_rims_of(self, options: &DrawOptions) -> Self {
        let pixel = pixel_width(&self.camera, options);
        Self { lights: self.lights.with_pixel(pixel), ..self }
    }

    /// The same for a frame that holds numbers in place of light; every surface hides what is behind it.
    pub(super) fn recording(self, record: Record) -> Self {
        let mut objects = self.objects;
        for object in &mut objects {
            object.simple = false;
            object.program = false;
            if object.pass == Pass::Blended {
                object.pass = Pass::Opaque;
            }
        }
        Self { objects, record: Some(record), ..self }
    }
}

impl ObjectView {
    fn new(
        object: &PreparedObject,
        materials: &[ShadeMaterial],
        lights: &ShadeLights,
        camera: &ViewCamera,
        options: &DrawOptions,
    ) -> Self {
        let material = &materials[object.material];
        let ViewObject { pass, cull_back, anchor, steep } = ViewObject::new(object, material, camera);
        let scanline = object.interpolation == Interpolation::Scanline;
        let mut view = Self {
            material: object.material,
            shading: object.shading,
            interpolation: object.interpolation,
            pass,
            cull_back,
            layout: Layout::new(object, material, options),
            anchor,
            steep,
            polygons: None,
            program: false,
            placed_by_program: false,
            depth_by_program: false,
            simple: false,
        };
        if let Some(polygons) = object.polygons.as_ref().filter(|_| scanline) {
            view.polygons = Some(PolygonView::new(polygons, object, camera, lights, material));
        }
        view.simple = view.is_simple(options.show);
        view
    }

    /// Lets a program draw it.
    fn draw_by(&mut self, program: &ObjectProgram, cull_back: bool) {
        self.program = true;
        self.placed_by_program = program.places_vertices();
        self.shading = Shading::Phong;
        self.interpolation = Interpolation::Perspective;
        self.polygons = None;
        self.simple = false;
        if self.placed_by_program {
            // Where its back is depends on the program.
            self.cull_back = cull_back;
        }
        self.depth_by_program = program.places_fragments();
        if (program.discards() || self.depth_by_program) && self.pass == Pass::Opaque {
            self.pass = Pass::Masked;
            self.cull_back = cull_back;
        }
    }

    /// Whether no textures, no vertex colours and no special view change its light.
    #[inline(always)]
    pub(super) fn is_simple(&self, show: DebugView) -> bool {
        self.layout.groups == 1
            && self.polygons.is_none()
            && matches!(
                show,
                DebugView::Shaded | DebugView::Diffuse | DebugView::Specular | DebugView::Ambient
            )
    }
}

impl Layout {
    fn new(object: &PreparedObject, material: &PreparedMaterial, options: &DrawOptions) -> Self {
        let mut layout = Self { groups: 1, ..Self::default() };
        let mut group = |wanted: bool| {
            wanted.then(|| {
                layout.groups += 1;
                layout.groups - 1
            })
        };
        let Attributes { uv: has_uv, uv2: has_uv2, color: has_color, tangent: has_tangent } =
            object.attributes;
        let per_pixel = object.shading == Shading::Phong;
        let textured = has_uv && material.textures().next().is_some();
        let turned = material.normal_map.is_some() || material.anisotropic;
        let bent = per_pixel && has_uv && has_tangent && turned;
        let plain = group(!per_pixel && textured);
        let mix = group(!per_pixel && textured && material.mix.is_some());
        group(mix.is_some());
        let normal = group(!per_pixel && options.aovs.normal);
        let uv = group(textured || has_uv && options.show == DebugView::Uv);
        let uv2 = group(textured && has_uv2 && material.textures().any(|map| map.second_uvs));
        let color = group(per_pixel && has_color);
        let tangent = group(bent);
        let extra = group(bent || has_color && material.alpha_mode != AlphaMode::Opaque);
        Self { plain, mix, normal, uv, uv2, color, tangent, extra, ..layout }
    }
}
