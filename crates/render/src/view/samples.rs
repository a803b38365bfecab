//! Where the coverage samples of a pixel are.

use thiserror::Error;

/// Subpixel steps per pixel.
pub const SUBPIXEL: i32 = 256;

/// How many coverage samples a pixel has.
///
/// ```
/// use glanz_render::Samples;
///
/// assert_eq!(Samples::try_from(8)?, Samples::Eight);
/// let error = Samples::try_from(3).unwrap_err();
/// assert_eq!(error.to_string(), "a pixel has 1, 2, 4, 8 or 16 samples, but 3 are asked for");
/// # Ok::<(), glanz_render::SamplesError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Samples {
    /// The centre.
    #[default]
    One = 1,
    /// Two.
    Two = 2,
    /// Four.
    Four = 4,
    /// Eight.
    Eight = 8,
    /// Sixteen.
    Sixteen = 16,
}

impl Samples {
    /// All of them, from the fewest.
    pub const ALL: [Self; 5] = [Self::One, Self::Two, Self::Four, Self::Eight, Self::Sixteen];

    /// The number.
    pub const fn count(self) -> u32 {
        self as u32
    }
}

/// There is no pattern of so many samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("a pixel has 1, 2, 4, 8 or 16 samples, but {found} are asked for")]
pub struct SamplesError {
    /// How many were asked for.
    pub found: u32,
}

impl TryFrom<u32> for Samples {
    type Error = SamplesError;

    fn try_from(found: u32) -> Result<Self, SamplesError> {
        Self::ALL.into_iter().find(|samples| samples.count() == found).ok_or(SamplesError { found })
    }
}

/// Sample positions within the pixel, in 1/256 of it.
///
/// The patterns are those that graphics hardware uses (Direct3D 11 standard sample positions): no two
/// samples share a row or column. One sample is at the centre.
pub fn positions(samples: Samples) -> &'static [[i32; 2]] {
    match samples {
        Samples::One => &ONE,
        Samples::Two => &TWO,
        Samples::Four => &FOUR,
        Samples::Eight => &EIGHT,
        Samples::Sixteen => &SIXTEEN,
    }
}

/// A position given in sixteenths from the centre.
const fn at(x: i32, y: i32) -> [i32; 2] {
    [(x + 8) * 16, (y + 8) * 16]
}

const ONE: [[i32; 2]; 1] = [at(0, 0)];
const TWO: [[i32; 2]; 2] = [at(4, 4), at(-4, -4)];
const FOUR: [[i32; 2]; 4] = [at(-2, -6), at(6, -2), at(-6, 2), at(2, 6)];
const EIGHT: [[i32; 2]; 8] =
    [at(1, -3), at(-1, 3), at(5, 1), at(-3, -5), at(-5, 5), at(-7, -1), at(3, 7), at(7, -7)];
const SIXTEEN: [[i32; 2]; 16] = [
    at(1, 1),
    at(-1, -3),
    at(-3, 2),
    at(4, -1),
    at(-5, -2),
    at(2, 5),
    at(5, 3),
    at(3, -5),
    at(-2, 6),
    at(0, -7),
    at(-4, -6),
    at(-6, 4),
    at(-8, 0),
    at(7, -4),
    at(6, 7),
    at(-7, -8),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_of_a_pixel_share_no_row_and_no_column() {
        for samples in Samples::ALL {
            let (positions, count) = (positions(samples), samples.count());
            assert_eq!(positions.len(), count as usize);
            for axis in 0..2 {
                let mut seen: Vec<i32> = positions.iter().map(|p| p[axis]).collect();
                seen.sort_unstable();
                seen.dedup();
                assert_eq!(seen.len(), count as usize);
                assert!(seen.iter().all(|p| (0..SUBPIXEL).contains(p)));
            }
        }
    }
}
