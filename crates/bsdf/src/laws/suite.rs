//! The tests of every model of the list: its verdicts over its range of parameters must be those that its `INFO` claims.
//!
//! An exempt model must be found to break the law in fact, so that an exemption that is no longer needed is found. Where
//! a law says nothing of a model, the test is that its verdict is "not applicable", with the reason.

use glanz_math::Vec3;

use super::judges::limits::{NEVER_LAMBERT, NEVER_NARROW, REFRACTED};
use super::judges::normalization::NO_FACETS;
use super::subject::{NO_DIRECTION, SINGLE_DIRECTION};
use super::{Finding, Law, Verdict, judge};
use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamError, ParamInfo, Shape};

/// Corners of the box of parameters that are tried.
const CORNERS: usize = 8;

macro_rules! suite {
    ($model:ty) => {
        use crate::Model as _;
        use crate::laws::{Law, suite};

        #[test]
        fn says_what_it_is() {
            suite::says_what_it_is(&<$model>::INFO);
        }
        #[test]
        fn derives_all_again_when_a_parameter_is_set() {
            suite::sets_parameters::<$model>();
        }
        #[test]
        fn is_reciprocal_unless_it_is_exempt() {
            suite::keeps(Law::Reciprocity, &<$model>::INFO);
        }
        #[test]
        fn conserves_energy_unless_it_is_exempt() {
            suite::keeps(Law::Energy, &<$model>::INFO);
        }
        #[test]
        fn is_nowhere_negative() {
            suite::keeps(Law::Positivity, &<$model>::INFO);
        }
        #[test]
        fn is_black_for_light_on_the_wrong_side() {
            suite::keeps(Law::Side, &<$model>::INFO);
        }
        #[test]
        fn is_finite_everywhere() {
            suite::keeps(Law::Grazing, &<$model>::INFO);
        }
        #[test]
        fn has_a_normalized_distribution_if_it_is_made_of_facets() {
            suite::keeps(Law::Normalization, &<$model>::INFO);
        }
        #[test]
        fn becomes_a_mirror_or_lambert_at_the_end_of_a_parameter() {
            suite::keeps(Law::Limits, &<$model>::INFO);
        }
        #[test]
        fn agrees_in_f32_and_f64() {
            suite::keeps(Law::Precision, &<$model>::INFO);
        }
        #[test]
        fn gives_the_same_bits_in_16_lanes() {
            suite::keeps(Law::Lanes, &<$model>::INFO);
        }
    };
}
pub(crate) use suite;

/// Asserts that the verdicts of a law are those that the model's description claims.
pub(crate) fn keeps(law: Law, info: &ModelInfo) {
    // The ends of all parameters are what the law of limits looks for itself.
    let shapes = if law == Law::Limits { vec![default(info)] } else { shapes(info) };
    let findings: Vec<_> = shapes.iter().map(|shape| judge(law, shape)).collect();
    let told = |finding: &&Finding| {
        let index = findings.iter().position(|other| core::ptr::eq(other, *finding));
        format!("{:?}: {finding}", index.map(|index| shapes[index].params()))
    };
    if let Some(reason) = silent(law, info) {
        let other = findings.iter().find(|finding| finding.verdict != Verdict::NotApplicable(reason));
        assert!(
            other.is_none(),
            "must not apply since {reason}; {}",
            other.as_ref().map_or(String::new(), told)
        );
        return;
    }
    let broken: Vec<_> = findings.iter().filter(|finding| finding.is_broken()).collect();
    if info.exempt.iter().any(|(exempt, _)| *exempt == law) {
        assert!(!broken.is_empty(), "is exempt from {}, but keeps it", law.name());
        return;
    }
    assert!(broken.is_empty(), "{}", broken.iter().map(told).collect::<Vec<_>>().join("\n"));
    let judged = |finding: &Finding| match finding.verdict {
        Verdict::NotApplicable(reason) => {
            law == Law::Limits && [NEVER_LAMBERT, NEVER_NARROW].contains(&reason)
        }
        _ => true,
    };
    let other = findings.iter().find(|finding| !judged(finding));
    assert!(other.is_none(), "{}", other.as_ref().map_or(String::new(), told));
}

/// Why a law says nothing of a model, after its description; none if it must be judged.
fn silent(law: Law, info: &ModelInfo) -> Option<&'static str> {
    let directional = matches!(law, Law::Reciprocity | Law::Energy | Law::Side | Law::Limits);
    let without_direction = matches!(info.term, LightTerm::Ambient | LightTerm::Emission);
    let facets = || default(info).distribution(Vec3::new(0.0, 0.0, 1.0)).is_some();
    match law {
        Law::Positivity => None,
        Law::Normalization => (!facets()).then_some(NO_FACETS),
        _ if directional && without_direction => Some(NO_DIRECTION),
        _ if info.delta => Some(SINGLE_DIRECTION),
        Law::Limits if info.side == crate::Side::Transmission => Some(REFRACTED),
        _ => None,
    }
}

fn default(info: &ModelInfo) -> Shape {
    Shape::named(info.name, &[]).expect("a name from the list")
}

/// Shapes over the ranges of the parameters. Of one parameter a row of values; of several the default, one parameter at a
/// time over a row of values, and corners of the box, at most [`CORNERS`].
fn shapes(info: &ModelInfo) -> Vec<Shape> {
    let params = info.params;
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
    let shape = |list: &[f64]| {
        let set: Vec<_> = params.iter().map(|param| param.name).zip(list.iter().copied()).collect();
        Shape::named(info.name, &set).expect("parameters within their ranges")
    };
    (0..lists.len()).filter(|i| !repeated(*i)).map(|i| shape(&lists[i])).collect()
}

/// Asserts that a model made by setting one parameter of another is in every value the one that is built from the start, and
/// that a value out of range is an error that names the parameter and its range.
pub(crate) fn sets_parameters<M: Model + PartialEq + core::fmt::Debug>() {
    let info = &M::INFO;
    for start in shapes(info) {
        let model = M::from_params(&start.params());
        for (i, param) in info.params.iter().enumerate() {
            for fraction in [0.0, 0.3, 1.0] {
                let value = param.min + fraction * (param.max - param.min);
                let mut values = start.params();
                values[i] = value;
                let names = info.params.iter().map(|param| param.name);
                let named: Vec<_> = names.zip(values.iter().copied()).collect();
                let (set, built) = (model.with(param.name, value).unwrap(), M::with_params(&named).unwrap());
                assert_eq!((set.get(param.name), set.params()), (Some(value), values));
                assert_eq!(set, built);
                let (set_shape, shape) =
                    (start.with(param.name, value).unwrap(), Shape::named(info.name, &named).unwrap());
                assert_eq!((set_shape.get(param.name), &set_shape), (Some(value), &shape));
                gives_the_same(&set, &shape);
            }
            for value in [param.min - 1.0, param.max * 1.01 + 1.0, f64::NAN] {
                let error = model.with(param.name, value).unwrap_err();
                let text = error.to_string();
                for part in [param.name.to_owned(), param.min.to_string(), param.max.to_string()] {
                    assert!(text.contains(&part), "{text}");
                }
                assert_eq!(start.with(param.name, value).unwrap_err().to_string(), text);
                assert!(matches!(error, ParamError::OutOfRange { .. }));
            }
        }
        assert_eq!((model.get("no such parameter"), start.get("no such parameter")), (None, None));
        assert!(matches!(model.with("no such parameter", 0.0), Err(ParamError::UnknownParam { .. })));
    }
}

/// Asserts that a model and a shape are the same functions, to the last bit.
fn gives_the_same<M: Model>(model: &M, shape: &Shape) {
    for pair in pairs() {
        let (a, b): (f64, f64) = (model.f_cos(&pair), shape.f_cos(&pair));
        assert_eq!(a.to_bits(), b.to_bits(), "{:?}", shape.params());
        assert_eq!(model.tint_cosine(&pair).to_bits(), shape.tint_cosine(&pair).to_bits());
        assert_eq!(model.shadowing(&pair), shape.shadowing(&pair));
    }
    let up = Vec3::from_angles(0.3, 1.0);
    assert_eq!(model.distribution(up), shape.distribution(up));
    assert_eq!((model.eta(), model.is_anisotropic()), (shape.eta(), shape.is_anisotropic()));
}

/// Pairs in the lobes of models, reflected and transmitted.
fn pairs() -> Vec<DirectionPair<f64>> {
    let wo = Vec3::from_angles(0.7, 0.3);
    let to = |theta, phi| DirectionPair::new(wo, Vec3::from_angles(theta, phi));
    vec![to(0.65, 3.4), to(0.2, 1.0), to(1.5, 3.5), to(2.7, 3.4), to(2.44, 3.44), to(0.7, 0.3)]
}

/// Asserts that the description is complete and that parameters are kept as they are given.
pub(crate) fn says_what_it_is(info: &ModelInfo) {
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
    for shape in shapes(info) {
        let values = shape.params();
        assert_eq!(values.len(), info.params.len());
        let set: Vec<_> = info.params.iter().map(|param| param.name).zip(values).collect();
        assert_eq!(Shape::named(info.name, &set).unwrap(), shape);
    }
}
