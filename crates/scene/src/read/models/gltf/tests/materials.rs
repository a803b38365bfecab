//! Materials, and the pictures that they name.

use super::*;

#[test]
fn lobes_of_metal_and_dielectric_are_weighed_by_the_texture() {
    let (mut document, binary) = rich();
    let path = "/materials/0/pbrMetallicRoughness";
    let pbr =
        json!({ "metallicRoughnessTexture": { "index": 0 }, "metallicFactor": 0.75, "roughnessFactor": 0.5 });
    change(&mut document, &[(path, pbr), ("/materials/0/extensions", json!({}))]);
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    let material = &model.materials[0];
    let fractions: Vec<_> =
        material.lobes.iter().map(|lobe| (lobe.shape.info().name, lobe.metalness)).collect();
    let (metal, rest) = (Metalness::Metal { factor: 0.75 }, Metalness::Dielectric { factor: 0.75 });
    assert_eq!(
        fractions,
        [
            ("ambient", Metalness::Dielectric { factor: 0.75 }),
            ("lambert", rest),
            ("ggx", rest),
            ("ggx", metal),
            ("ggx", metal)
        ]
    );
    let map = material.metal_rough_map.unwrap();
    assert!(!model.textures[map.texture].srgb);
    assert_eq!(material.lobes[2].shape.params()[0], 0.25);
    assert!(material.lobes[3].textured && !material.lobes[4].textured);
}

#[test]
fn light_of_its_own_is_multiplied_by_its_strength() {
    let model = read(&material(json!({ "emissiveFactor": [0, 0, 0.5], "extensions": {
        "KHR_materials_emissive_strength": { "emissiveStrength": 4 } } })));
    let lobe = model.materials[0].lobes.last().unwrap();
    assert_eq!((lobe.shape.info().name, lobe.tint.rgb()), ("emission", Some(Rgb([0.0, 0.0, 2.0]))));
    assert!(model.materials[0].cull_back && !model.materials[0].two_sided);
}

#[test]
fn numbers_out_of_range_are_cut_with_a_note() {
    let with = |name: &str, value: Value| material(json!({ "extensions": { name: value } }));
    for (name, value, expected) in [
        ("KHR_materials_ior", json!({ "ior": 0.5 }), "0 or an index from 1 on"),
        ("KHR_materials_specular", json!({ "specularColorFactor": [-1, 0, 0] }), "numbers from 0 on"),
        ("KHR_materials_clearcoat", json!({ "clearcoatFactor": -0.1 }), "numbers from 0 on"),
        ("KHR_materials_sheen", json!({ "sheenRoughnessFactor": -1 }), "numbers from 0 on"),
        ("KHR_materials_volume", json!({ "attenuationDistance": 0 }), "an attenuationDistance above 0"),
        ("KHR_materials_iridescence", json!({ "iridescenceIor": 0.9 }), "numbers from 1 on"),
    ] {
        let model = read(&with(name, value));
        let place = format!("(materials[0].extensions.{name})");
        let is_told =
            |note: &String| note.contains(&format!("expected {expected}")) && note.ends_with(&place);
        assert!(model.notes.iter().any(is_told), "{:?}", model.notes);
        let plain = read(&material(json!({})));
        let is_plain = model.materials == plain.materials;
        assert!(is_plain || name == "KHR_materials_specular", "{name}");
    }
    let bright = read(&material(json!({ "emissiveFactor": [1e300, 0, 0], "alphaMode": "GLASS" })));
    assert!(has_note(&bright, "the nearest are taken (materials[0].emissiveFactor)"), "{:?}", bright.notes);
    assert!(has_note(&bright, "the alphaMode 'GLASS' is taken as OPAQUE (materials[0].alphaMode)"));
    let dark = read(&material(
        json!({ "pbrMetallicRoughness": { "baseColorFactor": [-1, 0.5, 0, -2] }, "alphaMode": "BLEND" }),
    ));
    assert!(has_note(&dark, "base colours and alphaCutoff") && dark.materials[0].opacity == 0.0);
    let model = read(&with("KHR_materials_clearcoat", json!({ "clearcoatFactor": 7 })));
    assert_eq!(model.notes, ["glTF: factors above 1 count as 1"]);
    let full = read(&with("KHR_materials_clearcoat", json!({ "clearcoatFactor": 1 })));
    assert_eq!(model.materials, full.materials);
}

#[test]
fn textures_that_are_not_there_are_noted_once_for_each_material() {
    let coat = json!({ "clearcoatFactor": 1, "clearcoatTexture": { "index": 9 }, "clearcoatNormalTexture": { "index": 9 } });
    let one = json!({ "extensions": { "KHR_materials_clearcoat": coat } });
    let mut document = quad().0;
    let primitive = |number: usize| json!({ "attributes": { "POSITION": 0 }, "material": number });
    change(
        &mut document,
        &[
            ("/materials", json!([one, one])),
            ("/meshes/0/primitives", json!([primitive(0), primitive(1)])),
            ("/accessors/0/count", json!(3)),
        ],
    );
    let model = read_bytes(&glb(&document, &quad().1), Format::Gltf).unwrap();
    let noted = [
        "glTF: textures that are not there are left out (materials[0])",
        "glTF: clear coats have the normals of the surface below (2 times)",
    ];
    assert_eq!(model.notes, noted);
}

#[test]
fn textures_lie_by_the_set_of_coordinates_that_they_name() {
    let picture = base64(&texture::tests::png(1, 1, &[255; 4]));
    let [materials, uses] = material(json!({
        "pbrMetallicRoughness": { "baseColorTexture": { "index": 0, "texCoord": 1 } },
        "emissiveTexture": { "index": 0 }, "occlusionTexture": { "index": 0, "texCoord": 2 } }));
    let model = read(&[
        materials,
        uses,
        ("/images", json!([{ "uri": format!("data:image/png;base64,{picture}") }])),
        ("/textures", json!([{ "source": 0 }])),
        ("/meshes/0/primitives/0/attributes/TEXCOORD_0", json!(0)),
        ("/meshes/0/primitives/0/attributes/TEXCOORD_1", json!(0)),
    ]);
    let material = &model.materials[0];
    assert!(!material.base_color.unwrap().second_uvs && material.emission_map.unwrap().second_uvs);
    assert!(has_note(
        &model,
        "all sets of texture coordinates but the first of a material count as its second"
    ));
}

#[test]
fn unlit_materials_are_emission_alone() {
    let unlit = json!({ "pbrMetallicRoughness": { "baseColorFactor": [0.25, 0.5, 1, 0.5] },
        "alphaMode": "BLEND", "extensions": { "KHR_materials_unlit": {} } });
    let model = read(&material(unlit));
    assert_eq!(lobes(&model), [("emission", [0.25, 0.5, 1.0], None)]);
    assert!(model.materials[0].lobes[0].textured);
    assert_eq!((model.materials[0].opacity, model.materials[0].alpha_mode), (0.5, AlphaMode::Blend));
}

#[test]
fn textures_are_decoded_with_their_samplers() {
    for bytes in [sample_glb(), sample_json().into_bytes()] {
        let model = read_bytes(&bytes, Format::Gltf).unwrap();
        check(&model);
        let [color, normal] = &model.textures[..] else { panic!("{} textures", model.textures.len()) };
        assert_eq!(
            (color.rgba.as_slice(), color.srgb, color.name.as_str()),
            (&[255, 0, 0, 128][..], true, "red")
        );
        assert_eq!((color.wrap, color.filter), ([Wrap::Clamp, Wrap::Mirror], TextureFilter::Nearest));
        assert!(!normal.srgb);
        let material = &model.materials[0];
        assert_eq!((material.base_color.unwrap().texture, material.normal_map.unwrap().scale), (0, 0.5));
        assert_eq!(material.alpha_mode, AlphaMode::Mask { cutoff: 0.25 });
        assert!(material.two_sided && !material.cull_back);
        assert_eq!((model.cameras.len(), model.lights.len()), (1, 1));
    }
}

#[test]
fn a_texture_transform_shows_the_quadrant_that_the_extension_says() {
    // The example of the extension: "only the lower left quadrant of the source image".
    let (mut document, binary) = rich();
    let transform = json!({ "offset": [0, 1], "rotation": FRAC_PI_2, "scale": [0.5, 0.5] });
    change(
        &mut document,
        &[(
            "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions",
            json!({ "KHR_texture_transform": transform }),
        )],
    );
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    let rows = model.materials[0].base_color.unwrap().transform;
    for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
        let [x, y] = rows.map(|row| row[0] * u + row[1] * v + row[2]);
        assert!((-1e-6..=0.5 + 1e-6).contains(&x) && (0.5 - 1e-6..=1.0 + 1e-6).contains(&y), "{x} {y}");
    }
}
