//! The metrics by name.

use super::Scale;

/// A measure of how far two pictures are apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Metric {
    /// Colour difference CIEDE2000 per pixel, in CIELAB with the white D65.
    De2000,
    /// ꟻLIP: what an eye sees that looks at both in turn (Andersson et al. 2020, 2021). 0 … 1.
    Flip,
    /// Root of the mean square, over red, green and blue, of codes or of light.
    Rmse,
    /// The same as signal to noise in decibels, for a signal of 1.
    Psnr,
    /// Structural similarity of the luma of codes (Wang et al. 2004). 1 for identical pictures.
    Ssim,
}

impl Metric {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::De2000, Self::Flip, Self::Rmse, Self::Psnr, Self::Ssim];

    /// The name, as on a command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::De2000 => "de2000",
            Self::Flip => "flip",
            Self::Rmse => "rmse",
            Self::Psnr => "psnr",
            Self::Ssim => "ssim",
        }
    }

    /// Whether it is defined for pictures on this scale.
    pub fn applies_to(self, scale: Scale) -> bool {
        self != Self::Ssim || scale == Scale::Codes
    }

    /// Whether a greater value means that the pictures are nearer to each other.
    pub fn grows_with_likeness(self) -> bool {
        matches!(self, Self::Psnr | Self::Ssim)
    }
}
