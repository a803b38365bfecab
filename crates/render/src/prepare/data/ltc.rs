//! Linearly transformed cosines of a lobe.

use glanz_math::Real;

use super::ViewNodes;
use super::view_nodes::ViewPlace;

/// A clamped cosine that a linear map transforms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct LtcComponent {
    /// The rows of the inverse map, from the frame of [`Lookup::direction`](super::Lookup::direction) to that of the
    /// cosine.
    pub inverse: [f32; 9],
    /// Its fraction of the lobe; it may be below 0.
    pub amount: f32,
}

/// The transformed cosines of a lobe over the angle of the view, and over its azimuth where the lobe has a grain.
#[derive(Clone, Debug, PartialEq)]
pub struct LtcTable {
    /// Components of one view.
    pub count: usize,
    /// The views.
    pub nodes: ViewNodes,
    /// By azimuth, view and number.
    pub components: Vec<LtcComponent>,
}

impl LtcTable {
    /// A component at a view: the rows of its inverse map, and its amount.
    #[inline(always)]
    pub(crate) fn at<R: Real>(&self, place: &ViewPlace<R>, number: usize) -> [R; 10] {
        let value = |node: u32| self.components[node as usize * self.count + number].values();
        place.between(value)
    }
}

impl LtcComponent {
    /// The rows of the inverse map, and the amount.
    #[inline(always)]
    pub fn values(&self) -> [f32; 10] {
        let [a, b, c, d, e, f, g, h, i] = self.inverse;
        [a, b, c, d, e, f, g, h, i, self.amount]
    }
}
