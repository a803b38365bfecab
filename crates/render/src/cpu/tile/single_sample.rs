//! One sample per pixel: each pixel of a block is what its triangle is, or background.

use fearless_simd::Simd;
use glanz_math::{Lanes, Vec3};

use super::block_pair::{self, MOST, Ready};
use crate::cpu::block::{self, BLOCK};
use crate::cpu::lighting::reflect::reflect_lanes;
use crate::cpu::shading::background::ViewBackground;
use crate::cpu::shading::shade;
use crate::cpu::shading::shade_block::{Place, ShadeBlock, Shaded};
use crate::cpu::shading::triangle_batch;
use crate::cpu::tile::state::{Tile, TileScratch, keep_planes};
use crate::cpu::tile::target::{Codes, Surface};
use crate::cpu::visibility::coverage_layers::Run;
use crate::cpu::visibility::visible::Owners;
use glanz_math::inline::three;

/// Shades all blocks of a tile: straight into codes where these are given, else into the tile's pixels. `PLANES` says
/// whether distance and normals may be asked for: to keep them takes registers.
#[inline(always)]
pub(crate) fn shade<S: Simd, const PLANES: bool>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    mut codes: Option<&mut Codes>,
) {
    let background = ViewBackground::of(tile.frame);
    let mut owners = Owners::default();
    // Those of one triangle wait for their like, and so do those of more.
    let mut waiting: [Option<Ready>; 2] = [None; 2];
    tile.slot.for_each_block(
        #[inline(always)]
        |at| {
            scratch.visible.owners(simd, at, triangle_batch::enough(&scratch.visible, at), &mut owners);
            if block_pair::pays(simd)
                && !tile.blended
                && let Some(block) = ready(tile, scratch, &owners, at)
            {
                let place = &mut waiting[usize::from(block.count > 1)];
                return pair_up(simd, tile, scratch, place, block, &mut codes);
            }
            let mut rgb = [Lanes::splat(simd, 0.0); 3];
            if owners.count > 0 {
                rgb = colors::<S, PLANES>(simd, tile, scratch, &mut owners, at);
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
    for last in waiting.into_iter().flatten() {
        shade_pair(simd, tile, scratch, &[last; 2], &mut codes);
    }
}

/// Shades a block with the one that waits if they are of one object; otherwise it waits in its place.
#[inline(always)]
fn pair_up<S: Simd>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    place: &mut Option<Ready>,
    block: Ready,
    codes: &mut Option<&mut Codes>,
) {
    let Some(first) = place.take() else {
        *place = Some(block);
        return;
    };
    let fits = first.object == block.object;
    let second = if fits { block } else { first };
    shade_pair(simd, tile, scratch, &[first, second], codes);
    if !fits {
        *place = Some(block);
    }
}

/// Shades two blocks of an object: into codes where these are given, else into the tile's pixels.
#[inline(always)]
fn shade_pair<S: Simd>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    blocks: &[Ready; 2],
    codes: &mut Option<&mut Codes>,
) {
    let TileScratch { setups, pixels, .. } = scratch;
    match codes {
        Some(codes) => block_pair::shade(simd, tile, setups, blocks, *codes),
        None => block_pair::shade(simd, tile, setups, blocks, pixels),
    }
}

/// The block, if it shows few triangles and nothing else, all of one object of the commonest kind.
#[inline(always)]
fn ready(tile: &Tile, scratch: &mut TileScratch, owners: &Owners, at: usize) -> Option<Ready> {
    let Tile { frame, projected, .. } = *tile;
    let few = (1..=MOST).contains(&owners.count) && owners.all && owners.bits == 0xffff;
    if !few || owners.count > 1 && triangle_batch::pays(owners) {
        return None;
    }
    let all = &owners.runs[..owners.count];
    let object = scratch.visible.object(frame, all[0].setup);
    let view = &frame.objects[object];
    let same = all[1..].iter().all(|run| scratch.visible.object(frame, run.setup) == object);
    if !same || !view.simple || frame.loops[view.material].is_none() {
        return None;
    }
    let mut runs = [Run { setup: 0, bits: 0 }; MOST];
    for (own, run) in runs.iter_mut().zip(all) {
        own.setup = scratch.visible.record(frame, projected, &mut scratch.setups, run.setup);
        own.bits = run.bits;
    }
    Some(Ready { at, object, runs, count: owners.count })
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
    let background = ViewBackground::of(tile.frame);
    if covered == 0 && !tile.blended {
        return;
    }
    if covered == 0 {
        scratch.pixels.touch(simd, &background, &tile.grid, at);
    }
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

/// The colours of a block; where no surface is, any.
#[inline(always)]
fn colors<S: Simd, const PLANES: bool>(
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
    let simple = object.simple;
    let (located, value);
    let batched = simple
        && triangle_batch::pays(owners)
        && scratch.triangle_batch.fetch(frame, projected, &scratch.visible, owners, at, number);
    if batched {
        let rows = scratch.triangle_batch.rows(simd, frame, object);
        (located, value) = ShadeBlock::bare(simd, frame, &scratch.setups, object, place).locate(&rows);
    } else {
        if !owners.all {
            scratch.visible.owners(simd, at, BLOCK, owners);
        }
        let runs = &mut owners.runs[..owners.count];
        scratch.visible.set_up(frame, projected, &mut scratch.setups, runs);
        let list = &scratch.setups.list;
        if !simple || runs.iter().any(|run| list[run.setup as usize].object as usize != number) {
            let mut own = [Lanes::splat(simd, 0.0); 3];
            any_colors(simd, tile, scratch, runs, at, &mut own);
            return [own[0], own[1], own[2]];
        }
        let mut shade_block = ShadeBlock::bare(simd, frame, &scratch.setups, object, place);
        shade_block.runs = runs;
        (located, value) = match runs.len() {
            1 => shade_block.locate(&[shade_block.splat(0), shade_block.splat(1)]),
            _ => shade_block.locate(&[shade_block.gather(0), shade_block.gather(1)]),
        };
    }
    let bare = ShadeBlock::bare(simd, frame, &scratch.setups, object, place);
    let (rgb, normal) = located_colors(&bare, located, value);
    if PLANES && tile.keeps_planes() {
        let surface = Surface { distance: located.distance, normal, object: number as u32 + 1 };
        scratch.pixels.put_planes(at, &surface, owners.bits);
    }
    rgb
}

/// Colours and normals of a simple object whose pixels are located and have their first attribute group.
#[inline(always)]
fn located_colors<S: Simd>(
    shade_block: &ShadeBlock<S>,
    located: Place<S>,
    value: [Lanes<S>; 3],
) -> ([Lanes<S>; 3], Vec3<Lanes<S>>) {
    let ShadeBlock { frame, object, .. } = *shade_block;
    let Some(classic) = &frame.loops[object.material] else {
        // Variables of their own: what a call writes to lives in memory, for all that it is merged with.
        let (mut own, mut normal) = (value, Vec3::new(value[0], value[1], value[2]));
        simple_colors(shade_block, located, &mut own, &mut normal);
        return ([own[0], own[1], own[2]], Vec3::new(normal.x, normal.y, normal.z));
    };
    shade_block.simple(
        &frame.materials[object.material],
        &located,
        value,
        #[inline(always)]
        |point| classic.reflect(point),
    )
}

/// [`ShadeBlock::simple`] for any material; `value` becomes the colours.
#[inline(never)]
fn simple_colors<S: Simd>(
    shade_block: &ShadeBlock<S>,
    place: Place<S>,
    value: &mut [Lanes<S>; 3],
    normal: &mut Vec3<Lanes<S>>,
) {
    let ShadeBlock { simd, frame, object, .. } = *shade_block;
    let material = &frame.materials[object.material];
    simd.vectorize(
        #[inline(always)]
        || {
            (*value, *normal) = shade_block.simple(
                material,
                &place,
                *value,
                #[inline(always)]
                |point| reflect_lanes(simd, &frame.lights, material, point, None),
            );
        },
    );
}

/// The colours of a block of any kind; keeps the planes that are asked for.
#[inline(never)]
fn any_colors<S: Simd>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    runs: &[Run],
    at: usize,
    out: &mut [Lanes<S>; 3],
) {
    simd.vectorize(
        #[inline(always)]
        || {
            let place = block::coordinates(simd, &tile.grid, at, [0.5, 0.5]);
            let mut shaded = Shaded::nothing(simd);
            shade::shade(simd, tile.frame, &scratch.setups, runs, place, &mut shaded);
            if tile.keeps_planes() {
                scratch.pixels.touch(simd, &ViewBackground::of(tile.frame), &tile.grid, at);
                keep_planes(simd, &mut scratch.pixels, &scratch.setups, &shaded, runs, at);
            }
            *out = shaded.rgb;
        },
    )
}
