//! Coats, panes and transmittance.

use std::ops::Range;
use std::sync::Arc;

use glanz_bsdf::Shape;
use glanz_color::{Ior, Spectrum, rgb_spectra};

use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::appearance::layers::{CoatTable, PaneTable};
use crate::file::tables::colors::ColorValue;
use crate::file::tables::media::IorValue;
use crate::file::tables::values::At;
use crate::{Coat, Lobe, Material, Pane, Tint, Transmittance};

/// The width of a pane's highlight where nothing else is said: that of polished glass, hardly to be seen.
const POLISHED: f64 = 0.01;

/// What is left of light counts at least as much as this, so that its logarithm is finite.
const LEAST_LEFT: f64 = 1e-6;

impl CoatTable {
    /// The material under the coat.
    pub(crate) fn build(
        &self,
        material: Material,
        builder: &mut Builder,
        span: &Range<usize>,
    ) -> Result<Material, Problem> {
        let default = Coat::default();
        let coat = Coat {
            ior: clear(self.ior.as_ref(), builder)?.unwrap_or(default.ior),
            alpha: self.alpha.as_ref().map_or(default.alpha, |alpha| alpha.0),
            weight: self.weight.as_ref().map_or(default.weight, |weight| weight.0),
            thickness_mm: self.thickness_mm.as_ref().map_or(default.thickness_mm, |mm| mm.0),
            absorption_per_mm: absorption(self.transmittance_1mm.as_ref(), builder)?,
        };
        let place = self.alpha.as_ref().map_or(span, |alpha| &alpha.span);
        material.under_coat(&coat).map_err(|error| Problem::at(place, error.to_string()))
    }
}

impl PaneTable {
    /// Makes the material a pane, beside the terms that it has.
    pub(crate) fn build(
        &self,
        material: &mut Material,
        builder: &mut Builder,
        span: &Range<usize>,
    ) -> Result<(), Problem> {
        let per_mm = absorption(self.transmittance_1mm.as_ref(), builder)?.unwrap_or(Spectrum::ZERO);
        let pane = Arc::new(Pane {
            ior: clear(self.ior.as_ref(), builder)?.unwrap_or(Ior::constant(1.5)),
            thickness: self.thickness_mm.as_ref().map_or(4.0, |mm| mm.0) * 1e-3,
            absorption: per_mm * 1e3,
        });
        let alpha = self.alpha.as_ref().map_or(POLISHED, |alpha| alpha.0);
        let place = self.alpha.as_ref().map_or(span, |alpha| &alpha.span);
        let shape = Shape::named("ggx", &[("alpha", alpha)])
            .map_err(|error| Problem::at(place, error.to_string()))?;
        material.lobes.push(Lobe::new(shape, Tint::Pane(Arc::clone(&pane))));
        material.transmittance = Some(Transmittance::Pane(pane));
        Ok(())
    }
}

/// The transmittance of a surface: a colour, or what a boundary (`ior`) or a film in air
/// (`film_nm`) does not reflect.
pub(in crate::file::build) fn transmittance(
    value: &At<ColorValue>,
    builder: &mut Builder,
) -> Result<Transmittance, Problem> {
    let opaque =
        |name: &str| Problem::at(&value.span, format!("light does not pass '{name}', which is a metal"));
    Ok(match builder.tint(value)? {
        Tint::Ior(ior) if ior.k.max() > 0.0 => return Err(opaque(&ior.name)),
        Tint::Film(film) if film.base.k.max() > 0.0 => return Err(opaque(&film.base.name)),
        Tint::Ior(ior) => Transmittance::Boundary(ior),
        Tint::Film(film) => Transmittance::Film(film),
        Tint::Pane(pane) => Transmittance::Pane(pane),
        Tint::Polarized(..) => {
            return Err(Problem::at(&value.span, "'polarization' is for what a surface reflects"));
        }
        Tint::Reradiation(_) => {
            return Err(Problem::at(&value.span, "a transmittance cannot re-radiate")
                .help("give a colour, a reflectance, an 'ior' or a 'film_nm'"));
        }
        tint => {
            let most = match &tint {
                Tint::Rgb(rgb) => rgb.0.iter().fold(0.0, |most: f64, c| most.max(f64::from(*c))),
                Tint::Spectrum(spectrum) => spectrum.max(),
                _ => 0.0,
            };
            if most > 1.0 {
                let message = format!("expected a transmittance of at most 1, found {most}");
                return Err(Problem::at(&value.span, message));
            }
            Transmittance::Constant(tint)
        }
    })
}

/// A medium that does not absorb.
fn clear(value: Option<&At<IorValue>>, builder: &mut Builder) -> Result<Option<Ior>, Problem> {
    let Some(value) = value else { return Ok(None) };
    let ior = builder.medium(value)?;
    match ior.k.max() > 0.0 {
        true => {
            Err(Problem::at(&value.span, format!("light does not pass '{}', which is a metal", ior.name)))
        }
        false => Ok(Some(ior)),
    }
}

/// Absorption per mm from what is left after 1 mm.
fn absorption(value: Option<&At<ColorValue>>, builder: &mut Builder) -> Result<Option<Spectrum>, Problem> {
    let Some(value) = value else { return Ok(None) };
    let left = match builder.tint(value)? {
        Tint::Rgb(rgb) => rgb_spectra::spectrum_of_reflectance(rgb),
        Tint::Spectrum(spectrum) => *spectrum,
        _ => {
            return Err(Problem::at(&value.span, "expected a transmittance: a colour or a spectrum"));
        }
    };
    if left.max() > 1.0 {
        return Err(Problem::at(&value.span, format!("more than all light, {:.3}, would pass", left.max())));
    }
    Ok(Some(left.map(|left| -libm::log(left.max(LEAST_LEFT)))))
}
