//! The metrics by name, and what they give.

use super::flip::{self, DEFAULT_PPD, Exposures};
use super::{CompareError, Pair, Scale, Spread, de2000, rmse, ssim};

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

/// Settings of metrics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetricOptions {
    /// For ꟻLIP: pixels per degree of the eye's field of view.
    pub ppd: f64,
}

impl Default for MetricOptions {
    fn default() -> Self {
        Self { ppd: DEFAULT_PPD }
    }
}

/// What a metric gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// The metric.
    pub metric: Metric,
    /// The one number: the mean of `de2000`, `flip` and `ssim`, the value of `rmse` and of `psnr` (infinite
    /// for identical pictures).
    pub value: f64,
    /// How the values of the map are spread.
    pub spread: Spread,
    /// An error per pixel, rows from the top, 0 where the pictures are the same: ΔE00, ꟻLIP, the root of the
    /// mean square of the three channels (`rmse`, `psnr`), 1 − SSIM.
    pub map: Vec<f32>,
    /// For ꟻLIP of light: the exposures at which it was looked at.
    pub exposures: Option<Exposures>,
}

impl Pair {
    /// The metrics that are defined for this pair.
    pub fn metrics(&self) -> impl Iterator<Item = Metric> {
        let scale = self.scale;
        Metric::ALL.into_iter().filter(move |metric| metric.applies_to(scale))
    }

    /// Measures how far the second picture is from the first.
    pub fn measure(&self, metric: Metric, options: &MetricOptions) -> Result<Measurement, CompareError> {
        if !metric.applies_to(self.scale) {
            return Err(CompareError::CodesOnly { metric });
        }
        let (map, exposures) = match metric {
            Metric::De2000 => (de2000::map(self), None),
            Metric::Flip => flip::map(self, options.ppd)?,
            Metric::Rmse | Metric::Psnr => (rmse::map(self), None),
            Metric::Ssim => (ssim::map(self), None),
        };
        let spread = Spread::of(&map);
        let value = match metric {
            Metric::De2000 | Metric::Flip => spread.mean,
            Metric::Rmse => rmse::rmse(self),
            Metric::Psnr => rmse::psnr(rmse::rmse(self)),
            Metric::Ssim => ssim::mean(self, &map),
        };
        Ok(Measurement { metric, value, spread, map, exposures })
    }
}
