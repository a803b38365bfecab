//! An update gives what preparing the changed scene gives, to the last bit, and redoes nothing else.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use std::sync::Arc;

use common::everything::{
    AMBIENT, BALL, COATED, ENVIRONMENT, GLASS, GROUND, LUMINAIRE, METAL, PHONG, POINT, RECTANGLE, SPOT,
    TEXTURED, WINDOW, environment_map, everything, punctual, texture,
};
use common::{ALL_LAYERS, light, rectangle, shiny};
use glam::{DMat3, DMat4, DVec3};
use glanz_bsdf::Shape;
use glanz_color::Rgb;
use glanz_render::prepare::LobeLookups;
use glanz_render::{
    Change, DrawOptions, Frame, Observation, PrepareError, PrepareOptions, Prepared, View, draw, prepare,
};
use glanz_scene::{
    AlphaMode, AreaShape, Attenuation, Background, ColorMode, Interpolation, LightColors, LightKind, Lobe,
    RoughnessMap, Scene, Shading, TextureUse, White,
};

/// A change of a scene, its name, and what the update is told.
type Case = (&'static str, fn(&mut Scene), &'static [Change]);

/// Changes of scenes with lights of any kind.
const CASES: &[Case] = &[
    ("moved point light", |s| move_point(s, POINT), &[Change::Light(POINT)]),
    ("moved luminaire", |s| move_point(s, LUMINAIRE), &[Change::Light(LUMINAIRE)]),
    ("luminaire gone", |s| s.lights[LUMINAIRE].luminaire = None, &[Change::Light(LUMINAIRE)]),
    (
        "recoloured light",
        |s| s.lights[SPOT].colors = LightColors::all(Rgb([0.9, 0.1, 0.3])),
        &[Change::Light(SPOT)],
    ),
    (
        "recoloured ambient light",
        |s| s.lights[AMBIENT].colors = LightColors::all(Rgb([0.9, 0.1, 0.3])),
        &[Change::Light(AMBIENT)],
    ),
    ("light of another kind", |s| s.lights[SPOT].kind = s.lights[POINT].kind.clone(), &[Change::Light(SPOT)]),
    ("light made ambient", |s| s.lights[POINT].kind = LightKind::Ambient, &[Change::Light(POINT)]),
    (
        "light in the camera's space",
        |s| s.lights[POINT].space = glanz_scene::Space::Camera,
        &[Change::Light(POINT)],
    ),
    ("roughness", |s| set_shape(s, COATED, "ggx", &[("alpha", 0.15)]), &[Change::Material(COATED)]),
    ("model", |s| s.materials[PHONG] = shiny("blinn-phong-normalized", 40.0), &[Change::Material(PHONG)]),
    (
        "tint",
        |s| s.materials[GROUND].lobes[0].tint = Rgb([0.1, 0.7, 0.2]).into(),
        &[Change::Material(GROUND)],
    ),
    (
        "texture use",
        |s| s.materials[PHONG].base_color = Some(TextureUse::plain(0)),
        &[Change::Material(PHONG)],
    ),
    (
        "map of normals",
        |s| s.materials[GROUND].normal_map = Some(TextureUse::plain(1)),
        &[Change::Material(GROUND)],
    ),
    ("no map of normals", |s| s.materials[TEXTURED].normal_map = None, &[Change::Material(TEXTURED)]),
    (
        "a caster becomes clear",
        |s| s.materials[PHONG].alpha_mode = AlphaMode::Blend,
        &[Change::Material(PHONG)],
    ),
    (
        "a clear one becomes a caster",
        |s| s.materials[GLASS].alpha_mode = AlphaMode::Opaque,
        &[Change::Material(GLASS)],
    ),
    ("no transmittance", |s| s.materials[WINDOW].transmittance = None, &[Change::Material(WINDOW)]),
    ("moved object", |s| s.objects[METAL].transform.w_axis.y += 0.3, &[Change::Object(METAL)]),
    ("turned object", |s| turn(s, METAL, DMat4::from_rotation_z(0.7)), &[Change::Object(METAL)]),
    (
        "turned object with a map of normals",
        |s| turn(s, TEXTURED, DMat4::from_rotation_y(0.5)),
        &[Change::Object(TEXTURED)],
    ),
    ("turned flat object", |s| turn(s, COATED, DMat4::from_rotation_z(0.7)), &[Change::Object(COATED)]),
    ("turned object by scanlines", |s| turn(s, GLASS, DMat4::from_rotation_x(0.7)), &[Change::Object(GLASS)]),
    (
        "mirrored object",
        |s| turn(s, METAL, DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0))),
        &[Change::Object(METAL)],
    ),
    (
        "flattened object",
        |s| turn(s, PHONG, DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0))),
        &[Change::Object(PHONG)],
    ),
    ("object of another material", |s| s.objects[PHONG].material = GROUND, &[Change::Object(PHONG)]),
    ("object shaded otherwise", |s| s.objects[PHONG].shading = Some(Shading::Flat), &[Change::Object(PHONG)]),
    ("replaced mesh", |s| s.meshes[PHONG] = rectangle([-0.5, 0.0, 0.5, 0.9], 0.5), &[Change::Geometry]),
    (
        "replaced mesh, told as the object",
        |s| s.meshes[PHONG] = rectangle([-0.5, 0.0, 0.5, 0.9], 0.5),
        &[Change::Object(PHONG)],
    ),
    ("one object less", |s| drop(s.objects.pop()), &[Change::Geometry]),
    ("one object more", |s| s.objects.push(s.objects[GROUND].clone()), &[Change::Geometry]),
    (
        "one object more, told by number",
        |s| s.objects.push(s.objects[GROUND].clone()),
        &[Change::Object(GLASS)],
    ),
    ("object of a new material", add_material, &[Change::Geometry]),
    ("new material alone", add_material, &[Change::Material(0)]),
    ("one light more", |s| s.lights.push(s.lights[POINT].clone()), &[Change::Light(0)]),
    ("newest light by number", |s| s.lights.insert(0, s.lights[POINT].clone()), &[Change::Colors]),
    ("shading of the scene", |s| s.render.shading = Shading::Gouraud, &[Change::Geometry]),
    ("interpolation", |s| s.render.interpolation = Interpolation::ScreenLinear, &[Change::Geometry]),
    ("textures", |s| s.textures[0] = texture(false), &[Change::Textures]),
    ("a texture more", add_texture, &[Change::Material(PHONG)]),
    ("a texture more, told as a colour", add_texture, &[Change::Colors]),
    ("a texture more, told before", add_texture, &[Change::Textures, Change::Material(PHONG)]),
    ("a texture more, told after", add_texture, &[Change::Material(PHONG), Change::Textures]),
    ("no textures, told before", drop_textures, &[Change::Textures, Change::Colors]),
    ("no textures, told after", drop_textures, &[Change::Colors, Change::Textures]),
    ("all colours", recolor, &[Change::Colors]),
    ("white", |s| s.render.white = White::Scene, &[Change::Colors]),
    ("photometric units", |s| s.photometric = true, &[Change::Colors]),
    (
        "colours after what they depend on",
        |s| {
            recolor(s);
            move_point(s, POINT)
        },
        &[Change::Light(POINT), Change::Colors],
    ),
    (
        "colours before what they depend on",
        |s| {
            recolor(s);
            move_point(s, POINT)
        },
        &[Change::Colors, Change::Light(POINT)],
    ),
    ("all lights and materials", lights_and_materials, &[Change::Colors]),
    ("shadows", |s| s.render.shadows = !s.render.shadows, &[Change::Camera]),
    ("no change", |_| (), &[Change::Camera]),
    (
        "anything",
        |s| {
            s.lights.remove(1);
            s.materials.push(shiny("phong", 1.0))
        },
        &[Change::All],
    ),
];

/// Changes of scenes with environments and areas.
const FIELD_CASES: &[Case] = &[
    ("moved lamp", |s| move_point(s, POINT), &[Change::Light(POINT)]),
    ("roughness", |s| set_shape(s, COATED, "ggx", &[("alpha", 0.15)]), &[Change::Material(COATED)]),
    ("environment's map", |s| set_map(s, Some(0.9)), &[Change::Light(ENVIRONMENT)]),
    ("environment's map, told as a colour", |s| set_map(s, Some(0.9)), &[Change::Colors]),
    (
        "environment's map, told twice",
        |s| set_map(s, Some(0.9)),
        &[Change::Colors, Change::Light(ENVIRONMENT)],
    ),
    ("environment without a map", |s| set_map(s, None), &[Change::Light(ENVIRONMENT)]),
    ("turned environment", turn_environment, &[Change::Light(ENVIRONMENT)]),
    ("other area", |s| set_area(s, RECTANGLE, AreaShape::Disk { radius: 0.4 }), &[Change::Light(RECTANGLE)]),
    ("no areas", |s| s.lights.truncate(RECTANGLE), &[Change::All]),
    ("area made a point", |s| s.lights[BALL].kind = s.lights[POINT].kind.clone(), &[Change::Light(BALL)]),
];

fn move_point(scene: &mut Scene, number: usize) {
    let position = DVec3::new(-1.0, 1.5, 1.0);
    scene.lights[number].kind = LightKind::Point { position, attenuation: Attenuation::NONE };
}

fn set_shape(scene: &mut Scene, material: usize, name: &str, set: &[(&str, f64)]) {
    let mut lobes = scene.materials[material].lobes.iter_mut();
    lobes.find(|lobe| lobe.shape.info().name == name).unwrap().shape = Shape::named(name, set).unwrap();
}

fn turn(scene: &mut Scene, object: usize, by: DMat4) {
    scene.objects[object].transform *= by;
}

fn add_material(scene: &mut Scene) {
    scene.materials.push(shiny("phong", 5.0));
    scene.objects[PHONG].material = scene.materials.len() - 1;
}

fn add_texture(scene: &mut Scene) {
    scene.textures.push(texture(false));
    scene.materials[PHONG].base_color = Some(TextureUse::plain(scene.textures.len() - 1));
}

fn without_masks(lobe: &Lobe) -> Lobe {
    Lobe { masks: Vec::new(), roughness: RoughnessMap::Material, ..lobe.clone() }
}

fn drop_textures(scene: &mut Scene) {
    scene.textures.clear();
    for material in &mut scene.materials {
        (material.base_color, material.normal_map) = (None, None);
        (material.emission_map, material.metal_rough_map) = (None, None);
        (material.occlusion, material.lobes) = (None, material.lobes.iter().map(without_masks).collect());
    }
}

fn recolor(scene: &mut Scene) {
    for light in &mut scene.lights {
        light.colors = light.colors.scaled(0.7);
    }
    scene.materials[PHONG] = shiny("phong", 20.0);
    scene.materials[GROUND].lobes[0].tint = Rgb([0.1, 0.7, 0.2]).into();
}

fn lights_and_materials(scene: &mut Scene) {
    recolor(scene);
    move_point(scene, POINT);
    scene.materials[GROUND].normal_map = Some(TextureUse::plain(1));
    scene.materials[PHONG].alpha_mode = AlphaMode::Blend;
}

fn set_map(scene: &mut Scene, blue: Option<f32>) {
    let LightKind::Environment { map, .. } = &mut scene.lights[ENVIRONMENT].kind else { unreachable!() };
    *map = blue.map(environment_map);
}

fn turn_environment(scene: &mut Scene) {
    let LightKind::Environment { rotation, .. } = &mut scene.lights[ENVIRONMENT].kind else { unreachable!() };
    *rotation = DMat3::from_rotation_x(1.0);
}

fn set_area(scene: &mut Scene, light: usize, form: AreaShape) {
    let LightKind::Area { shape, .. } = &mut scene.lights[light].kind else { unreachable!() };
    *shape = form;
}

fn options(mode: ColorMode) -> PrepareOptions {
    let observation = Observation::new(mode, None).unwrap();
    PrepareOptions { observation, ..PrepareOptions::default() }
}

fn frame(prepared: &Prepared, scene: &Scene) -> Frame {
    let view = View::new(&scene.camera.unwrap(), 90, 70).unwrap();
    let background = Background::Color(Rgb([0.05, 0.1, 0.2]));
    draw(prepared, &view, &DrawOptions { aovs: ALL_LAYERS, ..DrawOptions::new(background) })
}

/// The bits of all planes, so that −0 is not 0.
fn bits(frame: &Frame) -> Vec<u32> {
    let planes = frame.rgb.iter().chain([&frame.alpha, &frame.depth]).chain(&frame.normal);
    planes.flatten().map(|value| value.to_bits()).chain(frame.object.iter().copied()).collect()
}

/// Says in which field two differ, since all of both would fill pages.
fn assert_same(updated: &Prepared, fresh: &Prepared, what: &str) {
    assert!(updated.geometry == fresh.geometry, "{what}: geometry differs");
    assert!(updated.objects == fresh.objects, "{what}: objects differ");
    assert!(updated.materials == fresh.materials, "{what}: materials differ");
    assert!(updated.lights == fresh.lights, "{what}: lights differ");
    assert!(updated.textures == fresh.textures, "{what}: textures differ");
    assert!(updated.bvh == fresh.bvh, "{what}: casters differ");
    assert!(updated.channels == fresh.channels, "{what}: channels differ");
    assert!(updated == fresh, "{what}: something else differs");
}

fn check(scene: &Scene, cases: &[Case], mode: ColorMode) {
    let options = options(mode);
    let start = prepare(scene, &options).unwrap();
    for (name, change, told) in cases {
        let mut changed = scene.clone();
        change(&mut changed);
        let mut updated = start.clone();
        updated.update(&changed, told).unwrap();
        let fresh = prepare(&changed, &options).unwrap();
        let what = format!("{name}, {mode:?}, shadows {}", scene.render.shadows);
        assert_same(&updated, &fresh, &what);
        assert!(bits(&frame(&updated, &changed)) == bits(&frame(&fresh, &changed)), "{what}: frames differ");
        // And back, which finds whatever the update left behind.
        updated.update(scene, told).unwrap();
        assert_same(&updated, &start, &format!("{what}, and back"));
        // The changes are found by comparing, too.
        updated.update(&changed, &Change::between(scene, &changed)).unwrap();
        assert_same(&updated, &fresh, &format!("{what}, found"));
    }
}

fn with_shadows(mut scene: Scene, shadows: bool) -> Scene {
    scene.render.shadows = shadows;
    scene
}

#[test]
fn updated_is_as_prepared_anew_in_rgb() {
    check(&with_shadows(punctual(), false), CASES, ColorMode::Rgb);
}

#[test]
fn updated_is_as_prepared_anew_in_rgb_with_shadows() {
    check(&with_shadows(punctual(), true), CASES, ColorMode::Rgb);
}

#[test]
fn updated_is_as_prepared_anew_in_spectra() {
    check(&with_shadows(punctual(), false), CASES, ColorMode::Spectral);
}

#[test]
fn updated_is_as_prepared_anew_in_spectra_with_shadows() {
    check(&with_shadows(punctual(), true), CASES, ColorMode::Spectral);
}

#[test]
fn updated_is_as_prepared_anew_under_environments_and_areas() {
    check(&with_shadows(everything(), true), FIELD_CASES, ColorMode::Rgb);
    check(&with_shadows(everything(), false), FIELD_CASES, ColorMode::Spectral);
}

#[test]
fn the_cases_change_pictures() {
    for (scene, cases) in [(punctual(), CASES), (everything(), FIELD_CASES)] {
        let scene = with_shadows(scene, true);
        let start = prepare(&scene, &options(ColorMode::Spectral)).unwrap();
        for (name, change, told) in cases.iter().filter(|case| case.0 != "no change") {
            let mut changed = scene.clone();
            change(&mut changed);
            let mut updated = start.clone();
            updated.update(&changed, told).unwrap();
            assert!(updated != start, "{name}");
        }
    }
}

/// What an update took over and did not copy.
fn shared(scene: &Scene, change: fn(&mut Scene), told: Change) -> [bool; 3] {
    let start = prepare(scene, &options(ColorMode::Rgb)).unwrap();
    let mut changed = scene.clone();
    change(&mut changed);
    let mut updated = start.clone();
    updated.update(&changed, &[told]).unwrap();
    let textures = start.textures.iter().zip(&updated.textures).all(|(a, b)| Arc::ptr_eq(a, b));
    let bvh = start.bvh.as_ref().zip(updated.bvh.as_ref()).is_some_and(|(a, b)| Arc::ptr_eq(a, b));
    [Arc::ptr_eq(&start.geometry, &updated.geometry), textures, bvh]
}

#[test]
fn what_did_not_change_is_shared() {
    let scene = with_shadows(punctual(), true);
    let share = |change, told| shared(&scene, change, told);
    assert_eq!(share(|s| move_point(s, POINT), Change::Light(POINT)), [true; 3]);
    assert_eq!(
        share(|s| set_shape(s, COATED, "ggx", &[("alpha", 0.15)]), Change::Material(COATED)),
        [true; 3]
    );
    assert_eq!(share(recolor, Change::Colors), [true; 3]);
    assert_eq!(share(|_| (), Change::Camera), [true; 3]);
    assert_eq!(share(|s| s.textures[0] = texture(false), Change::Textures), [true, false, true]);
    let moved = |s: &mut Scene| s.objects[PHONG].transform.w_axis.y += 0.3;
    assert_eq!(share(moved, Change::Object(PHONG)), [false, true, false]);
    let clear = |s: &mut Scene| s.materials[PHONG].alpha_mode = AlphaMode::Blend;
    assert_eq!(share(clear, Change::Material(PHONG)), [true, true, false]);
}

#[test]
fn a_moved_object_moves_in_place() {
    let mut scene = punctual();
    let mut prepared = prepare(&scene, &options(ColorMode::Rgb)).unwrap();
    let before = Arc::as_ptr(&prepared.geometry);
    scene.objects[PHONG].transform.w_axis.y += 0.3;
    prepared.update(&scene, &[Change::Object(PHONG)]).unwrap();
    assert_eq!(Arc::as_ptr(&prepared.geometry), before);
}

#[test]
fn what_lobes_make_of_environments_survives_a_moved_lamp() {
    let mut scene = everything();
    let start = prepare(&scene, &options(ColorMode::Rgb)).unwrap();
    move_point(&mut scene, POINT);
    scene.lights[SPOT] = light(scene.lights[SPOT].kind.clone(), Rgb([0.1, 0.2, 0.3]));
    let mut updated = start.clone();
    updated.update(&scene, &[Change::Light(POINT), Change::Light(SPOT)]).unwrap();
    let [before, after] = [&start, &updated].map(lookups_of);
    assert!(Arc::ptr_eq(&before, &after));
}

fn lookups_of(prepared: &Prepared) -> Arc<LobeLookups> {
    prepared.materials[COATED].integrals[1].lookups.clone().unwrap()
}

#[test]
fn no_material_keeps_a_texture_that_is_gone() {
    let mut scene = punctual();
    let mut updated = prepare(&scene, &options(ColorMode::Rgb)).unwrap();
    drop_textures(&mut scene);
    updated.update(&scene, &[Change::Textures]).unwrap();
    assert_same(&updated, &prepare(&scene, &options(ColorMode::Rgb)).unwrap(), "no textures");
}

/// The message of an update that must fail, after which all is as it was.
fn refused(scene: &Scene, change: fn(&mut Scene), told: &[Change]) -> String {
    let start = prepare(scene, &options(ColorMode::Rgb)).unwrap();
    let mut changed = scene.clone();
    change(&mut changed);
    let mut updated = start.clone();
    let error: PrepareError = updated.update(&changed, told).unwrap_err();
    assert_same(&updated, &start, &error.to_string());
    assert!(bits(&frame(&updated, scene)) == bits(&frame(&start, scene)), "{error}");
    // What is sound is still taken.
    updated.update(scene, &[Change::Colors, Change::Geometry, Change::Textures]).unwrap();
    assert_same(&updated, &start, &error.to_string());
    error.to_string()
}

/// A change that an update refuses, what the update is told, and the message.
type Refusal = (fn(&mut Scene), Change, &'static str);

const REFUSALS: &[Refusal] = &[
    (|_| (), Change::Light(99), "light 99 (counted from 0) is not there"),
    (|_| (), Change::Material(99), "material 99 (counted from 0) is not there"),
    (|_| (), Change::Object(99), "object 99 (counted from 0) is not there"),
    (
        |s| s.lights[POINT].colors = LightColors::all(Rgb([f32::NAN, 0.0, 0.0])),
        Change::Light(POINT),
        "light 3: colors must be finite numbers",
    ),
    (
        |s| s.lights[POINT].colors = LightColors::all(Rgb([f32::NAN, 0.0, 0.0])),
        Change::Colors,
        "light 3: colors must be finite numbers",
    ),
    (
        |s| s.lights[1].kind = LightKind::Directional { direction: DVec3::ZERO },
        Change::Light(1),
        "light 2: the direction must be finite and not zero",
    ),
    (
        |s| s.materials[PHONG].base_color = Some(TextureUse::plain(9)),
        Change::Material(PHONG),
        "material 'shiny' names a texture that is not there",
    ),
    (
        |s| s.materials[PHONG].base_color = Some(TextureUse::plain(9)),
        Change::Colors,
        "material 'shiny' names a texture that is not there",
    ),
    (
        |s| s.materials[PHONG].lobes[0].tint = Rgb([f32::INFINITY; 3]).into(),
        Change::Material(PHONG),
        "material 'shiny': tints must be finite numbers",
    ),
    (
        |s| {
            add_texture(s);
            s.materials[PHONG].lobes[0].tint = Rgb([f32::INFINITY; 3]).into()
        },
        Change::Material(PHONG),
        "material 'shiny': tints must be finite numbers",
    ),
    (
        |s| {
            move_point(s, POINT);
            s.materials[PHONG].lobes[0].tint = Rgb([f32::INFINITY; 3]).into()
        },
        Change::Colors,
        "material 'shiny': tints must be finite numbers",
    ),
    (
        |s| s.objects[PHONG].transform.w_axis.x = f64::NAN,
        Change::Object(PHONG),
        "object '' has a transform with numbers that are not finite",
    ),
    (
        |s| s.objects[PHONG].transform.w_axis.x = f64::NAN,
        Change::Geometry,
        "object '' has a transform with numbers that are not finite",
    ),
    (
        |s| {
            s.materials[GROUND].normal_map = Some(TextureUse::plain(1));
            s.objects[PHONG].transform.w_axis.x = f64::NAN
        },
        Change::Material(GROUND),
        "object '' has a transform with numbers that are not finite",
    ),
    (|s| s.objects[PHONG].mesh = 99, Change::Object(PHONG), "object '' names mesh 99, which is not there"),
    (
        |s| s.objects[PHONG].material = 99,
        Change::Object(PHONG),
        "object '' names material 99, which is not there",
    ),
    (|s| s.textures.clear(), Change::Textures, "material 'shiny' names a texture that is not there"),
    (
        |s| {
            s.textures.clear();
            s.render.shadows = false
        },
        Change::All,
        "material 'shiny' names a texture that is not there",
    ),
];

#[test]
fn what_cannot_be_done_is_refused_and_changes_nothing() {
    let scene = with_shadows(punctual(), true);
    for (change, told, message) in REFUSALS {
        assert_eq!(refused(&scene, *change, &[*told]), *message, "{told:?}");
    }
}

#[test]
fn only_what_changed_is_found() {
    let old = punctual();
    assert_eq!(Change::between(&old, &old.clone()), []);
    let found = |change: fn(&mut Scene)| {
        let mut new = old.clone();
        change(&mut new);
        Change::between(&old, &new)
    };
    assert_eq!(found(|s| move_point(s, POINT)), [Change::Light(POINT)]);
    assert_eq!(found(|s| set_shape(s, COATED, "ggx", &[("alpha", 0.15)])), [Change::Material(COATED)]);
    assert_eq!(found(|s| turn(s, METAL, DMat4::from_rotation_z(0.7))), [Change::Object(METAL)]);
    assert_eq!(found(|s| s.objects[PHONG].material = GROUND), [Change::Geometry]);
    assert_eq!(found(|s| s.render.white = White::Scene), [Change::Colors]);
    assert_eq!(found(|s| s.render.shadows = !s.render.shadows), [Change::Shadows]);
    assert_eq!(found(|s| s.image.width += 1), [Change::Camera]);
    assert_eq!(found(|s| s.render.ev = 1.0), [], "that is not prepared");
    assert_eq!(found(|s| drop(s.lights.pop())), [Change::All]);
}
