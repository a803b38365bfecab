//! The dyes that come with the crate.
//!
//! Each shape is a sum of Gaussians over wavenumber, fitted to spectra that were measured of the dye in solution: to the
//! absorption from 290 nm on, and to the emission, which is photons by wavelength. What the fits miss is at most 0.03 of the
//! greatest value, and 0.01 in the root of the mean square.

use std::sync::LazyLock;

use super::Dye;
use crate::spectra::Spectrum;
use crate::surfaces::fluorophore::band;

/// What is known about a dye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DyeInfo {
    /// The name as [`dye`](super::dye) knows it.
    pub name: &'static str,
    /// What it is, and in what it was measured.
    pub title: &'static str,
    /// Where its spectra come from.
    pub source: &'static str,
    /// Photons emitted for each absorbed.
    pub quantum_yield: f64,
    /// Where the quantum yield comes from.
    pub yield_source: &'static str,
}

/// All dyes.
pub fn dyes() -> &'static [DyeInfo] {
    static INFOS: LazyLock<Vec<DyeInfo>> = LazyLock::new(|| DYES.iter().map(|dye| dye.info).collect());
    &INFOS
}

/// The dye of a name, in small letters.
pub(super) fn find(name: &str) -> Option<Dye> {
    let fitted = DYES.iter().find(|dye| dye.info.name == name)?;
    let shape = |bands: &[Band], nm: f64| {
        bands.iter().map(|(peak, fwhm, height)| height * band(nm, *peak, *fwhm)).sum::<f64>()
    };
    let absorption = Spectrum::from_fn(|nm| shape(fitted.absorption, nm));
    let power = Spectrum::from_fn(|nm| shape(fitted.emission, nm) / nm);
    let dye = Dye::from_spectra(&absorption, &power, fitted.info.quantum_yield);
    Some(dye.expect("a listed dye has spectra and a yield"))
}

/// The peak and the width between half values in nm, and the height.
type Band = (f64, f64, f64);

struct Fitted {
    info: DyeInfo,
    absorption: &'static [Band],
    emission: &'static [Band],
}

const PHOTOCHEMCAD: &str = "bands fitted to spectra of PhotochemCAD: M. Taniguchi, J. S. Lindsey, Photochem. Photobiol. 94, 2018, \
                            290-327";

const DYES: [Fitted; 7] = [
    Fitted {
        info: DyeInfo {
            name: "pyranine",
            title: "pyranine (HPTS) in alkaline water: yellow markers",
            source: PHOTOCHEMCAD,
            quantum_yield: 1.0,
            yield_source: "T.-H. Tran-Thi et al., 2002, at pH 10, as cited there",
        },
        absorption: &[
            (441.4, 44.5, 0.677),
            (463.1, 32.5, 0.521),
            (293.0, 47.3, 0.514),
            (394.3, 66.3, 0.214),
            (298.3, 12.9, 0.178),
            (391.0, 10.2, 0.034),
        ],
        emission: &[(509.5, 41.1, 0.887), (543.3, 42.9, 0.203), (547.7, 85.2, 0.145)],
    },
    Fitted {
        info: DyeInfo {
            name: "fluorescein",
            title: "fluorescein in alkaline ethanol",
            source: PHOTOCHEMCAD,
            quantum_yield: 0.97,
            yield_source: "P. G. Seybold et al., 1969, as cited there",
        },
        absorption: &[
            (500.9, 22.6, 0.813),
            (479.1, 41.3, 0.361),
            (290.4, 30.2, 0.122),
            (325.4, 18.8, 0.063),
            (442.9, 35.0, 0.041),
            (334.2, 140.0, 0.025),
        ],
        emission: &[(539.6, 27.1, 0.845), (565.5, 52.8, 0.308), (600.2, 84.4, 0.064)],
    },
    Fitted {
        info: DyeInfo {
            name: "coumarin-6",
            title: "coumarin 6 in ethanol: green and yellow day-glow pigments",
            source: PHOTOCHEMCAD,
            quantum_yield: 0.78,
            yield_source: "G. A. Reynolds, K. H. Drexhage, Opt. Commun. 13, 1975",
        },
        absorption: &[
            (470.0, 28.0, 0.578),
            (432.5, 50.2, 0.521),
            (448.4, 32.9, 0.474),
            (285.8, 54.1, 0.182),
            (400.6, 50.0, 0.116),
        ],
        emission: &[(494.5, 29.2, 0.589), (518.5, 51.9, 0.563), (547.2, 89.9, 0.206)],
    },
    Fitted {
        info: DyeInfo {
            name: "rhodamine-6g",
            title: "rhodamine 6G in ethanol",
            source: PHOTOCHEMCAD,
            quantum_yield: 0.95,
            yield_source: "R. F. Kubin, A. N. Fletcher, J. Luminescence 27, 1982",
        },
        absorption: &[
            (530.8, 25.4, 0.849),
            (505.4, 45.3, 0.331),
            (292.8, 19.0, 0.106),
            (347.2, 16.8, 0.065),
            (312.5, 110.3, 0.039),
            (465.2, 37.4, 0.033),
        ],
        emission: &[(553.8, 33.5, 0.597), (580.4, 74.8, 0.470), (538.7, 20.9, 0.293)],
    },
    Fitted {
        info: DyeInfo {
            name: "rhodamine-b",
            title: "rhodamine B in ethanol: pink markers",
            source: PHOTOCHEMCAD,
            quantum_yield: 0.7,
            yield_source: "F. Lopez Arbeloa et al., 1989, as cited there",
        },
        absorption: &[
            (544.1, 27.9, 0.829),
            (519.8, 44.0, 0.333),
            (300.5, 30.4, 0.155),
            (354.2, 29.8, 0.086),
            (491.2, 55.1, 0.069),
            (402.3, 46.2, 0.033),
        ],
        emission: &[(563.5, 30.7, 0.766), (588.8, 76.1, 0.327)],
    },
    Fitted {
        info: DyeInfo {
            name: "quinine-sulphate",
            title: "quinine sulphate in sulphuric acid, 0.5 mol/l",
            source: PHOTOCHEMCAD,
            quantum_yield: 0.546,
            yield_source: "D. F. Eaton, Pure Appl. Chem. 60, 1988; W. H. Melhuish, J. Phys. Chem. 65, 1961",
        },
        absorption: &[
            (354.8, 33.9, 0.756),
            (315.8, 38.1, 0.653),
            (260.0, 78.8, 0.267),
            (339.4, 23.1, 0.232),
            (317.4, 10.0, 0.037),
        ],
        emission: &[(455.9, 71.3, 0.648), (426.4, 49.0, 0.329), (491.9, 107.0, 0.295)],
    },
    Fitted {
        info: DyeInfo {
            name: "brightener-28",
            title: "fluorescent brightener 28 (Calcofluor White M2R, Tinopal UNPA), a stilbene, at pH 9.4",
            source: "bands fitted to spectra of G. McNamara, C. A. Boswell et al., Cytometry A 69, 2006, 863-871",
            quantum_yield: 0.8,
            yield_source: "chosen; brighteners in and on fibres reach 0.8 to 0.9 (K. Hunger (ed.), Industrial Dyes, 2003)",
        },
        absorption: &[(260.2, 49.1, 1.2), (334.2, 46.2, 0.683), (357.7, 38.2, 0.54), (378.8, 29.8, 0.204)],
        emission: &[(428.7, 41.1, 0.566), (448.8, 68.9, 0.494), (409.2, 22.5, 0.316)],
    },
];
