//! Linear RGB.

use core::ops::{Add, Mul};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A colour as three linear amounts of the sRGB primaries; not limited to 0 … 1.
///
/// ```
/// use glanz_color::Rgb;
///
/// let orange = Rgb([1.0, 0.5, 0.0]);
/// assert!((orange.luminance() - 0.5702).abs() < 1e-6);
/// assert_eq!(orange * Rgb::gray(2.0) + Rgb([0.0, 0.0, 1.0]), Rgb([2.0, 1.0, 1.0]));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Rgb(pub [f32; 3]);

impl Rgb {
    /// No light, or no reflection.
    pub const BLACK: Self = Self([0.0; 3]);
    /// The classic unit light, or full reflection.
    pub const WHITE: Self = Self([1.0; 3]);

    /// The same amount of each primary.
    pub const fn gray(value: f32) -> Self {
        Self([value; 3])
    }

    /// Relative luminance: the weights of Rec. 709, which are those of sRGB.
    pub fn luminance(self) -> f32 {
        let [r, g, b] = self.0;
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// Whether every component is a finite number.
    pub fn is_finite(self) -> bool {
        self.0.iter().all(|c| c.is_finite())
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(core::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl Mul for Rgb {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(core::array::from_fn(|i| self.0[i] * other.0[i]))
    }
}

impl Mul<f32> for Rgb {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self(self.0.map(|c| c * factor))
    }
}
