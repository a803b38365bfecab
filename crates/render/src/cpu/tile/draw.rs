//! One tile: visibility, then interpolation and shading, then out.

use fearless_simd::Simd;

use crate::cpu::frame::FrameView;
use crate::cpu::shading::background::ViewBackground;
use crate::cpu::shading::triangle_setup::Projected;
use crate::cpu::tile::state::{Tile, TilePlace, TileScratch};
use crate::cpu::tile::target::{Band, Slot};
use crate::cpu::tile::{multi_sample, single_sample};

/// Draws a tile into its band.
#[inline(always)]
pub(crate) fn draw<S: Simd>(
    simd: S,
    frame: &FrameView,
    projected: &Projected,
    place: TilePlace,
    scratch: &mut TileScratch,
    band: &mut Band,
) {
    let grid = place.grid(frame);
    let [left, top] = grid.origin;
    let slot = Slot { stride: frame.camera.width, left, top, size: grid.size };
    let behind = (&ViewBackground::of(frame), &grid);
    let chunks = projected.chunks;
    let any = |blended: bool| {
        chunks.iter().any(|chunk| match blended {
            true => !chunk.blended.of(place.column, place.row).is_empty(),
            false => {
                !chunk.solid.of(place.column, place.row).is_empty()
                    || !chunk.points.of(place.column, place.row).is_empty()
            }
        })
    };
    let blended = any(true);
    scratch.pixels.clear();
    if !blended && !any(false) {
        band.write_empty(simd, &mut scratch.pixels, slot, behind);
        return;
    }
    let tile = Tile { frame, projected, grid, slot, blended };
    scratch.see(simd, &tile, place);
    match band {
        Band::Codes(codes) if codes.opaque && tile.is_plain() => {
            single_sample::shade(simd, &tile, scratch, Some(codes));
            return;
        }
        _ if frame.samples.len() == 1 => single_sample::shade(simd, &tile, scratch, None),
        _ if blended => multi_sample::shade_blended(simd, &tile, scratch),
        _ => multi_sample::shade(simd, &tile, scratch),
    }
    band.write(simd, &mut scratch.pixels, slot, behind);
}

impl TileScratch {
    /// Finds what is visible, and shades what lets light through.
    #[inline(always)]
    fn see<S: Simd>(&mut self, simd: S, tile: &Tile, TilePlace { column, row }: TilePlace) {
        let Tile { frame, projected, ref grid, .. } = *tile;
        let Self { visible, setups, transparency, .. } = self;
        setups.clear();
        visible.clear(frame.samples.len());
        for (number, chunk) in projected.chunks.iter().enumerate() {
            for &key in chunk.solid.of(column, row) {
                visible.triangle(simd, frame, projected, setups, grid, (number, key));
            }
            for point in chunk.points.of(column, row) {
                visible.point(point);
            }
        }
        if tile.blended {
            transparency.clear(frame.samples.len());
            for (number, chunk) in projected.chunks.iter().enumerate() {
                for &key in chunk.blended.of(column, row) {
                    transparency.collect(simd, frame, projected, (visible, setups), grid, (number, key));
                }
            }
            transparency.blend(simd, frame, setups, grid);
        }
    }
}
