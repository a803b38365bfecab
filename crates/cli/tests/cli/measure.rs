//! `glanz measure`: measured reflectance.

use std::fmt::Write as _;

use crate::folder::Folder;
use crate::pictures::Png;

/// A white tile and a glossy one, by one goniometer.
pub(crate) const TILE: &str = "\
# a tile
# quantity reflectance_factor
theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,r,g,b
45,180,0,0,0.9,0.8,0.7
45,180,30,90,0.9,0.8,0.7
45,180,45,0,9.5,9.4,9.3
";

#[test]
fn a_table_is_told_with_its_quantity() {
    let folder = Folder::new();
    folder.write("tile.csv", TILE);
    let facts = folder.glanz(&["measure", "info", "tile.csv", "--format", "json"]).json();
    assert_eq!(
        (facts["format"].as_str(), facts["quantity"].as_str()),
        (Some("csv"), Some("reflectance_factor"))
    );
    assert_eq!((facts["readings"].as_u64(), facts["lights"].as_u64()), (Some(3), Some(1)));
    assert!((facts["range"][1].as_f64().unwrap() - 9.5 / std::f64::consts::PI).abs() < 1e-6);
    let told =
        folder.glanz(&["measure", "info", "tile.csv", "--quantity", "brdf", "--format", "json"]).json();
    assert!((told["range"][1].as_f64().unwrap() - 9.5).abs() < 1e-6);
    let text = folder.glanz(&["measure", "info", "tile.csv"]);
    assert!(text.text().contains("readings     3, of 1 directions of the light"), "{}", text.text());
}

#[test]
fn a_table_goes_to_stdout() {
    let folder = Folder::new();
    folder.write("tile.csv", TILE);
    let run = folder.glanz(&["measure", "convert", "tile.csv", "--to", "csv", "-o", "-"]);
    assert!(run.text().contains("45,180,0,0,"), "{}", run.text());
    let sampled =
        folder.glanz(&["measure", "sample", "lambert", "--geometry", "merl", "--to", "merl", "-o", "-"]);
    assert_eq!(sampled.stdout[..4], 90_u32.to_le_bytes());
    let both =
        folder.glanz(&["measure", "convert", "tile.csv", "--to", "csv", "-o", "-", "--format", "json"]);
    assert_eq!(both.code, 2, "{}", both.stderr);
    for command in [&["smooth", "tile.csv", "--to", "csv"][..], &["fit", "tile.csv"]] {
        let run = folder.glanz(&[&["measure"], command, &["-o", "-"]].concat());
        assert_eq!(run.code, 2, "{}", run.stderr);
    }
    assert!(!folder.path("-").exists());
}

#[test]
fn tables_go_from_format_to_format_and_back() {
    let folder = Folder::new();
    for words in [
        &["sample", "ggx", "--set", "alpha=0.2", "--diffuse", "0.3", "-o", "a.bsdf"][..],
        &["convert", "a.bsdf", "-o", "same.bsdf"],
        &["convert", "a.bsdf", "-o", "b.binary"],
        &["convert", "b.binary", "-o", "same.binary"],
        &["convert", "b.binary", "-o", "c.bsdf"],
        &["convert", "a.bsdf", "-o", "d.csv", "--as", "reflectance-factor"],
    ] {
        let run = folder.glanz(&[&["measure"], words].concat());
        assert_eq!(run.code, 0, "{words:?}: {}", run.stderr);
    }
    assert!(folder.read("a.bsdf") == folder.read("same.bsdf"), "byte for byte");
    assert!(folder.read("b.binary") == folder.read("same.binary"), "byte for byte");
    let albedo = |file: &str| {
        let facts = folder.glanz(&["measure", "info", file, "--format", "json"]).json();
        facts["albedos"][1]["values"][0].as_f64().unwrap()
    };
    let (a, b, c) = (albedo("a.bsdf"), albedo("b.binary"), albedo("c.bsdf"));
    assert!((0.9..1.3).contains(&a) && (a - b).abs() < 0.02 * a && (a - c).abs() < 0.02 * a, "{a} {b} {c}");
    assert!(
        folder
            .read("d.csv")
            .starts_with(b"# ggx, by the virtual goniometer of Glanz\n# quantity reflectance_factor\n")
    );
    let run = folder.glanz(&["measure", "convert", "d.csv", "-o", "d.xml"]);
    assert!(run.code == 0 && run.stderr.contains("readings were smoothed"), "{}", run.stderr);
    let smooth = albedo("d.xml");
    assert!((smooth - a).abs() < 0.1 * a, "{smooth} for {a}");
    let run = folder.glanz(&["measure", "convert", "d.csv", "-o", "d.xyz"]);
    assert!(run.code == 2 && run.stderr.contains("names no format"), "{}", run.stderr);
}

#[test]
fn tables_go_to_zemax_and_to_klems_patches() {
    let folder = Folder::new();
    for words in [
        &["sample", "ggx", "--set", "alpha=0.3", "--diffuse", "0.3", "-o", "a.bsdf"][..],
        &["sample", "ward", "--set", "alpha_y=0.5", "--to", "zemax", "-o", "brushed.bsdf"],
        &["convert", "a.bsdf", "--to", "zemax", "-o", "zemax.bsdf"],
        &["convert", "zemax.bsdf", "--to", "zemax", "-o", "again.bsdf"],
        &["convert", "a.bsdf", "-o", "klems.xml"],
        &["convert", "klems.xml", "-o", "again.xml"],
        &["convert", "klems.xml", "-o", "klems.bsdf"],
        &["convert", "zemax.bsdf", "-o", "zemax.binary"],
    ] {
        let run = folder.glanz(&[&["measure"], words].concat());
        assert_eq!(run.code, 0, "{words:?}: {}", run.stderr);
    }
    assert!(folder.read("zemax.bsdf") == folder.read("again.bsdf"), "byte for byte");
    assert!(folder.read("klems.xml") == folder.read("again.xml"), "byte for byte");
    assert!(folder.read("brushed.bsdf").windows(14).any(|words| words == b"ASymmetrical4D"));
    // Y of the files of X, Y and Z, green of the others: all are grey.
    let albedo = |file: &str| {
        let facts = folder.glanz(&["measure", "info", file, "--format", "json"]).json();
        facts["albedos"][2]["values"][1].as_f64().unwrap()
    };
    let own = albedo("a.bsdf");
    for file in ["zemax.bsdf", "klems.xml", "klems.bsdf", "zemax.binary"] {
        assert!((albedo(file) - own).abs() < 0.03 * own, "{file}: {} {own}", albedo(file));
    }
    folder.write("fit.fit", "white = Lambertian(albedo = [0.9, 0.9, 0.9])");
    let run = folder.glanz(&["measure", "info", "fit.fit"]);
    assert!(run.stderr.contains("fitted models, not readings"), "{}", run.stderr);
}

#[test]
fn noise_is_the_same_for_the_same_seed_and_as_great_as_asked() {
    let folder = Folder::new();
    let sample = |name: &str, more: &[&str]| {
        folder.glanz(&[&["measure", "sample", "lambert", "-o", name], more].concat()).text();
        String::from_utf8(folder.read(name)).unwrap()
    };
    let values = |text: &str| -> Vec<f64> {
        let rows = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        rows.map(|line| line.rsplit(',').next().unwrap().parse().unwrap()).collect()
    };
    let clean = values(&sample("clean.csv", &[]));
    assert!(clean.iter().all(|value| (value - std::f64::consts::FRAC_1_PI).abs() < 1e-6));
    let noisy = sample("noisy.csv", &["--noise", "0.05"]);
    assert_eq!(noisy, sample("again.csv", &["--noise", "0.05"]));
    assert_ne!(noisy, sample("other.csv", &["--noise", "0.05", "--seed", "2"]));
    let parts: Vec<f64> = values(&noisy).iter().map(|value| value * std::f64::consts::PI - 1.0).collect();
    let n = parts.len() as f64;
    let (mean, square) = (parts.iter().sum::<f64>() / n, parts.iter().map(|x| x * x).sum::<f64>() / n);
    assert!(n > 2000.0 && mean.abs() < 0.004 && (square.sqrt() - 0.05).abs() < 0.003, "{mean} {square}");
    let plane = sample("plane.csv", &["--geometry", "in-plane", "--as", "reflectance-factor"]);
    assert!(values(&plane).len() == 6 * 35 && values(&plane).iter().all(|value| (value - 1.0).abs() < 1e-6));
}

#[test]
fn an_error_of_a_table_shows_its_line() {
    let folder = Folder::new();
    let mut text = TILE.to_owned();
    writeln!(text, "45,180,50,0,x,1,1").unwrap();
    folder.write("wrong.csv", text);
    let run = folder.glanz(&["measure", "info", "wrong.csv"]);
    assert!(run.stderr.contains("column 'r': expected a number, found 'x'"), "{}", run.stderr);
    assert!(run.stderr.contains("wrong.csv:7:1"), "{}", run.stderr);
}

#[test]
fn appearance_is_told_of_models_and_of_their_tables() {
    let folder = Folder::new();
    let numbers = |words: &[&str]| {
        let words = [&["measure", "appearance"], words, &["--format", "json"]].concat();
        folder.glanz(&words).json()
    };
    let first = |facts: &serde_json::Value, key: &str| facts[key][0].as_f64().unwrap();
    let model = numbers(&["ggx", "--set", "alpha=0.2", "--diffuse", "0.3"]);
    let sample = ["measure", "sample", "ggx", "--set", "alpha=0.2", "--diffuse", "0.3", "-o", "ggx.bsdf"];
    folder.glanz(&sample).text();
    let table = numbers(&["ggx.bsdf"]);
    for (key, part) in
        [("gloss_20", 0.02), ("gloss_60", 0.02), ("factor_45_0", 0.01), ("sphere_included", 0.01)]
    {
        let (a, b) = (first(&model, key), first(&table, key));
        assert!((a - b).abs() < part * a, "{key}: {a} of the model, {b} of its table");
    }
    let white = numbers(&["lambert"]);
    assert!((first(&white, "sphere_included") - 1.0).abs() < 1e-4 && first(&white, "gloss_60") < 2.6);
    assert!(folder.glanz(&["measure", "appearance", "lambert"]).text().contains("gloss 60°             2.5"));
}

#[test]
fn a_fit_is_ranked_and_is_a_material() {
    let folder = Folder::new();
    let sample = [
        "measure",
        "sample",
        "ggx",
        "--set",
        "alpha=0.15",
        "--diffuse",
        "0.4",
        "--noise",
        "0.03",
        "-o",
        "a.csv",
    ];
    folder.glanz(&sample).text();
    let words = ["measure", "fit", "a.csv", "--models", "ward+lambert,ggx+lambert,lambert", "-o", "fit.toml"];
    let facts = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    let best = &facts["fits"][0];
    assert_eq!(best["models"], "ggx+lambert");
    let near = |value: &serde_json::Value, expected: f64| {
        (value.as_f64().unwrap() - expected).abs() < 0.02 * expected
    };
    assert!(
        near(&best["lobes"][0]["parameters"][0]["value"], 0.15) && near(&best["lobes"][0]["tint"][0], 1.0),
        "{best}"
    );
    assert!(near(&best["lobes"][1]["tint"][0], 0.4), "{best}");
    assert!(best["error"].as_f64() < facts["fits"][1]["error"].as_f64());
    // What is written is a material.
    let draws = |text: &str| {
        let scene = format!(
            "{text}\n[image]\nwidth = 16\nheight = 16\n[[lights]]\nkind = \"directional\"\ndirection = [0, 0, -1]\n\
             [[objects]]\nmaterial = \"fitted\"\nmesh = {{ sphere = {{}} }}\n"
        );
        folder.write("scene.toml", scene);
        let run = folder.glanz(&["render", "scene.toml", "-o", "a.png"]);
        assert_eq!(run.code, 0, "{}", run.stderr);
    };
    draws(&String::from_utf8(folder.read("fit.toml")).unwrap());
    // With tints at normal and at grazing incidence, and with two widths.
    for (models, expected) in
        [("ggx:schlick+diffuse", "schlick = { angle = \"half\""), ("ggx:aniso+lambert", "aniso_deg = ")]
    {
        let run = folder.glanz(&["measure", "fit", "a.csv", "--models", models, "-o", "more.toml"]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        let text = String::from_utf8(folder.read("more.toml")).unwrap();
        assert!(text.contains(expected), "{text}");
        draws(&text);
    }
    // Two lobes say no more than one.
    let run = folder.glanz(&["measure", "fit", "a.csv", "--models", "ggx*2+lambert,ggx+lambert"]);
    assert!(run.text().contains("no better than that"), "{}", run.text());
    for (models, expected) in
        [("mirror", "mirror has no values"), ("gxg", "gxg"), ("ggx*9", "'ggx*9' is no lobe")]
    {
        let run = folder.glanz(&["measure", "fit", "a.csv", "--models", models]);
        assert!(run.code == 2 && run.stderr.contains(expected), "{}", run.stderr);
    }
}

#[test]
fn fits_are_ranked_by_how_different_balls_look() {
    let folder = Folder::new();
    let sample =
        ["measure", "sample", "ggx", "--set", "alpha=0.3", "--tint", "0.2", "--diffuse", "0.4", "-o"];
    folder.glanz(&[&sample[..], &["a.csv"]].concat()).text();
    let fit = ["measure", "fit", "a.csv", "--models", "lambert,ggx+lambert", "--metric", "rendered"];
    for by in ["metric", "rendered", "balls"] {
        let facts = folder.glanz(&[&fit[..], &["--rank-by", by, "--format", "json"]].concat()).json();
        assert_eq!((&facts["metric"], &facts["ranked_by"]), (&"rendered".into(), &by.into()));
        let [best, worst] = [0, 1].map(|i| &facts["fits"][i]);
        assert_eq!((&best["models"], &worst["models"]), (&"ggx+lambert".into(), &"lambert".into()), "{by}");
        // Exact readings, rounded to f32: nothing is left of the colour's difference.
        let p95 = |fit: &serde_json::Value| fit["delta_e"]["p95"].as_f64().unwrap();
        assert!(p95(best) < 0.01 && p95(worst) > 1.0, "{facts}");
        assert_eq!(best["balls"].as_array().unwrap().len(), if by == "balls" { 2 } else { 0 }, "{by}");
        if by == "balls" {
            // Balls of data are those of the table over the carrier, in codes of eight bits.
            let mean = |fit: &serde_json::Value| fit["balls"][1]["delta_e"]["mean"].as_f64().unwrap();
            assert!(mean(best) < 0.5 && mean(worst) > 2.0 * mean(best), "{facts}");
        }
    }
    let run = folder.glanz(&[&fit[..], &["--rank-by", "balls"]].concat());
    let text = run.text();
    assert!(
        text.contains("readings as rendered: ΔE00 median") && text.contains("ball, studio: ΔE00 mean"),
        "{text}"
    );
    // X, Y and Z are no material of which a ball could be drawn.
    folder.write(
        "xyz.csv",
        "theta_i_deg,theta_o_deg,X,Y,Z\n0,0,.2,.2,.2\n0,9,.2,.2,.2\n9,0,.2,.2,.2\n9,9,.2,.2,.2\n",
    );
    let run = folder.glanz(&["measure", "fit", "xyz.csv", "--models", "lambert", "--rank-by", "balls"]);
    assert!(run.code == 3 && run.stderr.contains("rank by rendered"), "{}: {}", run.code, run.stderr);
}

#[test]
fn a_brushed_sample_is_fitted_with_two_widths_unless_that_is_forbidden() {
    let folder = Folder::new();
    let sample = "measure sample ggx --set alpha=0.1 --set alpha_y=0.3 --tint 0.6 --aniso-deg 30 --every 7 --noise 0.05 -o a.csv";
    folder.glanz(&sample.split(' ').collect::<Vec<_>>()).text();
    let fit = |models: &str| folder.glanz(&["measure", "fit", "a.csv", "--models", models]).text().to_owned();
    let free = fit("ggx+lambert");
    assert!(free.contains("two widths, grain at 30.") || free.contains("two widths, grain at 29."), "{free}");
    assert!(free.contains("rather than") && free.contains("alpha_y = 0.3"), "{free}");
    assert!(!fit("ggx:iso+lambert").contains("grain at"));
    let forced = fit("ggx:aniso+lambert");
    assert!(forced.contains("grain at") && !forced.contains("rather than"), "{forced}");
}

/// What `measure appearance` tells programs.
fn appearance(folder: &Folder, words: &[&str]) -> serde_json::Value {
    folder.glanz(&[&["measure", "appearance"], words, &["--format", "json"]].concat()).json()
}

/// The colour in a geometry.
fn color(facts: &serde_json::Value, geometry: &str, key: &str, index: usize) -> f64 {
    let all = facts["colors"].as_array().unwrap();
    let found = all.iter().find(|color| color["geometry"] == geometry).unwrap();
    found[key][index].as_f64().unwrap()
}

#[test]
fn paint_has_the_numbers_of_another_program() {
    let folder = Folder::new();
    let words = ["--set", "alpha=0.1", "--set", "multiscatter=0", "--ior", "1.5", "--diffuse", "0.3"];
    let paint = appearance(&folder, &[&["ggx"], &words[..]].concat());
    // Numpy; light is reflected once there.
    assert!((paint["flop_index"].as_f64().unwrap() - 1.824).abs() < 1e-3, "{}", paint["flop_index"]);
    for (key, expected) in [("sphere_included", 0.3397), ("sphere_excluded", 0.3336), ("factor_45_0", 0.3059)]
    {
        assert!((paint[key][0].as_f64().unwrap() - expected).abs() < 1e-4, "{key}: {}", paint[key]);
    }
    assert_eq!((paint["gloss_chosen_deg"].as_f64(), paint["haze_d4039"][0].is_null()), (Some(60.0), true));
    assert!(paint["haze_e430_narrow"][0].as_f64() > paint["haze_e430_wide"][0].as_f64());
    // What is told for people is shorter, and says what rests on memory.
    let run = folder.glanz(&["measure", "appearance", "ggx", "--set", "alpha=0.1", "--ior", "1.5"]);
    assert!(run.text().contains("not verified against a standard:\n  apertures"), "{}", run.text());
    assert!(run.text().contains("haze ISO 13803") && !run.text().contains("haze D4039"), "{}", run.text());
}

#[test]
fn what_glows_is_whiter_where_there_is_ultraviolet() {
    let folder = Folder::new();
    let whiteness = |words: &[&str]| {
        let facts = appearance(&folder, words);
        (facts["whiteness"]["whiteness"].as_f64().unwrap(), facts)
    };
    let (day, facts) = whiteness(&["paper-brightened"]);
    let (lamp, _) = whiteness(&["paper-brightened", "--light", "LED-B3"]);
    assert!(day > 110.0 && lamp < day - 20.0, "{day} {lamp}");
    assert_eq!(facts["yellowness"].as_array().unwrap().len(), 5);
    assert!(facts["yellowness"][0]["yellowness"].as_f64().unwrap() < 0.0, "it is bluish");
    // The same surface as the material of a scene.
    let scene = "[materials.paper]\nlobes = [{ shape = \"lambert\", tint = { reradiation = \"paper-brightened\" } }]\n\
                 [materials.other]\nlibrary = \"gold\"\n";
    folder.write("paper.toml", scene);
    let (same, _) = whiteness(&["paper.toml", "--material", "paper"]);
    assert_eq!(same, day);
    let run = folder.glanz(&["measure", "appearance", "paper.toml"]);
    assert!(run.code == 2 && run.stderr.contains("name one with --material: paper, other"), "{}", run.stderr);
    // Gold is yellow, and no white.
    let gold = folder.glanz(&["measure", "appearance", "gold"]);
    assert!(gold.text().contains("no whiteness: W and T are beyond"), "{}", gold.text());
}

#[test]
fn rgb_is_under_d65_whatever_light_and_a_fit_is_a_material() {
    let folder = Folder::new();
    let sample = ["measure", "sample", "ggx", "--set", "alpha=0.2", "--diffuse", "0.3", "-o", "a.bsdf"];
    folder.glanz(&sample).text();
    let [d65, a] = ["D65", "A"].map(|light| appearance(&folder, &["a.bsdf", "--light", light]));
    assert_eq!(color(&d65, "45/0", "xyz", 0), color(&a, "45/0", "xyz", 0));
    assert!(a["notes"].to_string().contains("linear sRGB"), "{}", a["notes"]);
    assert_eq!(a["yellowness"].as_array().unwrap().len(), 1);
    let words =
        ["measure", "fit", "a.bsdf", "--models", "ggx+lambert", "-o", "fit.toml", "--report", "fit.csv"];
    folder.glanz(&words).text();
    let report = std::fs::read_to_string(folder.path("fit.csv")).unwrap();
    assert!(
        report.contains("\"read, light at 0°\",") && report.contains("\"fitted, light at 0°\","),
        "{report}"
    );
    let fit = appearance(&folder, &["fit.toml"]);
    for (geometry, within) in [("45/0", 0.5), ("45as15", 1.0), ("sci", 1.0)] {
        let (own, fitted) = (color(&d65, geometry, "lab", 0), color(&fit, geometry, "lab", 0));
        assert!((own - fitted).abs() < within, "{geometry}: {own} {fitted}");
    }
}

#[test]
fn what_makes_no_sense_of_an_appearance_is_refused() {
    let folder = Folder::new();
    for (words, expected) in [
        (&["gold", "--set", "alpha=0.1"][..], "--set is of models, and 'gold' is none"),
        (&["gold", "--observer", "lms2"], "has no X, Y, Z"),
        (&["gold", "--material", "x"], "--material is of scene files"),
        (&["gould"], "did you mean 'gold'"),
        (&["ggx", "--light", "FL99"], "there is no light 'FL99'"),
    ] {
        let run = folder.glanz(&[&["measure", "appearance"], words].concat());
        assert!(run.code == 2 && run.stderr.contains(expected), "{words:?}: {}", run.stderr);
    }
}

#[test]
fn readings_are_smoothed_and_compared() {
    let folder = Folder::new();
    let sample = ["measure", "sample", "ward", "--set", "alpha=0.2", "--diffuse", "0.3", "--noise", "0.05"];
    folder.glanz(&[&sample[..], &["--geometry", "hemisphere", "-o", "noisy.csv"]].concat()).text();
    folder.glanz(&[&sample[..7], &["--geometry", "hemisphere", "-o", "exact.csv"]].concat()).text();
    let smooth = ["measure", "smooth", "noisy.csv", "-o", "smooth.bsdf", "--format", "json"];
    let facts = folder.glanz(&smooth).json();
    // Without -o the numbers are told alone, and --to is of a file.
    let told = folder.glanz(&["measure", "smooth", "noisy.csv", "--format", "json"]).json();
    assert!(told["file"].is_null() && told["format"].is_null() && told["holes"].is_number(), "{told}");
    assert_eq!([&told["readings"], &told["noise"]], [&facts["readings"], &facts["noise"]]);
    assert_eq!(folder.glanz(&["measure", "smooth", "noisy.csv", "--to", "rgl"]).code, 2);
    assert_eq!((facts["format"].as_str(), facts["readings"].as_u64()), (Some("rgl"), Some(2454)));
    assert_eq!(facts["anisotropic"].as_bool(), Some(false));
    let noise = facts["noise"].as_f64().unwrap();
    assert!((0.03..0.08).contains(&noise), "{noise}");
    let compare = |words: &[&str]| {
        let more = ["--size", "32x32", "--format", "json"];
        folder.glanz(&[&["measure", "compare"], words, &more[..]].concat()).json()
    };
    let facts = compare(&["exact.csv", "smooth.bsdf", "-o", "balls.png"]);
    let median = facts["delta_e"]["median"].as_f64().unwrap();
    assert!(median < 1.5, "{median}");
    assert_eq!(
        (facts["metrics"].as_array().unwrap().len(), facts["balls"].as_array().unwrap().len()),
        (3, 2)
    );
    let balls = Png::decode(&folder.read("balls.png"));
    assert!((0..32).any(|x| balls.pixel(x, 20)[0] > 100), "balls are lit");
    // Far from what it is not.
    let far = compare(&["exact.csv", "velvet-red"])["delta_e"]["median"].as_f64().unwrap();
    assert!(far > 10.0 * median, "{far}");
    // A table of directions with what is known about them.
    folder.glanz(&["measure", "smooth", "noisy.csv", "-o", "grid.csv", "--neighbours", "4"]).text();
    let text = std::fs::read_to_string(folder.path("grid.csv")).unwrap();
    assert!(text.lines().nth(2).unwrap().ends_with(",Y,distance"), "{text}");
    assert!(folder.glanz(&["measure", "info", "grid.csv"]).text().contains("one channel"));
    // Numbers of appearance are of what lies between readings.
    let [own, exact] = ["noisy.csv", "smooth.bsdf"].map(|name| {
        appearance(&folder, &[name])["colors"][0]["lab"][0].as_f64().unwrap_or_else(|| panic!("{name}"))
    });
    assert!((own - exact).abs() < 1.0, "{own} {exact}");
}

#[test]
fn data_stand_where_models_do_and_in_scenes() {
    let folder = Folder::new();
    let sample = ["measure", "sample", "ggx", "--set", "alpha=0.2", "--diffuse", "0.3", "-o", "a.bsdf"];
    folder.glanz(&sample).text();
    let run = folder.glanz(&["check", "a.bsdf", "--allow-known"]);
    let told = String::from_utf8_lossy(&run.stdout);
    assert!(told.contains("reciprocity") && told.contains("lanes"), "{told}{}", run.stderr);
    folder.glanz(&["plot", "a.bsdf", "ggx", "--theta", "30,60", "-o", "a.svg"]).text();
    assert!(std::fs::read_to_string(folder.path("a.svg")).unwrap().contains("a.bsdf"));
    let scene = |keys: &str| {
        format!(
            "[image]\nwidth = 24\nheight = 24\n[[lights]]\nkind = \"directional\"\ndirection = [0, 0, -1]\n\
             [materials.m]\n{keys}\n[[objects]]\nmesh = \"sphere\"\nmaterial = \"m\"\n"
        )
    };
    folder.write("data.toml", scene("measured = { file = \"a.bsdf\" }"));
    folder.write(
        "model.toml",
        scene("lobes = [{ shape = \"ggx\", alpha = 0.2 }, { shape = \"lambert\", tint = 0.3 }]"),
    );
    for mode in ["rgb", "spectral"] {
        for name in ["data", "model"] {
            let (input, output) = (format!("{name}.toml"), format!("{name}.exr"));
            folder.glanz(&["render", &input, "--mode", mode, "-o", &output, "--force"]).text();
        }
        let facts = folder.glanz(&["compare", "model.exr", "data.exr", "--format", "json"]).json();
        let de = facts["measurements"].to_string();
        assert!(!de.is_empty());
        folder.glanz(&["compare", "model.exr", "data.exr", "--fail-above", "de2000.median=0.3"]).text();
    }
    let told = folder.glanz(&["info", "data.toml"]);
    assert!(told.text().contains("measured: 1 rank of 48 x 48 x 17 factors"), "{}", told.text());
    for (keys, expected) in [
        ("measured = { file = \"b.bsdf\" }", "there is no file 'b.bsdf'"),
        ("measured = { file = \"a.bsdf\", ranks = 4 }", "4 ranks of 3 channels"),
        ("measured = { file = \"a.bsdf\", ranks = \"all\" }", "\"auto\", or a number from 1 to 8"),
        ("measured = { file = \"a.bsdf\", neighbours = 0 }", "expected a number from 1 to 1000, found 0"),
        ("measured = { file = \"wrong.toml\" }", "'wrong.toml'"),
        ("measured = { file = \"a.bsdf\" }\ndiffuse = 0.5", "'diffuse' beside 'measured'"),
    ] {
        folder.write("wrong.toml", scene(keys));
        let run = folder.glanz(&["render", "wrong.toml", "-o", "wrong.png"]);
        assert!(run.code == 3 && run.stderr.contains(expected), "{keys}: {}", run.stderr);
    }
}
