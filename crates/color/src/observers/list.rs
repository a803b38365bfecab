//! The observers that come with Glanz.

use super::ObserverKind;

/// What is known about an observer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObserverInfo {
    /// The name as [`observer`](crate::observer) knows it.
    pub name: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// What its channels are.
    pub kind: ObserverKind,
    /// Where its numbers come from, and for which wavelengths; outside of them they are 0.
    pub source: &'static str,
}

/// All observers by name.
pub const fn observers() -> &'static [ObserverInfo] {
    LIST
}

const LIST: &[ObserverInfo] = &[
    ObserverInfo {
        name: "cie1931",
        title: "CIE 1931 standard observer, 2°",
        kind: ObserverKind::Xyz,
        source: "ISO/CIE 11664-1, from 360 nm",
    },
    ObserverInfo {
        name: "cie1964",
        title: "CIE 1964 supplementary standard observer, 10°",
        kind: ObserverKind::Xyz,
        source: "ISO/CIE 11664-1, from 360 nm",
    },
    ObserverInfo {
        name: "cie2015-2",
        title: "CIE 2015 observer from cone fundamentals, 2°",
        kind: ObserverKind::Xyz,
        source: "CIE 170-2:2015, from 390 nm",
    },
    ObserverInfo {
        name: "cie2015-10",
        title: "CIE 2015 observer from cone fundamentals, 10°",
        kind: ObserverKind::Xyz,
        source: "CIE 170-2:2015, from 390 nm",
    },
    ObserverInfo {
        name: "lms2",
        title: "cone fundamentals, 2°",
        kind: ObserverKind::Lms,
        source: "Stockman and Sharpe 2000, CIE 170-1:2006, from 390 nm; S is 0 above 615 nm",
    },
    ObserverInfo {
        name: "lms10",
        title: "cone fundamentals, 10°",
        kind: ObserverKind::Lms,
        source: "Stockman and Sharpe 2000, CIE 170-1:2006, from 390 nm; S is 0 above 615 nm",
    },
    ObserverInfo {
        name: "photopic",
        title: "luminous efficiency V(λ) by day",
        kind: ObserverKind::Photopic,
        source: "CIE 1924 (ISO/CIE 23539), from 360 nm",
    },
    ObserverInfo {
        name: "scotopic",
        title: "luminous efficiency V'(λ) at night, of the rods",
        kind: ObserverKind::Scotopic,
        source: "CIE 1951 (ISO/CIE 23539), from 380 nm",
    },
];
