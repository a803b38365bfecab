//! Refractive indices by name: metals from measured tables, transparent media from dispersion formulas.

mod dispersion;
mod media;
mod metals;

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use crate::names::{UnknownName, plain};
use crate::spectra::Spectrum;

pub use dispersion::Dispersion;

/// A complex refractive index η + i k over the grid; k > 0 absorbs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ior {
    /// The name, such as `Au` or `BK7`.
    pub name: String,
    /// The real part.
    pub eta: Spectrum,
    /// The extinction coefficient; 0 for transparent media.
    pub k: Spectrum,
    /// Where the numbers come from.
    pub source: String,
}

/// What a refractive index is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IorKind {
    /// Opaque: η and k from measurements, on the grid as [`Spectrum::from_table`] brings them there.
    Metal,
    /// Transparent: η from a formula, k = 0. Outside of its range the formula is continued; the
    /// absorption that real media have there is left out.
    Dielectric,
}

/// What is known about a refractive index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IorInfo {
    /// The name as [`ior`] knows it.
    pub name: &'static str,
    /// Another name that [`ior`] knows.
    pub title: &'static str,
    /// What it is of.
    pub kind: IorKind,
    /// The publication.
    pub source: &'static str,
    /// The wavelengths in nm for which it holds.
    pub range_nm: (f64, f64),
}

/// The refractive index of that name, or of that title; [`iors`] lists both.
///
/// ```
/// use glanz_color::ior;
///
/// // BK7 at the yellow line d of helium, 587.6 nm.
/// let glass = ior("BK7")?;
/// assert!((glass.eta.at(587.6) - 1.5168).abs() < 1e-4);
/// // Gold reflects red and swallows blue.
/// let gold = ior("gold")?.normal_reflectance();
/// assert!(gold.at(650.0) > 0.9 && gold.at(450.0) < 0.45);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn ior(name: &str) -> Result<Ior, UnknownName> {
    let wanted = plain(name);
    let is_it = |info: &&IorInfo| plain(info.name) == wanted || plain(info.title) == wanted;
    let info = iors().iter().find(is_it).ok_or_else(|| {
        let known = iors().iter().flat_map(|info| [info.name, info.title]);
        UnknownName::not_found("refractive index", name.trim(), known)
    })?;
    let (eta, k) = match info.kind {
        IorKind::Metal => metals::spectra(info.name),
        IorKind::Dielectric => (media::formula(info.name).spectrum(), Spectrum::ZERO),
    };
    Ok(Ior { name: info.name.to_owned(), eta, k, source: info.source.to_owned() })
}

/// All refractive indices by name: metals, then transparent media.
pub fn iors() -> &'static [IorInfo] {
    static LIST: LazyLock<Vec<IorInfo>> = LazyLock::new(|| metals::infos().chain(media::infos()).collect());
    &LIST
}

impl Ior {
    /// A medium of one index at all wavelengths, which does not absorb.
    pub fn constant(eta: f64) -> Self {
        Self {
            name: format!("{eta}"),
            eta: Spectrum::constant(eta),
            k: Spectrum::ZERO,
            source: "given as a number".to_owned(),
        }
    }

    /// The reflectance in air at normal incidence: ((η − 1)² + k²) / ((η + 1)² + k²).
    pub fn normal_reflectance(&self) -> Spectrum {
        Spectrum(core::array::from_fn(|i| {
            let (eta, k2) = (self.eta[i], self.k[i] * self.k[i]);
            ((eta - 1.0) * (eta - 1.0) + k2) / ((eta + 1.0) * (eta + 1.0) + k2)
        }))
    }
}

#[cfg(test)]
mod tests;
