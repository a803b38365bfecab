//! Lobes in the plane of incidence: polar and over the angle.

use glanz_bsdf::Side;

use super::sample::sampled;
use super::{Quantity, Request};
use crate::lobes::Case;
use crate::plot::{Axis, Curve, LineMark, Lines, Picture, Polar, Ray, Rgb8, color_of_curve, dash_of};
use crate::print::number;

/// The most decades that a logarithmic plot shows.
const DECADES: i32 = 6;
/// How near to the horizon, in degrees, values of f do not decide on the scale.
const HORIZON: f64 = 3.0;
/// The colour of rays that belong to no curve alone.
const RAY: Rgb8 = [0x5b, 0x63, 0x6e];

impl Request<'_> {
    /// Values about a point of the surface.
    pub(super) fn polar(&self) -> Picture {
        let whole = self.transmits();
        let reach = if whole { 180.0 } else { 90.0 };
        let curves = self.curves(reach);
        let radius = self.axis(&curves, 4);
        let several = self.cases.len() > 1;
        // One viewer is named, the one furthest from the others' numbers.
        let named = self.theta.iter().copied().fold(0.0, f64::max);
        let rays = self.theta.iter().enumerate().flat_map(|(index, theta)| {
            let color = if several { RAY } else { color_of_curve(index) };
            let label = if *theta == named { "viewer" } else { "" };
            let viewer = Ray { degrees: -theta, label: label.to_owned(), color, dashed: false };
            let label = if *theta == named { "mirror" } else { "" };
            let mirror = Ray { degrees: *theta, label: label.to_owned(), color, dashed: true };
            // Seen from above, both are the normal.
            if *theta == 0.0 || !self.reflects() { vec![viewer] } else { vec![viewer, mirror] }
        });
        Polar {
            title: self.title("Lobes in the plane of incidence"),
            subtitle: self.subtitle(&format!("{} by the direction of the light", self.quantity_name())),
            radius,
            rays: rays.collect(),
            curves,
            whole,
        }
        .picture()
    }

    /// Values over the angle of the light.
    pub(super) fn cartesian(&self) -> Picture {
        let reach = if self.transmits() { 180.0 } else { 90.0 };
        let curves = self.curves(reach);
        let y = self.axis(&curves, 6);
        let several = self.cases.len() > 1;
        let mark = |(index, theta): (usize, &f64)| LineMark {
            x: *theta,
            label: format!("mirror {}°", number(*theta)),
            color: if several { RAY } else { color_of_curve(index) },
        };
        let ticks = (-12..=12)
            .map(|i| 15.0 * f64::from(i))
            .filter(|tick: &f64| tick.abs() <= reach && (reach < 100.0 || tick % 30.0 == 0.0));
        let x = Axis::exact("angle of the light from the normal in °", (-reach, reach), 12);
        Lines {
            title: self.title("Lobes in the plane of incidence"),
            subtitle: self.subtitle("negative angles are on the viewer's side of the normal"),
            x: Axis { ticks: ticks.collect(), decimals: 0, ..x },
            y,
            marks: if self.theta.len() <= 4 && self.reflects() {
                self.theta.iter().enumerate().map(mark).collect()
            } else {
                Vec::new()
            },
            curves,
        }
        .picture()
    }

    /// A curve for each lobe and view: colours tell lobes apart, or views if there is one lobe.
    fn curves(&self, reach: f64) -> Vec<Curve> {
        let several = self.cases.len() > 1;
        let mut curves = Vec::new();
        for (case_index, case) in self.cases.iter().enumerate() {
            for (view_index, theta) in self.theta.iter().enumerate() {
                let (color, dash) = match several {
                    true => (case_index, dash_of(view_index)),
                    false => (view_index, None),
                };
                let view = format!("θo = {}°", number(*theta));
                curves.push(Curve {
                    name: if several {
                        format!("{}, {view}", case.label)
                    } else {
                        format!("{}{view}", set(case))
                    },
                    points: self.points(case, *theta, reach),
                    color: color_of_curve(color),
                    dash,
                });
            }
        }
        curves
    }

    fn points(&self, case: &Case, theta: f64, reach: f64) -> Vec<(f64, f64)> {
        let wo = self.wo(theta);
        // Where light is bent on its way through, its lobe is about the refracted direction, from below.
        let sine = libm::sin(theta.to_radians()) / case.shape.eta();
        let bent = libm::asin(sine.clamp(-1.0, 1.0)).to_degrees();
        let below = if case.shape.info().side == Side::Transmission { 180.0 - bent } else { theta };
        let peaks = [theta, below, -theta, theta - 180.0];
        let value = |degrees: f64| self.value(case, wo, self.in_plane(degrees));
        match self.log {
            // What is below all decades shown need not be followed.
            true => sampled(value, (-reach, reach), &peaks, |v| libm::log10(v.max(1e-9))),
            false => sampled(value, (-reach, reach), &peaks, |v| v),
        }
    }

    /// The axis of the values.
    pub(super) fn axis(&self, curves: &[Curve], about: usize) -> Axis {
        let points = || curves.iter().flat_map(|curve| curve.points.iter().copied());
        let values = || points().map(|(_, value)| value);
        // Near the horizon f may grow without bound: what is there does not decide on the scale.
        let clear = |degrees: f64| self.quantity == Quantity::FCos || (degrees.abs() - 90.0).abs() > HORIZON;
        let most = points().filter(|(degrees, value)| value.is_finite() && clear(*degrees));
        let most = most.map(|(_, value)| value).fold(0.0, f64::max);
        if !self.log {
            return Axis::round(self.quantity_name(), (0.0, most), about);
        }
        decades(self.quantity_name(), values(), most)
    }
}

/// A logarithmic axis from the least value shown to the greatest.
pub fn decades(label: &str, values: impl Iterator<Item = f64>, most: f64) -> Axis {
    let high = if most > 0.0 { (libm::log10(most) - 1e-9).ceil() as i32 } else { 0 };
    let least = values.filter(|value| *value > 0.0).fold(most.max(f64::MIN_POSITIVE), f64::min);
    let low = (libm::log10(least).floor() as i32).clamp(high - DECADES, high - 1);
    Axis::decades(label, (low, high))
}

/// What was set of the only lobe, if anything.
fn set(case: &Case) -> String {
    let words = case.label.strip_prefix(case.shape.info().name).unwrap_or("").trim();
    if words.is_empty() { String::new() } else { format!("{words}, ") }
}
