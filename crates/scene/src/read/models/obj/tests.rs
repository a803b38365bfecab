use std::collections::HashMap;

use glam::{Vec2, Vec3};
use glanz_color::Rgb;
use glanz_color::read::ReadError;

use crate::read::tests::{check, error_of, read_bytes};
use crate::read::{Format, Model, ReadOptions, Resolver, read_model_bytes, texture};
use crate::{AlphaMode, Mesh};

pub(crate) const SAMPLE: &str = "# sample
mtllib m.mtl
o box
v 0 0 0
v 1 0 0 1 0.5 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0.25
vn 0 0 2
g side
usemtl shiny
s 1
f 1/1/1 2/2/1 3//1 4/1
usemtl plain
f -4 -3 \\
-2
";

pub(crate) const MTL: &str = "# materials
newmtl shiny
Ka 0.1 0.2 0.3
Kd 0.5
Ks 1 1 1
Ns 64
Ke 0 0 0
d 0.25
illum 2
map_Kd -s 2 4 -o 0.5 0.25 -clamp on wood.png
newmtl plain
Kd 0.5 0.25 0
Ks 1 1 1
illum 1
Pr 0.3
";

fn read_with(obj: &str, files: &[(&str, &[u8])]) -> Result<Model, ReadError> {
    let files: HashMap<String, Vec<u8>> =
        files.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())).collect();
    let files: &dyn Resolver = &files;
    read_model_bytes(obj.as_bytes(), Format::Obj, "file", files, &ReadOptions::default())
}

fn mesh_of(obj: &str) -> Mesh {
    let model = read_bytes(obj.as_bytes(), Format::Obj).unwrap();
    check(&model);
    model.meshes.into_iter().next().unwrap()
}

#[test]
fn polygons_stay_and_corners_share_vertices() {
    let mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 4 5\nf 1 2\n");
    assert_eq!(mesh.corners, [0, 1, 2, 3, 0, 3, 4]);
    assert_eq!(mesh.face_starts, [0, 4, 7]);
    assert_eq!(mesh.positions.len(), 5);
    assert!(mesh.uvs.is_empty() && mesh.normals.is_empty() && mesh.colors.is_empty());
}

#[test]
fn a_vertex_is_made_for_each_combination_once() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n";
    let faces = "f 1/1 2/1 3/1\nf 1/2 2/1 3/1\nf 1/1 2/1 3/1\nf 1/2/2 2/1 3/1\nf 1/2 2/1 3/1\n";
    let mesh = mesh_of(&format!("{vertices}{faces}"));
    assert_eq!(mesh.corners, [0, 1, 2, 3, 1, 2, 0, 1, 2, 4, 1, 2, 3, 1, 2]);
    assert_eq!(
        mesh.uvs,
        [(0, 1), (0, 1), (0, 1), (1, 0), (1, 0)].map(|(u, v)| Vec2::new(u as f32, v as f32))
    );
    // Only the last vertex has a normal in the file; the others are computed.
    assert_eq!(mesh.normals, [Vec3::Z, Vec3::Z, Vec3::Z, Vec3::Z, Vec3::Y]);
}

#[test]
fn objects_and_materials_make_meshes_that_can_be_returned_to() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\nusemtl a\nf 2 3 1\no x\nf 1 2 3\n";
    let model = read_bytes(obj.as_bytes(), Format::Obj).unwrap();
    check(&model);
    let corners: Vec<&[u32]> = model.meshes.iter().map(|mesh| &mesh.corners[..]).collect();
    assert_eq!(corners, [&[0, 1, 2][..], &[0, 1, 2, 1, 2, 0], &[0, 1, 2], &[0, 1, 2]]);
    let materials: Vec<usize> = model.objects.iter().map(|object| object.material).collect();
    assert_eq!(materials, [0, 1, 2, 1]);
    assert_eq!(model.meshes[3].name, "x");
    assert!(model.meshes.iter().all(|mesh| mesh.positions.len() == 3));
}

#[test]
fn materials_and_maps_are_read_from_the_library() {
    let wood = texture::tests::png(1, 1, &[10, 20, 30, 255]);
    let model = read_with(SAMPLE, &[("m.mtl", MTL.as_bytes()), ("wood.png", &wood)]).unwrap();
    check(&model);
    let shiny = &model.materials[0];
    let lobe = |name: &str| {
        let found = shiny.lobes.iter().find(|lobe| lobe.shape.info().name == name);
        found.map(|lobe| (lobe.tint.rgb().expect("RGB alone"), lobe.shape.params()))
    };
    assert_eq!(lobe("ambient"), Some((Rgb([0.1, 0.2, 0.3]), vec![])));
    assert_eq!(lobe("lambert"), Some((Rgb::gray(0.5), vec![])));
    assert_eq!(lobe("blinn-phong"), Some((Rgb::gray(1.0), vec![64.0])));
    assert_eq!((shiny.opacity, shiny.alpha_mode), (0.25, AlphaMode::Blend));
    assert_eq!(shiny.base_color.unwrap().transform, [[2.0, 0.0, 0.5], [0.0, 4.0, -3.25]]);
    assert_eq!(model.textures[0].wrap, [crate::Wrap::Clamp; 2]);
    // Illumination model 1 has no highlight.
    assert!(model.materials[1].lobes.iter().all(|lobe| lobe.shape.info().name != "blinn-phong"));
    assert!(model.notes.iter().any(|note| note == "MTL: 'pr' is ignored"), "{:?}", model.notes);
}

#[test]
fn vertex_colours_are_decoded_and_missing_ones_white() {
    let model = read_with(SAMPLE, &[]).unwrap();
    let colors = &model.meshes[0].colors;
    assert_eq!(colors[0].to_array(), [1.0; 4]);
    assert!((colors[1].y - 0.214_041).abs() < 1e-6, "{}", colors[1]);
}

#[test]
fn what_is_missing_is_noted() {
    let model = read_with(SAMPLE, &[("m.mtl", MTL.as_bytes())]).unwrap();
    let has = |text: &str| model.notes.iter().any(|note| note.contains(text));
    assert!(has("'wood.png' is missing") && has("groups (g)") && has("smoothing"), "{:?}", model.notes);
    let model = read_with(SAMPLE, &[]).unwrap();
    assert!(model.notes.iter().any(|note| note.contains("'m.mtl' is missing")), "{:?}", model.notes);
    assert!(model.notes.iter().any(|note| note.contains("'shiny' is not defined")), "{:?}", model.notes);
}

#[test]
fn height_maps_are_told_from_normal_maps() {
    let mtl = b"newmtl shiny\nmap_Bump -bm 0.5 wood.png\n";
    let normal = texture::tests::png(1, 1, &[128, 128, 255, 255]);
    let model = read_with(SAMPLE, &[("m.mtl", mtl), ("wood.png", &normal)]).unwrap();
    assert_eq!(model.materials[0].normal_map.unwrap().scale, 0.5);
    assert!(!model.textures[0].srgb);
    let height = texture::tests::png(1, 1, &[128, 128, 128, 255]);
    let model = read_with(SAMPLE, &[("m.mtl", mtl), ("wood.png", &height)]).unwrap();
    assert!(model.materials[0].normal_map.is_none() && model.textures.is_empty());
}

#[test]
fn errors_name_the_line_and_what_was_expected() {
    let cases = [
        ("v 0 0\n", "line 1: expected 'v' and three finite numbers, found 'v 0 0'"),
        ("v 0 0 nan\n", "line 1"),
        ("v 0 0 0\nvn 1 inf 0\n", "line 2"),
        ("v 0 0 0\nf 1 1 2\n", "line 2: expected the number of one of the 1 v lines before"),
        ("v 0 0 0\nf 1 1 0\n", "line 2"),
        ("v 0 0 0\nf 1 1 -2\n", "line 2"),
        ("v 0 0 0\nf 1/1 1 1\n", "the number of one of the 0 vt lines before"),
        ("v 0 0 0\nf 1 1 99999999999999999999999\n", "line 2"),
        ("v 0 0 0\nf 1 1 1/1/1/1\n", "line 2"),
        ("v 0 0 0\nwhat 1\n", "line 2: expected a keyword of OBJ"),
        ("# nothing\n", "expected vertices (v)"),
    ];
    for (obj, message) in cases {
        let error = error_of(obj.as_bytes(), Format::Obj);
        assert!(error.contains(message), "{error}");
    }
    let error = read_with(SAMPLE, &[("m.mtl", b"newmtl shiny\nKd red\n")]).unwrap_err().to_string();
    assert_eq!(error, "m.mtl: line 2: expected one or three finite numbers from 0 on, found 'Kd red'");
}

#[test]
fn many_uses_of_one_position_take_linear_time() {
    // 100 000 vertices at one position: a list searched along would take minutes here.
    let mut obj = "v 0 0 0\n".to_owned();
    for i in 1..=100_000 {
        obj.push_str(&format!("vt {i} 0\nf 1/{i} 1/1 1/{}\n", (i + 1) / 2));
    }
    assert_eq!(mesh_of(&obj).positions.len(), 100_000);
}
