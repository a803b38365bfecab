//! Directional albedo over the angle of the viewer.

use glanz_bsdf::albedo_with;

use super::lobe::Lobe;
use super::plot::{LobePlot, MOST_CURVES};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart};
use crate::page::{curve_color, curve_dash};
use crate::words::Word;

/// The view angles, in degrees: every 2°, and closer where lobes begin to leave the surface.
const NEAR_HORIZON: [f64; 6] = [85.0, 87.0, 88.5, 89.0, 89.4, 89.8];

/// View angles up to this, in degrees, decide on the scale: nearer to the horizon some models grow without bound.
const CLEAR: f64 = 85.0;

impl LobePlot {
    /// The directional albedo over the angle of the viewer, a curve for each lobe; [`theta_deg`](Self::theta_deg)
    /// and [`quantity`](Self::quantity) do not matter.
    ///
    /// # Errors
    /// Those of lobes that have no direction.
    pub fn albedo(&self) -> Result<LineChart, Error> {
        self.check_lobes(1, MOST_CURVES)?;
        let mut theta: Vec<f64> = (0..=44).map(|i| 2.0 * f64::from(i)).chain(NEAR_HORIZON).collect();
        theta.sort_by(f64::total_cmp);
        let curve = |(index, lobe): (usize, &Lobe)| {
            let albedo = |theta: &f64| {
                let f_cos = |pair: &_| self.factor.f_cos(&lobe.shape, pair);
                let cosine = libm::cos(theta.to_radians());
                (*theta, albedo_with(&lobe.shape, cosine, self.phi_deg.to_radians(), f_cos))
            };
            Curve {
                name: lobe.label.clone(),
                points: theta.iter().map(albedo).collect(),
                color: curve_color(index),
                dash: curve_dash(index),
            }
        };
        let curves: Vec<_> = self.lobes.iter().enumerate().map(curve).collect();
        let points = || curves.iter().flat_map(|curve| curve.points.iter().copied());
        let values = || points().map(|(_, value)| value);
        let clear = points().filter(|(theta, value)| *theta <= CLEAR && value.is_finite());
        let most = clear.map(|(_, value)| value).fold(0.0, f64::max);
        let label = self.lang.say(Word::PartThatLeaves, &[]);
        let y = match self.log {
            true => Axis::decades_over(label, values(), most),
            // An albedo that is nearly 1 has 1 on its axis.
            false => Axis::round(label, (0.0, if most > 0.6 { most.max(1.0) } else { most }), 6),
        };
        let x = Axis::quarter_turn(self.lang.say(Word::AngleOfViewer, &[]));
        Ok(LineChart {
            title: self.lang.say(Word::Albedo, &[&self.title(Word::SeveralModels)]),
            subtitle: self.subtitle(&self.lang.say(Word::UnderFurnace, &[])),
            x,
            y,
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }
}
