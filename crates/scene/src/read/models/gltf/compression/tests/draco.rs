use draco_core::{
    DataType, EncoderBuffer, EncoderOptions, FaceIndex, GeometryAttributeType as Kind, Mesh, MeshEncoder,
    PointAttribute, PointIndex,
};
use glam::Vec3;
use serde_json::{Value, json};

use super::super::super::tests::{change, glb};
use super::{CELLS, VERTICES, bytes_of, check_sheet, sheet};
use crate::read::Format;
use crate::read::tests::{check, error_of, read_bytes};

/// How the attributes of the sheet are numbered in the file's JSON.
fn attributes() -> Value {
    json!({ "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 3, "JOINTS_0": 5, "WEIGHTS_0": 6 })
}

/// The document of the sheet compressed by Draco, and the accessors of its attributes.
fn draco_document(stream: &[u8]) -> Value {
    let accessor = |code: u32, kind: &str| json!({ "componentType": code, "count": VERTICES, "type": kind });
    let mut color = accessor(5121, "VEC4");
    color["normalized"] = json!(true);
    let indices = json!({ "componentType": 5123, "count": 6 * CELLS * CELLS, "type": "SCALAR" });
    let numbers =
        json!({ "POSITION": 9, "NORMAL": 4, "TEXCOORD_0": 7, "COLOR_0": 2, "JOINTS_0": 1, "WEIGHTS_0": 3 });
    let draco = json!({ "KHR_draco_mesh_compression": { "bufferView": 0, "attributes": numbers } });
    json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_draco_mesh_compression"],
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "buffers": [{ "byteLength": stream.len() }],
        "bufferViews": [{ "buffer": 0, "byteLength": stream.len() }],
        "accessors": [
            accessor(5126, "VEC3"), accessor(5126, "VEC3"), accessor(5126, "VEC2"), color, indices,
            accessor(5121, "VEC4"), accessor(5126, "VEC4"),
        ],
        "meshes": [{ "primitives": [{ "attributes": attributes(), "indices": 4, "extensions": draco }] }],
        "nodes": [{ "mesh": 0 }],
        "scenes": [{ "nodes": [0] }],
    })
}

/// The sheet compressed by Draco's encoder at a speed of 0, the smallest, to 10.
fn draco_stream(speed: i32) -> Vec<u8> {
    let sheet = sheet();
    let mut mesh = Mesh::new();
    let mut add = |number: u32, kind: Kind, width: u8, data: DataType, bytes: &[u8]| {
        let mut attribute = PointAttribute::new();
        attribute.init(kind, width, data, data == DataType::Uint8, VERTICES);
        attribute.buffer_mut().write(0, bytes);
        attribute.set_unique_id(number);
        mesh.add_attribute_preserve_unique_id(attribute);
    };
    add(9, Kind::Position, 3, DataType::Float32, &bytes_of(&sheet.positions));
    add(4, Kind::Normal, 3, DataType::Float32, &bytes_of(&sheet.normals));
    add(7, Kind::TexCoord, 2, DataType::Float32, &bytes_of(&sheet.uvs));
    add(2, Kind::Color, 4, DataType::Uint8, sheet.colors.as_flattened());
    add(1, Kind::Generic, 4, DataType::Uint8, &[1, 0, 0, 0].repeat(VERTICES));
    add(3, Kind::Generic, 4, DataType::Float32, &bytes_of(&[[1.0, 0.0, 0.0, 0.0]; VERTICES]));
    mesh.set_num_faces(sheet.triangles.len());
    for (face, triangle) in sheet.triangles.iter().enumerate() {
        mesh.set_face(FaceIndex(face as u32), triangle.map(PointIndex));
    }
    let mut options = EncoderOptions::new();
    options.set_compression_level(10 - speed);
    [14, 10, 12]
        .iter()
        .enumerate()
        .for_each(|(id, bits)| options.set_attribute_quantization(id as i32, *bits));
    let mut encoder = MeshEncoder::new();
    encoder.set_mesh(mesh);
    let mut out = EncoderBuffer::new();
    encoder.encode(&options, &mut out).unwrap();
    out.data().to_vec()
}

/// The largest error of 12 bits within a unit square, and some rounding.
const DRACO_TOLERANCE: f32 = 4e-4;

pub(super) fn file(changes: &[(&str, Value)]) -> Vec<u8> {
    let stream = draco_stream(5);
    let mut document = draco_document(&stream);
    change(&mut document, changes);
    glb(&document, &stream)
}

#[test]
fn draco_gives_the_same_triangles_in_every_way_of_encoding() {
    for speed in [0, 3, 5, 7, 10] {
        let stream = draco_stream(speed);
        let model = read_bytes(&glb(&draco_document(&stream), &stream), Format::Gltf).unwrap();
        check_sheet(&model, Vec3::ZERO, DRACO_TOLERANCE);
        assert!(model.notes.iter().all(|note| !note.contains("extension")), "{:?}", model.notes);
    }
}

#[test]
fn draco_primitives_take_part_in_skins_and_morph_targets() {
    let offset = json!([{ "POSITION": 7 }]);
    let stream = draco_stream(5);
    let mut binary = stream.clone();
    binary.resize(stream.len().next_multiple_of(4), 0);
    let start = binary.len();
    binary.extend(bytes_of(&[[0.0f32, 2.0, 0.0]; VERTICES]));
    let mut document = draco_document(&stream);
    change(
        &mut document,
        &[
            ("/buffers/0/byteLength", json!(binary.len())),
            ("/bufferViews/1", json!({ "buffer": 0, "byteOffset": start, "byteLength": 12 * VERTICES })),
            (
                "/accessors/7",
                json!({ "bufferView": 1, "componentType": 5126, "count": VERTICES, "type": "VEC3" }),
            ),
            ("/meshes/0/primitives/0/targets", offset),
            ("/meshes/0/weights", json!([0.5])),
            ("/skins", json!([{ "joints": [1, 2] }])),
            ("/nodes", json!([{ "mesh": 0, "skin": 0 }, {}, { "translation": [3, 0, 0] }])),
            ("/scenes/0/nodes", json!([0, 1, 2])),
        ],
    );
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    check_sheet(&model, Vec3::new(3.0, 1.0, 0.0), DRACO_TOLERANCE);
}

#[test]
fn counts_of_accessors_give_way_to_what_draco_has() {
    for (path, count) in [("/accessors/0/count", 5), ("/accessors/4/count", 6), ("/accessors/4/count", 3000)]
    {
        let model = read_bytes(&file(&[(path, json!(count))]), Format::Gltf).unwrap();
        check_sheet(&model, Vec3::ZERO, DRACO_TOLERANCE);
        assert!(
            model.notes.iter().any(|note| note.contains("other numbers of vertices")),
            "{:?}",
            model.notes
        );
    }
}

#[test]
fn joints_and_colours_may_be_numbers_of_another_type() {
    let skin = [("/skins", json!([{ "joints": [0, 0] }])), ("/nodes/0/skin", json!(0))];
    for code in [5123, 5126] {
        let mut changes = skin.to_vec();
        changes.push(("/accessors/5/componentType", json!(code)));
        let model = read_bytes(&file(&changes), Format::Gltf).unwrap();
        assert!(model.notes.iter().all(|note| !note.contains("drawn as it was bound")), "{:?}", model.notes);
        check_sheet(&model, Vec3::ZERO, DRACO_TOLERANCE);
    }
}

#[test]
fn draco_must_agree_with_the_accessors() {
    let error = |changes: &[(&str, Value)]| error_of(&file(changes), Format::Gltf);
    let place = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: expected";
    let numbers = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes";
    let found = error(&[(numbers, json!({ "NORMAL": 4 }))]);
    assert!(found.contains(&format!("{place} the positions among its attributes, found none")), "{found}");
    let found = error(&[(numbers, json!({ "POSITION": 77 }))]);
    assert!(found.contains("accessors[0]: expected items of 3 numbers in the attribute 77"), "{found}");
    let view = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView";
    assert!(error(&[(view, json!(9))]).contains("bufferViews[9]"));
    // Of what is not needed there is a remark.
    for number in [7, 77] {
        let changes = (&*format!("{numbers}/NORMAL"), json!(number));
        let model = read_bytes(&file(&[changes]), Format::Gltf).unwrap();
        let left_out = "the attribute NORMAL is left out";
        assert!(model.notes.iter().any(|note| note.contains(left_out)), "{:?}", model.notes);
    }
    let changes = [
        (&*format!("{numbers}/JOINTS_0"), json!(9)),
        ("/skins", json!([{ "joints": [0] }])),
        ("/nodes/0/skin", json!(0)),
    ];
    let model = read_bytes(&file(&changes), Format::Gltf).unwrap();
    assert!(model.notes.iter().any(|note| note.contains("drawn as it was bound")), "{:?}", model.notes);
}

#[test]
fn strips_compressed_by_draco_are_triangles() {
    let strip = [("/meshes/0/primitives/0/mode", json!(5)), ("/accessors/4/count", json!(400))];
    check_sheet(&read_bytes(&file(&strip), Format::Gltf).unwrap(), Vec3::ZERO, DRACO_TOLERANCE);
}

#[test]
fn damaged_draco_is_an_error_or_a_model() {
    let stream = draco_stream(5);
    let document = draco_document(&stream);
    let mut errors = 0;
    for at in 0..stream.len() {
        for bit in [0, 3, 7] {
            let mut damaged = stream.clone();
            damaged[at] ^= 1 << bit;
            match read_bytes(&glb(&document, &damaged), Format::Gltf) {
                Ok(model) => check(&model),
                Err(_) => errors += 1,
            }
        }
        let mut cut = document.clone();
        change(&mut cut, &[("/bufferViews/0/byteLength", json!(at))]);
        assert!(error_of(&glb(&cut, &stream), Format::Gltf).contains("cannot be decompressed"));
    }
    assert!(errors > stream.len() / 4, "{errors} of {} bytes", stream.len());
}
