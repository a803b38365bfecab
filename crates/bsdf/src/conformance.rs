//! The laws, instantiated for every model by the list.
//!
//! A model opts out of a law in `INFO.exempt`, with a reason. The suite then asks that the law is
//! broken in fact, so that an exemption that is no longer needed is found.

use glanz_math::{Lanes, PI, Real, Vec3, at_level, simd_level};

use crate::albedo::directional;
use crate::{Law, Model, Pair, Part, Shape};

/// How far both sides of the law of reciprocity may differ, in parts of the greater one: a few
/// units of the last place, since the same products are formed in another order.
const RECIPROCITY_F64: f64 = 1e-12;
/// The same in `f32`, whose last place is 6e-8, after a power that multiplies errors.
const RECIPROCITY_F32: f64 = 1e-5;
/// What the quadrature may add to an albedo of exactly 1 (see `albedo`).
const ENERGY: f64 = 2e-4;
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
        fn is_dark_where_the_light_is_below() {
            crate::conformance::is_dark_where_the_light_is_below::<$model>();
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

/// Every combination of a few values of each parameter, the extremes and the default among them.
fn instances<M: Model>() -> Vec<M> {
    let mut lists = vec![Vec::new()];
    for param in M::INFO.params {
        let range = param.max - param.min;
        let mut values: Vec<f64> =
            [0.0, 5e-6, 1e-5, 5e-5, 1e-3, 1.0].iter().map(|t| param.min + t * range).collect();
        values.push(param.default);
        let extended = |list: &Vec<f64>| {
            let list = list.clone();
            values.iter().map(move |v| [list.clone(), vec![*v]].concat()).collect::<Vec<_>>()
        };
        lists = lists.iter().flat_map(extended).collect();
    }
    lists.iter().map(|values| M::from_params(values)).collect()
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
    !matches!(M::INFO.part, Part::Ambient | Part::Emission)
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
    let lit = |(wo, wi): &(Vec3<f64>, Vec3<f64>)| wo.z > 0.0 && wi.z > 0.0;
    for model in instances::<M>() {
        for (wo, wi) in pairs().into_iter().filter(lit) {
            worst.0 = worst.0.max(asymmetry(&model, wo, wi));
            worst.1 = worst.1.max(f64::from(asymmetry(&model, short(wo), short(wi))));
        }
    }
    let broken = worst.0 > RECIPROCITY_F64 || worst.1 > RECIPROCITY_F32;
    assert_eq!(broken, exempt::<M>(Law::Reciprocity), "both ways differ by {worst:?} (f64, f32)");
}

/// |f(wo, wi) − f(wi, wo)| in parts of the greater, both sides multiplied with both cosines.
fn asymmetry<M: Model, R: Real>(model: &M, wo: Vec3<R>, wi: Vec3<R>) -> R {
    let there = model.f_cos(&Pair::new(wo, wi)) * wo.z;
    let back = model.f_cos(&Pair::new(wi, wo)) * wi.z;
    (there - back).abs() / there.max(back).max(there.lit(1e-20))
}

pub(crate) fn keeps_energy_unless_it_says_so<M: Model>() {
    let mut worst: (f64, String) = (0.0, String::new());
    for model in instances::<M>() {
        for degrees in [0.0, 20.0, 45.0, 70.0, 89.0] {
            let albedo = directional(libm::cos(degrees * PI / 180.0), |pair| model.f_cos(pair));
            if albedo > worst.0 {
                worst = (albedo, format!("{:?} at {degrees}°", model.params()));
            }
        }
    }
    let broken = worst.0 > 1.0 + ENERGY;
    assert_eq!(broken, exempt::<M>(Law::Energy), "the greatest albedo is {} for {}", worst.0, worst.1);
}

pub(crate) fn is_finite_and_positive_everywhere<M: Model>() {
    for model in instances::<M>() {
        for (wo, wi) in pairs() {
            let long = model.f_cos(&Pair::new(wo, wi));
            let short = model.f_cos(&Pair::new(short(wo), short(wi)));
            let fine = long.is_finite() && long >= 0.0 && short.is_finite() && short >= 0.0;
            assert!(fine, "{:?} for {wo:?} and {wi:?}: {long}, in f32 {short}", model.params());
        }
    }
}

pub(crate) fn is_dark_where_the_light_is_below<M: Model>() {
    let mut seen = 0;
    for model in instances::<M>() {
        for (wo, wi) in pairs().into_iter().filter(|(_, wi)| wi.z <= 0.0) {
            let values =
                [model.f_cos(&Pair::new(wo, wi)), f64::from(model.f_cos(&Pair::new(short(wo), short(wi))))];
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

/// An `f32` value must be an `f64` value for cosines no further off than `f32` rounds them, give or
/// take 1e-5 of it.
pub(crate) fn agrees_in_f32_and_f64<M: Model>() {
    const STEPS: [f64; 3] = [-COSINE_F32, 0.0, COSINE_F32];
    let clear = |(_, wi): &(Vec3<f64>, Vec3<f64>)| wi.z.abs() > 1e-4;
    for model in instances::<M>() {
        for (wo, wi) in pairs().into_iter().filter(clear) {
            let pair = Pair::new(wo, wi);
            let (mut low, mut high) = (f64::MAX, 0.0_f64);
            for io in STEPS {
                for i in STEPS {
                    let mut near = pair;
                    near.cos_io += io;
                    near.cos_i += i;
                    let value = model.f_cos(&near);
                    (low, high) = (low.min(value), high.max(value));
                }
            }
            let got = f64::from(model.f_cos(&Pair::new(short(wo), short(wi))));
            let fits = got >= low * (1.0 - 1e-5) - 1e-20 && got <= high * (1.0 + 1e-5) + 1e-20;
            assert!(fits, "{:?} for {wo:?} and {wi:?}: {got} not in {low} … {high}", model.params());
        }
    }
}

pub(crate) fn gives_the_same_bits_in_16_lanes<M: Model>() {
    let pairs = pairs();
    for model in instances::<M>() {
        for sixteen in pairs.chunks_exact(16) {
            let plane = |get: &dyn Fn(&Pair<f32>) -> f32| -> [f32; 16] {
                core::array::from_fn(|i| get(&Pair::new(short(sixteen[i].0), short(sixteen[i].1))))
            };
            let cosines = [plane(&|p| p.cos_o), plane(&|p| p.cos_i), plane(&|p| p.cos_io)];
            let tangents = [
                plane(&|p| p.tangent_o.0),
                plane(&|p| p.tangent_o.1),
                plane(&|p| p.tangent_i.0),
                plane(&|p| p.tangent_i.1),
            ];
            for name in ["scalar", "sse2", "avx2", "avx512", "neon", "simd128"] {
                let Ok(level) = simd_level(Some(name)) else { continue };
                let mut wide = [0.0; 16];
                at_level!(level, simd => {
                    let [cos_o, cos_i, cos_io] = cosines.map(|c| Lanes::load(simd, &c));
                    let [ox, oy, ix, iy] = tangents.map(|t| Lanes::load(simd, &t));
                    let widening = cos_o.one();
                    let pair = Pair { cos_o, cos_i, cos_io, tangent_o: (ox, oy), tangent_i: (ix, iy), widening };
                    model.f_cos(&pair).store(&mut wide);
                });
                for (i, got) in wide.iter().enumerate() {
                    let expected = model.f_cos(&Pair::new(short(sixteen[i].0), short(sixteen[i].1)));
                    assert_eq!(got.to_bits(), expected.to_bits(), "{name}, lane {i}: {got}, {expected}");
                }
            }
        }
    }
}
