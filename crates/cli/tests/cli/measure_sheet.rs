//! Sheets of `glanz measure compare`, and perfect mirrors among the numbers of appearance.

use crate::folder::Folder;
use crate::pictures::Png;

/// Readings of a glossy surface without noise.
fn sampled() -> Folder {
    let folder = Folder::new();
    let words = ["measure", "sample", "ggx", "--set", "alpha=0.3", "--diffuse", "0.2", "-o", "a.csv"];
    folder.glanz(&words).text();
    folder
}

#[test]
fn a_sheet_has_slices_with_readings_as_points() {
    let folder = sampled();
    let compare = |more: &[&str]| {
        let words = ["measure", "compare", "lambert", "a.csv", "--sheet", "--size", "48x48"];
        folder.glanz(&[&words[..], more].concat())
    };
    compare(&["-o", "a.png"]).text();
    let sheet = Png::decode(&folder.read("a.png"));
    // Balls of 48 pixels take columns of the least width.
    assert!(sheet.width > 700 && sheet.height > 700, "{} x {}", sheet.width, sheet.height);
    let facts = compare(&["--format", "json"]).json();
    let panels = facts["plots"]["panels"].as_array().unwrap();
    assert_eq!(panels.len(), 6, "three slices and three polar cuts");
    let slice = &panels[1];
    assert_eq!(slice["title"], "In the plane of incidence, light at 45°");
    let points = |name: &str| -> Vec<[f64; 2]> {
        let curves = slice["curves"].as_array().unwrap();
        let curve = curves.iter().find(|curve| curve["name"] == name).unwrap();
        let pair = |point: &serde_json::Value| [point[0].as_f64().unwrap(), point[1].as_f64().unwrap()];
        curve["points"].as_array().unwrap().iter().map(pair).collect()
    };
    // Detectors every 5° up to 85° on both sides, the normal counted once.
    let read = points("readings of a.csv");
    assert!(read.len() == 35 && read[0][0] == -85.0 && read[34][0] == 85.0, "{read:?}");
    assert!(points("lambert").iter().all(|[_, f]| (f * std::f64::consts::PI - 1.0).abs() < 1e-4));
    // What is drawn passes through readings that have no noise: 5 % is what smoothing leaves.
    let drawn = points("a.csv");
    for [theta, f] in read.iter().filter(|[theta, _]| theta.abs() < 80.0) {
        let near = drawn.iter().min_by(|a, b| (a[0] - theta).abs().total_cmp(&(b[0] - theta).abs())).unwrap();
        assert!((near[1] - f).abs() < 0.05 * f, "at {theta}: {} drawn, {f} read", near[1]);
    }
    compare(&["-o", "a.csv.svg"]).text();
    compare(&["-o", "slices.csv"]).text();
    assert!(
        folder.read("slices.csv").starts_with("panel,curve,θo of the detector in °,f in 1/sr,".as_bytes())
    );
}

#[test]
fn a_sheet_of_a_grain_has_light_of_one_azimuth() {
    let folder = Folder::new();
    let words = ["measure", "sample", "ward", "--set", "alpha_y=0.5", "--diffuse", "0.2", "-o", "a.csv"];
    folder.glanz(&words).text();
    let words = ["measure", "compare", "ward", "a.csv", "--sheet", "--size", "48x48", "--format", "json"];
    let facts = folder.glanz(&words).json();
    assert_eq!(facts["plots"]["subtitle"], "Y under D65 for cie1931; light from the azimuth 180°");
    let curves = facts["plots"]["panels"][0]["curves"].as_array().unwrap();
    let cloud = curves.iter().find(|curve| curve["name"] == "readings of a.csv").unwrap();
    assert_eq!(cloud["points"].as_array().unwrap().len(), 35);
}

#[test]
fn a_sheet_needs_a_file_that_can_hold_it() {
    let folder = sampled();
    let compare = |more: &[&str]| folder.glanz(&[&["measure", "compare", "lambert", "a.csv"], more].concat());
    let run = compare(&["--sheet"]);
    assert!(run.code == 2 && run.stderr.contains("--sheet is drawn into a file"), "{}", run.stderr);
    let run = compare(&["--sheet", "-o", "a.jpg"]);
    assert!(run.code == 2 && run.stderr.contains("must end in .svg, .png, .pdf"), "{}", run.stderr);
    let run = compare(&["-o", "a.svg"]);
    assert!(run.code == 2 && run.stderr.contains("--sheet"), "{}", run.stderr);
}

#[test]
fn a_mirror_has_the_gloss_of_its_reflectance() {
    let folder = Folder::new();
    let facts = |words: &[&str]| {
        folder.glanz(&[&["measure", "appearance"], words, &["--format", "json"]].concat()).json()
    };
    let first = |facts: &serde_json::Value, key: &str| facts[key][0].as_f64().unwrap();
    // The standard itself, and a mirror that reflects everything: 1 / 0.04908, 1 / 0.10006 and 1 / 0.61915.
    for (words, expected) in
        [(&["mirror", "--ior", "1.567"][..], [100.0, 100.0, 100.0]), (&["mirror"], [2037.6, 999.4, 161.5])]
    {
        let facts = facts(words);
        for (key, expected) in ["gloss_20", "gloss_60", "gloss_85"].iter().zip(expected) {
            let gloss = first(&facts, key);
            assert!((gloss - expected).abs() < 0.1, "{words:?} {key}: {gloss}, not {expected}");
        }
        assert!(first(&facts, "haze_iso_13803") == 0.0 && first(&facts, "sphere_excluded") == 0.0);
        let note = facts["notes"][0].as_str().unwrap();
        assert!(note.contains("its light is in gloss and in the sphere"), "{note}");
    }
    // Of a material, by its Y: crown glass of 1.519 at 60°, and 4.24 % in the sphere.
    let glass = facts(&["glass-solid"]);
    let (gloss, sphere) = (first(&glass, "gloss_60"), first(&glass, "sphere_included"));
    assert!((gloss - 92.2).abs() < 0.3 && (sphere - 0.0424).abs() < 0.0003, "{gloss} {sphere}");
}
