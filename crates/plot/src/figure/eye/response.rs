//! The response to luminance by several laws in one figure.

use glanz_eye::curves::{cone_semisaturation, gsdf_index, lightness, naka_rushton, weber_fechner};

use super::{EyePlot, ratios};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart};
use crate::page::{curve_color, dash};
use crate::words::Word;

/// The darkest luminance, where the grayscale standard display function begins, in cd/m².
const DARKEST: f64 = 0.05;
/// White that can be asked for, up to the end of that function.
const WHITES: (f64, f64) = (1.0, 3993.0);
/// The mean of a scene, in parts of its white.
const MEAN: f64 = 0.2;
/// The exponent of cones.
const EXPONENT: f64 = 0.73;

impl EyePlot {
    /// The logarithm, the cube root, the saturating response of cones and the number of just noticeable steps over luminance, each from 0
    /// at 0.05 cd/m² to 1 at the luminance of white; a set of curves for each white.
    ///
    /// # Errors
    /// [`Error::Luminance`] for a white that is not 1 to 3993 cd/m², [`Error::TooManyLobes`] for too many.
    pub fn response(&self) -> Result<LineChart, Error> {
        let whites = self.checked_luminances(WHITES)?;
        let mut curves = Vec::new();
        for (index, white) in whites.iter().enumerate() {
            curves.extend(self.laws(*white, whites.len() > 1, dash(index)));
        }
        let brightest = whites.iter().copied().fold(10.0, f64::max);
        let ticks = [0.1, 1.0, 10.0, 100.0, 1000.0];
        Ok(LineChart {
            title: self.say(Word::Response),
            subtitle: self.say(Word::ResponseSource),
            x: Axis::log(self.say(Word::Luminance), (DARKEST, brightest), &ticks),
            y: Axis::exact(self.say(Word::ResponseLabel), (0.0, 1.0), 5),
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }

    fn laws(&self, white: f64, named: bool, dash: Option<(f64, f64)>) -> Vec<Curve> {
        let sigma = cone_semisaturation(MEAN * white);
        let laws: [(Word, &dyn Fn(f64) -> f64); 5] = [
            (Word::Logarithm, &|luminance| weber_fechner(luminance, white)),
            (Word::CubeRoot, &|luminance| lightness(luminance / white)),
            (Word::Saturating, &|luminance| naka_rushton(luminance, sigma, EXPONENT)),
            (Word::Steps, &gsdf_index),
            (Word::Proportional, &|luminance| luminance),
        ];
        let curve = |(index, (word, law)): (usize, (Word, &dyn Fn(f64) -> f64))| {
            let (least, most) = (law(DARKEST), law(white));
            let name = self.say(word);
            let number = self.lang.number(white);
            Curve {
                name: if named { self.lang.say(Word::AtLuminance, &[&name, &number]) } else { name },
                points: ratios((DARKEST, white), |luminance| (law(luminance) - least) / (most - least)),
                color: if word == Word::Proportional { curve_color(7) } else { curve_color(index) },
                dash,
            }
        };
        laws.into_iter().enumerate().map(curve).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_law_goes_from_0_to_1_and_the_steps_lie_between_cube_root_and_logarithm() {
        let chart = EyePlot::default().response().unwrap();
        for curve in &chart.curves {
            let (first, last) = (curve.points[0], curve.points[curve.points.len() - 1]);
            assert_eq!((first, last), ((0.05, 0.0), (100.0, 1.0)), "{}", curve.name);
            assert!(curve.points.windows(2).all(|pair| pair[1].1 > pair[0].1), "{}", curve.name);
        }
        let middle = |index: usize| chart.curves[index].points[150].1;
        assert!(middle(1) < middle(3) && middle(3) < middle(0), "{} {} {}", middle(0), middle(1), middle(3));
    }
}
