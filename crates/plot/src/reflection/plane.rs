//! Lobes in the plane of incidence: polar and over the angle.

use glanz_bsdf::Side;

use super::lobe::Lobe;
use super::plot::{LobePlot, MOST_CURVES, Quantity};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart, LineMark, sampled};
use crate::figure::{PolarChart, Ray};
use crate::page::{Rgb8, curve_color, dash};
use crate::words::Word;

/// How near to the horizon, in degrees, values of f do not decide on the scale.
const HORIZON: f64 = 3.0;
/// The colour of rays that belong to no curve alone.
const RAY: Rgb8 = [0x5b, 0x63, 0x6e];

impl LobePlot {
    /// Values about a point of the surface, in the plane of incidence.
    ///
    /// # Errors
    /// Those of lobes that have no direction, and [`Error::TooManyLobes`].
    pub fn polar(&self) -> Result<PolarChart, Error> {
        self.check_views(MOST_CURVES)?;
        let whole = self.transmits();
        let reach = if whole { 180.0 } else { 90.0 };
        let curves = self.curves(reach);
        let radius = self.axis(&curves, 4);
        let several = self.lobes.len() > 1;
        // One viewer is named, the one furthest from the others' numbers.
        let named = self.theta_deg.iter().copied().fold(0.0, f64::max);
        let rays = self.theta_deg.iter().enumerate().flat_map(|(index, theta)| {
            let color = if several { RAY } else { curve_color(index) };
            let label = if *theta == named { self.lang.say(Word::Viewer, &[]) } else { String::new() };
            let viewer = Ray { degrees: -theta, label, color, dashed: false };
            let label = if *theta == named { self.lang.say(Word::Mirror, &[]) } else { String::new() };
            let mirror = Ray { degrees: *theta, label, color, dashed: true };
            // Seen from above, both are the normal.
            if *theta == 0.0 || !self.reflects() { vec![viewer] } else { vec![viewer, mirror] }
        });
        Ok(PolarChart {
            title: self.title(Word::LobesInPlane),
            subtitle: self.subtitle_of_values(&self.lang.say(Word::ByLight, &[&self.quantity_name()])),
            radius,
            rays: rays.collect(),
            curves,
            clouds: Vec::new(),
            whole,
            lang: self.lang,
        })
    }

    /// The same over the angle of the light.
    ///
    /// # Errors
    /// Those of [`polar`](Self::polar).
    pub fn cartesian(&self) -> Result<LineChart, Error> {
        self.check_views(MOST_CURVES)?;
        let reach = if self.transmits() { 180.0 } else { 90.0 };
        let curves = self.curves(reach);
        let y = self.axis(&curves, 6);
        let several = self.lobes.len() > 1;
        let mark = |(index, theta): (usize, &f64)| LineMark {
            x: *theta,
            label: self.lang.say(Word::MirrorAt, &[&self.lang.number(*theta)]),
            color: if several { RAY } else { curve_color(index) },
        };
        let ticks = (-12..=12)
            .map(|i| 15.0 * f64::from(i))
            .filter(|tick: &f64| tick.abs() <= reach && (reach < 100.0 || tick % 30.0 == 0.0));
        let x = Axis::exact(self.lang.say(Word::AngleOfLight, &[]), (-reach, reach), 12);
        Ok(LineChart {
            title: self.title(Word::LobesInPlane),
            subtitle: self.subtitle_of_values(&self.lang.say(Word::ViewerSide, &[])),
            x: Axis { ticks: ticks.collect(), decimals: 0, ..x },
            y,
            marks: if self.theta_deg.len() <= 4 && self.reflects() {
                self.theta_deg.iter().enumerate().map(mark).collect()
            } else {
                Vec::new()
            },
            curves,
            lang: self.lang,
        })
    }

    /// A curve for each lobe and view: colours tell lobes apart, or views if there is one lobe.
    fn curves(&self, reach: f64) -> Vec<Curve> {
        let several = self.lobes.len() > 1;
        let mut curves = Vec::new();
        for (lobe_index, lobe) in self.lobes.iter().enumerate() {
            for (view_index, theta) in self.theta_deg.iter().enumerate() {
                let (color, dash) = match several {
                    true => (lobe_index, dash(view_index)),
                    false => (view_index, None),
                };
                let view = format!("θo = {}°", self.lang.number(*theta));
                curves.push(Curve {
                    name: if several {
                        format!("{}, {view}", lobe.label)
                    } else {
                        format!("{}{view}", set(lobe))
                    },
                    points: self.points(lobe, *theta, reach),
                    color: curve_color(color),
                    dash,
                });
            }
        }
        curves
    }

    fn points(&self, lobe: &Lobe, theta: f64, reach: f64) -> Vec<(f64, f64)> {
        let wo = self.wo(theta);
        // Where light is bent on its way through, its lobe is about the refracted direction, from below.
        let sine = libm::sin(theta.to_radians()) / lobe.shape.eta();
        let bent = libm::asin(sine.clamp(-1.0, 1.0)).to_degrees();
        let below = if lobe.shape.info().side == Side::Transmission { 180.0 - bent } else { theta };
        let peaks = [theta, below, -theta, theta - 180.0];
        let value = |degrees: f64| self.value(lobe, wo, self.in_plane(degrees));
        match self.log {
            // What is below all decades shown need not be followed.
            true => sampled(value, (-reach, reach), &peaks, |v| libm::log10(v.max(1e-9))),
            false => sampled(value, (-reach, reach), &peaks, |v| v),
        }
    }

    /// The axis of the values.
    fn axis(&self, curves: &[Curve], about: usize) -> Axis {
        let points = || curves.iter().flat_map(|curve| curve.points.iter().copied());
        let values = || points().map(|(_, value)| value);
        // Near the horizon f may grow without bound: what is there does not decide on the scale.
        let clear = |degrees: f64| self.quantity == Quantity::FCos || (degrees.abs() - 90.0).abs() > HORIZON;
        let most = points().filter(|(degrees, value)| value.is_finite() && clear(*degrees));
        let most = most.map(|(_, value)| value).fold(0.0, f64::max);
        if !self.log {
            return Axis::round(self.quantity_name(), (0.0, most), about);
        }
        Axis::decades_over(self.quantity_name(), values(), most)
    }
}

/// What was set of the only lobe, if anything.
fn set(lobe: &Lobe) -> String {
    let words = lobe.label.strip_prefix(lobe.shape.info().name).unwrap_or("").trim();
    if words.is_empty() { String::new() } else { format!("{words}, ") }
}
