//! Visible triangles, set up for interpolation.
//!
//! A record is a row of floats: nine for the barycentric coordinates and the depth, then nine for each
//! group of three attributes (the values at the first corner, and the differences of the other two from
//! it). So the inner loop reads nothing but rows of numbers.

use glanz_math::{Real, Vec3};
use glanz_scene::Shading;

use crate::cpu::frame::{FrameView, Layout};
use crate::cpu::geometry::chunk::ChunkOutput;
use crate::cpu::geometry::clip::EXTRA;
use crate::cpu::geometry::screen::Screen;
use crate::cpu::lighting::point::unit;
use crate::cpu::lighting::point::{Reflected, ShadingPoint};
use crate::cpu::lighting::reflect::reflect;
use crate::cpu::lighting::shade_material::ShadeMaterial;
use crate::cpu::shading::gouraud::Lit;
use crate::cpu::visibility::raster::Triangle;
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// Floats of a group of three attributes, and of the part that comes before the groups.
pub(crate) const GROUP: usize = 9;

/// What the first pass left.
pub(crate) struct Projected<'a> {
    pub screen: &'a [Screen],
    pub lit: &'a [Lit],
    /// Of objects whose texels mix spectra: light through the second and the third, in place of textured
    /// and plain.
    pub lit_mix: &'a [Lit],
    /// What programs make of vertices, in rows of the frame's stride.
    pub varyings: &'a [f32],
    pub chunks: &'a [ChunkOutput],
}

/// A visible triangle of a tile.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TriangleSetup {
    /// Where its floats begin.
    pub offset: u32,
    pub object: u32,
    /// The facet within its object.
    pub facet: u32,
    /// Which of its edges belong to the facet's outline.
    pub outline: u8,
    pub back: bool,
}

/// The visible triangles of a tile.
#[derive(Debug, Default)]
pub(crate) struct TriangleSetups {
    pub floats: Vec<f32>,
    pub list: Vec<TriangleSetup>,
}

/// A triangle's vertices: numbers in the geometry's arrays and weights of each corner.
struct Corners {
    vertices: [usize; 3],
    weights: Option<[[f32; 3]; 3]>,
}

impl TriangleSetups {
    pub(crate) fn clear(&mut self) {
        self.floats.clear();
        self.list.clear();
    }

    /// Sets a triangle up; returns its number in the list.
    pub(crate) fn add(
        &mut self,
        frame: &FrameView,
        projected: &Projected,
        chunk: usize,
        triangle: &Triangle,
    ) -> u32 {
        let geometry = &frame.prepared.geometry;
        let cluster = &geometry.clusters[(triangle.name >> 7) as usize];
        let number = cluster.first_triangle as usize + (triangle.name & 127) as usize;
        let first = cluster.first_vertex as usize;
        let corners = Corners {
            vertices: three(
                geometry.triangles[number],
                #[inline(always)]
                |v| first + v as usize,
            ),
            weights: (triangle.key & EXTRA != 0)
                .then(|| projected.chunks[chunk].clipped_triangles[(triangle.key & !EXTRA) as usize].weights),
        };
        let (facet, outline) = geometry.facets[number];
        let (position, back) = barycentric(&three(
            triangle.screen,
            #[inline(always)]
            |[x, y, depth, _]| [x, y, depth],
        ));
        let setup = TriangleSetup {
            offset: self.floats.len() as u32,
            object: cluster.object,
            facet,
            outline: if corners.weights.is_some() { 0 } else { outline },
            back,
        };
        self.floats.extend_from_slice(&position);
        match frame.objects[setup.object as usize].program {
            true => self.add_varyings(frame, projected, &setup, &corners, triangle),
            false => self.add_attributes(frame, projected, &setup, &corners),
        }
        self.list.push(setup);
        self.list.len() as u32 - 1
    }

    /// Appends what a program gives its fragments: first 1/w, then three numbers a group.
    #[cold]
    #[inline(never)]
    fn add_varyings(
        &mut self,
        frame: &FrameView,
        projected: &Projected,
        setup: &TriangleSetup,
        corners: &Corners,
        triangle: &Triangle,
    ) {
        let object = setup.object as usize;
        let Some((programs, program)) = frame.programs.and_then(|all| Some((all, all.all.of(object)?)))
        else {
            return;
        };
        let stride = programs.all.stride;
        let float =
            |v: usize, number: usize| projected.varyings.get(v * stride + number).copied().unwrap_or(0.0);
        let inverse_w = match program.places_vertices() {
            true => {
                let at = corners.vertices.map(|v| float(v, 3));
                let whole = |weights: [f32; 3]| (0..3).map(|i| weights[i] * at[i]).sum::<f32>();
                corners.weights.map_or(at, |weights| weights.map(whole)).map(|w| 1.0 / w)
            }
            false if frame.camera.perspective => triangle.screen.map(|[_, _, depth, _]| depth),
            false => [1.0; 3],
        };
        self.floats.extend_from_slice(&differences(&inverse_w.map(|own| [own, 0.0, 0.0])));
        let numbers: Vec<_> = program.numbers().collect();
        for three in numbers.chunks(3) {
            let start = self.floats.len();
            let at = |v: usize| core::array::from_fn(|c| three.get(c).map_or(0.0, |(own, _)| float(v, *own)));
            self.group(corners, at);
            let last: [f32; 3] = at(corners.vertices[2]);
            for (c, (_, how)) in three.iter().enumerate() {
                if *how == glanz_shader::Interpolation::Flat {
                    // The last vertex decides, as in OpenGL.
                    self.floats[start + c] = last[c];
                }
            }
        }
    }

    fn add_attributes(
        &mut self,
        frame: &FrameView,
        projected: &Projected,
        setup: &TriangleSetup,
        corners: &Corners,
    ) {
        let object = &frame.objects[setup.object as usize];
        let layout = &object.layout;
        match object.shading {
            Shading::Phong => {
                let sign = normal_sign(setup, frame.materials[object.material].two_sided);
                let normals = &frame.prepared.geometry.normals;
                self.group(corners, |v| {
                    three(
                        normals[v],
                        #[inline(always)]
                        |c| c * sign,
                    )
                });
            }
            Shading::Gouraud => {
                let side = usize::from(setup.back && !object.cull_back);
                self.add_vertex_light(projected, layout, side, corners);
            }
            Shading::Flat => {
                let lit = flat(frame, setup);
                match (layout.plain, layout.mix) {
                    (Some(_), Some(_)) => lit.mixed().into_iter().for_each(|light| self.constant(light)),
                    (Some(_), None) => lit.plain().into_iter().for_each(|light| self.constant(light)),
                    (None, _) => self.constant(sum(lit.plain())),
                }
            }
        }
        if layout.normal.is_some() {
            self.add_normal(frame, setup, corners);
        }
        self.add_rest(frame, layout, corners);
    }

    /// Appends the normal: that of the facet where light is found for facets, else between those of the vertices.
    fn add_normal(&mut self, frame: &FrameView, setup: &TriangleSetup, corners: &Corners) {
        let object = &frame.prepared.objects[setup.object as usize];
        let sign = normal_sign(setup, frame.materials[object.material].two_sided);
        match &object.facets {
            Some(facets) => self.constant(facets.normals[setup.facet as usize].map(|c| c * sign)),
            None => self.group(corners, |v| frame.prepared.geometry.normals[v].map(|c| c * sign)),
        }
    }

    /// Appends the light of the vertices on one side: what textures multiply and what not, or their sum.
    #[inline(always)]
    fn add_vertex_light(&mut self, projected: &Projected, layout: &Layout, side: usize, corners: &Corners) {
        let lit = |v: usize| projected.lit[v][side];
        match layout.plain {
            Some(_) => {
                self.group(corners, |v| lit(v)[0]);
                self.group(corners, |v| lit(v)[1]);
                if layout.mix.is_some() {
                    self.group(corners, |v| projected.lit_mix[v][side][0]);
                    self.group(corners, |v| projected.lit_mix[v][side][1]);
                }
            }
            None => self.group(corners, |v| sum(lit(v))),
        }
    }

    fn add_rest(&mut self, frame: &FrameView, layout: &Layout, corners: &Corners) {
        let geometry = &frame.prepared.geometry;
        let color = |v: usize| geometry.colors.get(v).copied().unwrap_or([1.0; 4]);
        if layout.uv.is_some() {
            self.group(corners, |v| [geometry.uvs[v][0], geometry.uvs[v][1], 0.0]);
        }
        if layout.uv2.is_some() {
            self.group(corners, |v| [geometry.uvs2[v][0], geometry.uvs2[v][1], 0.0]);
        }
        if layout.color.is_some() {
            self.group(corners, |v| [color(v)[0], color(v)[1], color(v)[2]]);
        }
        if layout.tangent.is_some() {
            self.group(corners, |v| [0, 1, 2].map(|c| geometry.tangents[v][c]));
        }
        if layout.extra.is_some() {
            let sign = |v: usize| geometry.tangents.get(v).map_or(1.0, |t| t[3]);
            self.group(corners, |v| [color(v)[3], sign(v), 0.0]);
        }
    }

    /// Appends a group from its values at the corners.
    #[inline(always)]
    fn group(&mut self, corners: &Corners, value: impl Fn(usize) -> [f32; 3]) {
        let mut at = three(corners.vertices, value);
        if let Some(weights) = &corners.weights {
            let whole = at;
            at = weights.map(|[u, v, w]| {
                core::array::from_fn(|c| whole[0][c] * u + whole[1][c] * v + whole[2][c] * w)
            });
        }
        self.floats.extend_from_slice(&differences(&at));
    }

    fn constant(&mut self, value: [f32; 3]) {
        self.floats.extend_from_slice(&[value[0], value[1], value[2], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    }
}

/// What a normal is multiplied with on the side that is seen; 0 on a back face that is not lit.
#[inline(always)]
fn normal_sign(setup: &TriangleSetup, two_sided: bool) -> f32 {
    match (setup.back, two_sided) {
        (false, _) => 1.0,
        (true, true) => -1.0,
        (true, false) => 0.0,
    }
}

fn sum([a, b]: [[f32; 3]; 2]) -> [f32; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// The values at the first corner, and the differences of the other two from it.
#[inline(always)]
pub(crate) fn differences<R: Real>([a, b, c]: &[[R; 3]; 3]) -> [R; GROUP] {
    let from_first = inlined(
        #[inline(always)]
        |other: &[R; 3]| [other[0] - a[0], other[1] - a[1], other[2] - a[2]],
    );
    let ([b0, b1, b2], [c0, c1, c2]) = (from_first(b), from_first(c));
    [a[0], a[1], a[2], b0, b1, b2, c0, c1, c2]
}

/// From x, y and depth of the corners: the first corner, gradients of the second and third barycentric
/// coordinate on the screen, depth at the first corner and its differences at the others; and whether
/// the triangle shows its back.
#[inline(always)]
pub(crate) fn barycentric<R: Real>([a, b, c]: &[[R; 3]; 3]) -> ([R; GROUP], R::Mask) {
    let (x1, y1) = (b[0] - a[0], b[1] - a[1]);
    let (x2, y2) = (c[0] - a[0], c[1] - a[1]);
    let area = x1 * y2 - y1 * x2;
    // Long and thin triangles that cover samples on the grid of 1/256 pixel may have no area in single precision.
    let inverse = (area.one() / area).select(area.zero().lt(area.abs()), area.zero());
    let rows = [
        a[0],
        a[1],
        y2 * inverse,
        -(x2 * inverse),
        -(y1 * inverse),
        x1 * inverse,
        a[2],
        b[2] - a[2],
        c[2] - a[2],
    ];
    // y runs downwards on the screen: what turns right there is counter-clockwise seen from behind.
    (rows, area.zero().lt(area))
}

/// A facet as it is lit: at its centroid, with its own normal.
struct FlatFacet<'a> {
    frame: &'a FrameView<'a>,
    material: &'a ShadeMaterial<'a>,
    point: ShadingPoint<'a, f32>,
    /// The facet's colour; white where it has none.
    color: [f32; 3],
}

/// The facet of a record; none where there are no facets, which are there wherever shading is flat.
fn flat<'a>(frame: &'a FrameView, setup: &TriangleSetup) -> FlatFacet<'a> {
    let prepared = &frame.prepared.objects[setup.object as usize];
    let material = &frame.materials[prepared.material];
    let facets = prepared.facets.as_ref().expect("objects that are shaded flat have their facets prepared");
    let facet = setup.facet as usize;
    let vector = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z);
    let sign = normal_sign(setup, material.two_sided);
    let position = frame.camera.offset(prepared) + vector(facets.centroids[facet]);
    let camera = &frame.camera;
    let wo = if camera.perspective { unit(-position) } else { vector(camera.back) };
    let normal = vector(facets.normals[facet]) * sign;
    let color = facets.colors.get(facet).map_or([1.0; 3], |color| [color[0], color[1], color[2]]);
    FlatFacet { frame, material, point: ShadingPoint::plain(position, normal, wo).at_means(material), color }
}

impl FlatFacet<'_> {
    fn reflect(&self, texel: Option<[f32; 3]>) -> Reflected<f32> {
        reflect(&self.frame.lights, self.material, &self.point, texel)
    }

    /// What textures multiply, and what they do not.
    fn plain(&self) -> [[f32; 3]; 2] {
        let mixes = self.material.mix.is_some();
        let reflected = self.reflect(mixes.then_some(self.color));
        let mut textured = reflected.textured;
        if !mixes {
            textured.iter_mut().zip(self.color).for_each(|(light, color)| *light *= color);
        }
        [textured, reflected.plain]
    }

    /// What texels mix: through the first spectrum, then what textures do not touch, then through the second
    /// and third.
    fn mixed(&self) -> [[f32; 3]; 4] {
        let [r, g, b] = self.color;
        let first = self.reflect(Some([r, 0.0, 0.0]));
        let [second, third] = [[0.0, g, 0.0], [0.0, 0.0, b]].map(|texel| self.reflect(Some(texel)).textured);
        [first.textured, first.plain, second, third]
    }
}
