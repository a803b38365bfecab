//! A lobe as a sum of lookups in the chain of an environment.

use glanz_math::{PI, Real};

/// Angles of the view, from 0 to the last in equal steps.
pub const VIEWS: usize = 18;

/// The flattest view, in radians; beyond, the lobe is turned with the mirrored direction as it is.
pub const FLATTEST: f64 = 85.0 / 180.0 * PI;

/// One of the lookups that stand for a lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Lookup {
    /// Unit vector in the lobe's frame: y across the plane of view, z the mirrored direction (of light that passes: the
    /// refracted one), x up from it towards the normal and the viewer.
    pub direction: [f32; 3],
    /// The width's place in the chain, in half octaves.
    pub place: f32,
    /// Its fraction of the lobe.
    pub amount: f32,
}

/// The lookups of a lobe over the angle of the view, and over its azimuth where the lobe has a grain.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeLookups {
    /// Lookups of one view.
    pub count: usize,
    /// Azimuths from the lobe's x axis, in equal steps; one of lobes without a grain.
    pub azimuths: usize,
    /// The last azimuth in quarters of a turn: 1 where the lobe is the same on both sides of both of its axes, 4 where
    /// not.
    pub quarters: usize,
    /// By azimuth, view and number.
    pub lookups: Vec<Lookup>,
    /// By azimuth and view: the fraction of the lobe that is the clamped cosine about the normal. Empty of narrow lobes.
    pub cosine: Vec<f32>,
    /// Whether lookups mix levels that are a whole octave apart, everywhere.
    pub wide: bool,
}

/// Where a view is among those of the table.
pub(crate) struct ViewPlace<R> {
    /// The number of the lower node of each lane, by azimuth and view, and how far the view is on the way to the next.
    pub node: [u32; 16],
    pub t: R,
    /// The same of azimuths: the step to the next one in nodes, and how far it is.
    pub next: [u32; 16],
    pub around: Option<R>,
    /// −1 where the lobe is seen from its other side, so that y is turned.
    pub side: R,
}

impl LobeLookups {
    /// Where a view is; `azimuth` is that of the viewer from the lobe's x axis, of lobes that have a grain.
    #[inline(always)]
    pub(crate) fn place<R: Real>(&self, cos_o: R, azimuth: Option<R>) -> ViewPlace<R> {
        let last = (VIEWS - 1) as f64;
        let along = (cos_o.acos() * cos_o.lit(last / FLATTEST)).clamp(0.0, last);
        let (mut node, mut next) = ([0; 16], [0; 16]);
        let t = along - whole(along, last - 1.0, 1, &mut node);
        let one = cos_o.one();
        let (mut side, mut around) = (one, None);
        if let Some(azimuth) = azimuth.filter(|_| self.azimuths > 1) {
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
            next = [VIEWS as u32; 16];
        }
        ViewPlace { node, t, next, around, side }
    }

    /// A lookup at a view: its direction, place and amount.
    #[inline(always)]
    pub(crate) fn at<R: Real>(&self, place: &ViewPlace<R>, number: usize) -> [R; 5] {
        let value = |node: u32| self.lookups[node as usize * self.count + number].values();
        place.between(value)
    }

    /// The amount of the clamped cosine at a view; none where there is none.
    #[inline(always)]
    pub(crate) fn cosine_at<R: Real>(&self, place: &ViewPlace<R>) -> Option<R> {
        if self.cosine.is_empty() {
            return None;
        }
        let [amount] = place.between(|node| [self.cosine[node as usize]]);
        Some(amount)
    }
}

impl Lookup {
    /// Direction, place and amount.
    #[inline(always)]
    pub fn values(&self) -> [f32; 5] {
        let [x, y, z] = self.direction;
        [x, y, z, self.place, self.amount]
    }
}

impl<R: Real> ViewPlace<R> {
    /// What is linear between the nodes.
    #[inline(always)]
    fn between<const N: usize>(&self, value: impl Fn(u32) -> [f32; N]) -> [R; N] {
        let like = self.t;
        let mut arrays = [[[0.0; 16]; N]; 4];
        let corners = if self.around.is_some() { 4 } else { 2 };
        for lane in 0..R::LANES {
            let node = self.node[lane];
            for (corner, arrays) in arrays[..corners].iter_mut().enumerate() {
                let node = node + (corner as u32 & 1) + (corner as u32 >> 1) * self.next[lane];
                for (array, value) in arrays.iter_mut().zip(value(node)) {
                    array[lane] = value;
                }
            }
        }
        let mut values = [like; N];
        for (i, own) in values.iter_mut().enumerate() {
            let corner = [0, 1, 2, 3].map(#[inline(always)] |corner: usize| like.with_array(&arrays[corner][i]));
            let here = corner[0] + (corner[1] - corner[0]) * self.t;
            *own = match self.around {
                Some(around) => {
                    let there = corner[2] + (corner[3] - corner[2]) * self.t;
                    here + (there - here) * around
                }
                None => here,
            };
        }
        values
    }
}

/// The whole part of a number from 0 on, no more than `most`; so many steps of it are added to the nodes.
#[inline(always)]
fn whole<R: Real>(value: R, most: f64, step: u32, nodes: &mut [u32; 16]) -> R {
    let mut whole = value.min(value.lit(most)).to_array();
    for (whole, node) in whole.iter_mut().zip(nodes) {
        let floor = *whole as u32;
        *node += step * floor;
        *whole = floor as f32;
    }
    value.with_array(&whole)
}
