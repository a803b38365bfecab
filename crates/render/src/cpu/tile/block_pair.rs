//! Two whole blocks in step, where one block is one register of the processor.
//!
//! A pixel's formula is one long chain of operations. With half as many lanes to a register a block is two chains, side
//! by side, and the processor works on both; with AVX-512 it is one, and much of the time nothing but waiting. So there
//! two blocks are interpolated, shaded and developed together ([`Twice`]), where each shows few triangles of one object,
//! and nothing else, as most do.

use fearless_simd::Simd;
use glanz_math::{Lanes, Real, Twice, Vec3};
use glanz_scene::Shading;

use crate::cpu::block;
use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::lighting::matte_highlight::MatteHighlight;
use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::point::unit;
use crate::cpu::shading::surface::{interpolated, place};
use crate::cpu::shading::triangle_setup::{GROUP, TriangleSetups};
use crate::cpu::tile::state::Tile;
use crate::cpu::tile::target::{PairTarget, Surface};
use crate::cpu::visibility::coverage_layers::Run;
use glanz_math::inline::three;
use glanz_math::inline::{inlined, nine};

/// The most triangles of a block that waits for another.
pub(crate) const MOST: usize = 4;

/// A block that waits for another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ready {
    /// Where it is in the tile's arrays.
    pub at: usize,
    /// Its object.
    pub object: usize,
    /// The records of its triangles, each with the pixels that show it.
    pub runs: [Run; MOST],
    pub count: usize,
}

/// Whether blocks shall wait for one another.
#[inline(always)]
pub(crate) fn pays<S: Simd>(simd: S) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        matches!(simd.level(), fearless_simd::Level::Avx512(_))
    }
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    {
        let _ = simd;
        false
    }
}

/// Shades two blocks of an object, and puts them into their places.
#[inline(always)]
pub(crate) fn shade<S: Simd>(
    simd: S,
    tile: &Tile,
    setups: &TriangleSetups,
    blocks: &[Ready; 2],
    target: &mut impl PairTarget,
) {
    match blocks.iter().all(|block| block.count == 1) {
        true => shade_here::<S, _, true>(simd, tile, setups, blocks, target),
        false => shade_here::<S, _, false>(simd, tile, setups, blocks, target),
    }
}

/// [`shade`] of blocks that show one triangle each, or of any. A function of its own, so that it is there but once.
#[inline(never)]
fn shade_here<S: Simd, T: PairTarget, const WHOLE: bool>(
    simd: S,
    tile: &Tile,
    setups: &TriangleSetups,
    blocks: &[Ready; 2],
    target: &mut T,
) {
    let object = &tile.frame.objects[blocks[0].object];
    let Some(material) = &tile.frame.loops[object.material] else { return };
    simd.vectorize(
        #[inline(always)]
        || {
            let [px, py] = coordinates(simd, tile, blocks);
            let rows = inlined(
                #[inline(always)]
                |part: usize| match WHOLE {
                    true => splat(simd, setups, blocks, part),
                    false => gather(simd, setups, blocks, part),
                },
            );
            let (rgb, distance, normal) =
                colors(tile.frame, (object, material), [rows(0), rows(1)], [px, py]);
            let surface = Surface { distance, normal, object: blocks[0].object as u32 + 1 };
            target.put_pair(&tile.slot, [blocks[0].at, blocks[1].at], rgb, &surface);
        },
    );
}

/// Colours, distances and normals of pixels from the rows of their place, and of what is interpolated.
#[inline(always)]
fn colors<R: Real>(
    frame: &FrameView,
    (object, material): (&ObjectView, &MatteHighlight),
    [position, attribute]: [[R; GROUP]; 2],
    [px, py]: [R; 2],
) -> ([R; 3], R, Vec3<R>) {
    let [u, v, distance] = place(frame, object, &position, px, py);
    let value = interpolated(&attribute, u, v);
    let mut rgb = value;
    let mut normal = Vec3::new(px.zero(), px.zero(), px.zero());
    if object.shading == Shading::Phong {
        let (position, wo) = frame.camera.unproject(px, py, distance);
        let [x, y, z] = value;
        normal = Vec3::new(x, y, z);
        if !frame.options.raw_normals {
            normal = unit(normal);
        }
        let light = material.reflect(&ShadingPoint::plain(position, normal, wo));
        rgb = three(
            [0, 1, 2],
            #[inline(always)]
            |c| light.textured[c] + light.plain[c],
        );
    }
    let emission = frame.materials[object.material].emission;
    let rgb = three(
        [0, 1, 2],
        #[inline(always)]
        |c| rgb[c] + px.lit(f64::from(emission[c])),
    );
    (rgb, distance, normal)
}

/// Picture coordinates of the pixels' centres.
#[inline(always)]
fn coordinates<S: Simd>(simd: S, tile: &Tile, [a, b]: &[Ready; 2]) -> [Twice<Lanes<S>>; 2] {
    let [ax, ay] = block::coordinates(simd, &tile.grid, a.at, [0.5, 0.5]);
    let [bx, by] = block::coordinates(simd, &tile.grid, b.at, [0.5, 0.5]);
    [Twice(ax, bx), Twice(ay, by)]
}

/// The `part`-th nine floats of the records that each pixel shows.
#[inline(always)]
fn gather<S: Simd>(
    simd: S,
    setups: &TriangleSetups,
    [a, b]: &[Ready; 2],
    part: usize,
) -> [Twice<Lanes<S>>; GROUP] {
    let (a, b) =
        (setups.gather(simd, &a.runs[..a.count], part), setups.gather(simd, &b.runs[..b.count], part));
    nine(
        #[inline(always)]
        |i| Twice(a[i], b[i]),
    )
}

/// [`gather`] where there is one record to a block.
#[inline(always)]
fn splat<S: Simd>(
    simd: S,
    setups: &TriangleSetups,
    [a, b]: &[Ready; 2],
    part: usize,
) -> [Twice<Lanes<S>>; GROUP] {
    let (a, b) = (setups.row(&a.runs[0], part), setups.row(&b.runs[0], part));
    nine(
        #[inline(always)]
        |i| Twice(Lanes::splat(simd, a[i]), Lanes::splat(simd, b[i])),
    )
}
