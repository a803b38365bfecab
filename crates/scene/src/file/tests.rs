//! What scene files mean, and how they fail.

use std::path::{Path, PathBuf};

use glam::{DMat4, DVec3};
use glanz_color::Rgb;

use super::*;
use crate::{
    Attenuation, Background, Camera, ClassicMaterial, Image, LightColors, LightKind, Projection, Shading,
    Space,
};

/// The folder of the example scenes.
fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// All example scenes, by name.
fn example_files() -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(examples())
        .expect("the examples are there")
        .map(|entry| entry.expect("readable").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    files
}

fn parse(text: &str) -> Result<Loaded, FileError> {
    parse_str(text, &examples(), &LoadOptions::default())
}

fn scene(text: &str) -> Scene {
    parse(text).unwrap_or_else(|error| panic!("{error}\n{text}")).scene
}

/// The message, and the text that it points at.
fn error(text: &str) -> (String, String) {
    let error = parse(text).expect_err(text);
    let span = error.span.expect("every error in a text has a place");
    (error.message, error.text[span].to_owned())
}

/// The scene of the examples that says most, without the mesh from a file.
fn full() -> String {
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
    assert_eq!((ambient.kind, ambient.colors.ambient), (LightKind::Ambient, Rgb::gray(0.1)));
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
    assert_eq!(spot.colors, LightColors { ambient: color, diffuse: color, specular: Rgb::BLACK });
    assert_eq!(spot.space, Space::World);
}

#[test]
fn the_full_example_has_its_materials_and_objects() {
    let scene = scene(&full());
    let [matte, red] = &scene.materials[..] else { panic!("{:?}", scene.materials) };
    let tint = Rgb([0.8, 0.1, 0.1]);
    let classic = ClassicMaterial {
        ambient: tint,
        diffuse: tint,
        specular: Rgb::gray(0.6),
        shininess: 32.0,
        model: "blinn-phong".to_owned(),
        ..ClassicMaterial::default()
    };
    assert_eq!(*red, classic.build("red").expect("valid"));
    assert_eq!((matte.lobes.len(), matte.lobes[0].tint), (1, Rgb([0.7, 0.7, 0.2])));
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
fn an_unknown_key_is_refused_with_its_table_and_the_nearest_key() {
    let text = full().replace("shininess =", "shinines =");
    let (message, place) = error(&text);
    assert_eq!(message, "unknown key 'shinines' in [materials.red]; did you mean 'shininess'?");
    assert_eq!(place, "shinines");
    let error = parse(&text).expect_err("unknown key");
    assert_eq!((error.line, error.column), (48, 1));
    assert!(error.to_string().starts_with("scene:48:1: unknown key"), "{error}");
}
