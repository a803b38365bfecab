//! BRDFs of users as shapes.

use std::path::Path;
use std::sync::Arc;

use glanz_bsdf::laws::{Certificate, Subject, certify};
use glanz_bsdf::{DirectionPair, Law, Shape};
use glanz_math::{PI, SimdLevel, Vec3};
use glanz_shader::{Brdf, BrdfSource};

use crate::common::Numbers;

/// A file of the examples.
fn example(name: &str) -> Brdf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/brdf").join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    BrdfSource::new(name, text).compile().unwrap_or_else(|error| panic!("{error}"))
}

fn word(text: &str) -> Brdf {
    BrdfSource::word(text).and_then(|source| source.compile()).unwrap_or_else(|error| panic!("{error}"))
}

fn word_error(text: &str) -> String {
    BrdfSource::word(text).and_then(|source| source.compile()).expect_err(text).to_string()
}

/// Pairs of directions above the surface, no lower than 0.6°.
fn pairs(count: usize) -> Vec<DirectionPair<f32>> {
    let mut numbers = Numbers(7);
    let mut direction = || {
        let (height, azimuth) =
            (0.01 + 0.99 * f64::from(numbers.unit()), 2.0 * PI * f64::from(numbers.unit()));
        let w = Vec3::from_angles(height.acos(), azimuth);
        Vec3::new(w.x as f32, w.y as f32, w.z as f32)
    };
    (0..count).map(|_| DirectionPair::new(direction(), direction())).collect()
}

/// What the rounding of directions, 6e-8, makes of a lobe: its slope is some tens at these widths, and the logarithm of a value
/// that is down by 1e-6 another ten.
const ROUNDING: f32 = 4e-5;

fn agree(brdf: &Shape, built_in: &Shape) {
    let mut seen = 0.0_f32;
    for pair in pairs(4000) {
        let (got, expected) = (brdf.f_cos(&pair), built_in.f_cos(&pair));
        // Values this faint show in no picture.
        let off = (got - expected).abs() - ROUNDING * expected - 1e-7;
        assert!(off <= 0.0, "{got} for {expected}: {pair:?}");
        seen = seen.max(expected);
    }
    assert!(seen > 0.1);
}

#[test]
fn texts_of_built_in_models_give_their_values() {
    let phong = example("phong.brdf").shape().with("shininess", 12.0).unwrap();
    agree(&phong, &Shape::named("phong", &[("shininess", 12.0)]).unwrap());
    let ward = example("ward.brdf").shape();
    assert!(ward.is_anisotropic());
    agree(&ward, &Shape::named("ward", &[("alpha", 0.2), ("alpha_y", 0.1)]).unwrap());
    let ggx = example("ggx.wgsl").shape().with("alpha", 0.3).unwrap();
    assert!(!ggx.is_anisotropic());
    agree(&ggx, &Shape::named("ggx", &[("alpha", 0.3), ("multiscatter", 0.0)]).unwrap());
    agree(&word("1 / pi").shape(), &Shape::named("lambert", &[]).unwrap());
}

#[test]
fn cosines_alone_give_what_vectors_give() {
    let shape = example("phong.brdf").shape().with("shininess", 4.0).unwrap();
    for pair in pairs(2000) {
        let alone = DirectionPair::isotropic(pair.cos_o, pair.cos_i, pair.cos_io);
        let (vectors, cosines) = (shape.f_cos(&pair), shape.f_cos(&alone));
        assert!((vectors - cosines).abs() <= 1e-5 * vectors + 1e-6, "{vectors} {cosines}");
    }
    // Along the normal there is no azimuth, and so nothing to divide by.
    let up: f32 = shape.f_cos(&DirectionPair::isotropic(1.0_f32, 1.0, 1.0));
    assert!((up - std::f32::consts::FRAC_1_PI).abs() < 1e-6, "{up}");
    let slanted: f32 = shape.f_cos(&DirectionPair::isotropic(1.0_f32, 0.5, 0.5));
    assert!(slanted.is_finite());
}

#[test]
fn every_level_and_thread_gives_the_same_bits() {
    let shapes: Vec<_> = (1..40)
        .map(|n| {
            word("n = 3; pow(max(dot(N, H), 0), n) + 0.2 * abs(dot(L, V))")
                .shape()
                .with("n", f64::from(n))
                .unwrap()
        })
        .collect();
    let shapes = Arc::new(shapes);
    let all = |level: &'static str, shapes: &[Shape]| -> Vec<u32> {
        let pairs = pairs(64);
        let of = |shape: &Shape| {
            let chunks = pairs.as_chunks::<16>().0.iter();
            chunks
                .flat_map(|chunk| shape.value_lanes(level, chunk).unwrap())
                .map(f32::to_bits)
                .collect::<Vec<_>>()
        };
        shapes.iter().flat_map(of).collect()
    };
    let expected = all(SimdLevel::available()[0].0, &shapes);
    let threads = SimdLevel::available().into_iter().cycle().take(8).map(|(level, _)| {
        let shapes = Arc::clone(&shapes);
        // More models than a thread keeps registers for, in both orders.
        std::thread::spawn(move || (all(level, &shapes), all(level, &shapes)))
    });
    for thread in threads.collect::<Vec<_>>() {
        let (first, second) = thread.join().unwrap();
        assert!(first == expected && second == expected);
    }
    for pair in pairs(16) {
        let lanes = shapes[5].value_lanes(SimdLevel::available()[0].0, &[pair; 16]).unwrap();
        assert_eq!(lanes[3].to_bits(), shapes[5].f_cos(&pair).to_bits());
    }
}

fn broken(certificate: &Certificate) -> Vec<&'static str> {
    certificate
        .findings
        .iter()
        .filter(|finding| finding.is_broken())
        .map(|finding| finding.law.name())
        .collect()
}

#[test]
fn certificates_find_the_classic_faults() {
    let blinn = certify(&example("faults/blinn.brdf").shape());
    assert_eq!(broken(&blinn), ["energy"], "{blinn}");
    // The inverse of the factor of 'blinn-phong-normalized', at n = 10.
    let expected = 8.0 * PI * (1.0 / 32.0 + 10.0) / (12.0 * 14.0);
    assert!((blinn.finding(Law::Energy).value.unwrap() - expected).abs() < 1e-4, "{blinn}");
    let cook_torrance = certify(&example("faults/cook-torrance.brdf").shape());
    assert_eq!(broken(&cook_torrance), ["energy"], "{cook_torrance}");
    assert!(cook_torrance.finding(Law::Energy).value.unwrap() > 3.0, "{cook_torrance}");
    let ward = certify(&example("faults/ward.brdf").shape());
    assert_eq!(broken(&ward), ["energy", "grazing"], "{ward}");
    let right =
        [example("ward.brdf"), example("phong.brdf"), word("1 / pi"), word("0.3 * dot(N, L) * dot(N, V)")];
    let expected: [&[&str]; 4] = [&["energy"], &["reciprocity"], &[], &[]];
    for (brdf, expected) in right.iter().zip(expected) {
        let certificate = certify(&brdf.shape());
        assert_eq!(broken(&certificate), expected, "{certificate}");
    }
}

#[test]
fn a_trace_tells_the_line_that_is_no_number() {
    let ward = example("faults/ward.brdf");
    let finding = certify(&ward.shape()).finding(Law::Grazing).clone();
    let trace = ward.trace(&ward.shape().params(), finding.wo.unwrap(), finding.wi.unwrap());
    // The line of 'return' that divides by zero, or that of the root of less than nothing.
    let first = trace.first_not_finite().expect("it is not finite");
    let line = first.place.as_ref().unwrap().line;
    assert!([18, 20].contains(&line), "{first:?}");
    let root = trace.records().iter().find(|record| record.name == "root").expect("it is recorded");
    assert!(root.values(0)[0] == 0.0 || root.values(0)[0].is_nan(), "{root:?}");
}

#[test]
fn colours_and_truth_values_are_parameters() {
    let text = "::begin parameters\nfloat n 1 100 20\ncolor kd 0.5 0.25 1\nbool on 1\n::end parameters\n::begin shader\n\
        vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return on ? kd * n : vec3(2.0); }\n::end shader\n";
    let brdf = BrdfSource::new("folder/mixed.brdf", text).compile().unwrap();
    let info = brdf.info();
    assert_eq!((info.name, info.anisotropic), ("mixed.brdf", false));
    let params: Vec<_> = info.params.iter().map(|p| (p.name, p.min, p.max, p.default)).collect();
    let expected = [
        ("n", 1.0, 100.0, 20.0),
        ("kd_r", 0.0, 1.0, 0.5),
        ("kd_g", 0.0, 1.0, 0.25),
        ("kd_b", 0.0, 1.0, 1.0),
        ("on", 0.0, 1.0, 1.0),
    ];
    assert_eq!(params, expected);
    let at = |shape: &Shape| -> f32 { shape.f_cos(&DirectionPair::isotropic(1.0_f32, 0.5, 0.5)) };
    // The mean of the channels, times the cosine.
    assert!((at(&brdf.shape()) - 20.0 * 1.75 / 3.0 * 0.5).abs() < 1e-5);
    assert_eq!(at(&brdf.shape().with("on", 0.0).unwrap()), 1.0);
    assert!(brdf.remarks().iter().any(|remark| remark.message.contains("red, green and blue differ")));
    assert!(word("vec3(0.2)").remarks().is_empty());
    assert!(brdf.shape().with("n", 101.0).unwrap_err().to_string().contains("model 'mixed.brdf' is 101"));
}

#[test]
fn shapes_of_one_text_are_equal_and_others_are_not() {
    let (a, b, c) = (word("n = 2; n / pi"), word("n = 2; n / pi"), word("n = 3; n / pi"));
    assert_eq!(a.shape(), b.shape());
    assert_eq!(a.shape().with("n", 3.0).unwrap(), b.shape().with("n", 3.0).unwrap());
    assert_ne!(a.shape(), b.shape().with("n", 3.0).unwrap());
    assert_ne!(a.shape(), c.shape());
    assert!(std::ptr::eq(a.info(), b.info()));
}

#[test]
fn what_is_no_brdf_is_refused_with_its_place() {
    for (text, expected) in [
        ("pow(dot(N, H), m)", "expression:1:16: 'm' is not declared"),
        ("n = 2;\n  pow(dot(N, H), m)", "expression:2:18: 'm' is not declared"),
        ("n = 2; dot(N, H", "expression:"),
        ("float f(vec3 L, vec3 V, float n) { return n; }", "the parameter 'n' of this function is no vec3"),
        (
            "float f(vec3 L, vec3 Q) { return L.x; }",
            "the parameter 'Q' of this function stands for no direction",
        ),
        (
            "bool f(vec3 L, vec3 V) { return true; }",
            "a BRDF gives a float or a vec3, but this function gives a bool",
        ),
        ("float f(vec3 L) { return dFdx(L.x); }", "a BRDF has neither derivatives nor 'discard'"),
        ("uniform sampler2D t; vec3 f(vec3 L) { return texture(t, L.xy).xyz; }", "a BRDF has no textures"),
        (
            "float f(vec3 L) { float x = L.x; while (x < 2.0) { x *= 1.0; } return x; }",
            "a loop takes more than",
        ),
        ("", "expression:1:1: an expression for the value of the BRDF is expected"),
    ] {
        let error = word_error(text);
        assert!(error.contains(expected), "{text}: {error}");
    }
}

#[test]
fn includes_are_part_of_the_text() {
    let include = |path: &str, _: &str| {
        (path == "a.glsl").then(|| "float half_of(float x) { return 0.5 * x; }".to_owned())
    };
    let text = "#include \"a.glsl\"\nfloat f(vec3 L, vec3 V, vec3 N) { return half_of(dot(N, V)); }\n";
    let brdf = BrdfSource::new("f.glsl", text).include(&include).compile().unwrap();
    let source = brdf.shape().source().unwrap().clone();
    assert!(source.text.starts_with("float half_of"));
    let again = BrdfSource::new("f.glsl", source.text).compile().unwrap();
    assert_eq!(again.shape(), brdf.shape());
}

/// Every `.brdf` of a folder that `GLANZ_BRDFS` names, such as BRDF Explorer's.
#[test]
#[ignore = "it needs a folder of BRDFs"]
fn a_folder_of_brdfs_is_certified() {
    let folder = std::env::var("GLANZ_BRDFS").expect("GLANZ_BRDFS is a folder of .brdf files");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for path in files {
        let start = std::time::Instant::now();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        match BrdfSource::new(&name, std::fs::read_to_string(&path).unwrap()).compile() {
            Err(error) => println!("{name}: ERROR {error}"),
            Ok(brdf) => {
                let certificate = certify(&brdf.shape());
                let details = certificate.findings.iter().filter(|finding| finding.is_broken());
                let details: Vec<_> = details.map(|f| format!("{}: {}", f.law.name(), f.detail)).collect();
                let info = brdf.info();
                println!(
                    "{name}: {} params, anisotropic {}, {:.2} s; {}",
                    info.params.len(),
                    info.anisotropic,
                    start.elapsed().as_secs_f64(),
                    details.join("; ")
                );
            }
        }
    }
}

/// How many values a second a thread gives, 16 at a time.
#[test]
#[ignore = "it measures, which wants an optimised build"]
fn how_fast_a_brdf_is() {
    let shapes = ["phong.brdf", "ward.brdf", "ggx.wgsl", "faults/cook-torrance.brdf"]
        .map(|name| (name, example(name).shape()));
    let shapes = shapes.into_iter().chain([("1 / pi", word("1 / pi").shape())]);
    for (name, shape) in shapes {
        let pairs = pairs(16);
        let level = SimdLevel::best();
        let mut rates = Vec::new();
        for _ in 0..9 {
            let start = std::time::Instant::now();
            let mut sum = 0.0;
            for _ in 0..20_000 {
                sum +=
                    shape.value_lanes(level.name(), pairs.as_chunks::<16>().0.first().unwrap()).unwrap()[0];
            }
            assert!(sum.is_finite());
            rates.push(16.0 * 20_000.0 / start.elapsed().as_secs_f64() / 1e6);
        }
        rates.sort_by(f64::total_cmp);
        println!("{name}: median {:.1} M/s, least {:.1}, most {:.1}", rates[4], rates[0], rates[8]);
    }
}
