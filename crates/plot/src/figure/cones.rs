//! The cones and the rods of the eye.

use glanz_color::{Observer, UnknownName, observer};

use crate::chart::{Curve, WavelengthChart};
use crate::page::style::Rgb8;
use crate::words::{Lang, Word};

/// Red, green and blue for long, middle and short waves, grey for the rods.
const COLORS: [Rgb8; 4] = [[0xd0, 0x2f, 0x2f], [0x1f, 0x9d, 0x45], [0x2d, 0x5f, 0xd3], [0x8a, 0x93, 0x9e]];

/// The plot of the cones of 2° and 10° and of the rods, each 1 at its peak.
pub fn cones(lang: Lang) -> Result<WavelengthChart, UnknownName> {
    let near = curves(&observer("lms2")?, "2°", None);
    let wide = curves(&observer("lms10")?, "10°", Some((9.0, 6.0)));
    let rods = curves(&observer("scotopic")?, "", None).into_iter().map(|curve| Curve {
        name: lang.say(Word::Rods, &[]),
        color: COLORS[3],
        ..curve
    });
    Ok(WavelengthChart {
        title: lang.say(Word::Cones, &[]),
        subtitle: lang.say(Word::ConesSource, &[]),
        label: lang.say(Word::Sensitivity, &[]),
        range_nm: (380.0, 780.0),
        curves: near.into_iter().chain(wide).chain(rods).collect(),
        marked: Vec::new(),
        lang,
    })
}

fn curves(observer: &Observer, field: &str, dash: Option<(f64, f64)>) -> Vec<Curve> {
    let curves = observer.channels.iter().zip(COLORS).map(|(channel, color)| Curve {
        name: format!("{} {field}", channel.name).trim().to_owned(),
        points: channel.sensitivity.points().collect(),
        color,
        dash,
    });
    curves.collect()
}
