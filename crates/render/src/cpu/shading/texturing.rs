//! What varies over a surface beside its normal: textures, vertex colours, whole-polygon values.

use fearless_simd::Simd;
use glanz_math::{Lanes, Real, Vec3};
use glanz_scene::{AlphaMode, TextureUse};

use crate::cpu::frame::Layout;
use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::point::unit;
use crate::cpu::lighting::shade_material::ShadeMaterial;
use crate::cpu::shading::polygons::{CORNER, PolygonView};
use crate::cpu::shading::shade_block::{Place, ShadeBlock};
use crate::cpu::shading::triangle_setup::GROUP;
use crate::prepare::{Mipmap, PreparedMaterial};
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// Factors and directions that textures and vertex colours give sixteen pixels.
pub(crate) struct SurfaceAttributes<S: Simd> {
    /// Multiplies the textured lobes: the vertices' colour times the texel.
    pub base: [Lanes<S>; 3],
    /// The texel alone.
    texel: [Lanes<S>; 3],
    /// Multiplies the material's opacity.
    pub alpha: Lanes<S>,
    /// Multiplies the emission.
    pub emission: [Lanes<S>; 3],
    /// Multiplies the roughness.
    pub rough: Lanes<S>,
    /// Multiplies how metallic the surface is.
    pub metal: Lanes<S>,
    pub uv: [Lanes<S>; 2],
    /// What pictures say, by channels of the material.
    pub channels: [Lanes<S>; PreparedMaterial::MOST_CHANNELS],
    tangent: Option<(Vec3<Lanes<S>>, Lanes<S>)>,
    bend: [Lanes<S>; 3],
}

/// Texture coordinates of sixteen pixels, and how far each reaches in them.
type UvSet = ([[f32; 16]; 2], [f32; 16]);

impl<S: Simd> SurfaceAttributes<S> {
    #[inline(always)]
    pub(crate) fn new(like: Lanes<S>) -> Self {
        let (zero, one) = (like.zero(), like.one());
        Self {
            base: [one; 3],
            texel: [one; 3],
            alpha: one,
            emission: [one; 3],
            rough: one,
            metal: one,
            uv: [zero; 2],
            channels: [one; PreparedMaterial::MOST_CHANNELS],
            tangent: None,
            bend: [zero, zero, one],
        }
    }

    /// Reads what the layout has.
    #[inline(always)]
    pub(crate) fn read(
        &mut self,
        shade_block: &ShadeBlock<S>,
        layout: &Layout,
        material: &ShadeMaterial,
        place: &Place<S>,
        rows: &[Lanes<S>; GROUP],
    ) {
        if let Some(color) = layout.color {
            self.base = shade_block.attribute(color, place);
        }
        let mut extra = [shade_block.px.one(); 3];
        if let Some(number) = layout.extra {
            extra = shade_block.attribute(number, place);
            self.alpha = extra[0];
        }
        if let Some(number) = layout.uv {
            let [u, v, _] = shade_block.attribute(number, place);
            self.uv = [u, v];
            let covered = inlined(
                #[inline(always)]
                |number: usize, at: [Lanes<S>; 2]| {
                    let across = shade_block.uv_at(rows, number, 1.0, 0.0);
                    let down = shade_block.uv_at(rows, number, 0.0, 1.0);
                    footprint(at, across, down)
                },
            );
            let first = ([array(u), array(v)], covered(number, [u, v]));
            let second = layout.uv2.map(
                #[inline(always)]
                |number| {
                    let [u, v, _] = shade_block.attribute(number, place);
                    ([array(u), array(v)], covered(number, [u, v]))
                },
            );
            self.sample(shade_block, material, &[first, second.unwrap_or(first)]);
        }
        if let Some(number) = layout.tangent {
            let [x, y, z] = shade_block.attribute(number, place);
            self.tangent = Some((Vec3::new(x, y, z), extra[1]));
        }
    }

    /// Looks all the material's textures up, by the first or second set of coordinates and footprints.
    #[inline(always)]
    fn sample(&mut self, shade_block: &ShadeBlock<S>, material: &ShadeMaterial, sets: &[UvSet; 2]) {
        let textures = &shade_block.frame.prepared.textures;
        let look = inlined(
            #[inline(always)]
            |map: &TextureUse| {
                let (uv, footprint) = &sets[usize::from(map.second_uvs)];
                let columns = lookup(&textures[map.texture], map, uv, footprint);
                columns.map(
                    #[inline(always)]
                    |column| Lanes::load(shade_block.simd, &column),
                )
            },
        );
        if let Some(map) = &material.base_color {
            let [r, g, b, a] = look(map);
            self.texel = [r, g, b];
            for (base, texel) in self.base.iter_mut().zip([r, g, b]) {
                *base = *base * texel;
            }
            if material.alpha_mode != AlphaMode::Opaque {
                self.alpha = self.alpha * a;
            }
        }
        if let Some(map) = &material.emission_map {
            let [r, g, b, _] = look(map);
            self.emission = [r, g, b];
        }
        if let Some(map) = &material.metal_rough_map {
            let [_, rough, metal, _] = look(map);
            (self.rough, self.metal) = (rough, metal);
        }
        let channels = &material.channels[..];
        for (number, own) in channels.iter().enumerate() {
            // The first of several channels of a picture looks it up for all.
            if channels[..number].iter().any(|other| other.map == own.map) {
                continue;
            }
            let columns = look(&own.map);
            for (value, other) in self.channels.iter_mut().zip(channels).skip(number) {
                if other.map == own.map {
                    *value = columns[other.channel as usize];
                }
            }
        }
        if let Some(map) = &material.normal_map {
            let [x, y, z, _] = look(map);
            self.bend = tangent_space_normal([x, y, z], map.scale);
        }
    }

    /// Gives a point what textures say of it: its normal, its roughness, its metal, its masks; and its tangent.
    #[inline(always)]
    pub(crate) fn apply<'a>(&'a self, material: &ShadeMaterial, point: &mut ShadingPoint<'a, Lanes<S>>) {
        point.normal = self.bend(material, point.normal);
        if material.anisotropic {
            point.tangent = self.tangent.map(|(tangent, _)| tangent);
        }
        if material.metal_rough_map.is_some() {
            // The width of a lobe is the square of its roughness.
            (point.alpha_scale, point.metal) = (self.rough.sqr(), self.metal);
        }
        point.channels = &self.channels[..material.channels.len()];
    }

    /// The normal, bent by the normal map.
    #[inline(always)]
    fn bend(&self, material: &ShadeMaterial, normal: Vec3<Lanes<S>>) -> Vec3<Lanes<S>> {
        let (Some((tangent, sign)), true) = (self.tangent, material.normal_map.is_some()) else {
            return normal;
        };
        let tangent = unit(tangent - normal * normal.dot(tangent));
        let bitangent = normal.cross(tangent) * sign;
        let [x, y, z] = self.bend;
        unit(tangent * x + bitangent * y + normal * z)
    }
}

/// The lanes as an array.
#[inline(always)]
fn array<S: Simd>(lanes: Lanes<S>) -> [f32; 16] {
    let mut array = [0.0; 16];
    lanes.store(&mut array);
    array
}

/// The normal that a texel of a normal map stands for, along tangent, bitangent and normal; of any length.
#[inline(always)]
fn tangent_space_normal<S: Simd>([x, y, z]: [Lanes<S>; 3], scale: f32) -> [Lanes<S>; 3] {
    let centered = inlined(
        #[inline(always)]
        |c: Lanes<S>| c + c - c.one(),
    );
    let scale = x.lit(f64::from(scale));
    [centered(x) * scale, centered(y) * scale, centered(z)]
}

/// How far a pixel reaches in texture coordinates, along the longer of its two directions.
#[inline(always)]
fn footprint<S: Simd>(uv: [Lanes<S>; 2], across: [Lanes<S>; 2], down: [Lanes<S>; 2]) -> [f32; 16] {
    let length = inlined(
        #[inline(always)]
        |to: [Lanes<S>; 2]| (to[0] - uv[0]).sqr() + (to[1] - uv[1]).sqr(),
    );
    array(length(across).max(length(down)).sqrt())
}

/// One texture at sixteen places; the four channels.
fn lookup(texture: &Mipmap, map: &TextureUse, uv: &[[f32; 16]; 2], footprint: &[f32; 16]) -> [[f32; 16]; 4] {
    let mut columns = [[0.0; 16]; 4];
    // The transform stretches the footprint as it stretches the coordinates, at most by its longer column.
    let [[ux, vx, _], [uy, vy, _]] = map.transform;
    let stretch = Real::max(ux * ux + uy * uy, vx * vx + vy * vy).sqrt();
    for lane in 0..16 {
        let (u, v) = (uv[0][lane], uv[1][lane]);
        let at = map.transform.map(|[a, b, c]| a * u + b * v + c);
        for (column, value) in columns.iter_mut().zip(texture.sample(at, footprint[lane] * stretch)) {
            column[lane] = value;
        }
    }
    columns
}

/// Replaces what was interpolated over triangles by what the scheme of 1971 gives over whole polygons.
pub(crate) fn scanline<S: Simd>(
    shade_block: &ShadeBlock<S>,
    polygons: &PolygonView,
    values: &mut [[Lanes<S>; 3]; 4],
    extra: &mut SurfaceAttributes<S>,
) {
    let (columns, found) = along_scanlines(shade_block, polygons);
    let mask = glanz_math::LanesMask::from_bits(shade_block.simd, found);
    let lanes = |i: usize, other: Lanes<S>| Lanes::load(shade_block.simd, &columns[i]).select(mask, other);
    let layout = &shade_block.object.layout;
    let (first, plain) = (values[0], values[1]);
    let flat = shade_block.object.shading == glanz_scene::Shading::Flat;
    if !flat {
        values[0] = three([0, 1, 2], |c| {
            let whole = lanes(c, first[c]);
            let separate =
                layout.plain.is_some() || shade_block.object.shading == glanz_scene::Shading::Phong;
            if separate { whole } else { (whole + lanes(3 + c, whole.zero())).select(mask, first[c]) }
        });
        if layout.plain.is_some() {
            values[1] = three([0, 1, 2], |c| lanes(3 + c, plain[c]));
        }
        if layout.mix.is_some() {
            let (second, third) = (values[2], values[3]);
            values[2] = three([0, 1, 2], |c| lanes(12 + c, second[c]));
            values[3] = three([0, 1, 2], |c| lanes(15 + c, third[c]));
        }
    }
    if layout.color.is_some() {
        let (base, texel) = (extra.base, extra.texel);
        extra.base = three([0, 1, 2], |c| {
            let color = lanes(8 + c, base[c].one());
            (color * texel[c]).select(mask, base[c])
        });
    }
}

/// The values that a block's pixels get from their polygons, as columns, and the bits of the pixels that get any.
#[inline(always)]
fn along_scanlines<S: Simd>(
    shade_block: &ShadeBlock<S>,
    polygons: &PolygonView,
) -> ([[f32; 16]; CORNER], u32) {
    let mut columns = [[0.0f32; 16]; CORNER];
    let (px, py) = (array(shade_block.px), array(shade_block.py));
    let mut found = 0u32;
    for run in shade_block.runs {
        let setup = shade_block.setup(run);
        for lane in (0..16).filter(|lane| run.bits >> lane & 1 == 1) {
            if let Some(corner) = polygons.interpolate(setup.facet, setup.back, px[lane], py[lane]) {
                found |= 1 << lane;
                for (column, value) in columns.iter_mut().zip(corner) {
                    column[lane] = value;
                }
            }
        }
    }
    (columns, found)
}
