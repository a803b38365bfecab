//! Plots of the eye: lens, rods, pupil, dusk, glare, contrast sensitivity, response, mosaic of the retina.

mod cones;
mod confusion;
mod contrast;
mod glare;
mod light;
mod media;
mod mosaic;
mod response;

use crate::Error;
use crate::chart::Curve;
use crate::page::{curve_color, curve_dash};
use crate::words::{Lang, Word};

/// The ages that all formulas are for.
const AGES: (f64, f64) = (20.0, 80.0);
/// The most ages or luminances of a plot.
const MOST: usize = 12;
/// The luminance of a display's white, in cd/m².
const WHITE: f64 = 100.0;
/// The pigment of the lightest eyes.
const LIGHTEST: f64 = 1.2;

/// Whose eyes are plotted, and by what light.
///
/// A number that has no part in a plot is not looked at: age acts on [`lens`](Self::lens), [`rods`](Self::rods),
/// [`pupil`](Self::pupil) and [`glare`](Self::glare), luminance on [`contrast`](Self::contrast) and [`response`](Self::response), the
/// pigment on [`glare`](Self::glare).
///
/// ```
/// use glanz_plot::Figure;
/// use glanz_plot::figure::EyePlot;
///
/// let plot = EyePlot { ages: vec![20.0, 70.0], ..EyePlot::default() };
/// assert!(plot.pupil()?.csv().starts_with("curve,luminance in cd/m²,diameter in mm\n20 years,"));
/// # Ok::<_, glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EyePlot {
    /// Ages in years, 20 to 80, a curve for each.
    pub ages: Vec<f64>,
    /// Luminances of the background or of white, in cd/m².
    pub luminances: Vec<f64>,
    /// The pigment of iris and wall of the eye: 0 very dark, 0.5 brown, 1 blue-green, 1.2 very light blue.
    pub pigment: f64,
    /// The language of the words.
    pub lang: Lang,
}

impl Default for EyePlot {
    /// Brown eyes of 20, 50 and 80 years at 100 cd/m².
    fn default() -> Self {
        Self { ages: vec![20.0, 50.0, 80.0], luminances: vec![WHITE], pigment: 0.5, lang: Lang::En }
    }
}

impl EyePlot {
    fn say(&self, word: Word) -> String {
        self.lang.say(word, &[])
    }

    /// How an age is called.
    fn years(&self, age: f64) -> String {
        self.lang.say(Word::Years, &[&self.lang.number(age)])
    }

    /// The ages, if they are possible.
    fn checked_ages(&self) -> Result<&[f64], Error> {
        let (least, most) = AGES;
        check_count(self.ages.len())?;
        match self.ages.iter().find(|age| !(least..=most).contains(*age)) {
            Some(age) => Err(Error::Age { age: *age, least, most }),
            None => Ok(&self.ages),
        }
    }

    /// The luminances, if they are within a formula's range.
    fn checked_luminances(&self, (least, most): (f64, f64)) -> Result<&[f64], Error> {
        check_count(self.luminances.len())?;
        match self.luminances.iter().find(|luminance| !(least..=most).contains(*luminance)) {
            Some(luminance) => Err(Error::Luminance { luminance: *luminance, least, most }),
            None => Ok(&self.luminances),
        }
    }

    /// A curve for each age, from its points.
    fn by_age(&self, points: impl Fn(f64) -> Vec<(f64, f64)>) -> Result<Vec<Curve>, Error> {
        let curve = |(index, age): (usize, &f64)| Curve {
            name: self.years(*age),
            points: points(*age),
            color: curve_color(index),
            dash: curve_dash(index),
        };
        Ok(self.checked_ages()?.iter().enumerate().map(curve).collect())
    }
}

fn check_count(found: usize) -> Result<(), Error> {
    if found > MOST { Err(Error::TooManyLobes { found, most: MOST }) } else { Ok(()) }
}

/// The points of a function at places that grow by equal ratios.
fn ratios((low, high): (f64, f64), f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    /// So many that a curve over ten decades is smooth.
    const STEPS: i32 = 300;
    let span = libm::log(high / low);
    let place = |i: i32| match i {
        // The ends exactly.
        0 => low,
        STEPS => high,
        _ => low * libm::exp(span * f64::from(i) / f64::from(STEPS)),
    };
    (0..=STEPS).map(|i| (place(i), f(place(i)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Figure;

    #[test]
    fn an_eye_that_no_formula_is_for_is_refused() {
        for age in [19.0, 81.0, f64::NAN] {
            let plot = EyePlot { ages: vec![50.0, age], ..EyePlot::default() };
            assert!(matches!(plot.lens(), Err(Error::Age { .. })), "{age}");
        }
        let plot = EyePlot { luminances: vec![0.0], ..EyePlot::default() };
        assert!(matches!(plot.contrast(), Err(Error::Luminance { .. })));
        assert!(matches!(plot.response(), Err(Error::Luminance { .. })));
        let plot = EyePlot { pigment: 1.3, ..EyePlot::default() };
        assert!(matches!(plot.glare(), Err(Error::Pigment { .. })));
        let plot = EyePlot { ages: vec![30.0; 13], ..EyePlot::default() };
        assert!(matches!(plot.pupil(), Err(Error::TooManyLobes { .. })));
    }

    #[test]
    fn places_grow_by_equal_ratios_and_meet_both_ends() {
        let points = ratios((0.01, 1000.0), |x| x);
        assert_eq!((points[0].0, points[points.len() - 1].0), (0.01, 1000.0));
        let ratio = points[1].0 / points[0].0;
        assert!(points.windows(2).all(|pair| (pair[1].0 / pair[0].0 / ratio - 1.0).abs() < 1e-9));
    }

    #[test]
    fn curves_hold_the_numbers_of_the_formulas() {
        let plot = EyePlot { ages: vec![80.0], ..EyePlot::default() };
        let value = |chart: &dyn Figure, panel: usize, curve: usize, x: f64| {
            let data = chart.data();
            let points = data.panels[panel].curves[curve].points.clone();
            let near = points.iter().min_by(|a, b| (a[0] - x).abs().total_cmp(&(b[0] - x).abs()));
            near.expect("the curve has points")[1]
        };
        // CIE 170-1 at 80 years and 450 nm: 0.1768; CIE 203: 0.1771.
        let lens = plot.lens().unwrap();
        assert!((value(&lens, 0, 0, 450.0) - 0.1768).abs() < 1e-4);
        assert!((value(&lens, 0, 1, 450.0) - 0.1771).abs() < 1e-4);
        // Watson and Yellott at 0.01 cd/m², nearly the darkest place.
        assert!((value(&plot.pupil().unwrap(), 0, 0, 0.01) - 4.7131).abs() < 2e-3);
        // By day a patch has its luminance factor, at night that of V′: eye.md 45–48.
        let mesopic = plot.mesopic().unwrap();
        assert!((value(&mesopic, 1, 0, 100.0) - 0.11826).abs() < 5e-4);
        assert!((value(&mesopic, 1, 2, 1e-4) - 0.15423).abs() < 5e-4);
    }
}
