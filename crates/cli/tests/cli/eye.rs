//! `glanz eye`, and eyes as observers of other commands.

use crate::folder::Folder;
use crate::pictures::Png;

/// Two patches that differ for people with all cones, and hardly without M.
const PATCHES: &str = r#"
[image]
width = 48
height = 32
[camera]
eye = [0.0, 0.0, 5.0]
projection = "orthographic"
height = 2.0
[render]
mode = "spectral"
[[lights]]
kind = "directional"
direction = [0.0, 0.0, -1.0]
spectrum = "D65"
[materials.brown]
diffuse = [0.30, 0.20, 0.16]
[materials.green]
diffuse = [0.165, 0.26, 0.16]
[materials.white]
diffuse = 0.9
[[objects]]
name = "brown"
mesh = "quad"
material = "brown"
scale = [0.4, 1.0, 1.0]
translate = [-1.0, 0.0, 0.0]
[[objects]]
name = "green"
mesh = "quad"
material = "green"
scale = [0.4, 1.0, 1.0]
[[objects]]
name = "white"
mesh = "quad"
material = "white"
scale = [0.4, 1.0, 1.0]
translate = [1.0, 0.0, 0.0]
"#;

fn patches() -> Folder {
    let folder = Folder::new();
    folder.write("s.toml", PATCHES);
    folder
}

/// A pixel of the white patch.
fn white(png: &Png) -> [u8; 4] {
    png.pixel(40, 16)
}

#[test]
fn an_old_eye_sees_yellow_unadapted_and_white_adapted() {
    let folder = patches();
    folder.glanz(&["render", "s.toml", "--observer", "age:75", "-o", "adapted.png"]).text();
    let [r, g, b, _] = white(&Png::decode(&folder.read("adapted.png")));
    assert!(r.abs_diff(b) <= 1 && r.abs_diff(g) <= 1, "{r} {g} {b}");
    folder.write("old.toml", format!("[eye]\nage = 75\nadapted = 0\n{PATCHES}"));
    folder.glanz(&["render", "old.toml", "-o", "yellow.png"]).text();
    let [r, _, b, _] = white(&Png::decode(&folder.read("yellow.png")));
    assert!(b < r - 40, "{r} {b}");
}

#[test]
fn a_sheet_of_ages_has_both_adaptations() {
    let folder = patches();
    let facts =
        folder.glanz(&["eye", "s.toml", "--age", "20,50,80", "-o", "a.png", "--format", "json"]).json();
    let eyes = facts["eyes"].as_array().unwrap();
    assert_eq!(eyes.len(), 6);
    assert_eq!((&eyes[0]["observer"], &eyes[0]["adapted"]), (&"age:20".into(), &0.0.into()));
    assert_eq!((&eyes[5]["label"], &eyes[5]["adapted"]), (&"80 years, adapted".into(), &1.0.into()));
    let sheet = Png::decode(&folder.read("a.png"));
    assert!(sheet.width > 3 * 48 && sheet.height > 2 * 32);
}

#[test]
fn pairs_that_a_deficiency_makes_alike_are_named() {
    let folder = patches();
    let words = ["eye", "s.toml", "--deficiency", "none,deutan:8,deutan,tritan", "-o", "a.png"];
    let facts = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    let losses = facts["patches"]["eyes"].as_array().unwrap();
    assert_eq!(losses.len(), 3);
    let alike = |loss: &serde_json::Value| loss["alike"].as_array().unwrap().len();
    assert_eq!(losses.iter().map(alike).collect::<Vec<_>>(), [0, 1, 0]);
    assert_eq!(losses[1]["alike"][0]["objects"], serde_json::json!(["brown", "green"]));
    assert!(losses[1]["alike"][0]["before"].as_f64().unwrap() > 10.0);
    let text = folder.glanz(&words).text().to_owned();
    assert!(text.contains("brown and green") && text.contains("1 pairs become alike"), "{text}");
}

#[test]
fn levels_change_the_part_of_the_cones() {
    let folder = patches();
    let words = ["eye", "s.toml", "--level", "day,dusk,moon,0.002", "-o", "a.png", "--format", "json"];
    let facts = folder.glanz(&words).json();
    let part = |i: usize| facts["eyes"][i]["seen"]["cones"].as_f64();
    assert_eq!(part(0), None, "by day nothing but cones");
    assert!(part(1).unwrap() > 0.4 && part(2).unwrap() < part(1).unwrap() && part(3) == Some(0.0));
    assert!(facts["eyes"][2]["seen"]["pupil_mm"].as_f64().unwrap() > 6.0);
    folder.write(
        "lamp.toml",
        PATCHES.replace("spectrum = \"D65\"\n", "spectrum = \"D65\"\nilluminance_lx = 3.0\n"),
    );
    let failure = folder.glanz(&["eye", "lamp.toml", "--level", "dusk", "-o", "b.png"]).failure();
    assert!(failure.contains("photometric units"), "{failure}");
    let facts = folder.glanz(&["eye", "lamp.toml", "-o", "b.png", "--format", "json"]).json();
    let cones = facts["eyes"][0]["seen"]["cones"].as_f64().unwrap();
    assert!((0.3..0.9).contains(&cones), "3 lx are dusk: {cones}");
}

#[test]
fn a_picture_is_taken_apart_by_receptors_and_by_the_nerve() {
    let folder = patches();
    for (show, count) in [("receptors", 4), ("opponent", 6), ("glare", 2), ("acuity", 2)] {
        let file = format!("{show}.png");
        folder.glanz(&["eye", "s.toml", "--observer", "deutan", "--show", show, "-o", &file]).text();
        let sheet = Png::decode(&folder.read(&file));
        assert!(sheet.width > count * 48, "{show}: {} x {}", sheet.width, sheet.height);
    }
}

#[test]
fn a_film_goes_through_ages() {
    let folder = patches();
    folder.glanz(&["eye", "s.toml", "--age", "20:80:5", "--adapted", "0", "-o", "a.gif"]).text();
    assert!(folder.read("a.gif").starts_with(b"GIF89a"));
    let failure =
        folder.glanz(&["eye", "s.toml", "--age", "20:80:5", "--show", "opponent", "-o", "a.gif"]).failure();
    assert!(failure.contains("leave out --show"), "{failure}");
}

#[test]
fn other_commands_take_eyes_for_observers() {
    let folder = patches();
    let text = folder.glanz(&["color", "spectrum", "D65", "--observer", "age:70"]).text().to_owned();
    assert!(text.contains("age:70"), "{text}");
    // An RGB scene is seen in spectra, since an eye sees no RGB.
    folder.write("rgb.toml", PATCHES.replace("mode = \"spectral\"", ""));
    folder.glanz(&["render", "rgb.toml", "--observer", "deutan", "-o", "a.png"]).text();
    folder.glanz(&["render", "s.toml", "--observer", "deutan", "-o", "b.png"]).text();
    assert_eq!(
        Png::decode(&folder.read("a.png")).pixel(8, 16),
        Png::decode(&folder.read("b.png")).pixel(8, 16)
    );
}

#[test]
fn wrong_eyes_say_what_would_be_right() {
    let folder = patches();
    for (words, expected) in [
        (&["render", "s.toml", "--observer", "age:700", "-o", "a.png"][..], "5 to 100 years"),
        (&["eye", "s.toml", "--age", "old", "-o", "a.png"], "20,50,80"),
        (&["eye", "s.toml", "--level", "dark", "-o", "a.png"], "sun, day, room, dusk, moon, stars"),
        (&["eye", "s.toml", "--deficiency", "dutan", "-o", "a.png"], "deutan"),
        (&["eye", "s.toml", "--deficiency", "age:70", "-o", "a.png"], "expected none, protan"),
        (&["eye", "s.toml", "--observer", "lms2", "-o", "a.png"], "--observer is an eye here"),
        (&["eye", "s.toml", "--adapted", "2", "-o", "a.png"], "adapted is 0 to 1"),
        (&["eye", "s.toml", "--age", "20,50", "-o", "a.exr"], ".png"),
    ] {
        let failure = folder.glanz(words).failure();
        assert!(failure.contains(expected), "{words:?}: {failure}");
    }
    folder.write(
        "two.toml",
        PATCHES.replace("mode = \"spectral\"", "mode = \"spectral\"\nobserver = \"lms2\"\n[eye]\nage = 30"),
    );
    let failure = folder.glanz(&["render", "two.toml", "-o", "a.png"]).failure();
    assert!(failure.contains("an eye and an observer"), "{failure}");
    folder.write("wrong.toml", format!("[eye]\ndeficiency = \"dutan\"\n{PATCHES}"));
    let failure = folder.glanz(&["render", "wrong.toml", "-o", "a.png"]).failure();
    assert!(failure.contains("dutan") && failure.contains("wrong.toml"), "{failure}");
}

#[test]
fn pictures_are_looked_at_as_scenes_are() {
    let folder = patches();
    folder.glanz(&["render", "s.toml", "--spectral-exr", "-o", "spectra.exr"]).text();
    for eye in ["age:75", "deutan", "protan:12+age:60"] {
        folder.glanz(&["render", "s.toml", "--observer", eye, "-o", "scene.png"]).text();
        folder.glanz(&["render", "spectra.exr", "--observer", eye, "-o", "picture.png"]).text();
        let (scene, picture) =
            (Png::decode(&folder.read("scene.png")), Png::decode(&folder.read("picture.png")));
        for x in [8, 24, 40] {
            let (a, b) = (scene.pixel(x, 16), picture.pixel(x, 16));
            assert!(a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1), "{eye} at {x}: {a:?} {b:?}");
        }
    }
    folder.glanz(&["render", "s.toml", "-o", "codes.png"]).text();
    let run = folder.glanz(&["render", "codes.png", "--observer", "tritan", "-o", "seen.png"]);
    assert!(run.code == 0 && run.stderr.contains("the picture has no spectra"), "{}", run.stderr);
    let [r, g, b, _] = white(&Png::decode(&folder.read("seen.png")));
    assert!(r.abs_diff(g) <= 2 && g.abs_diff(b) <= 2, "{r} {g} {b}");
    let failure = folder.glanz(&["render", "codes.png", "-o", "x.png"]).failure();
    assert!(failure.contains("name the eye"), "{failure}");
}

#[test]
fn sheets_are_drawn_of_pictures_too() {
    let folder = patches();
    folder.glanz(&["render", "s.toml", "--spectral-exr", "-o", "spectra.exr"]).text();
    folder.glanz(&["render", "s.toml", "-o", "codes.png"]).text();
    for file in ["spectra.exr", "codes.png"] {
        let words = ["eye", file, "--age", "20,80", "-o", "ages.png", "--format", "json"];
        let facts = folder.glanz(&words).json();
        assert_eq!(facts["eyes"].as_array().unwrap().len(), 4, "{facts:#}");
        for show in ["receptors", "opponent", "glare", "acuity"] {
            folder.glanz(&["eye", file, "--show", show, "-o", "x.png", "--force"]).text();
            let sheet = Png::decode(&folder.read("x.png"));
            assert!(sheet.width >= 2 * 48, "{file}, {show}");
        }
    }
    folder.glanz(&["eye", "codes.png", "--population", "3", "-o", "people.png"]).text();
    folder.glanz(&["eye", "codes.png", "--observer", "population:3", "-o", "same.png"]).text();
    assert!(folder.read("people.png") == folder.read("same.png"));
    let failure = folder.glanz(&["eye", "codes.png", "--mach", "y=3", "-o", "m.svg"]).failure();
    assert!(failure.contains("one shading"), "{failure}");
    let failure = folder.glanz(&["render", "s.toml", "--observer", "population:5", "-o", "x.png"]).failure();
    assert!(failure.contains("glanz eye SCENE --population 5"), "{failure}");
}

#[test]
fn photons_are_noise_and_colours_go_out_of_focus() {
    let folder = patches();
    let draw = |file: &str, words: &[&str]| {
        let base = ["eye", "s.toml", "--level", "stars", "--px-per-deg", "40", "-o", file];
        folder.glanz(&[&base[..], words].concat()).text();
        folder.read(file)
    };
    let (still, noise, again) =
        (draw("a.png", &[]), draw("b.png", &["--noise"]), draw("c.png", &["--noise", "1"]));
    assert!(still != noise && noise == again && noise != draw("d.png", &["--noise", "2"]));
    assert!(still != draw("e.png", &["--chromatic"]));
    // A scene says the same: each pixel of its picture is that of the other's.
    let scene = |file: &str, noise: &str| {
        folder.write("n.toml", format!("[eye]\nlevel = \"stars\"\npx_per_deg = 40\n{noise}{PATCHES}"));
        folder.glanz(&["render", "n.toml", "-o", file]).text();
        let png = Png::decode(&folder.read(file));
        (0..48).map(|x| png.pixel(x, 16)).collect::<Vec<_>>()
    };
    let (seeded, without) = (scene("f.png", "noise = 1\n"), scene("g.png", ""));
    assert!(seeded != without && seeded != scene("h.png", "noise = 2\n"));
    assert_eq!(seeded, scene("i.png", "noise = 1\n"));
    folder.write("bad.toml", format!("[eye]\nnoise = -1\n{PATCHES}"));
    let failure = folder.glanz(&["render", "bad.toml", "-o", "x.png"]).failure();
    assert!(failure.contains("a whole number from 0 to 4294967295"), "{failure}");
}

#[test]
fn bands_of_a_row_are_told_by_their_places() {
    let folder = patches();
    let facts = folder
        .glanz(&["eye", "s.toml", "--mach", "y=16", "--gain", "5", "-o", "m.svg", "--format", "json"])
        .json();
    let shadings = facts["shadings"].as_array().unwrap();
    assert_eq!(shadings.len(), 3);
    // Three patches have six edges, each with a band on both sides.
    assert!(shadings[2]["bands"].as_array().unwrap().len() >= 6, "{facts:#}");
    assert!(folder.read("m.svg").starts_with(b"<svg"));
    let failure = folder.glanz(&["eye", "s.toml", "--mach", "y=99", "-o", "m.svg"]).failure();
    assert!(failure.contains("rows 0 to 31"), "{failure}");
}

#[test]
fn people_differ_and_the_same_seed_gives_the_same_people() {
    let folder = patches();
    let people = |file: &str, seed: &str| {
        let words = ["eye", "s.toml", "--population", "6", "--seed", seed, "-o", file, "--format", "json"];
        folder.glanz(&words).json()["delta_e_00"]["mean"].as_f64().unwrap()
    };
    let (a, again, other) = (people("a.png", "1"), people("b.png", "1"), people("c.png", "2"));
    assert!(a == again && a != other && (0.1..6.0).contains(&a), "{a} {other}");
    assert!(folder.read("a.png") == folder.read("b.png"));
}

#[test]
fn another_way_to_show_a_deficiency_stands_beside_true_cones() {
    let folder = patches();
    let ways = ["--against", "machado,daltonlens", "-o", "a.png"];
    let words = [&["eye", "s.toml", "--deficiency", "deutan,tritan"][..], &ways].concat();
    let facts = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    for eye in facts["eyes"].as_array().unwrap() {
        let mean = |i: usize| eye["against"][i]["mean"].as_f64().unwrap();
        assert!((0.1..12.0).contains(&mean(0)) && (0.1..6.0).contains(&mean(1)), "{eye:#}");
        assert_eq!((&eye["against"][1]["way"], mean(1) < mean(0)), (&"DaltonLens".into(), true));
    }
    let failure = folder
        .glanz(&["eye", "s.toml", "--deficiency", "deutan:5", "--against", "machado", "-o", "a.png"])
        .failure();
    assert!(failure.contains("protan, deutan and tritan"), "{failure}");
}
