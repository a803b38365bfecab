//! `glanz lesson`: experiments of the course.

use crate::folder::Folder;

#[test]
fn wards_regression_gives_the_widths_back() {
    let folder = Folder::new();
    for (along, across) in [(0.05, 0.05), (0.1, 0.1), (0.2, 0.2), (0.088, 0.13), (0.04, 0.11)] {
        let [x, y] = [along, across].map(|width: f64| width.to_string());
        let facts =
            folder.glanz(&["lesson", "ward", "--alpha", &x, "--alpha-y", &y, "--format", "json"]).json();
        let near = |key: &str, expected: f64| {
            let found = facts["found"][key].as_f64().unwrap();
            assert!((found / expected - 1.0).abs() < 0.02, "{along} {across}: {key} is {found}");
        };
        near("alpha_x", along);
        near("alpha_y", across);
        near("rho_s", 0.1);
        near("rho_d", 0.3);
        let slope = facts["slope"].as_f64().unwrap() * along * along;
        assert!((slope + 1.0).abs() < 0.04 && facts["truth"]["alpha_x"].as_f64() == Some(along), "{facts}");
    }
}

#[test]
fn own_readings_are_fitted_and_drawn() {
    let folder = Folder::new();
    let sample = [
        "measure",
        "sample",
        "ward",
        "--set",
        "alpha=0.2",
        "--set",
        "alpha_y=0.2",
        "--diffuse",
        "0.3",
        "-o",
        "own.csv",
    ];
    folder.glanz(&sample).text();
    let words = ["lesson", "ward", "--readings", "own.csv", "--plot", "own.csv.svg", "--lang", "fr"];
    let run = folder.glanz(&words);
    assert!(run.text().contains("readings of own.csv, channel Y"), "{}", run.text());
    let svg = String::from_utf8(folder.read("own.csv.svg")).unwrap();
    assert!(svg.contains("Régression de Ward") && svg.contains("mesures"), "words are French");
    let facts = folder.glanz(&["lesson", "ward", "--readings", "own.csv", "--format", "json"]).json();
    assert!((facts["found"]["alpha_x"].as_f64().unwrap() - 0.2).abs() < 0.02, "{facts}");
    assert!(facts["truth"].is_null() && facts["file"] == "own.csv");
    for words in [&["--readings", "own.csv", "--alpha", "0.1"][..], &["--anisotropic"], &["--alpha", "7"]] {
        assert_eq!(folder.glanz(&[&["lesson", "ward"], words].concat()).code, 2, "{words:?}");
    }
}
