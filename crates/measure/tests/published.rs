//! Published fits.

use glanz_math::Vec3;
use glanz_measure::{Measured, PublishedFit, ReadOptions};
use proptest::prelude::*;
use std::f64::consts::PI;

fn lobes_of(model: &str) -> PublishedFit {
    let line = format!(
        "# of a paper\r\n\na-material = Aggregate(Lambertian(albedo = [0.1, 0.2, 0.3]), {model})\r\n"
    );
    PublishedFit::read(&line).expect("the line is a fit").remove(0)
}

/// The BRDF of the second model of a fit, in red, against a formula of the cosines: n·h, wi·h, wi·n and wo·n.
fn check(model: &str, formula: &dyn Fn(f64, f64, f64, f64) -> f64) {
    let lobes = lobes_of(model).lobes().expect("the model has an equal");
    for (ti, to, phi) in [(0.5, 0.6, 3.0), (0.3, 0.2, 2.0), (1.1, 1.2, 3.1), (1.3, 0.4, 2.9)] {
        let (wi, wo) = (Vec3::from_angles(ti, 0.2), Vec3::from_angles(to, phi + 0.2));
        let half = (wi + wo).normalized();
        let (got, want) = (lobes[1].value(wi, wo)[0], formula(half.z, wi.dot(half), wi.z, wo.z));
        assert!((got - want).abs() <= 1e-9 * want.abs() + 1e-12, "{model}: {got} {want} at {ti} {to}");
    }
}

/// Beckmann's distribution without its 1/π.
fn beckmann(nh: f64, m: f64) -> f64 {
    f64::exp(-(1.0 / (nh * nh) - 1.0) / (m * m)) / (m * m * nh.powi(4))
}

fn groove(nh: f64, hd: f64, ni: f64, no: f64) -> f64 {
    f64::min(1.0, 2.0 * nh * f64::min(ni, no) / hd)
}

fn schlick(f0: f64, hd: f64) -> f64 {
    f0 + (1.0 - f0) * (1.0 - hd).powi(5)
}

/// Fresnel's reflectance in the form of Cook and Torrance.
fn fresnel(n: f64, c: f64) -> f64 {
    let g = f64::sqrt(n * n + c * c - 1.0);
    let (a, b) = ((g - c) / (g + c), (c * (g + c) - 1.0) / (c * (g - c) + 1.0));
    0.5 * a * a * (1.0 + b * b)
}

#[test]
fn models_are_those_of_the_publications() {
    let tan2 = |nh: f64| 1.0 / (nh * nh) - 1.0;
    check("NganWard(albedo = [0.5, 0.1, 0.1], roughness = 0.2)", &|nh, _, ni, no| {
        0.5 * f64::exp(-tan2(nh) / 0.04) / (4.0 * PI * 0.04 * f64::sqrt(ni * no))
    });
    check("NganWardDuer(albedo = [0.5, 0.1, 0.1], roughness = 0.2)", &|nh, _, ni, no| {
        0.5 * f64::exp(-tan2(nh) / 0.04) / (4.0 * PI * 0.04 * ni * no)
    });
    check("NganBlinnPhong(albedo = [0.5, 0.1, 0.1], sharpness = 40.0)", &|nh, _, _, _| {
        0.5 * 42.0 / (2.0 * PI) * nh.powi(40)
    });
    check("NganCookTorrance(albedo = [0.5, 0.1, 0.1], eta = 0.12, roughness = 0.3)", &|nh, hd, ni, no| {
        0.5 * beckmann(nh, 0.3) / PI * groove(nh, hd, ni, no) * schlick(0.12, hd) / (PI * ni * no)
    });
    check("LowCookTorrance(albedo = [0.5, 0.1, 0.1], roughness = 0.3, eta = 1.6)", &|nh, hd, ni, no| {
        0.5 * beckmann(nh, 0.3) * groove(nh, hd, ni, no) * fresnel(1.6, hd) / (PI * ni * no)
    });
    check(
        "NganAshikhminShirley(albedo = [0.5, 0.1, 0.1], fresnelReflectance = 0.1, sharpness = 60)",
        &|nh, hd, ni, no| 0.5 * 61.0 / (8.0 * PI) * nh.powi(60) * schlick(0.1, hd) / (hd * f64::max(ni, no)),
    );
    check(
        "LowAshikhminShirley(albedo = [0.5, 0.1, 0.1], sharpness = 60, fresnelReflectance = 1.4)",
        &|nh, hd, ni, no| 0.5 * 61.0 / (8.0 * PI) * nh.powi(60) * fresnel(1.4, hd) / (hd * f64::max(ni, no)),
    );
    let lafortune = lobes_of("NganLafortune(albedo = [0.5, 0.1, 0.1], Cxy = -0.6, Cz = 0.5, sharpness = 30)");
    let (wi, wo) = (Vec3::from_angles(0.5, 0.0), Vec3::from_angles(0.6, 3.0));
    let product = -0.6 * (wi.x * wo.x + wi.y * wo.y) + 0.5 * wi.z * wo.z;
    let want = 0.5 * 32.0 / (2.0 * PI) * (product / 0.6).powi(30);
    let lobes = lafortune.lobes().unwrap();
    assert!((lobes[1].value(wi, wo)[0] - want).abs() < 1e-9 * want);
    assert!((lobes[0].value(wi, wo)[2] - 0.3 / PI).abs() < 1e-12);
    assert_eq!(lobes[1].value(wi, Vec3::from_angles(1.6, 3.0)), [0.0; 3]);
}

#[test]
fn models_without_an_equal_are_errors() {
    let wrong = |model: &str| lobes_of(model).lobes().unwrap_err().to_string();
    assert_eq!(wrong("NganHe(albedo = [1, 1, 1], eta = 1.1)"), "Glanz has no model that is BBM's NganHe");
    assert_eq!(wrong("NganWard(albedo = [1, 1, 1])"), "NganWard lacks the parameter roughness, of 1 numbers");
    assert_eq!(
        wrong("NganWard(albedo = [1, 1], roughness = 0.2)"),
        "NganWard lacks the parameter albedo, of 3 numbers"
    );
    let range = wrong("NganLafortune(albedo = [1, 1, 1], Cxy = -0.6, Cz = 0.5, sharpness = 16600)");
    assert!(range.starts_with("NganLafortune: ") && range.contains("16600"), "{range}");
    let sgd = lobes_of("Bagher(albedo = [1, 2, 3], eta = [[1, 2, 3], [4, 5, 6]])");
    assert_eq!(sgd.models[1].parameters[1], ("eta".to_owned(), vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]));
}

#[test]
fn errors_of_fits_have_their_line() {
    let wrong = |text: &str| {
        let error = PublishedFit::read(text).unwrap_err();
        (error.line(), error.to_string())
    };
    assert_eq!(
        wrong("# x\na = Lambertian(albedo = [1, x])"),
        (Some(2), "expected a number, found 'x])'".to_owned())
    );
    assert_eq!(
        wrong("a = Lambertian(albedo = 1"),
        (Some(1), "expected ',' or ')', found the end".to_owned())
    );
    assert_eq!(wrong("a = Lambertian(albedo = 1) b").1, "expected the end of the line, found 'b'");
    assert_eq!(wrong("a = 3").1, "expected the name of a model, found '3'");
    assert_eq!(wrong("a").1, "expected 'name = Model(…)'");
    assert!(
        wrong(&format!("a = {}", "Aggregate(".repeat(1000))).1.starts_with("expected models at most 8 deep")
    );
    assert!(wrong(&format!("a = A(b = {}", "[".repeat(1000))).1.starts_with("expected lists at most 8 deep"));
    assert_eq!(wrong("").1, "there are no fits");
    let error = Measured::read(b"a = Aggregate(Lambertian(albedo = 1))", "a.fit", &ReadOptions::default())
        .unwrap_err();
    assert!(error.to_string().contains("fitted models, not readings"));
}

proptest! {
    #[test]
    fn mutated_fits_are_read_or_refused(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..5),
    ) {
        let mut bytes = b"a = Aggregate(Lambertian(albedo = [0.1, 0.2, 0.3]), NganWard(albedo = [1, 2, 3], roughness = 0.1))".to_vec();
        for (at, byte) in &changes {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        if let Ok(fits) = PublishedFit::read(&String::from_utf8_lossy(&bytes)) {
            fits.iter().for_each(|fit| drop(fit.lobes()));
        }
    }
}
