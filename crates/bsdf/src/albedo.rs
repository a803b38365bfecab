//! How much of the light from all around leaves towards one direction.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::{Pair, Shape};

/// Halvings of the cells towards the mirror direction: the finest are π/2 · 2^-13 = 0.0002 rad wide,
/// a fifteenth of a Phong lobe with the greatest exponent allowed, 10⁵.
const HALVINGS: i32 = 13;

/// No cell is wider than this, so that kinks of a lobe far from its peak (where R·wo passes zero) are
/// resolved.
const WIDEST: f64 = PI / 16.0;

/// Gauss–Legendre points per cell and direction.
const POINTS: usize = 6;

/// The directional albedo: ∫ f_cos(wo, wi) dωi over the upper hemisphere for the view angle whose
/// cosine is `cos_o` (0 … 1, clipped). With no directional light (ambient and emission lobes) the
/// integral exists but is no reflectance.
///
/// Quadrature on a grid in angles that is refined towards the mirror direction, where all lobes of
/// this crate have their peak. The error is below 2e-5 for all exponents from 1 to 10⁵ and below
/// 2e-4 between 0 and 1, where the lobe has an infinite slope at its edge.
pub fn albedo(shape: &Shape, cos_o: f64) -> f64 {
    directional(cos_o, |pair| shape.f_cos(pair))
}

/// [`albedo`] of any function of two directions.
pub(crate) fn directional(cos_o: f64, f_cos: impl Fn(&Pair<f64>) -> f64) -> f64 {
    let theta_o = libm::acos(cos_o.clamp(0.0, 1.0));
    let wo = Vec3::from_angles(theta_o, 0.0);
    let rule = GaussLegendre::new(POINTS);
    let polar = refined(0.0, PI / 2.0, theta_o);
    let around = refined(0.0, 2.0 * PI, PI);
    let strip = |theta: f64| {
        let cells = around.windows(2);
        let ring: f64 = cells
            .map(|cell| {
                rule.integrate(cell[0], cell[1], |phi| f_cos(&Pair::new(wo, Vec3::from_angles(theta, phi))))
            })
            .sum();
        ring * libm::sin(theta)
    };
    polar.windows(2).map(|cell| rule.integrate(cell[0], cell[1], strip)).sum()
}

/// Cell borders from `low` to `high`, ever finer towards `peak`.
fn refined(low: f64, high: f64, peak: f64) -> Vec<f64> {
    let mut borders = vec![low, peak, high];
    for halving in 0..=HALVINGS {
        let distance = PI / 2.0 * libm::ldexp(1.0, -halving);
        borders.extend([peak - distance, peak + distance]);
    }
    let steps = libm::ceil((high - low) / WIDEST) as i32;
    borders.extend((1..steps).map(|i| low + (high - low) * f64::from(i) / f64::from(steps)));
    borders.retain(|x| (low..=high).contains(x));
    borders.sort_by(f64::total_cmp);
    borders.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    borders
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(name: &str, n: f64) -> Shape {
        Shape::named(name, &[("shininess", n)]).unwrap()
    }

    #[test]
    fn phong_along_the_normal_is_2_over_n_plus_1() {
        for n in [0.0, 0.5, 1.0, 7.5, 32.0, 1000.0, 1e5] {
            let (got, expected) = (albedo(&shape("phong", n), 1.0), 2.0 / (n + 1.0));
            let error = if n > 0.0 && n < 1.0 { 2e-4 } else { 2e-5 };
            assert!((got - expected).abs() < error, "n = {n}: {got} for {expected}");
        }
    }

    #[test]
    fn phong_of_exponent_1_is_half_of_1_plus_cosine() {
        // A clipped cosine lobe about the mirror direction, cut by the horizon: (1 + cosθ) / 2.
        for cosine in [1.0, 0.9, 0.5, 0.1, 0.01, 0.0] {
            let got = albedo(&shape("phong", 1.0), cosine);
            assert!((got - 0.5 * (1.0 + cosine)).abs() < 2e-5, "cosθ = {cosine}: {got}");
        }
    }

    #[test]
    fn a_narrow_lobe_is_found_at_every_angle() {
        // Towards n → ∞ the energy-normalised lobe reflects the cosine of the view angle.
        for degrees in [0.0, 1.0, 10.0, 33.3, 60.0, 80.0, 85.0] {
            let cosine = libm::cos(degrees * PI / 180.0);
            let got = albedo(&shape("phong-normalized", 1e5), cosine);
            assert!((got - cosine).abs() < 2e-5, "{degrees}°: {got}");
        }
    }

    #[test]
    fn blinn_phong_along_the_normal_has_its_closed_form() {
        for n in [0.0, 2.0, 7.5, 100.0, 1e5] {
            let got = albedo(&shape("blinn-phong", n), 1.0);
            let expected = 8.0 / (n + 2.0) * (1.0 - libm::exp2(-0.5 * (n + 2.0)));
            assert!((got - expected).abs() < 2e-5, "n = {n}: {got} for {expected}");
        }
    }

    #[test]
    fn a_view_from_below_counts_as_grazing() {
        let lobe = shape("phong", 5.0);
        assert_eq!(albedo(&lobe, -0.3), albedo(&lobe, 0.0));
    }
}
