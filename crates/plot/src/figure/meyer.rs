//! Meyer's basis functions and where he samples them.

use glanz_color::meyer::{NODES_NM, curves};

use crate::chart::{Curve, Marked, WavelengthChart};
use crate::page::style::Rgb8;

/// Dark for A, red for C1 (red against green), blue for C2 (blue against yellow).
const COLORS: [Rgb8; 3] = [[0x1f, 0x24, 0x2b], [0xd0, 0x2f, 0x2f], [0x2d, 0x5f, 0xd3]];
const NAMES: [&str; 3] = ["A, light and dark", "C1, green and red", "C2, blue and yellow"];

/// The plot of A, C1 and C2 with the four wavelengths.
pub fn meyer() -> WavelengthChart {
    let curves = curves().into_iter().zip(NAMES).zip(COLORS).map(|((points, name), color)| Curve {
        name: name.to_owned(),
        points,
        color,
        dash: None,
    });
    let marked = NODES_NM.map(|nm| Marked { nm, label: nm.to_string() });
    WavelengthChart {
        title: "Meyer’s basis functions".to_owned(),
        subtitle: "The opponent space AC1C2 over wavelength, and the four samples in nm (Meyer 1988)"
            .to_owned(),
        label: "response per nm, in the unit of the published weights".to_owned(),
        range_nm: (380.0, 780.0),
        curves: curves.collect(),
        marked: marked.into(),
    }
}
