//! Fresnel reflectance of smooth boundaries, over the angle of incidence.

use glanz_bsdf::terms::fresnel_schlick;

use super::medium::Medium;
use crate::Error;
use crate::chart::{Axis, Curve, LineChart, LineMark, sampled};
use crate::page::{curve_color, dash};
use crate::words::{Lang, Word};

/// The most media of a plot.
const MOST_MEDIA: usize = 8;

/// The reflectance of smooth boundaries from air to media, exact and by Schlick's formula, over the angle of
/// incidence.
///
/// ```
/// use glanz_plot::{Figure, FresnelPlot, Medium};
///
/// let media = vec![Medium::named("1.5", 550.0)?, Medium::named("Au", 550.0)?];
/// let svg = FresnelPlot::new(media, 550.0).chart()?.svg()?;
/// assert!(svg.contains("Brewster 56.3°"));
/// # Ok::<_, glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FresnelPlot {
    /// The media, at the wavelength.
    pub media: Vec<Medium>,
    /// The wavelength of the light in nm, for the subtitle.
    pub lambda_nm: f64,
    /// Whether the axis of the reflectance is logarithmic.
    pub log: bool,
    /// Whether the two polarisations are drawn too.
    pub polarized: bool,
    /// The language of the words.
    pub lang: Lang,
}

impl FresnelPlot {
    /// A plot of unpolarised reflectance on a linear axis.
    pub fn new(media: Vec<Medium>, lambda_nm: f64) -> Self {
        Self { media, lambda_nm, log: false, polarized: false, lang: Lang::En }
    }

    /// The chart.
    ///
    /// # Errors
    /// [`Error::TooManyMedia`] for more than eight.
    pub fn chart(&self) -> Result<LineChart, Error> {
        if self.media.len() > MOST_MEDIA {
            return Err(Error::TooManyMedia { found: self.media.len(), most: MOST_MEDIA });
        }
        let (mut curves, mut marks) = (Vec::new(), Vec::new());
        for (index, medium) in self.media.iter().enumerate() {
            curves.extend(self.curves_of(medium, index));
            marks.extend(self.marks_of(medium, index));
        }
        let values = curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let label = self.lang.say(Word::Reflectance, &[]);
        let y = match self.log {
            true => Axis::decades_over(label, values, 1.0),
            false => Axis::exact(label, (0.0, 1.0), 5),
        };
        let from = if self.media.iter().any(leads_out) { Word::FromMedium } else { Word::FromAir };
        let below = self.lang.say(from, &[&self.lang.number(self.lambda_nm)]);
        Ok(LineChart {
            title: self.lang.say(Word::Fresnel, &[]),
            subtitle: if self.polarized { self.lang.say(Word::Polarisations, &[&below]) } else { below },
            x: Axis::quarter_turn(self.lang.say(Word::AngleOfIncidence, &[])),
            y,
            curves,
            marks,
            lang: self.lang,
        })
    }

    fn curves_of(&self, medium: &Medium, index: usize) -> Vec<Curve> {
        let color = curve_color(index);
        let f0 = medium.reflectance(1.0);
        let cosine = |degrees: f64| libm::cos(degrees.to_radians());
        let curve = |name: String, dash, value: &dyn Fn(f64) -> f64| Curve {
            name,
            points: sampled(|degrees| value(cosine(degrees)), (0.0, 90.0), &[], |v| v),
            color,
            dash,
        };
        let schlick = self.lang.say(Word::Schlick, &[&self.name_of(medium)]);
        let mut curves = vec![
            curve(self.name_of(medium), None, &|c| medium.reflectance(c)),
            curve(schlick, dash(1), &|c| fresnel_schlick(c, f0)),
        ];
        if self.polarized {
            curves.push(curve(format!("{}, s", self.name_of(medium)), dash(2), &|c| medium.polarized(c).0));
            curves.push(curve(format!("{}, p", self.name_of(medium)), dash(2), &|c| medium.polarized(c).1));
        }
        curves
    }

    /// The name of a medium, whose index may be in it.
    fn name_of(&self, medium: &Medium) -> String {
        let is_index = medium.name.starts_with("n = ");
        if is_index { self.lang.decimal(medium.name.clone()) } else { medium.name.clone() }
    }

    /// Brewster's angle, and the critical angle on the way out of a medium; none for what absorbs.
    fn marks_of(&self, medium: &Medium, index: usize) -> Vec<LineMark> {
        if medium.k != 0.0 || medium.eta == 1.0 {
            return Vec::new();
        }
        let mark = |word: Word, radians: f64| {
            let x = radians.to_degrees();
            LineMark {
                x,
                label: self.lang.say(word, &[&self.lang.decimal(format!("{x:.1}"))]),
                color: curve_color(index),
            }
        };
        let mut marks = vec![mark(Word::Brewster, libm::atan(medium.eta))];
        if leads_out(medium) {
            marks.push(mark(Word::Critical, libm::asin(medium.eta)));
        }
        marks
    }
}

/// Whether light leaves a denser medium: an index below 1 that is not a metal's.
fn leads_out(medium: &Medium) -> bool {
    medium.k == 0.0 && medium.eta < 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_below_1_is_the_way_out_with_its_critical_angle() {
        let chart = |word: &str| {
            let plot = FresnelPlot::new(vec![Medium::named(word, 550.0).unwrap()], 550.0);
            plot.chart().unwrap()
        };
        let out = chart("0.6666666666666666");
        assert!(out.subtitle.contains("to air") && !out.subtitle.contains("from air"), "{}", out.subtitle);
        let labels: Vec<_> = out.marks.iter().map(|mark| mark.label.as_str()).collect();
        assert_eq!(labels, ["Brewster 33.7°", "critical angle 41.8°"]);
        assert!(out.curves[0].points.iter().all(|(angle, value)| *angle < 41.9 || *value == 1.0));
        // The index of gold is below 1 at 550 nm, but light comes from air.
        assert!(chart("Au").subtitle.contains("from air") && chart("Au").marks.is_empty());
    }
}
