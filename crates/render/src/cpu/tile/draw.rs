//! One tile: visibility, then interpolation and shading, then out.

use fearless_simd::Simd;

use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::{TILE_WIDTH, columns};
use crate::cpu::geometry::chunk::ChunkOutput;
use crate::cpu::shading::background::ViewBackground;
use crate::cpu::shading::triangle_setup::Projected;
use crate::cpu::tile::state::{Tile, TilePlace, TileScratch};
use crate::cpu::tile::target::{Band, Slot};
use crate::cpu::tile::{multi_sample, single_sample};
use crate::view::Aovs;

/// Draws a tile into its band, or as many as there are in a row in which nothing is; gives their number.
#[inline(always)]
pub(crate) fn draw<S: Simd>(
    simd: S,
    frame: &FrameView,
    projected: &Projected,
    place: TilePlace,
    scratch: &mut TileScratch,
    band: &mut Band,
) -> usize {
    let grid = place.grid(frame);
    let [left, top] = grid.origin;
    let mut slot = Slot { stride: frame.camera.width, left, top, size: grid.size };
    let behind = (&ViewBackground::of(frame), &grid);
    scratch.pixels.clear(frame.options.aovs != Aovs::default());
    if projected.is_empty(place) {
        let right = (place.column + 1..columns(frame.camera.width))
            .find(|&column| !band.fills_empty() || !projected.is_empty(TilePlace { column, ..place }));
        let right = right.unwrap_or(columns(frame.camera.width));
        slot.size[0] = frame.camera.width.min(right * TILE_WIDTH) - left;
        band.write_empty(simd, &mut scratch.pixels, slot, behind);
        return right - place.column;
    }
    let blended = projected.is_blended(place);
    let tile = Tile { frame, projected, grid, slot, blended };
    scratch.see(simd, &tile, place);
    match band {
        Band::Codes(codes) if codes.opaque && tile.is_plain() => {
            single_sample::shade::<S, false>(simd, &tile, scratch, Some(codes));
            return 1;
        }
        _ if frame.samples.len() == 1 => single_sample::shade::<S, true>(simd, &tile, scratch, None),
        _ if blended => multi_sample::shade_blended(simd, &tile, scratch),
        _ => multi_sample::shade(simd, &tile, scratch),
    }
    band.write(simd, &mut scratch.pixels, slot, behind);
    1
}

impl Projected<'_> {
    /// Whether nothing touches a tile.
    fn is_empty(&self, place: TilePlace) -> bool {
        let TilePlace { column, row } = place;
        let empty = |chunk: &ChunkOutput| {
            chunk.solid.of(column, row).is_empty() && chunk.points.of(column, row).is_empty()
        };
        self.chunks.iter().all(empty) && !self.is_blended(place)
    }

    /// Whether anything blended touches a tile.
    fn is_blended(&self, TilePlace { column, row }: TilePlace) -> bool {
        self.chunks.iter().any(|chunk| !chunk.blended.of(column, row).is_empty())
    }
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
