//! The compensation must have no more than 1 − E, and hardly less.

use glanz_math::Vec3;

use super::*;
use crate::microfacet::{BeckmannDistribution, GgxDistribution};

/// The error of a furnace that the lobe is allowed, isotropic.
const FURNACE: f64 = 5e-3;

fn error<D: Distribution>(alpha: (f64, f64)) -> (f64, f64) {
    let lobe = Compensation::<D>::new(alpha, 1.0);
    let mut range = (f64::MAX, f64::MIN);
    for cosine in [0.003, 0.01, 0.03, 0.07, 0.12, 0.2, 0.3, 0.45, 0.6, 0.8, 0.97] {
        for azimuth in [0.0, 0.35, 0.8, 1.2, PI / 2.0] {
            let missing = 1.0 - smith_albedo::<D>(alpha, cosine, azimuth);
            let w = Vec3::from_angles(libm::acos(cosine), azimuth);
            let wrong = lobe.at(w.z, (w.x, w.y)) - missing;
            range = (range.0.min(wrong), range.1.max(wrong));
        }
    }
    range
}

fn is_white_to_half_a_percent<D: Distribution>() {
    for alpha in [0.001, 0.01, 0.03, 0.08, 0.15, 0.22, 0.37, 0.5, 0.72, 0.9, 1.0] {
        let (low, high) = error::<D>((alpha, alpha));
        assert!(low > -FURNACE && high < 5e-4, "{:?}, {alpha}: {low} … {high}", D::default());
    }
}

#[test]
fn an_isotropic_surface_sends_out_what_it_gets_to_half_a_percent() {
    is_white_to_half_a_percent::<GgxDistribution>();
    is_white_to_half_a_percent::<BeckmannDistribution>();
}

fn is_white_to_a_few_percent<D: Distribution>() {
    for (alpha, loss) in
        [((0.05, 0.16), 0.02), ((0.2, 0.1), 0.02), ((0.3, 0.5), 0.02), ((0.2, 0.6), 0.05), ((0.9, 0.1), 0.12)]
    {
        let (low, high) = error::<D>(alpha);
        assert!(low > -loss && high < 5e-4, "{:?}, {alpha:?}: {low} … {high}", D::default());
    }
}

#[test]
fn an_anisotropic_surface_makes_no_energy_and_loses_a_few_percent_at_most() {
    is_white_to_a_few_percent::<GgxDistribution>();
    is_white_to_a_few_percent::<BeckmannDistribution>();
}

#[test]
fn a_widened_surface_is_the_one_of_that_width() {
    let (wide, narrow) = (
        Compensation::<GgxDistribution>::new((0.8, 0.8), 1.0),
        Compensation::<GgxDistribution>::new((0.2, 0.2), 1.0),
    );
    for (wo, wi) in [(0.3, 0.8), (1.0, 0.1), (0.05, 0.05)] {
        let mut pair = DirectionPair::isotropic(wo, wi, 0.2);
        let expected = narrow.f_cos(&pair);
        pair.alpha_scale = 0.25;
        let got: f64 = wide.f_cos(&pair);
        // The polynomial of the average is too great by 7 % for so small a value.
        assert!(got <= expected * 1.001 && got > 0.93 * expected, "{got} for {expected}");
    }
}
