//! A fluorescent dye or pigment over a base, from the numbers that chemists tell of it.

use thiserror::Error;

use crate::spectra::{SAMPLES, Spectrum, lambda_nm};
use crate::surfaces::reradiation::Reradiation;

/// The base must reflect from 0 to 1, up to the rounding of tables.
const BASE_LIMIT: f64 = 1.0 + 1e-9;

/// A fluorescent substance in or on a base.
///
/// **Formula.** Of the light that the base would reflect, the substance absorbs the fraction
/// a(λ) = `absorptance` · g(λ). What is left is the diagonal, ρ(λ) (1 − a(λ)). Of the absorbed photons
/// the fraction `quantum_yield` is emitted with the spectrum of the emission band, whatever excited it
/// (Kasha's rule, 1950):
/// M\[out\]\[in\] = ρ(in) a(in) Q λ_in e(out) / Σ e(λ) λ, for out > in only. What the band would emit at
/// wavelengths up to the exciting one is lost as heat (Stokes). Both bands are Gaussians over wavenumber,
/// to which the bands of dyes come close; over wavelength they lean to the red.
///
/// **Laws.** Emits at longer wavelengths only; gives back at most as many photons as the base reflects,
/// so the check of energy passes for every parameter in range.
/// **Limits.** One band each; no concentration quenching, no re-absorption of emitted light, and all of
/// it leaves the material: `quantum_yield` is that of the whole layer.
/// **Cost.** Some ten thousand operations, once.
///
/// ```
/// use glanz_color::{Fluorophore, Spectrum, light};
///
/// // A dye that turns half of the light around 450 nm to around 520 nm.
/// let dye = Fluorophore {
///     absorption_nm: 450.0,
///     absorption_fwhm_nm: 50.0,
///     absorptance: 0.8,
///     emission_nm: 520.0,
///     emission_fwhm_nm: 50.0,
///     quantum_yield: 0.6,
/// };
/// let paper = dye.over(&Spectrum::constant(0.9))?;
/// assert!(paper.energy().ok);
/// let under_blue = paper.apply(&light("line(450)")?);
/// assert!(under_blue.at(520.0) > 0.0 && under_blue.at(400.0) == 0.0, "only to longer wavelengths");
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluorophore {
    /// The wavelength of strongest absorption, in nm: 250 to 780.
    pub absorption_nm: f64,
    /// The full width of absorption at half its maximum, in nm: 10 to 300.
    pub absorption_fwhm_nm: f64,
    /// The fraction that is absorbed at the strongest wavelength, of the light that the base would reflect:
    /// 0 to 1.
    pub absorptance: f64,
    /// The wavelength of strongest emission, in nm: 300 to 780, and at least `absorption_nm`.
    pub emission_nm: f64,
    /// The full width of emission at half its maximum, in nm: 10 to 300.
    pub emission_fwhm_nm: f64,
    /// Photons emitted for each absorbed: 0 to 1.
    pub quantum_yield: f64,
}

/// A parameter of a [`Fluorophore`] and its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FluorophoreParameter {
    /// The field's name.
    pub name: &'static str,
    /// The unit; empty for a pure number.
    pub unit: &'static str,
    /// The least value.
    pub min: f64,
    /// The greatest value.
    pub max: f64,
}

/// Why there is no such fluorophore.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FluorophoreError {
    /// A parameter is out of its range.
    #[error("expected {name} from {min} to {max}{unit}, found {found}", name = parameter.name,
        min = parameter.min, max = parameter.max, unit = spaced(parameter.unit))]
    Range {
        /// Which one.
        parameter: FluorophoreParameter,
        /// Its value.
        found: f64,
    },
    /// The emission is strongest at a shorter wavelength than the absorption.
    #[error("expected emission_nm at or above absorption_nm = {absorption_nm} (Stokes), found {emission_nm}")]
    Stokes {
        /// The wavelength of strongest absorption, in nm.
        absorption_nm: f64,
        /// The wavelength of strongest emission, in nm.
        emission_nm: f64,
    },
    /// The base reflects less than nothing or more than all.
    #[error("expected a base that reflects 0 to 1, found {found} at {nm} nm")]
    Base {
        /// The wavelength, in nm.
        nm: f64,
        /// The reflectance.
        found: f64,
    },
}

impl Fluorophore {
    /// All parameters with their ranges, in the order of the fields.
    pub const PARAMETERS: [FluorophoreParameter; 6] = [
        FluorophoreParameter { name: "absorption_nm", unit: "nm", min: 250.0, max: 780.0 },
        FluorophoreParameter { name: "absorption_fwhm_nm", unit: "nm", min: 10.0, max: 300.0 },
        FluorophoreParameter { name: "absorptance", unit: "", min: 0.0, max: 1.0 },
        FluorophoreParameter { name: "emission_nm", unit: "nm", min: 300.0, max: 780.0 },
        FluorophoreParameter { name: "emission_fwhm_nm", unit: "nm", min: 10.0, max: 300.0 },
        FluorophoreParameter { name: "quantum_yield", unit: "", min: 0.0, max: 1.0 },
    ];

    /// The re-radiation of the substance over a base of this reflectance.
    pub fn over(&self, base: &Spectrum) -> Result<Reradiation, FluorophoreError> {
        self.check()?;
        if let Some((nm, found)) = base.points().find(|(_, value)| !(0.0..=BASE_LIMIT).contains(value)) {
            return Err(FluorophoreError::Base { nm, found });
        }
        let absorbed = self.absorption() * *base;
        let emission = self.emission_per_photon();
        Ok(Reradiation::from_fn(|out, input| match out.cmp(&input) {
            core::cmp::Ordering::Less => 0.0,
            core::cmp::Ordering::Equal => base[input] - absorbed[input],
            core::cmp::Ordering::Greater => absorbed[input] * lambda_nm(input) * emission[out],
        }))
    }

    /// The fraction that is absorbed at each wavelength.
    pub fn absorption(&self) -> Spectrum {
        let (peak, width) = (self.absorption_nm, self.absorption_fwhm_nm);
        Spectrum::from_fn(|nm| self.absorptance * band(nm, peak, width))
    }

    /// Energy that leaves in each band for one photon that comes in, its energy being 1 / λ.
    fn emission_per_photon(&self) -> [f64; SAMPLES] {
        let shape = Spectrum::from_fn(|nm| band(nm, self.emission_nm, self.emission_fwhm_nm));
        let photons: f64 = shape.points().map(|(nm, energy)| energy * nm).sum();
        shape.0.map(|energy| self.quantum_yield * energy / photons)
    }

    fn check(&self) -> Result<(), FluorophoreError> {
        let values = [
            self.absorption_nm,
            self.absorption_fwhm_nm,
            self.absorptance,
            self.emission_nm,
            self.emission_fwhm_nm,
            self.quantum_yield,
        ];
        for (parameter, found) in Self::PARAMETERS.into_iter().zip(values) {
            if !(parameter.min..=parameter.max).contains(&found) {
                return Err(FluorophoreError::Range { parameter, found });
            }
        }
        if self.emission_nm < self.absorption_nm {
            let (absorption_nm, emission_nm) = (self.absorption_nm, self.emission_nm);
            return Err(FluorophoreError::Stokes { absorption_nm, emission_nm });
        }
        Ok(())
    }
}

/// A Gaussian over wavenumber, 1 at its peak, whose half maxima are `fwhm` apart in nm.
pub(super) fn band(nm: f64, peak: f64, fwhm: f64) -> f64 {
    // With half maxima at the wavenumbers 1/peak ± d: 1/(1/peak − d) − 1/(1/peak + d) = fwhm.
    let half = ((1.0 + (fwhm / peak) * (fwhm / peak)).sqrt() - 1.0) / fwhm;
    let x = (1.0 / nm - 1.0 / peak) / half;
    libm::exp2(-x * x)
}

/// The unit after a number.
fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const DYE: Fluorophore = Fluorophore {
        absorption_nm: 450.0,
        absorption_fwhm_nm: 60.0,
        absorptance: 0.8,
        emission_nm: 520.0,
        emission_fwhm_nm: 50.0,
        quantum_yield: 0.9,
    };

    #[test]
    fn half_of_the_maximum_is_reached_at_two_wavelengths_one_width_apart() {
        let value = |nm: f64| band(nm, 450.0, 60.0);
        assert_eq!(value(450.0), 1.0);
        // Half maxima by bisection on both sides.
        let cross = |mut inside: f64, mut outside: f64| {
            for _ in 0..60 {
                let middle = 0.5 * (inside + outside);
                if value(middle) > 0.5 { inside = middle } else { outside = middle }
            }
            inside
        };
        let (left, right) = (cross(450.0, 300.0), cross(450.0, 700.0));
        assert!((right - left - 60.0).abs() < 1e-9, "{left} {right}");
        assert!(right - 450.0 > 450.0 - left);
    }

    #[test]
    fn photons_of_far_excitation_come_back_by_the_quantum_yield() {
        let base = Spectrum::constant(0.7);
        let matrix = DYE.over(&base).unwrap();
        // 400 nm lies far below the emission: nothing of it is cut.
        let input = 20;
        let photons: f64 =
            (input + 1..SAMPLES).map(|out| matrix.get(out, input) * lambda_nm(out) / lambda_nm(input)).sum();
        let expected = 0.7 * DYE.absorption()[input] * DYE.quantum_yield;
        assert!((photons / expected - 1.0).abs() < 1e-6, "{photons} {expected}");
        assert!((matrix.get(input, input) - 0.7 * (1.0 - DYE.absorption()[input])).abs() < 1e-15);
    }

    #[test]
    fn wrong_parameters_are_named() {
        let message = |dye: Fluorophore| dye.over(&Spectrum::ONE).unwrap_err().to_string();
        let text = message(Fluorophore { emission_nm: 440.0, ..DYE });
        assert_eq!(text, "expected emission_nm at or above absorption_nm = 450 (Stokes), found 440");
        let text = message(Fluorophore { quantum_yield: 1.2, ..DYE });
        assert_eq!(text, "expected quantum_yield from 0 to 1, found 1.2");
        let text = message(Fluorophore { absorption_fwhm_nm: f64::NAN, ..DYE });
        assert_eq!(text, "expected absorption_fwhm_nm from 10 to 300 nm, found NaN");
        let text = DYE.over(&Spectrum::constant(1.5)).unwrap_err().to_string();
        assert_eq!(text, "expected a base that reflects 0 to 1, found 1.5 at 300 nm");
    }

    proptest! {
        #[test]
        fn no_parameters_in_range_make_light_from_nothing(
            unit in proptest::array::uniform6(0.0..=1.0f64), base in 0.0..=1.0f64,
        ) {
            let value = |i: usize| {
                let FluorophoreParameter { min, max, .. } = Fluorophore::PARAMETERS[i];
                min + (max - min) * unit[i]
            };
            let dye = Fluorophore {
                absorption_nm: value(0),
                absorption_fwhm_nm: value(1),
                absorptance: value(2),
                emission_nm: value(3).max(value(0)),
                emission_fwhm_nm: value(4),
                quantum_yield: value(5),
            };
            let report = dye.over(&Spectrum::constant(base)).unwrap().energy();
            prop_assert!(report.ok, "{report:?}");
            prop_assert!(report.max_photon_sum <= base + 1e-12, "{report:?}");
            prop_assert_eq!(report.up_conversion, 0.0);
        }
    }
}
