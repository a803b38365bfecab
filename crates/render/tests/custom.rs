//! A model of a program's own is drawn as one of the list is, to the bit.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::everything::{METAL, everything};
use common::{picture, transparent};
use glanz_bsdf::Shape;
use glanz_picture::Frame;
use glanz_render::Session;
use glanz_scene::{Camera, Light, Lobe, Material, Mesh, Scene};

/// The scene with its general lobes as a program's own models, and how many those are.
fn with_own_models(scene: &Scene) -> (Scene, usize) {
    let mut own = scene.clone();
    let mut replaced = 0;
    for lobe in own.materials.iter_mut().flat_map(|material| &mut material.lobes) {
        let custom = match &lobe.shape {
            Shape::Ggx(model) => Shape::custom(*model),
            Shape::GgxTransmission(model) => Shape::custom(*model),
            Shape::LambertTransmission(model) => Shape::custom(*model),
            Shape::Ward(model) => Shape::custom(*model),
            _ => continue,
        };
        lobe.shape = custom;
        replaced += 1;
    }
    (own, replaced)
}

fn bits(frame: &Frame) -> Vec<u32> {
    frame.rgb.iter().flatten().map(|value| value.to_bits()).collect()
}

#[test]
fn under_every_light_the_pixels_are_those_of_the_list() {
    let listed = everything();
    let (own, replaced) = with_own_models(&listed);
    assert!(replaced >= 3, "only {replaced} lobes are replaced");
    let drawn = |scene: &Scene| bits(&picture(scene, 90, 60, &transparent()));
    assert!(drawn(&own) == drawn(&listed));
}

/// The loop of classic materials holds models of the list alone, whatever a model says of its cost.
#[test]
fn a_cheap_model_of_a_programs_own_is_not_dark() {
    let scene = |shapes: [Shape; 2]| {
        let lobes = shapes.map(|shape| Lobe::new(shape, [0.5; 3])).to_vec();
        Scene::new()
            .with_mesh(Mesh::builtin("sphere").unwrap(), Material::of_lobes("own", lobes))
            .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0; 3]))
            .with_camera(Camera::new([0.0, 0.0, 4.0], [0.0; 3]))
    };
    let drawn = |shapes| picture(&scene(shapes), 60, 40, &transparent());
    let (matte, shiny) = (Shape::named("lambert", &[]).unwrap(), Shape::named("blinn-phong", &[]).unwrap());
    let own = [&matte, &shiny].map(|shape| match shape {
        Shape::Lambert(model) => Shape::custom(*model),
        Shape::BlinnPhong(model) => Shape::custom(*model),
        other => panic!("{other:?}"),
    });
    let (own, listed) = (drawn(own), drawn([matte, shiny]));
    let furthest = own.rgb[0].iter().zip(&listed.rgb[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    // The loop adds in another order.
    assert!(furthest < 1e-5 && listed.rgb[0].iter().any(|value| *value > 0.5), "{furthest}");
}

#[test]
fn a_parameter_that_is_set_redoes_the_picture() {
    let listed = everything();
    let alpha = |scene: Scene| {
        let mut session = Session::new(scene).unwrap();
        let before = bits(&session.frame().unwrap());
        session.material_mut(METAL).unwrap().lobes[0].set("alpha", 0.41).unwrap();
        let after = bits(&session.frame().unwrap());
        assert!(before != after);
        after
    };
    assert!(alpha(with_own_models(&listed).0) == alpha(listed));
}

#[test]
fn a_scene_file_cannot_name_it() {
    let (own, _) = with_own_models(&everything());
    let error = glanz_scene::file::write(&own, "data").unwrap_err();
    assert!(
        error.to_string().ends_with("a lobe of a model that only the program knows cannot be written"),
        "{error}"
    );
}
