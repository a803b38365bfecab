//! BRDFs of one's own where a model is named.

use crate::folder::Folder;

const WARD: &str = "analytic\n::begin parameters\nfloat alpha 0.05 1 0.2\n::end parameters\n::begin shader\n\
    vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n  float c = dot(N, normalize(L + V));\n  \
    float root = sqrt(dot(N, L) * dot(N, V));\n  return vec3(exp((1.0 - 1.0 / (c * c)) / (alpha * alpha)) / (12.5664 * alpha * alpha * root));\n}\n::end shader\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("ward.brdf", WARD);
    folder
}

#[test]
fn a_certificate_tells_the_line_that_is_not_finite() {
    let folder = folder();
    let run = folder.glanz(&["shader", "certify", "ward.brdf"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let text = String::from_utf8_lossy(&run.stdout);
    assert!(text.contains("ward.brdf:9:") && text.contains("'return' is inf"), "{text}");
    assert!(run.stderr.contains("grazing of ward.brdf"), "{}", run.stderr);
    let run = folder.glanz(&["shader", "certify", "ward.brdf", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let findings = json["certificates"][0]["findings"].as_array().unwrap();
    let grazing = findings.iter().find(|finding| finding["check"] == "grazing").unwrap();
    assert_eq!(
        (&grazing["cause"]["line"], &grazing["cause"]["value"][0]),
        (&9.into(), &serde_json::Value::Null)
    );
    assert!(grazing["wo"][2].as_f64().unwrap().abs() < 1e-9, "{grazing}");
    assert_eq!(folder.glanz(&["shader", "certify", "1 / pi"]).code, 0);
}

#[test]
fn plots_sheets_and_numbers_take_it() {
    let folder = folder();
    let words = [
        "plot",
        "ward.brdf",
        "phong",
        "n = 8 in 1..20; n / 100",
        "--set",
        "ward.brdf.alpha=0.1,0.3",
        "--set",
        "n=9",
        "-o",
        "a.csv",
    ];
    let text = {
        let run = folder.glanz(&words);
        assert_eq!(run.code, 0, "{}", run.stderr);
        std::fs::read_to_string(folder.path("a.csv")).unwrap()
    };
    for label in ["ward.brdf alpha=0.1", "ward.brdf alpha=0.3", "phong", "n = 8 in 1..20; n / 100 n=9"] {
        assert!(text.contains(label), "{label}: {text}");
    }
    let sheet = ["sheet", "ward.brdf", "--vary", "alpha=0.1,0.4", "--size", "16x16"];
    assert_eq!(folder.glanz(&sheet).code, 0);
    assert!(folder.names().contains(&"ward_sheet.png".to_owned()), "{:?}", folder.names());
    let run = folder.glanz(&["bsdf", "eval", "0.5 / pi", "--wo", "0,0", "--wi", "60,0"]);
    let text = run.text();
    assert!(text.contains("0.0795775"), "{text}");
}

#[test]
fn errors_are_at_the_line_of_the_one_who_wrote_it() {
    let folder = folder();
    folder.write("wrong.brdf", WARD.replace("dot(N, V)", "dot(N, W)"));
    for (words, code, expected) in [
        (&["check", "wrong.brdf"][..], 3, "wrong.brdf:8:"),
        (&["plot", "pow(max(dot(N, H), 0), m)", "-o", "a.svg"], 3, "expression:1:24"),
        (&["sheet", "none.brdf", "--vary", "n=1,2"], 3, "cannot read 'none.brdf'"),
        (&["check", "phongg"], 2, "phong"),
        (&["check", "ward.brdf", "--set", "alpha=7"], 2, "must be between 0.05 and 1"),
        (&["check", "ward.brdf", "--set", "beta=7"], 2, "there is no parameter 'beta'"),
    ] {
        let run = folder.glanz(words);
        assert_eq!(run.code, code, "{words:?}: {}", run.stderr);
        assert!(run.stderr.contains(expected), "{words:?}: {}", run.stderr);
    }
}
