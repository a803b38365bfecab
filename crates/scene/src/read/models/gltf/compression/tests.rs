use draco_core::{
    DataType, EncoderBuffer, EncoderOptions, FaceIndex, GeometryAttributeType as Kind, Mesh, MeshEncoder,
    PointAttribute, PointIndex,
};
use glam::{Vec2, Vec3, Vec4};
use meshoptimizer_rs::Workspace;
use meshoptimizer_rs::codec::{self, ExpMode, IndexEncoding, VertexEncoding};
use serde_json::{Value, json};

use super::super::tests::{change, glb};
use crate::read::tests::{check, error_of, read_bytes};
use crate::read::{Format, Model};

/// Cells along each side of the sheet.
const CELLS: u32 = 12;
const VERTICES: usize = ((CELLS + 1) * (CELLS + 1)) as usize;

/// A curved square whose vertices are known by their place.
struct Sheet {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    colors: Vec<[u8; 4]>,
    triangles: Vec<[u32; 3]>,
}

fn sheet() -> Sheet {
    let places = (0..VERTICES as u32).map(|vertex| [vertex % (CELLS + 1), vertex / (CELLS + 1)]);
    let places: Vec<[f32; 2]> =
        places.map(|place| place.map(|number| number as f32 / CELLS as f32)).collect();
    let normal = |&[x, _]: &[f32; 2]| Vec3::new(-(6.0 * x).cos(), 0.0, 1.0).normalize().to_array();
    let corner = |i: u32, j: u32| j * (CELLS + 1) + i;
    let cells = (0..CELLS * CELLS).map(|cell| (cell % CELLS, cell / CELLS));
    Sheet {
        positions: places.iter().map(|&[x, y]| [x, y, (6.0 * x).sin() / 6.0]).collect(),
        normals: places.iter().map(normal).collect(),
        uvs: places.iter().map(|&[x, y]| [1.0 - x, y]).collect(),
        colors: places.iter().map(|&[x, y]| [(255.0 * x) as u8, (255.0 * y) as u8, 64, 255]).collect(),
        triangles: cells
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect(),
    }
}

/// That a model is the sheet, its vertices in any order, moved by `offset`.
fn check_sheet(model: &Model, offset: Vec3, tolerance: f32) {
    check(model);
    let (sheet, mesh) = (sheet(), &model.meshes[0]);
    let place = |position: &Vec3| {
        let [x, y, _] = (*position - offset).to_array().map(|number| (number * CELLS as f32).round() as u32);
        y * (CELLS + 1) + x
    };
    let names: Vec<u32> = mesh.positions.iter().map(place).collect();
    for (vertex, name) in names.iter().map(|name| *name as usize).enumerate() {
        let position = Vec3::from(sheet.positions[name]) + offset;
        assert!(mesh.positions[vertex].distance(position) < tolerance, "{position}");
        assert!(mesh.normals[vertex].distance(Vec3::from(sheet.normals[name])) < 0.02, "{position}");
        assert!(mesh.uvs[vertex].distance(Vec2::from(sheet.uvs[name])) < tolerance, "{position}");
        let color = Vec4::from(sheet.colors[name].map(|channel| f32::from(channel) / 255.0));
        assert!(mesh.colors[vertex].distance(color) < 0.01, "{position} {color} {}", mesh.colors[vertex]);
    }
    let sorted = |triangles: &mut Vec<[u32; 3]>| {
        for triangle in triangles.iter_mut() {
            let least = (0..3).min_by_key(|corner| triangle[*corner]).unwrap();
            triangle.rotate_left(least);
        }
        triangles.sort_unstable();
    };
    let of_names = |corners: &[u32]| [0, 1, 2].map(|corner| names[corners[corner] as usize]);
    let mut found: Vec<[u32; 3]> = mesh.corners.chunks_exact(3).map(of_names).collect();
    let mut expected = sheet.triangles;
    sorted(&mut found);
    sorted(&mut expected);
    assert_eq!(found, expected);
}

fn bytes_of<const N: usize>(values: &[[f32; N]]) -> Vec<u8> {
    values.iter().flatten().flat_map(|value| value.to_le_bytes()).collect()
}

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

fn draco(changes: &[(&str, Value)]) -> Vec<u8> {
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
fn draco_must_agree_with_the_accessors() {
    let error = |changes: &[(&str, Value)]| error_of(&draco(changes), Format::Gltf);
    let place = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: expected";
    let found = error(&[("/accessors/0/count", json!(5))]);
    assert!(
        found.contains(&format!("{place} 288 triangles of 5 vertices, found 288 triangles of 169")),
        "{found}"
    );
    let found = error(&[("/accessors/4/count", json!(6))]);
    assert!(found.contains(&format!("{place} 2 triangles of 169 vertices, found what")), "{found}");
    let found = error(&[("/accessors/4/count", json!(3000))]);
    assert!(found.contains("expected 1000 triangles of 169 vertices, found 288"), "{found}");
    let found = error(&[("/accessors/4/count", json!(1u64 << 40))]);
    assert!(found.contains("bytes of memory for a file of this size"), "{found}");
    let numbers = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes";
    let found = error(&[(numbers, json!({ "NORMAL": 4 }))]);
    assert!(found.contains(&format!("{place} the positions among its attributes, found none")), "{found}");
    let found = error(&[(numbers, json!({ "POSITION": 77 }))]);
    assert!(
        found.contains(
            "accessors[0]: expected 169 items of 3 numbers of the componentType 5126 in the attribute 77"
        ),
        "{found}"
    );
    let view = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView";
    assert!(error(&[(view, json!(9))]).contains("bufferViews[9]"));
    // Of what is not needed there is a remark.
    for changes in [("/accessors/1/componentType", json!(5122)), (&format!("{numbers}/NORMAL"), json!(77))] {
        let model = read_bytes(&draco(&[changes]), Format::Gltf).unwrap();
        let left_out = "the attribute NORMAL is left out";
        assert!(model.notes.iter().any(|note| note.contains(left_out)), "{:?}", model.notes);
    }
    let changes = [
        ("/accessors/5/count", json!(9999)),
        ("/skins", json!([{ "joints": [0] }])),
        ("/nodes/0/skin", json!(0)),
    ];
    let model = read_bytes(&draco(&changes), Format::Gltf).unwrap();
    assert!(model.notes.iter().any(|note| note.contains("drawn as it was bound")), "{:?}", model.notes);
}

#[test]
fn strips_compressed_by_draco_are_triangles() {
    let strip = [("/meshes/0/primitives/0/mode", json!(5)), ("/accessors/4/count", json!(400))];
    check_sheet(&read_bytes(&draco(&strip), Format::Gltf).unwrap(), Vec3::ZERO, DRACO_TOLERANCE);
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

/// The sheet with its views compressed, as [`attributes`] and the last accessor, of indices, have them.
fn meshopt(name: &'static str, version: u8, mode: &str) -> (Value, Vec<u8>) {
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

/// A file compressed by Draco, and one by meshopt.
pub(crate) fn compressed_samples() -> [Vec<u8>; 2] {
    let (document, binary) = meshopt("EXT_meshopt_compression", 0, "TRIANGLES");
    [draco(&[]), glb(&document, &binary)]
}

/// The largest error of the filters above, of 16 bits.
const MESHOPT_TOLERANCE: f32 = 1e-4;

#[test]
fn meshopt_gives_the_same_triangles_in_every_mode() {
    for (name, version) in [("EXT_meshopt_compression", 0), ("KHR_meshopt_compression", 1)] {
        for mode in ["TRIANGLES", "INDICES"] {
            let (document, binary) = meshopt(name, version, mode);
            let model = read_bytes(&glb(&document, &binary), Format::Gltf).unwrap();
            check_sheet(&model, Vec3::ZERO, MESHOPT_TOLERANCE);
        }
    }
}

#[test]
fn a_buffer_that_stands_for_compressed_views_is_not_read() {
    let (mut document, binary) = meshopt("EXT_meshopt_compression", 0, "TRIANGLES");
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
    let (mut document, mut binary) = meshopt("EXT_meshopt_compression", 0, "TRIANGLES");
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
    let (document, binary) = meshopt("KHR_meshopt_compression", 1, "TRIANGLES");
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
