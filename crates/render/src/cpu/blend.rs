//! Surfaces that let through what is behind them: sorted per pixel, so that the order in which they
//! come does not matter.

use fearless_simd::Simd;
use glanz_math::Lanes;

use super::bins::TILE_WIDTH;
use super::frame::FrameView;
use super::group::{self, Shaded};
use super::raster::Grid;
use super::records::Records;
use super::runs::Run;
use super::target::TilePixels;

/// A pixel that a blended triangle covers in front of all that is opaque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fragment {
    /// Its place in the tile.
    pub pixel: u32,
    pub depth: f32,
    /// The triangle's name, by which equal depths are decided.
    pub name: u32,
    pub record: u32,
    /// The share of the pixel's samples that it covers.
    pub weight: f32,
}

/// Joins the fragments of several samples of the same pixel; all from `start` on are one triangle's.
pub(crate) fn join_samples(fragments: &mut Vec<Fragment>, start: usize) {
    fragments[start..].sort_unstable_by_key(|fragment| fragment.pixel);
    let mut kept = start;
    for i in start + 1..fragments.len() {
        if fragments[i].pixel == fragments[kept].pixel {
            fragments[kept].weight += fragments[i].weight;
            fragments[kept].depth = fragments[kept].depth.max(fragments[i].depth);
        } else {
            kept += 1;
            fragments[kept] = fragments[i];
        }
    }
    fragments.truncate((kept + 1).min(fragments.len()));
}

/// Shades the fragments, sixteen at a time, and lays them over the tile from the farthest to the
/// nearest.
#[inline(always)]
pub(crate) fn blend<S: Simd>(
    simd: S,
    frame: &FrameView,
    records: &Records,
    grid: &Grid,
    fragments: &mut [Fragment],
    pixels: &mut TilePixels,
) {
    fragments.sort_unstable_by(|a, b| {
        let order = a.pixel.cmp(&b.pixel).then(a.depth.total_cmp(&b.depth));
        order.then(b.name.cmp(&a.name)).then(a.record.cmp(&b.record))
    });
    for sixteen in fragments.chunks(16) {
        let (mut px, mut py) = ([0.0; 16], [0.0; 16]);
        let mut runs = [Run { record: 0, bits: 0 }; 16];
        for (lane, fragment) in sixteen.iter().enumerate() {
            let pixel = fragment.pixel as usize;
            px[lane] = (grid.origin[0] + pixel % TILE_WIDTH) as f32 + 0.5;
            py[lane] = (grid.origin[1] + pixel / TILE_WIDTH) as f32 + 0.5;
            runs[lane] = Run { record: fragment.record, bits: 1 << lane };
        }
        let place = [Lanes::load(simd, &px), Lanes::load(simd, &py)];
        let mut shaded = Shaded::nothing(simd);
        group::shade(simd, frame, records, &runs[..sixteen.len()], place, &mut shaded);
        let mut rgb = [[0.0; 16]; 3];
        let mut alpha = [0.0; 16];
        for (array, lanes) in rgb.iter_mut().zip(shaded.rgb) {
            lanes.store(array);
        }
        shaded.alpha.store(&mut alpha);
        for (lane, fragment) in sixteen.iter().enumerate() {
            let color = [rgb[0][lane], rgb[1][lane], rgb[2][lane]];
            pixels.touch(fragment.pixel as usize, frame.options.background);
            over(pixels, fragment.pixel as usize, color, alpha[lane].clamp(0.0, 1.0) * fragment.weight);
        }
    }
}

/// Porter and Duff 1984: lays a straight colour of some opacity over a pixel.
fn over(pixels: &mut TilePixels, pixel: usize, color: [f32; 3], alpha: f32) {
    if alpha <= 0.0 {
        return;
    }
    for (plane, value) in pixels.rgb.iter_mut().zip(color) {
        plane[pixel] = value * alpha + plane[pixel] * (1.0 - alpha);
    }
    pixels.alpha[pixel] = alpha + pixels.alpha[pixel] * (1.0 - alpha);
}
