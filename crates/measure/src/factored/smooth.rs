//! Factors between readings, smoothed by Gaussians.
//!
//! The logarithm of a reading over the carrier is a smooth function of half and difference angles. Between readings it is
//! that of a plane through the nearest ones, each weighted by a Gaussian of its distance whose width is that of the
//! neighbourhood: kernel regression, local and linear. Beside the readings, rather than between them, the plane is level: a
//! slope that is known along the plane of incidence says nothing of what lies off it. Far from all readings the carrier alone
//! remains.

use glanz_math::Vec3;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::carrier::Carrier;
use crate::Readings;
use crate::linear::solve;

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

/// Slopes are held back by one of these parts of the weights: readings along few lines say little about slopes across them.
const RIDGES: [f64; 3] = [1e-3, 0.05, 1.0];

/// Readings count at least this part of the carrier, and at most its inverse: their logarithms are finite.
const LEAST_FACTOR: f64 = 1e-3;

/// A plane may leave what its readings say by this part of how far they are apart.
const BEYOND: f64 = 0.25;

/// From where to where a place lies beside its neighbours, rather than at their rim: its distance from the first of them over
/// how far the last lies behind it, in the direction in which they lie.
const BESIDE: [f64; 2] = [3.0, 6.0];

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
    ridge: f64,
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
        let mut own =
            Self { channels, tree, logs, neighbours: NEIGHBOURS[0], ridge: RIDGES[0], error: f64::MAX };
        own.choose(&tried, neighbours.as_slice());
        own
    }

    /// How many readings count.
    pub(super) fn len(&self) -> usize {
        self.tree.size()
    }

    /// Takes the neighbourhood and the ridge that tell readings best from the others; only the ridge where neighbours are
    /// asked for.
    fn choose(&mut self, tried: &[GeomWithData<P, usize>], asked: &[usize]) {
        let counts = if asked.is_empty() { &NEIGHBOURS } else { asked };
        let most = counts.iter().copied().max().unwrap_or(1);
        let near: Vec<_> = tried.iter().map(|point| self.near(point.geom(), most, SAME * SAME)).collect();
        let mut best = (f64::MAX, counts[0], RIDGES[0]);
        for &count in counts {
            for ridge in RIDGES {
                let off = tried.iter().zip(&near).map(|(point, near)| {
                    let told = self.logs_from(&near[..count.min(near.len())], point.geom(), ridge);
                    self.off(point.data, &told)
                });
                let error = off.sum::<f64>() / tried.len().max(1) as f64;
                if error < best.0 {
                    best = (error, count, ridge);
                }
            }
        }
        (self.error, self.neighbours, self.ridge) = best;
    }

    /// The mean of |Δ ln| of a reading from what is told of it.
    fn off(&self, reading: usize, told: &[f64]) -> f64 {
        let off = told.iter().zip(self.log(reading)).map(|(told, own)| (told - f64::from(*own)).abs());
        off.sum::<f64>() / self.channels as f64
    }

    fn log(&self, reading: usize) -> &[f32] {
        &self.logs[reading * self.channels..][..self.channels]
    }

    /// The factors over the carrier at a pair of directions, and how far the nearest reading is.
    pub(super) fn factors(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> (Vec<f64>, f64) {
        let place = P::of(wi, wo);
        let near = self.near(&place, self.neighbours, -1.0);
        let nearest = near.first().map_or(f64::MAX, |near| libm::sqrt(near.squared));
        let far = nearest / FAR;
        let known = 1.0 / (1.0 + far * far * far * far);
        let logs = self.logs_from(&near, &place, self.ridge);
        (logs.into_iter().map(|log| libm::exp(log * known)).collect(), nearest)
    }

    /// The readings nearest to a place, those left out whose squared distance is not above the least.
    fn near(&self, place: &P, count: usize, least: f64) -> Vec<Near<P>> {
        let near = self.tree.nearest_neighbor_iter_with_distance_2(place);
        let near = near.filter(|(_, squared)| *squared > least).take(count);
        near.map(|(point, squared)| Near { place: *point.geom(), reading: point.data, squared }).collect()
    }

    /// Logarithms of factors at a place, of its neighbours.
    fn logs_from(&self, near: &[Near<P>], place: &P, ridge: f64) -> Vec<f64> {
        let mut logs = vec![0.0; self.channels];
        let Some(last) = near.last() else { return logs };
        let width = WIDTH * libm::sqrt(last.squared).max(1e-6);
        let (weights, among) = linear(near, place, (width, ridge));
        let (mut low, mut high) = (vec![f64::MAX; self.channels], vec![f64::MIN; self.channels]);
        for (near, weight) in near.iter().zip(weights) {
            for (c, log) in self.log(near.reading).iter().map(|log| f64::from(*log)).enumerate() {
                logs[c] += weight * log;
                low[c] = low[c].min(log);
                high[c] = high[c].max(log);
            }
        }
        for (log, (low, high)) in logs.iter_mut().zip(low.into_iter().zip(high)) {
            let more = BEYOND * among * (high - low);
            *log = log.clamp(low - more, high + more);
        }
        logs
    }
}

/// A neighbour.
struct Near<P> {
    place: P,
    reading: usize,
    /// The square of its distance.
    squared: f64,
}

/// Unknowns of a plane in the most dimensions.
const UNKNOWNS: usize = 5;

/// From 0 to 1 between two numbers, smoothly.
fn risen(x: f64, [from, to]: [f64; 2]) -> f64 {
    let part = ((x - from) / (to - from)).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}

/// How much a place lies among its neighbours: 1, and 0 where they lie far away on one side. Of each neighbour the weight and
/// the row: 1, and how far it is off along each axis.
fn among(weights: &[f64], rows: &[[f64; UNKNOWNS]]) -> f64 {
    let mut middle = [0.0; UNKNOWNS];
    for (weight, row) in weights.iter().zip(rows) {
        middle.iter_mut().zip(row).skip(1).for_each(|(sum, x)| *sum += weight * x);
    }
    let along = |row: &[f64; UNKNOWNS]| middle.iter().zip(row).map(|(middle, x)| middle * x).sum::<f64>();
    let (first, last) =
        rows.iter().map(along).fold((f64::MAX, 0.0_f64), |(first, last), at| (first.min(at), last.max(at)));
    1.0 - risen(first / (last - first).max(1e-30), BESIDE)
}

/// What each neighbour counts for in the height of the weighted plane at the place: the first row of (XᵀGX)⁻¹ XᵀG; of a level
/// plane as far as the place is not among them, and how much it is.
fn linear<P: Place>(near: &[Near<P>], place: &P, (width, ridge): (f64, f64)) -> (Vec<f64>, f64) {
    let n = P::DIMENSIONS + 1;
    let row = |near: &Near<P>| {
        core::array::from_fn::<f64, UNKNOWNS, _>(|i| match i {
            0 => 1.0,
            i if i < n => (near.place.nth(i - 1) - place.nth(i - 1)) / width,
            _ => 0.0,
        })
    };
    let rows: Vec<_> = near.iter().map(row).collect();
    let weight = |near: &Near<P>| libm::exp(-0.5 * near.squared / (width * width));
    let weights: Vec<f64> = near.iter().map(weight).collect();
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
        line[i] += ridge * whole;
    }
    // The first column of the inverse.
    let mut heights = [0.0; UNKNOWNS];
    heights[0] = 1.0;
    solve(&mut matrix, &mut heights[..n]);
    let among = among(&weights, &rows);
    let share = |(weight, row): (&f64, &[f64; UNKNOWNS])| {
        let sloped = heights.iter().zip(row).map(|(height, x)| height * x).sum::<f64>();
        weight * (among * sloped + (1.0 - among) / whole)
    };
    (weights.iter().zip(&rows).map(share).collect(), among)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values that rise along the first axis by 2 a unit, read in a plane, in steps of 0.05.
    fn plane() -> Smooth<Isotropic> {
        let place = |i: i32, j: i32| [0.05 * f64::from(i), 0.05 * f64::from(j), 0.0];
        let places: Vec<Isotropic> = (0..20).flat_map(|i| (0..20).map(move |j| place(i, j))).collect();
        let logs = places.iter().map(|place| 2.0 * place[0] as f32).collect();
        let points = places.into_iter().enumerate().map(|(i, place)| GeomWithData::new(place, i)).collect();
        let tree = RTree::bulk_load(points);
        Smooth { channels: 1, tree, logs, neighbours: 16, ridge: RIDGES[0], error: 0.0 }
    }

    fn told(place: Isotropic) -> f64 {
        let smooth = plane();
        smooth.logs_from(&smooth.near(&place, smooth.neighbours, -1.0), &place, smooth.ridge)[0]
    }

    #[test]
    fn slopes_are_followed_between_readings_and_a_step_beyond() {
        assert!((told([0.52, 0.31, 0.0]) - 1.04).abs() < 0.01);
        assert!((told([0.52, 0.31, 0.05]) - 1.04).abs() < 0.01);
        // As far as a quarter of how far the 16 nearest are apart, four columns.
        let beyond = told([1.0, 0.5, 0.0]);
        assert!((1.92..1.98).contains(&beyond), "{beyond}");
    }

    #[test]
    fn farther_away_nothing_is_told_but_what_was_read() {
        for off in [0.5, 1.0, 3.0] {
            let beyond = told([0.95 + off, 0.5, 0.0]);
            // The nearest readings are those of the last columns, 1.9 at most.
            assert!((1.6..=1.9).contains(&beyond), "{off}: {beyond}");
        }
    }
}
