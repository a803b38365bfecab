//! Colour temperature: the Planckian locus, correlated colour temperature and the distance from it.
//!
//! ```
//! use glanz_color::chromaticity::Chromaticity;
//! use glanz_color::light;
//! use glanz_color::temperature::color_temperature;
//!
//! let fl2 = Chromaticity::of_light(&light("FL2")?).expect("it is seen");
//! let found = color_temperature(fl2).expect("it is nearly white");
//! // CIE 15 gives 4230 K; a little above the locus.
//! assert!((found.cct_k - 4224.7).abs() < 1.0 && (found.duv - 0.0018).abs() < 1e-4);
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

use std::sync::LazyLock;

use crate::lights::formulas::planck_at;
use crate::measures::chromaticity::Chromaticity;
use crate::observers::cie1931_by_1_nm;

/// The temperatures within which a correlated colour temperature is sought, in K.
pub const CCT_RANGE_K: [f64; 2] = [1_000.0, 100_000.0];

/// The distance Duv beyond which a correlated colour temperature says nothing (CIE 15:2018, 9.4).
pub const MOST_DUV: f64 = 0.05;

/// The correlated colour temperature of a light and its distance from the Planckian locus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorTemperature {
    /// The temperature of the black body whose colour is nearest in the CIE 1960 diagram, in K.
    pub cct_k: f64,
    /// That distance in u, v; positive above the locus (greenish), negative below it (pinkish).
    pub duv: f64,
}

/// Why there is no colour temperature.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the nearest black body to x {}, y {} lies beyond {} to {} K", .0.x, .0.y, CCT_RANGE_K[0], CCT_RANGE_K[1])]
pub struct TemperatureError(pub Chromaticity);

/// The chromaticity of a black body at a temperature in K, for the CIE 1931 observer by sums of 1 nm from 360 to 830 nm.
///
/// None where the temperature is so low, or no number, that nothing is seen.
pub fn planckian(temperature_k: f64) -> Option<Chromaticity> {
    let power = planck_at(temperature_k);
    let xyz = cie1931_by_1_nm().iter().fold([0.0; 3], |sums: [f64; 3], (nm, xyz)| {
        let power = power(*nm);
        core::array::from_fn(|i| sums[i] + power * xyz[i])
    });
    Chromaticity::of_xyz(xyz)
}

/// u, v of a black body by the logarithm of its temperature, within the range.
fn planckian_uv(log_k: f64) -> [f64; 2] {
    planckian(libm::exp(log_k)).expect("black bodies from 1000 to 100000 K are seen").uv1960()
}

/// Points of the locus at even steps of the logarithm.
const STEPS: usize = 256;

/// The step of the logarithm between points: 1.8 % of the temperature.
fn step() -> f64 {
    libm::log(CCT_RANGE_K[1] / CCT_RANGE_K[0]) / (STEPS - 1) as f64
}

fn log_at(index: usize) -> f64 {
    libm::log(CCT_RANGE_K[0]) + step() * index as f64
}

/// How near to an end of the range, in the logarithm, a temperature counts as the end.
const END: f64 = 1e-5;

/// How far from the end of the locus, in u and v, a chromaticity is still its own.
const ON_LOCUS: f64 = 1e-6;

static TABLE: LazyLock<Vec<[f64; 2]>> =
    LazyLock::new(|| (0..STEPS).map(|i| planckian_uv(log_at(i))).collect());

/// The correlated colour temperature of a chromaticity.
///
/// By definition: the nearest point of the locus in CIE 1960 u, v. A table finds the neighbourhood, golden
/// section the point, each time with Planck's law itself; exact to 1e-5 relative for the locus of the
/// 1 nm sums. A chromaticity of sums by 5 nm is up to 1e-4 relative beside it up to 20000 K (0.07 K at 6500 K). Beyond [`MOST_DUV`] the number means nothing,
/// as the definition has it; it is still given, with the distance that says so.
///
/// # Errors
///
/// The nearest point is an end of [`CCT_RANGE_K`].
pub fn color_temperature(of: Chromaticity) -> Result<ColorTemperature, TemperatureError> {
    let uv = of.uv1960();
    let nearest = (0..STEPS)
        .min_by(|a, b| distance_squared(TABLE[*a], uv).total_cmp(&distance_squared(TABLE[*b], uv)))
        .filter(|_| uv[0].is_finite() && uv[1].is_finite())
        .ok_or(TemperatureError(of))?;
    let neighbours = [nearest.saturating_sub(1), (nearest + 1).min(STEPS - 1)];
    let log_k = golden_section(log_at(neighbours[0]), log_at(neighbours[1]), |log_k| {
        distance_squared(planckian_uv(log_k), uv)
    });
    // At an end of the range the nearest point may be that end only because the range has one: then more than rounding lies
    // along the locus.
    let ends = [log_at(0), log_at(STEPS - 1)];
    if let Some(end) = ends.into_iter().find(|end| (end - log_k).abs() < END)
        && distance_squared(planckian_uv(end), uv) > ON_LOCUS * ON_LOCUS
    {
        return Err(TemperatureError(of));
    }
    let on_locus = planckian_uv(log_k);
    let distance = distance_squared(on_locus, uv).sqrt();
    Ok(ColorTemperature { cct_k: libm::exp(log_k), duv: distance.copysign(uv[1] - on_locus[1]) })
}

fn distance_squared([u, v]: [f64; 2], [other_u, other_v]: [f64; 2]) -> f64 {
    let (du, dv) = (u - other_u, v - other_v);
    du * du + dv * dv
}

/// The least value of a function with one minimum between both (Kiefer 1953).
fn golden_section(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    const PART: f64 = 0.618_033_988_749_894_9;
    // 0.036 of the logarithm, times the part 40 times, is 2e-10.
    const TURNS: usize = 40;
    let (mut left, mut right) = (high - PART * (high - low), low + PART * (high - low));
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..TURNS {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - PART * (high - low);
            at_left = f(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + PART * (high - low);
            at_right = f(right);
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use proptest::prelude::*;

    fn temperature_of(name: &str) -> ColorTemperature {
        color_temperature(Chromaticity::of_light(&light(name).unwrap()).unwrap()).unwrap()
    }

    const KNOWN: [(&str, f64, f64); 8] = [
        ("A", 2855.54, 0.0),
        ("C", 6775.5, -0.002_167),
        ("D50", 5002.1, 0.003_199),
        ("D65", 6504.4, 0.003_199),
        ("D75", 7507.3, 0.003_122),
        ("FL2", 4224.7, 0.001_783),
        ("FL4", 2937.9, -0.000_821),
        ("FL11", 3998.7, 0.000_045),
    ];

    #[test]
    fn lights_have_their_known_temperatures() {
        // colour-science 0.4.7, uv_to_CCT_Ohno2013 with the same sums of 5 nm; for A also 2848 K by the
        // constant of 1931, times 14387.77/14350.
        for (name, cct_k, duv) in KNOWN {
            let found = temperature_of(name);
            assert!((found.cct_k / cct_k - 1.0).abs() < 2e-4, "{name}: {found:?}, not {cct_k}");
            assert!((found.duv - duv).abs() < 2e-5, "{name}: {found:?}, not {duv}");
        }
    }

    #[test]
    fn ohnos_example_is_found() {
        // Ohno 2013; colour-science 0.4.7 gives 6507.4747 K, 0.0032233.
        let found = color_temperature(Chromaticity::from_uv1960([0.1978, 0.3122])).unwrap();
        assert!((found.cct_k - 6507.47).abs() < 1.0, "{found:?}");
        assert!((found.duv - 0.003_223).abs() < 1e-5, "{found:?}");
    }

    #[test]
    fn black_bodies_at_the_ends_of_the_range_are_found() {
        for kelvin in [1000.0, 1001.0, 25_000.0, 99_000.0, 100_000.0] {
            let found = color_temperature(planckian(kelvin).unwrap()).unwrap();
            assert!(
                (found.cct_k / kelvin - 1.0).abs() < 1e-4 && found.duv.abs() < 1e-6,
                "{kelvin}: {found:?}"
            );
        }
        assert!(color_temperature(planckian(900.0).unwrap()).is_err());
    }

    #[test]
    fn colours_with_no_near_black_body_are_refused() {
        for (x, y) in [(0.15, 0.06), (0.73, 0.26), (f64::NAN, 0.3)] {
            assert!(color_temperature(Chromaticity::new(x, y)).is_err(), "{x}, {y}");
        }
        assert_eq!(planckian(0.0), None);
    }

    proptest! {
        #[test]
        fn a_temperature_is_found_again_from_beside_the_locus(
            log_k in 7.0..11.3_f64,
            duv in -0.02..0.02_f64,
        ) {
            let (before, after) = (planckian_uv(log_k - 1e-4), planckian_uv(log_k + 1e-4));
            let along = [after[0] - before[0], after[1] - before[1]];
            let length = libm::hypot(along[0], along[1]);
            // The normal that points to greater v.
            let normal = [along[1] / length, -along[0] / length];
            let [u, v] = planckian_uv(log_k);
            let sign = if normal[1] < 0.0 { -1.0 } else { 1.0 };
            let beside = [u + sign * duv * normal[0], v + sign * duv * normal[1]];
            let found = color_temperature(Chromaticity::from_uv1960(beside)).expect("within the range");
            prop_assert!((libm::log(found.cct_k) - log_k).abs() < 1e-5, "{found:?}");
            prop_assert!((found.duv - duv).abs() < 1e-8, "{found:?}, not {duv}");
        }
    }
}
