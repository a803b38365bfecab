//! The laws, instantiated for every model by the list.
//!
//! A model opts out of a law in `INFO.exempt`, with a reason. The suite then asks that the law is
//! broken in fact, so that an exemption that is no longer needed is found.

use glanz_math::{Lanes, PI, Real, SimdLevel, Vec3, at_level};

use crate::albedo::directional;
use crate::{DirectionPair, Law, LightTerm, Model, ParamInfo, Shape, Side};

/// How far both sides of the law of reciprocity may differ, in parts of the greater one: a few
/// units of the last place, since the same products are formed in another order.
const RECIPROCITY_F64: f64 = 1e-12;
/// The same in `f32`, whose last place is 6e-8, after a power that multiplies errors.
const RECIPROCITY_F32: f64 = 1e-5;
/// What the quadrature may add to an albedo of exactly 1 (see `albedo`).
const ENERGY: f64 = 2e-4;
/// An angle of view, in degrees, at which faults of the horizon show.
const FLAT: f64 = 89.99;
/// What the quadrature may add to the albedo there: 0.01 of the narrowest lobes, and as much again.
const ENERGY_FLAT: f64 = 0.02;
/// Corners of the box of parameters that are tried.
const CORNERS: usize = 8;
/// Rounding of a cosine formed in `f64` from three products.
const COSINE_F64: f64 = 5e-16;
/// Rounding of a cosine formed in `f32` from three products.
const COSINE_F32: f64 = 3e-7;

macro_rules! suite {
    ($model:ty) => {
        #[test]
        fn says_what_it_is() {
            crate::conformance::says_what_it_is::<$model>();
        }
        #[test]
        fn is_reciprocal_unless_it_says_so() {
            crate::conformance::is_reciprocal_unless_it_says_so::<$model>();
        }
        #[test]
        fn keeps_energy_unless_it_says_so() {
            crate::conformance::keeps_energy_unless_it_says_so::<$model>();
        }
        #[test]
        fn is_finite_and_positive_everywhere() {
            crate::conformance::is_finite_and_positive_everywhere::<$model>();
        }
        #[test]
        fn is_dark_where_the_light_is_on_the_wrong_side() {
            crate::conformance::is_dark_where_the_light_is_on_the_wrong_side::<$model>();
        }
        #[test]
        fn agrees_in_f32_and_f64() {
            crate::conformance::agrees_in_f32_and_f64::<$model>();
        }
        #[test]
        fn gives_the_same_bits_in_16_lanes() {
            crate::conformance::gives_the_same_bits_in_16_lanes::<$model>();
        }
    };
}
pub(crate) use suite;

/// Models over the ranges of the parameters. Of one parameter a row of values; of several the default, one
/// parameter at a time over a row of values, and corners of the box, at most [`CORNERS`].
fn instances<M: Model>() -> Vec<M> {
    let params = M::INFO.params;
    let default: Vec<f64> = params.iter().map(|p| p.default).collect();
    let fractions: &[f64] = match params.len() {
        1 => &[0.0, 5e-6, 1e-5, 5e-5, 1e-3, 0.05, 0.3, 1.0],
        _ => &[0.0, 1e-3, 0.1, 0.4, 1.0],
    };
    let mut lists = vec![default.clone()];
    for (i, param) in params.iter().enumerate() {
        let value = |t: &f64| param.min + t * (param.max - param.min);
        let varied = fractions.iter().map(|t| {
            let mut list = default.clone();
            list[i] = value(t);
            list
        });
        lists.extend(varied);
    }
    if params.len() > 1 {
        // Steps of 5/8 of all corners come to every one of them before any comes twice.
        let all = 1_usize << params.len().min(16);
        let step = (all * 5 / 8) | 1;
        let corner = |n: usize| {
            let bits = n * step % all;
            let end = |(i, p): (usize, &ParamInfo)| if bits >> i & 1 == 1 { p.max } else { p.min };
            params.iter().enumerate().map(end).collect::<Vec<_>>()
        };
        lists.extend((0..all.min(CORNERS)).map(corner));
    }
    let repeated = |i: usize| lists[..i].contains(&lists[i]);
    (0..lists.len()).filter(|i| !repeated(*i)).map(|i| M::from_params(&lists[i])).collect()
}

/// Directions over the whole sphere: all quarters, the pole, the horizon and a hair off both.
fn directions() -> Vec<Vec3<f64>> {
    let degrees = [0.0, 1e-4, 12.0, 30.0, 45.0, 60.0, 75.0, 89.0, 89.999, 90.0, 90.001, 120.0, 180.0];
    let around = [0.0, 37.0, 90.0, 179.0, 180.0, 261.0];
    let radians = PI / 180.0;
    let ring = |t: f64| around.map(move |p| Vec3::from_angles(t * radians, p * radians));
    let mut all: Vec<_> = degrees.iter().flat_map(|t| ring(*t)).collect();
    // Rounding leaves 6e-17 for the cosine of 90 degrees; these lie in the plane exactly.
    all.extend([Vec3::new(1.0, 0.0, 0.0), Vec3::new(-1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)]);
    all
}

/// All pairs of view and light, opposite and equal ones among them.
fn pairs() -> Vec<(Vec3<f64>, Vec3<f64>)> {
    let all = directions();
    let with = |wo: Vec3<f64>| all.iter().map(move |wi| (wo, *wi));
    let mut pairs: Vec<_> = all.iter().flat_map(|wo| with(*wo)).collect();
    pairs.extend(all.iter().map(|w| (*w, -*w)));
    pairs
}

fn short(v: Vec3<f64>) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}

/// Whether the lobe answers to light from a direction.
fn is_lit<M: Model>() -> bool {
    !matches!(M::INFO.term, LightTerm::Ambient | LightTerm::Emission)
}

fn exempt<M: Model>(law: Law) -> bool {
    M::INFO.exempt.iter().any(|(exempt, _)| *exempt == law)
}

pub(crate) fn says_what_it_is<M: Model>() {
    let info = M::INFO;
    assert!(info.name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'));
    for text in [info.name, info.title, info.formula, info.source] {
        assert!(!text.trim().is_empty());
    }
    assert_eq!(crate::MODELS.iter().filter(|other| other.name == info.name).count(), 1);
    for (i, param) in info.params.iter().enumerate() {
        assert!(param.min < param.max && (param.min..=param.max).contains(&param.default), "{}", param.name);
        assert!(!param.symbol.is_empty() && !param.doc.is_empty(), "{}", param.name);
        assert!(info.params[..i].iter().all(|other| other.name != param.name), "{} twice", param.name);
        let inside = 0.25 * param.min + 0.75 * param.max;
        let shape = Shape::named(info.name, &[(param.name, inside)]).unwrap();
        assert_eq!(shape.params()[i], inside);
        for outside in [param.min - 1.0, param.max * 1.01 + 1.0, f64::NAN] {
            assert!(Shape::named(info.name, &[(param.name, outside)]).is_err());
        }
    }
    for (_, reason) in info.exempt {
        assert!(reason.len() > 10, "an exemption wants a reason");
    }
    for model in instances::<M>() {
        let values = model.params();
        assert_eq!(values.len(), info.params.len());
        assert_eq!(M::from_params(&values).params(), values);
    }
}

pub(crate) fn is_reciprocal_unless_it_says_so<M: Model>() {
    let mut worst: (f64, f64) = (0.0, 0.0);
    for model in instances::<M>() {
        let back = reversed(&model);
        for (wo, wi) in pairs().into_iter().filter(|(wo, wi)| wo.z > 0.0 && right_side::<M>(wi.z)) {
            worst.0 = worst.0.max(asymmetry((&model, &back), wo, wi, COSINE_F64));
            worst.1 = worst.1.max(asymmetry((&model, &back), short(wo), short(wi), COSINE_F32));
        }
    }
    let broken = worst.0 > RECIPROCITY_F64 || worst.1 > RECIPROCITY_F32;
    assert_eq!(broken, exempt::<M>(Law::Reciprocity), "both ways differ by {worst:?} (f64, f32)");
}

/// Whether light from the height `z` is on the side that the model answers to.
fn right_side<M: Model>(z: f64) -> bool {
    if M::INFO.side == Side::Transmission { z < 0.0 } else { z > 0.0 }
}

/// The model of the same surface turned over: the parameter `eta`, below over above, becomes its inverse.
fn reversed<M: Model>(model: &M) -> M {
    let mut values = model.params();
    for (value, param) in values.iter_mut().zip(M::INFO.params) {
        if param.name == "eta" {
            *value = 1.0 / *value;
        }
    }
    M::from_params(&values)
}

/// |f(wo, wi) η_i² − f(wi, wo) η_o²| in parts of the greater, both sides multiplied with both cosines.
///
/// Light that passes through is seen by turning the surface over. Where it is refracted, the half vector is formed
/// from other numbers both ways, so that what a rounding of the cosines does is no difference.
fn asymmetry<M: Model, R: Real + Into<f64>>(
    (model, back): (&M, &M),
    wo: Vec3<R>,
    wi: Vec3<R>,
    rounding: f64,
) -> f64 {
    let over = |w: Vec3<R>| Vec3::new(w.x, w.y, -w.z);
    let swapped = match M::INFO.side {
        Side::Reflection => DirectionPair::new(wi, wo),
        Side::Transmission => DirectionPair::new(over(wi), over(wo)),
    };
    let eta2 = model.eta() * model.eta();
    let there = model.f_cos(&DirectionPair::new(wo, wi)).into() * wo.z.abs().into() * eta2;
    let again = back.f_cos(&swapped).into() * wi.z.abs().into();
    let slack = if model.eta() == 1.0 {
        0.0
    } else {
        let (low, high) = around(model, &long(&DirectionPair::new(wo, wi)), rounding);
        (high - low) * wo.z.abs().into() * eta2
    };
    ((there - again).abs() - slack).max(0.0) / there.max(again).max(1e-20)
}

/// The same pair in `f64`.
fn long<R: Real + Into<f64>>(pair: &DirectionPair<R>) -> DirectionPair<f64> {
    DirectionPair {
        cos_o: pair.cos_o.into(),
        cos_i: pair.cos_i.into(),
        cos_io: pair.cos_io.into(),
        tangent_o: (pair.tangent_o.0.into(), pair.tangent_o.1.into()),
        tangent_i: (pair.tangent_i.0.into(), pair.tangent_i.1.into()),
        alpha_scale: pair.alpha_scale.into(),
    }
}

/// The least and the greatest value for coordinates that differ by at most `rounding` from the pair's: every
/// coordinate is moved both ways, then all together the ways in which the value fell, or rose.
fn around<M: Model>(model: &M, pair: &DirectionPair<f64>, rounding: f64) -> (f64, f64) {
    type Coordinate = fn(&mut DirectionPair<f64>) -> &mut f64;
    const COORDINATES: [Coordinate; 7] = [
        |p| &mut p.cos_o,
        |p| &mut p.cos_i,
        |p| &mut p.cos_io,
        |p| &mut p.tangent_o.0,
        |p| &mut p.tangent_o.1,
        |p| &mut p.tangent_i.0,
        |p| &mut p.tangent_i.1,
    ];
    let read = if M::INFO.anisotropic { 7 } else { 3 };
    let at = model.f_cos(pair);
    let (mut low, mut high) = (at, at);
    let (mut falling, mut rising) = (*pair, *pair);
    for coordinate in &COORDINATES[..read] {
        let moved = |step: f64| {
            let mut near = *pair;
            *coordinate(&mut near) += step;
            model.f_cos(&near)
        };
        let (less, more) = (moved(-rounding), moved(rounding));
        low = low.min(less).min(more);
        high = high.max(less).max(more);
        let up = if more > less { rounding } else { -rounding };
        *coordinate(&mut rising) += up;
        *coordinate(&mut falling) -= up;
    }
    (low.min(model.f_cos(&falling)), high.max(model.f_cos(&rising)))
}

pub(crate) fn keeps_energy_unless_it_says_so<M: Model>() {
    let mut worst: (f64, String) = (0.0, String::new());
    let views: &[(f64, &[f64])] = match M::INFO.anisotropic {
        true => &[
            (0.0, &[0.0]),
            (45.0, &[0.0, 50.0, 90.0]),
            (75.0, &[0.0, 90.0]),
            (89.0, &[0.0, 50.0, 90.0]),
            (89.99, &[0.0, 90.0]),
        ],
        false => {
            &[(0.0, &[0.0]), (20.0, &[0.0]), (45.0, &[0.0]), (70.0, &[0.0]), (89.0, &[0.0]), (89.99, &[0.0])]
        }
    };
    // So flat, the quadrature finds a fault but proves no virtue: it is for lobes that say that they have one.
    let flat: &[(f64, &[f64])] = if exempt::<M>(Law::Energy) { &[(FLAT, &[0.0])] } else { &[] };
    for model in instances::<M>() {
        for (degrees, azimuths) in views.iter().chain(flat) {
            for azimuth in *azimuths {
                let view = (libm::cos(degrees * PI / 180.0), azimuth * PI / 180.0);
                let radiance = directional(&M::INFO, model.eta(), view, |pair| model.f_cos(pair));
                let slack = if *degrees == FLAT { ENERGY_FLAT } else { 0.0 };
                let albedo = radiance * model.eta() * model.eta() - slack;
                if albedo > worst.0 {
                    worst = (albedo, format!("{:?} at {degrees}°, azimuth {azimuth}°", model.params()));
                }
            }
        }
    }
    let broken = worst.0 > 1.0 + ENERGY;
    assert_eq!(broken, exempt::<M>(Law::Energy), "the greatest albedo is {} for {}", worst.0, worst.1);
}

pub(crate) fn is_finite_and_positive_everywhere<M: Model>() {
    for model in instances::<M>() {
        for (wo, wi) in pairs() {
            let long = model.f_cos(&DirectionPair::new(wo, wi));
            let short = model.f_cos(&DirectionPair::new(short(wo), short(wi)));
            let fine = long.is_finite() && long >= 0.0 && short.is_finite() && short >= 0.0;
            assert!(fine, "{:?} for {wo:?} and {wi:?}: {long}, in f32 {short}", model.params());
            assert!(!M::INFO.delta || long == 0.0, "a lobe without width answers to no light");
        }
    }
}

pub(crate) fn is_dark_where_the_light_is_on_the_wrong_side<M: Model>() {
    let mut seen = 0;
    for model in instances::<M>() {
        for (wo, wi) in pairs().into_iter().filter(|(_, wi)| !right_side::<M>(wi.z)) {
            let values = [
                model.f_cos(&DirectionPair::new(wo, wi)),
                f64::from(model.f_cos(&DirectionPair::new(short(wo), short(wi)))),
            ];
            if is_lit::<M>() {
                assert_eq!(values, [0.0; 2], "{:?} for {wo:?} and {wi:?}", model.params());
            } else {
                assert!(values[0] > 0.0, "light without direction comes from everywhere");
            }
            seen += 1;
        }
    }
    assert!(seen > 100);
}

/// An `f32` value must be an `f64` value for cosines and tangents no further off than `f32` rounds them, give
/// or take 1e-5 of it. Of a narrow lobe the rounding of a cosine is a good part of the width; that, and no more,
/// is what widens the range.
pub(crate) fn agrees_in_f32_and_f64<M: Model>() {
    let clear = |(_, wi): &(Vec3<f64>, Vec3<f64>)| wi.z.abs() > 1e-4;
    for model in instances::<M>() {
        for (wo, wi) in pairs().into_iter().filter(clear) {
            let (low, high) = around(&model, &DirectionPair::new(wo, wi), COSINE_F32);
            let got = f64::from(model.f_cos(&DirectionPair::new(short(wo), short(wi))));
            let fits = got >= low * (1.0 - 1e-5) - 1e-20 && got <= high * (1.0 + 1e-5) + 1e-20;
            assert!(fits, "{:?} for {wo:?} and {wi:?}: {got} not in {low} … {high}", model.params());
        }
    }
}

pub(crate) fn gives_the_same_bits_in_16_lanes<M: Model>() {
    let pairs = pairs();
    for model in instances::<M>() {
        for sixteen in pairs.chunks_exact(16) {
            let plane = |get: &dyn Fn(&DirectionPair<f32>) -> f32| -> [f32; 16] {
                core::array::from_fn(|i| get(&DirectionPair::new(short(sixteen[i].0), short(sixteen[i].1))))
            };
            let cosines = [plane(&|p| p.cos_o), plane(&|p| p.cos_i), plane(&|p| p.cos_io)];
            let tangents = [
                plane(&|p| p.tangent_o.0),
                plane(&|p| p.tangent_o.1),
                plane(&|p| p.tangent_i.0),
                plane(&|p| p.tangent_i.1),
            ];
            for name in ["scalar", "sse2", "avx2", "avx512", "neon", "simd128"] {
                let Ok(level) = SimdLevel::named(name) else { continue };
                let mut wide = [0.0; 16];
                at_level!(level, simd => {
                    let [cos_o, cos_i, cos_io] = cosines.map(|c| Lanes::load(simd, &c));
                    let [ox, oy, ix, iy] = tangents.map(|t| Lanes::load(simd, &t));
                    let alpha_scale = cos_o.one();
                    let pair = DirectionPair { cos_o, cos_i, cos_io, tangent_o: (ox, oy), tangent_i: (ix, iy), alpha_scale };
                    model.f_cos(&pair).store(&mut wide);
                });
                for (i, got) in wide.iter().enumerate() {
                    let expected = model.f_cos(&DirectionPair::new(short(sixteen[i].0), short(sixteen[i].1)));
                    assert_eq!(got.to_bits(), expected.to_bits(), "{name}, lane {i}: {got}, {expected}");
                }
            }
        }
    }
}
