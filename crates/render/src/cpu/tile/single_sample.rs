//! One sample per pixel: each pixel of a block is what its triangle is, or background.

use fearless_simd::Simd;
use glanz_math::Lanes;

use crate::cpu::block;
use crate::cpu::lighting::reflect::{reflect_classic, reflect_lanes};
use crate::cpu::shading::shade_block::{self, ShadeBlock, Shaded, is_simple};
use crate::cpu::shading::triangle_batch;
use crate::cpu::tile::draw::{Tile, TileScratch, keep_planes};
use crate::cpu::tile::target::Codes;
use crate::cpu::visibility::coverage_layers::Run;
use crate::cpu::visibility::visible::Owners;
use glanz_math::inline::three;

/// Shades all blocks of a tile: straight into codes where these are given, else into the tile's pixels.
#[inline(always)]
pub(crate) fn shade<S: Simd>(simd: S, tile: &Tile, scratch: &mut TileScratch, mut codes: Option<&mut Codes>) {
    let background = tile.frame.background();
    let mut owners = Owners::default();
    tile.slot.for_each_block(
        #[inline(always)]
        |at| {
            scratch.visible.owners(simd, at, &mut owners);
            let mut rgb = [Lanes::splat(simd, 0.0); 3];
            if owners.count > 0 {
                rgb = colors(simd, tile, scratch, &mut owners, at);
            }
            let Some(codes) = &mut codes else { return keep(simd, tile, scratch, rgb, owners.bits, at) };
            if owners.count == 0 && codes.put_empty(&tile.slot, at) {
                return;
            }
            if owners.bits != 0xffff {
                rgb = background.behind(simd, rgb, owners.bits, (&tile.grid, at)).0;
            }
            codes.put(&tile.slot, at, rgb);
        },
    );
}

/// Puts a block into the tile's pixels, behind what is blended.
#[inline(always)]
fn keep<S: Simd>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    rgb: [Lanes<S>; 3],
    covered: u32,
    at: usize,
) {
    let background = tile.frame.background();
    if covered == 0 && !tile.blended {
        return;
    }
    scratch.pixels.touch(simd, &background, &tile.grid, at);
    let (mut rgb, mut alpha) = background.behind(simd, rgb, covered, (&tile.grid, at));
    if tile.blended {
        let transmittance = three(
            [0, 1, 2],
            #[inline(always)]
            |c| Lanes::load(simd, scratch.transparency.transmittance(c, at)),
        );
        let light = scratch.transparency.light(simd, at);
        rgb = three(
            [0, 1, 2],
            #[inline(always)]
            |c| rgb[c] * transmittance[c] + light[c],
        );
        alpha = alpha * Lanes::load(simd, scratch.transparency.transmittance(3, at)) + light[3];
    }
    scratch.pixels.put(at, rgb, alpha);
}

/// The colours of a block; where nothing is, any.
#[inline(always)]
fn colors<S: Simd>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    owners: &mut Owners,
    at: usize,
) -> [Lanes<S>; 3] {
    let Tile { frame, projected, .. } = *tile;
    let place = block::coordinates(simd, &tile.grid, at, [0.5, 0.5]);
    let number = scratch.visible.object(frame, owners.runs[0].setup);
    let object = &frame.objects[number];
    let simple = is_simple(object, frame.options.show) && !tile.keeps_planes();
    let (located, value);
    let batched = simple
        && triangle_batch::pays(owners)
        && scratch.triangle_batch.fetch(frame, projected, &scratch.visible, owners, at, number);
    if batched {
        let rows = scratch.triangle_batch.rows(simd, frame, object);
        (located, value) = ShadeBlock::bare(simd, frame, &scratch.setups, object, place).locate(&rows);
    } else {
        let runs = &mut owners.runs[..owners.count];
        scratch.visible.set_up(frame, projected, &mut scratch.setups, runs);
        let list = &scratch.setups.list;
        if !simple || runs.iter().any(|run| list[run.setup as usize].object as usize != number) {
            return any_colors(simd, tile, scratch, runs, at);
        }
        let mut shade_block = ShadeBlock::bare(simd, frame, &scratch.setups, object, place);
        shade_block.runs = runs;
        (located, value) = match runs.len() {
            1 => shade_block.locate(&[shade_block.splat(0), shade_block.splat(1)]),
            _ => shade_block.locate(&[shade_block.gather(0), shade_block.gather(1)]),
        };
    }
    let shade_block = ShadeBlock::bare(simd, frame, &scratch.setups, object, place);
    let material = &frame.materials[object.material];
    shade_block
        .simple(
            material,
            &located,
            value,
            #[inline(always)]
            |point| match material.fast_path && frame.lights.fast_path {
                true => reflect_classic(&frame.lights.list, material, point, None),
                false => reflect_lanes(simd, &frame.lights, material, point, None),
            },
        )
        .0
}

/// The colours of a block of any kind; keeps the planes that are asked for.
#[inline(never)]
fn any_colors<S: Simd>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    runs: &[Run],
    at: usize,
) -> [Lanes<S>; 3] {
    simd.vectorize(
        #[inline(always)]
        || {
            let place = block::coordinates(simd, &tile.grid, at, [0.5, 0.5]);
            let mut shaded = Shaded::nothing(simd);
            shade_block::shade(simd, tile.frame, &scratch.setups, runs, place, &mut shaded);
            if tile.keeps_planes() {
                scratch.pixels.touch(simd, &tile.frame.background(), &tile.grid, at);
                keep_planes(simd, &mut scratch.pixels, &scratch.setups, &shaded, runs, at);
            }
            shaded.rgb
        },
    )
}
