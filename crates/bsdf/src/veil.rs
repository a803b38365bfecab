//! What lies over a lobe: factors that dim it by the angles alone.
//!
//! A clear coat takes away what it reflects before the light gets to what is below; a dielectric does so
//! with the light that it scatters inside. None of these knows a wavelength, so they belong to the shape.

use glanz_math::{GaussLegendre, Real};

use crate::albedo::directional;
use crate::models::charlie;
use crate::terms::fresnel_dielectric;
use crate::{Pair, Series, Shape};

/// The angle whose cosine a factor takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angle {
    /// Between viewer and half vector.
    Half,
    /// Between viewer and the half vector to the light mirrored at the surface: for light that passes a thin sheet.
    HalfThrough,
    /// Between viewer and normal.
    View,
}

impl Angle {
    /// Its cosine, 0 … 1.
    #[inline(always)]
    fn cosine<R: Real>(self, pair: &Pair<R>) -> R {
        match self {
            Self::Half => pair.cos_view_half(),
            Self::HalfThrough => {
                let height = pair.cos_o * pair.cos_i;
                Pair { cos_io: pair.cos_io - height - height, ..*pair }.cos_view_half()
            }
            Self::View => pair.cos_o.abs(),
        }
    }
}

/// A factor of a lobe.
#[derive(Clone, Debug, PartialEq)]
pub enum Veil {
    /// The same for all directions.
    Share(f64),
    /// `at_zero + (at_grazing − at_zero)(1 − cosθ)⁵`: Fresnel's law in the form of C. Schlick 1994, or what it
    /// leaves over.
    Schlick {
        /// Which cosine.
        angle: Angle,
        /// The factor where the cosine is 1.
        at_zero: f64,
        /// The factor where the cosine is 0.
        at_grazing: f64,
    },
    /// Any function of one cosine.
    Curve {
        /// Which cosine.
        angle: Angle,
        /// The factor over it.
        factor: Series,
    },
    /// A smooth clear layer that light crosses on its way in and out: (1 − F(θo))(1 − F(θi)) · `gain`.
    Coat {
        /// Its index of refraction over that of the air.
        eta: f64,
        /// What light that the layer throws back to the base adds; see [`Veil::over_matte`].
        gain: f64,
    },
    /// What a sheen layer leaves to the layers below (KHR_materials_sheen): 1 − strength · the greater of
    /// the sheen's albedos towards viewer and light.
    Sheen {
        /// The greatest channel of the sheen's colour.
        strength: f64,
        /// The albedo of the sheen lobe.
        albedo: charlie::Albedo,
    },
}

impl Veil {
    /// A coat over a lobe that mirrors: what the coat throws back to it is lost.
    pub fn over_glossy(eta: f64) -> Self {
        Self::Coat { eta, gain: 1.0 }
    }

    /// A coat over a matte base. Light that comes back from the base is partly reflected at the coat from
    /// inside and gets a further chance; a base of reflectance 1 in the end gives everything back, and one of
    /// reflectance ρ the share [`matte_under_coat`]. Source: J. L. Saunderson, "Calculation of the
    /// color of pigmented plastics", JOSA 32, 1942; the angular part as in L. B. Wolff, "Diffuse-reflectance
    /// model for smooth dielectric surfaces", JOSA A 11, 1994.
    pub fn over_matte(eta: f64) -> Self {
        Self::Coat { eta, gain: 1.0 / (1.0 - diffuse_fresnel(eta)) }
    }

    /// The factor.
    #[inline(always)]
    pub fn factor<R: Real>(&self, pair: &Pair<R>) -> R {
        let one = pair.cos_o.one();
        match self {
            Self::Share(share) => one.lit(*share),
            Self::Schlick { angle, at_zero, at_grazing } => {
                let rest = (one - angle.cosine(pair)).clamp(0.0, 1.0);
                one.lit(*at_zero) + one.lit(at_grazing - at_zero) * (rest.sqr().sqr() * rest)
            }
            Self::Curve { angle, factor } => factor.at(angle.cosine(pair).min(one)),
            Self::Coat { eta, gain } => {
                let through = |cosine: R| one - fresnel_dielectric(cosine.abs().min(one), one.lit(*eta));
                through(pair.cos_o) * through(pair.cos_i) * one.lit(*gain)
            }
            Self::Sheen { strength, albedo } => {
                let taken = albedo.at(pair.cos_o.abs()).max(albedo.at(pair.cos_i.abs()));
                (one - taken * one.lit(*strength)).max(one.zero())
            }
        }
    }
}

/// What a boundary reflects of light from everywhere, coming from the side of index 1:
/// 2 ∫ F(μ, eta) μ dμ. From inside it is 1 − (1 − this)/eta².
pub fn diffuse_fresnel(eta: f64) -> f64 {
    let rule = GaussLegendre::new(64);
    // In the square root of the cosine, Fresnel's steep rise towards grazing light is gentle.
    2.0 * rule.integrate(0.0, 1.0, |u| fresnel_dielectric(u * u, eta) * u * u * 2.0 * u)
}

/// The share that a matte base of reflectance `rho` gives back under a coat of index `eta`, of what one of
/// reflectance 1 does: ρ(1 − K) / (1 − K ρ), K being what the coat reflects of diffuse light from inside.
pub fn matte_under_coat(rho: f64, eta: f64) -> f64 {
    let inside = 1.0 - (1.0 - diffuse_fresnel(eta)) / (eta * eta);
    rho * (1.0 - inside) / (1.0 - inside * rho)
}

/// The directional albedo of a shape under veils.
pub fn veiled_albedo(shape: &Shape, veils: &[Veil], cos_o: f64) -> f64 {
    let veil = |pair: &Pair<f64>| veils.iter().map(|veil| veil.factor(pair)).product::<f64>();
    directional(shape.info(), shape.eta(), (cos_o, 0.0), |pair| shape.f_cos(pair) * veil(pair))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn diffuse_light_is_reflected_by_9_percent_from_outside_and_60_from_inside() {
        // G. Kortüm, Reflectance Spectroscopy, 1969, and many others: 0.092 and 0.596 for 1.5.
        let outside = diffuse_fresnel(1.5);
        assert!((outside - 0.0918).abs() < 1e-4, "{outside}");
        assert!((1.0 - (1.0 - outside) / 2.25 - 0.5964).abs() < 1e-4);
    }

    #[test]
    fn a_white_matte_base_under_a_coat_gives_everything_back_that_enters() {
        for eta in [1.0001, 1.3, 1.5, 2.4] {
            let veil = Veil::over_matte(eta);
            for degrees in [0.0_f64, 45.0, 80.0] {
                let cosine = libm::cos(degrees.to_radians());
                let base = Shape::named("lambert", &[]).expect("lambert exists");
                let got = veiled_albedo(&base, core::slice::from_ref(&veil), cosine);
                let entered = 1.0 - fresnel_dielectric(cosine, eta);
                assert!((got - entered).abs() < 1e-4, "{eta}, {degrees}°: {got} for {entered}");
            }
        }
    }

    #[test]
    fn a_grey_base_is_darker_under_a_coat_and_black_and_white_stay() {
        assert_eq!(matte_under_coat(0.0, 1.5), 0.0);
        assert!((matte_under_coat(1.0, 1.5) - 1.0).abs() < 1e-12);
        let grey = matte_under_coat(0.5, 1.5);
        assert!((grey - 0.5 * 0.4036 / (1.0 - 0.5964 * 0.5)).abs() < 1e-4, "{grey}");
    }

    #[test]
    fn a_coat_without_a_boundary_is_none() {
        let veil = Veil::over_matte(1.0);
        let pair = Pair::isotropic(0.3, 0.6, 0.5);
        assert!((veil.factor(&pair) - 1.0_f64).abs() < 1e-12);
    }

    #[test]
    fn schlick_runs_from_one_value_to_the_other() {
        let veil = Veil::Schlick { angle: Angle::View, at_zero: 0.04, at_grazing: 1.0 };
        assert_eq!(veil.factor(&Pair::isotropic(1.0, 0.5, 0.5)), 0.04_f64);
        assert_eq!(veil.factor(&Pair::isotropic(0.0, 0.5, 0.5)), 1.0_f64);
        assert!((veil.factor(&Pair::isotropic(0.5, 0.5, 0.5)) - 0.07_f64).abs() < 1e-12);
    }

    #[test]
    fn light_through_a_thin_sheet_has_the_angle_of_its_mirror_image() {
        let (above, below) =
            (Pair::isotropic(0.7, 0.4, 0.5), Pair::isotropic(0.7, -0.4, 0.5 - 2.0 * 0.7 * 0.4));
        let veil = |angle| Veil::Schlick { angle, at_zero: 0.9, at_grazing: 0.0 };
        let (expected, got): (f64, f64) =
            (veil(Angle::Half).factor(&above), veil(Angle::HalfThrough).factor(&below));
        assert!((got - expected).abs() < 1e-12, "{got} for {expected}");
    }

    #[test]
    fn a_curve_is_taken_at_its_cosine() {
        let veil = Veil::Curve { angle: Angle::View, factor: Series::through(4, |c| 1.0 - 0.5 * c) };
        assert!((veil.factor(&Pair::isotropic(0.6, 0.5, 0.5)) - 0.7_f64).abs() < 1e-12);
    }

    #[test]
    fn a_sheen_leaves_what_the_flatter_of_both_directions_does() {
        let albedo = charlie::Albedo::new(0.25);
        let veil = Veil::Sheen { strength: 0.5, albedo };
        for (cos_o, cos_i) in [(0.9, 0.1), (0.1, 0.9)] {
            let got: f64 = veil.factor(&Pair::isotropic(cos_o, cos_i, 0.5));
            assert!((got - (1.0 - 0.5 * albedo.at(0.1_f64))).abs() < 1e-12, "{got}");
        }
    }
}
