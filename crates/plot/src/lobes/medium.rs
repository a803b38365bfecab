//! What a lobe is multiplied with: Fresnel reflectance of a medium, or a share of one wavelength.

use clap::Args;
use glanz_bsdf::terms::{fresnel_conductor, fresnel_dielectric, fresnel_polarized};
use glanz_bsdf::{DirectionPair, Shape};
use glanz_color::{FIRST_NM, IorKind, LAST_NM, ior, iors};

use crate::failure::Failure;
use crate::print::number;
use crate::spectra;

/// The wavelength where none is given, in nm: near the greatest sensitivity of the eye.
const DEFAULT_NM: f64 = 550.0;
/// Indices that are numbers.
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
    /// What a smooth boundary to it reflects of unpolarised light.
    pub fn reflectance(&self, cosine: f64) -> f64 {
        match self.k > 0.0 {
            true => fresnel_conductor(cosine, self.eta, self.k),
            false => fresnel_dielectric(cosine, self.eta),
        }
    }
}

impl Medium {
    /// The same of light that is polarised across (s) and in (p) the plane of incidence.
    pub fn polarised(&self, cosine: f64) -> (f64, f64) {
        fresnel_polarized(cosine, self.eta, self.k)
    }
}

/// The medium of that name, or of that refractive index, at a wavelength.
pub fn medium(word: &str, nm: f64) -> Result<Medium, Failure> {
    if let Ok(eta) = word.trim().parse::<f64>() {
        if !INDICES.contains(&eta) {
            let (least, most) = (INDICES.start(), INDICES.end());
            return Err(Failure::Usage(format!(
                "a refractive index is {word}, but must be between {least} and {most}"
            )));
        }
        return Ok(Medium { name: format!("n = {}", number(eta)), eta, k: 0.0 });
    }
    let found = ior(word).map_err(|error| Failure::Usage(error.to_string()))?;
    // Outside of its range a dielectric's formula is continued, and k is none.
    let metal = iors().iter().any(|info| info.name == found.name && info.kind == IorKind::Metal);
    let k = if metal { found.k.at(nm) } else { 0.0 };
    Ok(Medium { name: found.name.clone(), eta: found.eta.at(nm), k })
}

/// What lobes are multiplied with.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Tint")]
pub struct FactorArgs {
    /// Multiply with the Fresnel reflectance of a medium: a name from `glanz color list metals`, or a refractive
    /// index such as 1.5
    #[arg(long, value_name = "NAME")]
    pub ior: Option<String>,

    /// Multiply with a share of light: a number, or a spectrum's name or file, at --lambda-nm
    #[arg(long, value_name = "NAME", conflicts_with = "ior")]
    pub tint: Option<String>,

    /// The wavelength at which --ior and --tint are taken, in nm [default: 550]
    #[arg(long, value_name = "NM", value_parser = wavelength)]
    pub lambda_nm: Option<f64>,
}

/// A wavelength within the grid of spectra.
pub fn wavelength(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(nm) if (FIRST_NM..=LAST_NM).contains(&nm) => Ok(nm),
        Ok(nm) => Err(format!("{nm} nm is not between {FIRST_NM} and {LAST_NM}")),
        Err(_) => Err("expected a wavelength in nm, such as 550".to_owned()),
    }
}

/// What a lobe is multiplied with, found.
#[derive(Clone, Debug, PartialEq)]
pub enum Factor {
    /// Nothing.
    One,
    /// A share of all light.
    Share(String, f64),
    /// Fresnel reflectance.
    Fresnel(Medium),
}

impl FactorArgs {
    /// The wavelength, in nm.
    pub fn nm(&self) -> f64 {
        self.lambda_nm.unwrap_or(DEFAULT_NM)
    }

    /// The factor that is meant.
    pub fn factor(&self) -> Result<Factor, Failure> {
        match (&self.ior, &self.tint) {
            (Some(word), _) => Ok(Factor::Fresnel(medium(word, self.nm())?)),
            (None, Some(word)) => match word.trim().parse::<f64>() {
                Ok(share) if share.is_finite() && share >= 0.0 => Ok(Factor::Share(number(share), share)),
                Ok(share) => Err(Failure::Usage(format!("--tint is {share}, but must not be negative"))),
                Err(_) => {
                    let source = spectra::source(word, Some(spectra::Kind::Surface))?;
                    Ok(Factor::Share(source.name, source.spectrum.at(self.nm())))
                }
            },
            (None, None) if self.lambda_nm.is_some() => {
                Err(Failure::Usage("--lambda-nm changes nothing without --ior or --tint".to_owned()))
            }
            (None, None) => Ok(Factor::One),
        }
    }
}

impl Factor {
    /// BSDF times cosine times factor.
    pub fn f_cos(&self, shape: &Shape, pair: &DirectionPair<f64>) -> f64 {
        let value = shape.f_cos(pair);
        match self {
            Self::One => value,
            Self::Share(_, share) => value * share,
            Self::Fresnel(medium) => {
                let reflected = medium.reflectance(shape.tint_cosine(pair));
                let transmits = shape.info().side == glanz_bsdf::Side::Transmission;
                value * if transmits { 1.0 - reflected } else { reflected }
            }
        }
    }

    /// Its name; empty for none.
    pub fn name(&self) -> &str {
        match self {
            Self::One => "",
            Self::Share(name, _) => name,
            Self::Fresnel(medium) => &medium.name,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn media_go_by_name_or_number() {
        assert!((medium("1.5", 550.0).unwrap().reflectance(1.0) - 0.04).abs() < 1e-15);
        let gold = medium("Au", 650.0).unwrap();
        assert!(gold.k > 1.0 && gold.reflectance(1.0) > 0.9);
        assert_eq!(medium("BK7", 300.0).unwrap().k, 0.0);
        for wrong in ["unobtainium", "0", "-1", "1e9", "nan", ""] {
            assert!(medium(wrong, 550.0).is_err(), "{wrong}");
        }
    }

    #[test]
    fn unpolarised_light_is_the_mean_of_both_polarisations() {
        for word in ["1.5", "0.7", "Au", "Cu", "4"] {
            let medium = medium(word, 600.0).unwrap();
            for degrees in [0.0_f64, 20.0, 45.0, 56.3099, 80.0, 89.0] {
                let cosine = degrees.to_radians().cos();
                let (s, p) = medium.polarised(cosine);
                let mean = medium.reflectance(cosine);
                assert!((0.5 * (s + p) - mean).abs() < 1e-9, "{word} at {degrees}°: {s} {p} {mean}");
            }
        }
        // Brewster's angle: nothing of p comes back.
        let glass = medium("1.5", 600.0).unwrap();
        assert!(glass.polarised(libm::cos(libm::atan(1.5))).1 < 1e-12);
    }

    #[test]
    fn a_lobe_is_multiplied_with_the_reflectance_at_the_half_vector() {
        let shape = Shape::named("lambert", &[]).unwrap();
        let pair = DirectionPair::isotropic(0.5, 0.5, -0.5);
        let glass = Factor::Fresnel(medium("1.5", 550.0).unwrap());
        // wo·wi = −1/2 is 120° between both, 60° to the half vector.
        let expected = shape.f_cos(&pair) * 0.089_187;
        assert!((glass.f_cos(&shape, &pair) - expected).abs() < 1e-6);
    }
}
