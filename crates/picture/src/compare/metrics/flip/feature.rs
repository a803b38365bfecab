//! The feature side of ꟻLIP: edges and points that one picture has and the other lacks.

use super::super::filter::{Kernel, filter, filter_rows_first};
use super::kernels::FeatureKernels;
use crate::compare::rows::one_plane;

/// The power of the difference; section 4.2.2 of the paper of 2020.
const Q_F: f32 = 0.5;

/// How much of an edge and of a point there is in every pixel.
pub(super) struct Features {
    edge: Vec<f32>,
    point: Vec<f32>,
}

impl Features {
    /// The features in the plane Y of the opponent space.
    pub(super) fn of(y: &[f32], width: usize, height: usize, kernels: &FeatureKernels) -> Self {
        let grey = one_plane(width, height, |i| (y[i] + 16.0) / 116.0);
        let magnitude = |detector: &Kernel<f32>| {
            let across = filter(&grey, width, detector, &kernels.smooth);
            let down = filter_rows_first(&grey, width, &kernels.smooth, detector);
            one_plane(width, height, |i| (across[i] * across[i] + down[i] * down[i]).sqrt())
        };
        Self { edge: magnitude(&kernels.edge), point: magnitude(&kernels.point) }
    }
}

/// The error 0 … 1 of the features of pixel `i`: edges or points, whichever differ more.
pub(super) fn feature_error(first: &Features, second: &Features, i: usize) -> f32 {
    let edge = (first.edge[i] - second.edge[i]).abs();
    let point = (first.point[i] - second.point[i]).abs();
    let difference = edge.max(point) * core::f32::consts::FRAC_1_SQRT_2;
    if difference == 0.0 { 0.0 } else { libm::powf(difference, Q_F).min(1.0) }
}
