//! What metrics give.

use super::metrics::flip::{self, DEFAULT_PPD, Exposures};
use super::metrics::{de2000, rmse, ssim};
use super::{CompareError, Metric, Pair, Spread};

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
