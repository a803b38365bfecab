//! Plots of lights: attenuation over distance, and the cone of a spot over the angle from its axis.
//!
//! The laws are those of scene files, by the same names.
//!
//! ```
//! use glanz_plot::light::{Attenuation, AttenuationPlot};
//! use glanz_plot::Figure;
//!
//! let square = Attenuation { label: "physical".to_owned(), constant: 0.0, linear: 0.0, quadratic: 1.0 };
//! let chart = AttenuationPlot::new(vec![square]).chart()?;
//! assert!(chart.csv().contains("\nphysical,2,0.25\n"));
//! # Ok::<_, glanz_plot::Error>(())
//! ```

use crate::Error;
use crate::chart::{Axis, Curve, LineChart, sampled};
use crate::page::{curve_color, curve_dash};
use crate::words::{Lang, Word};

/// The most curves of a plot.
const MOST_CURVES: usize = 64;
/// The highest value that a linear axis of attenuation shows: near a lamp the inverse square law has no bound.
const HIGHEST: f64 = 2.0;
/// The farthest distance of a plot, in metres.
const FARTHEST_M: f64 = 1e6;

/// A law by which light fades with the distance d: 1 / (constant + linear · d + quadratic · d²).
#[derive(Clone, Debug, PartialEq)]
pub struct Attenuation {
    /// What it is called in the legend.
    pub label: String,
    /// The part that does not depend on distance.
    pub constant: f64,
    /// The factor of d, in 1/m.
    pub linear: f64,
    /// The factor of d², in 1/m².
    pub quadratic: f64,
}

impl Attenuation {
    /// The part of the light that arrives at a distance in metres; infinite at 0 where there is no constant part.
    pub fn at(&self, distance: f64) -> f64 {
        1.0 / (self.constant + (self.linear + self.quadratic * distance) * distance)
    }
}

/// Attenuation over distance, a curve for each law.
#[derive(Clone, Debug, PartialEq)]
pub struct AttenuationPlot {
    /// The laws.
    pub laws: Vec<Attenuation>,
    /// The greatest distance in metres.
    pub to_m: f64,
    /// Whether the axis of the values is logarithmic.
    pub log: bool,
    /// The language of the words.
    pub lang: Lang,
}

impl AttenuationPlot {
    /// A plot over 10 m on linear axes.
    pub fn new(laws: Vec<Attenuation>) -> Self {
        Self { laws, to_m: 10.0, log: false, lang: Lang::En }
    }

    /// The chart.
    ///
    /// # Errors
    /// [`Error::TooManyLobes`] for too many curves, [`Error::Distance`] for a distance that is not above 0.
    pub fn chart(&self) -> Result<LineChart, Error> {
        check_count(self.laws.len())?;
        if !(self.to_m > 0.0 && self.to_m <= FARTHEST_M) {
            return Err(Error::Distance { distance_m: self.to_m, most_m: FARTHEST_M });
        }
        let curve = |(index, law): (usize, &Attenuation)| Curve {
            name: law.label.clone(),
            points: distances(self.to_m).map(|distance| (distance, law.at(distance))).collect(),
            color: curve_color(index),
            dash: curve_dash(index),
        };
        let curves: Vec<_> = self.laws.iter().enumerate().map(curve).collect();
        let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let most = values().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let label = self.lang.say(Word::PartThatArrives, &[]);
        let y = match self.log {
            true => Axis::decades_over(label, values(), most),
            false => Axis::round(label, (0.0, most.min(HIGHEST)), 5),
        };
        Ok(LineChart {
            title: self.lang.say(Word::Attenuation, &[]),
            subtitle: self.lang.say(Word::AttenuationLaw, &[]),
            x: Axis::exact(self.lang.say(Word::Distance, &[]), (0.0, self.to_m), 10),
            y,
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }
}

/// Distances in metres: 500 even steps, and finer ones next to the lamp, where curves are steep.
fn distances(to_m: f64) -> impl Iterator<Item = f64> {
    let step = to_m / 500.0;
    (0..20)
        .map(move |i| step * f64::from(i) / 20.0)
        .chain((1..=500).map(move |i| to_m * f64::from(i) / 500.0))
}

/// The cone of a spot.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    /// What it is called in the legend.
    pub label: String,
    /// Half the opening angle, in degrees; nothing is lit beyond.
    pub cutoff_deg: f64,
    /// The power of the cosine from the axis.
    pub exponent: f64,
    /// The cosines between which it fades from full to nothing, instead of the power.
    pub smooth_edge: Option<(f64, f64)>,
}

impl Cone {
    /// The part of the light at an angle from the axis, in degrees.
    pub fn at(&self, degrees: f64) -> f64 {
        if degrees.abs() > self.cutoff_deg {
            return 0.0;
        }
        let cosine = libm::cos(degrees.to_radians());
        match self.smooth_edge {
            Some((inner, outer)) => {
                let part = ((cosine - outer) / (inner - outer).max(1e-6)).clamp(0.0, 1.0);
                part * part
            }
            None if self.exponent == 0.0 => 1.0,
            None => libm::pow(cosine.max(0.0), self.exponent),
        }
    }
}

/// Cones of spots over the angle from the axis.
#[derive(Clone, Debug, PartialEq)]
pub struct SpotPlot {
    /// The cones.
    pub cones: Vec<Cone>,
    /// Whether the axis of the values is logarithmic.
    pub log: bool,
    /// The language of the words.
    pub lang: Lang,
}

impl SpotPlot {
    /// A plot on linear axes.
    pub fn new(cones: Vec<Cone>) -> Self {
        Self { cones, log: false, lang: Lang::En }
    }

    /// The chart.
    ///
    /// # Errors
    /// [`Error::TooManyLobes`] for too many curves.
    pub fn chart(&self) -> Result<LineChart, Error> {
        check_count(self.cones.len())?;
        let widest = self.cones.iter().map(|cone| cone.cutoff_deg).fold(0.0, f64::max);
        let reach = if widest > 90.0 { 180.0 } else { 90.0 };
        let curve = |(index, cone): (usize, &Cone)| {
            let edge = cone.cutoff_deg;
            let mut points = sampled(|degrees| cone.at(degrees), (0.0, edge.min(reach)), &[], |v| v);
            // The edge is a step.
            if edge < reach {
                points.extend([(edge, 0.0), (reach, 0.0)]);
            }
            Curve { name: cone.label.clone(), points, color: curve_color(index), dash: curve_dash(index) }
        };
        let curves: Vec<_> = self.cones.iter().enumerate().map(curve).collect();
        let values = curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let label = self.lang.say(Word::PartThatArrives, &[]);
        let y = match self.log {
            true => Axis::decades_over(label, values, 1.0),
            false => Axis::exact(label, (0.0, 1.0), 5),
        };
        let ticks = (0..=12).map(|i| 15.0 * f64::from(i)).filter(|tick| *tick <= reach).collect();
        let x = Axis::exact(self.lang.say(Word::AngleFromAxis, &[]), (0.0, reach), 6);
        Ok(LineChart {
            title: self.lang.say(Word::Spot, &[]),
            subtitle: self.lang.say(Word::SpotLaw, &[]),
            x: Axis { ticks, decimals: 0, ..x },
            y,
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }
}

fn check_count(found: usize) -> Result<(), Error> {
    if found > MOST_CURVES { Err(Error::TooManyLobes { found, most: MOST_CURVES }) } else { Ok(()) }
}

/// The label of a law by its factors, with those that are 0 left out: `1 + 0.5 d + 0.1 d²`.
pub fn attenuation_label(constant: f64, linear: f64, quadratic: f64, lang: Lang) -> String {
    let part = |factor: f64, unit: &str| match (factor, unit) {
        (0.0, _) => None,
        (1.0, unit) if !unit.is_empty() => Some(unit.to_owned()),
        (factor, unit) => Some(format!("{} {unit}", lang.number(factor)).trim_end().to_owned()),
    };
    let parts = [part(constant, ""), part(linear, "d"), part(quadratic, "d²")];
    let sum: Vec<_> = parts.into_iter().flatten().collect();
    match sum.as_slice() {
        [one] if one == "1" => one.clone(),
        [one] => format!("1 / {one}"),
        _ => format!("1 / ({})", sum.join(" + ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone(cutoff_deg: f64, exponent: f64) -> Cone {
        Cone { label: String::new(), cutoff_deg, exponent, smooth_edge: None }
    }

    #[test]
    fn a_cone_is_a_power_of_the_cosine_up_to_its_edge() {
        assert_eq!((cone(30.0, 0.0).at(29.9), cone(30.0, 0.0).at(30.1)), (1.0, 0.0));
        assert!((cone(90.0, 2.0).at(60.0) - 0.25).abs() < 1e-12);
        // From behind a cosine is negative, and its power nothing.
        assert_eq!((cone(180.0, 1.0).at(120.0), cone(180.0, 0.0).at(120.0)), (0.0, 1.0));
        let smooth = Cone { smooth_edge: Some((1.0, 0.0)), ..cone(90.0, 5.0) };
        assert!((smooth.at(60.0) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn the_edge_of_a_cone_is_a_step() {
        let chart = SpotPlot::new(vec![cone(20.0, 0.0)]).chart().unwrap();
        let end: Vec<_> = chart.curves[0].points.iter().rev().take(3).copied().collect();
        assert_eq!(end, [(90.0, 0.0), (20.0, 0.0), (20.0, 1.0)]);
    }

    #[test]
    fn laws_are_named_by_their_factors() {
        assert_eq!(attenuation_label(1.0, 0.5, 0.0, Lang::En), "1 / (1 + 0.5 d)");
        assert_eq!(
            (attenuation_label(1.0, 0.0, 0.0, Lang::En), attenuation_label(0.0, 0.0, 1.0, Lang::En)),
            ("1".into(), "1 / d²".into())
        );
        assert_eq!(attenuation_label(1.0, 0.0, 0.1, Lang::Fr), "1 / (1 + 0,1 d²)");
    }

    #[test]
    fn a_distance_must_be_above_0() {
        let plot = |to_m| AttenuationPlot { to_m, ..AttenuationPlot::new(Vec::new()) };
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(plot(wrong).chart(), Err(Error::Distance { .. })), "{wrong}");
        }
    }
}
