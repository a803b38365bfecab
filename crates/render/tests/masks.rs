//! Masks of lobes, roughness by pictures of their own, occlusion, and textures by a second set of coordinates: every pixel
//! is what a material of numbers gives.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::{add, empty, light, picture, pixel_camera, rectangle, transparent};
use glam::{DMat4, DVec3, Vec2};
use glanz_bsdf::{LayerWeight, Shape};
use glanz_color::Rgb;
use glanz_render::prepare::{PrepareOptions, prepare};
use glanz_scene::{
    Attenuation, ChannelUse, Light, LightColors, LightKind, Lobe, Mask, Material, Metalness, RoughnessMap,
    Scene, Shading, Texture, TextureChannel, TextureFilter, TextureUse,
};

const SIZE: u32 = 32;
/// Codes are fractions in `f32`, and factors multiplied in another order.
const ROUNDING: f32 = 2e-5;

/// Four columns of texels with numbers of their own in each channel.
const TEXELS: [[u8; 4]; 4] = [[0, 255, 51, 102], [51, 204, 0, 153], [153, 51, 255, 0], [255, 0, 102, 255]];

fn columns() -> Texture {
    let rgba: Vec<u8> = TEXELS.into_iter().flatten().collect();
    let rgba = rgba.repeat(4);
    Texture { width: 4, height: 4, rgba, filter: TextureFilter::Nearest, ..Texture::default() }
}

/// The value of a channel in a column of pixels.
fn said(channel: TextureChannel, x: u32) -> f64 {
    f64::from(TEXELS[(x / (SIZE / 4)) as usize][channel as usize]) / 255.0
}

fn channel(channel: TextureChannel) -> ChannelUse {
    ChannelUse { map: TextureUse::plain(0), channel }
}

fn lobe(shape: &str, params: &[(&str, f64)], tint: [f32; 3]) -> Lobe {
    Lobe::new(Shape::named(shape, params).unwrap(), Rgb(tint))
}

/// A rectangle that fills the picture, with a lamp before it, one behind, ambient light and grey surroundings.
fn filled(material: Material) -> Scene {
    let size = SIZE as f32;
    let mut scene = empty(pixel_camera(SIZE, SIZE));
    add(&mut scene, rectangle([0.0, 0.0, size, size], 0.0), material, DMat4::IDENTITY);
    scene.textures.push(columns());
    scene.lights.push(light(LightKind::Ambient, Rgb::gray(0.3)));
    let position = DVec3::new(12.0, 9.0, 30.0);
    // Without ambient light of its own.
    let lamp = LightKind::Point { position, attenuation: Attenuation::NONE };
    scene.lights.push(Light::new(lamp, LightColors::direct(Rgb::gray(1.0))));
    scene
        .lights
        .push(light(LightKind::Environment { map: None, rotation: glam::DMat3::IDENTITY }, Rgb::gray(0.5)));
    scene
}

/// Compares a material with what a material of numbers gives for each column.
fn compare(material: Material, at: impl Fn(u32) -> Material) {
    let drawn = picture(&filled(material), SIZE, SIZE, &transparent());
    for column in 0..4 {
        let x = column * (SIZE / 4) + 3;
        let expected = picture(&filled(at(x)), SIZE, SIZE, &transparent());
        for y in [1, 9, 22] {
            let (found, plain) = (drawn.pixel(x as usize, y), expected.pixel(x as usize, y));
            for c in 0..3 {
                let off = (found[c] - plain[c]).abs();
                assert!(
                    off <= ROUNDING * plain[c].abs().max(0.1),
                    "column {column}: {found:?} for {plain:?}"
                );
            }
        }
    }
}

fn matte() -> Lobe {
    lobe("lambert", &[], [0.5, 0.4, 0.3]).textured()
}

fn gloss(alpha: f64) -> Lobe {
    lobe("ggx", &[("alpha", alpha)], [0.9, 0.8, 0.7])
}

#[test]
fn a_mask_says_how_much_of_a_lobe_there_is() {
    let masks = [
        Mask::of(channel(TextureChannel::Red)),
        Mask { from: 1.0, to: 0.25, ..Mask::of(channel(TextureChannel::Alpha)) },
    ];
    let masked = gloss(0.3).masked(masks[0]).masked(masks[1]);
    let material = Material::of_lobes("masked", vec![matte(), masked, gloss(0.5).masked(masks[1])]);
    compare(material, |x| {
        let [red, alpha] = masks.map(|mask| mask.at(said(mask.of.channel, x)));
        let weighed = |lobe: Lobe, weight: f64| lobe.under(LayerWeight::Constant(weight));
        Material::of_lobes(
            "plain",
            vec![matte(), weighed(gloss(0.3), red * alpha), weighed(gloss(0.5), alpha)],
        )
    });
}

/// Punctual light alone is exact for roughness by pictures: surroundings take the lobe as it is without them.
#[test]
fn a_lobe_is_as_rough_as_its_own_picture_says() {
    let lamp_alone = |material: Material| {
        let mut scene = filled(material);
        scene.lights.truncate(2);
        scene
    };
    let own = Lobe { roughness: RoughnessMap::Own(channel(TextureChannel::Green)), ..gloss(0.8) };
    let uniform = Lobe { roughness: RoughnessMap::Uniform, ..gloss(0.6) };
    let mut material = Material::of_lobes("rough", vec![gloss(0.9), own, uniform]);
    material.metal_rough_map = Some(TextureUse::plain(0));
    let drawn = picture(&lamp_alone(material), SIZE, SIZE, &transparent());
    for column in 0..4 {
        let x = column * (SIZE / 4) + 3;
        let green = said(TextureChannel::Green, x);
        let width = |alpha: f64| (alpha * green * green).max(glanz_bsdf::models::ggx::LEAST_ALPHA);
        if green == 0.0 {
            // Narrower than a shape can be by itself.
            continue;
        }
        let plain = Material::of_lobes("plain", vec![gloss(width(0.9)), gloss(width(0.8)), gloss(0.6)]);
        let expected = picture(&lamp_alone(plain), SIZE, SIZE, &transparent());
        for y in [1, 9, 22] {
            let (found, plain) = (drawn.pixel(x as usize, y), expected.pixel(x as usize, y));
            for c in 0..3 {
                let off = (found[c] - plain[c]).abs();
                assert!(off <= 1e-3 * plain[c].max(0.01), "column {column}: {found:?} for {plain:?}");
            }
        }
    }
}

#[test]
fn occlusion_leaves_lamps_alone() {
    let mask = Mask { from: 0.5, to: 1.0, ..Mask::of(channel(TextureChannel::Blue)) };
    let lobes = || vec![lobe("ambient", &[], [0.5, 0.4, 0.3]).textured(), matte(), gloss(0.4)];
    let mut material = Material::of_lobes("occluded", lobes());
    material.occlusion = Some(mask);
    let drawn = picture(&filled(material), SIZE, SIZE, &transparent());
    let only = |kept: std::ops::Range<usize>| {
        let mut scene = filled(Material::of_lobes("plain", lobes()));
        scene.lights = scene.lights[kept].to_vec();
        picture(&scene, SIZE, SIZE, &transparent())
    };
    let (ambient, lamp, around) = (only(0..1), only(1..2), only(2..3));
    for column in 0..4 {
        let x = column * (SIZE / 4) + 3;
        let arrives = mask.at(said(TextureChannel::Blue, x)) as f32;
        for y in [1, 9, 22] {
            let at = |frame: &glanz_picture::Frame| frame.pixel(x as usize, y);
            for c in 0..3 {
                let expected = at(&lamp)[c] + arrives * (at(&ambient)[c] + at(&around)[c]);
                let found = at(&drawn)[c];
                assert!((found - expected).abs() <= ROUNDING, "column {column}: {found} for {expected}");
            }
        }
    }
}

#[test]
fn textures_lie_by_the_second_set_where_they_ask_for_it() {
    let mut upright = Material::of_lobes("first", vec![matte()]);
    upright.base_color = Some(TextureUse { second_uvs: true, ..TextureUse::plain(0) });
    let mut scene = filled(upright.clone());
    scene.meshes[0].uvs2 = scene.meshes[0].uvs.iter().map(|uv| Vec2::new(uv.y, uv.x)).collect();
    let turned = picture(&scene, SIZE, SIZE, &transparent());
    upright.base_color = Some(TextureUse::plain(0));
    let mut swapped = filled(upright);
    swapped.meshes[0].uvs = scene.meshes[0].uvs2.clone();
    assert_eq!(turned.rgb, picture(&swapped, SIZE, SIZE, &transparent()).rgb);
    // Without a second set the first holds.
    let (columns, second) = (filled(swapped.materials[0].clone()), scene.meshes[0].uvs2.clone());
    scene.meshes[0].uvs2.clear();
    let without = picture(&scene, SIZE, SIZE, &transparent());
    assert_eq!(without.rgb, picture(&columns, SIZE, SIZE, &transparent()).rgb);
    assert!(!second.is_empty() && without.rgb != turned.rgb);
}

#[test]
fn more_channels_than_a_material_can_have_are_refused() {
    let many = |count: usize| {
        let masks = (0..count).map(|i| {
            let map =
                TextureUse { transform: [[1.0, 0.0, i as f32], [0.0, 1.0, 0.0]], ..TextureUse::plain(0) };
            gloss(0.3).masked(Mask::of(ChannelUse { map, channel: TextureChannel::Red }))
        });
        prepare(&filled(Material::of_lobes("many", masks.collect())), &PrepareOptions::default())
    };
    assert!(many(16).is_ok());
    let error = many(17).unwrap_err().to_string();
    assert!(error.contains("17 channels of pictures, more than 16"), "{error}");
    let lobes = vec![
        gloss(0.3).masked(Mask::of(ChannelUse { map: TextureUse::plain(7), channel: TextureChannel::Red })),
    ];
    let missing = prepare(&filled(Material::of_lobes("missing", lobes)), &PrepareOptions::default());
    assert!(missing.unwrap_err().to_string().contains("names a texture that is not there"));
}

/// The same four texels everywhere: their mean is what vertices and facets see, and environments of roughness.
#[test]
fn vertices_facets_and_environments_see_the_mean() {
    let texel = [102, 153, 51, 204];
    let uniform = Texture { width: 1, height: 1, rgba: texel.to_vec(), ..Texture::default() };
    let [red, green, blue, _] = texel.map(|code| f64::from(code) / 255.0);
    let part = |lobe: Lobe, metalness| Lobe { metalness, ..lobe };
    let own =
        |lobe: Lobe, width: f64| Lobe { shape: Shape::named("ggx", &[("alpha", width)]).unwrap(), ..lobe };
    let mut textured = Material::of_lobes(
        "textured",
        vec![
            part(lobe("ambient", &[], [0.5, 0.4, 0.3]), Metalness::Dielectric { factor: 0.75 }),
            part(matte(), Metalness::Dielectric { factor: 0.75 }),
            part(gloss(0.5), Metalness::Metal { factor: 0.75 })
                .masked(Mask::of(channel(TextureChannel::Red))),
        ],
    );
    textured.metal_rough_map = Some(TextureUse::plain(0));
    let weigh = |mut lobe: Lobe, weight: f64| {
        lobe.metalness = Metalness::Any;
        lobe.masks.clear();
        lobe.under(LayerWeight::Constant(weight))
    };
    let metal = 0.75 * blue;
    let ambient = lobe("ambient", &[], [0.5, 0.4, 0.3].map(|tint: f32| tint * (1.0 - metal) as f32));
    let plain = Material::of_lobes(
        "plain",
        vec![ambient, weigh(matte(), 1.0 - metal), weigh(own(gloss(0.5), 0.5 * green * green), metal * red)],
    );
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let drawn = |material: &Material| {
            let mut scene = filled(material.clone());
            scene.textures[0] = uniform.clone();
            common::render_as(&mut scene, shading, glanz_scene::Interpolation::Perspective);
            picture(&scene, SIZE, SIZE, &transparent())
        };
        let (found, expected) = (drawn(&textured).pixel(9, 9), drawn(&plain).pixel(9, 9));
        for c in 0..3 {
            let off = (found[c] - expected[c]).abs();
            assert!(off <= 1e-4 * expected[c], "{shading:?}: {found:?} for {expected:?}");
        }
    }
}
