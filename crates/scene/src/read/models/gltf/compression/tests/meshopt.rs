use glam::Vec3;
use meshoptimizer_rs::Workspace;
use meshoptimizer_rs::codec::{self, ExpMode, IndexEncoding, VertexEncoding};
use serde_json::{Value, json};

use super::super::super::tests::{change, glb};
use super::{VERTICES, bytes_of, check_sheet, sheet};
use crate::read::Format;
use crate::read::tests::{check, error_of, read_bytes};

/// A file in the making whose views are all compressed.
struct Meshopt {
    name: &'static str,
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    /// The bytes of the buffer that stands for those of the views.
    size: usize,
}

impl Meshopt {
    /// A view of so many items, compressed, and an accessor of it.
    fn add(&mut self, bytes: &[u8], [count, stride]: [usize; 2], mode: &str, filter: &str, accessor: Value) {
        let compressed = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len(),
            "byteStride": stride, "count": count, "mode": mode, "filter": filter });
        let mut view = json!({ "buffer": 1, "byteOffset": self.size, "byteLength": count * stride });
        if mode == "ATTRIBUTES" {
            view["byteStride"] = json!(stride);
        }
        view["extensions"][self.name] = compressed;
        let mut accessor = accessor;
        accessor["bufferView"] = json!(self.views.len());
        accessor["count"] = json!(count);
        self.binary.extend(bytes);
        self.size += count * stride;
        self.views.push(view);
        self.accessors.push(accessor);
    }
}

/// The sheet with its views compressed, in the order of its accessors: positions, normals, texture coordinates, colours, indices.
pub(super) fn file(name: &'static str, version: u8, mode: &str) -> (Value, Vec<u8>) {
    let (sheet, space) = (sheet(), &mut Workspace::default());
    let mut file = Meshopt { name, binary: Vec::new(), views: Vec::new(), accessors: Vec::new(), size: 0 };
    let encoding = VertexEncoding::new(version, 2).unwrap();
    let vertices = |bytes: &[u8], stride: usize, space: &mut Workspace| {
        codec::encode_vertex_buffer(bytes, VERTICES, stride, encoding, space).unwrap()
    };
    let floats = |values: &[[f32; 3]], w: f32| -> Vec<f32> {
        values.iter().flat_map(|&[x, y, z]| [x, y, z, w]).collect()
    };
    let exponential = |values: &[f32], stride: usize, space: &mut Workspace| {
        codec::encode_filter_exp(VERTICES, stride, 16, values, ExpMode::Separate, space).unwrap()
    };
    let positions = exponential(sheet.positions.as_flattened(), 12, space);
    let float = |kind: &str| json!({ "componentType": 5126, "type": kind });
    file.add(&vertices(&positions, 12, space), [VERTICES, 12], "ATTRIBUTES", "EXPONENTIAL", float("VEC3"));
    let normals = codec::encode_filter_oct(VERTICES, 4, 8, &floats(&sheet.normals, 1.0), space).unwrap();
    let normal = json!({ "componentType": 5120, "normalized": true, "type": "VEC3" });
    file.add(&vertices(&normals, 4, space), [VERTICES, 4], "ATTRIBUTES", "OCTAHEDRAL", normal);
    let uvs = vertices(&bytes_of(&sheet.uvs), 8, space);
    file.add(&uvs, [VERTICES, 8], "ATTRIBUTES", "NONE", float("VEC2"));
    let color = json!({ "componentType": 5121, "normalized": true, "type": "VEC4" });
    let (colors, filter) = match version {
        0 => (sheet.colors.as_flattened().to_vec(), "NONE"),
        _ => {
            let colors: Vec<f32> =
                sheet.colors.iter().flatten().map(|value| f32::from(*value) / 255.0).collect();
            (codec::encode_filter_color(VERTICES, 4, 8, &colors, space).unwrap(), "COLOR")
        }
    };
    file.add(&vertices(&colors, 4, space), [VERTICES, 4], "ATTRIBUTES", filter, color);
    let indices = sheet.triangles.as_flattened();
    let bytes = match mode {
        "TRIANGLES" => codec::encode_index_buffer(indices, IndexEncoding::DEFAULT, space).unwrap(),
        _ => codec::encode_index_sequence(indices, IndexEncoding::DEFAULT, space).unwrap(),
    };
    let index = json!({ "componentType": 5123, "type": "SCALAR" });
    file.add(&bytes, [indices.len(), 2], mode, "NONE", index);
    (document(&file), file.binary)
}

fn document(file: &Meshopt) -> Value {
    let mut fallback = json!({ "byteLength": file.size });
    fallback["extensions"][file.name] = json!({ "fallback": true });
    json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": [file.name],
        "extensionsRequired": [file.name],
        "buffers": [{ "byteLength": file.binary.len() }, fallback],
        "bufferViews": file.views,
        "accessors": file.accessors,
        "meshes": [{ "primitives": [{
            "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 3 }, "indices": 4,
        }] }],
        "nodes": [{ "mesh": 0 }],
        "scenes": [{ "nodes": [0] }],
    })
}

/// The largest error of the filters above, of 16 bits.
const MESHOPT_TOLERANCE: f32 = 1e-4;

#[test]
fn meshopt_gives_the_same_triangles_in_every_mode() {
    for (name, version) in [("EXT_meshopt_compression", 0), ("KHR_meshopt_compression", 1)] {
        for mode in ["TRIANGLES", "INDICES"] {
            let (document, binary) = file(name, version, mode);
            let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
            check_sheet(&model, Vec3::ZERO, MESHOPT_TOLERANCE);
        }
    }
}

#[test]
fn a_buffer_that_stands_for_compressed_views_is_not_read() {
    let (mut document, binary) = file("EXT_meshopt_compression", 0, "TRIANGLES");
    change(&mut document, &[("/buffers/1/uri", json!("https://example.org/fallback.bin"))]);
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    check_sheet(&model, Vec3::ZERO, MESHOPT_TOLERANCE);
    // gltf-pipeline's test files do not say what the buffer is.
    document["buffers"][1] = json!({ "byteLength": 99 });
    check_sheet(&read_bytes(&glb(&document, &binary), Format::Gltf).unwrap(), Vec3::ZERO, MESHOPT_TOLERANCE);
}

#[test]
fn rotations_compressed_by_meshopt_are_quaternions() {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let space = &mut Workspace::default();
    let rotations =
        codec::encode_filter_quat(2, 8, 16, &[half, 0.0, 0.0, half, 0.0, 0.0, 0.0, 1.0], space).unwrap();
    let bytes =
        codec::encode_vertex_buffer(&rotations, 2, 8, VertexEncoding::new(0, 0).unwrap(), space).unwrap();
    let (mut document, mut binary) = file("EXT_meshopt_compression", 0, "TRIANGLES");
    let view = json!({ "buffer": 1, "byteLength": 16, "byteStride": 8, "extensions": { "EXT_meshopt_compression": {
        "buffer": 0, "byteOffset": binary.len(), "byteLength": bytes.len(), "byteStride": 8, "count": 2,
        "mode": "ATTRIBUTES", "filter": "QUATERNION" } } });
    binary.extend(bytes);
    let instancing = json!({ "EXT_mesh_gpu_instancing": { "attributes": { "ROTATION": 5 } } });
    change(
        &mut document,
        &[
            ("/buffers/0/byteLength", json!(binary.len())),
            ("/bufferViews/5", view),
            (
                "/accessors/5",
                json!({ "bufferView": 5, "componentType": 5122, "normalized": true, "count": 2, "type": "VEC4" }),
            ),
            ("/nodes/0/extensions", instancing),
        ],
    );
    let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
    let turned: Vec<_> =
        model.objects.iter().map(|object| object.transform.y_axis.truncate().as_vec3()).collect();
    assert!(turned[0].distance(Vec3::Z) < 1e-3 && turned[1].distance(Vec3::Y) < 1e-3, "{turned:?}");
}

#[test]
fn damaged_meshopt_is_an_error_or_a_model() {
    let (document, binary) = file("KHR_meshopt_compression", 1, "TRIANGLES");
    for at in (0..binary.len()).step_by(3) {
        let mut damaged = binary.clone();
        damaged[at] ^= 0x41;
        if let Ok(model) = read_bytes(&glb(&document, &damaged), Format::Gltf) {
            check(&model);
        }
    }
    let place = "/bufferViews/0/extensions/KHR_meshopt_compression";
    let error = |key: &str, value: Value| {
        let mut document = document.clone();
        change(&mut document, &[(&format!("{place}/{key}"), value)]);
        error_of(&glb(&document, &binary), Format::Gltf)
    };
    let cut = error("byteLength", json!(20));
    let expected = "bufferViews[0].extensions.KHR_meshopt_compression: expected 169 items of 12 bytes in the mode 'ATTRIBUTES' with the filter 'EXPONENTIAL', found what cannot be decompressed";
    assert!(cut.contains(expected), "{cut}");
    for (key, value) in [("mode", json!("OTHER")), ("filter", json!("OTHER")), ("byteStride", json!(13))] {
        assert!(error(key, value.clone()).contains("cannot be decompressed"), "{key}");
    }
    assert!(error("count", json!(1u64 << 40)).contains("bytes of memory for a file of this size"));
    assert!(error("buffer", json!(7)).contains("expected one of 2 buffers, found buffer 7"));
}
