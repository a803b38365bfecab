//! What Smith's lobes must be over any distribution, asked of both.

use glanz_math::{PI, Vec3};

use super::*;
use crate::albedo::directional;
use crate::terms::{smith_g1, smith_g2};
use crate::{DirectionPair, Model};

/// Makes one test per distribution out of each function.
macro_rules! for_both {
    ($($name:ident),+ $(,)?) => {
        mod beckmann {
            $(#[test]
            fn $name() {
                super::$name::<super::BeckmannDistribution>();
            })+
        }
        mod ggx {
            $(#[test]
            fn $name() {
                super::$name::<super::GgxDistribution>();
            })+
        }
    };
}

for_both!(
    a_single_reflection_is_the_product_of_its_terms,
    equal_widths_read_no_tangent,
    a_white_furnace_shows_it_to_half_a_percent,
    an_anisotropic_surface_is_white_to_a_percent_and_more_the_more_it_is_anisotropic,
    a_narrow_reflection_is_a_mirror,
    the_compensation_is_what_the_whole_lobe_has_beside_single_reflections,
    the_compensation_has_the_albedo_that_single_reflections_lack,
    transmission_is_the_product_of_its_terms,
    a_narrow_transmission_is_perfect_refraction,
    transmission_without_a_difference_of_indices_is_as_with_a_small_one,
);

fn smith<D: Distribution>(alpha: f64, alpha_y: f64, multiscatter: f64) -> Smith<D> {
    Smith::from_params(&[alpha, alpha_y, multiscatter])
}

fn transmission<D: Distribution>(alpha: f64, eta: f64) -> SmithTransmission<D> {
    SmithTransmission::from_params(&[alpha, eta])
}

fn directions() -> [(Vec3<f64>, Vec3<f64>); 6] {
    [(0.2, 0.5, 3.0), (1.2, 1.0, 2.9), (0.3, 0.1, 2.3), (1.2, 1.0, 2.5), (0.8, 0.1, 0.3), (1.5, 1.45, 3.1)]
        .map(|(o, i, phi)| (Vec3::from_angles(o, 0.4), Vec3::from_angles(i, 0.4 + phi)))
}

fn seen<M: Model>(model: &M, degrees: f64, azimuth: f64) -> f64 {
    let view = (libm::cos(degrees * PI / 180.0), azimuth);
    directional(&M::INFO, model.eta(), view, |pair| model.f_cos(pair))
}

fn a_single_reflection_is_the_product_of_its_terms<D: Distribution>() {
    for alpha in [(0.3, 0.3), (0.05, 0.16), (0.1, 0.3), (1.0, 0.2)] {
        for (wo, wi) in directions() {
            let g = smith_g2(D::lambda(wo, alpha), D::lambda(wi, alpha));
            let expected = D::d((wo + wi).normalized(), alpha) * g / (4.0 * wo.z);
            let got = smith::<D>(alpha.0, alpha.1, 0.0).f_cos(&DirectionPair::new(wo, wi));
            // Far down the slope of a narrow Beckmann lobe the value is exactly 0.
            assert!((got - expected).abs() <= 1e-11 * expected + 1e-28, "{alpha:?}: {got} for {expected}");
        }
    }
}

fn equal_widths_read_no_tangent<D: Distribution>() {
    let (one, two) = (smith::<D>(0.3, 0.0, 1.0), smith::<D>(0.3, 0.3, 1.0));
    for (wo, wi) in directions() {
        let bare = DirectionPair::between((wo.z, wo), (wi.z, wi));
        assert_eq!(one.f_cos(&bare), one.f_cos(&DirectionPair::new(wo, wi)));
        assert_eq!(one.f_cos(&bare), two.f_cos(&bare));
    }
    assert!(!one.is_anisotropic() && !two.is_anisotropic() && smith::<D>(0.3, 0.2, 1.0).is_anisotropic());
}

fn a_white_furnace_shows_it_to_half_a_percent<D: Distribution>() {
    for alpha in [0.01, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0] {
        for degrees in [0.0, 30.0, 60.0, 80.0, 87.0] {
            let got = seen(&smith::<D>(alpha, 0.0, 1.0), degrees, 0.0);
            assert!((0.995..1.0002).contains(&got), "α = {alpha} at {degrees}°: {got}");
        }
    }
}

fn an_anisotropic_surface_is_white_to_a_percent_and_more_the_more_it_is_anisotropic<D: Distribution>() {
    let extreme = if D::TABULATED { 0.07 } else { 0.12 };
    for (alpha, alpha_y, loss) in [(0.05, 0.16, 0.008), (0.5, 0.3, 0.015), (0.9, 0.1, extreme)] {
        for degrees in [0.0, 45.0, 80.0] {
            for azimuth in [0.0, 0.7, 1.5] {
                let got = seen(&smith::<D>(alpha, alpha_y, 1.0), degrees, azimuth);
                assert!(
                    got > 1.0 - loss && got < 1.0002,
                    "{alpha}/{alpha_y} at {degrees}°, {azimuth}: {got}"
                );
            }
        }
    }
}

fn a_narrow_reflection_is_a_mirror<D: Distribution>() {
    for degrees in [0.0, 30.0, 60.0, 80.0] {
        let single = seen(&smith::<D>(0.001, 0.0, 0.0), degrees, 0.0);
        assert!((single - 1.0).abs() < 1e-3, "{degrees}°: {single}");
        let wo = Vec3::from_angles(degrees * PI / 180.0, 0.0);
        let lobe = smith::<D>(0.01, 0.0, 1.0);
        let at = |angle: f64| lobe.f_cos(&DirectionPair::new(wo, Vec3::from_angles(angle * PI / 180.0, PI)));
        assert!(at(degrees) > at(degrees + 0.5) && at(degrees) > at(degrees - 0.5));
    }
}

fn the_compensation_is_what_the_whole_lobe_has_beside_single_reflections<D: Distribution>() {
    let (whole, single) = (smith::<D>(0.6, 0.0, 1.0), smith::<D>(0.6, 0.0, 0.0));
    let multiple = SmithMultiple::<D>::from_params(&[0.6, 0.0]);
    for (cos_o, cos_i, cos_io) in [(0.3, 0.8, 0.2), (1.0, 0.5, 0.5), (0.1, 0.1, -0.9)] {
        let pair = DirectionPair::isotropic(cos_o, cos_i, cos_io);
        let rest: f64 = whole.f_cos(&pair) - single.f_cos(&pair);
        assert!((multiple.f_cos(&pair) - rest).abs() < 1e-14);
    }
}

fn the_compensation_has_the_albedo_that_single_reflections_lack<D: Distribution>() {
    for degrees in [84.3, 60.0, 0.0] {
        let got = seen(&SmithMultiple::<D>::from_params(&[0.6, 0.0]), degrees, 0.0);
        let expected = 1.0 - smith_albedo::<D>((0.6, 0.6), libm::cos(degrees * PI / 180.0), 0.0);
        assert!(got < expected + 5e-4 && got > expected - 5e-3, "{got} for {expected}");
    }
}

fn transmission_is_the_product_of_its_terms<D: Distribution>() {
    for eta in [1.5, 1.0 / 1.5] {
        for (theta_o, theta_i, phi) in [(0.3, 0.3, 3.0), (0.6, 0.2, 2.5), (0.1, 0.5, 3.1)] {
            let (wo, wi) = (Vec3::from_angles(theta_o, 0.0), Vec3::from_angles(PI - theta_i, phi));
            let sum = (wo + wi * eta).normalized();
            let h = if sum.z < 0.0 { -sum } else { sum };
            let (oh, ih) = (wo.dot(h), wi.dot(h));
            assert!(oh > 0.0 && ih < 0.0);
            let alpha = (0.4, 0.4);
            let up = Vec3::new(wi.x, wi.y, -wi.z);
            let g = smith_g1(D::lambda(wo, alpha)) * smith_g1(D::lambda(up, alpha));
            let expected = D::d(h, alpha) * g * oh * -ih / (wo.z * (oh + eta * ih) * (oh + eta * ih));
            let (lobe, pair) = (transmission::<D>(0.4, eta), DirectionPair::new(wo, wi));
            let got = lobe.f_cos(&pair);
            assert!((got / expected - 1.0).abs() < 1e-11, "{got} for {expected}");
            assert!((lobe.tint_cosine(&pair) - oh).abs() < 1e-12);
        }
    }
}

fn a_narrow_transmission_is_perfect_refraction<D: Distribution>() {
    for (eta, degrees) in [(1.5, 0.0), (1.5, 60.0), (1.5, 80.0), (0.75, 0.0), (0.75, 40.0)] {
        let got = eta * eta * seen(&transmission::<D>(0.002, eta), degrees, 0.0);
        assert!((got - 1.0).abs() < 2e-3, "{eta} at {degrees}°: {got}");
        let wo = Vec3::from_angles(degrees * PI / 180.0, 0.0);
        let bent = libm::asin(libm::sin(degrees * PI / 180.0) / eta);
        let lobe = transmission::<D>(0.01, eta);
        let at = |angle: f64| lobe.f_cos(&DirectionPair::new(wo, Vec3::from_angles(PI - angle, PI)));
        assert!(at(bent) > at(bent + 0.01) && at(bent) > at(bent - 0.01), "{eta} at {degrees}°");
    }
}

fn transmission_without_a_difference_of_indices_is_as_with_a_small_one<D: Distribution>() {
    let pair = DirectionPair::new(Vec3::from_angles(0.3, 0.0), Vec3::from_angles(PI - 0.3, PI));
    let (none, small) = (transmission::<D>(0.3, 1.0), transmission::<D>(0.3, 1.01));
    assert_eq!(none.f_cos(&pair), small.f_cos(&pair));
    assert!(none.f_cos(&pair).is_finite());
}
