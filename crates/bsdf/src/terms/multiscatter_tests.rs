//! What the lobe of missing energy must be: no more than what is missing, and hardly less.

use glanz_math::Vec3;

use super::*;

/// The error of a furnace that the lobe is allowed, isotropic.
const FURNACE: f64 = 5e-3;

fn error(distribution: Distribution, alpha: (f64, f64)) -> (f64, f64) {
    let lobe = MultiScatter::new(distribution, alpha, 1.0);
    let mut range = (f64::MAX, f64::MIN);
    for cosine in [0.003, 0.01, 0.03, 0.07, 0.12, 0.2, 0.3, 0.45, 0.6, 0.8, 0.97] {
        for azimuth in [0.0, 0.35, 0.8, 1.2, PI / 2.0] {
            let missing = 1.0 - smith_albedo(distribution, alpha, cosine, azimuth);
            let w = Vec3::from_angles(libm::acos(cosine), azimuth);
            let wrong = lobe.at(w.z, (w.x, w.y)) - missing;
            range = (range.0.min(wrong), range.1.max(wrong));
        }
    }
    range
}

#[test]
fn a_surface_of_one_width_sends_out_what_it_gets_to_half_a_percent() {
    for distribution in [Distribution::Ggx, Distribution::Beckmann] {
        for alpha in [0.001, 0.01, 0.03, 0.08, 0.15, 0.22, 0.37, 0.5, 0.72, 0.9, 1.0] {
            let (low, high) = error(distribution, (alpha, alpha));
            assert!(low > -FURNACE && high < 5e-4, "{distribution:?}, {alpha}: {low} … {high}");
        }
    }
}

#[test]
fn an_elongated_surface_makes_no_energy_and_loses_a_few_percent_at_most() {
    for distribution in [Distribution::Ggx, Distribution::Beckmann] {
        for (alpha, loss) in [
            ((0.05, 0.16), 0.02),
            ((0.2, 0.1), 0.02),
            ((0.3, 0.5), 0.02),
            ((0.2, 0.6), 0.05),
            ((0.9, 0.1), 0.12),
        ] {
            let (low, high) = error(distribution, alpha);
            assert!(low > -loss && high < 5e-4, "{distribution:?}, {alpha:?}: {low} … {high}");
        }
    }
}

#[test]
fn a_widened_surface_is_the_one_of_that_width() {
    let (wide, narrow) = (
        MultiScatter::new(Distribution::Ggx, (0.8, 0.8), 1.0),
        MultiScatter::new(Distribution::Ggx, (0.2, 0.2), 1.0),
    );
    for (wo, wi) in [(0.3, 0.8), (1.0, 0.1), (0.05, 0.05)] {
        let mut pair = DirectionPair::isotropic(wo, wi, 0.2);
        let expected = narrow.f_cos(&pair, Some(pair.alpha_scale));
        pair.alpha_scale = 0.25;
        let got: f64 = wide.f_cos(&pair, Some(pair.alpha_scale));
        // The polynomial of the average is too great by 7 % for so little that is missing.
        assert!(got <= expected * 1.001 && got > 0.93 * expected, "{got} for {expected}");
    }
}
