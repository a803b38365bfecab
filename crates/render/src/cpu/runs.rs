//! Which triangles sixteen neighbouring pixels see, as layers to be shaded.
//!
//! A layer gives each pixel at most one triangle. With one sample per pixel there is one layer; with
//! more, a pixel on an edge sees several triangles, each weighted with the samples that it covers.

/// Pixels of a layer that see the same triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    /// Its number among the tile's records.
    pub record: u32,
    /// Bit i: the i-th of the sixteen pixels.
    pub bits: u32,
}

/// Triangles for sixteen pixels, shaded together.
#[derive(Clone, Debug)]
pub(crate) struct Layer {
    /// Its runs, in [`Layers::runs`].
    pub runs: core::ops::Range<usize>,
    /// The pixels that it has.
    pub bits: u32,
    /// How much each pixel counts.
    pub weights: [f32; 16],
    /// Where in the pixel to shade: the centre, or a sample.
    pub at: [f32; 2],
}

/// All layers of sixteen pixels.
#[derive(Debug, Default)]
pub(crate) struct Layers {
    pub runs: Vec<Run>,
    pub list: Vec<Layer>,
    seen: Vec<Seen>,
}

/// A triangle, the pixels that see it, and with how many samples each.
#[derive(Debug)]
struct Seen {
    record: u32,
    bits: u32,
    counts: [u8; 16],
    placed: bool,
}

const CENTER: [f32; 2] = [0.5, 0.5];

impl Layers {
    pub fn clear(&mut self) {
        self.runs.clear();
        self.list.clear();
        self.seen.clear();
    }

    /// One layer of these runs, in which every pixel counts fully, or `weight`.
    pub fn add_sample(&mut self, runs: &[Run], weight: f32, at: [f32; 2]) {
        let start = self.runs.len();
        self.runs.extend_from_slice(runs);
        let bits = runs.iter().fold(0, |bits, run| bits | run.bits);
        self.list.push(Layer { runs: start..self.runs.len(), bits, weights: [weight; 16], at });
    }

    /// Notes what one sample of each pixel sees; [`Layers::pack`] makes layers of it.
    pub fn note(&mut self, runs: &[Run]) {
        for run in runs {
            let at = self.seen.iter().position(|seen| seen.record == run.record).unwrap_or_else(|| {
                self.seen.push(Seen { record: run.record, bits: 0, counts: [0; 16], placed: false });
                self.seen.len() - 1
            });
            let seen = &mut self.seen[at];
            seen.bits |= run.bits;
            for (lane, count) in seen.counts.iter_mut().enumerate() {
                *count += (run.bits >> lane & 1) as u8;
            }
        }
    }

    /// Packs what was noted into as few layers as first-fit finds.
    pub fn pack(&mut self, samples: usize) {
        let share = 1.0 / samples as f32;
        while self.seen.iter().any(|seen| !seen.placed) {
            let start = self.runs.len();
            let mut layer = Layer { runs: start..start, bits: 0, weights: [0.0; 16], at: CENTER };
            for seen in self.seen.iter_mut().filter(|seen| !seen.placed) {
                if seen.bits & layer.bits != 0 {
                    continue;
                }
                seen.placed = true;
                layer.bits |= seen.bits;
                self.runs.push(Run { record: seen.record, bits: seen.bits });
                for (weight, count) in layer.weights.iter_mut().zip(seen.counts) {
                    *weight += f32::from(count) * share;
                }
            }
            layer.runs.end = self.runs.len();
            self.list.push(layer);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_hold_each_pixel_once_and_all_weights() {
        let mut layers = Layers::default();
        layers.note(&[Run { record: 0, bits: 0b0011 }, Run { record: 1, bits: 0b1100 }]);
        layers.note(&[Run { record: 0, bits: 0b0111 }, Run { record: 2, bits: 0b1000 }]);
        layers.pack(2);
        let mut total = [0.0; 16];
        for layer in &layers.list {
            let mut bits = 0;
            for run in &layers.runs[layer.runs.clone()] {
                assert_eq!(bits & run.bits, 0);
                bits |= run.bits;
            }
            assert_eq!(bits, layer.bits);
            for (sum, weight) in total.iter_mut().zip(layer.weights) {
                *sum += weight;
            }
        }
        assert_eq!(total[..5], [1.0, 1.0, 1.0, 1.0, 0.0]);
    }
}
