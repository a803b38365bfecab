//! What metrics give.

use glanz_math::MemoryBudget;

use super::metrics::flip::{self, DEFAULT_PPD, Exposures};
use super::metrics::{de2000, rmse, ssim};
use super::{CompareError, Metric, Pair, Scale, Spread};

/// Settings of metrics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetricOptions {
    /// For ꟻLIP: pixels per degree of the eye's field of view.
    pub ppd: f64,
    /// What a metric may take of memory beside the pair.
    pub memory: MemoryBudget,
}

impl Default for MetricOptions {
    fn default() -> Self {
        Self { ppd: DEFAULT_PPD, memory: MemoryBudget::default() }
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

    /// What a metric takes beside the pair: its map and a sorted copy of it or, before that, codes; filters work in bands of few rows.
    fn memory_of(&self, metric: Metric) -> u64 {
        let per_pixel = match (metric, self.scale) {
            (Metric::Rmse | Metric::Psnr, Scale::Codes) => 28,
            _ => 8,
        };
        (self.width as u64 * self.height as u64).saturating_mul(per_pixel)
    }

    /// Measures how far the second picture is from the first.
    pub fn measure(&self, metric: Metric, options: &MetricOptions) -> Result<Measurement, CompareError> {
        if !metric.applies_to(self.scale) {
            return Err(CompareError::CodesOnly { metric });
        }
        let what = format_args!("{} of {}×{} pixels", metric.name(), self.width, self.height);
        options.memory.check(what, self.memory_of(metric))?;
        let (mut exposures, mut rmse) = (None, 0.0);
        let map = match metric {
            Metric::De2000 => de2000::map(self),
            Metric::Flip => {
                let (map, found) = flip::map(self, options.ppd)?;
                exposures = found;
                map
            }
            Metric::Rmse | Metric::Psnr => {
                let (map, found) = rmse::map_and_rmse(self);
                rmse = found;
                map
            }
            Metric::Ssim => ssim::map(self),
        };
        let spread = Spread::of(&map);
        let value = match metric {
            Metric::De2000 | Metric::Flip => spread.mean,
            Metric::Rmse => rmse,
            Metric::Psnr => rmse::psnr(rmse),
            Metric::Ssim => ssim::mean(self, &map),
        };
        Ok(Measurement { metric, value, spread, map, exposures })
    }
}
