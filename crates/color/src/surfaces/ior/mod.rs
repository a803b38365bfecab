//! Refractive indices by name: metals from measured tables, transparent media from dispersion formulas.

mod dispersion;
mod media;
mod metals;

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use crate::names::{UnknownName, plain};
use crate::spectra::Spectrum;

pub use dispersion::Dispersion;

/// The source of a number.
const GIVEN: &str = "given as a number";

/// The greatest n and k of a complex number.
const MOST: f64 = 50.0;

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
/// A complex number is one of all wavelengths: `1.5+3i` is n = 1.5, k = 3, as `1.5-3i` is in the other convention.
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn ior(name: &str) -> Result<Ior, UnknownName> {
    if let Some((eta, k)) = complex(name) {
        let (eta, k) = (Spectrum::constant(eta), Spectrum::constant(k));
        return Ok(Ior { name: name.trim().to_owned(), eta, k, source: GIVEN.to_owned() });
    }
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

/// The real part and the extinction coefficient of a number such as `1.5+3i`, where n is above 0 and both at most 50.
fn complex(text: &str) -> Option<(f64, f64)> {
    let text = text.trim().strip_suffix(['i', 'j'])?;
    // The sign between both parts, not one of an exponent.
    let is_sign =
        |(at, c): &(usize, char)| *at > 0 && matches!(c, '+' | '-') && !text[..*at].ends_with(['e', 'E']);
    let (at, _) = text.char_indices().rfind(is_sign)?;
    let eta: f64 = text[..at].trim().parse().ok()?;
    let k: f64 = text[at + 1..].trim().parse().ok()?;
    (eta > 0.0 && eta <= MOST && (0.0..=MOST).contains(&k)).then_some((eta, k))
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
            source: GIVEN.to_owned(),
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
