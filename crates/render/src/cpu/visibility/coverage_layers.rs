//! Which triangles sixteen neighbouring pixels see, as layers to be shaded.
//!
//! A layer gives each pixel at most one triangle. With one sample per pixel there is one layer; with
//! more, a pixel on an edge sees several triangles, each weighted with the samples that it covers.

/// Pixels of a layer that see the same triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    /// Its number among the tile's records.
    pub setup: u32,
    /// Bit i: the i-th of the sixteen pixels.
    pub bits: u32,
}

/// Triangles for sixteen pixels, shaded together.
#[derive(Clone, Debug)]
pub(crate) struct CoverageLayer<const C: usize> {
    /// Its runs, in [`CoverageLayers::runs`].
    pub runs: core::ops::Range<usize>,
    /// The pixels that it has.
    pub bits: u32,
    /// How much each pixel counts.
    pub weights: Weights<C>,
    /// Where in the pixel to shade: the centre, or a sample.
    pub at: [f32; 2],
}

/// How much sixteen pixels count: in all channels alike (1), or in each of three and for coverage where they are seen
/// through something coloured (4).
pub(crate) type Weights<const C: usize> = [[f32; 16]; C];

/// All layers of sixteen pixels.
#[derive(Debug)]
pub(crate) struct CoverageLayers<const C: usize> {
    pub runs: Vec<Run>,
    pub list: Vec<CoverageLayer<C>>,
    /// How much of each pixel no triangle covers.
    pub open: Weights<C>,
    seen: Vec<CoveredTriangle<C>>,
}

impl<const C: usize> Default for CoverageLayers<C> {
    fn default() -> Self {
        Self { runs: Vec::new(), list: Vec::new(), open: [[0.0; 16]; C], seen: Vec::new() }
    }
}

/// A triangle, the pixels that see it, and how much of each.
#[derive(Debug)]
struct CoveredTriangle<const C: usize> {
    setup: u32,
    bits: u32,
    weights: Weights<C>,
    placed: bool,
}

const CENTER: [f32; 2] = [0.5, 0.5];

impl<const C: usize> CoverageLayers<C> {
    pub(crate) fn clear(&mut self) {
        self.runs.clear();
        self.list.clear();
        self.seen.clear();
        self.open = [[0.0; 16]; C];
    }

    /// One layer of these runs: what a sample that counts so much in each pixel sees.
    pub(crate) fn add_sample(&mut self, runs: &[Run], weights: &Weights<C>, at: [f32; 2]) {
        let start = self.runs.len();
        self.runs.extend_from_slice(runs);
        let bits = runs.iter().fold(0, |bits, run| bits | run.bits);
        self.list.push(CoverageLayer { runs: start..self.runs.len(), bits, weights: *weights, at });
        self.leave_open(bits, weights);
    }

    /// Notes what a sample that counts so much in each pixel sees; [`CoverageLayers::pack`] makes layers of it.
    pub(crate) fn note(&mut self, runs: &[Run], weights: &Weights<C>) {
        for run in runs {
            let at = self.seen.iter().position(|seen| seen.setup == run.setup).unwrap_or_else(|| {
                self.seen.push(CoveredTriangle {
                    setup: run.setup,
                    bits: 0,
                    weights: [[0.0; 16]; C],
                    placed: false,
                });
                self.seen.len() - 1
            });
            let seen = &mut self.seen[at];
            seen.bits |= run.bits;
            add_where(&mut seen.weights, weights, run.bits);
        }
        self.leave_open(runs.iter().fold(0, |bits, run| bits | run.bits), weights);
    }

    fn leave_open(&mut self, covered: u32, weights: &Weights<C>) {
        add_where(&mut self.open, weights, !covered);
    }

    /// Packs what was noted into as few layers as first-fit finds.
    pub(crate) fn pack(&mut self) {
        while self.seen.iter().any(|seen| !seen.placed) {
            let start = self.runs.len();
            let mut layer =
                CoverageLayer { runs: start..start, bits: 0, weights: [[0.0; 16]; C], at: CENTER };
            for seen in self.seen.iter_mut().filter(|seen| !seen.placed) {
                if seen.bits & layer.bits != 0 {
                    continue;
                }
                seen.placed = true;
                layer.bits |= seen.bits;
                self.runs.push(Run { setup: seen.setup, bits: seen.bits });
                for (weight, own) in layer.weights.iter_mut().zip(seen.weights) {
                    weight.iter_mut().zip(own).for_each(|(weight, own)| *weight += own);
                }
            }
            layer.runs.end = self.runs.len();
            self.list.push(layer);
        }
    }
}

/// Adds to the sums whose bit is set.
fn add_where<const C: usize>(sums: &mut Weights<C>, values: &Weights<C>, bits: u32) {
    for (sums, values) in sums.iter_mut().zip(values) {
        for (lane, (sum, value)) in sums.iter_mut().zip(values).enumerate() {
            *sum += if bits >> lane & 1 == 1 { *value } else { 0.0 };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_hold_each_pixel_once_and_all_weights() {
        let mut layers = CoverageLayers::<1>::default();
        let half = [[0.5; 16]];
        layers.note(&[Run { setup: 0, bits: 0b0011 }, Run { setup: 1, bits: 0b1100 }], &half);
        layers.note(&[Run { setup: 0, bits: 0b0111 }, Run { setup: 2, bits: 0b1000 }], &half);
        layers.pack();
        let mut total = [0.0; 16];
        for layer in &layers.list {
            let mut bits = 0;
            for run in &layers.runs[layer.runs.clone()] {
                assert_eq!(bits & run.bits, 0);
                bits |= run.bits;
            }
            assert_eq!(bits, layer.bits);
            for (sum, weight) in total.iter_mut().zip(layer.weights[0]) {
                *sum += weight;
            }
        }
        assert_eq!(total[..5], [1.0, 1.0, 1.0, 1.0, 0.0]);
        assert_eq!(layers.open[0][..5], [0.0, 0.0, 0.0, 0.0, 1.0]);
    }
}
