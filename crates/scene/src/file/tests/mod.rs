//! What scene files mean, and how they fail.

mod errors;
mod library;
mod lights;
mod materials;
mod memory;
mod programs;
mod proptests;
mod remarks;
mod schema;
mod spectra;

use std::path::{Path, PathBuf};

use glam::{DMat4, DVec3};
use glanz_color::Rgb;

use super::*;
use crate::{
    AlphaMode, Attenuation, Background, Camera, ClassicMaterial, Image, Interpolation, LightColors,
    LightKind, Mesh, Projection, Shading, Space,
};

/// The folder of the example scenes.
fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// All example scenes, by name.
pub(super) fn example_files() -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(examples())
        .expect("the examples are there")
        .map(|entry| entry.expect("readable").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    files
}

pub(super) fn parse(text: &str) -> Result<Loaded, FileError> {
    parse_str(text, &examples(), &LoadOptions::default())
}

pub(super) fn scene(text: &str) -> Scene {
    parse(text).unwrap_or_else(|error| panic!("{error}\n{text}")).scene
}

/// The scene of the examples that says most, without the mesh from a file.
pub(super) fn full() -> String {
    let text = std::fs::read_to_string(examples().join("full.toml")).expect("the example is there");
    let end = text.find("[[objects]]\nmesh = { file").expect("the last object is from a file");
    text[..end].to_owned()
}

#[test]
fn the_full_example_means_what_it_says() {
    let scene = scene(&full());
    let background = Background::Color(Rgb([0.05, 0.05, 0.08]));
    assert_eq!(scene.image, Image { width: 800, height: 600, samples: 4, supersample: false, background });
    let projection = Projection::Perspective { fov_y: 40f64.to_radians() };
    let eye = DVec3::new(0.0, 0.0, 4.0);
    assert_eq!(scene.camera, Some(Camera { eye, target: DVec3::ZERO, up: DVec3::Y, projection }));
    let [ambient, directional, point, spot] = &scene.lights[..] else { panic!("{:?}", scene.lights) };
    assert_eq!(
        (ambient.kind.clone(), ambient.colors.ambient.clone()),
        (LightKind::Ambient, Rgb::gray(0.1).into())
    );
    assert_eq!(directional.kind, LightKind::Directional { direction: DVec3::new(0.0, -1.0, -1.0) });
    assert_eq!(directional.colors, LightColors::all(Rgb::gray(0.5)));
    let attenuation = Attenuation { constant: 0.0, linear: 0.0, quadratic: 0.25 };
    assert_eq!(point.kind, LightKind::Point { position: DVec3::splat(2.0), attenuation });
    let kind = LightKind::Spot {
        position: DVec3::new(-2.0, 3.0, 2.0),
        direction: DVec3::new(2.0, -3.0, -2.0),
        cutoff: 15f64.to_radians(),
        exponent: 8.0,
        smooth_edge: None,
        attenuation: Attenuation::NONE,
    };
    assert_eq!(spot.kind, kind);
    let color = Rgb([1.0, 0.9, 0.7]);
    assert_eq!(spot.colors, LightColors { specular: Rgb::BLACK.into(), ..LightColors::all(color) });
    assert_eq!(spot.space, Space::World);
}

#[test]
fn a_background_may_be_one_number() {
    for (text, gray) in [("0.25", 0.25), ("1", 1.0)] {
        let scene = scene(&format!("[image]\nbackground = {text}\n[[objects]]\nmesh = \"quad\"\n"));
        assert_eq!(scene.image.background, Background::Color(Rgb::gray(gray)));
    }
}

#[test]
fn the_full_example_has_its_materials_and_objects() {
    let scene = scene(&full());
    let [red, matte] = &scene.materials[..] else { panic!("{:?}", scene.materials) };
    let tint = Rgb([0.8, 0.1, 0.1]);
    let classic = ClassicMaterial {
        ambient: tint.into(),
        diffuse: tint.into(),
        specular: Rgb::gray(0.6).into(),
        shininess: 32.0,
        model: "blinn-phong".to_owned(),
        ..ClassicMaterial::default()
    };
    assert_eq!(*red, classic.build("red").expect("valid"));
    assert_eq!((matte.lobes.len(), matte.lobes[0].tint.rgb()), (1, Some(Rgb([0.7, 0.7, 0.2]))));
    assert_eq!(matte.lobes[0].shape.info().name, "lambert");
    let [sphere, kite] = &scene.objects[..] else { panic!("{:?}", scene.objects) };
    assert_eq!(scene.materials[sphere.material].name, "red");
    assert_eq!(scene.meshes[sphere.mesh].triangle_count(), 64 * 31 * 2);
    assert_eq!(sphere.transform, DMat4::from_translation(DVec3::new(-0.8, 0.0, 0.0)));
    assert_eq!((sphere.shading, kite.shading), (None, Some(Shading::Flat)));
    assert_eq!(scene.materials[kite.material].name, "matte");
    // Scaled, then turned by 20° about +Y, then moved.
    let (sin, cos) = (libm::sin(20f64.to_radians()), libm::cos(20f64.to_radians()));
    let tip = kite.transform.transform_point3(DVec3::new(1.0, 1.0, 0.0));
    assert!((tip - DVec3::new(0.9 + cos, 1.2, -sin)).length() < 1e-12, "{tip}");
}

#[test]
fn the_examples_load_and_show_something() {
    let files = example_files();
    assert!(files.len() >= 10, "{files:?}");
    for path in files {
        let loaded = load(&path, &LoadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        assert!(!loaded.scene.objects.is_empty(), "{}", path.display());
        // Notes are for what a file says that is not done; only the materials of a model are such.
        assert!(loaded.notes.iter().all(|note| note.contains("metallic-roughness")), "{:?}", loaded.notes);
        for mesh in &loaded.scene.meshes {
            assert_eq!(mesh.validate(), Ok(()), "{}", path.display());
        }
        for object in &loaded.scene.objects {
            assert!(
                object.mesh < loaded.scene.meshes.len() && object.material < loaded.scene.materials.len()
            );
        }
    }
}

#[test]
fn an_empty_scene_is_an_empty_scene_with_the_defaults() {
    let loaded = parse("").expect("empty is valid");
    assert_eq!(loaded.scene, Scene::default());
    let render = loaded.scene.render;
    assert_eq!(
        (render.show, render.tone_map, render.ev),
        (crate::DebugView::Shaded, crate::ToneMap::None, 0.0)
    );
}

#[test]
fn a_light_sends_its_color_unless_a_part_has_its_own() {
    let text = "[[lights]]\nkind = 'directional'\ndirection = [0, 0, -1]\nattached_to = 'camera'\n\
                color = [0.5, 0.5, 0.5]\nspecular = '#ffffff'\nintensity = 2";
    let light = &scene(text).lights[0];
    let half = Rgb::gray(1.0);
    assert_eq!(light.colors, LightColors { specular: Rgb::gray(2.0).into(), ..LightColors::direct(half) });
    assert_eq!(light.space, Space::Camera);
    let ambient = &scene("[[lights]]\nkind = 'ambient'\n").lights[0];
    assert_eq!(ambient.colors, LightColors::ambient(Rgb::WHITE));
}

#[test]
fn attenuation_has_names_and_missing_factors_are_zero() {
    let attenuation = |value: &str| {
        let text = format!("[[lights]]\nkind = 'point'\nposition = [0, 0, 0]\n{value}");
        match &scene(&text).lights[0].kind {
            LightKind::Point { attenuation, .. } => *attenuation,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(attenuation(""), Attenuation { constant: 1.0, linear: 0.0, quadratic: 0.0 });
    assert_eq!(attenuation("attenuation = 'physical'"), Attenuation::PHYSICAL);
    let linear = Attenuation { constant: 0.0, linear: 2.0, quadratic: 0.0 };
    assert_eq!(attenuation("attenuation = { linear = 2 }"), linear);
}

#[test]
fn cameras_are_perspective_or_orthographic() {
    let camera = scene("[camera]\neye = [1, 2, 3]").camera.expect("given");
    assert_eq!((camera.target, camera.up), (DVec3::ZERO, DVec3::Y));
    assert_eq!(camera.projection, Projection::Perspective { fov_y: 40f64.to_radians() });
    let text = "[camera]\neye = [1, 2, 3]\nprojection = 'orthographic'\nheight = 2.0";
    assert_eq!(scene(text).camera.expect("given").projection, Projection::Orthographic { height: 2.0 });
}

#[test]
fn rotations_are_done_in_their_order_and_a_matrix_says_it_all() {
    let object = |keys: &str| scene(&format!("[[objects]]\nmesh = 'quad'\n{keys}")).objects[0].transform;
    let turned = object(
        "rotate_deg = [{ axis = [0, 0, 2], angle = 90 }, { axis = [1, 0, 0], angle = 90 }]\nscale = [2, 1, -1]",
    );
    // x is doubled, then turned to y, then to z.
    assert!((turned.transform_vector3(DVec3::X) - DVec3::new(0.0, 0.0, 2.0)).length() < 1e-12);
    assert!((turned.transform_vector3(DVec3::Z) - DVec3::new(0.0, 1.0, 0.0)).length() < 1e-12);
    let matrix = object("matrix = [[1, 2, 3, 4], [0, 1, 0, 5], [0, 0, 1, 6]]");
    assert_eq!(matrix.transform_point3(DVec3::new(1.0, 1.0, 1.0)), DVec3::new(10.0, 6.0, 7.0));
}

#[test]
fn materials_are_classic_or_lobes_with_their_defaults() {
    let text = "[materials.a]\n[materials.b]\nlobes = [{ shape = 'phong', shininess = 7 }, { shape = 'ambient' }]\n\
                two_sided = false\nopacity = 0.5\n[materials.c]\nalpha_mode = 'mask'\nemission = [1, 2, 3]";
    let materials = scene(text).materials;
    assert_eq!((materials[0].lobes.len(), materials[0].two_sided), (0, true));
    let lobes = &materials[1].lobes;
    assert_eq!(
        (lobes[0].shape.params(), lobes[0].tint.rgb(), lobes[0].textured),
        (vec![7.0], Some(Rgb::WHITE), false)
    );
    assert!(lobes[1].textured && !materials[1].two_sided);
    assert_eq!((materials[1].opacity, materials[1].alpha_mode), (0.5, AlphaMode::Blend));
    assert_eq!(materials[2].alpha_mode, AlphaMode::Mask { cutoff: 0.5 });
    assert_eq!(materials[2].lobes[0].tint, Rgb([1.0, 2.0, 3.0]).into());
}

#[test]
fn a_matte_model_has_no_highlight_and_says_so() {
    let loaded = parse("[materials.a]\nmodel = 'lambert'\nspecular = [1, 1, 1]").expect("valid");
    assert!(loaded.scene.materials[0].lobes.is_empty());
    assert_eq!(loaded.notes, ["material 'a': 'lambert' has no highlight; 'specular' is not used"]);
}

#[test]
fn equal_objects_share_a_mesh_and_others_do_not() {
    let object = |keys: &str| format!("[[objects]]\nmesh = 'sphere'\n{keys}\n");
    let text =
        [object(""), object("scale = 2"), object("normals = 'facet'"), object("subdivide = 1")].concat();
    let scene = scene(&text);
    assert_eq!(scene.objects.iter().map(|o| o.mesh).collect::<Vec<_>>(), [0, 0, 1, 2]);
    assert_eq!(scene.meshes[2].triangle_count(), 4 * scene.meshes[0].triangle_count());
    assert_eq!((scene.materials.len(), scene.objects[3].material), (1, 0));
}

#[test]
fn colors_are_the_meshs_own_unless_a_built_in_mesh_has_a_material() {
    let kite = |keys: &str| {
        let text = format!("[materials.a]\n[[objects]]\nmesh = 'kite'\n{keys}");
        scene(&text).meshes.remove(0).colors
    };
    assert!(!kite("").is_empty());
    assert!(kite("material = 'a'").is_empty());
    assert_eq!(kite("material = 'a'\ncolors = 'mesh'"), kite(""));
    let text = "[[objects]]\nmesh = 'quad'\ncolors = [[1, 0, 0], [0, 1, 0], [0, 0, 1], '#ffffff']";
    let colors = &scene(text).meshes[0].colors;
    assert_eq!((colors[1].to_array(), colors[3].to_array()), ([0.0, 1.0, 0.0, 1.0], [1.0; 4]));
}

#[test]
fn per_object_settings_differ_from_the_scenes() {
    let text = "[render]\nshading = 'flat'\ninterpolation = 'scanline'\nshow = 'uv'\ntone_map = 'khronos-neutral'\n\
                ev = -1.5\n[[objects]]\nname = 'a'\nmesh = 'quad'\nshading = 'gouraud'\ninterpolation = 'screen-linear'";
    let loaded = parse(text).expect("valid");
    let render = loaded.scene.render;
    assert_eq!(
        (render.show, render.tone_map, render.ev),
        (crate::DebugView::Uv, crate::ToneMap::KhronosNeutral, -1.5)
    );
    let (render, object) = (loaded.scene.render, &loaded.scene.objects[0]);
    assert_eq!((render.shading, render.interpolation), (Shading::Flat, Interpolation::Scanline));
    assert_eq!(object.shading, Some(Shading::Gouraud));
    assert_eq!((object.interpolation, object.name.as_str()), (Some(Interpolation::ScreenLinear), "a"));
}

/// Loads with overrides.
pub(super) fn set(text: &str, sets: &[(&str, &str)]) -> Result<Loaded, FileError> {
    let sets = sets.iter().map(|(path, value)| ((*path).to_owned(), (*value).to_owned())).collect();
    parse_str(text, &examples(), &LoadOptions { sets, ..LoadOptions::default() })
}

#[test]
fn overrides_set_values_that_are_there_or_have_a_default() {
    let sets = [
        ("materials.red.shininess", "64"),
        ("materials.matte.lobes.0.tint", "[1, 0, 0]"),
        ("lights.1.color", "'#ff0000'"),
        ("lights.0.intensity", "3"),
        ("render.shading", "gouraud"),
        ("image.width", "16"),
        ("objects.0.mesh.sphere.slices", "5"),
        ("camera.eye", "[0, 0, 9]"),
        ("ambient", "{ color = [1, 1, 1] }"),
    ];
    let scene = set(&full(), &sets).unwrap_or_else(|error| panic!("{error}")).scene;
    assert_eq!(scene.materials[0].lobes[2].shape.params(), [64.0]);
    assert_eq!(scene.materials[1].lobes[0].tint, Rgb([1.0, 0.0, 0.0]).into());
    assert_eq!(scene.lights[2].colors.diffuse, Rgb([1.0, 0.0, 0.0]).into());
    assert_eq!(scene.lights[1].colors.diffuse, Rgb::gray(1.5).into());
    assert_eq!((scene.render.shading, scene.image.width), (Shading::Gouraud, 16));
    assert_eq!(scene.meshes[0].triangle_count(), 5 * 31 * 2);
    assert_eq!(scene.camera.expect("given").eye, DVec3::new(0.0, 0.0, 9.0));
    assert_eq!(scene.lights[0].colors.ambient, Rgb::WHITE.into());
}

#[test]
fn overrides_find_lights_and_objects_by_name_and_make_tables() {
    let text = "[[lights]]\nname = 'lamp'\nkind = 'point'\nposition = [0, 0, 0]\n[[objects]]\nname = 'o'\nmesh = 'quad'";
    let sets = [
        ("lights.lamp.attenuation.linear", "2"),
        ("objects.o.shading", "flat"),
        ("ambient.color", "[1, 1, 1]"),
    ];
    let scene = set(text, &sets).expect("valid").scene;
    let attenuation = Attenuation { constant: 0.0, linear: 2.0, quadratic: 0.0 };
    assert_eq!(scene.lights[1].kind, LightKind::Point { position: DVec3::ZERO, attenuation });
    assert_eq!(
        (scene.objects[0].shading, &scene.lights[0].colors.ambient),
        (Some(Shading::Flat), &Rgb::WHITE.into())
    );
}

#[test]
fn an_override_can_give_an_object_a_new_material() {
    let sets = [("materials.new", "{ diffuse = [1, 0, 0] }"), ("objects.0.material", "new")];
    let scene = set("[[objects]]\nmesh = 'quad'", &sets).expect("valid").scene;
    assert_eq!((scene.materials[0].name.as_str(), scene.objects[0].material), ("new", 0));
}

#[test]
fn the_hash_is_of_the_content_with_its_overrides_and_files() {
    let hash = |text: &str, sets: &[(&str, &str)]| set(text, sets).expect("valid").scene.content_hash();
    let plain = hash(&full(), &[]);
    assert_eq!(plain, hash(&format!("# a note\n{}", full().replace(" = ", "=")), &[]));
    assert_ne!(plain, hash(&full(), &[("materials.red.shininess", "33")]));
    assert_eq!(
        hash(&full().replace("32.0", "33"), &[]),
        hash(&full(), &[("materials.red.shininess", "33.0")])
    );
}

/// A folder of its own for one test, removed at its end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str, files: &[(&str, &str)]) -> Self {
        let path = std::env::temp_dir().join(format!("glanz-scene-file-{name}-{}", std::process::id()));
        std::fs::create_dir_all(path.join("scenes")).expect("the folder can be made");
        for (file, text) in files {
            std::fs::write(path.join(file), text).expect("the file can be written");
        }
        Self(path)
    }

    fn load(&self, allow_outside: bool) -> Result<Loaded, FileError> {
        load(&self.0.join("scenes/scene.toml"), &LoadOptions { allow_outside, ..LoadOptions::default() })
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A triangle.
const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn files_outside_of_the_folder_are_read_only_where_that_is_allowed() {
    let scene = "[[objects]]\nmesh = { file = \"../t.obj\" }";
    let scratch = Scratch::new("outside", &[("t.obj", OBJ), ("scenes/scene.toml", scene)]);
    let error = scratch.load(false).expect_err("outside");
    assert_eq!(error.message, "'../t.obj' leaves the folder of the scene file");
    assert_eq!((error.line, error.column), (2, 17));
    assert_eq!(scratch.load(true).expect("allowed").scene.meshes[0].triangle_count(), 1);
}

#[test]
fn a_file_is_read_once_and_its_meshes_are_shared() {
    let scene = "[materials.m]\n[[objects]]\nname = 'a'\nmesh = { file = 't.obj' }\n\
                 [[objects]]\nmesh = { file = 't.obj' }\nmaterial = 'm'\ntranslate = [1, 0, 0]\n\
                 [[objects]]\nmesh = { file = 't.obj' }\nsubdivide = 1\nnormals = 'facet'";
    let scratch = Scratch::new("once", &[("scenes/t.obj", OBJ), ("scenes/scene.toml", scene)]);
    let before = scratch.load(false).expect("valid");
    let scene = &before.scene;
    assert_eq!(scene.objects.iter().map(|o| o.mesh).collect::<Vec<_>>(), [0, 0, 1]);
    assert_eq!(scene.meshes.iter().map(Mesh::triangle_count).collect::<Vec<_>>(), [1, 4]);
    assert_eq!(scene.materials[scene.objects[1].material].name, "m");
    assert_eq!(scene.objects[0].material, scene.objects[2].material);
    assert_ne!(scene.objects[0].material, scene.objects[1].material);
    assert_eq!((scene.objects[0].name.as_str(), scene.objects[1].transform.w_axis.x), ("a", 1.0));
    std::fs::write(scratch.0.join("scenes/t.obj"), OBJ.replace("0 1 0", "0 2 0")).expect("writable");
    assert_ne!(
        scratch.load(false).expect("valid").scene.content_hash(),
        before.scene.content_hash(),
        "what the file says counts"
    );
}

#[test]
fn meshes_that_only_others_were_made_of_are_left_out() {
    let scene = "[[objects]]\nmesh = { file = 't.obj' }\nsubdivide = 1\n[[objects]]\nmesh = 'quad'";
    let scratch = Scratch::new("unused", &[("scenes/t.obj", OBJ), ("scenes/scene.toml", scene)]);
    let scene = scratch.load(false).expect("valid").scene;
    assert_eq!(scene.meshes.iter().map(Mesh::triangle_count).collect::<Vec<_>>(), [4, 2]);
    assert_eq!((scene.objects[0].mesh, scene.objects[1].mesh), (0, 1));
}

#[test]
fn cameras_and_lights_of_a_gltf_file_move_with_its_object() {
    let gltf = r#"{ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0, 1] }],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": { "KHR_lights_punctual": { "lights": [{ "type": "point" }] } },
        "cameras": [{ "name": "Eye", "type": "perspective", "perspective": { "yfov": 0.5, "znear": 0.1 } }],
        "nodes": [{ "name": "Eye", "camera": 0, "translation": [0, 0, 5] },
                  { "extensions": { "KHR_lights_punctual": { "light": 0 } }, "translation": [0, 3, 0] }] }"#;
    let object = "[[objects]]\nmesh = { file = 'c.gltf' }\ntranslate = [1, 0, 0]\nscale = 2\n";
    let scene = format!("camera = 'Eye'\n{object}lights = true\n");
    let scratch = Scratch::new("camera", &[("scenes/c.gltf", gltf), ("scenes/scene.toml", &scene)]);
    let scene = scratch.load(false).unwrap_or_else(|error| panic!("{error}")).scene;
    assert_eq!(scene.camera.expect("found").eye, DVec3::new(1.0, 0.0, 10.0));
    match &scene.lights[0].kind {
        LightKind::Point { position, .. } => assert_eq!(*position, DVec3::new(1.0, 6.0, 0.0)),
        other => panic!("{other:?}"),
    }
    std::fs::write(scratch.0.join("scenes/scene.toml"), format!("camera = 'eye'\n{object}"))
        .expect("writable");
    let error = scratch.load(false).expect_err("another name");
    assert_eq!(error.message, "unknown camera 'eye'; did you mean 'Eye'?");
}

#[test]
fn files_that_cannot_be_a_scene_are_refused_as_a_whole() {
    let scratch = Scratch::new("whole", &[]);
    let error = scratch.load(false).expect_err("there is none");
    assert!(error.message.starts_with("the scene file cannot be read:") && error.span.is_none(), "{error}");
    std::fs::write(scratch.0.join("scenes/scene.toml"), [b'a', 0xff]).expect("writable");
    assert_eq!(
        scratch.load(false).expect_err("bytes").message,
        "expected UTF-8 text, found byte 1 that is not"
    );
}

#[test]
fn a_cube_coloured_by_position_is_that_of_rgb() {
    let scene = parse("[[objects]]\nmesh = 'cube'\ncolors = 'position'\n")
        .unwrap_or_else(|error| panic!("{error}"))
        .scene;
    let mesh = &scene.meshes[scene.objects[0].mesh];
    for (at, color) in mesh.positions.iter().zip(&mesh.colors) {
        assert_eq!(color.truncate(), (*at + glam::Vec3::ONE) * 0.5, "{at}");
    }
    assert_eq!(mesh.colors.len(), 24);
    let flat = parse("[[objects]]\nmesh = 'quad'\ncolors = 'position'\n")
        .unwrap_or_else(|error| panic!("{error}"))
        .scene;
    assert!(flat.meshes[0].colors.iter().all(|color| color.z == 0.5), "across no extent it is one half");
}
