//! Tables over four angles.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use glanz_math::Vec3;

use super::LEAST_COSINE;
use super::coordinates::{Coordinates, clamped};
use crate::{Channels, Quantity, ReadError, Readings};

/// A table over four angles, linear between its nodes.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Coordinates, Table};
///
/// let every = |step: usize, last: usize| (0..=last).step_by(step).map(|x| x as f64).collect::<Vec<f64>>();
/// let nodes = [every(15, 75), vec![0.0], every(10, 80), every(30, 330)];
/// let table = Table::of_function(Coordinates::Specular, nodes, Channels::Luminance, &mut |_, wo| vec![wo.z])?;
/// let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
/// let value = table.value(at(30.0, 180.0), at(45.0, 20.0)).expect("it lies between nodes");
/// assert!((value[0] - at(45.0, 0.0).z).abs() < 0.02);
/// // There are no data beyond the last node, nor below the horizon.
/// assert_eq!(table.value(at(85.0, 180.0), at(80.0, 0.0)), None);
/// # Ok::<(), glanz_measure::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    coordinates: Coordinates,
    channels: Channels,
    axes: [Axis; 4],
    quantity: Quantity,
    /// The last angle varies most quickly, then come the channels; what is missing is NaN.
    values: Vec<f32>,
}

/// The nodes of an angle.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    /// Ascending, in radians.
    pub(super) nodes: Vec<f64>,
    pub(super) kind: Kind,
}

/// How an angle goes on beyond its nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// From an axis: half a step beyond its ends it has the value of the end.
    Polar,
    /// From an axis, and beyond the last node along the line through the last two.
    PolarContinued,
    /// Around an axis.
    Azimuth,
    /// Around an axis, the same on both sides of the plane of the light.
    MirroredAzimuth,
    /// The azimuth of a difference vector where light and detector may change places.
    ReciprocalAzimuth,
    /// Both of them.
    MirroredReciprocalAzimuth,
}

/// Nodes that a value lies between, and their weights.
type Place = [(usize, f64); 2];

/// What a table is made of.
pub(super) struct Parts {
    pub(super) coordinates: Coordinates,
    pub(super) channels: Channels,
    pub(super) axes: [Axis; 4],
    pub(super) quantity: Quantity,
    pub(super) values: Vec<f32>,
}

impl Table {
    /// Says what is wrong with the parts, if they make no table.
    pub(super) fn new(parts: Parts) -> Result<Self, ReadError> {
        let Parts { coordinates, channels, axes, quantity, values } = parts;
        for axis in &axes {
            axis.check()?;
        }
        let sizes = axes.iter().map(|axis| axis.nodes.len());
        let count = sizes.fold(channels.count(), usize::saturating_mul);
        if count == 0 || values.len() != count {
            let message = format!("the table has {} numbers, and its nodes need {count}", values.len());
            return Err(ReadError::broken(message));
        }
        let mut table = Self { coordinates, channels, axes, quantity, values };
        // With one azimuth of the light the table is one of differences of azimuths.
        if coordinates == Coordinates::Spherical && table.is_isotropic() {
            let from = table.axes[1].nodes[0];
            table.axes[3].nodes.iter_mut().for_each(|phi| *phi -= from);
            table.axes[1].nodes[0] = 0.0;
            table.coordinates = Coordinates::SphericalDifference;
        }
        Ok(table)
    }

    /// A table of a function: `f` gives the BRDF in 1/sr, one number per channel, for a direction to the light and one to
    /// the detector. `nodes_deg` are the nodes of the four angles in degrees, ascending; the second is the azimuth of the
    /// light (of the half vector), and has one node where the function depends on differences of azimuths alone; then the
    /// last may go from 0 to 180 only, and stands for both sides of the plane of the light. Nodes whose light or detector
    /// is below the horizon have no data.
    ///
    /// # Errors
    ///
    /// [`ReadError::Broken`] where nodes are missing or do not ascend.
    pub fn of_function(
        coordinates: Coordinates,
        nodes_deg: [Vec<f64>; 4],
        channels: Channels,
        f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
    ) -> Result<Self, ReadError> {
        let is_half = nodes_deg[1].len() == 1 && nodes_deg[3].last().is_some_and(|last| *last == 180.0);
        let around = if is_half { Kind::MirroredAzimuth } else { Kind::Azimuth };
        let [a, b, c, d] = &nodes_deg;
        let kinds = [(a, Kind::Polar), (b, Kind::Azimuth), (c, Kind::Polar), (d, around)];
        let axes = kinds.map(|(nodes, kind)| Axis::of_degrees(nodes, kind));
        let count = channels.count();
        let nodes: usize = axes.iter().map(|axis| axis.nodes.len()).product();
        let values = vec![f32::NAN; nodes * count];
        let mut table = Self::new(Parts { coordinates, channels, axes, quantity: Quantity::Brdf, values })?;
        for node in 0..nodes {
            let [wi, wo] = table.pair(node);
            // Some of them lie at the horizon, where functions may be without bounds.
            if wi.z > -1e-9 && wo.z > -1e-9 {
                let all = f(clamped(wi), clamped(wo));
                (0..count).for_each(|c| table.values[node * count + c] = all[c] as f32);
            }
        }
        Ok(table)
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        &self.channels
    }

    /// Which angles it is over.
    pub fn coordinates(&self) -> Coordinates {
        self.coordinates
    }

    /// The nodes of the four angles, in degrees.
    pub fn nodes_deg(&self) -> [Vec<f64>; 4] {
        [0, 1, 2, 3].map(|axis| self.axes[axis].nodes.iter().map(|x| rounded(x.to_degrees())).collect())
    }

    /// Whether the values depend on differences of azimuths alone.
    pub fn is_isotropic(&self) -> bool {
        self.axes[1].nodes.len() == 1
    }

    /// Whether it is given for one side of the plane of the light, and stands for both.
    pub fn is_mirrored(&self) -> bool {
        matches!(self.axes[3].kind, Kind::MirroredAzimuth | Kind::MirroredReciprocalAzimuth)
    }

    /// The BRDF of each channel between the nodes; nothing below the horizon, beyond the nodes, and where more than half
    /// of what it would be made of is missing.
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        self.mixed(wi, wo, false)
    }

    /// As [`Table::value`], and beyond the nodes what is at the nearest of them.
    pub fn extended(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        self.mixed(wi, wo, true)
    }

    fn mixed(&self, wi: Vec3<f64>, wo: Vec3<f64>, extend: bool) -> Option<Vec<f64>> {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return None;
        }
        let angles = self.coordinates.angles(wi, wo);
        let mut places = [[(0, 0.0); 2]; 4];
        for ((place, axis), angle) in places.iter_mut().zip(&self.axes).zip(angles) {
            *place = axis.place(angle, extend)?;
        }
        let count = self.channels.count();
        let (mut sum, mut known) = (vec![0.0; count], 0.0);
        for corner in 0..16_usize {
            let (mut node, mut weight) = (0, 1.0);
            for (axis, place) in places.iter().enumerate() {
                let (at, part) = place[corner >> axis & 1];
                node = node * self.axes[axis].nodes.len() + at;
                weight *= part;
            }
            let values = &self.values[node * count..(node + 1) * count];
            if weight != 0.0 && values.iter().all(|value| value.is_finite()) {
                known += weight;
                sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * f64::from(*value));
            }
        }
        let least = if extend { 1e-9 } else { 0.5 };
        let is_continued = self.axes.iter().any(|axis| axis.kind == Kind::PolarContinued);
        let of = |value: &f64| {
            let value = if is_continued { (value / known).max(0.0) } else { value / known };
            self.quantity.brdf(value, wo.z.max(LEAST_COSINE))
        };
        if known < least { None } else { sum.iter().map(of).collect() }
    }

    /// Takes numbers of 0 below the horizon as what they are, none.
    pub(super) fn drop_zeros_below_horizon(&mut self) {
        let count = self.channels.count();
        for node in 0..self.len() {
            let [wi, wo] = self.pair(node);
            let values = &mut self.values[node * count..(node + 1) * count];
            if wi.z.min(wo.z) <= 1e-12 && values.iter().all(|value| *value == 0.0) {
                values.fill(f32::NAN);
            }
        }
    }

    /// The number of nodes.
    pub(super) fn len(&self) -> usize {
        self.values.len() / self.channels.count()
    }

    /// The values at a node, as they are in the file.
    fn values(&self, node: usize) -> &[f32] {
        let count = self.channels.count();
        &self.values[node * count..(node + 1) * count]
    }

    /// The BRDF of a channel at a node; NaN where there is none.
    pub(super) fn brdf(&self, node: usize, channel: usize) -> f32 {
        let [_, wo] = self.pair(node);
        let value = f64::from(self.values(node)[channel]);
        self.quantity.brdf(value, wo.z.max(LEAST_COSINE)).unwrap_or(f64::NAN) as f32
    }

    /// The directions of a node, to the light and to the detector.
    pub(super) fn pair(&self, node: usize) -> [Vec3<f64>; 2] {
        let mut rest = node;
        let mut angles = [0.0; 4];
        for axis in (0..4).rev() {
            let nodes = &self.axes[axis].nodes;
            angles[axis] = nodes[rest % nodes.len()];
            rest /= nodes.len();
        }
        if self.is_isotropic() {
            angles[1] = self.coordinates.default_azimuth();
        }
        self.coordinates.pair(angles)
    }

    /// The readings at the nodes above the horizon that have one.
    pub(crate) fn readings(&self) -> Readings {
        let mut readings = Readings::new(self.channels.clone());
        for node in 0..self.len() {
            let ([wi, wo], values) = (self.pair(node), self.values(node));
            // An angle of 90° may come out as a little more.
            if wi.z < -1e-12 || wo.z < -1e-12 || values.iter().all(|value| value.is_nan()) {
                continue;
            }
            let of = |value: &f32| self.quantity.brdf(f64::from(*value), wo.z).unwrap_or(f64::NAN) as f32;
            readings.push(wi, wo, &values.iter().map(of).collect::<Vec<f32>>());
        }
        readings
    }
}

/// To a billionth of a degree, which the way to radians and back does not keep.
fn rounded(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9
}

impl Axis {
    pub(super) fn of_degrees(nodes: &[f64], kind: Kind) -> Self {
        Self { nodes: nodes.iter().map(|x| x.to_radians()).collect(), kind }
    }

    fn check(&self) -> Result<(), ReadError> {
        let nodes = &self.nodes;
        if nodes.is_empty() || nodes.iter().any(|x| !x.is_finite() || x.abs() > 4.0 * TAU) {
            return Err(ReadError::broken("an axis of the table has no angles, or such as are none"));
        }
        match nodes.windows(2).find(|pair| pair[0] >= pair[1]) {
            Some(pair) => Err(ReadError::broken(format!(
                "angles of the table must ascend, and {} is followed by {}",
                rounded(pair[0].to_degrees()),
                rounded(pair[1].to_degrees())
            ))),
            None => Ok(()),
        }
    }

    /// The nodes that an angle lies between; nothing beyond them, but where it is to be extended.
    fn place(&self, angle: f64, extend: bool) -> Option<Place> {
        if self.nodes.len() == 1 {
            return Some([(0, 1.0), (0, 0.0)]);
        }
        match self.kind {
            Kind::Polar | Kind::PolarContinued => self.polar(angle, extend),
            Kind::Azimuth => self.around(angle, TAU, extend),
            Kind::MirroredAzimuth => self.around_either(angle, TAU, extend),
            Kind::ReciprocalAzimuth => self.around(angle, PI, extend),
            Kind::MirroredReciprocalAzimuth => self.around_either(angle, PI, extend),
        }
    }

    fn ends(&self) -> [f64; 2] {
        [self.nodes[0], self.nodes[self.nodes.len() - 1]]
    }

    fn polar(&self, angle: f64, extend: bool) -> Option<Place> {
        let (nodes, n) = (&self.nodes, self.nodes.len());
        let [first, last] = self.ends();
        let low = first - 0.5 * (nodes[1] - first) - 1e-9;
        let high = last + 0.5 * (last - nodes[n - 2]) + 1e-9;
        if self.kind == Kind::PolarContinued && angle > last && angle <= FRAC_PI_2 {
            let beyond = (angle - last) / (last - nodes[n - 2]);
            return Some([(n - 2, -beyond), (n - 1, 1.0 + beyond)]);
        }
        (extend || (low..=high).contains(&angle)).then(|| self.between(angle))
    }

    fn between(&self, angle: f64) -> Place {
        let n = self.nodes.len();
        let index = self.nodes.partition_point(|node| *node <= angle).saturating_sub(1).min(n - 2);
        let (low, high) = (self.nodes[index], self.nodes[index + 1]);
        let part = ((angle - low) / (high - low)).clamp(0.0, 1.0);
        [(index, 1.0 - part), (index + 1, part)]
    }

    /// The place of an angle that repeats after a turn.
    fn around(&self, angle: f64, turn: f64, extend: bool) -> Option<Place> {
        let n = self.nodes.len();
        let [first, last] = self.ends();
        let turned = first + (angle - first) - turn * libm::floor((angle - first + 1e-9) / turn);
        if turned <= last + 1e-9 {
            return Some(self.between(turned));
        }
        let widest = self.nodes.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        let gap = first + turn - last;
        // A gap no wider than a step is one of a circle that is closed.
        if gap <= 1.5 * widest {
            let part = (turned - last) / gap;
            return Some([(n - 1, 1.0 - part), (0, part)]);
        }
        let is_near_last = turned - last < 0.5 * gap;
        extend.then(|| if is_near_last { [(n - 1, 1.0), (0, 0.0)] } else { [(0, 1.0), (n - 1, 0.0)] })
    }

    /// The place of an angle or, where there is none, of the one on the other side.
    fn around_either(&self, angle: f64, turn: f64, extend: bool) -> Option<Place> {
        let place = self.around(angle, turn, false).or_else(|| self.around(-angle, turn, false));
        // Cells have their nodes in their middle.
        let [first, last] = self.ends();
        let is_cell = first > 0.0 && turn * 0.5 - last <= 1.01 * first;
        place.or_else(|| self.around(angle, turn, extend || is_cell))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(kind: Kind, nodes: &[f64], angle: f64) -> Option<f64> {
        let axis = Axis::of_degrees(nodes, kind);
        let place = axis.place(angle.to_radians(), false)?;
        Some(place.iter().map(|(node, weight)| nodes[*node] * weight).sum())
    }

    fn is(found: Option<f64>, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-9)
    }

    #[test]
    fn angles_lie_between_nodes() {
        let polar = |angle| at(Kind::Polar, &[10.0, 20.0, 40.0], angle);
        assert!(
            is(polar(15.0), 15.0) && is(polar(30.0), 30.0) && is(polar(6.0), 10.0) && is(polar(49.0), 40.0)
        );
        assert_eq!((polar(4.0), polar(51.0)), (None, None));
        assert!(is(at(Kind::PolarContinued, &[0.0, 60.0, 75.0], 90.0), 90.0));
    }

    #[test]
    fn azimuths_go_around() {
        let circle = |angle| at(Kind::Azimuth, &[0.0, 90.0, 180.0, 270.0], angle);
        assert!(is(circle(45.0), 45.0) && is(circle(-90.0), 270.0) && is(circle(315.0), 135.0));
        assert!(is(circle(765.0), 45.0));
        let half = [0.0, 90.0, 180.0];
        assert_eq!(at(Kind::Azimuth, &half, 200.0), None);
        assert!(is(at(Kind::MirroredAzimuth, &half, 200.0), 160.0));
        assert!(is(at(Kind::MirroredAzimuth, &[45.0, 135.0], 350.0), 45.0));
        assert!(is(at(Kind::ReciprocalAzimuth, &half, 200.0), 20.0));
        assert!(is(at(Kind::MirroredReciprocalAzimuth, &[0.0, 90.0], 250.0), 70.0));
    }
}
