mod materials;
mod whole_files;

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec3, Vec2, Vec3, Vec4};
use glanz_color::Rgb;
use serde_json::{Value, json};

pub(crate) use super::compression::tests::compressed_samples;
use crate::read::tests::{check, error_of, read_bytes};
use crate::read::{Format, Model, NoFiles, ReadOptions, read_model_bytes, texture};
use crate::{AlphaMode, LightKind, Metalness, Projection, TextureFilter, Wrap};

/// A binary container of these two chunks.
pub(super) fn glb(json: &Value, binary: &[u8]) -> Vec<u8> {
    let pad = |bytes: &[u8], fill: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), fill);
        bytes
    };
    let (json, binary) = (pad(json.to_string().as_bytes(), b' '), pad(binary, 0));
    let mut bytes = b"glTF".to_vec();
    let word = |value: usize| (value as u32).to_le_bytes();
    bytes.extend(word(2));
    bytes.extend(word(12 + 8 + json.len() + 8 + binary.len()));
    for (chunk, kind) in [(json, b"JSON"), (binary, b"BIN\0")] {
        bytes.extend(word(chunk.len()));
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

/// A document with two triangles of four vertices: three floats for each position from byte 0 on,
/// six indices in bytes from byte 48 on, and a copy of the indices in 16 bits from byte 56 on.
fn quad() -> (Value, Vec<u8>) {
    let positions: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let mut binary: Vec<u8> = positions.iter().flat_map(|value| value.to_le_bytes()).collect();
    binary.extend([0, 1, 2, 0, 2, 3, 0, 0]);
    [0u16, 1, 2, 0, 2, 3].iter().for_each(|index| binary.extend(index.to_le_bytes()));
    let document = json!({
        "asset": { "version": "2.0" },
        "buffers": [{ "byteLength": binary.len() }],
        "bufferViews": [
            { "buffer": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 6 },
            { "buffer": 0, "byteOffset": 56, "byteLength": 12 },
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR" },
            { "bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR" },
        ],
        "meshes": [{ "name": "quad", "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "nodes": [{ "mesh": 0 }],
        "scenes": [{ "nodes": [0] }],
        "scene": 0,
    });
    (document, binary)
}

/// The quad with some values of its document replaced.
fn with(changes: &[(&str, Value)]) -> Vec<u8> {
    let (mut document, binary) = quad();
    change(&mut document, changes);
    glb(&document, &binary)
}

pub(super) fn change(document: &mut Value, changes: &[(&str, Value)]) {
    for (path, value) in changes {
        let (parent, key) = path.rsplit_once('/').unwrap();
        match document.pointer_mut(parent).unwrap() {
            Value::Array(array) => {
                let index: usize = key.parse().unwrap();
                if index == array.len() { array.push(value.clone()) } else { array[index] = value.clone() }
            }
            object => object[key] = value.clone(),
        }
    }
}

pub(crate) fn read(changes: &[(&str, Value)]) -> Model {
    let model = read_bytes(&with(changes), Format::Gltf).unwrap();
    check(&model);
    model
}

fn error(changes: &[(&str, Value)]) -> String {
    error_of(&with(changes), Format::Gltf)
}

pub(super) fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let group = |group: &[u8]| {
        let word =
            group.iter().enumerate().fold(0, |word, (i, byte)| word | u32::from(*byte) << (16 - 8 * i));
        (0..=group.len()).map(|i| DIGITS[(word >> (18 - 6 * i)) as usize & 63] as char).collect::<String>()
    };
    bytes.chunks(3).map(group).collect()
}

/// A document with materials, a picture, lights, a camera and sparse data.
fn rich() -> (Value, Vec<u8>) {
    let (mut document, binary) = quad();
    let picture = base64(&texture::tests::png(1, 1, &[255, 0, 0, 128]));
    let lights = json!({ "KHR_lights_punctual": { "lights": [
        { "type": "spot", "intensity": 2.0, "spot": { "innerConeAngle": 0.25, "outerConeAngle": 0.5 } },
    ] } });
    change(
        &mut document,
        &[
            ("/images", json!([{ "uri": format!("data:image/png;base64,{picture}"), "name": "red" }])),
            ("/textures", json!([{ "source": 0, "sampler": 0 }])),
            ("/samplers", json!([{ "wrapS": 33071, "wrapT": 33648, "magFilter": 9728 }])),
            (
                "/materials",
                json!([{
                    "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicFactor": 0.0 },
                    "normalTexture": { "index": 0, "scale": 0.5 },
                    "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true,
                    "extensions": {
                        "KHR_materials_clearcoat": { "clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.25 },
                        "KHR_materials_sheen": { "sheenColorFactor": [0.5, 0.25, 0], "sheenRoughnessFactor": 0.5 },
                        "KHR_materials_transmission": { "transmissionFactor": 0.5 },
                        "KHR_materials_volume": { "thicknessFactor": 1, "attenuationDistance": 2,
                            "attenuationColor": [1, 0.5, 0] },
                        "KHR_materials_anisotropy": { "anisotropyStrength": 0.5, "anisotropyRotation": 1 },
                        "KHR_materials_iridescence": { "iridescenceFactor": 0.5, "iridescenceIor": 1.4 },
                        "KHR_materials_specular": { "specularFactor": 0.5, "specularColorFactor": [2, 1, 0] },
                        "KHR_materials_ior": { "ior": 1.4 },
                    },
                }]),
            ),
            ("/extensions", lights),
            ("/cameras", json!([{ "type": "perspective", "perspective": { "yfov": 0.8 } }])),
            (
                "/nodes/1",
                json!({ "camera": 0, "translation": [0, 0, 4], "extensions": { "KHR_lights_punctual": { "light": 0 } } }),
            ),
            ("/scenes/0/nodes/1", json!(1)),
            ("/meshes/0/primitives/0/material", json!(0)),
            (
                "/accessors/0/sparse",
                json!({ "count": 1, "indices": { "bufferView": 2, "componentType": 5123, "byteOffset": 2 },
            "values": { "bufferView": 0, "byteOffset": 12 } }),
            ),
        ],
    );
    (document, binary)
}

/// A file of so many positions, and triangles of 32-bit indices after them.
pub(crate) fn grid(vertices: u32, triangles: u32, binary: &[u8]) -> Vec<u8> {
    let mut document = quad().0;
    change(
        &mut document,
        &[
            ("/buffers/0/byteLength", json!(binary.len())),
            ("/bufferViews/0/byteLength", json!(12 * vertices)),
            (
                "/bufferViews/1",
                json!({ "buffer": 0, "byteOffset": 12 * vertices, "byteLength": 12 * triangles }),
            ),
            ("/accessors/0/count", json!(vertices)),
            (
                "/accessors/1",
                json!({ "bufferView": 1, "componentType": 5125, "count": 3 * triangles, "type": "SCALAR" }),
            ),
        ],
    );
    glb(&document, binary)
}

pub(crate) fn sample_glb() -> Vec<u8> {
    let (document, binary) = rich();
    glb(&document, &binary)
}

pub(crate) fn sample_json() -> String {
    let (mut document, binary) = rich();
    let uri = format!("data:application/octet-stream;base64,{}", base64(&binary));
    change(&mut document, &[("/buffers/0/uri", json!(uri))]);
    document.to_string()
}

#[test]
fn indexed_triangles_are_read_in_every_index_type() {
    for accessor in [1, 2] {
        let model = read(&[("/meshes/0/primitives/0/indices", json!(accessor))]);
        assert_eq!(model.meshes[0].corners, [0, 1, 2, 0, 2, 3]);
        assert_eq!(model.meshes[0].positions[2], Vec3::new(1.0, 1.0, 0.0));
        assert_eq!((model.meshes[0].name.as_str(), model.objects[0].name.as_str()), ("quad", "quad"));
    }
}

#[test]
fn strips_and_fans_become_triangles_of_the_same_side() {
    let indexed = |mode: u32| read(&[("/meshes/0/primitives/0/mode", json!(mode))]).meshes[0].corners.clone();
    assert_eq!(indexed(5), [0, 1, 2, 1, 0, 2, 2, 0, 2, 0, 3, 2]);
    assert_eq!(indexed(6), [1, 2, 0, 2, 0, 0, 0, 2, 0, 2, 3, 0]);
    let plain = [("/meshes/0/primitives/0", json!({ "attributes": { "POSITION": 0 }, "mode": 6 }))];
    assert_eq!(read(&plain).meshes[0].corners, [1, 2, 0, 2, 3, 0]);
    let lines = read(&[("/meshes/0/primitives/0/mode", json!(1))]);
    assert!(lines.objects.is_empty() && lines.notes.iter().any(|note| note.contains("lines are ignored")));
}

#[test]
fn primitives_take_only_the_vertices_that_they_use() {
    let model = read(&[
        ("/accessors/1/count", json!(3)),
        ("/bufferViews/1/byteOffset", json!(51)),
        ("/bufferViews/1/byteLength", json!(3)),
    ]);
    assert_eq!(model.meshes[0].corners, [0, 1, 2]);
    assert_eq!(model.meshes[0].positions, [Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0), Vec3::Y]);
}

#[test]
fn sparse_items_replace_those_of_the_view() {
    // Item 1 becomes a copy of item 1 of the view moved by one, which is item 1: choose item 3 by
    // its offset.
    let sparse = |view: Option<usize>| {
        json!({ "bufferView": view, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {
            "count": 2,
            "indices": { "bufferView": 1, "componentType": 5121, "byteOffset": 1 },
            "values": { "bufferView": 0, "byteOffset": 24 },
        } })
    };
    let positions = |view| read(&[("/accessors/0", sparse(view))]).meshes[0].positions.clone();
    let (c, d) = (Vec3::new(1.0, 1.0, 0.0), Vec3::Y);
    assert_eq!(positions(Some(0)), [Vec3::ZERO, c, d, d]);
    assert_eq!(positions(None), [Vec3::ZERO, c, d, Vec3::ZERO]);
}

#[test]
fn normalised_numbers_of_all_types_become_fractions() {
    for (code, bytes, expected) in [
        (5120, vec![0x81u8, 127, 0, 0], [-1.0, 1.0]),
        (5121, vec![255, 51, 0, 0], [1.0, 0.2]),
        (5122, [(-32768i16).to_le_bytes(), 32767i16.to_le_bytes()].concat(), [-1.0, 1.0]),
        (5123, [65535u16.to_le_bytes(), 13107u16.to_le_bytes()].concat(), [1.0, 0.2]),
        (5126, [1.5f32.to_le_bytes(), (-2.0f32).to_le_bytes()].concat(), [1.5, -2.0]),
    ] {
        let (mut document, mut binary) = quad();
        let offset = binary.len();
        binary.extend(bytes.repeat(4));
        change(
            &mut document,
            &[
                ("/buffers/0/byteLength", json!(binary.len())),
                (
                    "/bufferViews/3",
                    json!({ "buffer": 0, "byteOffset": offset, "byteLength": binary.len() - offset,
                "byteStride": bytes.len() }),
                ),
                (
                    "/accessors/3",
                    json!({ "bufferView": 3, "componentType": code, "normalized": true, "count": 4, "type": "VEC2" }),
                ),
                ("/meshes/0/primitives/0/attributes/TEXCOORD_0", json!(3)),
            ],
        );
        let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
        assert_eq!(model.meshes[0].uvs, [Vec2::from(expected); 4], "{code}");
    }
}

#[test]
fn colours_of_three_numbers_are_opaque() {
    let model = read(&[("/meshes/0/primitives/0/attributes/COLOR_0", json!(0))]);
    assert_eq!(model.meshes[0].colors[1], Vec4::new(1.0, 0.0, 0.0, 1.0));
}

#[test]
fn transforms_multiply_down_the_tree_and_may_mirror() {
    let half_turn = [0.0, 0.0, 1.0, 0.0];
    let model = read(&[(
        "/nodes",
        json!([
            { "children": [1], "translation": [1, 2, 3], "rotation": half_turn },
            { "mesh": 0, "name": "mirrored", "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1] },
        ]),
    )]);
    let transform = model.objects[0].transform;
    assert_eq!(transform.transform_point3(DVec3::ZERO), DVec3::new(-4.0, 2.0, 3.0));
    assert_eq!(transform.transform_vector3(DVec3::new(1.0, 1.0, 1.0)), DVec3::new(1.0, -1.0, 1.0));
    assert_eq!(model.objects[0].name, "mirrored");
}

#[test]
fn cycles_and_shared_children_are_errors() {
    let own = error(&[("/nodes/0/children", json!([0]))]);
    assert!(own.contains("nodes[0].children") && own.contains("node 0, which is one already"), "{own}");
    let ring = error(&[("/nodes", json!([{ "children": [1] }, { "children": [2] }, { "children": [0] }]))]);
    assert!(ring.contains("nodes[2].children"), "{ring}");
    // Each node twice the child of the one before: without the check, 2^40 visits.
    let nodes: Vec<Value> = (1..=40).map(|i| json!({ "children": [i, i] })).chain([json!({})]).collect();
    assert!(error(&[("/nodes", json!(nodes))]).contains("which is one already"));
}

#[test]
fn deep_trees_need_no_deep_stack() {
    let nodes: Vec<Value> =
        (1..50_000).map(|i| json!({ "children": [i] })).chain([json!({ "mesh": 0 })]).collect();
    assert_eq!(read(&[("/nodes", json!(nodes))]).objects.len(), 1);
}

#[test]
fn all_nodes_are_read_where_there_is_no_scene() {
    let (mut document, binary) = quad();
    document.as_object_mut().unwrap().remove("scenes");
    document["nodes"] = json!([{ "mesh": 0 }, { "children": [0] }, { "mesh": 0 }]);
    assert_eq!(read_bytes(&glb(&document, &binary), Format::Gltf).unwrap().objects.len(), 2);
}

#[test]
fn lights_are_in_classic_units_and_look_along_minus_z() {
    let light = |light: Value| {
        let extensions = json!({ "KHR_lights_punctual": { "lights": [light] } });
        let node =
            json!({ "translation": [1, 2, 3], "extensions": { "KHR_lights_punctual": { "light": 0 } } });
        [("/extensions", extensions), ("/nodes/0", node)]
    };
    let spot = read(&light(json!({ "type": "spot", "intensity": PI, "color": [1, 0.5, 0],
        "spot": { "innerConeAngle": 0.25, "outerConeAngle": 0.5 } })));
    let LightKind::Spot { position, direction, cutoff, smooth_edge, attenuation, .. } = spot.lights[0].kind
    else {
        panic!("{:?}", spot.lights[0]);
    };
    assert_eq!((position, direction, cutoff), (DVec3::new(1.0, 2.0, 3.0), DVec3::NEG_Z, 0.5));
    assert_eq!(smooth_edge, Some((libm::cos(0.25), libm::cos(0.5))));
    assert_eq!(attenuation, crate::Attenuation::PHYSICAL);
    assert_eq!(spot.lights[0].colors, crate::LightColors::direct(Rgb([1.0, 0.5, 0.0])));
    let sun = read(&light(json!({ "type": "directional" })));
    assert_eq!(sun.lights[0].kind, LightKind::Directional { direction: DVec3::NEG_Z });
    assert_eq!(sun.lights[0].colors.diffuse, Rgb::gray((1.0 / PI) as f32).into());
    let wrong = json!({ "type": "spot", "spot": { "innerConeAngle": 0.5, "outerConeAngle": 0.5 } });
    for (odd, what) in [
        (wrong, "lights[0]: expected cone angles"),
        (json!({ "type": "area" }), "lights[0]: expected the type"),
    ] {
        let model = read(&light(odd));
        assert!(model.lights.is_empty() && has_note(&model, "a light is left out") && has_note(&model, what));
    }
}

#[test]
fn cameras_stand_at_their_node() {
    let with_camera = |camera: Value| {
        [
            ("/cameras", json!([camera])),
            ("/nodes/0", json!({ "camera": 0, "translation": [0, 0, 5], "scale": [2, 2, 2] })),
        ]
    };
    let model =
        read(&with_camera(json!({ "type": "perspective", "name": "c", "perspective": { "yfov": 0.5 } })));
    let (name, camera) = &model.cameras[0];
    assert_eq!(
        (name.as_str(), camera.eye, camera.target, camera.up),
        ("c", DVec3::Z * 5.0, DVec3::Z * 4.0, DVec3::Y)
    );
    assert_eq!(camera.projection, Projection::Perspective { fov_y: 0.5 });
    let model = read(&with_camera(json!({ "type": "orthographic", "orthographic": { "ymag": 3 } })));
    assert_eq!(model.cameras[0].1.projection, Projection::Orthographic { height: 6.0 });
    for yfov in [4.0, 0.0, -1.0, 1e-30, 1e-6, PI - 5e-8, 1e300] {
        let model = read(&with_camera(json!({ "type": "perspective", "perspective": { "yfov": yfov } })));
        let left_out =
            has_note(&model, "cameras[0]: expected a perspective") && has_note(&model, "found a yfov");
        assert!(model.cameras.is_empty() && left_out, "{yfov}: {:?}", model.notes);
    }
    let far = [
        ("/cameras", json!([{ "type": "perspective", "perspective": { "yfov": 0.5 } }])),
        ("/nodes/0", json!({ "camera": 0, "translation": [0, 0, 1e20] })),
    ];
    assert!(read(&far).cameras.is_empty());
}

/// The tints and exponents of a material, by shape.
fn lobes(model: &Model) -> Vec<(&'static str, [f32; 3], Option<f64>)> {
    let lobe = |lobe: &crate::Lobe| {
        (lobe.shape.info().name, lobe.tint.rgb().expect("RGB alone").0, lobe.shape.params().first().copied())
    };
    model.materials[0].lobes.iter().map(lobe).collect()
}

pub(crate) fn material(material: Value) -> [(&'static str, Value); 2] {
    [("/materials", json!([material])), ("/meshes/0/primitives/0/material", json!(0))]
}

#[test]
fn required_extensions_that_are_unknown_are_refused_and_others_noted() {
    let name = "EXT_other";
    let error = error(&[("/extensionsRequired", json!(["KHR_materials_unlit", name]))]);
    let expected =
        "expected extensions that docs/FORMATS.md names, found 'EXT_other', which is not supported";
    assert!(error.contains(expected), "{error}");
    let notes = read(&[("/extensionsUsed", json!([name]))]).notes;
    assert!(notes.iter().any(|note| note.contains(name)), "{notes:?}");
    // Materials and pictures change no geometry.
    for name in ["KHR_materials_variants", "KHR_texture_basisu", "EXT_texture_webp"] {
        assert_eq!(read(&[("/extensionsRequired", json!([name]))]).objects.len(), 1);
    }
}

#[test]
fn the_version_is_looked_at_before_the_types_of_that_version() {
    let old = json!({ "asset": { "version": "1.0" }, "accessors": { "a": {} }, "scene": "s", "buffers": {} });
    let error = |document: &Value| error_of(document.to_string().as_bytes(), Format::Gltf);
    let found = error(&old);
    assert!(
        found.contains("asset.version: expected version 2 of glTF, found glTF 1.0, which is not supported"),
        "{found}"
    );
    assert!(error(&json!({ "asset": { "version": 1 } })).contains("found glTF 1,"));
    assert!(error(&json!({ "accessors": {} })).contains("files of glTF 1.0 may leave it out"));
}

#[test]
fn indices_out_of_range_are_errors_that_name_them() {
    let cases = [
        (
            "/meshes/0/primitives/0/attributes/POSITION",
            "meshes[0].primitives[0]: expected one of 3 accessors",
        ),
        ("/meshes/0/primitives/0/indices", "meshes[0].primitives[0]: expected one of 3 accessors"),
        ("/meshes/0/primitives/0/mode", "meshes[0].primitives[0].mode: expected a mode of 0 to 6"),
        ("/nodes/0/mesh", "nodes[0].mesh: expected one of 1 meshes"),
        ("/scenes/0/nodes/0", "scenes: expected one of 1 nodes"),
        ("/scene", "scene: expected one of 1 scenes"),
        ("/accessors/0/bufferView", "bufferViews[99]: expected one of 3 bufferViews"),
        ("/bufferViews/0/buffer", "bufferViews[0]: expected one of 1 buffers"),
        ("/bufferViews/0/byteLength", "bufferViews[0]: expected bytes within"),
        ("/accessors/0/byteOffset", "accessors[0]: expected 4 items of 12 bytes"),
        ("/accessors/0/componentType", "accessors[0]: expected a componentType"),
        ("/buffers/0/byteLength", "buffers[0]: expected 99 bytes"),
    ];
    for (path, message) in cases {
        let error = error(&[(path, json!(99))]);
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn claims_beyond_the_file_are_refused() {
    for count in [1_000_000_000u64, u64::MAX] {
        let claim = json!({ "componentType": 5126, "count": count, "type": "VEC3" });
        assert!(error(&[("/accessors/0", claim)]).contains("accessors[0]: expected a count of at most"));
    }
    let stride = error(&[("/bufferViews/0/byteStride", json!(u64::MAX))]);
    assert!(stride.contains("expected a byteStride"), "{stride}");
    let offset = error(&[("/bufferViews/0/byteOffset", json!(u64::MAX))]);
    assert!(offset.contains("bufferViews[0]"), "{offset}");
}

#[test]
fn small_files_cannot_grow_without_limit() {
    let primitive = json!({ "attributes": { "POSITION": 0 }, "indices": 1 });
    let nodes = vec![json!({ "mesh": 0 }); 4000];
    let roots: Vec<usize> = (0..4000).collect();
    let error = error(&[
        ("/meshes/0/primitives", json!(vec![primitive; 4000])),
        ("/nodes", json!(nodes)),
        ("/scenes/0/nodes", json!(roots)),
    ]);
    assert!(error.contains("bytes of memory for a file of this size"), "{error}");
}

fn has_note(model: &Model, text: &str) -> bool {
    model.notes.iter().any(|note| note.contains(text))
}

/// The quad with these bytes behind its own, for which there is view 3.
fn with_bytes(bytes: &[u8], changes: &[(&str, Value)]) -> Model {
    let (mut document, mut binary) = quad();
    let view = json!({ "buffer": 0, "byteOffset": binary.len(), "byteLength": bytes.len() });
    binary.extend(bytes);
    change(&mut document, &[("/buffers/0/byteLength", json!(binary.len())), ("/bufferViews/3", view)]);
    change(&mut document, changes);
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    check(&model);
    model
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}
