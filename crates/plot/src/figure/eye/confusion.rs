//! Lines of colours that eyes without a kind of cones take for the same.

use std::sync::LazyLock;

use glanz_color::{Matrix3, Observer, Spectrum, observer};
use glanz_eye::Eye;

use super::{EyePlot, check_count};
use crate::Error;
use crate::chart::{Axis, Curve, LineChart};
use crate::page::{curve_color, dash};
use crate::words::Word;

/// Lines for each eye.
const LINES: usize = 11;
/// Places along a line at which it is looked whether there are colours.
const STEPS: usize = 600;
/// How far a line is followed, in units of the diagram.
const REACH: f64 = 3.0;

impl EyePlot {
    /// Confusion lines in the chromaticity diagram of CIE 170-2:2015 for 2°, of eyes of which a kind of cones is missing: colours on a line differ in
    /// that kind alone, and look alike at the right luminance. They meet in the colour that the missing cones alone would see.
    ///
    /// The standard cones are combinations of that diagram's curves; of other eyes the nearest by least squares are taken.
    ///
    /// # Errors
    /// [`Error::TooManyLobes`] for too many eyes.
    pub fn confusion(&self, eyes: &[Eye]) -> Result<LineChart, Error> {
        check_count(eyes.len())?;
        let closed = LOCUS.iter().chain(LOCUS.first()).copied();
        let mut curves = vec![Curve {
            name: self.say(Word::Locus),
            points: closed.collect(),
            color: [0x8a, 0x93, 0x9e],
            dash: None,
        }];
        for (index, eye) in eyes.iter().enumerate() {
            let Some((x, y)) = copunctal(eye) else { continue };
            for line in 0..LINES {
                let points = inside((x, y), towards((x, y), line));
                if points.len() < 2 {
                    continue;
                }
                // Adding 0 leaves no negative 0.
                let [x, y] = [x, y].map(|v| (v * 1000.0).round() / 1000.0 + 0.0);
                let name = if line == LINES / 2 { format!("{eye}: ({x:.3}, {y:.3})") } else { String::new() };
                curves.push(Curve { name, points, color: curve_color(index), dash: dash(0) });
            }
        }
        Ok(LineChart {
            title: self.say(Word::Confusion),
            subtitle: self.say(Word::ConfusionSource),
            x: Axis::exact("x", (0.0, 0.8), 8),
            y: Axis::exact("y", (0.0, 0.9), 9),
            curves,
            marks: Vec::new(),
            lang: self.lang,
        })
    }
}

/// The observer of CIE 170-2, whose curves are combinations of the standard cones.
static DIAGRAM: LazyLock<Observer> =
    LazyLock::new(|| observer("cie2015-2").expect("the observer is in the list"));

/// The chromaticities of single wavelengths, from 390 to 700 nm by 5 nm.
static LOCUS: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    let at = |nm: i32| {
        let xyz: [f64; 3] = core::array::from_fn(|c| DIAGRAM.channels[c].sensitivity.at(f64::from(nm)));
        let sum: f64 = xyz.iter().sum();
        (xyz[0] / sum, xyz[1] / sum)
    };
    (390..=700).step_by(5).map(at).collect()
});

/// The chromaticity of what the missing cones alone would see; none of an eye that has all.
fn copunctal(eye: &Eye) -> Option<(f64, f64)> {
    let missing = eye.cones.missing()?;
    let cones: [Spectrum; 3] = core::array::from_fn(|c| eye.with_usual_cones().cone(c));
    let xyz = &DIAGRAM.channels;
    // The normal equations of XYZ as sums of the cones' curves.
    let normal =
        Matrix3::from_columns(core::array::from_fn(|i| core::array::from_fn(|j| cones[i].dot(&cones[j]))));
    let inverse = normal.inverse();
    let [x, y, z] = core::array::from_fn(|axis| {
        let target = &xyz[axis].sensitivity;
        inverse.apply(core::array::from_fn(|c| cones[c].dot(target)))[missing]
    });
    Some((x / (x + y + z), y / (x + y + z)))
}

/// The direction of a line: lines are spread evenly by angle over the diagram.
fn towards((x, y): (f64, f64), line: usize) -> (f64, f64) {
    // Seen from the middle of the diagram, so that angles do not jump where they are measured.
    let middle = libm::atan2(1.0 / 3.0 - y, 1.0 / 3.0 - x);
    let off = |(to_x, to_y): &(f64, f64)| {
        let angle = libm::atan2(to_y - y, to_x - x) - middle;
        libm::atan2(libm::sin(angle), libm::cos(angle))
    };
    let (least, most) = LOCUS.iter().map(off).fold((0.0_f64, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
    let part = (line as f64 + 0.5) / LINES as f64;
    let angle = middle + least + part * (most - least);
    (libm::cos(angle), libm::sin(angle))
}

/// The part of a line that lies among the colours there are.
fn inside((x, y): (f64, f64), (dx, dy): (f64, f64)) -> Vec<(f64, f64)> {
    let places = (0..=STEPS).map(|i| REACH * i as f64 / STEPS as f64).map(|t| (x + t * dx, y + t * dy));
    let within: Vec<(f64, f64)> = places.filter(|place| is_color(*place)).collect();
    match within[..] {
        [first, .., last] => vec![first, last],
        _ => Vec::new(),
    }
}

/// Whether a chromaticity lies within the locus and the line that closes it: by how often a ray meets them.
fn is_color((x, y): (f64, f64)) -> bool {
    let edges = LOCUS.iter().zip(LOCUS.iter().skip(1).chain(LOCUS.first()));
    let meets =
        edges.filter(|(a, b)| (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0));
    meets.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums by 5 nm of curves with six digits.
    const FIT: f64 = 5e-4;

    #[test]
    fn lines_meet_where_the_matrix_of_cie_170_2_has_them() {
        // x = 1.94735469 L − 1.41445123 M + 0.36476327 S, y = 0.68990272 L + 0.34832189 M, z = 1.93485343 S.
        for (name, expected) in
            [("protan", (0.73841, 0.26159)), ("deutan", (1.32671, -0.32671)), ("tritan", (0.15862, 0.0))]
        {
            let (x, y) = copunctal(&name.parse().unwrap()).unwrap();
            assert!((x - expected.0).abs() < FIT && (y - expected.1).abs() < FIT, "{name}: {x} {y}");
        }
        assert_eq!(copunctal(&Eye::default()), None);
    }

    #[test]
    fn lines_stay_among_the_colors() {
        let eyes: Vec<Eye> =
            ["protan", "deutan", "tritan"].iter().map(|name| name.parse().unwrap()).collect();
        let chart = EyePlot::default().confusion(&eyes).unwrap();
        assert!(chart.curves.len() > 3 * (LINES - 2), "{}", chart.curves.len());
        for (x, y) in chart.curves[1..].iter().flat_map(|curve| &curve.points) {
            assert!(is_color((*x, *y)), "{x} {y}");
        }
        assert!(is_color((1.0 / 3.0, 1.0 / 3.0)) && !is_color((0.0, 0.0)) && !is_color((0.7, 0.5)));
    }
}
