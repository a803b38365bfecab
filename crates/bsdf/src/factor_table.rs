//! Factors over the angles, from a table: what measured reflectance is over the model that was fitted to it.

use std::fmt;

use glanz_math::{Real, Vec3};
use serde::{Deserialize, Serialize};

use crate::DirectionPair;

/// Ranks that stand together in memory.
const GROUP: usize = 4;

/// A half vector whose tangential part is shorter has no azimuth.
const NO_AZIMUTH: f64 = 1e-12;

/// Factors over half and difference angles, several for each pair of directions: its ranks.
///
/// The axes are x = ⁴√(1 − n·h), y = √(1 − wo·h) and z = (cosθi − cosθo) / (2 sinθh sinθd), which is the cosine of the
/// azimuth φd of the difference, −1 … 1. They take square roots and no function of an angle, so that a value is the same
/// to the last bit on every machine. Tables of surfaces with a grain have a fourth axis, the azimuth φh of the half vector,
/// and z goes around the full circle; both azimuths are s / (|c| + |s|) of their sine and cosine, which runs through the
/// quadrants as the angle does. Between the nodes factors are linear along each axis.
///
/// ```
/// use glanz_bsdf::{DirectionPair, FactorTable};
///
/// // A factor that grows with the angle between light and half vector, as Fresnel's does.
/// let sizes = [4, 33, 3, 1];
/// let factor = |[wo, wi]: [glanz_math::Vec3<f64>; 2]| (1.0 - 0.5 * (1.0 + wo.dot(wi))) as f32;
/// let values = FactorTable::nodes(sizes).into_iter().map(factor).collect();
/// let table = FactorTable::new(sizes, 1, values)?;
/// let pair = DirectionPair::isotropic(0.8_f64, 0.5, 0.2);
/// assert!((table.factors(&pair)[0] - 0.4).abs() < 1e-3);
/// # Ok::<(), glanz_bsdf::FactorTableError>(())
/// ```
#[derive(Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Plain", into = "Plain")]
pub struct FactorTable {
    sizes: [usize; 4],
    ranks: usize,
    /// Of each node its ranks, in groups that are filled up with 0.
    values: Vec<[f32; GROUP]>,
}

/// Why numbers are no table of factors.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FactorTableError {
    /// An axis is too short or too long.
    #[error("a table of {0:?} nodes: axes have 2 to 512 nodes, the fourth 1 to 512")]
    Sizes([usize; 4]),
    /// There are no ranks, or too many.
    #[error("{0} ranks: there are 1 to 8")]
    Ranks(usize),
    /// There are too few or too many numbers.
    #[error("expected {expected} factors, found {found}")]
    Count {
        /// As many as nodes times ranks.
        expected: usize,
        /// As many as there are.
        found: usize,
    },
    /// One is not finite.
    #[error("factor {0} is not finite")]
    NotFinite(usize),
}

/// The table as it is serialised.
#[derive(Serialize, Deserialize)]
#[serde(rename = "FactorTable", deny_unknown_fields)]
struct Plain {
    sizes: [usize; 4],
    ranks: usize,
    values: Vec<f32>,
}

impl TryFrom<Plain> for FactorTable {
    type Error = FactorTableError;
    fn try_from(plain: Plain) -> Result<Self, FactorTableError> {
        Self::new(plain.sizes, plain.ranks, plain.values)
    }
}

impl From<FactorTable> for Plain {
    fn from(table: FactorTable) -> Self {
        Self { sizes: table.sizes, ranks: table.ranks, values: table.values() }
    }
}

impl fmt::Debug for FactorTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z, w] = self.sizes;
        write!(f, "FactorTable({x} × {y} × {z} × {w}, {} ranks)", self.ranks)
    }
}

impl FactorTable {
    /// The most ranks of a table.
    pub const MOST_RANKS: usize = 2 * GROUP;

    /// A table from the ranks of its nodes, in the order of [`FactorTable::nodes`].
    ///
    /// # Errors
    ///
    /// [`FactorTableError`] where the numbers are none.
    pub fn new(sizes: [usize; 4], ranks: usize, values: Vec<f32>) -> Result<Self, FactorTableError> {
        let [x, y, z, w] = sizes;
        if [x, y, z].iter().any(|size| !(2..=512).contains(size)) || !(1..=512).contains(&w) {
            return Err(FactorTableError::Sizes(sizes));
        }
        if !(1..=Self::MOST_RANKS).contains(&ranks) {
            return Err(FactorTableError::Ranks(ranks));
        }
        let (expected, found) = (sizes.iter().product::<usize>() * ranks, values.len());
        if expected != found {
            return Err(FactorTableError::Count { expected, found });
        }
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            return Err(FactorTableError::NotFinite(at));
        }
        let groups = values.chunks(ranks).flat_map(|node| {
            node.chunks(GROUP).map(|part| core::array::from_fn(|i| part.get(i).copied().unwrap_or(0.0)))
        });
        Ok(Self { sizes, ranks, values: groups.collect() })
    }

    /// The directions to viewer and light at each node, along the first axis fastest. Some are below the horizon.
    pub fn nodes(sizes: [usize; 4]) -> Vec<[Vec3<f64>; 2]> {
        let [nx, ny, nz, nw] = sizes;
        let is_isotropic = nw == 1;
        let step = |i: usize, n: usize| i as f64 / (n - 1).max(1) as f64;
        let mut nodes = Vec::with_capacity(sizes.iter().product());
        for l in 0..nw {
            let half_azimuth = if is_isotropic { [1.0, 0.0] } else { around(l as f64 / nw as f64) };
            for k in 0..nz {
                let azimuth = match is_isotropic {
                    true => {
                        let z = 2.0 * step(k, nz) - 1.0;
                        [z, libm::sqrt((1.0 - z * z).max(0.0))]
                    }
                    false => around(k as f64 / nz as f64),
                };
                for j in 0..ny {
                    for i in 0..nx {
                        nodes.push(directions(step(i, nx), step(j, ny), azimuth, half_azimuth));
                    }
                }
            }
        }
        nodes
    }

    /// Nodes along the axes; the last is 1 where there is no grain.
    pub fn sizes(&self) -> [usize; 4] {
        self.sizes
    }

    /// How many factors there are for a pair of directions.
    pub fn ranks(&self) -> usize {
        self.ranks
    }

    /// Whether factors depend on where the tangent is.
    pub fn is_anisotropic(&self) -> bool {
        self.sizes[3] > 1
    }

    /// The ranks of all nodes, as [`FactorTable::new`] takes them.
    pub fn values(&self) -> Vec<f32> {
        let groups = self.groups();
        let nodes = self.values.chunks(groups);
        nodes.flat_map(|node| node.as_flattened()[..self.ranks].iter().copied()).collect()
    }

    /// How much memory the factors take.
    pub fn bytes(&self) -> usize {
        size_of_val(self.values.as_slice())
    }

    fn groups(&self) -> usize {
        self.ranks.div_ceil(GROUP)
    }

    /// All factors of a pair, those from [`FactorTable::ranks`] on being 0. In double precision, too, they are looked up in
    /// single precision.
    #[inline(never)]
    pub fn factors<R: Real>(&self, pair: &DirectionPair<R>) -> [R; Self::MOST_RANKS] {
        pair.cos_o.at_own_level(
            #[inline(always)]
            || self.factors_here(pair),
        )
    }

    #[inline(always)]
    fn factors_here<R: Real>(&self, pair: &DirectionPair<R>) -> [R; Self::MOST_RANKS] {
        let zero = pair.cos_o.zero();
        let places = self.places(pair).map(R::to_array);
        let mut columns = [[0.0_f32; 16]; Self::MOST_RANKS];
        for lane in 0..R::LANES {
            let place = places.map(|axis| axis[lane]);
            for group in 0..self.groups() {
                let values = match self.is_anisotropic() {
                    true => self.between_around(place, group),
                    false => self.between(place, group),
                };
                for (rank, value) in values.into_iter().enumerate() {
                    columns[GROUP * group + rank][lane] = value;
                }
            }
        }
        columns.map(|column| zero.with_array(&column))
    }

    /// Where a pair is among the nodes, along each axis.
    #[inline(always)]
    fn places<R: Real>(&self, pair: &DirectionPair<R>) -> [R; 4] {
        let (zero, one) = (pair.cos_o.zero(), pair.cos_o.one());
        let (cos_h, cos_d) = (pair.cos_half().clamp(0.0, 1.0), pair.cos_view_half());
        let (off_h, off_d) = (one - cos_h, one - cos_d);
        let sine = |cosine: R, off: R| (off * (one + cosine)).sqrt();
        let (sin_h, sin_d) = (sine(cos_h, off_h), sine(cos_d, off_d));
        let last = |axis: usize| zero.lit((self.sizes[axis] - 1) as f64);
        let (x, y) = (off_h.sqrt().sqrt() * last(0), off_d.sqrt() * last(1));
        let half = zero.lit(0.5);
        let cosine = (pair.cos_i - pair.cos_o) * half / (sin_h * sin_d).max(zero.lit(1e-12));
        let cosine = cosine.clamp(-1.0, 1.0);
        if !self.is_anisotropic() {
            return [x, y, (cosine + one) * half * last(2), zero];
        }
        let (hx, hy) = (pair.tangent_o.0 + pair.tangent_i.0, pair.tangent_o.1 + pair.tangent_i.1);
        let across = hx * pair.tangent_i.1 - hy * pair.tangent_i.0;
        let length = (hx.sqr() + hy.sqr()).max(zero.lit(NO_AZIMUTH)).sqrt();
        let sine = across / (length * sin_d).max(zero.lit(1e-12));
        let turn = |c: R, s: R, axis: usize| quarter_turns(c, s) * zero.lit(0.25 * self.sizes[axis] as f64);
        [x, y, turn(cosine, sine, 2), turn(hx, hy, 3)]
    }

    /// A group of ranks between the nodes of three axes.
    #[inline(always)]
    fn between(&self, [x, y, z, _]: [f32; 4], group: usize) -> [f32; GROUP] {
        let [nx, ny, nz, _] = self.sizes;
        let groups = self.groups();
        let ((i, x), (j, y), (k, z)) = (split(x, nx), split(y, ny), split(z, nz));
        let at = |k: usize, j: usize| {
            let first = ((k * ny + j) * nx + i) * groups + group;
            mix(self.values[first], self.values[first + groups], x)
        };
        let plane = |k: usize| mix(at(k, j), at(k, j + 1), y);
        mix(plane(k), plane(k + 1), z)
    }

    /// A group of ranks between the nodes of four axes, of which the last two go around.
    #[inline(always)]
    fn between_around(&self, [x, y, z, w]: [f32; 4], group: usize) -> [f32; GROUP] {
        let [nx, ny, nz, nw] = self.sizes;
        let groups = self.groups();
        let ((i, x), (j, y)) = (split(x, nx), split(y, ny));
        let ((k, k1, z), (l, l1, w)) = (split_around(z, nz), split_around(w, nw));
        let at = |l: usize, k: usize, j: usize| {
            let first = (((l * nz + k) * ny + j) * nx + i) * groups + group;
            mix(self.values[first], self.values[first + groups], x)
        };
        let plane = |l: usize, k: usize| mix(at(l, k, j), at(l, k, j + 1), y);
        let block = |l: usize| mix(plane(l, k), plane(l, k1), z);
        mix(block(l), block(l1), w)
    }
}

/// The node before a place, and how far after it the place is.
#[inline(always)]
fn split(place: f32, nodes: usize) -> (usize, f32) {
    let place = Real::clamp(place, 0.0, (nodes - 1) as f64);
    let whole = (place as usize).min(nodes - 2);
    (whole, place - whole as f32)
}

/// The nodes before and after a place on a circle, and how far after the first one it is.
#[inline(always)]
fn split_around(place: f32, nodes: usize) -> (usize, usize, f32) {
    let place = Real::clamp(place, 0.0, nodes as f64);
    let whole = (place as usize).min(nodes - 1);
    (whole, if whole + 1 == nodes { 0 } else { whole + 1 }, place - whole as f32)
}

#[inline(always)]
fn mix(a: [f32; GROUP], b: [f32; GROUP], t: f32) -> [f32; GROUP] {
    core::array::from_fn(
        #[inline(always)]
        |i| a[i] + (b[i] - a[i]) * t,
    )
}

/// Quarters of a turn, 0 … 4, that (c, s) is away from −90°: linear in s / (|c| + |s|) in each quadrant.
#[inline(always)]
fn quarter_turns<R: Real>(c: R, s: R) -> R {
    let (one, zero) = (c.one(), c.zero());
    let part = s / (c.abs() + s.abs()).max(zero.lit(1e-20));
    let three = one.lit(3.0);
    (three - part).select(c.lt(zero), one + part)
}

/// Cosine and sine of the angle that is this part of a turn away from −90°, as [`quarter_turns`] counts.
fn around(part: f64) -> [f64; 2] {
    let turns = 4.0 * part;
    let (s, c) = match turns {
        _ if turns <= 2.0 => (turns - 1.0, 1.0 - libm::fabs(turns - 1.0)),
        _ => (3.0 - turns, libm::fabs(3.0 - turns) - 1.0),
    };
    let length = libm::sqrt(s * s + c * c);
    [c / length, s / length]
}

/// The directions to viewer and light where the axes say x, y, −cosφd with sinφd, and cosφh with sinφh.
fn directions(x: f64, y: f64, [c, s]: [f64; 2], [cos_t, sin_t]: [f64; 2]) -> [Vec3<f64>; 2] {
    let (cos_h, cos_d) = (1.0 - x * x * x * x, 1.0 - y * y);
    let sine = |cosine: f64| libm::sqrt((1.0 - cosine * cosine).max(0.0));
    let (sin_h, sin_d) = (sine(cos_h), sine(cos_d));
    let half = Vec3::new(sin_h * cos_t, sin_h * sin_t, cos_h);
    let along = Vec3::new(-cos_h * cos_t, -cos_h * sin_t, sin_h);
    let across = Vec3::new(-sin_t, cos_t, 0.0);
    let off = (along * c + across * s) * sin_d;
    [half * cos_d - off, half * cos_d + off]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn pair([wo, wi]: [Vec3<f64>; 2]) -> DirectionPair<f64> {
        DirectionPair::new(wo, wi)
    }

    /// Places are looked up in single precision, and the quotient that an azimuth is loses digits where both of its parts are
    /// small.
    const AT_NODES: f32 = 0.02;

    #[test]
    fn nodes_are_where_they_are_looked_up() {
        for sizes in [[9, 8, 7, 1], [6, 5, 8, 12]] {
            let count = sizes.iter().product::<usize>();
            let table = FactorTable::new(sizes, 1, (0..count).map(|i| (i % 97) as f32).collect());
            let table = table.expect("it has as many values as nodes");
            let mut tried = 0;
            for (i, node) in FactorTable::nodes(sizes).into_iter().enumerate() {
                let on_axis = i % sizes[0] == 0 || i / sizes[0] % sizes[1] == 0;
                // Opposite directions have no half vector.
                if on_axis || i / sizes[0] % sizes[1] == sizes[1] - 1 {
                    continue;
                }
                let place = table.places(&pair(node));
                let [x, y, z, w] = place.map(|axis| axis as f32);
                let [nx, ny, nz, nw] = sizes;
                let expected = [i % nx, i / nx % ny, i / (nx * ny) % nz, i / (nx * ny * nz)];
                for (axis, (got, expected)) in [x, y, z, w].into_iter().zip(expected).enumerate() {
                    let off = (got - expected as f32).abs();
                    let off = if nw > 1 && axis > 1 { off.min(sizes[axis] as f32 - off) } else { off };
                    assert!(off < 1e-5, "{i}, axis {axis}: {got} for {expected}");
                }
                let got = table.factors(&pair(node))[0] as f32;
                assert!((got - (i % 97) as f32).abs() < 97.0 * AT_NODES, "{i}: {got}");
                tried += 1;
            }
            assert!(tried > 200, "{tried}");
        }
    }

    #[test]
    fn ranks_keep_their_places_and_survive_serde() {
        let sizes = [2, 2, 2, 1];
        for ranks in [1, 3, 4, 5, 8] {
            let values: Vec<f32> = (0..8 * ranks).map(|i| (i % ranks) as f32).collect();
            let table = FactorTable::new(sizes, ranks, values.clone()).expect("as many as nodes");
            let factors = table.factors(&DirectionPair::isotropic(0.9_f64, 0.4, 0.3));
            for (rank, factor) in factors.into_iter().enumerate() {
                assert_eq!(factor, if rank < ranks { rank as f64 } else { 0.0 });
            }
            assert_eq!(table.values(), values);
            let text = serde_json::to_string(&table).expect("tables are plain");
            assert_eq!(serde_json::from_str::<FactorTable>(&text).expect("it was written so"), table);
        }
        assert_eq!(FactorTable::new(sizes, 9, vec![0.0; 72]), Err(FactorTableError::Ranks(9)));
        assert_eq!(
            FactorTable::new([1, 2, 2, 1], 1, vec![0.0; 4]),
            Err(FactorTableError::Sizes([1, 2, 2, 1]))
        );
        let count = FactorTableError::Count { expected: 8, found: 7 };
        assert_eq!(FactorTable::new(sizes, 1, vec![0.0; 7]), Err(count));
        assert_eq!(FactorTable::new(sizes, 1, vec![f32::NAN; 8]), Err(FactorTableError::NotFinite(0)));
    }

    proptest! {
        #[test]
        fn any_pair_has_a_factor_between_those_of_the_nodes(
            theta_o in 0.0..1.57_f64, phi_o in 0.0..6.2_f64, theta_i in 0.0..3.1_f64, phi_i in 0.0..6.2_f64,
        ) {
            let (wo, wi) = (Vec3::from_angles(theta_o, phi_o), Vec3::from_angles(theta_i, phi_i));
            for sizes in [[5, 4, 3, 1], [5, 4, 3, 6]] {
                let count = sizes.iter().product::<usize>();
                let values = (0..count).map(|i| 1.0 + (i % 7) as f32).collect();
                let table = FactorTable::new(sizes, 1, values).expect("as many as nodes");
                let factor = table.factors(&DirectionPair::new(wo, wi))[0];
                prop_assert!((1.0..=7.0).contains(&factor), "{factor}");
                let single = |w: Vec3<f64>| Vec3::new(w.x as f32, w.y as f32, w.z as f32);
                let single = DirectionPair::new(single(wo), single(wi));
                let factor = table.factors(&single)[0];
                prop_assert!((1.0..=7.0).contains(&factor), "{factor}");
            }
        }
    }
}
