//! A session draws what a new shot of the changed scene draws, to the last bit, and prepares nothing twice.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use std::sync::Arc;

use common::everything::{COATED, GLASS, METAL, PHONG, POINT, RECTANGLE, everything, punctual, texture};
use common::shiny;
use glam::{DMat4, DVec3};
use glanz_color::{Rgb, light, observer};
use glanz_picture::ToneMap;
use glanz_render::{Prepared, Samples, Session, Shot, ShotError};
use glanz_scene::{
    Background, Camera, ColorMode, DebugView, Interpolation, LightKind, Scene, Shading, TextureUse, White,
};

/// A change of a session, and its name.
type Case = (&'static str, fn(&mut Session));

const CASES: &[Case] = &[
    ("material", |s| s.material_mut(PHONG).unwrap().set("shininess", 3.0).unwrap()),
    ("other material", |s| *s.material_mut(METAL).unwrap() = shiny("blinn-phong", 9.0)),
    ("light's place", |s| s.light_mut(POINT).unwrap().set_position([-1.0, 1.5, 1.0]).unwrap()),
    ("light's spectrum", |s| s.light_mut(POINT).unwrap().set_spectrum(light("A").unwrap())),
    ("light's kind", |s| s.light_mut(POINT).unwrap().kind = LightKind::Ambient),
    ("object's place", |s| s.object_mut(METAL).unwrap().set_position([0.4, 0.3, 0.2])),
    ("object's material", |s| s.object_mut(METAL).unwrap().material = GLASS),
    ("object turned inside out", |s| {
        s.object_mut(METAL).unwrap().transform *= DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    }),
    ("camera", |s| s.set_camera(Camera::new([1.0, 2.0, 3.0], [0.0; 3]))),
    ("size", |s| s.set_size(61, 23)),
    ("samples", |s| s.set_samples(Samples::Four)),
    ("background", |s| s.set_background(Background::Color(Rgb([0.9, 0.2, 0.1])))),
    ("no background", |s| s.set_background(Background::Transparent)),
    ("exposure", |s| s.set_ev(1.5)),
    ("tone mapping", |s| s.set_tone_map(ToneMap::Reinhard)),
    ("white", |s| s.set_white(White::Scene)),
    ("no white", |s| s.set_white(White::None)),
    ("view of normals", |s| s.set_show(DebugView::Normals)),
    ("shading", |s| s.set_shading(Shading::Gouraud)),
    ("shadows", |s| s.set_shadows(!s.scene().render.shadows)),
    ("componentwise", |s| s.set_mode(ColorMode::Rgb)),
    ("Meyer's samples", |s| s.set_mode(ColorMode::Meyer)),
    ("uniform samples", |s| s.set_mode(ColorMode::Sampled(5))),
    ("observer and a light", |s| {
        s.set_mode(ColorMode::Spectral);
        s.set_observer(Some(observer("cie1964").unwrap()));
        s.light_mut(POINT).unwrap().set_color(Rgb([0.2, 0.5, 0.9]));
    }),
    ("several at once", |s| {
        s.material_mut(PHONG).unwrap().set("shininess", 3.0).unwrap();
        s.object_mut(METAL).unwrap().set_position([0.4, 0.3, 0.2]);
        s.light_mut(POINT).unwrap().set_position([-1.0, 1.5, 1.0]).unwrap();
        s.set_ev(-1.0);
        s.set_size(50, 40);
    }),
    ("anything", |s| {
        let scene = s.scene_mut();
        scene.textures.push(texture(false));
        scene.materials[PHONG].base_color = Some(TextureUse::plain(scene.textures.len() - 1));
        scene.render.interpolation = Interpolation::ScreenLinear;
        scene.lights.remove(0);
        scene.objects.pop();
    }),
    ("a part before anything", |s| {
        s.material_mut(PHONG).unwrap().set("shininess", 3.0).unwrap();
        s.scene_mut().meshes[METAL].positions[0].x += 0.1;
        s.light_mut(POINT).unwrap().set_position([-1.0, 1.5, 1.0]).unwrap();
    }),
];

/// A scene of few pixels.
fn small(scene: Scene, mode: ColorMode) -> Scene {
    let mut scene = scene.with_size(48, 36).with_mode(mode);
    scene.image.samples = 1;
    scene.image.background = Background::Color(Rgb([0.05, 0.1, 0.2]));
    scene
}

fn assert_draws(session: &mut Session, scene: &Scene, what: &str) {
    let mut fresh = Shot::new(scene).unwrap();
    assert!(session.rgba8().unwrap() == fresh.rgba8().unwrap(), "{what}: codes differ");
    let (session_frame, frame) = (session.frame().unwrap(), fresh.frame().unwrap());
    assert!(session_frame == frame, "{what}: frames differ");
    assert!(session.prepared() == fresh.prepared(), "{what}: what is prepared differs");
}

fn check(scene: Scene, cases: &[Case]) {
    let mut session = Session::new(scene.clone()).unwrap();
    for (name, change) in cases {
        let before = session.rgba8().unwrap();
        change(&mut session);
        let changed = session.scene().clone();
        assert_draws(&mut session, &changed, name);
        assert!(session.rgba8().unwrap() != before, "{name} changes nothing");
        *session.scene_mut() = scene.clone();
        assert_draws(&mut session, &scene, &format!("{name}, and back"));
    }
}

#[test]
fn a_changed_session_draws_what_a_new_shot_draws() {
    check(small(punctual(), ColorMode::Spectral), CASES);
}

#[test]
fn so_it_does_with_shadows_in_rgb() {
    let mut scene = small(punctual(), ColorMode::Rgb);
    scene.render.shadows = true;
    let without_observer = |case: &&Case| !case.0.contains("white") && case.0 != "componentwise";
    let cases: Vec<Case> = CASES.iter().filter(without_observer).copied().collect();
    check(scene, &cases);
}

#[test]
fn so_it_does_under_areas() {
    let cases: &[Case] = &[
        ("area's place", |s| s.light_mut(RECTANGLE).unwrap().set_position([0.3, 1.0, 1.0]).unwrap()),
        ("roughness", |s| s.material_mut(COATED).unwrap().set("lobes.1.alpha", 0.15).unwrap()),
        ("environment", |s| s.set_background(Background::Environment)),
    ];
    check(small(everything(), ColorMode::Rgb), cases);
}

/// Where the arrays are that are made by preparing.
fn places(prepared: &Prepared) -> (usize, *const u8, usize, usize) {
    let textures = Arc::as_ptr(&prepared.textures[0]) as usize;
    let table = prepared.materials.as_ptr().cast();
    (Arc::as_ptr(&prepared.geometry) as usize, table, textures, prepared.objects.as_ptr() as usize)
}

#[test]
fn drawing_again_prepares_nothing() {
    let mut session = Session::new(small(punctual(), ColorMode::Spectral)).unwrap();
    let first = session.rgba8().unwrap();
    let before = places(session.prepared());
    assert_eq!(session.rgba8().unwrap(), first);
    session.set_camera(Camera::new([1.0, 2.0, 3.0], [0.0; 3]));
    session.set_ev(1.0);
    session.set_size(20, 10);
    session.rgba8().unwrap();
    session.light_mut(POINT).unwrap();
    session.update().unwrap();
    assert_eq!(
        places(session.prepared()),
        before,
        "nor do camera, exposure, size and a light that is only looked at"
    );
}

#[test]
fn a_changed_material_leaves_geometry_and_textures() {
    let mut session = Session::new(small(punctual(), ColorMode::Spectral)).unwrap();
    let before = (Arc::clone(&session.prepared().geometry), Arc::clone(&session.prepared().textures[0]));
    session.material_mut(PHONG).unwrap().set("shininess", 3.0).unwrap();
    session.light_mut(POINT).unwrap().set_position([-1.0, 1.5, 1.0]).unwrap();
    session.update().unwrap();
    assert!(Arc::ptr_eq(&before.0, &session.prepared().geometry));
    assert!(Arc::ptr_eq(&before.1, &session.prepared().textures[0]));
}

#[test]
fn after_an_error_the_scene_is_what_was_drawn_last() {
    let scene = small(punctual(), ColorMode::Spectral);
    let mut session = Session::new(scene.clone()).unwrap();
    let faults: &[Case] = &[
        ("size", |s| s.set_size(0, 10)),
        ("camera", |s| s.set_camera(Camera::new([0.0; 3], [0.0; 3]))),
        ("light", |s| s.light_mut(POINT).unwrap().set_color(Rgb([f32::NAN; 3]))),
        ("material", |s| s.material_mut(PHONG).unwrap().base_color = Some(TextureUse::plain(99))),
        ("object", |s| s.object_mut(METAL).unwrap().transform.w_axis.x = f64::NAN),
        ("material's number", |s| s.object_mut(METAL).unwrap().material = 99),
        ("observer", |s| s.set_mode(ColorMode::Meyer)),
        ("samples", |s| s.scene_mut().image.samples = 3),
        ("no environment", |s| s.set_background(Background::Environment)),
        ("texture", |s| s.scene_mut().textures.clear()),
    ];
    session.set_observer(Some(observer("cie1964").unwrap()));
    let good = session.scene().clone();
    session.update().unwrap();
    for (name, fault) in faults {
        // Some changes that could be made stand before the one that cannot.
        session.material_mut(METAL).unwrap().two_sided ^= true;
        session.light_mut(0).unwrap().set_color(Rgb([0.9, 0.1, 0.3]));
        fault(&mut session);
        let error: Result<(), ShotError> = session.update();
        assert!(error.is_err(), "{name}");
        assert!(*session.scene() == good, "{name}");
        assert_draws(&mut session, &good, name);
    }
}

#[test]
fn a_buffer_of_another_length_is_an_error_that_says_which_is_right() {
    let mut session = Session::new(Scene::new().with_size(8, 6)).unwrap();
    for found in [0, 4 * 8 * 6 - 1, 4 * 8 * 6 + 4] {
        let error = session.draw_into(&mut vec![0; found]).unwrap_err();
        assert_eq!(error, ShotError::Length { width: 8, height: 6, expected: 192, found });
        assert!(error.to_string().contains("192 bytes"), "{error}");
    }
    session.draw_into(&mut [0; 192]).unwrap();
}
