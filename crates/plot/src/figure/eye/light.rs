//! What the amount of light does: the pupil, and the way from day to night.

use glanz_color::{Spectrum, UnknownName, light, observer, reflectance};
use glanz_eye::curves::{
    Eyes, PHOTOPIC_EFFICACY, SCOTOPIC_EFFICACY, mesopic, mesopic_with, pupil_diameter_mm,
};

use super::{EyePlot, ratios};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart, SideBySide};
use crate::page::style::Rgb8;
use crate::page::{curve_color, curve_dash};
use crate::words::Word;

/// A disc of 60° across, in deg².
const FIELD_DEG2: f64 = core::f64::consts::PI * 30.0 * 30.0;
/// Lights from little to much for the rods: sodium, incandescent, daylight.
const LIGHTS: [&str; 3] = ["HP1", "A", "D65"];
/// Patches of the ColorChecker, what they are called, and their colours.
const PATCHES: [(&str, Word, Rgb8); 3] = [
    ("red", Word::Red, [0xd0, 0x2f, 0x2f]),
    ("green", Word::Green, [0x1f, 0x9d, 0x45]),
    ("blue", Word::Blue, [0x2d, 0x5f, 0xd3]),
];

/// Luminances from photopic and scotopic sums over a spectrum.
struct Sums {
    photopic: Spectrum,
    scotopic: Spectrum,
}

impl Sums {
    fn new() -> Result<Self, UnknownName> {
        let curve = |name| -> Result<Spectrum, UnknownName> {
            let channels = observer(name)?.channels;
            Ok(channels.into_iter().next().map_or(Spectrum::ZERO, |channel| channel.sensitivity))
        };
        Ok(Self { photopic: curve("photopic")?, scotopic: curve("scotopic")? })
    }

    /// Photopic and scotopic luminance of a light, in the unit of its power times lm/W.
    fn of(&self, light: &Spectrum) -> (f64, f64) {
        (PHOTOPIC_EFFICACY * self.photopic.dot(light), SCOTOPIC_EFFICACY * self.scotopic.dot(light))
    }
}

impl EyePlot {
    /// The diameter of the pupil over luminance for each age.
    ///
    /// # Errors
    /// [`Error::Age`] for an age that is not 20 to 80 years, [`Error::TooManyLobes`] for too many.
    pub fn pupil(&self) -> Result<LineChart, Error> {
        let diameter = |age: f64| {
            ratios((1e-4, 1e4), |luminance| pupil_diameter_mm(luminance, FIELD_DEG2, age, Eyes::Both))
        };
        Ok(LineChart {
            title: self.say(Word::PupilByAge),
            subtitle: self.say(Word::PupilSource),
            x: Axis::decades(self.say(Word::Luminance), (-4, 4)),
            y: Axis::exact(self.say(Word::Diameter), (1.0, 9.0), 8),
            curves: self.by_age(diameter)?,
            marks: Vec::new(),
            lang: self.lang,
        })
    }

    /// From day to night: the share of the cones under three lights, and how light red, green and blue patches are beside white.
    ///
    /// # Errors
    /// None with the spectra that come with [`glanz_color`].
    pub fn mesopic(&self) -> Result<SideBySide, Error> {
        let sums = Sums::new()?;
        Ok(SideBySide {
            title: self.say(Word::Mesopic),
            subtitle: self.say(Word::MesopicSource),
            charts: vec![self.cone_share(&sums)?, self.purkinje(&sums)?],
            lang: self.lang,
        })
    }

    fn cone_share(&self, sums: &Sums) -> Result<LineChart, Error> {
        let mut curves = Vec::new();
        for (index, name) in LIGHTS.into_iter().enumerate() {
            let (photopic, scotopic) = sums.of(&light(name)?);
            let ratio = scotopic / photopic;
            let rounded = self.lang.decimal(format!("{ratio:.2}"));
            curves.push(Curve {
                name: format!("{name}, S/P {rounded}"),
                points: ratios((1e-3, 10.0), |luminance| mesopic(luminance, luminance * ratio).m),
                color: curve_color(index),
                dash: curve_dash(index),
            });
        }
        Ok(LineChart {
            title: self.say(Word::ConeShareTitle),
            subtitle: String::new(),
            x: Axis::decades(self.say(Word::Luminance), (-3, 1)),
            y: Axis::exact(self.say(Word::ConeShare), (0.0, 1.0), 5),
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }

    fn purkinje(&self, sums: &Sums) -> Result<LineChart, Error> {
        let daylight = light("D65")?;
        let (photopic, scotopic) = sums.of(&daylight);
        let ratio = scotopic / photopic;
        let mut curves = Vec::new();
        for (name, word, color) in PATCHES {
            let (by_day, by_night) = sums.of(&(reflectance(name)? * daylight));
            let (by_day, by_night) = (by_day / photopic, by_night / scotopic);
            let beside_white = |luminance: f64| {
                let white = mesopic(luminance, luminance * ratio);
                mesopic_with(white.m, luminance * by_day, luminance * ratio * by_night) / white.luminance
            };
            curves.push(Curve {
                name: self.say(word),
                points: ratios((1e-4, 100.0), beside_white),
                color,
                dash: None,
            });
        }
        let most = curves.iter().flat_map(|curve| &curve.points).map(|(_, value)| *value).fold(0.0, f64::max);
        Ok(LineChart {
            title: self.say(Word::Purkinje),
            subtitle: String::new(),
            x: Axis::decades(self.say(Word::WhiteLuminance), (-4, 2)),
            y: Axis::round(self.say(Word::OverWhite), (0.0, most), 5),
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn daylight_has_its_ratio_of_scotopic_to_photopic_luminance() {
        // eye.md 47: 2.46463, from sums over 390 to 780 nm; ours begin at 300 nm.
        const OTHER_ENDS: f64 = 1e-4;
        let (photopic, scotopic) = Sums::new().unwrap().of(&light("D65").unwrap());
        assert!((scotopic / photopic / 2.46463 - 1.0).abs() < OTHER_ENDS, "{}", scotopic / photopic);
    }

    #[test]
    fn at_dusk_red_darkens_and_blue_brightens() {
        let chart = EyePlot::default().mesopic().unwrap();
        let ends = |curve: &Curve| (curve.points[0].1, curve.points[curve.points.len() - 1].1);
        let curves = &chart.charts[1].curves;
        let ((red_night, red_day), (blue_night, blue_day)) = (ends(&curves[0]), ends(&curves[2]));
        assert!(red_night < 0.5 * red_day && blue_night > 2.0 * blue_day);
    }
}
