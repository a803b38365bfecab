//! Materials of the library in scene files.

use super::{LoadOptions, parse_str};
use super::{parse, scene};
use crate::{AlphaMode, Coat, Material, library};

/// The message, the text that it points at, and the advice.
fn error(text: &str) -> (String, String, String) {
    let error = parse(text).expect_err(text);
    let span = error.span.expect("every error in a text has a place");
    (error.message, error.text[span].to_owned(), error.help.unwrap_or_default())
}

fn gold(name: &str) -> Material {
    Material { name: name.to_owned(), ..library::material("gold").expect("gold is in the library") }
}

#[test]
fn a_material_is_taken_from_the_library_under_its_own_name() {
    let scene = scene("[materials.ring]\nlibrary = 'gold'\n[[objects]]\nmesh = 'torus'\nmaterial = 'ring'");
    assert_eq!(scene.materials, [gold("ring")]);
}

#[test]
fn coat_alpha_and_grain_still_apply() {
    let text = "[materials.a]\nlibrary = 'gold'\nopacity = 0.5\naniso_deg = 90\ntwo_sided = false\ncoat = { ior = 1.5 }";
    let coated = gold("a").under_coat(&Coat::default()).expect("the coat is fine");
    let expected = Material {
        two_sided: false,
        opacity: 0.5,
        alpha_mode: AlphaMode::Blend,
        aniso: 90_f64.to_radians(),
        ..coated
    };
    assert_eq!(scene(text).materials, [expected]);
}

#[test]
fn an_object_finds_its_material_in_the_library_once() {
    let scene = scene("[[objects]]\nmesh = 'quad'\nmaterial = 'gold'\n".repeat(2).as_str());
    assert_eq!(scene.materials, [gold("gold")]);
    assert!(scene.objects.iter().all(|object| object.material == 0));
}

#[test]
fn a_material_of_the_scene_comes_before_one_of_the_library() {
    let scene = scene("[materials.gold]\ndiffuse = 0.5\n[[objects]]\nmesh = 'quad'\nmaterial = 'gold'");
    assert_eq!(scene.materials.len(), 1);
    assert_ne!(scene.materials[0], gold("gold"));
}

#[test]
fn the_content_of_the_library_is_part_of_the_hash() {
    let hash = |name: &str| {
        let text = format!("[materials.a]\nlibrary = '{name}'");
        parse(&text).expect("the scene is fine").scene.content_hash()
    };
    assert_eq!(hash("gold"), hash("gold"));
    assert_ne!(hash("gold"), hash("silver"));
}

#[test]
fn a_texture_that_multiplies_nothing_is_told() {
    let folder = std::env::temp_dir().join(format!("glanz-library-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    image::RgbaImage::from_pixel(1, 1, image::Rgba([255; 4]))
        .save(folder.join("a.png"))
        .expect("it can be written");
    let notes = |name: &str| {
        let text = format!("[materials.a]\nlibrary = '{name}'\nbase_color_texture = 'a.png'");
        parse_str(&text, &folder, &LoadOptions::default()).expect("the scene is fine").notes
    };
    let note = "material 'a': no term of 'gold' takes a texture; only the texture's alpha counts";
    let (gold, plaster) = (notes("gold"), notes("plaster"));
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    assert_eq!((gold, plaster), (vec![note.to_owned()], Vec::new()));
}

#[test]
fn errors_point_at_what_is_wrong_and_name_what_is_near() {
    let object = |name: &str| format!("[materials.ruby]\n[[objects]]\nmesh = 'quad'\nmaterial = '{name}'");
    let cases = [
        (
            "[materials.a]\nlibrary = 'golt'".to_owned(),
            "there is no material 'golt' in the library; did you mean 'gold'?",
            "'golt'",
        ),
        (
            "[materials.a]\nlibrary = 'unobtainium'".to_owned(),
            "there is no material 'unobtainium' in the library",
            "'unobtainium'",
        ),
        ("[materials.a]\nlibrary = 'gold'\nlobes = []".to_owned(), "'lobes' beside 'library'", "[]"),
        ("[materials.a]\nlibrary = 'gold'\nshininess = 3".to_owned(), "'shininess' beside 'library'", "3"),
        ("[materials.a]\npane = {}\nlibrary = 'gold'".to_owned(), "'pane' beside 'library'", "{}"),
        (
            "[materials.a]\nsee_through = 0.5\nlibrary = 'gold'".to_owned(),
            "'see_through' beside 'library'",
            "0.5",
        ),
        ("[materials.a]\nlibrary = 3".to_owned(), "expected a string, found integer 3", "3"),
        (object("rubi"), "unknown material 'rubi'; did you mean 'ruby'?", "'rubi'"),
        (
            object("gl-rubi"),
            "unknown material 'gl-rubi'; did you mean 'gl-ruby' of the library?",
            "'gl-rubi'",
        ),
        (
            "[materials.silber]\n[[objects]]\nmesh = 'quad'\nmaterial = 'sillver'".to_owned(),
            "unknown material 'sillver'; did you mean 'silber', or 'silver' of the library?",
            "'sillver'",
        ),
    ];
    for (text, message, place) in &cases {
        let (found, at, _) = error(text);
        assert_eq!((found.as_str(), at.as_str()), (*message, *place), "{text}");
    }
    let (_, _, help) = error("[materials.a]\nlibrary = 'gold'\nlobes = []");
    assert_eq!(help, "`glanz material show gold` prints the keys of 'gold', to be changed in its place");
}
