//! Colours of lights and surfaces.

use glanz_color::{Ior, Rgb, fluorescent, fluorescents};

use super::text::{Table, inline, number, rgb, samples, string, tall_list};
use crate::file::build::air;
use crate::{Boundary, CoatedBoundary, Film, LightColor, Pane, Polarization, Tint, Transmittance};

/// The colour of a light.
pub(super) fn light(color: &LightColor) -> String {
    match color {
        LightColor::Rgb(color) => rgb(*color),
        LightColor::Spectrum(spectrum) => inline([("samples", samples(spectrum))]),
    }
}

/// The tint of a surface.
pub(super) fn tint(tint: &Tint) -> String {
    match tint {
        Tint::Rgb(color) => rgb(*color),
        Tint::Spectrum(spectrum) => inline([("samples", samples(spectrum))]),
        Tint::Reradiation(matrix) => {
            let is_known = |name: &&str| fluorescent(name).is_ok_and(|known| known == **matrix);
            match fluorescents().iter().map(|info| info.name).find(is_known) {
                Some(name) => inline([("reradiation", string(name))]),
                None => {
                    let rows = Vec::from((**matrix).clone());
                    inline([("matrix", tall_list(rows.iter().map(samples)))])
                }
            }
        }
        Tint::Ior(medium) => inline([("ior", ior(medium))]),
        Tint::Polarized(medium, polarization) => {
            inline([("ior", ior(medium)), ("polarization", string(Polarization::name(*polarization)))])
        }
        Tint::Schlick(at_normal) => inline([("schlick", self::tint(at_normal))]),
        Tint::Film(thin) => film(thin).inline(),
        Tint::Pane(sheet) => pane(sheet),
        Tint::Coated(boundary) => coated(boundary),
    }
}

/// The transmittance of a surface; `None` for tints that mean something else there.
pub(super) fn transmittance(value: &Transmittance) -> Option<String> {
    Some(match value {
        Transmittance::Constant(color @ (Tint::Rgb(_) | Tint::Spectrum(_) | Tint::Schlick(_))) => tint(color),
        Transmittance::Constant(_) => return None,
        Transmittance::Boundary(medium) => inline([("ior", ior(medium))]),
        Transmittance::Pane(sheet) => pane(sheet),
        Transmittance::Film(thin) => film(thin).inline(),
    })
}

/// Whether a tint is what lobes have that say none.
pub(super) fn is_white(tint: &Tint) -> bool {
    *tint == Tint::Rgb(Rgb::WHITE)
}

/// A medium by its name, its index, or its samples.
fn ior(medium: &Ior) -> String {
    if glanz_color::ior(&medium.name).as_ref() == Ok(medium) {
        return string(&medium.name);
    }
    let index = medium.eta.0[0];
    if (1.05..=20.0).contains(&index) && *medium == Ior::constant(index) {
        return number(index);
    }
    let mut table = Table::default();
    table.put("name", string(&medium.name));
    table.put("eta", samples(&medium.eta));
    table.put_unless(medium.k.max() == 0.0 && medium.k.0.iter().all(|k| *k == 0.0), "k", samples(&medium.k));
    table.put_unless(medium.source.is_empty(), "source", string(&medium.source));
    table.inline()
}

fn film(film: &Film) -> Table {
    let mut table = Table::default();
    table.put("film_nm", number(film.thickness_nm));
    table.put("film_ior", ior(&film.film));
    table.put_unless(film.base == air(), "ior", ior(&film.base));
    table
}

fn coated(boundary: &CoatedBoundary) -> String {
    let mut table = match &boundary.below {
        Boundary::Film(thin) => film(thin),
        Boundary::Medium(medium) | Boundary::Polarized(medium, _) => {
            let mut table = Table::default();
            table.put("ior", ior(medium));
            table
        }
    };
    if let Boundary::Polarized(_, polarization) = &boundary.below {
        table.put("polarization", string(Polarization::name(*polarization)));
    }
    let coat = [("ior", ior(&boundary.coat)), ("alpha", number(boundary.alpha))];
    table.put("under_coat", inline(coat));
    table.inline()
}

fn pane(pane: &Pane) -> String {
    let mut table = Table::default();
    table.put("ior", ior(&pane.ior));
    table.put("thickness_m", number(pane.thickness));
    table.put_unless(pane.absorption.0.iter().all(|a| *a == 0.0), "absorption", samples(&pane.absorption));
    inline([("pane", table.inline())])
}
