//! The cones and rods of eyes.

use glanz_eye::Eye;

use super::{EyePlot, check_count};
use crate::Error;
use crate::chart::{Curve, WavelengthChart};
use crate::page::{Rgb8, dash};
use crate::words::Word;

/// Red, green and blue for long, middle and short waves, grey for the rods.
const COLORS: [Rgb8; 4] = [[0xd0, 0x2f, 0x2f], [0x1f, 0x9d, 0x45], [0x2d, 0x5f, 0xd3], [0x8a, 0x93, 0x9e]];

impl EyePlot {
    /// The sensitivities of the cones and rods of eyes, on the scale on which those of the standard eye are 1 at their peaks: an old eye
    /// has lower ones. Missing cones are left out.
    ///
    /// # Errors
    /// [`Error::TooManyLobes`] for too many eyes.
    pub fn cones(&self, eyes: &[Eye]) -> Result<WavelengthChart, Error> {
        check_count(eyes.len())?;
        let of_eye = |(index, eye): (usize, &Eye)| {
            let dash = dash(index);
            let observer = eye.observer_with_rods();
            let curves = observer.channels.iter().enumerate().filter_map(move |(c, channel)| {
                let missing = eye.cones.missing() == Some(c) || eye.cones == glanz_eye::Cones::None && c < 3;
                let points = channel.sensitivity.points().filter(|(nm, _)| *nm >= 360.0).collect();
                let name = format!("{}, {eye}", channel.name);
                (!missing).then_some(Curve { name, points, color: COLORS[c], dash })
            });
            curves.collect::<Vec<_>>()
        };
        Ok(WavelengthChart {
            title: self.say(Word::Cones),
            subtitle: self.say(Word::ConesOfEyes),
            label: self.say(Word::Sensitivity),
            range_nm: (360.0, 780.0),
            curves: eyes.iter().enumerate().flat_map(of_eye).collect(),
            marked: Vec::new(),
            lang: self.lang,
        })
    }
}
