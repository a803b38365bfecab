//! Dichromacy as many programs show it: on the linear light of a screen.

use glanz_color::Matrix3;

use crate::Cones;

/// The matrix on linear sRGB by which G. M. Machado, M. M. Oliveira and L. A. F. Fernandes ("A Physiologically-based Model for Simulation of
/// Color Vision Deficiency", IEEE TVCG 15(6), 2009) show what is seen without a kind of cones, at severity 1; none where none or all are
/// missing.
///
/// For comparison: it knows neither spectra nor the eye's age, and white alone stays what it is. On the patches of the ColorChecker it is
/// 2.4 (protan), 1.8 (deutan) and 4.5 (tritan) ΔE00 from the projection of true cones, up to 12.
///
/// ```
/// use glanz_eye::{Cones, machado};
///
/// let [r, g, b] = machado(Cones::NoM).expect("a kind is missing").apply([1.0; 3]);
/// assert!((r - 1.0).abs() < 1e-5 && (g - 1.0).abs() < 1e-5 && (b - 1.0).abs() < 1e-5);
/// assert!(machado(Cones::All).is_none());
/// ```
pub fn machado(cones: Cones) -> Option<Matrix3> {
    Some(Matrix3(match cones {
        Cones::NoL => [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        Cones::NoM => {
            [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
        }
        Cones::NoS => [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
        Cones::All | Cones::None => return None,
    }))
}

/// L, M, S of V. C. Smith and J. Pokorny (1975) by X, Y, Z as D. B. Judd and J. J. Vos corrected them.
const LMS_OF_XYZ: Matrix3 =
    Matrix3([[0.15514, 0.54312, -0.03286], [-0.15514, 0.45684, 0.03286], [0.0, 0.0, 0.01608]]);

/// These X, Y, Z by linear light of a screen of BT.709 (F. Viénot, H. Brettel, J. D. Mollon 1999).
const XYZ_OF_RGB: Matrix3 = Matrix3([
    [0.409568, 0.355041, 0.179167],
    [0.213389, 0.706743, 0.079868],
    [0.0186297, 0.114620, 0.912367],
]);

/// These X, Y, Z of light of 475, 575, 485 and 660 nm.
const ANCHORS: [[f64; 3]; 4] = [
    [0.13287, 0.11284, 0.9422],
    [0.84394, 0.91558, 0.00197],
    [0.05699, 0.16987, 0.5864],
    [0.16161, 0.061, 1e-5],
];

/// The projection of H. Brettel, F. Viénot and J. D. Mollon (1997) on the linear light of a screen, with the cones of Smith and Pokorny
/// and the screen's white as neutral, as DaltonLens and programs after it show what is seen without a kind of cones.
///
/// For comparison, as [`machado`]: on the patches of the ColorChecker it is 1.3 (protan), 1.1 (deutan) and 1.5 (tritan) ΔE00 from the
/// projection of true cones, up to 6.
///
/// ```
/// use glanz_eye::{BrettelOnScreen, Cones};
///
/// let protan = BrettelOnScreen::without(Cones::NoL).expect("a kind is missing");
/// let [r, g, b] = protan.apply([1.0, 0.0, 0.0]);
/// assert!((r - 0.1498).abs() < 1e-4 && (g - 0.1076).abs() < 1e-4 && (b - 0.0038).abs() < 1e-4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrettelOnScreen {
    /// The maps on either side of the plane: on that to which its normal points, and on the other.
    sides: [Matrix3; 2],
    /// The normal of the plane that holds white and the direction of the missing cone.
    between: [f64; 3],
}

impl BrettelOnScreen {
    /// That of an eye without a kind of cones; none where none or all are missing.
    pub fn without(cones: Cones) -> Option<Self> {
        let missing = cones.missing()?;
        let to_lms = LMS_OF_XYZ.times(&XYZ_OF_RGB);
        let to_rgb = to_lms.inverse();
        let white = to_lms.apply([1.0; 3]);
        let anchors = if missing == 2 { [ANCHORS[2], ANCHORS[3]] } else { [ANCHORS[0], ANCHORS[1]] };
        let anchors = anchors.map(|xyz| LMS_OF_XYZ.apply(xyz));
        let axis = core::array::from_fn(|c| if c == missing { 1.0 } else { 0.0 });
        let mut between = cross(white, axis);
        if dot(between, anchors[0]) < 0.0 {
            between = between.map(|value| -value);
        }
        let sides = anchors.map(|anchor| {
            let normal = cross(white, anchor);
            let mut projection = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            projection[missing] =
                core::array::from_fn(|c| if c == missing { 0.0 } else { -normal[c] / normal[missing] });
            to_rgb.times(&Matrix3(projection)).times(&to_lms)
        });
        // The normal in the screen's light: n · (M rgb).
        let columns: [[f64; 3]; 3] =
            core::array::from_fn(|c| to_lms.apply(core::array::from_fn(|i| if i == c { 1.0 } else { 0.0 })));
        Some(Self { sides, between: columns.map(|column| dot(between, column)) })
    }

    /// What is shown for a colour of linear sRGB.
    pub fn apply(&self, rgb: [f64; 3]) -> [f64; 3] {
        self.sides[usize::from(dot(self.between, rgb) < 0.0)].apply(rgb)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The vector product.
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_on_both_sides_are_projected_as_computed_elsewhere() {
        // By numpy, from the same matrices and the text of the paper.
        for (cones, red, blue) in [
            (Cones::NoL, [0.149803, 0.107645, 0.003837], [0.278635, 0.390044, 0.699645]),
            (Cones::NoM, [0.372985, 0.259539, -0.019803], [0.25847, 0.375798, 0.701847]),
            (Cones::NoS, [1.012773, -0.012433, 0.075891], [0.174672, 0.424654, 0.549512]),
        ] {
            let way = BrettelOnScreen::without(cones).unwrap();
            for (rgb, expected) in [([1.0, 0.0, 0.0], red), ([0.2, 0.4, 0.7], blue), ([1.0; 3], [1.0; 3])] {
                for (found, expected) in way.apply(rgb).iter().zip(expected) {
                    assert!((found - expected).abs() < 1e-6, "{cones:?} {rgb:?}: {found} for {expected}");
                }
            }
        }
        assert_eq!(BrettelOnScreen::without(Cones::All), None);
    }
}
