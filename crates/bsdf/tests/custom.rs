//! Models of a program's own give what they would give in the list.

use glanz_bsdf::laws::{Law, Subject, certify};
use glanz_bsdf::models::{ggx::Ggx, refraction::Refraction, ward::Ward};
use glanz_bsdf::{DirectionPair, Model, ModelInfo, ParamInfo, Shape};
use glanz_math::{PI, SimdLevel, Vec3};

/// Directions all over the hemisphere, and the light below it.
fn pairs() -> Vec<DirectionPair<f64>> {
    let directions = |count: u32| (0..count).map(move |i| (0.03 + f64::from(i) * 0.1, f64::from(i * i)));
    let mut pairs = Vec::new();
    for (theta_o, phi_o) in directions(15) {
        for (theta_i, phi_i) in directions(20) {
            let (wo, wi) = (Vec3::from_angles(theta_o, phi_o), Vec3::from_angles(theta_i, phi_i));
            pairs.push(DirectionPair { alpha_scale: 0.75, ..DirectionPair::new(wo, wi) });
        }
    }
    pairs
}

fn single(pair: &DirectionPair<f64>) -> DirectionPair<f32> {
    let s = |x: f64| x as f32;
    DirectionPair {
        cos_o: s(pair.cos_o),
        cos_i: s(pair.cos_i),
        cos_io: s(pair.cos_io),
        half2: s(pair.half2),
        tangent_o: (s(pair.tangent_o.0), s(pair.tangent_o.1)),
        tangent_i: (s(pair.tangent_i.0), s(pair.tangent_i.1)),
        alpha_scale: s(pair.alpha_scale),
    }
}

/// Everything that a shape says of itself, as bits.
fn answers(shape: &Shape) -> Vec<u64> {
    let mut bits: Vec<u64> = shape.params().iter().map(|value| value.to_bits()).collect();
    bits.push(shape.eta().to_bits());
    bits.push(u64::from(shape.is_anisotropic()));
    for pair in pairs() {
        let low = single(&pair);
        bits.push(shape.f_cos(&pair).to_bits());
        bits.push(u64::from(shape.f_cos(&low).to_bits()));
        bits.push(shape.tint_cosine(&pair).to_bits());
        bits.push(u64::from(shape.tint_cosine(&low).to_bits()));
        bits.push(shape.shadowing(&pair).map_or(0, f64::to_bits));
        bits.push(shape.distribution(Vec3::from_angles(pair.cos_o, 0.4)).map_or(0, f64::to_bits));
        for (level, _) in SimdLevel::available() {
            let lanes = shape.value_lanes(level, &[low; 16]).expect("the machine has it");
            bits.extend(lanes.map(|value| u64::from(value.to_bits())));
        }
    }
    bits
}

#[test]
fn a_model_of_the_list_gives_the_same_bits_as_a_custom_one() {
    let ggx = Ggx::with_params(&[("alpha", 0.2)]).expect("it is in range");
    let ward = Ward::with_params(&[("alpha", 0.05), ("alpha_y", 0.2)]).expect("they are in range");
    let refraction = Refraction::with_params(&[]).expect("nothing is set");
    for (custom, listed) in [
        (Shape::custom(ggx), Shape::Ggx(ggx)),
        (Shape::custom(ward), Shape::Ward(ward)),
        (Shape::custom(refraction), Shape::Refraction(refraction)),
    ] {
        assert_eq!(custom.info(), listed.info());
        assert_eq!(custom.id(), u32::MAX);
        assert!(answers(&custom) == answers(&listed), "{} differs", listed.info().name);
        assert_eq!(certify(&custom), certify(&listed));
    }
}

#[test]
fn a_parameter_is_set_by_name() {
    let wide = Shape::custom(Ggx::with_params(&[("alpha", 0.2)]).expect("it is in range"));
    let narrow = wide.with("alpha", 0.1).expect("it is in range");
    assert_eq!((wide.get("alpha"), narrow.get("alpha"), narrow.get("m")), (Some(0.2), Some(0.1), None));
    assert!(answers(&narrow) == answers(&Shape::named("ggx", &[("alpha", 0.1)]).expect("it is in range")));
    let error = wide.with("alpha", 2.0).expect_err("it is above the range");
    assert_eq!(error.to_string(), "parameter 'alpha' of model 'ggx' is 2, but must be between 0.001 and 1");
    assert_eq!(wide, wide.clone());
    assert_ne!(wide, narrow);
    assert_ne!(wide, narrow.with("alpha", 0.2).expect("it is in range"), "formulas are not compared");
}

const GLOSS: ParamInfo =
    ParamInfo { name: "gloss", symbol: "g", doc: "how much it reflects", min: 0.0, max: 2.0, default: 1.0 };
static PAPER: ModelInfo =
    ModelInfo { name: "paper", params: &[GLOSS], ..glanz_bsdf::models::lambert::Lambert::INFO };

#[test]
fn a_function_is_a_shape_with_parameters() {
    let paper = |set: &[(&str, f64)]| {
        Shape::from_function(&PAPER, set, |params, pair| params[0] / PI * pair.cos_i.max(0.0))
    };
    let (bright, plain) = (paper(&[("gloss", 1.5)]).expect("it is in range"), paper(&[]).expect("a default"));
    let pair = DirectionPair::isotropic(0.8, 0.5, 0.3);
    assert_eq!((bright.f_cos(&pair), plain.f_cos(&pair)), (1.5 / PI * 0.5, 1.0 / PI * 0.5));
    assert_eq!(bright.with("gloss", 1.0).expect("it is in range").f_cos(&pair), plain.f_cos(&pair));
    assert_eq!(format!("{bright:?}"), r#"Custom(paper { params: [1.5], .. })"#);
    assert!(paper(&[("gloss", 3.0)]).is_err() && paper(&[("alpha", 0.1)]).is_err());
    // The laws see what it is: half as much light again as comes in.
    let certificate = certify(&bright);
    assert!(certificate.finding(Law::Energy).is_broken());
    assert!(!certificate.finding(Law::Lanes).is_broken() && !certificate.finding(Law::Precision).is_broken());
    assert!(certify(&plain).is_healthy());
}
