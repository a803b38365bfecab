//! Triangles sorted by the tiles that they touch.

/// Width of a tile in pixels.
pub(crate) const TILE_WIDTH: usize = 64;
/// Height of a tile in pixels.
pub(crate) const TILE_HEIGHT: usize = 32;
/// Pixels of a tile.
pub(crate) const TILE_PIXELS: usize = TILE_WIDTH * TILE_HEIGHT;

/// One list of triangle names per tile.
#[derive(Debug, Default)]
pub(crate) struct Bins {
    columns: usize,
    tiles: Vec<Vec<u32>>,
}

impl Bins {
    /// Empties the lists, for a picture of this size.
    pub fn reset(&mut self, width: usize, height: usize) {
        self.columns = width.div_ceil(TILE_WIDTH);
        self.tiles.resize_with(self.columns * height.div_ceil(TILE_HEIGHT), Vec::new);
        self.tiles.iter_mut().for_each(Vec::clear);
    }

    /// Adds a triangle to all tiles from pixel `first` to pixel `last`, which are in the picture.
    #[inline(always)]
    pub fn push(&mut self, first: [i32; 2], last: [i32; 2], name: u32) {
        let tile = |p: i32, size: usize| p as usize / size;
        for row in tile(first[1], TILE_HEIGHT)..=tile(last[1], TILE_HEIGHT) {
            for column in tile(first[0], TILE_WIDTH)..=tile(last[0], TILE_WIDTH) {
                self.tiles[row * self.columns + column].push(name);
            }
        }
    }

    /// The triangles of a tile.
    pub fn of(&self, column: usize, row: usize) -> &[u32] {
        &self.tiles[row * self.columns + column]
    }
}
