//! The views that a lobe's integrals are known for.

use glanz_math::{PI, Real};

/// Angles of the view, from 0 to the last in equal steps.
pub const VIEWS: usize = 18;

/// The flattest view, in radians; beyond, a lobe is turned with the mirrored direction as it is.
pub const FLATTEST: f64 = 85.0 / 180.0 * PI;

/// The azimuths of the views of a table whose entries are by azimuth and view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ViewNodes {
    /// Azimuths from the lobe's x axis, in equal steps; one of lobes without a grain.
    pub azimuths: usize,
    /// The last azimuth in quarters of a turn: 1 where the lobe is the same on both sides of both of its axes, 4 where
    /// not.
    pub quarters: usize,
}

/// Where a view is among those of the table.
pub(crate) struct ViewPlace<R> {
    /// The number of the lower node of each lane, by azimuth and view, and how far the view is on the way to the next.
    pub node: [u32; 16],
    pub t: R,
    /// Whether that is one node for all lanes.
    pub is_one: bool,
    /// How far it is to the next azimuth.
    pub around: Option<R>,
    /// −1 where the lobe is seen from its other side, so that y is turned.
    pub side: R,
}

impl ViewNodes {
    /// Where a view is; `tangent` are the coordinates of the viewer on the lobe's x and y axis, of lobes with a grain.
    #[inline(always)]
    pub(crate) fn place<R: Real>(&self, cos_o: R, tangent: Option<[R; 2]>) -> ViewPlace<R> {
        let last = (VIEWS - 1) as f64;
        let along = (cos_o.acos() * cos_o.lit(last / FLATTEST)).clamp(0.0, last);
        let mut node = [0; 16];
        let t = along - whole(along, last - 1.0, 1, &mut node);
        let one = cos_o.one();
        let (mut side, mut around) = (one, None);
        if let Some([x, y]) = tangent.filter(|_| self.azimuths > 1) {
            let azimuth = y.atan2(x);
            let zero = one.zero();
            let turn = one.lit(2.0 * PI);
            let half = one.lit(PI);
            let mut angle = azimuth + turn.select(azimuth.lt(zero), zero);
            if self.quarters == 1 {
                angle = angle - half.select(half.le(angle), zero);
                let other = one.lit(0.5 * PI).lt(angle);
                side = (-one).select(other, one);
                angle = (half - angle).select(other, angle);
            }
            let steps = (self.azimuths - 1) as f64;
            let place = (angle * one.lit(steps / (0.5 * PI * self.quarters as f64))).clamp(0.0, steps);
            around = Some(place - whole(place, steps - 1.0, VIEWS as u32, &mut node));
        }
        let is_one = node[..R::LANES].iter().all(|own| *own == node[0]);
        ViewPlace { node, t, is_one, around, side }
    }
}

impl<R: Real> ViewPlace<R> {
    /// What is linear between the nodes.
    #[inline(always)]
    pub(crate) fn between<const N: usize>(&self, value: impl Fn(u32) -> [f32; N]) -> [R; N] {
        let near = self.corners(0, &value);
        let far = self.corners(1, &value);
        let mut values = [self.t; N];
        for i in 0..N {
            values[i] = near[i] + (far[i] - near[i]) * self.t;
        }
        let Some(around) = self.around else { return values };
        let near = self.corners(VIEWS as u32, &value);
        let far = self.corners(VIEWS as u32 + 1, &value);
        for i in 0..N {
            let there = near[i] + (far[i] - near[i]) * self.t;
            values[i] = values[i] + (there - values[i]) * around;
        }
        values
    }

    /// The values of nodes a few steps on.
    #[inline(always)]
    fn corners<const N: usize>(&self, step: u32, value: &impl Fn(u32) -> [f32; N]) -> [R; N] {
        let mut values = [self.t; N];
        if self.is_one {
            for (own, value) in values.iter_mut().zip(value(self.node[0] + step)) {
                *own = self.t.lit(f64::from(value));
            }
            return values;
        }
        let mut arrays = [[0.0; 16]; N];
        for lane in 0..R::LANES {
            for (array, value) in arrays.iter_mut().zip(value(self.node[lane] + step)) {
                array[lane] = value;
            }
        }
        for (own, array) in values.iter_mut().zip(&arrays) {
            *own = self.t.with_array(array);
        }
        values
    }
}

/// The whole part of a number from 0 on, no more than `most`; so many steps of it are added to the nodes.
#[inline(always)]
fn whole<R: Real>(value: R, most: f64, step: u32, nodes: &mut [u32; 16]) -> R {
    let (numbers, floor) = value.min(value.lit(most)).whole();
    for (number, node) in numbers.into_iter().zip(nodes) {
        *node += step * number as u32;
    }
    floor
}
