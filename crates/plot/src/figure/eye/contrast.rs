//! Contrast sensitivity over spatial frequency.

use glanz_eye::curves::{CsfChannel, barten_csf, castle_csf, mannos_sakrison};

use super::{EyePlot, ratios};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart};
use crate::page::style::Rgb8;
use crate::page::{curve_color, dash};
use crate::words::Word;

/// Frequencies in cycles per degree.
const FREQUENCIES: (f64, f64) = (0.1, 60.0);
/// Luminances of castleCSF in cd/m².
const LUMINANCES: (f64, f64) = (1e-3, 1e4);
/// The radius of the grating in degrees, and its area: 7.07 deg².
const RADIUS_DEG: f64 = 1.5;
const AREA_DEG2: f64 = core::f64::consts::PI * RADIUS_DEG * RADIUS_DEG;
/// The channels, what they are called, and their colours.
const CHANNELS: [(CsfChannel, Word, Rgb8); 3] = [
    (CsfChannel::Achromatic, Word::Achromatic, [0x1f, 0x24, 0x2b]),
    (CsfChannel::RedGreen, Word::RedGreen, [0xd0, 0x2f, 0x2f]),
    (CsfChannel::YellowViolet, Word::YellowViolet, [0x7a, 0x4f, 0xc0]),
];

impl EyePlot {
    /// Contrast sensitivity at each luminance: castleCSF's three channels, Barten's for a grating of the same area, and that of Mannos and
    /// Sakrison.
    ///
    /// # Errors
    /// [`Error::Luminance`] for one that is not 0.001 to 10⁴ cd/m², [`Error::TooManyLobes`] for too many.
    pub fn contrast(&self) -> Result<LineChart, Error> {
        let luminances = self.checked_luminances(LUMINANCES)?;
        let mut curves = Vec::new();
        for (index, luminance) in luminances.iter().enumerate() {
            let number = self.lang.number(*luminance);
            let named = |name: &str| self.lang.say(Word::AtLuminance, &[name, &number]);
            for (channel, word, color) in CHANNELS {
                let points = ratios(FREQUENCIES, |f| castle_csf(channel, f, *luminance, AREA_DEG2, 0.0));
                curves.push(Curve { name: named(&self.say(word)), points, color, dash: dash(index) });
            }
            let barten = |f| barten_csf(f, *luminance, libm::sqrt(AREA_DEG2));
            let points = ratios(FREQUENCIES, barten);
            curves.push(Curve {
                name: named("Barten 1999"),
                points,
                color: curve_color(0),
                dash: dash(index),
            });
        }
        curves.push(self.scaled_mannos_sakrison(luminances));
        Ok(LineChart {
            title: self.say(Word::Contrast),
            subtitle: self.say(Word::ContrastSource),
            x: Axis::log(self.say(Word::Frequency), FREQUENCIES, &[0.1, 0.3, 1.0, 3.0, 10.0, 30.0]),
            y: Axis::decades(self.say(Word::ContrastLabel), (0, 3)),
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }

    /// The relative function, to the greatest achromatic sensitivity of castleCSF.
    fn scaled_mannos_sakrison(&self, luminances: &[f64]) -> Curve {
        let most = |f: &dyn Fn(f64) -> f64| {
            ratios(FREQUENCIES, f).into_iter().map(|(_, value)| value).fold(0.0, f64::max)
        };
        let peaks = luminances
            .iter()
            .map(|luminance| most(&|f| castle_csf(CsfChannel::Achromatic, f, *luminance, AREA_DEG2, 0.0)));
        let scale = peaks.fold(0.0, f64::max) / most(&mannos_sakrison);
        Curve {
            name: self.say(Word::MannosSakrison),
            points: ratios(FREQUENCIES, |f| scale * mannos_sakrison(f)),
            color: curve_color(7),
            dash: dash(2),
        }
    }
}
