//! Cube maps of programs: six faces, a panorama, or the scene's environment light.

use std::sync::Arc;

use glanz_color::Rgb;
use glanz_picture::output::PictureKind;
use glanz_render::{PrepareError, PrepareOptions, Shot, prepare};
use glanz_scene::glam::{DMat3, DVec3};
use glanz_scene::{
    Background, Camera, EnvironmentMap, Light, LightColors, LightKind, Material, Mesh, Program, ProgramText,
    Projection, Scene, Texture, UniformValue,
};

/// A square that fills the picture, drawn by a look in the direction of a uniform.
fn scene(sampler: &str, uniforms: &[(&str, UniformValue)]) -> Scene {
    let text = format!(
        "#version 330\nuniform samplerCube {sampler}; uniform vec3 d; uniform float level;\nout vec4 c;\n\
         void main() {{ c = textureLod({sampler}, d, level) + 0.0 * texture({sampler}, d + dFdx(gl_FragCoord.xyz)); }}"
    );
    let mut scene =
        Scene::new().with_mesh(Mesh::builtin("quad").expect("it is listed"), Material::default_gray());
    let mut camera = Camera::new([0.0, 0.0, 3.0], [0.0; 3]);
    camera.projection = Projection::Orthographic { height: 1.0 };
    scene.camera = Some(camera);
    (scene.image.width, scene.image.height) = (16, 16);
    scene.image.background = Background::Transparent;
    let mut program = Program::of_fragment(ProgramText::new("own.frag", text));
    program.uniforms.extend(uniforms.iter().map(|(name, value)| ((*name).to_owned(), value.clone())));
    scene.set_program(program);
    scene
}

fn numbers(values: &[f64]) -> UniformValue {
    UniformValue::Numbers(values.to_vec())
}

/// Its colour in the middle.
fn drawn(scene: &Scene) -> [f32; 3] {
    let frame = Shot::new(scene).unwrap_or_else(|error| panic!("{error}")).frame().expect("it ends");
    let [r, g, b, _] = frame.pixel(8, 8);
    [r, g, b]
}

/// A texture of linear codes by a function of column and row.
fn texture(width: u32, height: u32, code: impl Fn(u32, u32) -> [u8; 3]) -> Texture {
    let codes = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let rgba = codes.flat_map(|(x, y)| {
        let [r, g, b] = code(x, y);
        [r, g, b, 255]
    });
    Texture { width, height, rgba: rgba.collect(), srgb: false, ..Texture::default() }
}

/// An environment, turned by 1 radian.
fn light(map: Option<EnvironmentMap>, color: [f32; 3]) -> Light {
    let kind = LightKind::Environment { map: map.map(Arc::new), rotation: DMat3::from_rotation_y(1.0) };
    Light::new(kind, LightColors::direct(Rgb(color)))
}

#[test]
fn faces_are_those_of_opengl_upright_from_inside() {
    let mut scene = scene("anything", &[("anything", UniformValue::Cube([0, 1, 2, 3, 4, 5]))]);
    // Red numbers the face, green grows to the right and blue downwards.
    scene.textures =
        (0..6).map(|face| texture(8, 8, |x, y| [40 * face as u8, 30 * x as u8, 30 * y as u8])).collect();
    for (direction, face, [right, down]) in [
        ([1.0, 0.5, -0.25], 0, [0.625, 0.25]),
        ([-1.0, 0.5, -0.25], 1, [0.375, 0.25]),
        ([0.25, 2.0, 1.0], 2, [0.5625, 0.75]),
        ([0.25, -2.0, 1.0], 3, [0.5625, 0.25]),
        ([0.25, 0.5, 1.0], 4, [0.625, 0.25]),
        ([0.25, 0.5, -1.0], 5, [0.375, 0.25]),
    ] {
        scene.programs[0].uniforms.insert("d".to_owned(), numbers(&direction));
        let code = |place: f64| (30.0 * (place * 8.0 - 0.5) / 255.0) as f32;
        let expected = [40.0 * face as f32 / 255.0, code(right), code(down)];
        let got = drawn(&scene);
        assert!((0..3).all(|c| (got[c] - expected[c]).abs() < 1e-5), "{direction:?}: {got:?}, {expected:?}");
    }
}

#[test]
fn a_filter_ends_at_the_edge_of_a_face() {
    let cube = ("sky", UniformValue::Cube([0, 1, 1, 1, 1, 1]));
    let mut scene = scene("sky", &[cube, ("d", numbers(&[1.0, 0.999, 0.0]))]);
    scene.textures = vec![texture(4, 4, |_, y| [50 * y as u8 + 20, 0, 0]), texture(4, 4, |_, _| [255; 3])];
    assert!((drawn(&scene)[0] - 20.0 / 255.0).abs() < 1e-6, "not the lower edge, not another face");
    scene.programs[0].uniforms.insert("level".to_owned(), numbers(&[2.0]));
    assert!((drawn(&scene)[0] - 95.0 / 255.0).abs() < 3e-3, "the mean");
}

#[test]
fn a_panorama_is_looked_into_as_environments_are() {
    let codes = |x: u32, y: u32| [x as u8 * 4, y as u8 * 8, 100];
    let places = (0..32).flat_map(|y| (0..64).map(move |x| (x, y)));
    let pixels = places.map(|(x, y)| codes(x, y).map(|code| f32::from(code) / 255.0)).collect();
    let map = EnvironmentMap { width: 64, height: 32, pixels };
    let mut of_picture = scene("sky", &[("sky", UniformValue::Texture(0))]);
    of_picture.textures = vec![texture(64, 32, codes)];
    let mut of_light = scene("skybox", &[]);
    of_light.lights = vec![light(Some(map.clone()), [1.0, 0.5, 2.0])];
    for direction in [[0.3, 0.2, -1.0], [2.0, -1.0, 0.5], [-0.4, 0.6, 0.1], [0.01, -0.3, 1.0]] {
        let d = DVec3::from_array(direction);
        let set = |scene: &mut Scene| scene.programs[0].uniforms.insert("d".to_owned(), numbers(&direction));
        set(&mut of_picture);
        set(&mut of_light);
        let (expected, got) = (map.at(d), drawn(&of_picture));
        assert!((0..3).all(|c| (f64::from(got[c]) - expected[c]).abs() < 1e-4), "{got:?}, {expected:?}");
        let turned = map.at(DMat3::from_rotation_y(-1.0) * d);
        let expected = [turned[0], 0.5 * turned[1], 2.0 * turned[2]];
        let got = drawn(&of_light);
        assert!((0..3).all(|c| (f64::from(got[c]) - expected[c]).abs() < 1e-4), "{got:?}, {expected:?}");
    }
    // The coarsest level is about the mean.
    let level = ("level".to_owned(), numbers(&[9.0]));
    of_light.programs[0].uniforms.insert(level.0, level.1);
    assert!((f64::from(drawn(&of_light)[2]) - 2.0 * map.mean()[2]).abs() < 1e-3);
}

#[test]
fn what_cannot_be_a_cube_map_is_refused_and_what_is_not_set_is_black() {
    let error = |scene: &Scene| match prepare(scene, &PrepareOptions::default()) {
        Err(PrepareError::Program(error)) => error.to_string(),
        other => panic!("{other:?}"),
    };
    let mut wide = scene("sky", &[("sky", UniformValue::Cube([0; 6]))]);
    wide.textures = vec![texture(4, 2, |_, _| [0; 3])];
    assert!(error(&wide).contains("squares of one size: one has 4×2 texels"), "{}", error(&wide));
    let mut flat = wide.clone();
    let text = "uniform sampler2D sky; out vec4 c; void main() { c = texture(sky, vec2(0.5)); }";
    flat.programs[0].fragment = Some(ProgramText::new("own.frag", text));
    assert!(error(&flat).contains("six are the faces of a samplerCube"), "{}", error(&flat));
    let text = "uniform sampler3D sky; out vec4 c; void main() { c = texture(sky, vec3(0.5)); }";
    flat.programs[0].fragment = Some(ProgramText::new("own.frag", text));
    assert!(error(&flat).contains("only sampler2D, sampler2DShadow and samplerCube do"), "{}", error(&flat));

    let mut unset = scene("shadowMap", &[("d", numbers(&[1.0, 0.0, 0.0]))]);
    unset.lights = vec![light(None, [1.0; 3])];
    assert_eq!(drawn(&unset), [0.0; 3]);
    let mut shot = Shot::new(&unset).expect("it is right");
    let picture = shot.picture(PictureKind::Codes8, &mut |_| {}).expect("it ends");
    let remarks = shot.remarks(&unset, &picture).expect("it ends");
    let told: Vec<String> = remarks.iter().map(|remark| remark.text.clone()).collect();
    assert!(told.iter().any(|text| text.contains("the sampler 'shadowMap' a cube map")), "{told:?}");
}
