//! Meyer's basis functions and where he samples them.

use glanz_color::meyer::{NODES_NM, curves};

use crate::chart::{Curve, Marked, WavelengthChart};
use crate::page::style::Rgb8;
use crate::words::{Lang, Word};

/// Dark for A, red for C1 (red against green), blue for C2 (blue against yellow).
const COLORS: [Rgb8; 3] = [[0x1f, 0x24, 0x2b], [0xd0, 0x2f, 0x2f], [0x2d, 0x5f, 0xd3]];
const NAMES: [Word; 3] = [Word::MeyerA, Word::MeyerC1, Word::MeyerC2];

/// The plot of A, C1 and C2 with the four wavelengths.
pub fn meyer(lang: Lang) -> WavelengthChart {
    let curves = curves().into_iter().zip(NAMES).zip(COLORS).map(|((points, name), color)| Curve {
        name: lang.say(name, &[]),
        points,
        color,
        dash: None,
    });
    let marked = NODES_NM.map(|nm| Marked { nm, label: nm.to_string() });
    WavelengthChart {
        title: lang.say(Word::Meyer, &[]),
        subtitle: lang.say(Word::MeyerAxes, &[]),
        label: lang.say(Word::MeyerLabel, &[]),
        range_nm: (380.0, 780.0),
        curves: curves.collect(),
        marked: marked.into(),
        lang,
    }
}
