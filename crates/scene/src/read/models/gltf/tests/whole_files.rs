//! Odd values, poses, instances, damaged files and variants: what takes several parts of a file.

use super::*;

#[test]
fn positions_that_are_no_numbers_take_their_triangles_along() {
    let (document, mut binary) = quad();
    binary[16..20].copy_from_slice(&f32::NAN.to_le_bytes());
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    check(&model);
    assert_eq!(model.triangle_count(), 1);
    assert!(
        has_note(&model, "faces with positions that are no finite numbers are left out"),
        "{:?}",
        model.notes
    );
    let huge = json!([1e300, 0, 0]);
    let chain = [("/nodes", json!([{ "scale": huge, "children": [1] }, { "scale": huge, "mesh": 0 }]))];
    assert!(error(&chain).contains("nodes[1]: expected a finite transform"));
}

#[test]
fn attributes_that_are_no_numbers_are_replaced_and_broken_ones_left_out() {
    let odd = floats(&[0.0, 0.0, 1.0, f32::NAN, 0.0, 0.0, 0.0, f32::INFINITY, 1.0, 0.0, 0.0, 2.0]);
    let accessor = json!({ "bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3" });
    let attribute = |name: &str| format!("/meshes/0/primitives/0/attributes/{name}");
    let model = with_bytes(&odd, &[("/accessors/3", accessor.clone()), (&attribute("NORMAL"), json!(3))]);
    assert_eq!(model.meshes[0].normals, [Vec3::Z; 4]);
    assert!(
        has_note(&model, "NORMAL is computed from the faces where it is no finite number (2 times)"),
        "{:?}",
        model.notes
    );
    let model = with_bytes(&odd, &[("/accessors/3", accessor), (&attribute("COLOR_0"), json!(3))]);
    assert_eq!(model.meshes[0].colors[1], Vec4::ONE);
    for (index, why) in
        [(99, "expected one of 3 accessors"), (1, "expected 4 items"), (2, "expected 4 items")]
    {
        let model = read(&[(&attribute("NORMAL"), json!(index)), (&attribute("TEXCOORD_0"), json!(index))]);
        assert!(model.meshes[0].normals.is_empty() && model.meshes[0].uvs.is_empty());
        assert!(
            has_note(&model, "the attribute NORMAL is left out") && has_note(&model, why),
            "{:?}",
            model.notes
        );
    }
    let model = read(&[("/meshes/0/primitives/0/material", json!(9))]);
    assert!(has_note(
        &model,
        "materials that are not there are the default one (meshes[0].primitives[0].material)"
    ));
}

#[test]
fn pictures_that_cannot_be_read_are_left_out() {
    let textured = json!([{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicRoughnessTexture": { "index": 0 } } }]);
    let read = |texture: Value, images: Value| {
        read(&[
            ("/materials", textured.clone()),
            ("/meshes/0/primitives/0/material", json!(0)),
            ("/textures", json!([texture])),
            ("/images", images),
        ])
    };
    let data = |bytes: &[u8]| json!([{ "uri": format!("data:;base64,{}", base64(bytes)) }]);
    let plain = json!({ "source": 0 });
    let cases = [
        (
            plain.clone(),
            json!([{ "uri": "none%20.png" }]),
            "the picture 'none .png' is missing: it is left out (images[0])",
        ),
        (
            plain.clone(),
            data(b"no picture at all"),
            "is not a PNG, JPEG or WebP picture, but begins with 'no pictu'",
        ),
        (plain.clone(), data(&texture::tests::png(2, 2, &[7; 16])[..50]), "cannot be decoded"),
        (plain.clone(), json!([{ "bufferView": 77 }]), "a picture is left out (file: bufferViews[77]"),
        (
            plain.clone(),
            json!([{ "uri": "http://somewhere/a.png" }]),
            "a picture is left out (file: images[0]: expected data",
        ),
        (plain.clone(), json!([{}]), "pictures without a uri or a bufferView are left out (images[0])"),
        (plain, json!([]), "pictures that are not there are left out (textures[0])"),
        (json!({}), json!([]), "a texture without a picture is left out (textures[0])"),
        (
            json!({ "extensions": { "KHR_texture_basisu": { "source": 0 } } }),
            json!([{ "uri": "a.ktx2" }]),
            "a texture in KTX2 alone (KHR_texture_basisu) is left out (textures[0])",
        ),
    ];
    for (texture, images, note) in cases {
        let model = read(texture, images);
        let material = &model.materials[0];
        assert!(
            material.base_color.is_none() && material.metal_rough_map.is_none() && model.textures.is_empty()
        );
        assert!(has_note(&model, note), "{note}: {:?}", model.notes);
    }
    let [_, _, webp] = texture::tests::samples();
    let both = json!({ "source": 1, "extensions": { "EXT_texture_webp": { "source": 0 } } });
    assert_eq!(read(both, data(&webp)).textures[0].width, 16);
}

#[test]
fn skins_are_in_the_pose_of_their_joints() {
    // Two joints, the second moved by (1.5, 1, 0); the upper two vertices follow it.
    let joints = [[0u8, 0, 0, 0], [0; 4], [1, 0, 0, 0], [1, 0, 0, 0]].concat();
    let weights = floats(&[2.0, 0.0, 0.0, 0.0].repeat(4));
    let skinned = |skin: Value| {
        with_bytes(
            &[joints.clone(), weights.clone()].concat(),
            &[
                (
                    "/accessors/3",
                    json!({ "bufferView": 3, "componentType": 5121, "count": 4, "type": "VEC4" }),
                ),
                (
                    "/accessors/4",
                    json!({ "bufferView": 3, "byteOffset": 16, "componentType": 5126, "count": 4, "type": "VEC4" }),
                ),
                (
                    "/meshes/0/primitives/0/attributes",
                    json!({ "POSITION": 0, "JOINTS_0": 3, "WEIGHTS_0": 4 }),
                ),
                ("/skins", json!([skin])),
                (
                    "/nodes",
                    json!([
                        { "mesh": 0, "skin": 0, "translation": [5, 5, 5] },
                        { "children": [2] },
                        { "translation": [1.5, 1, 0] },
                        { "mesh": 0 },
                    ]),
                ),
                ("/scenes/0/nodes", json!([0, 1, 3])),
            ],
        )
    };
    let model = skinned(json!({ "joints": [1, 2] }));
    let expected = [Vec3::ZERO, Vec3::X, Vec3::new(2.5, 2.0, 0.0), Vec3::new(1.5, 2.0, 0.0)];
    assert_eq!(model.meshes[0].positions, expected);
    assert_eq!(model.objects[0].transform, glam::DMat4::IDENTITY);
    // Another node without the skin shows the mesh as it is bound.
    assert_eq!(model.meshes[model.objects[1].mesh].positions[2], Vec3::new(1.0, 1.0, 0.0));
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    for (skin, why) in [(json!({ "joints": [1, 9] }), "node 9"), (json!({ "joints": [1] }), "joint 1")] {
        let model = skinned(skin);
        assert_eq!(model.meshes[0].positions[2], Vec3::new(1.0, 1.0, 0.0), "{why}");
        assert!(has_note(&model, why), "{:?}", model.notes);
    }
}

#[test]
fn morph_targets_have_the_weights_of_the_file() {
    let moves = floats(&[0.0, 0.0, 2.0].repeat(4));
    let posed = |mesh: Value, node: Value| {
        let model = with_bytes(
            &moves,
            &[
                (
                    "/accessors/3",
                    json!({ "bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3" }),
                ),
                ("/meshes/0/primitives/0/targets", json!([{ "POSITION": 3 }, { "POSITION": 3 }])),
                ("/meshes/0/weights", mesh),
                ("/nodes/0/weights", node),
            ],
        );
        assert!(model.notes.is_empty(), "{:?}", model.notes);
        model.meshes[0].positions[1]
    };
    assert_eq!(posed(json!([0.5, 0.25]), Value::Null), Vec3::new(1.0, 0.0, 1.5));
    assert_eq!(posed(json!([0.5, 0.25]), json!([0, 1])), Vec3::new(1.0, 0.0, 2.0));
    assert_eq!(posed(json!([]), Value::Null), Vec3::X);
}

#[test]
fn instances_are_objects_of_one_mesh() {
    let places = floats(&[1.0, 0.0, 0.0, 0.0, 3.0, 0.0, f32::NAN, 0.0, 0.0]);
    let extension = |attributes: Value| json!({ "EXT_mesh_gpu_instancing": { "attributes": attributes } });
    let model = with_bytes(
        &places,
        &[
            ("/accessors/3", json!({ "bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC3" })),
            ("/nodes/0/translation", json!([0, 0, 7])),
            ("/nodes/0/extensions", extension(json!({ "TRANSLATION": 3 }))),
        ],
    );
    let places: Vec<DVec3> = model.objects.iter().map(|object| object.transform.w_axis.truncate()).collect();
    assert_eq!((model.meshes.len(), places), (1, vec![DVec3::new(1.0, 0.0, 7.0), DVec3::new(0.0, 3.0, 7.0)]));
    assert!(has_note(&model, "instances that are not placed by finite numbers"), "{:?}", model.notes);
}

#[test]
fn specular_and_glossiness_become_a_dielectric_of_that_reflectance() {
    let old = json!({ "extensions": { "KHR_materials_pbrSpecularGlossiness": {
        "diffuseFactor": [0.5, 0.25, 0, 0.5], "specularFactor": [0.1, 0.1, 0.1], "glossinessFactor": 0.5 } } });
    let new = json!({ "pbrMetallicRoughness": { "baseColorFactor": [0.5, 0.25, 0, 0.5], "metallicFactor": 0,
        "roughnessFactor": 0.5 }, "extensions": { "KHR_materials_specular": { "specularColorFactor": [2.5, 2.5, 2.5] } } });
    let (old, new) = (read(&material(old)), read(&material(new)));
    assert_eq!(old.materials, new.materials);
    assert!(has_note(&old, "as a dielectric of that reflectance"));
    let picture = base64(&texture::tests::png(1, 1, &[255, 255, 255, 51]));
    let [materials, uses] = material(json!({ "extensions": { "KHR_materials_pbrSpecularGlossiness": {
        "diffuseTexture": { "index": 0 }, "specularGlossinessTexture": { "index": 0 } } } }));
    let textured = read(&[
        materials,
        uses,
        ("/images", json!([{ "uri": format!("data:image/png;base64,{picture}") }])),
        ("/textures", json!([{ "source": 0 }])),
    ]);
    let material = &textured.materials[0];
    assert!(material.base_color.is_some());
    let gloss = material.lobes.iter().find(|lobe| lobe.shape.info().name == "ggx").unwrap();
    assert!(gloss.shape.params()[0] == 1.0 && gloss.masks.len() == 1, "{gloss:?}");
    // Glossiness 0.2 is roughness 0.8.
    let rough = &textured.textures[material.metal_rough_map.unwrap().texture];
    assert_eq!((rough.rgba[1], rough.srgb), (204, false));
}

#[test]
fn compressed_geometry_is_never_zeros() {
    let draco = json!({ "KHR_draco_mesh_compression": { "bufferView": 0, "attributes": { "POSITION": 0 } } });
    let extensions = ("/meshes/0/primitives/0/extensions", draco);
    let placeholder = ("/accessors/0", json!({ "componentType": 5126, "count": 4, "type": "VEC3" }));
    let found = error(&[extensions.clone(), placeholder]);
    let what =
        "KHR_draco_mesh_compression: expected 2 triangles of 4 vertices, found what cannot be decompressed";
    assert!(found.contains(what), "{found}");
    // With what the file has for readers that do not know the extension, it is read.
    assert_eq!(read(&[extensions]).triangle_count(), 2);
    let (fallback, view) =
        (json!({ "EXT_meshopt_compression": {} }), json!({ "buffer": 1, "byteLength": 48 }));
    let buffer = json!({ "byteLength": 99, "extensions": fallback });
    let found = error(&[("/buffers/1", buffer), ("/bufferViews/0", view)]);
    assert!(found.contains("expected bytes within the 0 of buffer 1"), "{found}");
}

#[test]
fn broken_containers_and_json_name_the_byte_or_line() {
    let bytes = with(&[]);
    let cut = |at: usize| error_of(&bytes[..at], Format::Gltf);
    assert!(cut(10).contains("byte 8: expected 4 bytes, found the end of the file"));
    assert!(cut(100).contains("byte 8: expected a file of"));
    let mut version = bytes.clone();
    version[4] = 1;
    assert!(error_of(&version, Format::Gltf).contains("version 2 of glTF, found glTF 1"));
    let mut chunk = bytes.clone();
    chunk[15] = 0x7f;
    assert!(error_of(&chunk, Format::Gltf).contains("byte 12: expected a chunk of at most"));
    let error = error_of(b"{\n  \"asset\": 3\n}", Format::Gltf);
    assert!(error.contains("line 2, column 12") && error.contains("invalid type"), "{error}");
    assert!(error_of(&[b'['; 100_000], Format::Gltf).contains("line 1"));
}

#[test]
fn variants_choose_other_materials() {
    let document = || {
        let mapping =
            json!({ "mappings": [{ "material": 1, "variants": [1] }, { "material": 9, "variants": [] }] });
        let mut document = quad().0;
        change(
            &mut document,
            &[
                ("/materials", json!([{ "name": "own" }, { "name": "other" }])),
                ("/meshes/0/primitives/0/material", json!(0)),
                ("/meshes/0/primitives/0/extensions", json!({ "KHR_materials_variants": mapping })),
                (
                    "/extensions",
                    json!({ "KHR_materials_variants": { "variants": [{ "name": "day" }, { "name": "night" }] } }),
                ),
            ],
        );
        glb(&document, &quad().1)
    };
    let read = |variant: Option<&str>| {
        let options = ReadOptions { variant: variant.map(str::to_owned), ..ReadOptions::default() };
        read_model_bytes(&document(), Format::Gltf, "file", &NoFiles, &options)
    };
    let name = |variant| read(variant).unwrap().materials[0].name.clone();
    assert_eq!([name(None), name(Some("day")), name(Some("night"))], ["own", "own", "other"]);
    let notes = read(None).unwrap().notes;
    assert!(notes.iter().any(|note| note.contains("it has the variants 'day', 'night'")), "{notes:?}");
    let error = read(Some("noon")).unwrap_err().to_string();
    assert!(error.contains("one of the variants 'day', 'night'") && error.contains("noon"), "{error}");
    let options = ReadOptions { variant: Some("day".to_owned()), ..ReadOptions::default() };
    let obj =
        read_model_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", Format::Obj, "file", &NoFiles, &options);
    assert!(obj.unwrap_err().to_string().contains("glTF, which alone has variants"));
}
