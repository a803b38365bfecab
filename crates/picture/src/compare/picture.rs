//! A picture to be compared.

/// What the values of a picture stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scale {
    /// What a screen shows: 0 … 1, compared as sRGB codes where a metric works on values as such.
    Codes,
    /// Light without bounds, compared as it is.
    Light,
}

/// A picture in linear light of the primaries of sRGB, laid over black.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width in pixels, at least 1.
    pub width: usize,
    /// Height in pixels, at least 1.
    pub height: usize,
    /// Red, green and blue: `width·height` finite values each, rows from the top.
    pub rgb: [Vec<f32>; 3],
    /// What the picture was made from.
    pub scale: Scale,
    /// What of the file was taken otherwise than it might be meant, in sentences.
    pub notes: Vec<String>,
}

impl Picture {
    /// The number of pixels.
    pub fn pixels(&self) -> usize {
        self.width * self.height
    }
}
