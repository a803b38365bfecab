//! Every law finds what is deliberately broken, and passes what is not.

use glanz_math::{PI, Real, Vec3};

use super::hemisphere::{by_angles, integral};
use super::*;
use crate::{DirectionPair, LightTerm, ModelInfo, ParamInfo, Shape, Side};

/// What is wrong with a lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    Nothing,
    OneWay,
    TooBright,
    BrightAtGrazing,
    Negative,
    Through,
    NotANumber,
    NotANumberInF32,
    NegativeInF32,
    OneWayInF32,
    OneLane,
    ThinFacets,
    Askew,
    Imprecise,
}

/// A Phong lobe times cosine, with a fault.
#[derive(Clone, Copy)]
struct Broken {
    fault: Fault,
    shininess: f64,
}

const SHARP: ParamInfo =
    ParamInfo { name: "shininess", symbol: "n", doc: "exponent", min: 1.0, max: 1e5, default: 10.0 };
const INFO: ModelInfo = ModelInfo {
    name: "broken",
    title: "A lobe with a fault",
    formula: "(R·wo)ⁿ cosθi",
    source: "a test",
    params: &[SHARP],
    term: LightTerm::Specular,
    side: Side::Reflection,
    anisotropic: false,
    delta: false,
    operations: 0,
    exempt: &[(Law::Energy, "it glows, and says so")],
};

/// The cosine to a direction 5° and more nearer to the normal than the mirror direction.
fn askew<R: Real>(pair: &DirectionPair<R>) -> R {
    let lift = pair.cos_i.lit(0.2);
    let length = (pair.cos_i.one() + lift.sqr() + (lift + lift) * pair.cos_o).sqrt();
    (pair.cos_mirror() + lift * pair.cos_i) / length
}

impl Broken {
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let lobe = |cosine: R| cosine.max(zero).pow(zero.lit(self.shininess));
        let scale = zero.lit((self.shininess + 2.0) / (2.0 * PI));
        let value = lobe(pair.cos_mirror()) * scale * pair.cos_i;
        let value = match self.fault {
            Fault::OneWay => value * pair.cos_i,
            Fault::TooBright => value * zero.lit(1.01),
            Fault::BrightAtGrazing => value / (pair.cos_o * pair.cos_i).max(zero.lit(1e-9)).sqrt(),
            Fault::Negative => value - zero.lit(1e-9) * pair.cos_i,
            Fault::Askew => lobe(askew(pair)) * scale,
            Fault::NotANumber => value / (pair.cos_o - zero.lit(1e-3)).max(zero),
            _ => value,
        };
        if self.fault == Fault::Through { value.abs() } else { value.select(zero.lt(pair.cos_i), zero) }
    }
}

impl Subject for Broken {
    fn info(&self) -> &ModelInfo {
        &INFO
    }
    fn params(&self) -> Vec<f64> {
        vec![self.shininess]
    }
    fn with_params(&self, params: &[f64]) -> Option<Box<dyn Subject + '_>> {
        Some(Box::new(Self { shininess: params[0], ..*self }))
    }
    fn value(&self, pair: &DirectionPair<f64>) -> f64 {
        self.f_cos(pair)
    }
    fn value_f32(&self, pair: &DirectionPair<f32>) -> Option<f32> {
        Some(match self.fault {
            Fault::NotANumberInF32 if pair.cos_i < 1e-4 => f32::NAN,
            Fault::Imprecise => self.f_cos(pair) * 1.0001,
            Fault::NegativeInF32 if pair.cos_o < 0.0 => -1e-9,
            Fault::OneWayInF32 => self.f_cos(pair) * (1.0 + 1e-4 * pair.cos_i),
            _ => self.f_cos(pair),
        })
    }
    fn value_lanes(&self, level: &str, pairs: &[DirectionPair<f32>; 16]) -> Option<[f32; 16]> {
        let mut values = pairs.map(|pair| self.value_f32(&pair).unwrap());
        if self.fault == Fault::OneLane {
            values[13] *= 1.0 + f32::EPSILON;
        }
        (level == "sse2").then_some(values)
    }
    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        let fraction = if self.fault == Fault::ThinFacets { 0.99 } else { 1.0 };
        let n = self.shininess;
        Some(fraction * (n + 2.0) / (2.0 * PI) * libm::pow(half.z.max(0.0), n))
    }
}

fn broken(fault: Fault) -> Certificate {
    certify(&Broken { fault, shininess: 10.0 })
}

/// The laws that find the fault.
fn found(fault: Fault) -> Vec<Law> {
    broken(fault).findings.iter().filter(|finding| finding.is_broken()).map(|finding| finding.law).collect()
}

#[test]
fn a_lobe_without_fault_is_healthy() {
    let certificate = broken(Fault::Nothing);
    assert!(certificate.is_healthy(), "{certificate:?}");
    assert_eq!(certificate.params, [("shininess", 10.0)]);
}

#[test]
fn each_fault_is_found_by_its_law_alone() {
    for (fault, law) in [
        (Fault::OneWay, Law::Reciprocity),
        (Fault::TooBright, Law::Energy),
        (Fault::BrightAtGrazing, Law::Energy),
        (Fault::ThinFacets, Law::Normalization),
        (Fault::Imprecise, Law::Precision),
        (Fault::OneLane, Law::Lanes),
    ] {
        assert_eq!(found(fault), [law], "{fault:?}");
    }
}

#[test]
fn faults_that_break_several_laws_are_found_by_each() {
    assert!(found(Fault::Negative).contains(&Law::Positivity));
    assert!(found(Fault::Askew).contains(&Law::Limits));
    assert!(found(Fault::NotANumber).contains(&Law::Grazing));
    assert!(found(Fault::NotANumberInF32).contains(&Law::Grazing));
    assert!(found(Fault::NegativeInF32).contains(&Law::Positivity));
    assert!(found(Fault::Through).contains(&Law::Side));
    assert!(found(Fault::OneWayInF32).contains(&Law::Reciprocity));
}

#[test]
fn a_known_fault_is_a_fault_with_its_reason() {
    let certificate = broken(Fault::TooBright);
    let finding = certificate.finding(Law::Energy);
    assert_eq!(finding.verdict, Verdict::Broken { known: Some("it glows, and says so") });
    assert!((finding.value.unwrap() - 1.01).abs() < 1e-4);
    assert!(!certificate.is_healthy());
    let unknown = broken(Fault::OneWay);
    assert_eq!(unknown.finding(Law::Reciprocity).verdict, Verdict::Broken { known: None });
}

#[test]
fn the_brightest_view_is_told() {
    let finding = broken(Fault::BrightAtGrazing);
    let detail = &finding.finding(Law::Energy).detail;
    assert!(detail.contains("θo = 89.999°"), "{detail}");
}

#[test]
fn phong_of_1975_is_not_reciprocal_and_that_is_known() {
    let certificate = certify(&Shape::named("phong", &[]).unwrap());
    assert!(matches!(certificate.finding(Law::Reciprocity).verdict, Verdict::Broken { known: Some(_) }));
    assert_eq!(certificate.finding(Law::Energy).verdict, Verdict::Holds, "2/(n+1) is below 1 for n = 32");
}

#[test]
fn lambert_is_healthy_and_its_own_limit() {
    let certificate = certify(&Shape::named("lambert", &[]).unwrap());
    assert!(certificate.is_healthy(), "{certificate:?}");
    assert!((certificate.finding(Law::Energy).value.unwrap() - 1.0).abs() < 1e-5);
    assert_eq!(certificate.finding(Law::Limits).verdict, Verdict::Holds);
    assert!(matches!(certificate.finding(Law::Normalization).verdict, Verdict::NotApplicable(_)));
}

#[test]
fn the_table_of_a_certificate_has_a_row_per_law() {
    let certificate = broken(Fault::TooBright);
    let rows: Vec<_> = certificate.to_string().lines().map(str::to_owned).collect();
    assert_eq!(rows.len(), Law::ALL.len() + 1, "{certificate}");
    assert_eq!(
        rows[1],
        format!("  energy         FAILS, known  {}", certificate.finding(Law::Energy).detail)
    );
    assert_eq!(rows[2], "                               it glows, and says so");
    assert_eq!(format!("{certificate:#}").lines().next(), Some("broken shininess=10"));
}

#[test]
fn a_function_is_judged_in_f64_alone() {
    let lobe = Function::new(INFO, |pair: &DirectionPair<f64>| pair.cos_i.max(0.0) / PI);
    let certificate = certify(&lobe);
    assert!(certificate.is_healthy(), "{certificate}");
    for law in [Law::Precision, Law::Lanes] {
        assert!(matches!(certificate.finding(law).verdict, Verdict::NotApplicable(_)), "{law:?}");
    }
}

#[test]
fn a_certificate_is_the_same_every_time() {
    let shape = Shape::named("blinn-phong-normalized", &[("shininess", 300.0)]).unwrap();
    assert_eq!(certify(&shape), certify(&shape));
}

#[test]
fn an_integral_does_not_depend_on_the_azimuth_of_a_surface_that_is_isotropic() {
    let shape = Shape::named("phong-normalized", &[("shininess", 5e4)]).unwrap();
    for theta in [0.2, 0.9, 1.4] {
        let seen = |phi| integral(&shape, Vec3::from_angles(theta, phi), &|pair| shape.f_cos(pair));
        let [a, b] = [0.0, 2.5].map(seen);
        assert!(
            (a - b).abs() < 1e-6 && (a - crate::albedo(&shape, libm::cos(theta))).abs() < 2e-5,
            "{theta}"
        );
    }
}

#[test]
fn a_narrow_lobe_is_measured_at_the_horizon() {
    let n = 2e5;
    let lobe = |pair: &DirectionPair<f64>| (n + 1.0) / (2.0 * PI) * libm::pow(pair.cos_mirror().max(0.0), n);
    let seen = |degrees: f64| by_angles(Vec3::from_angles(degrees * PI / 180.0, 0.3), &lobe);
    assert!((seen(80.0) - 1.0).abs() < 1e-5, "{}", seen(80.0));
    // The horizon halves a lobe that lies in it.
    assert!((seen(89.9999) - 0.5).abs() < 1e-3, "{}", seen(89.9999));
}

#[test]
fn the_factors_of_facet_models_make_up_the_model() {
    // f_cos = D G / (4 cosθo) for those that reflect at facets once.
    for (name, set) in [
        ("cook-torrance", vec![("m", 0.3), ("weight2", 0.4)]),
        ("cook-torrance-gaussian", vec![("m", 0.25)]),
        ("beckmann", vec![("alpha", 0.3), ("alpha_y", 0.1), ("multiscatter", 0.0)]),
        ("ggx", vec![("alpha", 0.3), ("alpha_y", 0.1), ("multiscatter", 0.0)]),
        ("charlie", vec![]),
    ] {
        let shape = Shape::named(name, &set).unwrap();
        for (theta, phi) in [(0.3, 2.0), (0.9, 3.0), (1.3, 4.0)] {
            let (wo, wi) = (Vec3::from_angles(0.7, 0.2), Vec3::from_angles(theta, phi));
            let pair = DirectionPair::new(wo, wi);
            let half = (wo + wi).normalized();
            let (d, g) = (shape.distribution(half).unwrap(), shape.shadowing(&pair).unwrap());
            let made = d * g / (4.0 * wo.z);
            let value = shape.f_cos(&pair);
            assert!((made / value - 1.0).abs() < 1e-6, "{name}: {made} for {value}");
        }
    }
}
