//! Ordered dithering: a fixed pattern of fractions of a code, added before rounding.

/// Where a pixel is in Bayer's 8×8 pattern: his recursive order, by interleaving the bits of y and
/// x xor y, lowest first.
const fn bayer(x: usize, y: usize) -> usize {
    let mixed = x ^ y;
    let mut order = 0;
    let mut bit = 0;
    while bit < 3 {
        order = order << 2 | (mixed >> bit & 1) << 1 | (y >> bit & 1);
        bit += 1;
    }
    order
}

/// The pattern's rows, repeated so that 16 values can be read from any phase.
static OFFSETS: [[f32; 24]; 8] = {
    let mut rows = [[0.0; 24]; 8];
    let mut y = 0;
    while y < 8 {
        let mut x = 0;
        while x < 24 {
            // −63/128 … 63/128: never enough to leave the codes 0 … 255, and 0 on average.
            rows[y][x] = (bayer(x % 8, y) as f32 + 0.5) / 64.0 - 0.5;
            x += 1;
        }
        y += 1;
    }
    rows
};

/// What to add to the codes of 16 pixels from `x` on in row `y`.
#[inline(always)]
pub(super) fn offsets(x: usize, y: usize) -> &'static [f32; 16] {
    let row = &OFFSETS[y & 7];
    row[x & 7..].first_chunk().expect("a row holds 16 values from any of 8 phases")
}

/// The pattern in blocks of 4×4 pixels, row by row: the two by two blocks that it has.
static BLOCKS: [[[f32; 16]; 2]; 2] = {
    let mut blocks = [[[0.0; 16]; 2]; 2];
    let mut i = 0;
    while i < 64 {
        let (x, y) = (i % 8, i / 8);
        blocks[y / 4][x / 4][y % 4 * 4 + x % 4] = OFFSETS[y][x];
        i += 1;
    }
    blocks
};

/// What to add to the codes of 4×4 pixels, row by row, from column and row `at` on: multiples of 4.
#[inline(always)]
pub(super) fn block_offsets([x, y]: [usize; 2]) -> &'static [f32; 16] {
    &BLOCKS[y >> 2 & 1][x >> 2 & 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pattern_has_every_value_once_and_no_mean() {
        let mut seen: Vec<f32> = (0..8).flat_map(|y| offsets(0, y)[..8].to_vec()).collect();
        seen.sort_by(f32::total_cmp);
        for (i, value) in seen.iter().enumerate() {
            assert_eq!(*value, (i as f32 + 0.5) / 64.0 - 0.5);
        }
        assert_eq!(seen.iter().sum::<f32>(), 0.0);
    }

    #[test]
    fn the_pattern_depends_on_the_place_in_the_picture_alone() {
        for x in 0..40 {
            for y in 0..10 {
                assert_eq!(offsets(x, y)[1..], offsets(x + 1, y)[..15]);
                assert_eq!(offsets(x, y), offsets(x + 8, y + 8));
            }
        }
    }

    #[test]
    fn blocks_have_the_offsets_of_their_rows() {
        for (x, y) in [(0, 0), (4, 0), (0, 4), (20, 12), (8, 36)] {
            for row in 0..4 {
                assert_eq!(block_offsets([x, y])[4 * row..][..4], offsets(x, y + row)[..4]);
            }
        }
    }

    #[test]
    fn the_smallest_pattern_is_bayers() {
        // Bayer 1973: [0 2; 3 1], here as the coarse order of the four corners.
        let corner = |x, y| bayer(x, y) / 16;
        assert_eq!([corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)], [0, 2, 3, 1]);
    }
}
