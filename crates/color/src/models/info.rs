//! What a colour model tells of itself.

use super::Xyz;

/// How far the values of a channel go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The range is where ordinary colours lie; values beyond it are colours too.
    Nominal,
    /// Values outside of the range mean nothing.
    Strict,
    /// An angle: values outside of the range are taken round the circle.
    Cyclic,
}

/// One number of a colour model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel {
    /// Its name, as the field writes it.
    pub name: &'static str,
    /// Least and greatest value; infinite where there is none.
    pub range: [f64; 2],
    /// What the range means.
    pub limit: Limit,
}

impl Channel {
    /// A channel whose range may be left.
    pub const fn nominal(name: &'static str, low: f64, high: f64) -> Self {
        Self { name, range: [low, high], limit: Limit::Nominal }
    }

    /// A channel whose range may not be left.
    pub const fn strict(name: &'static str, low: f64, high: f64) -> Self {
        Self { name, range: [low, high], limit: Limit::Strict }
    }

    /// A hue in degrees.
    pub const fn hue(name: &'static str) -> Self {
        Self { name, range: [0.0, 360.0], limit: Limit::Cyclic }
    }

    /// Whether the value means something.
    pub fn accepts(&self, value: f64) -> bool {
        let within = self.range[0] <= value && value <= self.range[1];
        value.is_finite() && (within || self.limit != Limit::Strict)
    }
}

/// What a colour model is called and what its numbers are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelInfo {
    /// The name in files and on the command line.
    pub name: &'static str,
    /// One line on what it is.
    pub title: &'static str,
    /// Its numbers, in order.
    pub channels: &'static [Channel],
    /// Whether it can hold the colours of the sRGB cube only.
    pub srgb_only: bool,
}

/// A colour model: a type that holds a colour in it, with the way to XYZ and back.
///
/// XYZ is the hub: CIE 1931, relative to the white D65 ([`super::D65_XYZ`]), whose Y is 1. Conversions
/// are total: they never panic, and give numbers that are not finite only for numbers that mean nothing.
pub trait ColorModel: Copy {
    /// What it is called and what its numbers are.
    const INFO: ModelInfo;

    /// The same colour in XYZ.
    fn to_xyz(self) -> Xyz;

    /// The colour of XYZ in this model.
    fn from_xyz(xyz: Xyz) -> Self;

    /// The same colour in another model.
    fn to<M: ColorModel>(self) -> M {
        M::from_xyz(self.to_xyz())
    }
}
