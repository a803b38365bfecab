//! Views that show something else than light.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real, Vec3};

use crate::cpu::shading::shade_block::{Place, ShadeBlock};
use crate::cpu::shading::texturing::SurfaceAttributes;
use crate::cpu::shading::triangle_setup::GROUP;
use crate::view::DebugView;
use glanz_math::inline::inlined;

/// Half the width of wireframe lines, in pixels.
const LINE: f32 = 0.75;
/// Black, which is the same in the channels of every observer.
const LINE_COLOR: [f32; 3] = [0.0; 3];
const NOT_AN_EDGE: f32 = 1e9;

/// Replaces colour and opacity by what the view shows; leaves them for the shaded ones.
#[inline(always)]
pub(crate) fn replace<S: Simd>(
    shade_block: &ShadeBlock<S>,
    place: &Place<S>,
    rows: &[Lanes<S>; GROUP],
    normal: Vec3<Lanes<S>>,
    extra: &SurfaceAttributes<S>,
    rgb: &mut [Lanes<S>; 3],
    alpha: &mut Lanes<S>,
) {
    let one = shade_block.px.one();
    *rgb = match shade_block.frame.options.show {
        DebugView::Shaded | DebugView::Ambient | DebugView::Diffuse | DebugView::Specular => return,
        DebugView::Wireframe => {
            wireframe(shade_block, place, rows, rgb);
            return;
        }
        DebugView::Normals => {
            let half = shade_block.px.lit(0.5);
            let n = if shade_block.object.shading == glanz_scene::Shading::Phong {
                normal
            } else {
                facing(shade_block)
            };
            [n.x * half + half, n.y * half + half, n.z * half + half]
        }
        DebugView::Depth => [depth(shade_block, place); 3],
        DebugView::Ids => per_run(
            shade_block,
            #[inline(always)]
            |setup| hashed(setup.object),
        ),
        DebugView::Facets => per_run(
            shade_block,
            #[inline(always)]
            |setup| hashed(setup.object.wrapping_mul(0x85eb_ca6b) ^ setup.facet),
        ),
        DebugView::Uv => [extra.uv[0], extra.uv[1], one.zero()],
        DebugView::Lit => {
            let lit = one.zero().lt(rgb[0]);
            [one.select(lit, one.zero()); 3]
        }
    };
    *alpha = one;
}

/// The facet's own normal, from the triangle that the pixel sees.
#[inline(always)]
fn facing<S: Simd>(shade_block: &ShadeBlock<S>) -> Vec3<Lanes<S>> {
    let [x, y, z] = per_run(
        shade_block,
        #[inline(always)]
        |setup| {
            let object = &shade_block.frame.prepared.objects[setup.object as usize];
            let facets = object.facets.as_ref();
            let sign = if setup.back { -1.0 } else { 1.0 };
            facets.map_or([0.0; 3], |f| f.normals[setup.facet as usize].map(|c| c * sign))
        },
    );
    Vec3::new(x, y, z)
}

/// Near is bright: linear from the scene's nearest to its farthest point.
#[inline(always)]
fn depth<S: Simd>(shade_block: &ShadeBlock<S>, place: &Place<S>) -> Lanes<S> {
    let [near, far] = shade_block.frame.camera.range;
    let span = (far - near).max(1e-30);
    let value =
        (shade_block.px.lit(f64::from(far)) - place.distance) * shade_block.px.lit(f64::from(1.0 / span));
    value.clamp(0.0, 1.0) * shade_block.px.lit(0.95) + shade_block.px.lit(0.05)
}

/// A value for each pixel from its record.
#[inline(always)]
fn per_run<S: Simd>(
    shade_block: &ShadeBlock<S>,
    value: impl Fn(&crate::cpu::shading::triangle_setup::TriangleSetup) -> [f32; 3],
) -> [Lanes<S>; 3] {
    let mut lanes = [shade_block.px.zero(); 3];
    for run in shade_block.runs {
        let mask = LanesMask::from_bits(shade_block.simd, run.bits);
        let color = value(shade_block.setup(run));
        for c in 0..3 {
            lanes[c] = Lanes::splat(shade_block.simd, color[c]).select(mask, lanes[c]);
        }
    }
    lanes
}

/// A colour that differs much between neighbouring numbers.
fn hashed(number: u32) -> [f32; 3] {
    let mut x = number.wrapping_add(1).wrapping_mul(0x9e37_79b9);
    x = (x ^ x >> 16).wrapping_mul(0x85eb_ca6b);
    x = (x ^ x >> 13).wrapping_mul(0xc2b2_ae35);
    x ^= x >> 16;
    [x, x >> 8, x >> 16].map(|byte| 0.08 + 0.85 * (byte & 255) as f32 / 255.0)
}

/// Darkens pixels near an edge of a facet. Edges inside a facet, which only its triangulation has, do
/// not count.
#[inline(always)]
fn wireframe<S: Simd>(
    shade_block: &ShadeBlock<S>,
    place: &Place<S>,
    rows: &[Lanes<S>; GROUP],
    rgb: &mut [Lanes<S>; 3],
) {
    let [x0, y0, ux, uy, vx, vy, ..] = *rows;
    let one = place.u.one();
    let (dx, dy) = (shade_block.px - x0, shade_block.py - y0);
    let u = dx * ux + dy * uy;
    let v = dx * vx + dy * vy;
    let length = inlined(
        #[inline(always)]
        |x: Lanes<S>, y: Lanes<S>| (x.sqr() + y.sqr()).max(one.lit(1e-30)).sqrt(),
    );
    // Distance in pixels from the edges opposite to the corners.
    let distances = [(one - u - v) / length(ux + vx, uy + vy), u / length(ux, uy), v / length(vx, vy)];
    let is_edge = per_run(
        shade_block,
        #[inline(always)]
        |setup| [0, 1, 2].map(|edge| if setup.outline >> edge & 1 == 1 { 0.0 } else { NOT_AN_EDGE }),
    );
    let mut nearest = one.lit(f64::from(NOT_AN_EDGE));
    for edge in 0..3 {
        nearest = nearest.min(distances[edge].abs() + is_edge[edge]);
    }
    let line = (one.lit(f64::from(LINE) + 0.5) - nearest).clamp(0.0, 1.0);
    for c in 0..3 {
        rgb[c] = rgb[c] + (one.lit(f64::from(LINE_COLOR[c])) - rgb[c]) * line;
    }
}
