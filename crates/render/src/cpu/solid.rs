//! One sample per pixel: each pixel of a block is what its triangle is, or background.

use fearless_simd::Simd;
use glanz_math::Lanes;

use super::block;
use super::dust;
use super::group::{self, Group, Shaded, is_simple};
use super::reflect::{reflect_classic, reflect_lanes};
use super::runs::Run;
use super::target::Codes;
use super::three;
use super::tile::{Tile, TileScratch, keep_planes};
use super::visible::Owners;

/// Shades all blocks of a tile: straight into codes where these are given, else into the tile's pixels.
#[inline(always)]
pub(crate) fn shade<S: Simd>(simd: S, tile: &Tile, scratch: &mut TileScratch, mut codes: Option<&mut Codes>) {
    let backdrop = tile.frame.backdrop();
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
                rgb = backdrop.behind(simd, rgb, owners.bits, (&tile.grid, at)).0;
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
    let backdrop = tile.frame.backdrop();
    if covered == 0 && !tile.blended {
        return;
    }
    scratch.pixels.touch(simd, &backdrop, &tile.grid, at);
    let (mut rgb, mut alpha) = backdrop.behind(simd, rgb, covered, (&tile.grid, at));
    if tile.blended {
        let through = three(
            [0, 1, 2],
            #[inline(always)]
            |c| Lanes::load(simd, scratch.glass.through(c, at)),
        );
        let light = scratch.glass.light(simd, at);
        rgb = three(
            [0, 1, 2],
            #[inline(always)]
            |c| rgb[c] * through[c] + light[c],
        );
        alpha = alpha * Lanes::load(simd, scratch.glass.through(3, at)) + light[3];
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
    let number = scratch.visible.object(frame, owners.runs[0].record);
    let object = &frame.objects[number];
    let simple = is_simple(object, frame.options.show) && !tile.keeps_planes();
    let (located, value);
    let dusty = simple
        && dust::pays(owners)
        && scratch.dust.fetch(frame, projected, &scratch.visible, owners, at, number);
    if dusty {
        let rows = scratch.dust.rows(simd, frame, object);
        (located, value) = Group::bare(simd, frame, &scratch.records, object, place).locate(&rows);
    } else {
        let runs = &mut owners.runs[..owners.count];
        scratch.visible.set_up(frame, projected, &mut scratch.records, runs);
        let list = &scratch.records.list;
        if !simple || runs.iter().any(|run| list[run.record as usize].object as usize != number) {
            return any_colors(simd, tile, scratch, runs, at);
        }
        let mut group = Group::bare(simd, frame, &scratch.records, object, place);
        group.runs = runs;
        (located, value) = match runs.len() {
            1 => group.locate(&[group.splat(0), group.splat(1)]),
            _ => group.locate(&[group.gather(0), group.gather(1)]),
        };
    }
    let group = Group::bare(simd, frame, &scratch.records, object, place);
    let material = &frame.materials[object.material];
    group
        .simple(
            material,
            &located,
            value,
            #[inline(always)]
            |point| match material.classic && frame.lights.classic {
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
            group::shade(simd, tile.frame, &scratch.records, runs, place, &mut shaded);
            if tile.keeps_planes() {
                scratch.pixels.touch(simd, &tile.frame.backdrop(), &tile.grid, at);
                keep_planes(simd, &mut scratch.pixels, &scratch.records, &shaded, runs, at);
            }
            shaded.rgb
        },
    )
}
