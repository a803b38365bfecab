//! Angular weights of layers above a lobe: Schlick's approximation, the transmittance of a clear coat, sheen scaling.
//!
//! A clear coat attenuates the lobes below it by what it reflects, a dielectric interface its diffuse base. None of these
//! depends on the wavelength, so they belong to the shape. So does the table by which measured reflectance differs from the
//! model that was fitted to it.

use std::sync::Arc;

use glanz_math::{GaussLegendre, PI, Real, Vec3};
use serde::{Deserialize, Serialize};

use crate::albedo::directional;
use crate::models::charlie;
use crate::terms::{fresnel_dielectric, lambda_ggx};
use crate::{Chebyshev, DirectionPair, FactorTable, Shape};

/// The angle whose cosine a weight depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
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
    fn cosine<R: Real>(self, pair: &DirectionPair<R>) -> R {
        match self {
            Self::Half => pair.cos_view_half(),
            Self::HalfThrough => pair.mirrored().cos_view_half(),
            Self::View => pair.cos_o.abs(),
        }
    }
}

/// The weight of a lobe below a layer.
///
/// ```
/// use glanz_bsdf::{CoatSurface, LayerWeight, Shape, layered_albedo};
///
/// let lambert = Shape::named("lambert", &[])?;
/// let coat = CoatSurface::new(1.5, 0.001);
/// // Below a coat that reflects 4 % along the normal, a white base reflects the rest.
/// let albedo = layered_albedo(&lambert, &[LayerWeight::over_matte(&coat)], 1.0);
/// assert!((albedo - 0.96).abs() < 2e-3);
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LayerWeight {
    /// The same for all directions.
    Constant(f64),
    /// `at_zero + (at_grazing − at_zero)(1 − cosθ)⁵`: the approximation of Fresnel's law by C. Schlick 1994, or of
    /// the transmittance.
    Schlick {
        /// Which cosine.
        angle: Angle,
        /// The factor where the cosine is 1.
        at_zero: f64,
        /// The factor where the cosine is 0.
        at_grazing: f64,
    },
    /// Any function of one cosine.
    Series {
        /// Which cosine.
        angle: Angle,
        /// The factor over it.
        #[serde(with = "crate::serial::chebyshev")]
        factor: Chebyshev,
    },
    /// A clear layer that light crosses on its way in and out: (1 − E(θo))(1 − E(θi)) · `gain`, E being the albedo of
    /// the layer.
    Coat {
        /// 1 − E over the cosine.
        #[serde(with = "crate::serial::chebyshev")]
        transmittance: Chebyshev,
        /// The gain by internal reflection at the layer; see [`LayerWeight::over_matte`].
        gain: f64,
    },
    /// A clear layer over a smooth boundary, whose tint holds what a mirror below the layer gives at the half-angle cosine
    /// (see [`coated_reflectance`]): (1 − E(θo))(1 − E(θi)) / (1 − E(θh))², which is 1 for light that is mirrored.
    OverBoundary {
        /// 1 − E over the cosine.
        #[serde(with = "crate::serial::chebyshev")]
        transmittance: Chebyshev,
    },
    /// The albedo scaling of layers below a sheen (KHR_materials_sheen): 1 − strength · the greater of the sheen's
    /// albedos towards viewer and light.
    Sheen {
        /// The greatest channel of the sheen's colour.
        strength: f64,
        /// The albedo of the sheen lobe.
        albedo: charlie::Albedo,
    },
    /// A rank of a table over half and difference angles: what measured reflectance is over the lobe.
    Table {
        /// The table.
        table: Arc<FactorTable>,
        /// Which of its ranks.
        rank: usize,
    },
}

impl LayerWeight {
    /// A coat over a specular lobe of a known boundary, whose tint has the internal reflection: [`coated_reflectance`].
    pub fn over_boundary(coat: &CoatSurface) -> Self {
        Self::OverBoundary { transmittance: coat.transmittance.clone() }
    }

    /// A coat over a specular lobe of which nothing but its colour is known: internal reflection is lost.
    pub fn over_glossy(coat: &CoatSurface) -> Self {
        Self::Coat { transmittance: coat.transmittance.clone(), gain: 1.0 }
    }

    /// A coat over a diffuse base, with internal reflection between both: a base of reflectance 1 reflects all that the
    /// coat does not, and one of reflectance ρ the fraction [`CoatSurface::reflectance_of_coated`] of it. Source: J. L. Saunderson,
    /// "Calculation of the color of pigmented plastics", JOSA 32, 1942; the angular part as in L. B. Wolff,
    /// "Diffuse-reflectance model for smooth dielectric surfaces", JOSA A 11, 1994.
    pub fn over_matte(coat: &CoatSurface) -> Self {
        Self::Coat { transmittance: coat.transmittance.clone(), gain: 1.0 / (1.0 - coat.diffuse) }
    }

    /// Whether it depends on where the tangent is.
    pub fn is_anisotropic(&self) -> bool {
        matches!(self, Self::Table { table, .. } if table.is_anisotropic())
    }

    /// The factor.
    #[inline(always)]
    pub fn factor<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let one = pair.cos_o.one();
        match self {
            Self::Constant(weight) => one.lit(*weight),
            Self::Schlick { angle, at_zero, at_grazing } => {
                let rest = (one - angle.cosine(pair)).clamp(0.0, 1.0);
                one.lit(*at_zero) + one.lit(at_grazing - at_zero) * (rest.sqr().sqr() * rest)
            }
            Self::Series { angle, factor } => factor.at(angle.cosine(pair).min(one)),
            Self::Coat { transmittance, gain } => {
                let left = |cosine: R| transmittance.at(cosine.abs().min(one)).clamp(0.0, 1.0);
                left(pair.cos_o) * left(pair.cos_i) * one.lit(*gain)
            }
            Self::OverBoundary { transmittance } => {
                let left =
                    |cosine: R| transmittance.at(cosine.abs().min(one)).clamp(LEAST_TRANSMITTANCE, 1.0);
                left(pair.cos_o) * left(pair.cos_i) / left(pair.cos_view_half()).sqr()
            }
            Self::Sheen { strength, albedo } => {
                let taken = albedo.at(pair.cos_o.abs()).max(albedo.at(pair.cos_i.abs()));
                (one - taken * one.lit(*strength)).max(one.zero())
            }
            Self::Table { table, rank } => table.factors(pair).get(*rank).copied().unwrap_or(one.zero()),
        }
    }
}

/// A ratio of transmittances takes none as less than this: at grazing angles both are 0.
const LEAST_TRANSMITTANCE: f64 = 1e-3;

/// Terms of a coat's transmittance over the cosine.
const COAT_TERMS: usize = 24;

/// Facets of a rough coat along each of two directions that its reflectance is the mean over.
const FACETS: usize = 24;

/// The surface of a clear coat: GGX facets that reflect by Fresnel's law.
///
/// ```
/// use glanz_bsdf::CoatSurface;
///
/// // A smooth coat of index 1.5 reflects 9.2 % of diffuse light (Kortüm 1969).
/// let coat = CoatSurface::new(1.5, 0.001);
/// assert!((coat.diffuse_reflectance() - 0.092).abs() < 5e-4);
/// // It darkens a grey base more than a white one: light that is reflected inside meets the base again.
/// assert_eq!(coat.reflectance_of_coated(1.0), 1.0);
/// assert!((coat.reflectance_of_coated(0.5) - 0.288).abs() < 2e-3);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CoatSurface {
    eta: f64,
    transmittance: Chebyshev,
    /// Its reflectance for diffuse light from outside.
    diffuse: f64,
}

impl CoatSurface {
    /// That of a coat with this index of refraction and width of its highlight.
    pub fn new(eta: f64, alpha: f64) -> Self {
        let transmittance =
            Chebyshev::interpolate(COAT_TERMS, |cosine| 1.0 - coat_reflectance(eta, alpha, cosine));
        let diffuse = 1.0 - 2.0 * GaussLegendre::new(32).integrate(0.0, 1.0, |c| transmittance.at(c) * c);
        Self { eta, transmittance, diffuse }
    }

    /// Its reflectance for diffuse light from outside.
    pub fn diffuse_reflectance(&self) -> f64 {
        self.diffuse
    }

    /// What a diffuse base of reflectance `rho` below it reflects, in parts of what one of reflectance 1 does:
    /// ρ(1 − K) / (1 − K ρ), K being the coat's reflectance for diffuse light from inside.
    pub fn reflectance_of_coated(&self, rho: f64) -> f64 {
        let inside = 1.0 - (1.0 - self.diffuse) / (self.eta * self.eta);
        rho * (1.0 - inside) / (1.0 - inside * rho)
    }
}

/// The reflectance of a mirror below a coat, without what the coat itself reflects: (1 − E)² R / (1 − E R), light going to and
/// fro between both. E is the albedo of the coat towards a direction of this cosine, R what the boundary below reflects at
/// the cosine that light has inside of the coat, times what absorption leaves on the way down and up.
///
/// ```
/// use glanz_bsdf::coated_reflectance;
///
/// // Below a smooth coat of index 1.5, which reflects 4 %, a perfect mirror returns the rest.
/// assert!((coated_reflectance(0.04, 1.0) - 0.96).abs() < 1e-12);
/// ```
pub fn coated_reflectance(coat: f64, below: f64) -> f64 {
    let passed = 1.0 - coat;
    if passed <= 0.0 { 0.0 } else { passed * passed * below / (1.0 - coat * below) }
}

/// The directional albedo of the surface of a coat: GGX facets of width `alpha` that reflect by Fresnel's law, single
/// reflections only: the mean of F · G2/G1 over the distribution of visible normals. Source of their distribution: E. Heitz,
/// "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018.
///
/// ```
/// use glanz_bsdf::coat_reflectance;
///
/// assert!((coat_reflectance(1.5, 0.001, 1.0) - 0.04).abs() < 1e-4);
/// ```
pub fn coat_reflectance(eta: f64, alpha: f64, cos_o: f64) -> f64 {
    let cos_o = cos_o.clamp(1e-4, 1.0);
    let sin_o = libm::sqrt(1.0 - cos_o * cos_o);
    let stretched = Vec3::new(alpha * sin_o, 0.0, cos_o).normalized();
    let across = Vec3::new(0.0, 1.0, 0.0);
    let along = stretched.cross(across);
    let lambda = |w: Vec3<f64>| lambda_ggx(w, (alpha, alpha));
    let wo = Vec3::new(sin_o, 0.0, cos_o);
    let mut sum = 0.0;
    for i in 0..FACETS * FACETS {
        let step = |i: usize| (i as f64 + 0.5) / FACETS as f64;
        // A disk seen from the stretched view, of which the lower half is foreshortened.
        let (radius, turn) = (libm::sqrt(step(i % FACETS)), 2.0 * PI * step(i / FACETS));
        let (sin, cos) = libm::sincos(turn);
        let t1 = radius * cos;
        let half = 0.5 * (1.0 + stretched.z);
        let t2 = (1.0 - half) * libm::sqrt(1.0 - t1 * t1) + half * radius * sin;
        let t3 = libm::sqrt((1.0 - t1 * t1 - t2 * t2).max(0.0));
        let n = across * t1 + along * t2 + stretched * t3;
        let h = Vec3::new(alpha * n.x, alpha * n.y, n.z.max(0.0)).normalized();
        let wi = wo.reflected(h);
        if wi.z > 0.0 {
            let masked = (1.0 + lambda(wo)) / (1.0 + lambda(wo) + lambda(wi));
            sum += fresnel_dielectric(wo.dot(h).clamp(0.0, 1.0), eta) * masked;
        }
    }
    sum / (FACETS * FACETS) as f64
}

/// The directional albedo of a shape below layers.
pub fn layered_albedo(shape: &Shape, layers: &[LayerWeight], cos_o: f64) -> f64 {
    let layer = |pair: &DirectionPair<f64>| layers.iter().map(|layer| layer.factor(pair)).product::<f64>();
    directional(shape.info(), shape.eta(), (cos_o, 0.0), |pair| shape.f_cos(pair) * layer(pair))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::albedo_with;

    /// The least width that the coat's shape has: as good as smooth.
    const SMOOTH: f64 = 0.001;

    #[test]
    fn a_smooth_coat_reflects_what_fresnel_says() {
        for cosine in [1.0, 0.7, 0.3, 0.1] {
            let (got, exact) = (coat_reflectance(1.5, SMOOTH, cosine), fresnel_dielectric(cosine, 1.5));
            assert!((got - exact).abs() < 2e-4, "{cosine}: {got} for {exact}");
        }
        // G. Kortüm, Reflectance Spectroscopy, 1969, and many others: 0.092 from outside, 0.596 from inside.
        let diffuse = CoatSurface::new(1.5, SMOOTH).diffuse_reflectance();
        assert!((diffuse - 0.0918).abs() < 5e-4, "{diffuse}");
        assert!((1.0 - (1.0 - diffuse) / 2.25 - 0.5964).abs() < 5e-4);
    }

    #[test]
    fn a_rough_coat_reflects_the_integral_of_its_lobe() {
        for (alpha, cosine) in [(0.2, 0.9), (0.5, 0.5), (1.0, 0.3)] {
            let ggx = Shape::named("ggx", &[("alpha", alpha), ("multiscatter", 0.0)]).expect("ggx exists");
            let lobe =
                |pair: &DirectionPair<f64>| ggx.f_cos(pair) * fresnel_dielectric(pair.cos_view_half(), 1.5);
            let exact = albedo_with(&ggx, cosine, 0.0, lobe);
            let got = coat_reflectance(1.5, alpha, cosine);
            assert!((got - exact).abs() < 2e-3, "{alpha}, {cosine}: {got} for {exact}");
        }
    }

    #[test]
    fn a_grey_base_is_darker_under_a_coat_and_black_and_white_stay() {
        let coat = CoatSurface::new(1.5, SMOOTH);
        assert_eq!(coat.reflectance_of_coated(0.0), 0.0);
        assert!((coat.reflectance_of_coated(1.0) - 1.0).abs() < 1e-12);
        let grey = coat.reflectance_of_coated(0.5);
        assert!((grey - 0.5 * 0.4036 / (1.0 - 0.5964 * 0.5)).abs() < 1e-3, "{grey}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
        #[test]
        fn a_coated_base_never_gives_more_than_it_gets(
            eta in 1.05..3.0_f64,
            alpha in 0.001..1.0_f64,
            degrees in 0.0..85.0_f64,
        ) {
            let coat = CoatSurface::new(eta, alpha);
            let cosine = libm::cos(degrees.to_radians());
            let (lambert, ggx) = (
                Shape::named("lambert", &[]).expect("lambert exists"),
                Shape::named("ggx", &[("alpha", alpha), ("multiscatter", 0.0)]).expect("ggx exists"),
            );
            let matte = layered_albedo(&lambert, &[LayerWeight::over_matte(&coat)], cosine);
            let glossy = layered_albedo(&ggx, &[LayerWeight::over_glossy(&coat)], cosine);
            let gloss = |pair: &DirectionPair<f64>| ggx.f_cos(pair) * fresnel_dielectric(pair.cos_view_half(), eta);
            let top = albedo_with(&ggx, cosine, 0.0, gloss);
            let boundary = LayerWeight::over_boundary(&coat);
            let smooth = |cosine: f64| coated_reflectance(coat_reflectance(eta, alpha, cosine), 1.0);
            let mirror = |pair: &DirectionPair<f64>| {
                ggx.f_cos(pair) * smooth(pair.cos_view_half()) * boundary.factor(pair)
            };
            let below = albedo_with(&ggx, cosine, 0.0, mirror);
            prop_assert!(top + below < 1.005, "a perfect mirror: {top} + {below}");
            // The series, the mean over facets and both quadratures are each within 2e-3.
            prop_assert!(top + matte < 1.005, "white matte: {top} + {matte}");
            prop_assert!(top + matte > 0.99, "nothing is lost over white: {top} + {matte}");
            prop_assert!(top + glossy < 1.005, "mirroring: {top} + {glossy}");
        }
    }

    #[test]
    fn schlick_runs_from_one_value_to_the_other() {
        let layer = LayerWeight::Schlick { angle: Angle::View, at_zero: 0.04, at_grazing: 1.0 };
        assert_eq!(layer.factor(&DirectionPair::isotropic(1.0, 0.5, 0.5)), 0.04_f64);
        assert_eq!(layer.factor(&DirectionPair::isotropic(0.0, 0.5, 0.5)), 1.0_f64);
        assert!((layer.factor(&DirectionPair::isotropic(0.5, 0.5, 0.5)) - 0.07_f64).abs() < 1e-12);
    }

    #[test]
    fn light_through_a_thin_sheet_has_the_angle_of_its_mirror_image() {
        let (above, below) = (
            DirectionPair::isotropic(0.7, 0.4, 0.5),
            DirectionPair::isotropic(0.7, -0.4, 0.5 - 2.0 * 0.7 * 0.4),
        );
        let layer = |angle| LayerWeight::Schlick { angle, at_zero: 0.9, at_grazing: 0.0 };
        let (expected, got): (f64, f64) =
            (layer(Angle::Half).factor(&above), layer(Angle::HalfThrough).factor(&below));
        assert!((got - expected).abs() < 1e-12, "{got} for {expected}");
    }

    #[test]
    fn a_curve_is_taken_at_its_cosine() {
        let layer =
            LayerWeight::Series { angle: Angle::View, factor: Chebyshev::interpolate(4, |c| 1.0 - 0.5 * c) };
        assert!((layer.factor(&DirectionPair::isotropic(0.6, 0.5, 0.5)) - 0.7_f64).abs() < 1e-12);
    }

    #[test]
    fn a_sheen_leaves_what_the_flatter_of_both_directions_does() {
        let albedo = charlie::Albedo::new(0.25);
        let layer = LayerWeight::Sheen { strength: 0.5, albedo };
        for (cos_o, cos_i) in [(0.9, 0.1), (0.1, 0.9)] {
            let got: f64 = layer.factor(&DirectionPair::isotropic(cos_o, cos_i, 0.5));
            assert!((got - (1.0 - 0.5 * albedo.at(0.1_f64))).abs() < 1e-12, "{got}");
        }
    }
}
