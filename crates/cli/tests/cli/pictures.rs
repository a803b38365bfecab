//! `glanz render`, `sweep` and `shade-compare`: the pictures that they write.

use std::io::Cursor;

use crate::folder::Folder;

/// A decoded PNG: width, height, bits per channel, RGBA bytes.
#[derive(Debug, PartialEq)]
pub(crate) struct Png {
    pub width: usize,
    pub height: usize,
    bits: u8,
    pub rgba: Vec<u8>,
}

impl Png {
    pub(crate) fn decode(bytes: &[u8]) -> Self {
        let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut data).unwrap();
        let rgba = match info.color_type {
            png::ColorType::Rgba => data,
            png::ColorType::Rgb => {
                let sample = info.bit_depth as usize / 8;
                data.chunks(3 * sample).flat_map(|rgb| [rgb, &[255, 255][..sample]].concat()).collect()
            }
            other => panic!("{other:?}"),
        };
        Self { width: info.width as usize, height: info.height as usize, bits: info.bit_depth as u8, rgba }
    }

    fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    pub(crate) fn pixel(&self, x: usize, y: usize) -> [u8; 4] {
        self.rgba[4 * (y * self.width + x)..][..4].try_into().unwrap()
    }

    /// Whether `part` lies in this picture anywhere.
    fn holds(&self, part: &Self) -> bool {
        let row = |x: usize, y: usize| &self.rgba[4 * (y * self.width + x)..][..4 * part.width];
        let part_row = |y: usize| &part.rgba[4 * y * part.width..][..4 * part.width];
        let fits = |x: usize, y: usize| (0..part.height).all(|dy| row(x, y + dy) == part_row(dy));
        (0..=self.height - part.height).any(|y| (0..=self.width - part.width).any(|x| fits(x, y)))
    }
}

fn drawn(folder: &Folder, words: &[&str]) -> Png {
    let run = folder.glanz(&[&["render", "scene.toml", "-o", "-"], words].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stderr.lines().all(|line| line.starts_with("note: ")), "{}", run.stderr);
    Png::decode(&run.stdout)
}

#[test]
fn a_picture_goes_beside_the_scene_and_says_so_on_stderr() {
    let folder = Folder::with_scene();
    let run = folder.glanz(&["render", "scene.toml"]);
    assert_eq!(run.text(), "");
    assert_eq!(run.stderr, "wrote scene.png\n");
    assert_eq!(folder.names(), ["scene.png", "scene.toml"]);
    let picture = Png::decode(&folder.read("scene.png"));
    assert_eq!((picture.size(), picture.bits), ((48, 32), 8));
    assert_ne!(picture.pixel(24, 16), picture.pixel(0, 0), "the ball is not the background");
}

#[test]
fn a_named_picture_is_written_over_an_old_one() {
    let folder = Folder::with_scene();
    folder.write("old.png", "old");
    assert_eq!(folder.glanz(&["render", "scene.toml", "-o", "old.png"]).code, 0);
    assert!(folder.read("old.png").starts_with(b"\x89PNG"));
}

#[test]
fn stdout_gets_the_bytes_of_the_file() {
    let folder = Folder::with_scene();
    folder.glanz(&["render", "scene.toml", "-o", "a.png"]);
    assert_eq!(folder.glanz(&["render", "scene.toml", "-o", "-"]).stdout, folder.read("a.png"));
}

#[test]
fn every_option_of_the_picture_changes_it() {
    let folder = Folder::with_scene();
    let plain = drawn(&folder, &[]);
    let options: [&[&str]; 15] = [
        &["--size", "40x30"],
        &["--samples", "8"],
        &["--shading", "flat"],
        &["--shading", "gouraud"],
        &["--model", "blinn-phong"],
        &["--show", "normals"],
        &["--show", "wireframe"],
        &["--ev", "-1"],
        &["--tone-map", "reinhard"],
        &["--background", "#336699"],
        &["--background", "transparent"],
        &["--eye", "-1,2,4"],
        &["--target", "-0.2,0,0"],
        &["--fov-deg", "30"],
        &["--set", "materials.ball.shininess=4"],
    ];
    for words in options {
        assert_ne!(drawn(&folder, words), plain, "{words:?}");
    }
}

#[test]
fn the_picture_does_not_depend_on_threads_or_simd_level() {
    let folder = Folder::with_scene();
    let plain = folder.glanz(&["render", "scene.toml", "-o", "-"]).stdout;
    for threads in ["1", "2", "7"] {
        let words = ["render", "scene.toml", "-o", "-", "--threads", threads];
        assert_eq!(folder.glanz(&words).stdout, plain, "{threads} threads");
    }
    let words = ["render", "scene.toml", "-o", "-"];
    assert_eq!(
        folder.glanz_with(&words, &[("GLANZ_SIMD", glanz_math::SimdLevel::narrowest().name())]).stdout,
        plain
    );
}

#[test]
fn a_background_is_what_it_is_called() {
    let folder = Folder::with_scene();
    assert_eq!(drawn(&folder, &["--background", "#336699"]).pixel(0, 0), [0x33, 0x66, 0x99, 255]);
    assert_eq!(drawn(&folder, &["--background", "1,0,0"]).pixel(0, 0), [255, 0, 0, 255]);
    assert_eq!(drawn(&folder, &["--background", "transparent"]).pixel(0, 0)[3], 0);
}

#[test]
fn the_ending_chooses_the_format() {
    let folder = Folder::with_scene();
    let first = |name: &str, words: &[&str]| {
        let run = folder.glanz(&[&["render", "scene.toml", "-o", name], words].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        folder.read(name)
    };
    assert!(first("a.exr", &[]).starts_with(&[0x76, 0x2f, 0x31, 0x01]));
    assert!(first("a.gif", &[]).starts_with(b"GIF89a"));
    assert!(first("a.PNG", &[]).starts_with(b"\x89PNG"));
    assert_eq!(Png::decode(&first("a.png", &["--bit-depth", "16"])).bits, 16);
}

#[test]
fn a_turntable_begins_with_the_still_and_moves() {
    let folder = Folder::with_scene();
    let words = ["render", "scene.toml", "--frames", "7..10", "--turntable", "-o", "spin_{frame:04}.png"];
    let run = folder.glanz(&words);
    assert_eq!(run.text(), "");
    assert_eq!(run.stderr, "wrote 3 files, spin_0007.png to spin_0009.png\n");
    assert_eq!(folder.names(), ["scene.toml", "spin_0007.png", "spin_0008.png", "spin_0009.png"]);
    let [first, second] = ["spin_0007.png", "spin_0008.png"].map(|name| Png::decode(&folder.read(name)));
    assert_eq!(first, drawn(&folder, &[]));
    assert_ne!(first, second);
}

#[test]
fn a_value_moves_from_one_end_to_the_other() {
    let folder = Folder::with_scene();
    let words = ["--frames", "0..3", "--animate", "materials.ball.shininess=4:64", "-o", "{frame}.png"];
    assert_eq!(folder.glanz(&[&["render", "scene.toml"], &words[..]].concat()).code, 0);
    for (frame, shininess) in [(0, 4), (1, 34), (2, 64)] {
        let set = format!("materials.ball.shininess={shininess}");
        let still = drawn(&folder, &["--set", &set]);
        assert_eq!(Png::decode(&folder.read(&format!("{frame}.png"))), still, "frame {frame}");
    }
}

#[test]
fn films_are_one_file() {
    let folder = Folder::with_scene();
    for (name, magic) in [("a.gif", &b"GIF89a"[..]), ("a.apng", &b"\x89PNG"[..])] {
        let words = ["render", "scene.toml", "--frames", "0..3", "--turntable", "-o", name, "--fps", "10"];
        let run = folder.glanz(&words);
        assert_eq!((run.code, run.stderr), (0, format!("wrote {name}\n")));
        assert!(folder.read(name).starts_with(magic));
    }
    let apng = folder.read("a.apng");
    let info = png::Decoder::new(Cursor::new(&apng)).read_info().unwrap();
    assert_eq!(info.info().animation_control().unwrap().num_frames, 3);
}

#[test]
fn a_preview_alone_writes_no_file() {
    let folder = Folder::with_scene();
    let run = folder.glanz_with(&["render", "scene.toml", "--preview=blocks"], &[("COLUMNS", "24")]);
    assert_eq!(run.text().lines().count(), 8);
    assert!(run.text().lines().all(|line| line.matches('▀').count() == 24));
    assert_eq!(folder.names(), ["scene.toml"]);
    let both = folder.glanz(&["render", "scene.toml", "--preview=blocks", "-o", "a.png"]);
    assert!(both.text().contains('▀') && folder.path("a.png").exists());
}

#[test]
fn timings_have_every_stage() {
    let folder = Folder::with_scene();
    let words = ["render", "scene.toml", "--repeat", "3", "--timings", "-o", "a.png"];
    let run = folder.glanz(&words);
    let names: Vec<_> = run.text().lines().skip(2).map(|line| line.split(' ').next().unwrap()).collect();
    assert_eq!(names, ["load", "prepare", "draw", "develop", "encode", "total"]);
    assert!(run.text().starts_with("ms over 3 runs\n"));
    let json = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    let stages = &json["timings"]["stages"];
    assert!(stages["draw"]["min"].as_f64() <= stages["draw"]["median"].as_f64());
    assert!(stages["develop"].is_null(), "8-bit pictures are developed while they are drawn");
    let words = ["render", "scene.toml", "--timings", "-o", "a.png", "--bit-depth", "16", "--format", "json"];
    assert!(folder.glanz(&words).json()["timings"]["stages"]["develop"]["min"].is_number());
}

#[test]
fn a_program_is_told_what_was_written() {
    let folder = Folder::with_scene();
    let json = folder.glanz(&["render", "scene.toml", "--format", "json"]).json();
    assert_eq!((&json["file"], &json["width"]), (&"scene.png".into(), &48.into()));
    // The hash of the scene is that in the file.
    let hash = json["scene_hash"].as_str().unwrap();
    let file = folder.read("scene.png");
    assert!(hash.len() == 16 && file.windows(16).any(|part| part == hash.as_bytes()), "{json}");
    let sha256 = |words: &[&str]| {
        let words = [&["render", "scene.toml", "--format", "json", "--force"], words].concat();
        folder.glanz(&words).json()["sha256"].as_str().unwrap().to_owned()
    };
    assert_eq!(json["sha256"].as_str().unwrap().len(), 64);
    assert_eq!(json["sha256"], sha256(&[]), "the same picture");
    assert_ne!(json["sha256"], sha256(&["--ev", "1"]), "another picture");
}

#[test]
fn a_program_is_told_of_each_frame_of_a_film() {
    let folder = Folder::with_scene();
    let film = |words: &[&str]| {
        let words =
            [&["render", "scene.toml", "--frames", "0..2", "--format", "json", "--force"], words].concat();
        folder.glanz(&words).json()
    };
    let turned = film(&["--turntable", "-o", "t{frame}.png"]);
    assert_eq!(turned["files"], serde_json::json!(["t0.png", "t1.png"]));
    assert_ne!(turned["sha256"][0], turned["sha256"][1], "{turned}");
    assert_eq!(turned["scene_hashes"][0], turned["scene_hashes"][1], "the scene is the same");
    let moved = film(&["--animate", "materials.ball.shininess=4:40", "-o", "m.apng"]);
    assert_eq!(moved["sha256"].as_array().unwrap().len(), 1, "{moved}");
    assert_eq!(moved["scene_hashes"].as_array().unwrap().len(), 2, "{moved}");
    assert_ne!(moved["scene_hashes"][0], moved["scene_hashes"][1], "{moved}");
    let hash = moved["scene_hashes"][1].as_str().unwrap();
    assert_eq!(hash.len(), 16);
}

#[test]
fn a_sheet_holds_the_pictures_of_all_values() {
    let folder = Folder::with_scene();
    let words = ["--vary", "materials.ball.shininess=4,64", "--vary", "render.shading=flat,gouraud,phong"];
    let words = [&["sweep", "scene.toml", "--size", "48x32", "--format", "json"], &words[..]].concat();
    let json = folder.glanz(&words).json();
    assert_eq!(json["file"], "scene_sweep.png");
    assert_eq!(json["cells"].as_array().unwrap().len(), 6);
    assert_eq!(json["cells"][1]["values"]["render.shading"], "gouraud");
    let sheet = Png::decode(&folder.read("scene_sweep.png"));
    assert!(sheet.width > 3 * 48 && sheet.height > 2 * 32);
    for cell in json["cells"].as_array().unwrap() {
        let set = |path: &str| format!("{path}={}", cell["values"][path].to_string().trim_matches('"'));
        let words = ["--set", &set("materials.ball.shininess"), "--set", &set("render.shading")];
        assert!(sheet.holds(&drawn(&folder, &words)), "{words:?}");
    }
}

#[test]
fn one_value_that_varies_makes_rows_of_the_asked_length() {
    let folder = Folder::with_scene();
    let words = ["sweep", "scene.toml", "--vary", "render.ev=-1:1:5", "--size", "48x32", "--columns", "2"];
    let json = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    assert_eq!(json["width"], 6 + 2 * (48 + 6));
    assert_eq!(json["cells"][4]["values"]["render.ev"], 1.0);
    assert_eq!((&json["cells"][4]["row"], &json["cells"][4]["column"]), (&2.into(), &0.into()));
    assert_eq!(json["cells"][4]["file"], "scene_sweep.png");
}

#[test]
fn a_comparison_measures_the_distance_to_phong_shading() {
    let folder = Folder::with_scene();
    let run = folder.glanz(&["shade-compare", "scene.toml", "-o", "three.png"]);
    insta::assert_snapshot!(run.text());
    let json = folder.glanz(&["shade-compare", "scene.toml", "-o", "three.png", "--format", "json"]).json();
    let (flat, gouraud) = (&json["difference"]["flat"], &json["difference"]["gouraud"]);
    assert!(flat["linear"]["rmse"].as_f64() > gouraud["linear"]["rmse"].as_f64());
    assert_eq!(flat["pixels"], gouraud["pixels"]);
    let picture = Png::decode(&folder.read("three.png"));
    for shading in ["flat", "gouraud", "phong"] {
        assert!(picture.holds(&drawn(&folder, &["--shading", shading])), "{shading}");
    }
}

#[test]
fn a_bare_model_is_framed_and_lit() {
    let folder = Folder::new();
    folder
        .write("tetra.obj", "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
    let run = folder.glanz(&["render", "tetra.obj", "--size", "60x40"]);
    assert_eq!(run.stderr, "wrote tetra.png\n");
    let picture = Png::decode(&folder.read("tetra.png"));
    let background = picture.pixel(0, 0);
    assert_ne!(picture.pixel(30, 20), background);
    // Nothing reaches the edge: all of it is in the picture.
    assert!((0..60).all(|x| picture.pixel(x, 0) == background && picture.pixel(x, 39) == background));
    let set =
        ["render", "tetra.obj", "--size", "60x40", "-o", "-", "--set", "materials.default.diffuse=[1,0,0]"];
    assert_ne!(Png::decode(&folder.glanz(&set).stdout), picture, "its material can be set");
}
