//! Media at one wavelength: dielectrics and metals.

use glanz_bsdf::terms::{fresnel_conductor, fresnel_dielectric, fresnel_polarized};
use glanz_color::{Ior, ior};

use crate::{Error, number};

/// The refractive indices that are possible.
const INDICES: std::ops::RangeInclusive<f64> = 0.05..=20.0;

/// A medium at one wavelength.
#[derive(Clone, Debug, PartialEq)]
pub struct Medium {
    /// Its name.
    pub name: String,
    /// The real part of its refractive index.
    pub eta: f64,
    /// The extinction coefficient; 0 for transparent media.
    pub k: f64,
}

impl Medium {
    /// The medium of that name, such as `Au`, or of the refractive index that the word is (also as n + k i: `1.5+3i`), at a
    /// wavelength in nm.
    ///
    /// # Errors
    /// [`Error::UnknownMedium`], and [`Error::RefractiveIndex`] for a number that no medium has.
    pub fn named(word: &str, nm: f64) -> Result<Self, Error> {
        if let Ok(eta) = word.trim().parse::<f64>() {
            if !INDICES.contains(&eta) {
                let (least, most) = (*INDICES.start(), *INDICES.end());
                return Err(Error::RefractiveIndex { index: word.to_owned(), least, most });
            }
            return Ok(Self { name: format!("n = {}", number(eta)), eta, k: 0.0 });
        }
        Ok(Self::of(&ior(word)?, nm))
    }

    /// A medium at a wavelength in nm.
    pub fn of(ior: &Ior, nm: f64) -> Self {
        Self { name: ior.name.clone(), eta: ior.eta.at(nm), k: ior.k.at(nm) }
    }

    /// The reflectance of a smooth boundary to it from air, for unpolarised light at this cosine from the normal.
    pub fn reflectance(&self, cosine: f64) -> f64 {
        match self.k > 0.0 {
            true => fresnel_conductor(cosine, self.eta, self.k),
            false => fresnel_dielectric(cosine, self.eta),
        }
    }

    /// The same for light polarised perpendicular (s) and parallel (p) to the plane of incidence.
    pub fn polarized(&self, cosine: f64) -> (f64, f64) {
        fresnel_polarized(cosine, self.eta, self.k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn media_go_by_name_or_number() {
        assert!((Medium::named("1.5", 550.0).unwrap().reflectance(1.0) - 0.04).abs() < 1e-15);
        let gold = Medium::named("Au", 650.0).unwrap();
        assert!(gold.k > 1.0 && gold.reflectance(1.0) > 0.9);
        assert_eq!(Medium::named("BK7", 300.0).unwrap().k, 0.0);
        for wrong in ["unobtainium", "0", "-1", "1e9", "nan", ""] {
            assert!(Medium::named(wrong, 550.0).is_err(), "{wrong}");
        }
    }

    #[test]
    fn unpolarised_light_is_the_mean_of_both_polarisations() {
        for word in ["1.5", "0.7", "Au", "Cu", "4"] {
            let medium = Medium::named(word, 600.0).unwrap();
            for degrees in [0.0_f64, 20.0, 45.0, 56.3099, 80.0, 89.0] {
                let cosine = degrees.to_radians().cos();
                let (s, p) = medium.polarized(cosine);
                let mean = medium.reflectance(cosine);
                assert!((0.5 * (s + p) - mean).abs() < 1e-9, "{word} at {degrees}°: {s} {p} {mean}");
            }
        }
        // Brewster's angle: nothing of p comes back.
        let glass = Medium::named("1.5", 600.0).unwrap();
        assert!(glass.polarized(libm::cos(libm::atan(1.5))).1 < 1e-12);
    }
}
