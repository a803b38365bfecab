//! What there is to choose from.

use std::sync::LazyLock;

use crate::spectra::{FIRST_NM, LAST_NM};

/// What is known about a light.
#[derive(Clone, Debug, PartialEq)]
pub struct LightInfo {
    /// The name as [`light`](crate::light) knows it; for a family, the form of its names.
    pub name: &'static str,
    /// A name that gives such a light: the name itself, or one of the family.
    pub example: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// Where its numbers come from.
    pub source: &'static str,
    /// The wavelengths in nm for which the source gives values.
    pub range_nm: (f64, f64),
    /// What the spectrum is between 300 nm and there.
    pub below: &'static str,
}

/// All lights and families of lights, in the order in which CIE lists them.
pub fn lights() -> &'static [LightInfo] {
    static LIST: LazyLock<Vec<LightInfo>> = LazyLock::new(list);
    &LIST
}

/// The names of the lights that come from tables, and what they are.
const TABLED: &[(&str, &str)] = &[
    ("B", "direct sunlight, 4874 K (obsolete)"),
    ("C", "average daylight without most of its ultraviolet, 6774 K (obsolete)"),
    ("FL1", "fluorescent, standard: daylight, 6430 K"),
    ("FL2", "fluorescent, standard: cool white, 4230 K"),
    ("FL3", "fluorescent, standard: white, 3450 K"),
    ("FL4", "fluorescent, standard: warm white, 2940 K"),
    ("FL5", "fluorescent, standard: daylight, 6350 K"),
    ("FL6", "fluorescent, standard: light white, 4150 K"),
    ("FL7", "fluorescent, broad band: daylight, 6500 K"),
    ("FL8", "fluorescent, broad band: like D50, 5000 K"),
    ("FL9", "fluorescent, broad band: cool white, 4150 K"),
    ("FL10", "fluorescent, three bands, 5000 K"),
    ("FL11", "fluorescent, three bands, 4000 K"),
    ("FL12", "fluorescent, three bands, 3000 K"),
    ("FL3.1", "fluorescent, halophosphate, 2932 K"),
    ("FL3.2", "fluorescent, halophosphate, 3965 K"),
    ("FL3.3", "fluorescent, halophosphate, 6280 K"),
    ("FL3.4", "fluorescent, de luxe, 2904 K"),
    ("FL3.5", "fluorescent, de luxe, 4086 K"),
    ("FL3.6", "fluorescent, de luxe, 4894 K"),
    ("FL3.7", "fluorescent, three bands, 2979 K"),
    ("FL3.8", "fluorescent, three bands, 4006 K"),
    ("FL3.9", "fluorescent, three bands, 4853 K"),
    ("FL3.10", "fluorescent, three bands, 5000 K"),
    ("FL3.11", "fluorescent, three bands, 5854 K"),
    ("FL3.12", "fluorescent, many bands, 2984 K"),
    ("FL3.13", "fluorescent, many bands, 3896 K"),
    ("FL3.14", "fluorescent, many bands, 5045 K"),
    ("FL3.15", "fluorescent, like D65, 6509 K"),
    ("HP1", "high-pressure sodium, standard, 1959 K"),
    ("HP2", "high-pressure sodium, colour enhanced, 2506 K"),
    ("HP3", "high-pressure metal halide, 3144 K"),
    ("HP4", "high-pressure metal halide, 4002 K"),
    ("HP5", "high-pressure metal halide, 4039 K"),
    ("LED-B1", "LED, blue with phosphor, 2733 K"),
    ("LED-B2", "LED, blue with phosphor, 2998 K"),
    ("LED-B3", "LED, blue with phosphor, 4103 K"),
    ("LED-B4", "LED, blue with phosphor, 5109 K"),
    ("LED-B5", "LED, blue with phosphor, 6598 K"),
    ("LED-BH1", "LED, blue with phosphor and red LED, 2851 K"),
    ("LED-RGB1", "LED, red, green and blue, 2840 K"),
    ("LED-V1", "LED, violet with phosphors, 2724 K"),
    ("LED-V2", "LED, violet with phosphors, 4070 K"),
];

const WHOLE: (f64, f64) = (FIRST_NM, LAST_NM);
const REAL: &str = "real: the formula holds from 300 nm";
const CIE: &str = "CIE 15:2004";

fn list() -> Vec<LightInfo> {
    let mut list = vec![
        fixed(
            "A",
            "incandescent lamp, 2856 K",
            "ISO/CIE 11664-2: Planck's law, T = 2848 K with c2 = 1.435e7 nm K",
        ),
        fixed("D50", "daylight, 5003 K", CIE),
        fixed("D55", "daylight, 5503 K", CIE),
        fixed("D65", "daylight, 6504 K", CIE),
        fixed("D75", "daylight, 7504 K", CIE),
        family("D(cct)", "D(4000)", "daylight of a colour temperature in K, 4000 to 25000; also D4000", CIE),
        LightInfo {
            below: "1, as everywhere",
            ..fixed("E", "equal energy at all wavelengths", "1 by definition")
        },
    ];
    list.extend(TABLED.iter().map(|(name, title)| tabled(name, title)));
    list.extend([
        family(
            "blackbody(T)",
            "blackbody(2700)",
            "Planck's law, T in K",
            "c2 = 1.438776877e7 nm K (SI, 2019)",
        ),
        family(
            "gaussian(nm, fwhm)",
            "gaussian(530, 30)",
            "one band: centre and width at half its peak in nm",
            "exp",
        ),
        family("line(nm)", "line(589.3)", "a single line", "shared by the two samples beside it"),
        fixed("UV365", "black light", "a Gaussian, 365 nm, 20 nm wide at half its peak"),
    ]);
    list
}

fn fixed(name: &'static str, title: &'static str, source: &'static str) -> LightInfo {
    family(name, name, title, source)
}

fn family(name: &'static str, example: &'static str, title: &'static str, source: &'static str) -> LightInfo {
    LightInfo { name, example, title, source, range_nm: WHOLE, below: REAL }
}

fn tabled(name: &'static str, title: &'static str) -> LightInfo {
    let (nm, _) = super::TABLE.points(name).expect("every listed light has a column");
    let range_nm = (nm[0], nm[nm.len() - 1]);
    let below = match range_nm.0 > FIRST_NM {
        true => "0: the source gives nothing there, though the lamp may well shine",
        false => "real: the source gives values from 300 nm",
    };
    let source = if name.starts_with("LED") { "CIE 15:2018, table" } else { "CIE 15:2004, table" };
    LightInfo { source, range_nm, below, ..fixed(name, title, "") }
}
