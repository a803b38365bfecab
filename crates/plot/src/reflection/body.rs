//! Lobes as bodies.

use glanz_bsdf::Side;
use glanz_math::{Frame, Vec3};

use super::lobe::Lobe;
use super::plot::{LobePlot, MOST_PANELS};
use crate::Error;
use crate::figure::{LobeBodies, LobeBody};
use crate::words::Word;

/// Rings about the axis of a lobe, closer together towards it.
const RINGS: usize = 64;
/// Points of a ring.
const AROUND: usize = 72;
/// The first ring, in radians from the axis.
const FIRST: f64 = 4e-4;
/// The decades that a logarithmic body shows.
const DECADES: f64 = 4.0;

impl LobePlot {
    /// A body for each lobe and view: in each direction of the light as far out as the lobe is strong.
    ///
    /// # Errors
    /// Those of lobes that have no direction, and [`Error::EmptyLobe`].
    pub fn lobe3d(&self) -> Result<LobeBodies, Error> {
        self.check_views(MOST_PANELS)?;
        let mut bodies = Vec::new();
        for lobe in &self.lobes {
            for theta in &self.theta_deg {
                bodies.push(self.body(lobe, *theta)?);
            }
        }
        let label = self.quantity_name();
        let shown = match self.log {
            true => self.lang.say(Word::Logarithmic, &[&label, &self.lang.number(DECADES)]),
            false => label.clone(),
        };
        Ok(LobeBodies {
            title: self.title(Word::Lobes),
            subtitle: self.subtitle_of_values(&self.lang.say(Word::ByLight, &[&shown])),
            bodies,
            label,
            lang: self.lang,
        })
    }

    fn body(&self, lobe: &Lobe, theta: f64) -> Result<LobeBody, Error> {
        let wo = self.wo(theta);
        let transmits = lobe.shape.info().side == Side::Transmission;
        let axis = match transmits {
            true => {
                let bent = (libm::sin(theta.to_radians()) / lobe.shape.eta()).clamp(-1.0, 1.0);
                self.in_plane(180.0 - libm::asin(bent).to_degrees())
            }
            false => self.in_plane(theta),
        };
        let frame = Frame::around(axis);
        let directions: Vec<_> = std::iter::once(0.0)
            .chain((0..RINGS).map(ring))
            .flat_map(|angle| (0..AROUND).map(move |i| about(frame, angle, i)))
            .collect();
        let values: Vec<_> = directions.iter().map(|wi| self.value(lobe, wo, *wi)).collect();
        let most = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let view = format!("{}, θo = {}°", lobe.label, self.lang.number(theta));
        if most <= 0.0 {
            return Err(Error::EmptyLobe { lobe: view });
        }
        let length = |value: f64| match self.log {
            false => value / most,
            true => (1.0 + libm::log10((value / most).max(1e-30)) / DECADES).max(0.0),
        };
        // The plane of incidence stands still, and the tangent turns.
        let (sine, cosine) = libm::sincos(self.phi_deg.to_radians());
        let array = |v: Vec3<f64>| [v.x * cosine + v.y * sine, v.y * cosine - v.x * sine, v.z];
        let points = directions
            .iter()
            .zip(&values)
            .map(|(wi, value)| array(*wi * if value.is_finite() { length(*value) } else { 1.0 }));
        Ok(LobeBody {
            caption: self.lang.say(Word::UpTo, &[&view, &self.lang.number(most)]),
            values: directions.iter().zip(&values).map(|(wi, value)| ([wi.x, wi.y, wi.z], *value)).collect(),
            points: points.collect(),
            columns: AROUND,
            view: array(wo),
            mirror: (!transmits).then(|| array(self.in_plane(theta))),
        })
    }
}

/// The angle of a ring from the axis: geometric near it, even further out, up to half a turn.
fn ring(index: usize) -> f64 {
    let part = index as f64 / (RINGS - 1) as f64;
    let near = FIRST * libm::pow(0.4 / FIRST, (part / 0.6).min(1.0));
    if part <= 0.6 { near } else { 0.4 + (std::f64::consts::PI - 0.4) * (part - 0.6) / 0.4 }
}

/// The direction at an angle from the axis.
fn about(frame: Frame<f64>, angle: f64, index: usize) -> Vec3<f64> {
    let (sine, cosine) = libm::sincos(angle);
    let (s, c) = libm::sincos(std::f64::consts::TAU * index as f64 / AROUND as f64);
    frame.t * (sine * c) + frame.b * (sine * s) + frame.n * cosine
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_widen_from_the_axis_to_its_opposite() {
        let rings: Vec<_> = (0..RINGS).map(ring).collect();
        assert!(rings.windows(2).all(|pair| pair[0] < pair[1]));
        assert!((rings[RINGS - 1] - std::f64::consts::PI).abs() < 1e-12);
    }
}
