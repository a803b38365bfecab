//! Two whole blocks in step, where one block is one register of the processor.
//!
//! A pixel's formula is one long chain of operations. With half as many lanes to a register a block is two chains, side
//! by side, and the processor works on both; with AVX-512 it is one, and much of the time nothing but waiting. So there
//! two blocks are interpolated, shaded and developed together ([`Twice`]), where each shows one triangle throughout, as
//! most do.

use fearless_simd::Simd;
use glanz_math::{Lanes, Real, Twice, Vec3};
use glanz_scene::Shading;

use crate::cpu::block;
use crate::cpu::frame::ObjectView;
use crate::cpu::lighting::matte_highlight::MatteHighlight;
use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::point::unit;
use crate::cpu::shading::surface::{interpolated, place};
use crate::cpu::shading::triangle_setup::{GROUP, TriangleSetups};
use crate::cpu::tile::state::Tile;
use crate::cpu::tile::target::Codes;
use glanz_math::inline::inlined;
use glanz_math::inline::nine;
use glanz_math::inline::three;

/// A block that waits for another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Whole {
    /// Where it is in the tile's arrays.
    pub at: usize,
    /// Its object, and where its triangle's record begins.
    pub object: usize,
    pub offset: usize,
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

/// Shades two blocks of an object, and puts them into their places. A function of its own, so that it is there but once.
#[inline(never)]
pub(crate) fn shade<S: Simd>(
    simd: S,
    tile: &Tile,
    setups: &TriangleSetups,
    blocks: [Whole; 2],
    codes: &mut Codes,
) {
    let object = &tile.frame.objects[blocks[0].object];
    if let Some(material) = &tile.frame.loops[object.material] {
        simd.vectorize(
            #[inline(always)]
            || shade_here(simd, tile, setups, (object, material), blocks, codes),
        );
    }
}

#[inline(always)]
fn shade_here<S: Simd>(
    simd: S,
    tile: &Tile,
    setups: &TriangleSetups,
    (object, material): (&ObjectView, &MatteHighlight),
    blocks: [Whole; 2],
    codes: &mut Codes,
) {
    let frame = tile.frame;
    let [px, py] = coordinates(simd, tile, blocks);
    let [u, v, distance] = place(frame, object, &row(simd, setups, blocks, 0), px, py);
    let value = interpolated(&row(simd, setups, blocks, 1), u, v);
    let mut rgb = value;
    if object.shading == Shading::Phong {
        let (position, wo) = frame.camera.unproject(px, py, distance);
        let [x, y, z] = value;
        let light = material.reflect(&ShadingPoint::plain(position, unit(Vec3::new(x, y, z)), wo));
        rgb = three(
            [0, 1, 2],
            #[inline(always)]
            |c| light.textured[c] + light.plain[c],
        );
    }
    let emission = frame.materials[object.material].emission;
    rgb = three(
        [0, 1, 2],
        #[inline(always)]
        |c| rgb[c] + px.lit(f64::from(emission[c])),
    );
    codes.put_two(&tile.slot, [blocks[0].at, blocks[1].at], rgb);
}

/// Picture coordinates of the pixels' centres.
#[inline(always)]
fn coordinates<S: Simd>(simd: S, tile: &Tile, [a, b]: [Whole; 2]) -> [Twice<Lanes<S>>; 2] {
    let [ax, ay] = block::coordinates(simd, &tile.grid, a.at, [0.5, 0.5]);
    let [bx, by] = block::coordinates(simd, &tile.grid, b.at, [0.5, 0.5]);
    [Twice(ax, bx), Twice(ay, by)]
}

/// The `part`-th nine floats of the blocks' records.
#[inline(always)]
fn row<S: Simd>(
    simd: S,
    setups: &TriangleSetups,
    [a, b]: [Whole; 2],
    part: usize,
) -> [Twice<Lanes<S>>; GROUP] {
    let of = inlined(
        #[inline(always)]
        |block: Whole| -> &[f32; GROUP] {
            let floats = &setups.floats[block.offset + part * GROUP..];
            floats.first_chunk().expect("records hold whole groups")
        },
    );
    let (a, b) = (of(a), of(b));
    nine(
        #[inline(always)]
        |i| Twice(Lanes::splat(simd, a[i]), Lanes::splat(simd, b[i])),
    )
}
