//! Metals: η and k as measured, from the table that `cargo xtask data` writes.

use std::sync::LazyLock;

use super::{IorInfo, IorKind};
use crate::spectra::table::lines;
use crate::spectra::{Outside, Spectrum};

const JOHNSON_CHRISTY_1972: &str = "P. B. Johnson and R. W. Christy, Phys. Rev. B 6, 4370 (1972)";
const JOHNSON_CHRISTY_1974: &str = "P. B. Johnson and R. W. Christy, Phys. Rev. B 9, 5056 (1974)";
const RAKIC_1995: &str = "A. D. Rakić, Appl. Opt. 34, 4755 (1995), evaporated films";
const RAKIC_1998: &str =
    "A. D. Rakić and others, Appl. Opt. 37, 5271 (1998), Brendel-Bormann model fitted to measurements";
const WERNER_2009: &str =
    "W. S. M. Werner and others, J. Phys. Chem. Ref. Data 38, 1013 (2009), from electron energy loss";
const QUERRY_1985: &str = "M. R. Querry, Optical Constants, CRDC-CR-85034 (1985), Cu 70 %, Zn 30 %";

const METALS: &[(&str, &str, &str)] = &[
    ("Ag", "silver", JOHNSON_CHRISTY_1972),
    ("Al", "aluminium", RAKIC_1995),
    ("Au", "gold", JOHNSON_CHRISTY_1972),
    ("Cr", "chromium", JOHNSON_CHRISTY_1974),
    ("Cu", "copper", JOHNSON_CHRISTY_1972),
    ("Fe", "iron", JOHNSON_CHRISTY_1974),
    ("Ni", "nickel", JOHNSON_CHRISTY_1974),
    ("Pt", "platinum", RAKIC_1998),
    ("Ti", "titanium", JOHNSON_CHRISTY_1974),
    ("W", "tungsten", RAKIC_1998),
    ("Zn", "zinc", WERNER_2009),
    ("brass", "CuZn30", QUERRY_1985),
];

/// One row of the table.
struct Point {
    metal: &'static str,
    nm: f64,
    eta: f64,
    k: f64,
}

static POINTS: LazyLock<Vec<Point>> = LazyLock::new(|| {
    // The first line that is no comment names the columns.
    let rows = lines(include_str!("../../../data/metals.csv")).skip(1);
    let point = |mut cells: std::str::Split<'static, char>| {
        let metal = cells.next()?;
        let mut number = || cells.next()?.parse().ok();
        Some(Point { metal, nm: number()?, eta: number()?, k: number()? })
    };
    rows.map(|row| point(row).expect("a row of metals has four cells")).collect()
});

pub(super) fn infos() -> impl Iterator<Item = IorInfo> {
    METALS.iter().map(|&(name, title, source)| {
        let mut of_it = POINTS.iter().filter(|point| point.metal == name).map(|point| point.nm);
        let first = of_it.next().expect("every listed metal has rows");
        let range_nm = (first, of_it.next_back().unwrap_or(first));
        IorInfo { name, title, kind: IorKind::Metal, source, range_nm }
    })
}

/// η and k of a metal of the list.
pub(super) fn spectra(name: &str) -> (Spectrum, Spectrum) {
    let of_it = || POINTS.iter().filter(|point| point.metal == name);
    let nm: Vec<f64> = of_it().map(|point| point.nm).collect();
    let on_grid = |values: Vec<f64>| {
        Spectrum::from_table(&nm, &values, Outside::Hold).expect("every listed metal has a table")
    };
    (on_grid(of_it().map(|point| point.eta).collect()), on_grid(of_it().map(|point| point.k).collect()))
}
