//! What a program drew.

/// The colour of pixels that are not a number: one that is seldom meant.
const NOT_A_NUMBER: [u8; 4] = [255, 0, 255, 255];

/// A picture as the program gave it: values of a display, not of light.
#[derive(Clone, Debug, PartialEq)]
pub struct ScreenPicture {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green, blue and alpha, by rows from the top.
    pub pixels: Vec<[f32; 4]>,
}

impl ScreenPicture {
    /// 8-bit codes, RGBA by rows from the top: values are cut to 0 … 1, alpha counts for nothing, and what is not a number
    /// is magenta.
    pub fn codes(&self) -> Vec<u8> {
        let code = |value: f32| (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let pixel = |pixel: &[f32; 4]| match is_number(pixel) {
            true => [code(pixel[0]), code(pixel[1]), code(pixel[2]), 255],
            false => NOT_A_NUMBER,
        };
        self.pixels.iter().flat_map(pixel).collect()
    }

    /// How many pixels are not a number, and column and row from the top of the first of them.
    pub fn not_numbers(&self) -> Option<(usize, [usize; 2])> {
        let first = self.pixels.iter().position(|pixel| !is_number(pixel))?;
        let count = self.pixels.iter().filter(|pixel| !is_number(pixel)).count();
        Some((count, [first % self.width, first / self.width]))
    }

    /// Whether all codes are 0.
    pub fn is_black(&self) -> bool {
        let black = |value: &f32| *value * 255.0 < 0.5;
        self.pixels.iter().all(|pixel| pixel[..3].iter().all(black))
    }
}

/// Whether its colour is.
fn is_number(pixel: &[f32; 4]) -> bool {
    !pixel[..3].iter().any(|value| value.is_nan())
}
