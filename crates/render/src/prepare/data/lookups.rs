//! A lobe as a sum of lookups in the chain of an environment.

use glanz_math::Real;

use super::ViewNodes;
use super::view_nodes::ViewPlace;

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
    /// The views.
    pub nodes: ViewNodes,
    /// By azimuth, view and number.
    pub lookups: Vec<Lookup>,
    /// By azimuth and view: the fraction of the lobe that is the clamped cosine about the normal. Empty of narrow lobes.
    pub cosine: Vec<f32>,
    /// Whether lookups mix levels that are a whole octave apart, everywhere.
    pub wide: bool,
}

impl LobeLookups {
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
