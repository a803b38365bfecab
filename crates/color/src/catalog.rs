//! Spectra by name, of whatever kind: lights, measured reflectances, and metals and glasses by their reflectance.

use crate::lights::{fine_light, light, lights};
use crate::names::{UnknownName, plain};
use crate::spectra::{FineSpectrum, Outside, Spectrum};
use crate::surfaces::ior::{IorKind, ior, iors};
use crate::surfaces::reflectances::{fine_reflectance, reflectance, reflectances};

/// What a spectrum is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpectrumKind {
    /// Power by wavelength.
    Light,
    /// Reflectance or transmittance by wavelength.
    Surface,
}

/// A spectrum that comes with the library.
#[derive(Clone, Debug, PartialEq)]
pub struct CatalogSpectrum {
    /// What it is, in a few words.
    pub title: String,
    /// What it is of.
    pub kind: SpectrumKind,
    /// The values on the grid, as they are drawn.
    pub spectrum: Spectrum,
    /// The values by 1 nm, for numbers.
    pub fine: FineSpectrum,
}

/// The spectrum of that name: a light, a measured reflectance, or the reflectance of a metal or glass in air at
/// normal incidence.
///
/// ```
/// use glanz_color::{SpectrumKind, catalog_spectrum};
///
/// assert_eq!(catalog_spectrum("D65")?.kind, SpectrumKind::Light);
/// let gold = catalog_spectrum("gold")?;
/// assert!(gold.kind == SpectrumKind::Surface && gold.spectrum.at(650.0) > 0.9);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
///
/// # Errors
/// [`UnknownName`], with the nearest names of all kinds.
pub fn catalog_spectrum(name: &str) -> Result<CatalogSpectrum, UnknownName> {
    let is = |known: &str| plain(known) == plain(name);
    match light(name) {
        Ok(spectrum) => {
            let title = lights().iter().find(|info| is(info.name)).map_or("light", |info| info.title);
            let (title, fine) = (title.to_owned(), fine_light(name)?);
            return Ok(CatalogSpectrum { title, kind: SpectrumKind::Light, spectrum, fine });
        }
        Err(error @ UnknownName::Parameter { .. }) => return Err(error),
        Err(UnknownName::NotFound { .. }) => {}
    }
    let kind = SpectrumKind::Surface;
    if let Ok(spectrum) = reflectance(name) {
        let title = reflectances().iter().find(|info| is(info.name)).map_or("", |info| info.title);
        return Ok(CatalogSpectrum {
            title: title.to_owned(),
            kind,
            spectrum,
            fine: fine_reflectance(name)?,
        });
    }
    let Ok(found) = ior(name) else {
        return Err(UnknownName::not_found("spectrum", name, names()));
    };
    let info = iors().iter().find(|info| info.name == found.name);
    let what = match info.map(|info| info.kind) {
        Some(IorKind::Dielectric) => "one face",
        _ => "polished metal",
    };
    let title = info.map_or("", |info| info.title);
    let title = format!("{title}, reflectance of {what} in air at normal incidence");
    let spectrum = found.normal_reflectance();
    let fine = FineSpectrum::from_drawn(&spectrum, Outside::Hold);
    Ok(CatalogSpectrum { title, kind, spectrum, fine })
}

/// All names that [`catalog_spectrum`] knows.
fn names() -> impl Iterator<Item = &'static str> {
    let iors = iors().iter().flat_map(|info| [info.name, info.title]);
    let reflectances = reflectances().iter().map(|info| info.name);
    lights().iter().map(|info| info.name).chain(reflectances).chain(iors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metals_go_by_either_name() {
        assert_eq!(catalog_spectrum("gold").unwrap(), catalog_spectrum("Au").unwrap());
    }

    #[test]
    fn names_of_all_kinds_are_suggested() {
        let error = catalog_spectrum("coper").unwrap_err();
        assert_eq!(error.to_string(), "there is no spectrum 'coper'; did you mean 'copper'?");
    }
}
