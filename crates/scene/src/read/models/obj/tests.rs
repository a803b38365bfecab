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
    assert!(has("'wood.png' is missing") && has("groups (g)"), "{:?}", model.notes);
    let model = read_with(SAMPLE, &[]).unwrap();
    assert!(model.notes.iter().any(|note| note.contains("'m.mtl' is missing")), "{:?}", model.notes);
    assert!(model.notes.iter().any(|note| note.contains("'shiny' is not defined")), "{:?}", model.notes);
}

#[test]
fn height_maps_are_told_from_normal_maps() {
    let mtl = b"newmtl shiny\nmap_Bump -bm 0.5 wood.png\n";
    let read = |texel: [u8; 4]| {
        let picture = texture::tests::png(1, 1, &texel);
        read_with(SAMPLE, &[("m.mtl", mtl), ("wood.png", &picture)]).unwrap()
    };
    let model = read([128, 128, 255, 255]);
    assert_eq!(model.materials[0].normal_map.unwrap().scale, 0.5);
    assert!(!model.textures[0].srgb);
    // A grey picture, and a brown photo: of one texel they are flat.
    for texel in [[128, 128, 128, 255], [150, 110, 70, 255]] {
        let model = read(texel);
        assert_eq!(model.materials[0].normal_map.unwrap().scale, 0.5);
        assert_eq!(model.textures[0].rgba, [128, 128, 255, 255]);
        assert!(has_note(&model, "map_Bump is of heights"), "{:?}", model.notes);
    }
}

#[test]
fn errors_name_the_line_and_what_was_expected() {
    let cases = [
        ("v 0 0\n", "line 1: expected 'v' and three finite numbers, found 'v 0 0'"),
        ("v 0 0 0\nv 1 x 0\n", "line 2"),
        ("v 0 0 0\nf 1 1 2\n", "line 2: expected the number of one of the 1 v lines before"),
        ("v 0 0 0\nf 1 1 0\n", "line 2"),
        ("v 0 0 0\nf 1 1 -2\n", "line 2"),
        ("v 0 0 0\nf 1 1 99999999999999999999999\n", "line 2"),
        ("# nothing\n", "expected vertices (v)"),
        ("PK\x03\n", "line 1: expected a keyword of OBJ"),
    ];
    for (obj, message) in cases {
        let error = error_of(obj.as_bytes(), Format::Obj);
        assert!(error.contains(message), "{error}");
    }
}

/// A square in the plane z = 0 by two triangles.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

fn has_note(model: &Model, text: &str) -> bool {
    model.notes.iter().any(|note| note.contains(text))
}

/// The model of this text, which must have two triangles and a remark with this in it.
fn odd(obj: &str, note: &str) -> Model {
    let model = read_bytes(obj.as_bytes(), Format::Obj).unwrap();
    check(&model);
    assert_eq!(model.triangle_count(), 2, "{obj}");
    assert!(has_note(&model, note), "{note}: {:?}", model.notes);
    model
}

#[test]
fn lines_of_no_known_keyword_are_passed_over() {
    odd(
        &format!("$ drawn long ago\n{SQUARE}"),
        "'$' are not understood: '$ drawn long ago' is passed over (line 1)",
    );
    let skinned = SQUARE.replace("f 1 2", "vw 0 0 1\nvw 1 0 1\nf 1 2");
    odd(&skinned, "'vw 0 0 1' is passed over (2 times, first at line 5)");
}

#[test]
fn comments_stand_anywhere_and_are_never_continued() {
    let plain = mesh_of(SQUARE);
    let commented = SQUARE.replace("\n", " # of a square\n").replace("f 1 2 3", "f 1 2 3#c");
    assert_eq!(mesh_of(&commented), plain);
    let continued = SQUARE.replacen("f 1", "# C:\\models\\\nf 1", 1).replacen("1 3 4", "1 3 \\\n4", 1);
    assert_eq!(mesh_of(&continued), plain);
}

#[test]
fn byte_order_marks_and_ends_of_lines_are_of_any_kind() {
    let plain = mesh_of(SQUARE);
    for text in [format!("\u{feff}{SQUARE}"), SQUARE.replace('\n', "\r"), SQUARE.replace('\n', "\r\n")] {
        assert_eq!(mesh_of(&text), plain, "{text:?}");
    }
}

#[test]
fn positions_that_are_no_numbers_take_their_faces_along() {
    let unused = read_bytes(format!("{SQUARE}v nan inf 1e99\n").as_bytes(), Format::Obj).unwrap();
    assert_eq!((unused.triangle_count(), unused.notes.len()), (2, 0));
    let used = format!("{SQUARE}v 1.#QNAN 0 0\nf 1 2 5\nf 2 5 3\n");
    let model =
        odd(&used, "faces with positions that are no finite numbers are left out (2 times, first at line 8)");
    assert_eq!(model.meshes[0].positions.len(), 4);
}

#[test]
fn attributes_that_are_no_numbers_are_replaced() {
    let with =
        |attributes: &str, faces: &str| format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n{attributes}{faces}");
    let faces = "f 1/1/1 2/2/2 3/1/1\nf 1/1/1 3/1/1 4/1/1\n";
    let text = with("vt 0 1\nvt nan 0\nvn 0 0 1\nvn nan nan nan\n", faces);
    let model = odd(&text, "normals that are no finite numbers are computed from the faces (line 8)");
    assert!(has_note(&model, "texture coordinates that are no finite numbers are taken as 0 (line 6)"));
    assert_eq!(model.meshes[0].normals, [Vec3::Z; 4]);
    assert_eq!(model.meshes[0].uvs[1], Vec2::new(0.0, 1.0));
    let colored = SQUARE.replacen("v 1 1 0", "v 1 1 0 nan 0 0", 1).replacen("v 0 1 0", "v 0 1 0 0 1 0", 1);
    let model = odd(&colored, "colours of vertices that are no finite numbers are taken as white (line 3)");
    assert_eq!(model.meshes[0].colors[2].to_array(), [1.0; 4]);
    assert_eq!(model.meshes[0].colors[3].to_array(), [0.0, 1.0, 0.0, 1.0]);
    let bytes = SQUARE.replacen("v 1 1 0", "v 1 1 0 255 0 0", 1);
    odd(&bytes, "colours of vertices beyond 0 to 1");
}

#[test]
fn corners_leave_out_attributes_that_are_not_there() {
    let text = SQUARE.replace("f 1 2 3", "vt 0 0\nf 1/1/1 2/9/7 3/-4/0");
    let model = odd(&text, "corners name vt lines that are not there");
    assert!(has_note(
        &model,
        "corners name vn lines that are not there: they are taken without them (3 times"
    ));
    assert!(model.meshes[0].normals.is_empty());
    odd(&SQUARE.replace("f 1 2 3", "f 1/1/1/1 2 3"), "only the first three numbers");
}

#[test]
fn smoothing_groups_count_where_there_are_no_normals() {
    // Two squares with a fold of 90° between them, and one with a fold of 30°.
    let fold = |s: &str, degrees: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let obj = format!(
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv {} 0 {}\nv {} 1 {}\n{s}\nf 1 2 3 4\nf 2 5 6 3\n",
            1.0 + cos,
            sin,
            1.0 + cos,
            sin
        );
        let mesh = mesh_of(&obj);
        let at = |corner: usize| mesh.normals.get(mesh.corners[corner] as usize).copied();
        (at(1), at(4), mesh.positions.len())
    };
    for degrees in [30.0, 90.0] {
        let (one, other, count) = fold("s off", degrees);
        assert!(one != other && one == Some(Vec3::Z) && count == 8, "{one:?} {other:?}");
        let (one, other, count) = fold("s 1", degrees);
        assert!(one == other && one != Some(Vec3::Z) && count == 6, "{one:?} {other:?}");
        assert_eq!(fold("", degrees), (None, None, 6));
    }
    let (one, other, _) = fold("s 1\ns 2\ns 0", 30.0);
    assert_ne!(one, other);
}

#[test]
fn concave_polygons_and_closed_lists_are_cut_at_their_notches() {
    let dart = "v 0 2 0\nv -2 -2 0\nv 0 -1 0\nv 2 -2 0\nf 2 3 4 1 2\n";
    let mesh = mesh_of(dart);
    assert_eq!(mesh.face(0).len(), 4);
    let areas: Vec<f32> = mesh
        .triangles()
        .map(|t| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            (b - a).cross(c - a).z / 2.0
        })
        .collect();
    assert_eq!(areas, [3.0, 3.0]);
}

/// The only material of an MTL text, whose name is `a`, and the remarks.
fn material_of(mtl: &str, files: &[(&str, &[u8])]) -> (crate::Material, Vec<String>) {
    let obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
    let mtl = format!("newmtl a\n{mtl}");
    let all: Vec<(&str, &[u8])> = files.iter().copied().chain([("m.mtl", mtl.as_bytes())]).collect();
    let mut model = read_with(obj, &all).unwrap();
    check(&model);
    (model.materials.swap_remove(0), model.notes)
}

fn lobe_names(material: &crate::Material) -> Vec<&str> {
    material.lobes.iter().map(|lobe| lobe.shape.info().name).collect()
}

#[test]
fn a_highlight_needs_an_exponent() {
    for (mtl, has) in [
        ("Ks 1 1 1\nNs 0\n", false),
        ("Ks 1 1 1\n", false),
        ("Ks 1\nNs 0.5\n", false),
        ("Ks 1\nNs 1\n", true),
    ] {
        let (material, notes) = material_of(mtl, &[]);
        assert_eq!(lobe_names(&material).contains(&"blinn-phong"), has, "{mtl}");
        let said = notes.iter().any(|note| note.contains("exponent (Ns)") && note.contains("material 'a'"));
        assert_eq!(said, !has, "{notes:?}");
    }
    let (_, notes) = material_of("Ns 0\n", &[]);
    assert!(notes.is_empty(), "{notes:?}");
}

#[test]
fn opacity_is_d_or_else_one_less_tr() {
    let cases = [
        ("d 0.25\n", 0.25, ""),
        ("d 0.25\nTr 0.1\n", 0.25, ""),
        ("Tr 1\nd 1\n", 1.0, ""),
        ("Tr 1\n", 1.0, "'Tr 1' without 'd' is taken as opaque"),
        ("Tr 0\n", 1.0, ""),
        ("Tr 0.25\n", 0.75, "'Tr' without 'd' is taken as 1 less the opacity"),
        ("d 0\n", 0.0, "fully transparent (d 0): nothing of it is seen (material 'a')"),
    ];
    for (mtl, opacity, note) in cases {
        let (material, notes) = material_of(mtl, &[]);
        assert_eq!(material.opacity, opacity, "{mtl}");
        assert_eq!(material.alpha_mode == AlphaMode::Blend, opacity < 1.0);
        assert_eq!(notes.len(), usize::from(!note.is_empty()), "{notes:?}");
        assert!(notes.iter().all(|found| found.contains(note)), "{notes:?}");
    }
}

#[test]
fn statements_that_make_no_sense_are_passed_over() {
    let diffuse = |material: &crate::Material| {
        material
            .lobes
            .iter()
            .find_map(|lobe| (lobe.shape.info().name == "lambert").then(|| lobe.tint.rgb())?)
    };
    let odd = ["Kd red", "Kd nan 0 0", "Ns x", "d", "map_Kd", "illum two", "Kd spectral red.rfl 1", "Tr nan"];
    for line in odd {
        let (material, notes) = material_of(&format!("Kd 0.5\n{line}\n"), &[]);
        assert_eq!(diffuse(&material), Some(Rgb::gray(0.5)), "{line}");
        assert!(
            notes[0].contains(&format!("'{line}' is not understood and passed over (m.mtl, line 3)")),
            "{notes:?}"
        );
    }
    let (material, notes) = material_of("Kd xyz 0.2 0.1 0.05\n", &[]);
    let Rgb([r, g, b]) = diffuse(&material).unwrap();
    assert!((r - 0.4697).abs() < 1e-3 && (g - 0.0).abs() < 1e-3 && (b - 0.0433).abs() < 1e-3, "{r} {g} {b}");
    assert!(notes.iter().any(|note| note.contains("xyz are converted")), "{notes:?}");
    let (material, notes) = material_of("Kd -0.5 0.25 1 # dark\n", &[]);
    assert_eq!(diffuse(&material), Some(Rgb([0.0, 0.25, 1.0])));
    assert_eq!(notes.len(), 1);
    let early = read_with("mtllib m.mtl\nv 0 0 0\n", &[("m.mtl", b"Kd 1\nnewmtl a\n")]).unwrap();
    assert!(has_note(&early, "before the first 'newmtl'"));
}

#[test]
fn names_keep_a_number_sign_unless_it_begins_a_comment() {
    let obj = "mtllib m.mtl # the file\nv 0 0 0\nusemtl Material #25\nf 1 1 1\nusemtl red # one\nf 1 1 1\n";
    let mtl = b"newmtl Material #24\nKd 0\nnewmtl Material #25\nKd 0.5\nnewmtl red\nKd 1 0 0\n";
    let model = read_with(obj, &[("m.mtl", mtl)]).unwrap();
    let names: Vec<&str> = model.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["Material #25", "red"]);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
}

#[test]
fn a_picture_is_not_multiplied_by_black() {
    let png = texture::tests::png(1, 1, &[200, 100, 50, 255]);
    let (material, notes) = material_of("Kd 0 0 0\nmap_Kd w.png\n", &[("w.png", &png)]);
    let (white, _) = material_of("Kd 1 1 1\nmap_Kd w.png\n", &[("w.png", &png)]);
    assert_eq!(material, white);
    assert!(notes.iter().any(|note| note.contains("is taken as 1 1 1")), "{notes:?}");
    let (black, notes) = material_of("Kd 0 0 0\n", &[]);
    assert!(black != white && !notes.iter().any(|note| note.contains("is taken as 1 1 1")));
}

#[test]
fn pictures_of_other_machines_are_looked_for_beside_the_model() {
    let wood = texture::tests::png(1, 1, &[10, 20, 30, 255]);
    let mtl = "map_Kd C:\\Users\\somebody\\wood.png\n";
    let (material, notes) = material_of(mtl, &[("wood.png", &wood)]);
    assert!(material.base_color.is_some());
    assert!(notes[0].contains("is missing: 'wood.png' beside the model is taken"), "{notes:?}");
    let (material, notes) = material_of(mtl, &[]);
    assert!(material.base_color.is_none() && notes[0].contains("is missing: it is left out"), "{notes:?}");
    for bytes in [&b"GIF89a"[..], &wood[..wood.len() - 20]] {
        let (material, notes) = material_of(mtl, &[("wood.png", bytes)]);
        assert!(material.base_color.is_none() && notes.len() == 2, "{notes:?}");
        assert!(notes[1].contains("wood.png' is not") || notes[1].contains("cannot be decoded"), "{notes:?}");
    }
}

#[test]
fn heights_become_normals_that_lean_down_the_slope() {
    // Four columns that rise to the right and fall back; four rows alike.
    let ramp = |code: fn(usize) -> u8| -> Vec<u8> {
        (0..16).flat_map(|i| [code(i), code(i), code(i), 255]).collect()
    };
    let normals = |heights: &[u8], options: &str| {
        let picture = texture::tests::png(4, 4, heights);
        let mtl = format!("newmtl shiny\nmap_Bump {options} wood.png\n");
        let model = read_with(SAMPLE, &[("m.mtl", mtl.as_bytes()), ("wood.png", &picture)]).unwrap();
        model.textures[0].rgba.clone()
    };
    // One column to the next is 51 / 255 · 2 texels: slopes of 0.4.
    let right = normals(&ramp(|i| (i % 4 * 51) as u8), "-clamp on");
    let length = 1.16_f32.sqrt();
    let code = |value: f32| ((value / length * 0.5 + 0.5) * 255.0).round() as u8;
    assert_eq!(right[4..8], [code(-0.4), 128, code(1.0), 255]);
    // Rows that rise downwards lean up.
    let down = normals(&ramp(|i| (i / 4 * 51) as u8), "-clamp on");
    assert_eq!(down[16..20], [128, code(0.4), code(1.0), 255]);
    // Without a clamp the borders see each other.
    let wrapped = normals(&ramp(|i| (i % 4 * 51) as u8), "");
    assert!(wrapped[0] > 128 && right[0] < 128, "{wrapped:?}");
}

#[test]
fn a_picture_of_opacity_becomes_the_alpha_of_the_colours() {
    let color = texture::tests::png(2, 1, &[10, 20, 30, 255, 40, 50, 60, 255]);
    let by_color = texture::tests::png(1, 1, &[51, 51, 51, 255]);
    let by_alpha = texture::tests::png(2, 1, &[255, 255, 255, 0, 255, 255, 255, 128]);
    let read = |mtl: &str| {
        let obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
        let mtl = format!("newmtl a\n{mtl}");
        let files: [(&str, &[u8]); 4] =
            [("m.mtl", mtl.as_bytes()), ("c.png", &color), ("g.png", &by_color), ("a.png", &by_alpha)];
        let model = read_with(obj, &files).unwrap();
        let material = &model.materials[0];
        assert_eq!(
            material.alpha_mode == AlphaMode::Blend,
            material.base_color.is_some_and(|m| m.texture > 0) || !mtl.contains("map_Kd")
        );
        let map = material.base_color.unwrap();
        (model.textures[map.texture].rgba.clone(), model.notes)
    };
    assert_eq!(read("map_Kd c.png\nmap_d g.png\n").0, [10, 20, 30, 51, 40, 50, 60, 51]);
    assert_eq!(read("map_Kd c.png\nmap_d a.png\n").0, [10, 20, 30, 0, 40, 50, 60, 128]);
    assert_eq!(read("map_d g.png\n").0, [255, 255, 255, 51]);
    let (rgba, notes) = read("map_Kd c.png\nmap_d -s 2 2 2 g.png\n");
    assert_eq!(rgba, [10, 20, 30, 255, 40, 50, 60, 255]);
    assert!(notes[0].contains("map_d is ignored"), "{notes:?}");
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
