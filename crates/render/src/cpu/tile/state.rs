//! What drawing a tile reads, and what it keeps.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real};

use crate::cpu::block::{BLOCK, Grid};
use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::{TILE_HEIGHT, TILE_WIDTH};
use crate::cpu::shading::shade_block::Shaded;
use crate::cpu::shading::triangle_batch::TriangleBatch;
use crate::cpu::shading::triangle_setup::{Projected, TriangleSetups};
use crate::cpu::tile::target::{Slot, TilePixels};
use crate::cpu::tile::transparency::TransparencyBuffer;
use crate::cpu::visibility::coverage_layers::{CoverageLayers, Run};
use crate::cpu::visibility::visible::Visible;
use crate::view::Aovs;
use crate::view::samples::SUBPIXEL;

/// Everything that drawing a tile needs beside the frame. Kept by each thread, for its memory.
#[derive(Debug, Default)]
pub(crate) struct TileScratch {
    pub visible: Visible,
    pub setups: TriangleSetups,
    pub layers: CoverageLayers<1>,
    pub tinted_layers: CoverageLayers<4>,
    pub transparency: TransparencyBuffer,
    pub triangle_batch: TriangleBatch,
    pub pixels: TilePixels,
}

/// A tile's number and its part of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TilePlace {
    pub column: usize,
    pub row: usize,
}

impl TilePlace {
    pub(crate) fn grid(self, frame: &FrameView) -> Grid {
        let origin = [self.column * TILE_WIDTH, self.row * TILE_HEIGHT];
        let size = [
            TILE_WIDTH.min(frame.camera.width - origin[0]),
            TILE_HEIGHT.min(frame.camera.height - origin[1]),
        ];
        Grid { origin, size, sample: [SUBPIXEL / 2; 2] }
    }
}

/// What all blocks of a tile share.
#[derive(Clone, Copy)]
pub(crate) struct Tile<'a> {
    pub frame: &'a FrameView<'a>,
    pub projected: &'a Projected<'a>,
    pub grid: Grid,
    pub slot: Slot,
    /// Whether the tile has blended surfaces.
    pub blended: bool,
}

impl Tile<'_> {
    /// Whether a block's pixels are finished as soon as they are shaded.
    pub(crate) fn is_plain(&self) -> bool {
        self.frame.samples.len() == 1 && !self.blended && !self.keeps_planes()
    }

    /// Whether planes beside colour are asked for.
    #[inline(always)]
    pub(crate) fn keeps_planes(&self) -> bool {
        self.frame.options.aovs != Aovs::default()
    }
}

/// Keeps distance, normal and object of the nearest layer of a block.
pub(crate) fn keep_planes<S: Simd>(
    simd: S,
    pixels: &mut TilePixels,
    setups: &TriangleSetups,
    shaded: &Shaded<S>,
    runs: &[Run],
    at: usize,
) {
    let bits = runs.iter().fold(0, |bits, run| bits | run.bits);
    let old = pixels.distance[at..].first_chunk().expect("tiles are whole blocks");
    let nearer = shaded.distance.lt(Lanes::load(simd, old)).bits() & bits;
    let kept = LanesMask::from_bits(simd, nearer);
    let normal = [shaded.normal.x, shaded.normal.y, shaded.normal.z];
    let planes = pixels.normal.iter_mut().zip(normal);
    for (plane, value) in planes.chain([(&mut pixels.distance, shaded.distance)]) {
        let plane = plane[at..].first_chunk_mut().expect("tiles are whole blocks");
        value.select(kept, Lanes::load(simd, plane)).store(plane);
    }
    for run in runs {
        let number = setups.list[run.setup as usize].object + 1;
        for lane in (0..BLOCK).filter(|lane| (run.bits & nearer) >> lane & 1 == 1) {
            pixels.object[at + lane] = number;
        }
    }
}
