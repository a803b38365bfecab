//! Weights that carry values at measured wavelengths over to the grid.

use crate::spectra::STEP_NM;

/// A value on the grid is the sum of these measured samples times these weights; the weights sum to 1.
pub(super) type Weights = Vec<(usize, f64)>;

/// Ascending wavelengths at which something was measured, in nm.
pub(super) struct Axis<'a> {
    nm: &'a [f64],
}

impl<'a> Axis<'a> {
    /// An axis of ascending, finite wavelengths.
    pub(super) fn new(nm: &'a [f64]) -> Self {
        Self { nm }
    }

    /// Weights on the line between neighbours: never negative, and what is measured as a fraction of light
    /// is given to all of the light between, once.
    pub(super) fn linear(&self, nm: f64) -> Weights {
        match self.place(nm) {
            Place::Nowhere => Weights::new(),
            Place::At(index) => vec![(index, 1.0)],
            Place::Finer => self.average(nm),
            Place::Between(left, t) => vec![(left, 1.0 - t), (left + 1, t)],
        }
    }

    /// Weights of the cubic through neighbours (Catmull and Rom 1974, for unequal steps): quadratics
    /// are kept, so sums with smooth functions, as those of an observer, are too. May be negative.
    pub(super) fn cubic(&self, nm: f64) -> Weights {
        match self.place(nm) {
            Place::Nowhere => Weights::new(),
            Place::At(index) => vec![(index, 1.0)],
            Place::Finer => self.average(nm),
            Place::Between(left, t) => self.hermite(left, t),
        }
    }

    /// Where a wavelength lies among those measured.
    fn place(&self, nm: f64) -> Place {
        let (Some(first), Some(last)) = (self.nm.first(), self.nm.last()) else { return Place::Nowhere };
        if self.nm.len() == 1 {
            return if (nm - first).abs() <= 0.5 * STEP_NM { Place::At(0) } else { Place::Nowhere };
        }
        if !(*first..=*last).contains(&nm) {
            return Place::Nowhere;
        }
        // A mean step, so that one close pair does not change how all is read; 1 % for rounded steps.
        if (last - first) / ((self.nm.len() - 1) as f64) < 0.99 * STEP_NM {
            return Place::Finer;
        }
        let left = self.nm.partition_point(|&x| x <= nm).clamp(1, self.nm.len() - 1) - 1;
        match (nm - self.nm[left]) / (self.nm[left + 1] - self.nm[left]) {
            0.0 => Place::At(left),
            1.0 => Place::At(left + 1),
            t => Place::Between(left, t),
        }
    }

    /// The mean of finer samples, each by its width and its nearness to the sample of the grid.
    fn average(&self, nm: f64) -> Weights {
        let from = self.nm.partition_point(|&x| x <= nm - STEP_NM);
        let to = self.nm.partition_point(|&x| x < nm + STEP_NM);
        let near = |i: usize| self.width(i) * (1.0 - (self.nm[i] - nm).abs() / STEP_NM);
        let total: f64 = (from..to).map(near).sum();
        if total > 0.0 {
            return (from..to).map(|i| (i, near(i) / total)).collect();
        }
        // A gap in fine samples.
        let left = self.nm.partition_point(|&x| x <= nm).clamp(1, self.nm.len() - 1) - 1;
        let t = (nm - self.nm[left]) / (self.nm[left + 1] - self.nm[left]);
        vec![(left, 1.0 - t), (left + 1, t)]
    }

    /// The width of the band that a sample stands for.
    fn width(&self, index: usize) -> f64 {
        let left = self.nm[index.saturating_sub(1)];
        let right = self.nm[(index + 1).min(self.nm.len() - 1)];
        0.5 * (right - left)
    }

    /// The cubic Hermite polynomial between two samples, as weights of up to four.
    fn hermite(&self, left: usize, t: f64) -> Weights {
        let h = self.nm[left + 1] - self.nm[left];
        let (t2, t3) = (t * t, t * t * t);
        let mut weights = vec![(left, 2.0 * t3 - 3.0 * t2 + 1.0), (left + 1, 3.0 * t2 - 2.0 * t3)];
        for (at, factor) in [(left, t3 - 2.0 * t2 + t), (left + 1, t3 - t2)] {
            for (index, weight) in self.slope(at, left) {
                add(&mut weights, index, weight * factor * h);
            }
        }
        weights
    }

    /// The slope at a sample: of the parabola through it and its neighbours; at an end, of the line to
    /// the only neighbour.
    fn slope(&self, at: usize, segment: usize) -> Weights {
        if at == 0 || at + 1 == self.nm.len() {
            let h = self.nm[segment + 1] - self.nm[segment];
            return vec![(segment, -1.0 / h), (segment + 1, 1.0 / h)];
        }
        let (before, after) = (self.nm[at] - self.nm[at - 1], self.nm[at + 1] - self.nm[at]);
        let (left, right) = (after / (before * (before + after)), before / (after * (before + after)));
        vec![(at - 1, -left), (at, left - right), (at + 1, right)]
    }
}

/// Where a wavelength lies on an axis.
enum Place {
    /// Outside.
    Nowhere,
    /// On a sample.
    At(usize),
    /// Among samples that are closer than those of the grid.
    Finer,
    /// At this part of the way from this sample to the next.
    Between(usize, f64),
}

fn add(weights: &mut Weights, index: usize, weight: f64) {
    match weights.iter_mut().find(|(known, _)| *known == index) {
        Some((_, sum)) => *sum += weight,
        None => weights.push((index, weight)),
    }
}
