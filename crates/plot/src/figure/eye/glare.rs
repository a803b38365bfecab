//! Light that the eye scatters, by age.

use glanz_eye::curves::{cie146_glare, vos_glare};

use super::{EyePlot, LIGHTEST, ratios};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart, SideBySide};
use crate::page::dash;
use crate::words::Word;

/// The angles of CIE 146, in degrees.
const CIE146_DEG: (f64, f64) = (0.1, 90.0);

impl EyePlot {
    /// The glare function of CIE 135/1 for each age, and the same times the square of the angle with that of CIE 146.
    ///
    /// # Errors
    /// [`Error::Age`] for an age that is not 20 to 80 years, [`Error::TooManyLobes`] for too many, [`Error::Pigment`] for one that no eye
    /// has.
    pub fn glare(&self) -> Result<SideBySide, Error> {
        if !(0.0..=LIGHTEST).contains(&self.pigment) {
            return Err(Error::Pigment { pigment: self.pigment, most: LIGHTEST });
        }
        Ok(SideBySide {
            title: self.say(Word::Glare),
            subtitle: self.lang.say(Word::GlareSource, &[&self.lang.number(self.pigment)]),
            charts: vec![self.glare_function()?, self.stray_light()?],
            lang: self.lang,
        })
    }

    fn glare_function(&self) -> Result<LineChart, Error> {
        let label = self.say(Word::AngleFromSource);
        Ok(LineChart {
            title: self.say(Word::GlareFunction),
            subtitle: String::new(),
            x: Axis::log(label, (1e-3, 90.0), &[1e-3, 0.01, 0.1, 1.0, 10.0]),
            y: Axis::decades(self.say(Word::PerSteradian), (-3, 7)),
            curves: self.by_age(|age| ratios((1e-3, 90.0), |theta| vos_glare(theta, age, self.pigment)))?,
            marks: Vec::new(),
            lang: self.lang,
        })
    }

    /// What scatters as 1/θ² is flat here, and ages lie apart.
    fn stray_light(&self) -> Result<LineChart, Error> {
        let times_square = |glare: fn(f64, f64, f64) -> f64, age: f64| {
            ratios(CIE146_DEG, |theta| theta * theta * glare(theta, age, self.pigment))
        };
        let total = self.by_age(|age| times_square(vos_glare, age))?;
        let general = self.by_age(|age| times_square(cie146_glare, age))?;
        let curves: Vec<_> = total
            .into_iter()
            .chain(general.into_iter().map(|curve| Curve {
                name: format!("{}, CIE 146", curve.name),
                dash: dash(1),
                ..curve
            }))
            .collect();
        let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
        let (least, most) = (values().fold(f64::MAX, f64::min), values().fold(0.0, f64::max));
        let ticks = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0];
        let y = Axis::log(self.say(Word::StrayLightLabel), (0.9 * least, 1.1 * most), &ticks);
        Ok(LineChart {
            title: self.say(Word::StrayLight),
            subtitle: String::new(),
            x: Axis::log(self.say(Word::AngleFromSource), CIE146_DEG, &[0.1, 1.0, 10.0]),
            y,
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }
}
