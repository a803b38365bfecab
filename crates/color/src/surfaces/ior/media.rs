//! Transparent media: Sellmeier coefficients as published.
//!
//! All resonances lie below 250 nm or beyond 3 µm, so the formulas stay smooth where they are continued
//! to the grid's ends.

use super::dispersion::Dispersion::{self, Sellmeier};
use super::{IorInfo, IorKind};

struct Medium {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    range_nm: (f64, f64),
    formula: Dispersion<'static>,
}

const MEDIA: &[Medium] = &[
    Medium {
        name: "BK7",
        title: "crown glass",
        source: "N-BK7, Schott data sheet (2017)",
        range_nm: (300.0, 2500.0),
        formula: Sellmeier(&[
            (1.03961212, 0.00600069867),
            (0.231792344, 0.0200179144),
            (1.01046945, 103.560653),
        ]),
    },
    Medium {
        name: "SF10",
        title: "flint glass",
        source: "SF10, Schott data sheet (2017)",
        range_nm: (380.0, 2500.0),
        formula: Sellmeier(&[
            (1.61625977, 0.0127534559),
            (0.259229334, 0.0581983954),
            (1.07762317, 116.60768),
        ]),
    },
    Medium {
        name: "fused-silica",
        title: "quartz glass",
        source: "I. H. Malitson, J. Opt. Soc. Am. 55, 1205 (1965)",
        range_nm: (210.0, 3710.0),
        formula: Sellmeier(&[
            (0.6961663, 0.0684043 * 0.0684043),
            (0.4079426, 0.1162414 * 0.1162414),
            (0.8974794, 9.896161 * 9.896161),
        ]),
    },
    Medium {
        name: "diamond",
        title: "C",
        source: "F. Peter, Z. Phys. 15, 358 (1923)",
        range_nm: (226.0, 644.0),
        formula: Sellmeier(&[(0.3306, 0.175 * 0.175), (4.3356, 0.106 * 0.106)]),
    },
    Medium {
        name: "water",
        title: "H2O",
        source: "M. Daimon and A. Masumura, Appl. Opt. 46, 3811 (2007), at 20 °C",
        range_nm: (182.0, 1129.0),
        formula: Sellmeier(&[
            (5.684027565e-1, 5.101829712e-3),
            (1.726177391e-1, 1.821153936e-2),
            (2.086189578e-2, 2.620722293e-2),
            (1.130748688e-1, 1.069792721e1),
        ]),
    },
    Medium {
        name: "sapphire",
        title: "Al2O3",
        source: "I. H. Malitson and M. J. Dodge, J. Opt. Soc. Am. 62, 1405 (1972), ordinary ray",
        range_nm: (200.0, 5000.0),
        formula: Sellmeier(&[
            (1.4313493, 0.0726631 * 0.0726631),
            (0.65054713, 0.1193242 * 0.1193242),
            (5.3414021, 18.028251 * 18.028251),
        ]),
    },
    Medium {
        name: "PMMA",
        title: "acrylic",
        source: "N. Sultanova, S. Kasarova, I. Nikolov, Acta Phys. Pol. A 116, 585 (2009), fit by M. Polyanskiy",
        range_nm: (437.0, 1052.0),
        formula: Sellmeier(&[(1.1819, 0.011313)]),
    },
    Medium {
        name: "polycarbonate",
        title: "PC",
        source: "N. Sultanova, S. Kasarova, I. Nikolov, Acta Phys. Pol. A 116, 585 (2009), fit by M. Polyanskiy",
        range_nm: (437.0, 1052.0),
        formula: Sellmeier(&[(1.4182, 0.021304)]),
    },
];

pub(super) fn infos() -> impl Iterator<Item = IorInfo> {
    MEDIA.iter().map(|medium| IorInfo {
        name: medium.name,
        title: medium.title,
        kind: IorKind::Dielectric,
        source: medium.source,
        range_nm: medium.range_nm,
    })
}

/// The formula of a medium of the list.
pub(super) fn formula(name: &str) -> Dispersion<'static> {
    let medium = MEDIA.iter().find(|medium| medium.name == name);
    medium.expect("every listed medium has a formula").formula
}
