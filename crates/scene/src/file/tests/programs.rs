//! Shaders in place of materials.

use super::*;
use crate::UniformValue;

/// The scene with `sky` set so, read in a folder with six faces and a panorama.
fn read(sky: &str) -> Result<Loaded, FileError> {
    use std::sync::atomic::{AtomicUsize, Ordering};
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let folder = std::env::temp_dir().join(format!("glanz-programs-{}-{number}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    for (number, face) in ["right", "left", "top", "bottom", "front", "back", "all"].into_iter().enumerate() {
        let color = image::Rgba([10 * number as u8, 0, 0, 255]);
        let picture = image::RgbaImage::from_pixel(2, 2, color);
        picture.save(folder.join(format!("{face}.png"))).expect("it can be written");
    }
    std::fs::write(folder.join("a.frag"), "uniform samplerCube sky;").expect("it can be written");
    let text = format!("program = {{ fragment = 'a.frag', uniforms = {{ sky = {sky} }} }}");
    let loaded = parse_str(&text, &folder, &LoadOptions::default());
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    loaded
}

#[test]
fn a_cube_map_is_a_panorama_six_files_or_a_pattern() {
    let reds = |sky: &str| {
        let scene = read(sky).unwrap_or_else(|error| panic!("{error}")).scene;
        let value = scene.programs[0].uniforms["sky"].clone();
        let reds: Vec<u8> = value.textures().iter().map(|own| scene.textures[*own].rgba[0]).collect();
        (matches!(value, UniformValue::Cube(_)), reds)
    };
    let faces = (true, vec![0, 10, 20, 30, 40, 50]);
    assert_eq!(reds("'all.png'"), (false, vec![60]));
    assert_eq!(reds("'*.png'"), faces);
    let list = "['right.png', 'left.png', 'top.png', 'bottom.png', 'front.png', 'back.png']";
    assert_eq!(reds(list), faces);
    // It can be written, and the names of its textures read again.
    let scene = read(list).expect("it is right").scene;
    let written = write(&scene, "data").expect("it can be written");
    assert!(written.text.contains("sky = [\""), "{}", written.text);
}

#[test]
fn what_is_no_cube_map_is_told_where_it_stands() {
    for (sky, said) in [
        ("['right.png', 'left.png']", "expected the six faces of a cube map, found 2 pictures"),
        ("['right.png', 1.0]", "expected a picture, found a number"),
        ("[1.0, 'right.png']", "expected a number, found \"right.png\""),
        ("'sky_*.png'", "none of 'sky_px.png', 'sky_posx.png', 'sky_right.png', 'sky_0.png' can be read"),
    ] {
        let error = read(sky).expect_err(sky).to_string();
        assert!(error.contains(said), "{sky}: {error}");
    }
}
