//! Materials by textures against those of numbers: at a texel both must be the same.

use glanz_bsdf::{LayerWeight, Shape};
use glanz_math::{PI, Vec3};
use serde_json::{Value, json};

use super::super::super::tests::{base64, material as with_material, read};
use super::{BASE, Color, value};
use crate::read::{Model, texture};
use crate::{ChannelUse, Lobe, Material, RoughnessMap, TextureChannel};

/// A texel whose colours say fractions that codes of 8 bits have, as numbers and by the table of sRGB.
const TEXEL: [u8; 4] = [51, 102, 204, 153];

/// A material all of whose textures are one texel.
fn of_one_texel(mut material: Value) -> Model {
    let picture = format!("data:image/png;base64,{}", base64(&texture::tests::png(1, 1, &TEXEL)));
    material["doubleSided"] = json!(true);
    let [material, primitive] = with_material(material);
    let uv = ("/meshes/0/primitives/0/attributes/TEXCOORD_0", json!(1));
    read(&[
        material,
        primitive,
        uv,
        ("/images", json!([{ "uri": picture }])),
        ("/textures", json!([{ "source": 0 }])),
    ])
}

/// The number that a channel of the texel says.
fn said(of: &ChannelUse, model: &Model) -> f64 {
    let texture = &model.textures[of.map.texture];
    let number = f32::from(texture.rgba[of.channel as usize]) / 255.0;
    let is_color = texture.srgb && of.channel != TextureChannel::Alpha;
    f64::from(if is_color { glanz_color::srgb_decode(number) } else { number })
}

/// The material at its one texel: what its masks and roughness say is made a part of its lobes.
fn at_texel(model: &Model) -> Material {
    let mut material = model.materials[0].clone();
    for lobe in &mut material.lobes {
        let weight: f64 = lobe.masks.drain(..).map(|mask| mask.at(said(&mask.of, model))).product();
        lobe.layers.push(LayerWeight::Constant(weight));
        let own = match lobe.roughness {
            RoughnessMap::Own(of) => Some(said(&of, model)),
            RoughnessMap::Material => material
                .metal_rough_map
                .map(|map| said(&ChannelUse { map, channel: TextureChannel::Green }, model)),
            RoughnessMap::Uniform => None,
        };
        lobe.roughness = RoughnessMap::Uniform;
        if let Some(own) = own {
            *lobe = widened(lobe, own * own);
        }
    }
    material.metal_rough_map = None;
    material
}

/// The lobe with all its widths times a factor.
fn widened(lobe: &Lobe, factor: f64) -> Lobe {
    let info = lobe.shape.info();
    let params: Vec<(&str, f64)> = info
        .params
        .iter()
        .zip(lobe.shape.params())
        .map(|(param, value)| {
            (param.name, if param.name.starts_with("alpha") { value * factor } else { value })
        })
        .collect();
    Lobe { shape: Shape::named(info.name, &params).unwrap(), ..lobe.clone() }
}

/// Compares a material by textures with one of numbers at the texel.
fn compare_texel(by_textures: Value, by_numbers: Value, tolerance: f64) {
    let textured = at_texel(&of_one_texel(by_textures));
    let plain = at_texel(&of_one_texel(by_numbers));
    let mut lit = 0.0_f64;
    for (theta_v, theta_l, phi) in [(0.0, 0.3, 1.0), (0.5, 0.5, 3.1), (0.9, 0.2, 2.5), (1.3, 1.1, 2.9)] {
        for below in [false, true] {
            let v = Vec3::from_angles(theta_v, 0.4);
            let l = Vec3::from_angles(if below { PI - theta_l } else { theta_l }, 0.4 + phi);
            let (got, expected) = (value(&textured, v, l), value(&plain, v, l));
            for c in 0..3 {
                let off = (got[c] - expected[c]).abs();
                assert!(
                    off <= tolerance * expected[c].abs().max(1e-3),
                    "{theta_v} {theta_l} {phi} {below}: {got:?} for {expected:?}"
                );
                lit = lit.max(expected[c]);
            }
        }
    }
    assert!(lit > 0.005, "{lit}");
}

const RED: f64 = 0.2;
const GREEN: f64 = 0.4;
const ALPHA: f64 = 0.6;

/// The texel as a colour.
fn texel_color() -> Color {
    [0, 1, 2].map(|c| f64::from(glanz_color::srgb_decode(f32::from(TEXEL[c]) / 255.0)))
}

fn lit(extension: &str, body: Value) -> Value {
    json!({ "extensions": { extension: body },
        "pbrMetallicRoughness": { "baseColorFactor": [BASE[0], BASE[1], BASE[2], 1], "metallicFactor": 0,
            "roughnessFactor": 0.5 } })
}

#[test]
fn textures_of_a_clear_coat_say_where_it_is_and_how_rough() {
    let map = json!({ "index": 0 });
    let name = "KHR_materials_clearcoat";
    compare_texel(
        lit(
            name,
            json!({ "clearcoatFactor": 0.75, "clearcoatTexture": map,
            "clearcoatRoughnessFactor": 0.8, "clearcoatRoughnessTexture": map }),
        ),
        lit(name, json!({ "clearcoatFactor": 0.75 * RED, "clearcoatRoughnessFactor": 0.8 * GREEN })),
        1e-5,
    );
}

#[test]
fn textures_of_specular_reflection_say_how_much_and_of_which_colour() {
    let map = json!({ "index": 0 });
    let name = "KHR_materials_specular";
    let [r, g, b] = texel_color();
    compare_texel(
        lit(
            name,
            json!({ "specularFactor": 0.75, "specularTexture": map,
            "specularColorFactor": [0.5, 1, 0.75], "specularColorTexture": map }),
        ),
        lit(name, json!({ "specularFactor": 0.75 * ALPHA, "specularColorFactor": [0.5 * r, g, 0.75 * b] })),
        1e-3,
    );
    compare_texel(
        lit(name, json!({ "specularColorTexture": map })),
        lit(name, json!({ "specularColorFactor": [r, g, b] })),
        // The greatest channel is kept in 8 bits.
        1e-3,
    );
}

#[test]
fn textures_of_a_sheen_say_its_colour_and_roughness() {
    let map = json!({ "index": 0 });
    let name = "KHR_materials_sheen";
    let [r, g, b] = texel_color();
    compare_texel(
        lit(
            name,
            json!({ "sheenColorFactor": [0.8, 0.8, 0.8], "sheenColorTexture": map,
            "sheenRoughnessFactor": 0.7 }),
        ),
        lit(name, json!({ "sheenColorFactor": [0.8 * r, 0.8 * g, 0.8 * b], "sheenRoughnessFactor": 0.7 })),
        1e-3,
    );
    let rough = |factor: f64, texture: Value| {
        let mut body = json!({ "sheenColorFactor": [1, 1, 1], "sheenRoughnessFactor": factor });
        if !texture.is_null() {
            body["sheenRoughnessTexture"] = texture;
        }
        lit(name, body)
    };
    // By its mean.
    compare_texel(rough(0.9, map), rough(0.9 * ALPHA, Value::Null), 1e-5);
}

#[test]
fn textures_of_transmission_and_of_thin_films_say_where_they_are() {
    let map = json!({ "index": 0 });
    compare_texel(
        lit("KHR_materials_transmission", json!({ "transmissionFactor": 0.75, "transmissionTexture": map })),
        lit("KHR_materials_transmission", json!({ "transmissionFactor": 0.75 * RED })),
        1e-5,
    );
    let film = |factor: f64| json!({ "iridescenceFactor": factor, "iridescenceIor": 1.33, "iridescenceThicknessMaximum": 400 });
    let mut textured = film(0.75);
    textured["iridescenceTexture"] = map;
    let name = "KHR_materials_iridescence";
    compare_texel(lit(name, textured), lit(name, film(0.75 * RED)), 1e-5);
}

#[test]
fn textures_of_thickness_and_anisotropy_count_by_their_mean() {
    let map = json!({ "index": 0 });
    let name = "KHR_materials_anisotropy";
    let textured = json!({ "anisotropyStrength": 0.9, "anisotropyRotation": 0.25, "anisotropyTexture": map });
    let model = of_one_texel(lit(name, textured.clone()));
    let turned = libm::atan2(2.0 * GREEN - 1.0, 2.0 * RED - 1.0);
    assert!((model.materials[0].aniso - 0.25 - turned).abs() < 1e-9);
    compare_texel(lit(name, textured), lit(name, json!({ "anisotropyStrength": 0.9 * 0.8 })), 1e-5);
    let glass = |thickness: f64, texture: Value| {
        let mut material = lit("KHR_materials_transmission", json!({ "transmissionFactor": 1 }));
        material["extensions"]["KHR_materials_volume"] = json!({ "thicknessFactor": thickness,
            "attenuationDistance": 0.5, "attenuationColor": [0.2, 0.5, 0.8] });
        if !texture.is_null() {
            material["extensions"]["KHR_materials_volume"]["thicknessTexture"] = texture;
        }
        material
    };
    compare_texel(glass(1.0, map), glass(GREEN, Value::Null), 1e-5);
}

#[test]
fn a_roughness_texture_leaves_the_layers_above_alone() {
    let map = json!({ "index": 0 });
    let coat = |rough: Value, factor: f64| {
        let mut material =
            lit("KHR_materials_clearcoat", json!({ "clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.6 }));
        material["pbrMetallicRoughness"]["roughnessFactor"] = json!(factor);
        material["pbrMetallicRoughness"]["metallicFactor"] = json!(0);
        if !rough.is_null() {
            material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = rough;
        }
        material
    };
    compare_texel(coat(map, 1.0), coat(Value::Null, GREEN), 1e-5);
}

#[test]
fn occlusion_dims_by_its_strength() {
    let mut material = lit("KHR_materials_ior", json!({}));
    material["occlusionTexture"] = json!({ "index": 0, "strength": 0.75 });
    let model = of_one_texel(material);
    let mask = model.materials[0].occlusion.unwrap();
    assert!((mask.at(said(&mask.of, &model)) - (1.0 + 0.75 * (RED - 1.0))).abs() < 1e-6);
}
