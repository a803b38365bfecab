//! Directional albedos by quadrature.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::{DirectionPair, ModelInfo, Shape, Side};

/// Halvings of the cells towards the mirror direction: the finest are π/2 · 2^-13 = 0.0002 rad wide,
/// a fifteenth of a Phong lobe with the greatest exponent allowed, 10⁵.
const HALVINGS: i32 = 13;

/// Halvings towards the mirror azimuth: a lobe about a half vector that is 0.002 rad wide in height is only 3e-5 rad
/// wide around at 89°.
const HALVINGS_AROUND: i32 = 17;

/// Halvings towards the viewer, where lobes that send light back have their peak: 0.02 rad.
const HALVINGS_BACK: i32 = 6;

/// Halvings of a cell that the horizon cuts, of those that half vectors span.
const HALVINGS_HORIZON: u32 = 3;

/// No cell is wider than this, so that kinks of a lobe far from its peak (where R·wo passes zero) are
/// resolved.
pub(crate) const WIDEST: f64 = PI / 16.0;

/// The same in slopes of half vectors, where lobes are smooth but at the horizon.
const WIDEST_SLOPE: f64 = PI / 8.0;

/// Borders of cells nearer to each other than this, in radians or slopes, are one.
const NEAREST: f64 = 1e-6;

/// Gauss–Legendre points per cell and direction.
const POINTS: usize = 6;

/// The directional albedo for a view in the plane of normal and tangent: [`albedo_at`] with azimuth 0. It is all
/// that there is to know of a model that is not anisotropic.
///
/// ```
/// use glanz_bsdf::{Shape, albedo};
///
/// // Lambert's surface reflects all light, whatever the view.
/// let lambert = Shape::named("lambert", &[])?;
/// assert!((albedo(&lambert, 0.3) - 1.0).abs() < 1e-5);
/// // Phong's highlight of exponent n along the normal reflects 2/(n+1).
/// let phong = Shape::named("phong", &[("shininess", 9.0)])?;
/// assert!((albedo(&phong, 1.0) - 0.2).abs() < 2e-5);
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
pub fn albedo(shape: &Shape, cos_o: f64) -> f64 {
    albedo_at(shape, cos_o, 0.0)
}

/// The directional albedo: ∫ f_cos(wo, wi) dωi for the view angle whose cosine is `cos_o` (0 … 1, clipped) and
/// the azimuth from the tangent in radians, over the hemisphere that the light of the model comes from (see
/// [`Side`]). With no directional light (ambient and emission lobes) the integral exists but is no reflectance;
/// of a lobe without width (`delta`) it is 0.
///
/// Quadrature on a grid in angles that is refined towards the mirror direction and the viewer (for lobes on the
/// other side: towards the straight and the refracted direction), where all lobes of this crate have their peaks.
/// The error is below 2e-5 for Phong's exponents from 1 to 10⁵ and below 2e-4 between 0 and 1, where the lobe
/// has an infinite slope at its edge. For anisotropic models the grid is in the slopes of the half vector
/// along tangent and bitangent, which is where a lobe that is narrow one way only lies along the grid.
///
/// ```
/// use glanz_bsdf::{Shape, albedo_at};
///
/// // Brushed metal by Ward's model, rough across the tangent: a flat view across it gets more light.
/// let ward = Shape::named("ward", &[("alpha", 0.05), ("alpha_y", 0.4)])?;
/// let (along, across) = (albedo_at(&ward, 0.2, 0.0), albedo_at(&ward, 0.2, std::f64::consts::FRAC_PI_2));
/// assert!(across > 1.8 * along);
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
pub fn albedo_at(shape: &Shape, cos_o: f64, azimuth: f64) -> f64 {
    directional(shape.info(), shape.eta(), (cos_o, azimuth), |pair| shape.f_cos(pair))
}

/// [`albedo_at`] of a shape with any factor: ∫ `f_cos` dωi by the shape's own quadrature, where `f_cos` is about as
/// narrow as the shape.
pub fn albedo_with(
    shape: &Shape,
    cos_o: f64,
    azimuth: f64,
    f_cos: impl Fn(&DirectionPair<f64>) -> f64,
) -> f64 {
    directional(shape.info(), shape.eta(), (cos_o, azimuth), f_cos)
}

/// [`albedo_at`] of any function of two directions, with the view as cosine and azimuth.
pub(crate) fn directional(
    info: &ModelInfo,
    eta: f64,
    (cos_o, azimuth): (f64, f64),
    f_cos: impl Fn(&DirectionPair<f64>) -> f64,
) -> f64 {
    let theta_o = libm::acos(cos_o.clamp(0.0, 1.0));
    let wo = Vec3::from_angles(theta_o, azimuth);
    let value = |wi| f_cos(&DirectionPair::new(wo, wi));
    match (info.delta, info.side, info.anisotropic) {
        (true, ..) => 0.0,
        (_, Side::Reflection, true) => over_half_vectors(wo, value),
        (_, Side::Reflection, false) => {
            // Both halves of the circle are alike; their common borders are the peaks.
            let around = refined(0.0, PI, WIDEST, NEAREST, &[(PI, HALVINGS_AROUND), (0.0, HALVINGS_BACK)]);
            let polar = refined(0.0, PI / 2.0, WIDEST, NEAREST, &[(theta_o, HALVINGS)]);
            2.0 * over_angles(&polar, &around, |theta, phi| value(Vec3::from_angles(theta, phi + azimuth)))
        }
        (_, Side::Transmission, anisotropic) => {
            let refracted = libm::asin((libm::sin(theta_o) / eta).min(1.0));
            let polar =
                refined(0.0, PI / 2.0, WIDEST, NEAREST, &[(theta_o, HALVINGS), (refracted, HALVINGS)]);
            let (end, times) = if anisotropic { (2.0 * PI, 1.0) } else { (PI, 2.0) };
            let around = refined(0.0, end, WIDEST, NEAREST, &[(PI, HALVINGS_AROUND)]);
            let below = |theta, phi| value(Vec3::from_angles(PI - theta, phi + azimuth));
            times * over_angles(&polar, &around, below)
        }
    }
}

/// ∫ f dω over cells in polar angle and azimuth.
pub(crate) fn over_angles(polar: &[f64], around: &[f64], f: impl Fn(f64, f64) -> f64) -> f64 {
    let rule = GaussLegendre::new(POINTS);
    let strip = |theta: f64| {
        let cells = around.windows(2);
        let ring: f64 = cells.map(|cell| rule.integrate(cell[0], cell[1], |phi| f(theta, phi))).sum();
        ring * libm::sin(theta)
    };
    polar.windows(2).map(|cell| rule.integrate(cell[0], cell[1], strip)).sum()
}

/// ∫ f(wi) dωi over the upper hemisphere, by the half vector: dωi = 4 (wo·h) dωh.
///
/// Its slopes hx/hz and hy/hz are the tangents of the two angles that the grid divides.
fn over_half_vectors(wo: Vec3<f64>, f: impl Fn(Vec3<f64>) -> f64) -> f64 {
    let rule = GaussLegendre::new(POINTS);
    let back = |along: f64| libm::atan2(along, wo.z);
    let borders = |along: f64| {
        refined(
            -PI / 2.0,
            PI / 2.0,
            WIDEST_SLOPE,
            NEAREST,
            &[(0.0, HALVINGS), (back(along), HALVINGS_BACK / 2)],
        )
    };
    let (in_x, in_y) = (borders(wo.x), borders(wo.y));
    let cells = in_x.windows(2).flat_map(|x| in_y.windows(2).map(move |y| [x[0], x[1], y[0], y[1]]));
    cells.map(|cell| half_vector_cell(&rule, wo, cell, HALVINGS_HORIZON, &f)).sum()
}

/// The part of [`over_half_vectors`] in one cell, which is quartered where the horizon cuts it.
fn half_vector_cell(
    rule: &GaussLegendre,
    wo: Vec3<f64>,
    [x0, x1, y0, y1]: [f64; 4],
    halvings: u32,
    f: &impl Fn(Vec3<f64>) -> f64,
) -> f64 {
    let at = |x: f64, y: f64| {
        let h = Vec3::new(libm::tan(x), libm::tan(y), 1.0).normalized();
        (wo.reflected(h), wo.dot(h), h.z)
    };
    let lit = |x, y| {
        let (wi, cosine, _) = at(x, y);
        wi.z > 0.0 && cosine > 0.0
    };
    let corners = [lit(x0, y0), lit(x0, y1), lit(x1, y0), lit(x1, y1)];
    if halvings > 0 && corners.contains(&true) && corners.contains(&false) {
        let (x, y) = (0.5 * (x0 + x1), 0.5 * (y0 + y1));
        let quarters = [[x0, x, y0, y], [x, x1, y0, y], [x0, x, y, y1], [x, x1, y, y1]];
        return quarters.iter().map(|quarter| half_vector_cell(rule, wo, *quarter, halvings - 1, f)).sum();
    }
    rule.integrate(x0, x1, |x| {
        rule.integrate(y0, y1, |y| {
            let (wi, cosine, up) = at(x, y);
            if wi.z <= 0.0 || cosine <= 0.0 {
                return 0.0;
            }
            // dωh is hz³ times the area in slopes, and a slope grows by 1/cos² with its angle.
            let (slope_x, slope_y) = (1.0 / libm::cos(x), 1.0 / libm::cos(y));
            f(wi) * 4.0 * cosine * up * up * up * slope_x * slope_x * slope_y * slope_y
        })
    })
}

/// Cell borders from `low` to `high`, no further apart than `widest` nor nearer than `nearest`, and ever finer towards the peaks, each
/// with the number of halvings.
pub(crate) fn refined(low: f64, high: f64, widest: f64, nearest: f64, peaks: &[(f64, i32)]) -> Vec<f64> {
    let mut borders = vec![low, high];
    for (peak, halvings) in peaks {
        borders.push(*peak);
        for halving in 0..=*halvings {
            let distance = PI / 2.0 * libm::ldexp(1.0, -halving);
            borders.extend([peak - distance, peak + distance]);
        }
    }
    let steps = libm::ceil((high - low) / widest) as i32;
    borders.extend((1..steps).map(|i| low + (high - low) * f64::from(i) / f64::from(steps)));
    borders.retain(|x| (low..=high).contains(x));
    borders.sort_by(f64::total_cmp);
    borders.dedup_by(|a, b| (*a - *b).abs() < nearest);
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

    /// What an anisotropic or a transmitting model says of itself, as far as the quadrature asks.
    fn info(side: Side, anisotropic: bool) -> ModelInfo {
        ModelInfo { side, anisotropic, ..*shape("phong", 1.0).info() }
    }

    #[test]
    fn slopes_of_the_half_vector_and_angles_give_the_same() {
        let info = info(Side::Reflection, true);
        for degrees in [0.0, 45.0, 80.0] {
            for name in ["lambert", "blinn-phong-normalized"] {
                let shape = Shape::named(name, &[]).unwrap();
                let cosine = libm::cos(degrees * PI / 180.0);
                let got = directional(&info, 1.0, (cosine, 0.7), |pair| shape.f_cos(pair));
                let expected = albedo(&shape, cosine);
                assert!((got - expected).abs() < 1e-4, "{name} at {degrees}°: {got} for {expected}");
            }
        }
    }

    #[test]
    fn a_lobe_far_narrower_one_way_is_found_at_every_azimuth() {
        // A density of slopes, which adds up to 1 when every facet reflects all that it receives: the integral
        // of D (wo·h) / cosθo, without shadowing and without horizon.
        for (x, y) in [(0.05, 0.16), (0.16, 0.05), (0.001, 0.1), (0.001, 0.001)] {
            for azimuth in [0.0, 0.4, 1.5] {
                let info = info(Side::Reflection, true);
                let got = directional(&info, 1.0, (0.8, azimuth), |pair| {
                    let up = pair.cos_o + pair.cos_i;
                    let (px, py) = (
                        (pair.tangent_o.0 + pair.tangent_i.0) / up,
                        (pair.tangent_o.1 + pair.tangent_i.1) / up,
                    );
                    let exponent = (px / x) * (px / x) + (py / y) * (py / y);
                    let d = libm::exp(-exponent) / (PI * x * y * libm::pow(pair.cos_half(), 4.0));
                    d / (4.0 * 0.8)
                });
                assert!((got - 1.0).abs() < 1e-4, "{x}/{y} at {azimuth}: {got}");
            }
        }
    }

    #[test]
    fn narrow_lobes_of_light_from_below_are_found_straight_on_and_refracted() {
        for degrees in [0.0, 30.0, 70.0] {
            let theta = degrees * PI / 180.0;
            for eta in [1.0, 1.5] {
                let wt = Vec3::from_angles(PI - libm::asin(libm::sin(theta) / eta), PI);
                let got =
                    directional(&info(Side::Transmission, false), eta, (libm::cos(theta), 0.0), |pair| {
                        let wi = Vec3::new(pair.tangent_i.0, pair.tangent_i.1, pair.cos_i);
                        // A Gaussian of solid angle 1 about the refracted direction.
                        let chord = wi - wt;
                        libm::exp(-chord.dot(chord) / 1e-6) / (PI * 1e-6)
                    });
                assert!((got - 1.0).abs() < 1e-4, "{degrees}° into {eta}: {got}");
            }
        }
    }
}
