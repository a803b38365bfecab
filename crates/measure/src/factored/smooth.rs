//! Factors between readings, smoothed by Gaussians.
//!
//! The logarithm of a reading over the carrier is a smooth function of half and difference angles. Between readings it is
//! that of a plane through the nearest ones, each weighted by a Gaussian of its distance whose width is that of the
//! neighbourhood: kernel regression, local and linear. Far from all readings the carrier alone remains.

use glanz_math::Vec3;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::carrier::Carrier;
use crate::Readings;

/// Neighbourhoods that are tried.
const NEIGHBOURS: [usize; 5] = [8, 16, 32, 64, 128];

/// Readings that the neighbourhoods are tried on.
const TRIED: usize = 400;

/// Of more readings every n-th counts.
const MOST_READINGS: usize = 120_000;

/// The Gaussian's width over the distance of the last neighbour.
const WIDTH: f64 = 0.5;

/// Readings nearer than this are the same pair of directions, or its mirror image.
const SAME: f64 = 1e-9;

/// Slopes are held back by this part of the weights.
const RIDGE: f64 = 1e-3;

/// Readings count at least this part of the carrier, and at most its inverse: their logarithms are finite.
const LEAST_FACTOR: f64 = 1e-3;

/// So far from all readings the carrier counts as much as they do.
const FAR: f64 = 0.25;

/// A place of a pair of directions, by which neighbours are found.
pub(super) trait Place: rstar::Point<Scalar = f64> + Copy + std::fmt::Debug {
    /// The place of a pair.
    fn of(wi: Vec3<f64>, wo: Vec3<f64>) -> Self;
}

/// Of isotropic surfaces: ⁴√(1 − n·h), √(1 − wo·h), and the difference of the cosines.
pub(super) type Isotropic = [f64; 3];

/// Of surfaces with a grain: half and difference vector as points of a plane, at the first two numbers' distances.
pub(super) type Grained = [f64; 4];

/// Half vector, its cosine to the normal and to both directions, and ⁴√ and √ of what those leave to 1.
fn half(wi: Vec3<f64>, wo: Vec3<f64>) -> (Vec3<f64>, [f64; 2]) {
    let sum = wi + wo;
    let h = sum * (1.0 / libm::sqrt(sum.dot(sum).max(1e-12)));
    let left = |cosine: f64| libm::sqrt((1.0 - cosine).max(0.0));
    (h, [libm::sqrt(left(h.z)), left(h.dot(wo))])
}

impl Place for Isotropic {
    fn of(wi: Vec3<f64>, wo: Vec3<f64>) -> Self {
        let (_, [x, y]) = half(wi, wo);
        [x, y, 0.5 * (wi.z - wo.z)]
    }
}

impl Place for Grained {
    fn of(wi: Vec3<f64>, wo: Vec3<f64>) -> Self {
        let (h, [x, y]) = half(wi, wo);
        let flat = libm::sqrt((h.x * h.x + h.y * h.y).max(1e-12));
        let off = wi - h * h.dot(wi);
        let size = libm::sqrt(off.dot(off).max(1e-12));
        let around = (h.x * off.y - h.y * off.x) / (flat * size);
        let along = off.z / (flat * size);
        [x * h.x / flat, x * h.y / flat, y * along, y * around]
    }
}

/// Readings over a carrier.
#[derive(Clone, Debug)]
pub(super) struct Smooth<P: Place> {
    channels: usize,
    tree: RTree<GeomWithData<P, usize>>,
    /// Of each reading that counts, by channels.
    logs: Vec<f32>,
    pub(super) neighbours: usize,
    /// The mean of |Δ ln| where readings were told from their neighbours.
    pub(super) error: f64,
}

impl<P: Place> Smooth<P> {
    /// Of readings whose values are all there, with neighbourhoods of so many, or of as many as tell readings best.
    pub(super) fn new(readings: &Readings, carrier: &Carrier, neighbours: Option<usize>) -> Self {
        let channels = readings.channels().count();
        let step = readings.len().div_ceil(MOST_READINGS).max(1);
        let mut points = Vec::new();
        let mut logs = Vec::new();
        for i in (0..readings.len()).step_by(step) {
            let ([wi, wo], values) = (readings.pair(i), readings.values(i));
            if values.iter().any(|value| !value.is_finite()) || wi.z <= 0.0 || wo.z <= 0.0 {
                continue;
            }
            points.push(GeomWithData::new(P::of(wi, wo), points.len()));
            let known = carrier.values(wi, wo);
            logs.extend(known.iter().zip(values).map(|(carrier, value)| {
                let factor = f64::from(*value) / carrier.max(1e-30);
                libm::log(factor.clamp(LEAST_FACTOR, 1.0 / LEAST_FACTOR)) as f32
            }));
        }
        let tried: Vec<_> = points.iter().step_by((points.len() / TRIED).max(1)).copied().collect();
        let tree = RTree::bulk_load(points);
        let mut own = Self { channels, tree, logs, neighbours: NEIGHBOURS[0], error: f64::MAX };
        own.choose(&tried, neighbours.as_slice());
        own
    }

    /// How many readings count.
    pub(super) fn len(&self) -> usize {
        self.tree.size()
    }

    /// Takes the neighbourhood that tells readings best from the others.
    fn choose(&mut self, tried: &[GeomWithData<P, usize>], asked: &[usize]) {
        let mut best = (f64::MAX, NEIGHBOURS[0]);
        for &neighbours in if asked.is_empty() { &NEIGHBOURS } else { asked } {
            self.neighbours = neighbours;
            let mut sum = 0.0;
            for point in tried {
                let (told, _) = self.logs_at(point.geom(), true);
                let own = &self.logs[point.data * self.channels..][..self.channels];
                let off = told.iter().zip(own).map(|(told, own)| (told - f64::from(*own)).abs());
                sum += off.sum::<f64>() / self.channels as f64;
            }
            let error = sum / tried.len().max(1) as f64;
            if error < best.0 || !asked.is_empty() {
                best = (error, neighbours);
            }
        }
        (self.error, self.neighbours) = best;
    }

    /// The factors over the carrier at a pair of directions, and how far the nearest reading is.
    pub(super) fn factors(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> (Vec<f64>, f64) {
        let (logs, nearest) = self.logs_at(&P::of(wi, wo), false);
        let far = nearest / FAR;
        let known = 1.0 / (1.0 + far * far * far * far);
        (logs.into_iter().map(|log| libm::exp(log * known)).collect(), nearest)
    }

    /// Logarithms of factors at a place, and how far the nearest reading is; the reading there itself may be left out.
    fn logs_at(&self, place: &P, leaves_out: bool) -> (Vec<f64>, f64) {
        let least = if leaves_out { SAME * SAME } else { -1.0 };
        let near = self.tree.nearest_neighbor_iter_with_distance_2(place);
        let near: Vec<_> = near.filter(|(_, squared)| *squared > least).take(self.neighbours).collect();
        let Some((first, last)) = near.first().zip(near.last()) else {
            return (vec![0.0; self.channels], f64::MAX);
        };
        let (nearest, width) = (libm::sqrt(first.1), WIDTH * libm::sqrt(last.1).max(1e-6));
        let weights: Vec<f64> =
            near.iter().map(|(_, squared)| libm::exp(-0.5 * squared / (width * width))).collect();
        let weights = linear(&weights, near.iter().map(|(point, _)| point.geom()), place, width);
        let mut logs = vec![0.0; self.channels];
        let (mut low, mut high) = (vec![f64::MAX; self.channels], vec![f64::MIN; self.channels]);
        for ((point, _), weight) in near.iter().zip(weights) {
            let own = &self.logs[point.data * self.channels..][..self.channels];
            for (c, log) in own.iter().map(|log| f64::from(*log)).enumerate() {
                logs[c] += weight * log;
                low[c] = low[c].min(log);
                high[c] = high[c].max(log);
            }
        }
        // A plane may leave what its readings say by a quarter of how far they are apart.
        for (log, (low, high)) in logs.iter_mut().zip(low.into_iter().zip(high)) {
            let more = 0.25 * (high - low);
            *log = log.clamp(low - more, high + more);
        }
        (logs, nearest)
    }
}

/// Unknowns of a plane in the most dimensions.
const UNKNOWNS: usize = 5;

/// What each neighbour counts for in the height of the weighted plane at the place: the first row of (XᵀGX)⁻¹ XᵀG.
fn linear<'p, P: Place + 'p>(
    weights: &[f64],
    points: impl Iterator<Item = &'p P>,
    place: &P,
    width: f64,
) -> Vec<f64> {
    let n = P::DIMENSIONS + 1;
    let row = |point: &P| {
        core::array::from_fn::<f64, UNKNOWNS, _>(|i| match i {
            0 => 1.0,
            i if i < n => (point.nth(i - 1) - place.nth(i - 1)) / width,
            _ => 0.0,
        })
    };
    let rows: Vec<_> = points.map(row).collect();
    let mut matrix = [[0.0; UNKNOWNS]; UNKNOWNS];
    for (weight, row) in weights.iter().zip(&rows) {
        for i in 0..n {
            for j in 0..n {
                matrix[i][j] += weight * row[i] * row[j];
            }
        }
    }
    let whole = matrix[0][0];
    for (i, line) in matrix.iter_mut().enumerate().take(n).skip(1) {
        line[i] += RIDGE * whole;
    }
    let heights = first_column_of_inverse(matrix, n);
    let share = |(weight, row): (&f64, &[f64; UNKNOWNS])| {
        weight * heights.iter().zip(row).map(|(height, x)| height * x).sum::<f64>()
    };
    weights.iter().zip(&rows).map(share).collect()
}

/// The first column of the inverse of a positive matrix, by elimination.
fn first_column_of_inverse(mut matrix: [[f64; UNKNOWNS]; UNKNOWNS], n: usize) -> [f64; UNKNOWNS] {
    let mut x = [0.0; UNKNOWNS];
    x[0] = 1.0;
    for i in 0..n {
        for j in i + 1..n {
            let factor = matrix[j][i] / matrix[i][i];
            let above = matrix[i];
            matrix[j].iter_mut().zip(above).skip(i).for_each(|(own, above)| *own -= factor * above);
            x[j] -= factor * x[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| matrix[i][j] * x[j]).sum();
        x[i] = (x[i] - known) / matrix[i][i];
    }
    x
}
