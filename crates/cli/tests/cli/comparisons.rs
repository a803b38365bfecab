//! `glanz compare`: its numbers, its picture, and how it fails.

use std::io::Cursor;

use glanz_picture::output::{Effort, Metadata, write_exr, write_png8};
use glanz_render::Frame;

use crate::folder::{Folder, Run};

const SIZE: (usize, usize) = (24, 16);

/// A PNG of these grey codes.
fn png((width, height): (usize, usize), code: impl Fn(usize, usize) -> u8) -> Vec<u8> {
    let mut file = Vec::new();
    let pixels = (0..width * height).flat_map(|i| {
        let code = code(i % width, i / width);
        [code, code, code, 255]
    });
    let rgba: Vec<u8> = pixels.collect();
    write_png8(&mut file, (width, height), &rgba, Effort::Fast, &Metadata::default()).unwrap();
    file
}

/// An OpenEXR file of this grey light.
fn exr(light: impl Fn(usize, usize) -> f32) -> Vec<u8> {
    let (width, height) = SIZE;
    let plane: Vec<f32> = (0..width * height).map(|i| light(i % width, i / width)).collect();
    let rgb = [plane.clone(), plane.clone(), plane];
    let frame = Frame { width, height, rgb, alpha: vec![1.0; width * height], ..Frame::default() };
    let mut file = Cursor::new(Vec::new());
    write_exr(&mut file, frame, Vec::new(), &Metadata::default()).unwrap();
    file.into_inner()
}

/// Ramps and edges in codes and in light, and pictures that fit nothing.
fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("a.png", png(SIZE, |x, y| (x * 8 + y) as u8));
    folder.write("b.png", png(SIZE, |x, y| (x * 8 + y) as u8 + if x > 11 { 20 } else { 0 }));
    folder.write("small.png", png((3, 2), |_, _| 0));
    folder.write("a.exr", exr(|x, y| (1 + x + y) as f32 * 0.125));
    folder.write("b.exr", exr(|x, y| (1 + x + y) as f32 * if y > 7 { 0.125 } else { 0.15 }));
    folder.write("text.png", "not a picture");
    folder
}

fn compare(words: &[&str]) -> Run {
    folder().glanz(&[&["compare"], words].concat())
}

#[test]
fn codes_are_compared_in_a_table() {
    insta::assert_snapshot!(compare(&["a.png", "b.png"]).text());
}

#[test]
fn light_is_compared_in_a_table() {
    insta::assert_snapshot!(compare(&["a.exr", "b.exr"]).text());
}

#[test]
fn programs_get_every_number() {
    let words =
        ["a.png", "b.png", "--format", "json", "--fail-above", "rmse.max=1", "--fail-below", "psnr=10"];
    let json = compare(&words).json();
    assert_eq!((&json["width"], &json["values"]), (&24.into(), &"srgb-codes".into()));
    let metrics = &json["metrics"];
    // Half of the pixels are 20 codes off.
    let off = 20.0 / 255.0;
    let near = |value: &serde_json::Value, expected: f64| (value.as_f64().unwrap() - expected).abs() < 1e-6;
    assert!(near(&metrics["rmse"]["value"], off * 0.5_f64.sqrt()), "{metrics}");
    assert!(near(&metrics["rmse"]["max"], off) && near(&metrics["rmse"]["mean"], off / 2.0), "{metrics}");
    assert!(near(&metrics["psnr"]["value"], -20.0 * (off * 0.5_f64.sqrt()).log10()), "{metrics}");
    assert_eq!(metrics.as_object().unwrap().len(), 5);
    assert_eq!(json["bounds"][0]["of"], "rmse.max");
    assert_eq!(json["bounds"][1]["holds"], true);
}

#[test]
fn identical_pictures_have_no_error() {
    for (name, metrics) in [("a.png", 5), ("a.exr", 4)] {
        let run = compare(&[name, name, "--format", "json", "--fail-above", "flip=0,de2000.max=0"]);
        let json = run.json();
        assert_eq!(json["metrics"].as_object().unwrap().len(), metrics);
        for (metric, numbers) in json["metrics"].as_object().unwrap() {
            let expected = match metric.as_str() {
                "psnr" => serde_json::Value::Null,
                "ssim" => 1.0.into(),
                _ => 0.0.into(),
            };
            assert_eq!(numbers["value"], expected, "{name} {metric}");
        }
    }
    assert!(compare(&["a.png", "a.png"]).text().contains("psnr           inf"));
}

#[test]
fn light_beside_codes_is_compared_as_shown() {
    for words in [&["a.exr", "a.png"][..], &["a.exr", "b.exr", "--as-shown"]] {
        let json = compare(&[words, &["--format", "json"]].concat()).json();
        assert_eq!(json["values"], "srgb-codes");
        assert!(json["metrics"]["ssim"]["value"].is_f64());
        assert!(json["metrics"]["flip"]["exposures"].is_null());
    }
}

#[test]
fn only_what_was_asked_for_and_what_has_a_bound_is_measured() {
    let run = compare(&["a.png", "b.png", "--metric", "psnr", "--fail-above", "rmse=1", "--format", "json"]);
    let names: Vec<_> = run.json()["metrics"].as_object().unwrap().keys().cloned().collect();
    assert_eq!(names, ["psnr", "rmse"]);
}

#[test]
fn more_pixels_per_degree_hide_more() {
    let flip = |ppd: &str| {
        let json = compare(&["a.png", "b.png", "--metric", "flip", "--ppd", ppd, "--format", "json"]).json();
        json["metrics"]["flip"]["value"].as_f64().unwrap()
    };
    assert_ne!(flip("20"), flip("100"));
}

#[test]
fn a_broken_bound_is_one_line_after_the_numbers() {
    let run =
        compare(&["a.png", "b.png", "--fail-above", "de2000.max=1,flip=0.9", "--fail-below", "ssim=0.999"]);
    assert_eq!(run.code, 1);
    assert!(run.stdout.starts_with(b"b.png against a.png"));
    insta::assert_snapshot!(run.stderr);
}

#[test]
fn the_map_of_errors_is_a_picture() {
    let folder = folder();
    let run = folder.glanz(&["compare", "a.png", "b.png", "-o", "errors.png"]);
    assert!(run.text().starts_with("b.png against a.png"));
    assert_eq!(run.stderr, "wrote errors.png\n");
    let file = folder.read("errors.png");
    let piped = folder.glanz(&["compare", "a.png", "b.png", "-o", "-", "--threads", "1"]);
    assert!(piped.stderr.starts_with("b.png against a.png"));
    assert!(piped.stdout == file, "a picture depends on the number of threads");
    let mut reader = png::Decoder::new(Cursor::new(file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    // The brightest end of the scales is on the sheet.
    assert!(pixels.chunks(3).any(|pixel| pixel == [252, 253, 191]));
}

/// Snapshots how a comparison fails, which leaves everything as it was.
macro_rules! fails {
    ($($name:ident: $words:expr;)+) => {
        $(#[test]
        fn $name() {
            let folder = folder();
            let before = (folder.names(), folder.read("a.png"));
            insta::assert_snapshot!(folder.glanz(&[&["compare"], &$words[..]].concat()).failure());
            assert_eq!((folder.names(), folder.read("a.png")), before);
        })+
    };
}

fails! {
    one_picture_alone: ["a.png"];
    a_picture_that_is_missing: ["a.png", "none.png"];
    a_picture_that_is_none: ["a.png", "text.png"];
    pictures_of_two_sizes: ["a.png", "small.png"];
    an_unknown_metric: ["a.png", "b.png", "--metric", "flop"];
    structure_of_light: ["a.exr", "b.exr", "--metric", "ssim"];
    a_bound_on_the_wrong_side: ["a.png", "b.png", "--fail-above", "psnr=40"];
    a_bound_of_no_statistic: ["a.png", "b.png", "--fail-above", "flip.least=1"];
    a_bound_that_is_no_number: ["a.png", "b.png", "--fail-above", "flip=low"];
    pixels_per_degree_that_are_none: ["a.png", "b.png", "--ppd", "0"];
    a_map_of_errors_as_exr: ["a.png", "b.png", "-o", "errors.exr"];
    a_map_of_errors_over_a_picture: ["a.png", "b.png", "-o", "./a.png"];
    a_map_of_errors_in_no_folder: ["a.png", "b.png", "-o", "none/errors.png"];
}
