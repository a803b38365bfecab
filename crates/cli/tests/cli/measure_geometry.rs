//! Where the virtual goniometer of `glanz measure sample` goes.

use crate::folder::Folder;

#[test]
fn a_width_is_found_again_from_every_geometry() {
    let folder = Folder::new();
    for (geometry, least, most) in [
        ("in-plane", 210, 210),
        ("hemisphere", 2454, 2454),
        ("astm", 300, 490),
        ("merl", 19_000, 21_000),
        ("rgl", 10_000, 20_000),
    ] {
        let words =
            ["measure", "sample", "ward", "--set", "alpha=0.15", "--diffuse", "0.2", "--noise", "0.03"];
        folder.glanz(&[&words[..], &["--geometry", geometry, "-o", "a.csv"]].concat()).text();
        let words = ["measure", "fit", "a.csv", "--models", "ward+lambert", "--format", "json"];
        let facts = folder.glanz(&words).json();
        let told = folder.glanz(&["measure", "info", "a.csv", "--format", "json"]).json();
        let readings = told["readings"].as_u64().unwrap();
        assert!((least..=most).contains(&readings), "{geometry}: {readings}");
        let alpha = facts["fits"][0]["lobes"][0]["parameters"][0]["value"].as_f64().unwrap();
        // 3 % of noise in some twenty readings of the highlight, which in-plane has fewest of.
        assert!((alpha / 0.15 - 1.0).abs() < 0.02, "{geometry}: {alpha}");
    }
}

#[test]
fn what_has_a_grain_is_turned_under_the_goniometer() {
    let folder = Folder::new();
    for geometry in ["astm", "merl"] {
        let words =
            ["measure", "sample", "ward", "--set", "alpha=0.1", "--set", "alpha_y=0.25", "--diffuse", "0.2"];
        folder.glanz(&[&words[..], &["--geometry", geometry, "-o", "a.csv"]].concat()).text();
        let words = ["measure", "fit", "a.csv", "--models", "ward:aniso+lambert", "--format", "json"];
        let facts = folder.glanz(&words).json();
        let parameters = &facts["fits"][0]["lobes"][0]["parameters"];
        let [x, y] = [0, 1].map(|i| parameters[i]["value"].as_f64().unwrap());
        // Without noise; f32 in the file is what is left.
        assert!((x / 0.1 - 1.0).abs() < 1e-3 && (y / 0.25 - 1.0).abs() < 1e-3, "{geometry}: {x} {y}");
    }
}
