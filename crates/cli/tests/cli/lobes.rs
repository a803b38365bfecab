//! `glanz check`, `glanz plot`, `glanz sheet` and tables of directions.

use crate::folder::{Folder, command};

/// Width and height in the head of a PNG.
fn png_size(bytes: &[u8]) -> (u32, u32) {
    assert!(bytes.starts_with(b"\x89PNG"));
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The certificate's finding of a check.
fn finding<'a>(certificate: &'a serde_json::Value, check: &str) -> &'a serde_json::Value {
    let findings = certificate["findings"].as_array().unwrap();
    findings.iter().find(|finding| finding["check"] == check).unwrap()
}

#[test]
fn a_healthy_model_passes_every_check_that_applies() {
    insta::assert_snapshot!(Folder::new().glanz(&["check", "lambert"]).text());
}

#[test]
fn a_known_fault_is_told_with_its_reason_and_fails() {
    let run = Folder::new().glanz(&["check", "phong"]);
    assert_eq!(run.code, 1);
    insta::assert_snapshot!(String::from_utf8(run.stdout).unwrap());
    insta::assert_snapshot!(run.stderr);
}

#[test]
fn a_certificate_for_programs_holds_numbers() {
    let folder = Folder::new();
    let run = folder.glanz(&["check", "phong", "--set", "shininess=0.5,8", "--format", "json"]);
    assert_eq!(run.code, 1);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let [half, eight] = json["certificates"].as_array().unwrap().as_slice() else {
        panic!("two certificates: {json}")
    };
    assert_eq!((&half["params"]["shininess"], &half["healthy"]), (&0.5.into(), &false.into()));
    // Along the normal, 2/(n+1) of the light comes back.
    assert!((number(&finding(half, "energy")["value"]) - 2.0 / 1.5).abs() < 1e-3);
    assert_eq!(finding(half, "energy")["verdict"], "fails");
    assert_eq!(finding(eight, "energy")["verdict"], "holds");
    assert_eq!(finding(eight, "reciprocity")["known"], true);
    assert_eq!(finding(eight, "normalization")["verdict"], "not applicable");
}

#[test]
fn every_model_of_the_list_is_checked_and_no_fault_is_unknown() {
    let folder = Folder::new();
    let run = folder.glanz(&["check", "--all", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let names = |json: &serde_json::Value, key: &str| -> Vec<String> {
        json.as_array().unwrap().iter().map(|model| model[key].as_str().unwrap().to_owned()).collect()
    };
    let list = folder.glanz(&["bsdf", "list", "--format", "json"]).json();
    assert_eq!(names(&json["certificates"], "model"), names(&list["models"], "name"));
    for certificate in json["certificates"].as_array().unwrap() {
        for finding in certificate["findings"].as_array().unwrap() {
            let unknown = finding["verdict"] == "fails" && finding["known"] == false;
            assert!(!unknown, "{}: {finding}", certificate["model"]);
        }
    }
}

#[test]
fn every_kind_of_plot_is_a_picture_in_both_formats() {
    let folder = Folder::new();
    for kind in ["polar", "cartesian", "lobe3d", "albedo", "slice"] {
        for ending in ["svg", "png"] {
            let name = format!("{kind}.{ending}");
            let words = ["plot", "phong-normalized", "lambert", "--set", "shininess=5,50", "--kind", kind];
            let run = folder.glanz(&[&words[..], &["-o", &name]].concat());
            assert_eq!((run.code, run.stderr.as_str()), (0, format!("wrote {name}\n").as_str()));
            let bytes = folder.read(&name);
            match ending {
                "svg" => {
                    let text = String::from_utf8(bytes).unwrap();
                    assert!(text.contains("phong-normalized shininess=50"), "{kind}: no legend");
                    assert!(text.trim_end().ends_with("</svg>"), "{kind}");
                }
                _ => assert!(png_size(&bytes).0 >= 1000, "{kind}"),
            }
        }
    }
}

#[test]
fn every_kind_of_plot_is_drawn_of_ward() {
    let folder = Folder::new();
    for kind in ["polar", "cartesian", "lobe3d", "albedo", "slice", "terms"] {
        let file = format!("{kind}.svg");
        folder.glanz(&["plot", "ward", "--set", "alpha=0.05,0.16", "--kind", kind, "-o", &file]).text();
        assert!(folder.names().contains(&file), "{kind}");
    }
}

#[test]
fn a_plot_of_fresnel_reflectance_marks_brewsters_angle_of_dielectrics_alone() {
    let folder = Folder::new();
    folder.glanz(&["plot", "--kind", "fresnel", "--ior", "1.5,Au", "--polarised", "-o", "f.svg"]).text();
    let text = String::from_utf8(folder.read("f.svg")).unwrap();
    // atan 1.5
    assert_eq!(text.matches("Brewster").count(), 1);
    assert!(text.contains("Brewster 56.3°") && text.contains("Au, Schlick") && text.contains("n = 1.5, p"));
}

#[test]
fn plots_are_the_same_every_time_and_differ_by_what_is_asked() {
    let folder = Folder::new();
    let plot = |more: &[&str]| {
        folder.glanz(&[&["plot", "phong", "-o", "a.svg"], more].concat()).text();
        folder.read("a.svg")
    };
    let plain = plot(&[]);
    assert!(plain == plot(&[]), "another plot of the same");
    for more in
        [&["--log"][..], &["--theta", "60"], &["--quantity", "f"], &["--ior", "Au"], &["--tint", "0.5"]]
    {
        assert!(plain != plot(more), "{more:?}");
    }
}

#[test]
fn values_for_a_table_of_directions_stand_behind_its_columns() {
    let folder = Folder::new();
    folder.write(
        "dirs.csv",
        "name,theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg\n\"a, b\",30,0,45,180\n\nbelow,0,0,120,0\n",
    );
    let words = ["bsdf", "eval", "phong", "--set", "shininess=2", "--directions", "dirs.csv"];
    let text = folder.glanz(&words).text().to_owned();
    insta::assert_snapshot!(text);
    let f_cos: f64 = text.lines().nth(1).unwrap().rsplit(',').nth(1).unwrap().parse().unwrap();
    let expected = 15_f64.to_radians().cos().powi(2) / std::f64::consts::PI;
    assert!((f_cos - expected).abs() < 1e-9);
    let run = folder.glanz(&[&words[..], &["-o", "values.csv"]].concat());
    assert_eq!((run.text(), run.stderr.as_str()), ("", "wrote values.csv\n"));
    assert_eq!(String::from_utf8(folder.read("values.csv")).unwrap(), text);
}

#[test]
fn a_table_may_come_from_stdin_with_vectors() {
    use std::io::Write;
    use std::process::Stdio;
    let folder = Folder::new();
    let mut child = command(&folder.path(""))
        .args(["bsdf", "eval", "lambert", "--directions", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(b"wo_x\two_y\two_z\twi_x\twi_y\twi_z\r\n0\t0\t1\t0.6\t0\t0.8\r\n")
        .unwrap();
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let value: f64 = text.trim_end().rsplit('\t').nth(1).unwrap().parse().unwrap();
    assert!((value - 0.8 / std::f64::consts::PI).abs() < 1e-15, "{text}");
}

#[test]
fn a_lobe_of_metal_is_the_lobe_times_fresnel_at_that_wavelength() {
    let folder = Folder::new();
    let value = |more: &[&str]| {
        let words = ["bsdf", "eval", "phong", "--wo", "0,0", "--wi", "0,0", "--format", "json"];
        number(&folder.glanz(&[&words[..], more].concat()).json()["f_cos"])
    };
    let plain = value(&[]);
    // At normal incidence glass of 1.5 reflects 4 %.
    assert!((value(&["--ior", "1.5"]) / plain - 0.04).abs() < 1e-12);
    let [red, blue] = ["650", "450"].map(|nm| value(&["--ior", "Cu", "--lambda-nm", nm]) / plain);
    assert!(red > 0.9 && blue < 0.7, "copper is red: {red} {blue}");
    assert!((value(&["--tint", "0.25"]) / plain - 0.25).abs() < 1e-15);
}

#[test]
fn a_sheet_has_a_ball_for_each_pair_of_values() {
    let folder = Folder::new();
    let words = ["sheet", "blinn-phong-normalized", "--vary", "shininess=8:128:3", "--vary", "ior=Au,1.5"];
    let run = folder.glanz(&[&words[..], &["--size", "40x32", "--format", "json"]].concat());
    let json = run.json();
    assert_eq!(json["file"], "blinn-phong-normalized_sheet.png");
    assert_eq!(json["cells"].as_array().unwrap().len(), 6);
    assert_eq!(json["cells"][5]["values"], serde_json::json!({ "shininess": 128.0, "ior": 1.5 }));
    assert_eq!(json["cells"][4]["values"]["ior"], "Au");
    let (width, height) = png_size(&folder.read("blinn-phong-normalized_sheet.png"));
    assert!(width > 2 * 40 && height > 3 * 32);
}

#[test]
fn balls_of_different_metals_meshes_and_lights_differ() {
    let folder = Folder::new();
    let sheet = |more: &[&str]| {
        let words = ["sheet", "lambert", "--vary", "tint=gold,0.5", "--size", "24x24", "-o", "a.png"];
        folder.glanz(&[&words[..], more].concat()).text();
        folder.read("a.png")
    };
    let plain = sheet(&[]);
    for more in [&["--mesh", "torus"][..], &["--light", "A"], &["--ev", "1"], &["--tone-map", "none"]] {
        assert!(plain != sheet(more), "{more:?}");
    }
}
