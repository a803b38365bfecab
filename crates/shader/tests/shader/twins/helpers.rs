//! What twins share, where models do not reach all of it: numbers beyond their ranges, pairs from cosines alone.

use glanz_bsdf::{DirectionPair, wgsl};
use glanz_math::{Exponent, Real, Vec3};

use super::cases::random_place;
use super::{FIRST, Place, same, shader, values};
use crate::common::{self, Numbers};

/// Finite numbers of all sizes and signs, and NaN.
fn awkward() -> Vec<f32> {
    let mut numbers = Numbers(3);
    let mut all = vec![0.0, -0.0, 1.0, -1.0, 2.0, 1.0 + f32::EPSILON, 1e-40, 1e30, f32::NAN];
    // Where a power of 100 becomes 0.
    all.extend((0..100).map(|i| 0.5 + (i - 50) as f32 * 1e-7));
    all.extend((0..20_000).map(|_| 4.0 * numbers.unit() - 2.0));
    all
}

/// Holds an expression of `x` in WGSL to a function.
fn holds(expression: &str, numbers: &[f32], expected: impl Fn(f32) -> f32) {
    let text = shader(&wgsl::text(wgsl::twins()), "0.0")
        + &format!("fn value_of(x: f32) -> f32 {{ return {expression}; }}");
    let xs: Vec<_> = awkward().into_iter().map(|x| [x]).collect();
    for (got, [x]) in values(&common::wgsl(&text), numbers, &xs).into_iter().zip(&xs) {
        assert!(same(got, expected(*x)), "{expression} of {x:e}: {got:e} for {:e}", expected(*x));
    }
}

#[test]
fn numbers_are_those_of_real() {
    holds("real_acos(x)", &[], Real::acos);
    for n in [0.0, 0.5, 1.0, 31.5, 100.0, 1e5] {
        holds(&format!("real_pow(x, {n:?})"), &[], |x| Real::pow(x, n));
    }
    for n in (0..=130).map(f64::from).chain([0.5, 7.25]) {
        let exponent = Exponent::new(n);
        holds(&format!("power(x, exponent_at({FIRST}u))"), &exponent.numbers(), |x| x.power(&exponent));
    }
}

/// Holds an expression of a pair in WGSL to a function.
fn holds_of_pairs(expression: &str, expected: impl Fn(&Place) -> f32) {
    let program = common::wgsl(&shader(&wgsl::text(wgsl::twins()), expression));
    let mut numbers = Numbers(9);
    let places: Vec<_> = (0..20_000).map(|_| random_place(&mut numbers)).collect();
    let inputs: Vec<_> = places.iter().map(Place::inputs).collect();
    for (got, place) in values(&program, &[], &inputs).into_iter().zip(&places) {
        assert!(same(got, expected(place)), "{expression} at {place:?}: {got:e} for {:e}", expected(place));
    }
}

#[test]
fn pairs_are_those_of_rust() {
    holds_of_pairs("pair.cos_o", |place| place.pair().cos_o);
    holds_of_pairs("pair.cos_i", |place| place.pair().cos_i);
    holds_of_pairs("pair.cos_io", |place| place.pair().cos_io);
    holds_of_pairs("pair.half2", |place| place.pair().half2);
    holds_of_pairs("pair.tangent_o.y - pair.tangent_i.x", |place| place.wo.y - place.wi.x);
    holds_of_pairs("pair_cos_mirror(pair)", |place| place.pair().cos_mirror());
    holds_of_pairs("pair_cos_half(pair)", |place| place.pair().cos_half());
    holds_of_pairs("pair_cos_view_half(pair)", |place| place.pair().cos_view_half());
    let up = Vec3::new(0.6, 0.0, 0.8);
    holds_of_pairs("pair_between(0.5, vec3<f32>(0.6, 0.0, 0.8), 0.25, wi).half2", |place| {
        DirectionPair::between((0.5, up), (0.25, place.wi)).half2
    });
    holds_of_pairs("pair_isotropic(wo.z, wi.z, wo.x).half2", |place| {
        DirectionPair::isotropic(place.wo.z, place.wi.z, place.wo.x).half2
    });
}
