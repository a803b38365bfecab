//! The part of the light that leaves, over the angle of the viewer.

use glanz_bsdf::albedo_with;

use super::Request;
use crate::plot::{Axis, Curve, Lines, Picture, color_of_curve, dash_of_curve};

/// The view angles, in degrees: every 2°, and closer where lobes begin to leave the surface.
const NEAR_HORIZON: [f64; 6] = [85.0, 87.0, 88.5, 89.0, 89.4, 89.8];

/// View angles up to this, in degrees, decide on the scale: nearer to the horizon some models grow without bound.
const CLEAR: f64 = 85.0;

impl Request<'_> {
    /// A curve for each lobe.
    pub(super) fn albedo(&self) -> Picture {
        let mut theta: Vec<f64> = (0..=44).map(|i| 2.0 * f64::from(i)).chain(NEAR_HORIZON).collect();
        theta.sort_by(f64::total_cmp);
        let curve = |(index, case): (usize, &crate::lobes::Case)| {
            let albedo = |theta: &f64| {
                let f_cos = |pair: &_| self.factor.f_cos(&case.shape, pair);
                let cosine = libm::cos(theta.to_radians());
                (*theta, albedo_with(&case.shape, cosine, self.phi.to_radians(), f_cos))
            };
            Curve {
                name: case.label.clone(),
                points: theta.iter().map(albedo).collect(),
                color: color_of_curve(index),
                dash: dash_of_curve(index),
            }
        };
        let curves: Vec<_> = self.cases.iter().enumerate().map(curve).collect();
        let points = || curves.iter().flat_map(|curve| curve.points.iter().copied());
        let values = || points().map(|(_, value)| value);
        let clear = points().filter(|(theta, value)| *theta <= CLEAR && value.is_finite());
        let most = clear.map(|(_, value)| value).fold(0.0, f64::max);
        const LABEL: &str = "part of the light that leaves";
        let y = match self.log {
            true => super::plane::decades(LABEL, values(), most),
            // An albedo that is nearly 1 has 1 on its axis.
            false => Axis::round(LABEL, (0.0, if most > 0.6 { most.max(1.0) } else { most }), 6),
        };
        let x = Axis::exact("angle of the viewer from the normal in °", (0.0, 90.0), 6);
        Lines {
            title: format!("Directional albedo: {}", self.title("several models")),
            subtitle: self.subtitle("under light of 1 from all around"),
            x: Axis { ticks: (0..=6).map(|i| 15.0 * f64::from(i)).collect(), decimals: 0, ..x },
            y,
            curves,
            marks: Vec::new(),
        }
        .picture()
    }
}
