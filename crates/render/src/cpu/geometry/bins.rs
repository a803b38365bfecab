//! Triangles, and single samples, sorted by the tiles that they touch.

/// Width of a tile in pixels.
pub(crate) const TILE_WIDTH: usize = 64;
/// Height of a tile in pixels.
pub(crate) const TILE_HEIGHT: usize = 32;
/// Pixels of a tile.
pub(crate) const TILE_PIXELS: usize = TILE_WIDTH * TILE_HEIGHT;

/// One list of things per tile.
#[derive(Debug, Default)]
pub(crate) struct Bins<T> {
    columns: usize,
    tiles: Vec<Vec<T>>,
    /// Whether anything is in any list: most bins stay empty, and nobody needs to look into them.
    used: bool,
}

impl<T: Copy> Bins<T> {
    /// Empties the lists, for a picture of this size.
    pub(crate) fn reset(&mut self, width: usize, height: usize) {
        self.columns = columns(width);
        self.tiles.resize_with(self.columns * height.div_ceil(TILE_HEIGHT), Vec::new);
        if self.used {
            self.tiles.iter_mut().for_each(Vec::clear);
        }
        self.used = false;
    }

    /// Adds a thing to all tiles from pixel `first` to pixel `last`, which are in the picture.
    #[inline(always)]
    pub(crate) fn push(&mut self, first: [i32; 2], last: [i32; 2], thing: T) {
        self.used = true;
        let tile = |p: i32, size: usize| p as usize / size;
        for row in tile(first[1], TILE_HEIGHT)..=tile(last[1], TILE_HEIGHT) {
            for column in tile(first[0], TILE_WIDTH)..=tile(last[0], TILE_WIDTH) {
                self.tiles[row * self.columns + column].push(thing);
            }
        }
    }

    /// Adds a thing to the tile of this number: row by row, as [`columns`] counts them.
    #[inline(always)]
    pub(crate) fn push_to(&mut self, tile: usize, thing: T) {
        self.used = true;
        self.tiles[tile].push(thing);
    }

    /// The things of a tile.
    #[inline(always)]
    pub(crate) fn of(&self, column: usize, row: usize) -> &[T] {
        if !self.used {
            return &[];
        }
        &self.tiles[row * self.columns + column]
    }
}

/// How many tiles stand side by side in a picture of this width.
pub(crate) fn columns(width: usize) -> usize {
    width.div_ceil(TILE_WIDTH)
}
