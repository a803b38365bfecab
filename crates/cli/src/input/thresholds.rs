//! Bounds on metrics, at which a comparison fails.

use glanz_picture::compare::{Measurement, Metric};
use schemars::JsonSchema;
use serde::Serialize;

use crate::print::{finite, number};

/// Which number of a metric.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Statistic {
    /// The one number that stands for the metric.
    Value,
    Mean,
    Median,
    P95,
    Max,
}

impl Statistic {
    /// Those over the pixels, with their names.
    pub(crate) const OVER_PIXELS: [(Self, &'static str); 4] =
        [(Self::Mean, "mean"), (Self::Median, "median"), (Self::P95, "p95"), (Self::Max, "max")];

    /// The number itself.
    pub(crate) fn of(self, measured: &Measurement) -> f64 {
        match self {
            Self::Value => measured.value,
            Self::Mean => measured.spread.mean,
            Self::Median => measured.spread.median,
            Self::P95 => measured.spread.p95,
            Self::Max => measured.spread.max,
        }
    }
}

/// Whether a metric has statistics over the pixels beside its value.
pub(crate) fn is_spread(metric: Metric) -> bool {
    matches!(metric, Metric::De2000 | Metric::Flip | Metric::Rmse)
}

/// A bound on a metric, for programs.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BoundFacts {
    /// The metric, and the statistic where it is not the metric's one number
    of: String,
    /// The least that is allowed
    #[serde(skip_serializing_if = "Option::is_none")]
    least: Option<f64>,
    /// The most that is allowed
    #[serde(skip_serializing_if = "Option::is_none")]
    most: Option<f64>,
    /// What was found; null where it is infinite
    found: Option<f64>,
    /// Whether the bound holds
    holds: bool,
}

/// A bound on a number of a metric: above it, or below it for metrics that grow with likeness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Threshold {
    /// The metric.
    pub metric: Metric,
    statistic: Statistic,
    limit: f64,
}

impl Threshold {
    /// `METRIC=LIMIT` or `METRIC.STATISTIC=LIMIT` of a metric that grows with the difference.
    pub(crate) fn above(text: &str) -> Result<Self, String> {
        let threshold = Self::parse(text, "de2000=1 or flip.max=0.2")?;
        let name = threshold.metric.name();
        match threshold.metric.grows_with_likeness() {
            true => Err(format!("a greater {name} means more alike; use --fail-below {text}")),
            false => Ok(threshold),
        }
    }

    /// `METRIC=LIMIT` of a metric that grows with likeness.
    pub(crate) fn below(text: &str) -> Result<Self, String> {
        let threshold = Self::parse(text, "psnr=40 or ssim=0.98")?;
        let name = threshold.metric.name();
        match threshold.metric.grows_with_likeness() {
            true => Ok(threshold),
            false => Err(format!("a greater {name} means less alike; use --fail-above {text}")),
        }
    }

    fn parse(text: &str, example: &str) -> Result<Self, String> {
        let expected = || format!("expected METRIC=LIMIT, such as {example}");
        let (what, limit) = text.split_once('=').ok_or_else(expected)?;
        let (name, statistic) = match what.trim().split_once('.') {
            Some((name, statistic)) => (name, Some(statistic)),
            None => (what.trim(), None),
        };
        let metric = Metric::ALL.into_iter().find(|metric| metric.name() == name);
        let metric = metric.ok_or_else(|| {
            let names = Metric::ALL.map(Metric::name).join(", ");
            format!("'{name}' is no metric; there are {names}")
        })?;
        let statistic = match statistic {
            Some(statistic) => Self::statistic(metric, statistic)?,
            None => Statistic::Value,
        };
        let limit = limit.trim().parse::<f64>().ok().filter(|limit| limit.is_finite());
        Ok(Self { metric, statistic, limit: limit.ok_or_else(expected)? })
    }

    fn statistic(metric: Metric, name: &str) -> Result<Statistic, String> {
        let known = Statistic::OVER_PIXELS.iter().filter(|_| is_spread(metric));
        let found = known.clone().find(|(_, known)| *known == name).map(|(statistic, _)| *statistic);
        found.ok_or_else(|| {
            let names: Vec<_> = known.map(|(_, name)| *name).collect();
            match names.is_empty() {
                true => format!("{} is one number and has no '{name}'", metric.name()),
                false => format!("{} has no '{name}', but {}", metric.name(), names.join(", ")),
            }
        })
    }

    /// The number that is bounded, as on the command line.
    fn name(&self) -> String {
        let statistic = Statistic::OVER_PIXELS.iter().find(|(statistic, _)| *statistic == self.statistic);
        match statistic {
            Some((_, name)) => format!("{}.{name}", self.metric.name()),
            None => self.metric.name().to_owned(),
        }
    }

    /// What is wrong with these measurements, if anything. What is no number is wrong.
    pub(crate) fn broken_by(&self, measured: &[Measurement]) -> Option<String> {
        let value = self.value(measured);
        let (side, holds) = match self.metric.grows_with_likeness() {
            true => ("below", value >= self.limit),
            false => ("above", value <= self.limit),
        };
        (!holds).then(|| format!("{} is {}, {side} {}", self.name(), number(value), number(self.limit)))
    }

    /// The bound and whether it holds, for programs.
    pub(crate) fn facts(&self, measured: &[Measurement]) -> BoundFacts {
        let is_least = self.metric.grows_with_likeness();
        BoundFacts {
            of: self.name(),
            least: is_least.then_some(self.limit),
            most: (!is_least).then_some(self.limit),
            found: finite(self.value(measured)),
            holds: self.broken_by(measured).is_none(),
        }
    }

    fn value(&self, measured: &[Measurement]) -> f64 {
        let measured = measured.iter().find(|measured| measured.metric == self.metric);
        self.statistic.of(measured.expect("every bounded metric is measured"))
    }
}

#[cfg(test)]
mod tests {
    use glanz_picture::compare::Spread;

    use super::*;

    fn measured(metric: Metric, value: f64, max: f64) -> Measurement {
        let spread = Spread { mean: value, median: 0.0, p95: 0.0, max };
        Measurement { metric, value, spread, map: Vec::new(), exposures: None }
    }

    #[test]
    fn a_bound_names_a_metric_a_statistic_and_a_limit() {
        let found = Threshold::above(" flip.max = 0.2").unwrap();
        assert_eq!(found, Threshold { metric: Metric::Flip, statistic: Statistic::Max, limit: 0.2 });
        assert_eq!(Threshold::below("psnr=40").unwrap().statistic, Statistic::Value);
        for wrong in
            ["flip", "flip=", "flip=nan", "flap=1", "flip.least=1", "rmse.=1", "=1", "psnr=40", "ssim.max=1"]
        {
            assert!(Threshold::above(wrong).is_err(), "{wrong}");
        }
        for wrong in ["flip=1", "ssim.mean=1", "psnr"] {
            assert!(Threshold::below(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_bound_is_broken_beyond_its_limit() {
        let measured = [measured(Metric::De2000, 1.0, 9.0), measured(Metric::Psnr, f64::INFINITY, 0.0)];
        let broken = |threshold: Result<Threshold, String>| threshold.unwrap().broken_by(&measured);
        assert_eq!(broken(Threshold::above("de2000=1")), None);
        assert_eq!(broken(Threshold::above("de2000=0.5")).unwrap(), "de2000 is 1, above 0.5");
        assert_eq!(broken(Threshold::above("de2000.max=8")).unwrap(), "de2000.max is 9, above 8");
        assert_eq!(broken(Threshold::below("psnr=99")), None);
    }

    #[test]
    fn what_is_no_number_breaks_every_bound() {
        let bound = Threshold::above("rmse=1").unwrap();
        assert!(bound.broken_by(&[measured(Metric::Rmse, f64::NAN, 0.0)]).is_some());
    }
}
