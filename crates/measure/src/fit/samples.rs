//! Readings as a fit needs them.

use glanz_bsdf::{Angle, DirectionPair, LayerWeight, Shape};

use super::{FitOptions, blocks};
use crate::Readings;

/// Channels that widths are searched with, at most.
pub(super) const GROUPS: usize = 3;

/// Readings that count, as columns of numbers.
#[derive(Clone)]
pub(super) struct Samples {
    pub pairs: Vec<DirectionPair<f64>>,
    /// f cosθi, channel by channel.
    pub values: Vec<Vec<f64>>,
    /// What the squares of differences are multiplied with.
    pub weights: Vec<f64>,
    /// What stands for numbers near 0.
    pub least: f64,
}

impl Samples {
    pub(super) fn of(readings: &Readings, options: &FitOptions) -> Self {
        let least_cosine = libm::cos(options.most_theta_deg.to_radians());
        let counts = |index: &usize| {
            let [wi, wo] = readings.pair(*index);
            wi.z >= least_cosine
                && wo.z >= least_cosine
                && (f32::MIN_POSITIVE..=f32::MAX).contains(&readings.weight(*index))
                && readings.values(*index).iter().all(|x| x.is_finite())
        };
        let all = blocks::map(readings.len(), |range| range.filter(counts).collect::<Vec<usize>>()).concat();
        let step = all.len().div_ceil(options.most_readings.max(1)).max(1);
        let chosen: Vec<usize> = all.into_iter().step_by(step).collect();
        let pair = |index: &usize| {
            let [wi, wo] = readings.pair(*index);
            DirectionPair::new(wo, wi)
        };
        let of_channel = |c: usize| {
            let value = |index: &usize| f64::from(readings.values(*index)[c]) * readings.pair(*index)[0].z;
            blocks::fill(chosen.len(), |range, out| {
                out.iter_mut().zip(&chosen[range]).for_each(|(out, index)| *out = value(index));
            })
        };
        Self {
            pairs: blocks::map(chosen.len(), |range| chosen[range].iter().map(pair).collect::<Vec<_>>())
                .concat(),
            values: (0..readings.channels().count()).map(of_channel).collect(),
            weights: chosen.iter().map(|index| f64::from(readings.weight(*index))).collect(),
            least: 0.0,
        }
        .with_least()
    }

    /// With the ten-thousandth of the mean of all values as the least number.
    fn with_least(mut self) -> Self {
        let sum: f64 = self.values.iter().flatten().map(|y| y.max(0.0)).sum();
        self.least = 1e-4 * sum / (self.len() * self.values.len()).max(1) as f64;
        self
    }

    pub(super) fn len(&self) -> usize {
        self.pairs.len()
    }

    /// The same with three channels, the means of thirds, if there are more: widths are those of all channels together.
    pub(super) fn grouped(&self) -> Option<Self> {
        let count = self.values.len();
        let mean = |g: usize| {
            let members = &self.values[g * count / GROUPS..(g + 1) * count / GROUPS];
            blocks::fill(self.len(), |range, out| {
                for member in members {
                    out.iter_mut().zip(&member[range.clone()]).for_each(|(sum, value)| *sum += value);
                }
                out.iter_mut().for_each(|sum| *sum /= members.len() as f64);
            })
        };
        (count > GROUPS).then(|| Self { values: (0..GROUPS).map(mean).collect(), ..self.clone() })
    }

    /// Every n-th, so that at most this many are left.
    pub(super) fn thinned(&self, most: usize) -> Self {
        let step = self.len().div_ceil(most).max(1);
        let every = |values: &Vec<f64>| values.iter().step_by(step).copied().collect();
        Self {
            pairs: self.pairs.iter().step_by(step).copied().collect(),
            values: self.values.iter().map(every).collect(),
            weights: every(&self.weights),
            least: self.least,
        }
    }

    /// f cosθi of a shape whose x axis lies at this azimuth.
    pub(super) fn column(&self, shape: &Shape, azimuth: f64) -> Vec<f64> {
        let (sin, cos) = libm::sincos(azimuth);
        let turn = |(x, y): (f64, f64)| (cos * x + sin * y, cos * y - sin * x);
        let is_turned = shape.is_anisotropic() && azimuth != 0.0;
        blocks::fill(self.len(), |range, out| {
            let pairs = &self.pairs[range];
            let values = match is_turned {
                false => shape.values(pairs),
                true => {
                    let turned = |pair: &DirectionPair<f64>| DirectionPair {
                        tangent_o: turn(pair.tangent_o),
                        tangent_i: turn(pair.tangent_i),
                        ..*pair
                    };
                    shape.values(&pairs.iter().map(turned).collect::<Vec<_>>())
                }
            };
            out.copy_from_slice(&values);
        })
    }

    /// The two parts of a column in Schlick's form: times 1 − u⁵ and times u⁵, as layers of materials weigh them.
    pub(super) fn schlick(&self, column: &[f64]) -> [Vec<f64>; 2] {
        schlick_layers().map(|layer| {
            blocks::fill(self.len(), |range, out| {
                for (out, i) in out.iter_mut().zip(range) {
                    *out = column[i] * layer.factor(&self.pairs[i]);
                }
            })
        })
    }
}

/// The weights of the tints at normal and at grazing incidence.
pub(super) fn schlick_layers() -> [LayerWeight; 2] {
    let layer = |at_zero, at_grazing| LayerWeight::Schlick { angle: Angle::Half, at_zero, at_grazing };
    [layer(1.0, 0.0), layer(0.0, 1.0)]
}
