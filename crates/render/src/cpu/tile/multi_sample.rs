//! Several samples per pixel: what they see is shaded layer by layer and added up.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real};

use crate::cpu::block::{self, BLOCK};
use crate::cpu::geometry::bins::TILE_PIXELS;
use crate::cpu::shading::background::ViewBackground;
use crate::cpu::shading::shade;
use crate::cpu::shading::shade_block::Shaded;
use crate::cpu::tile::state::{Tile, TileScratch, keep_planes};
use crate::cpu::visibility::coverage_layers::{CoverageLayers, Weights};
use crate::cpu::visibility::visible::Owners;
use crate::view::samples::SUBPIXEL;
use glanz_math::inline::three;

/// Shades all blocks of a tile into its pixels.
#[inline(always)]
pub(crate) fn shade<S: Simd>(simd: S, tile: &Tile, scratch: &mut TileScratch) {
    let mut layers = core::mem::take(&mut scratch.layers);
    tile.slot.for_each_block(
        #[inline(always)]
        |at| {
            find_layers(simd, tile, scratch, &mut layers, at);
            if !layers.list.is_empty() {
                shade_layers(simd, tile, scratch, &layers, at);
            }
        },
    );
    scratch.layers = layers;
}

/// The same for tiles with surfaces that let through what is behind them, each channel as much as it may.
#[inline(always)]
pub(crate) fn shade_blended<S: Simd>(simd: S, tile: &Tile, scratch: &mut TileScratch) {
    let mut layers = core::mem::take(&mut scratch.tinted_layers);
    tile.slot.for_each_block(
        #[inline(always)]
        |at| {
            find_layers(simd, tile, scratch, &mut layers, at);
            shade_layers(simd, tile, scratch, &layers, at);
        },
    );
    scratch.tinted_layers = layers;
}

/// Collects what the samples of a block see into layers.
#[inline(always)]
fn find_layers<S: Simd, const C: usize>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    layers: &mut CoverageLayers<C>,
    at: usize,
) {
    let frame = tile.frame;
    let TileScratch { visible, setups, transparency, .. } = scratch;
    let samples = frame.samples.len();
    let fraction = Lanes::splat(simd, 1.0 / samples as f32);
    let mut owners = Owners::default();
    layers.clear();
    for (sample, position) in frame.samples.iter().enumerate() {
        let place = sample * TILE_PIXELS + at;
        visible.owners(simd, place, BLOCK, &mut owners);
        let runs = &mut owners.runs[..owners.count];
        visible.set_up(frame, tile.projected, setups, runs);
        let mut weights = [[0.0; BLOCK]; C];
        for (channel, weights) in weights.iter_mut().enumerate() {
            match tile.blended {
                true => {
                    (Lanes::load(simd, transparency.transmittance(channel, place)) * fraction).store(weights)
                }
                false => fraction.store(weights),
            }
        }
        match frame.options.supersample {
            true => layers.add_sample(runs, &weights, position.map(|s| s as f32 / SUBPIXEL as f32)),
            false => layers.note(runs, &weights),
        }
    }
    layers.pack();
    layers.list.retain(|layer| layer.bits != 0);
}

/// Shades the layers of a block and adds them up with the background and what is blended.
#[inline(always)]
fn shade_layers<S: Simd, const C: usize>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    layers: &CoverageLayers<C>,
    at: usize,
) {
    let background = ViewBackground::of(tile.frame);
    scratch.pixels.touch(simd, &background, &tile.grid, at);
    let (mut sum, mut covered) = sum_layers(simd, tile, scratch, layers, at);
    let (color, alpha) = background.block(simd, &tile.grid, at);
    let open = of_channels(
        &layers.open,
        #[inline(always)]
        |open| Lanes::load(simd, open),
    );
    sum = three(
        [0, 1, 2],
        #[inline(always)]
        |c| sum[c] + open[c] * color[c],
    );
    covered = covered + Lanes::load(simd, &layers.open[C - 1]) * alpha;
    if tile.blended {
        let light = scratch.transparency.light(simd, at);
        sum = three(
            [0, 1, 2],
            #[inline(always)]
            |c| sum[c] + light[c],
        );
        covered = covered + light[3];
    }
    scratch.pixels.put(at, sum, covered);
}

/// The colours of the layers by their weights, and their coverage; keeps the planes that are asked for.
#[inline(always)]
fn sum_layers<S: Simd, const C: usize>(
    simd: S,
    tile: &Tile,
    scratch: &mut TileScratch,
    layers: &CoverageLayers<C>,
    at: usize,
) -> ([Lanes<S>; 3], Lanes<S>) {
    let TileScratch { setups, pixels, .. } = scratch;
    let zero = Lanes::splat(simd, 0.0);
    let mut sum = [zero; 3];
    let mut covered = zero;
    for layer in &layers.list {
        let runs = &layers.runs[layer.runs.clone()];
        let place = block::coordinates(simd, &tile.grid, at, layer.at);
        let mut shaded = Shaded::nothing(simd);
        shade::shade(simd, tile.frame, setups, runs, place, &mut shaded);
        let bits = LanesMask::from_bits(simd, layer.bits);
        let weights = of_channels(
            &layer.weights,
            #[inline(always)]
            |weights| Lanes::load(simd, weights).select(bits, zero),
        );
        sum = three(
            [0, 1, 2],
            // Where the weight is zero the value may be anything, NaN too.
            #[inline(always)]
            |c| (sum[c] + shaded.rgb[c] * weights[c]).select(zero.lt(weights[c]), sum[c]),
        );
        covered = covered + Lanes::load(simd, &layer.weights[C - 1]).select(bits, zero);
        if tile.keeps_planes() {
            keep_planes(simd, pixels, setups, &shaded, runs, at);
        }
    }
    (sum, covered)
}

/// One value for each channel, from one for all or from three and coverage.
#[inline(always)]
fn of_channels<S: Simd, const C: usize>(
    weights: &Weights<C>,
    load: impl Fn(&[f32; BLOCK]) -> Lanes<S>,
) -> [Lanes<S>; 3] {
    three(
        [0, 1, 2],
        #[inline(always)]
        |c: usize| load(&weights[c.min(C - 1)]),
    )
}
