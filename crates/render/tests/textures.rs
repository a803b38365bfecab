//! Textures, vertex colours and alpha.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::{add, ambient_only, camera, empty, light, picture, pixel_camera, rectangle, render_as, shiny};
use common::{sampled, transparent};
use glam::{DMat4, DQuat, DVec3, Vec4};
use glanz_color::Rgb;
use glanz_render::{DrawOptions, Frame};
use glanz_scene::{
    AlphaMode, Background, Camera, Interpolation, LightKind, Material, Mesh, Scene, Shading, Texture,
    TextureFilter, TextureUse, Wrap,
};

const SHADINGS: [Shading; 3] = [Shading::Flat, Shading::Gouraud, Shading::Phong];
/// Linear values of 8-bit codes are kept in `f32`; products of few of them.
const ROUNDING: f32 = 2e-6;

/// The sRGB curve of IEC 61966-2-1, from a code.
fn decoded(code: u8) -> f32 {
    let x = f64::from(code) / 255.0;
    (if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }) as f32
}

fn texture(width: u32, texel: impl Fn(u32, u32) -> [u8; 4]) -> Texture {
    let texels = (0..width * width).flat_map(|i| texel(i % width, i / width));
    Texture { width, height: width, rgba: texels.collect(), srgb: true, ..Texture::default() }
}

fn textured(mut material: Material) -> Material {
    material.base_color = Some(TextureUse::plain(0));
    material
}

/// A textured rectangle that fills a picture of `size` pixels, in ambient light of 1.
fn filled(size: u32, texture: Texture, material: Material) -> Scene {
    let mut scene = empty(pixel_camera(size, size));
    add(&mut scene, rectangle([0.0, 0.0, size as f32, size as f32], 0.0), material, DMat4::IDENTITY);
    scene.textures.push(texture);
    scene.lights.push(light(LightKind::Ambient, Rgb::gray(1.0)));
    scene
}

fn assert_near(found: [f32; 4], expected: [f32; 3], within: f32, what: &str) {
    for c in 0..3 {
        assert!((found[c] - expected[c]).abs() <= within, "{what}: {found:?} for {expected:?}");
    }
}

fn checker(x: u32, y: u32) -> [u8; 4] {
    if (x + y).is_multiple_of(2) { [230, 120, 10, 255] } else { [20, 60, 200, 255] }
}

#[test]
fn the_nearest_texel_shows_its_decoded_colour_upright() {
    let code = |x: u32, y: u32| [(16 * x) as u8, (30 * y) as u8, (7 * x + 5 * y) as u8, 255];
    let nearest = Texture { filter: TextureFilter::Nearest, ..texture(8, code) };
    for shading in SHADINGS {
        let mut scene = filled(32, nearest.clone(), textured(ambient_only(Rgb([1.0, 0.5, 0.25]))));
        render_as(&mut scene, shading, Interpolation::Perspective);
        let frame = picture(&scene, 32, 32, &transparent());
        for y in 0..32 {
            for x in 0..32 {
                let [r, g, b, _] = code(x / 4, y / 4);
                let expected = [decoded(r), 0.5 * decoded(g), 0.25 * decoded(b)];
                let what = format!("{shading:?}, pixel {x}, {y}");
                assert_near(frame.pixel(x as usize, y as usize), expected, ROUNDING, &what);
            }
        }
    }
}

#[test]
fn textures_of_plain_numbers_are_not_decoded() {
    let plain = Texture { srgb: false, ..texture(1, |_, _| [51, 102, 204, 255]) };
    let frame = picture(&filled(4, plain, textured(ambient_only(Rgb::gray(1.0)))), 4, 4, &transparent());
    assert_near(frame.pixel(1, 1), [0.2, 0.4, 0.8], ROUNDING, "fifths");
}

#[test]
fn a_magnified_texture_runs_linearly_in_light_between_texel_centres() {
    // Two columns, 8 pixels each: from the first centre (4) to the second (12).
    let scene = filled(
        16,
        Texture {
            wrap: [Wrap::Clamp; 2],
            ..texture(2, |x, _| [[0, 0, 0, 255], [255, 188, 99, 255]][x as usize])
        },
        textured(ambient_only(Rgb::gray(1.0))),
    );
    let frame = picture(&scene, 16, 16, &transparent());
    for x in 0..16 {
        let t = ((x as f32 + 0.5 - 4.0) / 8.0).clamp(0.0, 1.0);
        let expected = [t, t * decoded(188), t * decoded(99)];
        assert_near(frame.pixel(x, 5), expected, ROUNDING, &format!("column {x}"));
    }
}

#[test]
fn a_shrunk_checkerboard_is_the_mean_of_its_light_up_to_the_borders() {
    // 256 texels on 16 pixels: level 4, in which every texel is the mean. One code of sRGB at this
    // brightness is 0.008, and each level is rounded to codes.
    let [a, b] = [checker(0, 0), checker(1, 0)];
    let mean: [f32; 3] = core::array::from_fn(|c| 0.5 * (decoded(a[c]) + decoded(b[c])));
    for size in [16, 24] {
        let scene = filled(size, texture(256, checker), textured(ambient_only(Rgb::gray(1.0))));
        let frame = picture(&scene, size, size, &transparent());
        for i in 0..(size * size) as usize {
            let (x, y) = (i % size as usize, i / size as usize);
            assert_near(frame.pixel(x, y), mean, 0.008, &format!("{size} pixels, pixel {x}, {y}"));
        }
    }
}

#[test]
fn mip_levels_do_not_change_at_the_borders_of_triangles() {
    // Stripes along v of 8 texels, 16 of which fall on a pixel: level 4 is grey. With half of that
    // footprint, as when it is cut at a triangle's border, level 3 shows black at the pixels' centres.
    let stripes = texture(256, |_, y| if y / 8 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] });
    let mut scene = filled(16, stripes, textured(ambient_only(Rgb::gray(1.0))));
    let uvs = scene.meshes[0].uvs.iter_mut();
    uvs.for_each(|uv| *uv = glam::Vec2::new(uv.x * 0.01, uv.y + 4.0 / 256.0));
    for samples in [1, 4] {
        let frame = picture(&scene, 16, 16, &sampled(samples));
        for i in 0..256 {
            let found = frame.pixel(i % 16, i / 16);
            assert_near(found, [0.5; 3], 0.01, &format!("{samples} samples, pixel {}, {}", i % 16, i / 16));
        }
    }
}

#[test]
fn wraps_repeat_mirror_and_clamp() {
    let code = |x: u32| (60 + 40 * x) as u8;
    let expected = [
        (Wrap::Repeat, [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]),
        (Wrap::Mirror, [3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0]),
        (Wrap::Clamp, [0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3]),
    ];
    for (wrap, columns) in expected {
        let picture_of = texture(4, |x, _| [code(x), 0, 0, 255]);
        let nearest = Texture { wrap: [wrap; 2], filter: TextureFilter::Nearest, ..picture_of };
        let mut scene = filled(12, nearest, textured(ambient_only(Rgb::gray(1.0))));
        scene.meshes[0].uvs.iter_mut().for_each(|uv| uv.x = uv.x * 3.0 - 1.0);
        let frame = picture(&scene, 12, 12, &transparent());
        let found: Vec<f32> = (0..12).map(|x| frame.pixel(x, 3)[0]).collect();
        for (x, column) in columns.into_iter().enumerate() {
            assert!((found[x] - decoded(code(column))).abs() < ROUNDING, "{wrap:?}: {found:?}");
        }
    }
}

#[test]
fn the_transform_of_a_texture_moves_its_coordinates() {
    let nearest = Texture {
        filter: TextureFilter::Nearest,
        ..texture(4, |x, y| [(60 * x) as u8, (60 * y) as u8, 0, 255])
    };
    let mut material = textured(ambient_only(Rgb::gray(1.0)));
    // u' = v, v' = u + 1/4: turned, and moved by a texel.
    let transform = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.25]];
    material.base_color = Some(TextureUse { transform, ..TextureUse::plain(0) });
    let frame = picture(&filled(4, nearest, material), 4, 4, &transparent());
    for i in 0..16u32 {
        let (x, y) = (i % 4, i / 4);
        let expected = [decoded((60 * y) as u8), decoded((60 * ((x + 1) % 4)) as u8), 0.0];
        assert_near(frame.pixel(x as usize, y as usize), expected, ROUNDING, &format!("pixel {x}, {y}"));
    }
}

/// A lit square in perspective with everything but textures.
fn lit_square(shading: Shading, material: Material) -> Scene {
    let mut scene = empty(camera(3.0, 45.0));
    let turn = DMat4::from_quat(DQuat::from_rotation_y(0.5) * DQuat::from_rotation_x(-0.3));
    add(&mut scene, rectangle([-1.0, -1.0, 1.0, 1.0], 0.0), material, turn);
    scene
        .lights
        .push(light(LightKind::Directional { direction: DVec3::new(-0.5, -0.4, -1.0) }, Rgb::gray(0.5)));
    scene.lights.push(light(LightKind::Ambient, Rgb([0.3, 0.2, 0.1])));
    render_as(&mut scene, shading, Interpolation::Perspective);
    scene
}

fn draw(scene: &Scene) -> Frame {
    picture(scene, 30, 30, &transparent())
}

/// Ambient, diffuse, specular and emitted light of the square, as separate pictures.
fn without_textured_lobes(mut material: Material) -> Material {
    material.lobes.retain(|lobe| !lobe.textured);
    material
}

#[test]
fn textures_and_vertex_colours_multiply_the_textured_lobes_and_no_other() {
    let factor = [decoded(200), decoded(90), decoded(150)];
    let color = Vec4::new(0.5, 0.75, 0.25, 1.0);
    for shading in SHADINGS {
        let material = shiny("phong", 8.0);
        let whole = draw(&lit_square(shading, material.clone()));
        let plain = draw(&lit_square(shading, without_textured_lobes(material.clone())));
        let mut with_texture = lit_square(shading, textured(material.clone()));
        with_texture.textures.push(texture(1, |_, _| [200, 90, 150, 255]));
        let mut with_color = lit_square(shading, material.clone());
        with_color.meshes[0].colors = vec![color; 4];
        let mut with_both = with_texture.clone();
        with_both.meshes[0].colors = vec![color; 4];
        let color = color.to_array();
        let cases = [
            ("texture", with_texture, factor),
            ("vertex colours", with_color, [color[0], color[1], color[2]]),
            ("both", with_both, core::array::from_fn(|c| factor[c] * color[c])),
        ];
        for (what, scene, factor) in cases {
            let found = draw(&scene);
            for i in (0..900).filter(|i| whole.alpha[*i] == 1.0) {
                let expected = core::array::from_fn(|c| {
                    plain.rgb[c][i] + (whole.rgb[c][i] - plain.rgb[c][i]) * factor[c]
                });
                assert_near(found.pixel(i % 30, i / 30), expected, ROUNDING, &format!("{what}, {shading:?}"));
            }
        }
        assert!(whole.alpha.iter().filter(|a| **a == 1.0).count() > 300);
    }
}

#[test]
fn vertex_colours_run_linearly_over_the_surface() {
    let mut scene = filled(10, texture(1, |_, _| [255; 4]), ambient_only(Rgb::gray(1.0)));
    let (left, right) = (Vec4::new(0.0, 1.0, 0.5, 1.0), Vec4::new(1.0, 0.25, 0.5, 1.0));
    scene.meshes[0].colors = vec![left, left, right, right];
    for shading in [Shading::Gouraud, Shading::Phong] {
        render_as(&mut scene, shading, Interpolation::Perspective);
        let frame = picture(&scene, 10, 10, &transparent());
        for x in 0..10 {
            let expected = left.lerp(right, (x as f32 + 0.5) / 10.0).truncate().to_array();
            assert_near(frame.pixel(x, 4), expected, ROUNDING, &format!("{shading:?}, column {x}"));
        }
    }
    render_as(&mut scene, Shading::Flat, Interpolation::Perspective);
    let frame = picture(&scene, 10, 10, &transparent());
    assert_near(frame.pixel(0, 0), left.lerp(right, 0.5).truncate().to_array(), ROUNDING, "flat: the mean");
}

#[test]
fn a_mask_keeps_what_is_opaque_enough() {
    let alphas = [0u8, 127, 128, 255];
    let nearest = |x: u32, _| [255, 255, 255, alphas[x as usize]];
    for (cutoff, alpha, kept) in
        [(0.5, 1.0, [0, 0, 1, 1]), (0.2, 1.0, [0, 1, 1, 1]), (0.5, 0.9, [0, 0, 0, 1])]
    {
        let mut material = textured(ambient_only(Rgb([0.5, 0.25, 1.0])));
        material.alpha_mode = AlphaMode::Mask { cutoff };
        material.opacity = alpha;
        let holes = Texture { filter: TextureFilter::Nearest, ..texture(4, nearest) };
        for samples in [1, 4] {
            let frame = picture(&filled(8, holes.clone(), material.clone()), 8, 8, &sampled(samples));
            for i in 0..64 {
                let there = kept[i % 8 / 2] as f32;
                let expected = [0.5 * there, 0.25 * there, there, there];
                assert_eq!(frame.pixel(i % 8, i / 8), expected, "cutoff {cutoff}, column {}", i % 8);
            }
        }
    }
}

#[test]
fn what_a_mask_leaves_out_hides_nothing() {
    let mut material = textured(ambient_only(Rgb::gray(0.5)));
    material.alpha_mode = AlphaMode::Mask { cutoff: 0.5 };
    let holes = texture(4, |x, _| [255, 255, 255, if x < 2 { 0 } else { 255 }]);
    let mut scene = filled(8, Texture { filter: TextureFilter::Nearest, ..holes }, material);
    add(&mut scene, rectangle([0.0, 0.0, 8.0, 8.0], -1.0), ambient_only(Rgb::gray(0.25)), DMat4::IDENTITY);
    let frame = picture(&scene, 8, 8, &transparent());
    assert!((0..64).all(|i| frame.rgb[0][i] == if i % 8 < 4 { 0.25 } else { 0.5 }));
}

#[test]
fn panes_are_laid_over_each_other_from_the_farthest_to_the_nearest() {
    let pane = |gray: f32, alpha: f32| {
        let mut material = ambient_only(Rgb::gray(gray));
        (material.opacity, material.alpha_mode) = (alpha, AlphaMode::Blend);
        material
    };
    let panes = [(0.0f32, 0.25, 0.5), (1.0, 1.0, 0.25), (2.0, 0.5, 0.75)];
    let background = 0.125f32;
    let expected =
        panes.iter().fold(background, |below, (_, gray, alpha)| gray * alpha + below * (1.0 - alpha));
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let mut scene = empty(pixel_camera(8, 8));
        scene.lights.push(light(LightKind::Ambient, Rgb::gray(1.0)));
        for i in order {
            let (z, gray, alpha) = panes[i];
            add(&mut scene, rectangle([0.0, 0.0, 8.0, 8.0], z), pane(gray, alpha), DMat4::IDENTITY);
        }
        let options = DrawOptions::new(Background::Color(Rgb::gray(background)));
        let frame = picture(&scene, 8, 8, &options);
        assert!(frame.rgb[0].iter().all(|v| (v - expected).abs() < 1e-6), "{order:?}: {}", frame.rgb[0][9]);
        assert!(frame.alpha.iter().all(|a| *a == 1.0));
        let clear = picture(&scene, 8, 8, &transparent());
        let alpha = 1.0 - 0.5 * 0.75 * 0.25;
        assert!(clear.alpha.iter().all(|a| (a - alpha).abs() < 1e-6));
    }
}

#[test]
fn vertex_alpha_and_texture_alpha_multiply_the_materials() {
    let mut material = textured(ambient_only(Rgb::gray(1.0)));
    (material.opacity, material.alpha_mode) = (0.5, AlphaMode::Blend);
    let mut scene = filled(4, texture(1, |_, _| [255, 255, 255, 51]), material);
    scene.meshes[0].colors = vec![Vec4::new(1.0, 1.0, 1.0, 0.5); 4];
    for shading in SHADINGS {
        render_as(&mut scene, shading, Interpolation::Perspective);
        let frame = picture(&scene, 4, 4, &transparent());
        assert!((frame.pixel(1, 1)[3] - 0.05).abs() < ROUNDING, "{shading:?}: {:?}", frame.pixel(1, 1));
    }
}

/// A lit sphere-like mesh with a normal map.
fn bumpy(texel: [u8; 4], scale: f32) -> Scene {
    let mut material = shiny("phong", 8.0);
    material.normal_map = Some(TextureUse { scale, ..TextureUse::plain(0) });
    let mut scene = lit_square(Shading::Phong, material);
    scene.textures.push(Texture { srgb: false, ..texture(1, |_, _| texel) });
    scene
}

#[test]
fn a_normal_map_that_points_straight_up_changes_next_to_nothing() {
    let flat = draw(&lit_square(Shading::Phong, shiny("phong", 8.0)));
    // 128 is the code nearest to 1/2; the normal leans by 1/255, without it by nothing.
    let near = draw(&bumpy([128, 128, 255, 255], 1.0));
    let straight = draw(&bumpy([128, 128, 255, 255], 0.0));
    for i in 0..900 {
        let (x, y) = (i % 30, i / 30);
        let [r, g, b, _] = flat.pixel(x, y);
        assert_near(near.pixel(x, y), [r, g, b], 0.02, "nearly straight");
        assert_near(straight.pixel(x, y), [r, g, b], 1e-5, "straight");
    }
}

#[test]
fn a_normal_map_leans_the_normal_along_the_textures_axes() {
    // Along +u is +x of the rectangle, y upwards in the map is +y: the same as other vertex normals.
    let lean = |x: f64, y: f64| DVec3::new(x, y, 1.0).normalize();
    for (code, x, y) in [([255, 128, 255, 255], 1.0, 1.0 / 255.0), ([128, 0, 255, 255], 1.0 / 255.0, -1.0)] {
        let mapped = draw(&bumpy(code, 1.0));
        let mut scene = lit_square(Shading::Phong, shiny("phong", 8.0));
        let Mesh { normals, .. } = &mut scene.meshes[0];
        normals.iter_mut().for_each(|n| *n = lean(x, y).as_vec3());
        let leaning = draw(&scene);
        for i in (0..900).filter(|i| leaning.alpha[*i] == 1.0) {
            let [r, g, b, _] = leaning.pixel(i % 30, i / 30);
            assert_near(mapped.pixel(i % 30, i / 30), [r, g, b], 1e-5, &format!("{code:?}"));
        }
    }
}

#[test]
fn textures_are_right_under_perspective() {
    // A floor that recedes: the column in the middle keeps its u, rows follow 1/distance.
    let mut scene = empty(Camera {
        eye: DVec3::new(0.0, 1.0, 0.0),
        target: DVec3::new(0.0, 0.0, -2.0),
        ..camera(1.0, 40.0)
    });
    let mut floor = rectangle([-4.0, 0.0, 4.0, 16.0], 0.0);
    floor.normals.clear();
    let down = DMat4::from_rotation_x(-core::f64::consts::FRAC_PI_2);
    add(&mut scene, floor, textured(ambient_only(Rgb::gray(1.0))), down);
    scene.lights.push(light(LightKind::Ambient, Rgb::gray(1.0)));
    let stripes = texture(16, |_, y| [(y * 16) as u8, 0, 0, 255]);
    scene.textures.push(Texture { filter: TextureFilter::Nearest, ..stripes });
    let frame = picture(&scene, 41, 41, &transparent());
    let camera = scene.camera.unwrap();
    let [_, up, back] = camera.axes();
    let mut seen = 0;
    for y in 0..41 {
        let lift = (20.5 - (f64::from(y) + 0.5)) / 20.5 * 20f64.to_radians().tan();
        let ray = up * lift - back;
        let depth = ray.z * (1.0 / ray.y);
        let row = 16.0 - depth;
        if ray.y >= 0.0 || !(0.01..15.99).contains(&row) || (row - row.round()).abs() < 0.01 {
            continue;
        }
        seen += 1;
        let expected = decoded((row.floor() as u32 * 16) as u8);
        assert_near(frame.pixel(20, y as usize), [expected, 0.0, 0.0], ROUNDING, &format!("row {y}"));
    }
    assert!(seen > 20, "{seen} rows");
}

#[test]
fn a_texture_that_its_transform_repeats_is_shrunk_as_often() {
    // 16 texels repeated 16 times on 16 pixels: each pixel shows the mean.
    let mut material = textured(ambient_only(Rgb::gray(1.0)));
    let transform = [[16.0, 0.0, 0.0], [0.0, 16.0, 0.0]];
    material.base_color = Some(TextureUse { transform, ..TextureUse::plain(0) });
    let [a, b] = [checker(0, 0), checker(1, 0)];
    let mean: [f32; 3] = core::array::from_fn(|c| 0.5 * (decoded(a[c]) + decoded(b[c])));
    let frame = picture(&filled(20, texture(16, checker), material), 20, 20, &transparent());
    for i in 0..400 {
        assert_near(frame.pixel(i % 20, i / 20), mean, 0.008, &format!("pixel {}, {}", i % 20, i / 20));
    }
}
