use glam::{Vec2, Vec3};

use crate::Mesh;
use crate::read::Format;
use crate::read::tests::{check, error_of, read_bytes};

const HEADER: &str = "comment made by a test
element vertex 4
property float x
property double y
property short z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property float s
property float t
property list uchar int extra
element material 1
property int index
element face 2
property uchar flags
property list uchar uint vertex_indices
end_header
";

const BODY: &str = "0 0 0 0 0 1 255 0 0 0 0 0
1 0 0 0 0 1 255 0 0 1 0 1 7
1 1 0 0 0 1 255 0 0 1 1 0

0 1 0 0 0 1 128 0 0 0 1 2 5 6
1
9 4 0 1 2 3
9 3 0 1 2
";

/// The body of the sample, in binary.
fn binary_body(big: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut put = |little: &[u8]| {
        let mut word = little.to_vec();
        if big {
            word.reverse();
        }
        bytes.extend(word);
    };
    let vertices: [([f32; 2], u8, &[i32]); 4] =
        [([0.0, 0.0], 255, &[]), ([1.0, 0.0], 255, &[7]), ([1.0, 1.0], 255, &[]), ([0.0, 1.0], 128, &[5, 6])];
    for ([x, y], red, extra) in vertices {
        put(&x.to_le_bytes());
        put(&f64::from(y).to_le_bytes());
        put(&0i16.to_le_bytes());
        [0.0f32, 0.0, 1.0].iter().for_each(|value| put(&value.to_le_bytes()));
        [red, 0, 0].iter().for_each(|value| put(&[*value]));
        [x, y].iter().for_each(|value| put(&value.to_le_bytes()));
        put(&[extra.len() as u8]);
        extra.iter().for_each(|value| put(&value.to_le_bytes()));
    }
    put(&1i32.to_le_bytes());
    for face in [&[0u32, 1, 2, 3][..], &[0, 1, 2]] {
        put(&[9]);
        put(&[face.len() as u8]);
        face.iter().for_each(|value| put(&value.to_le_bytes()));
    }
    bytes
}

/// The same mesh in all three encodings.
pub(crate) fn samples() -> [Vec<u8>; 3] {
    let header = |format: &str| format!("ply\nformat {format} 1.0\n{HEADER}").into_bytes();
    [
        [header("ascii"), BODY.as_bytes().to_vec()].concat(),
        [header("binary_little_endian"), binary_body(false)].concat(),
        [header("binary_big_endian"), binary_body(true)].concat(),
    ]
}

fn mesh_of(bytes: &[u8]) -> Mesh {
    let model = read_bytes(bytes, Format::Ply).unwrap();
    check(&model);
    model.meshes.into_iter().next().unwrap()
}

#[test]
fn the_three_encodings_mean_the_same() {
    let [text, little, big] = samples().map(|bytes| mesh_of(&bytes));
    assert_eq!(text.positions, [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y]);
    assert_eq!(text.normals, [Vec3::Z; 4]);
    assert_eq!(text.uvs[2], Vec2::new(1.0, 0.0));
    assert!((text.colors[3].x - 0.215_861).abs() < 1e-6 && text.colors[0].x == 1.0);
    assert_eq!((&text.corners[..], &text.face_starts[..]), (&[0, 1, 2, 3, 0, 1, 2][..], &[0, 4, 7][..]));
    assert_eq!(text, little);
    assert_eq!(text, big);
}

#[test]
fn what_is_skipped_is_noted() {
    let notes = read_bytes(&samples()[0], Format::Ply).unwrap().notes;
    for text in ["'extra' of 'vertex'", "element 'material'", "'flags' of 'face'"] {
        assert!(notes.iter().any(|note| note.contains(text)), "{notes:?}");
    }
}

fn ascii(header: &str, body: &str) -> Vec<u8> {
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let header = header.replace("XYZ", xyz).replace("LIST", "property list uchar int vertex_index\n");
    format!("ply\nformat ascii 1.0\n{header}end_header\n{body}").into_bytes()
}

#[test]
fn strips_become_triangles_that_keep_their_side() {
    let bytes = ascii(
        "element vertex 4\nXYZelement tristrips 1\nLIST",
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 -1 3 2 1 -1\n",
    );
    assert_eq!(mesh_of(&bytes).corners, [0, 1, 2, 2, 1, 3, 3, 2, 1]);
}

#[test]
fn faces_may_come_before_their_vertices() {
    let bytes = ascii("element face 1\nLISTelement vertex 3\nXYZ", "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n");
    assert_eq!(mesh_of(&bytes).corners, [0, 1, 2]);
}

#[test]
fn a_billion_claimed_vertices_are_one_error() {
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let bytes = format!(
            "ply\nformat {format} 1.0\nelement vertex 1000000000\nproperty float x\nproperty float y\n\
             property float z\nend_header\n"
        );
        let error = error_of(bytes.as_bytes(), Format::Ply);
        assert!(error.contains("as the header tells") && error.contains("end of the file"), "{error}");
    }
}

#[test]
fn a_list_of_four_billion_corners_ends_with_the_file() {
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n\
                  property float z\nelement face 1\nproperty list uint uint vertex_indices\nend_header\n";
    let bytes = [header.as_bytes(), &u32::MAX.to_le_bytes(), &[0; 40]].concat();
    assert!(error_of(&bytes, Format::Ply).contains("face 0"));
    let empty =
        header.replace("property list uint uint vertex_indices\n", "").replace("face 1", "face 4000000000");
    assert!(error_of(empty.as_bytes(), Format::Ply).contains("'vertex_indices'"));
    let nothing = header
        .replace("face 1", "nothing 4000000000")
        .replace("property list uint uint vertex_indices\n", "");
    assert!(read_bytes(nothing.as_bytes(), Format::Ply).is_ok());
}

#[test]
fn errors_name_place_and_expectation() {
    let cases: [(Vec<u8>, &str); 10] = [
        (b"plx\n".to_vec(), "line 1: expected 'ply'"),
        (
            b"ply\nformat ascii 1.0\nelement vertex -1\n".to_vec(),
            "line 3: expected 'element', a name and a count",
        ),
        (b"ply\nformat ascii 1.0\nproperty int x\n".to_vec(), "line 3: expected 'property'"),
        (b"ply\nformat odd 1.0\n".to_vec(), "line 2: expected ascii"),
        (b"ply\nformat ascii 1.0\nelement vertex 1\nend_header\n".to_vec(), "properties x, y and z"),
        (
            ascii("element vertex 1\nXYZ", "0 0\n"),
            "line 8: expected a finite number, found the end of the line",
        ),
        (ascii("element vertex 1\nXYZ", "0 0 x\n"), "line 8: expected a finite number, found 'x'"),
        (
            ascii("element vertex 1\nXYZproperty uchar red\n", "0 0 0 256\n"),
            "line 9: expected a whole number of the type",
        ),
        (
            ascii("element vertex 1\nXYZelement face 1\nLIST", "0 0 0\n3 0 0 1\n"),
            "face 0: expected numbers of vertices below 1, found 1",
        ),
        (
            ascii("element vertex 1\nXYZelement face 1\nLIST", "0 0 0\n3 0 0 -2\n"),
            "line 11: expected the number of a vertex",
        ),
    ];
    for (bytes, message) in cases {
        let error = error_of(&bytes, Format::Ply);
        assert!(error.contains(message), "{error}");
    }
}

/// A square of two triangles, whose header and lines are changed in this way.
fn square(changes: &[(&str, &str)]) -> Vec<u8> {
    let mut text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                    element face 2\nproperty list uchar int vertex_indices\nend_header\n\
                    0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
            .to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    text.into_bytes()
}

#[test]
fn byte_order_marks_ends_of_lines_and_unknown_lines_do_no_harm() {
    let plain = mesh_of(&square(&[]));
    let text = String::from_utf8(square(&[])).unwrap();
    for text in [format!("\u{feff}{text}"), text.replace('\n', "\r"), text.replace('\n', "\r\n")] {
        assert_eq!(mesh_of(text.as_bytes()), plain, "{text:?}");
    }
    // A body whose first byte is a line feed, behind a header whose lines end with CR.
    let [_, little, _] = samples();
    let end = little.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let header: Vec<u8> = little[..end].iter().map(|b| if *b == b'\n' { b'\r' } else { *b }).collect();
    let mut body = little[end..].to_vec();
    body[0] = b'\n';
    let mesh = mesh_of(&[header, body].concat());
    assert!(mesh.positions[0].x > 0.0 && mesh.positions[1] == Vec3::X);
    let model =
        read_bytes(&square(&[("element vertex", "written by hand\nelement vertex")]), Format::Ply).unwrap();
    assert!(model.notes[0].contains("'written by hand' is not understood and passed over (line 3)"));
}

#[test]
fn what_is_no_number_is_left_out_or_replaced() {
    let unused = square(&[("vertex 4", "vertex 5"), ("3 0 1 2", "nan inf 1e99\n3 0 1 2")]);
    let model = read_bytes(&unused, Format::Ply).unwrap();
    check(&model);
    assert_eq!((model.triangle_count(), model.notes.len()), (2, 0));
    let used = read_bytes(&square(&[("0 1 0\n3", "0 nan 0\n3")]), Format::Ply).unwrap();
    check(&used);
    assert_eq!(used.triangle_count(), 1);
    assert!(used.notes[0].contains("no finite numbers are left out"), "{:?}", used.notes);
    let more = "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\n\
                property float t\nproperty float red\nproperty float green\nproperty float blue";
    let odd = square(&[
        ("property float z", more),
        ("0 0 0\n", "0 0 0 0 0 1 0 0 1 1 1\n"),
        ("1 0 0\n", "1 0 0 nan 0 1 inf 0 nan 1 1\n"),
        ("1 1 0\n", "1 1 0 0 0 1 0 0 1 1 1\n"),
        ("0 1 0\n3", "0 1 0 0 0 1 0 0 1 1 1\n3"),
    ]);
    let model = read_bytes(&odd, Format::Ply).unwrap();
    check(&model);
    let mesh = &model.meshes[0];
    assert_eq!((mesh.normals[1], mesh.uvs[1], mesh.colors[1]), (Vec3::Z, Vec2::ZERO, glam::Vec4::ONE));
    for what in ["normals", "texture coordinates", "colours"] {
        assert!(
            model.notes.iter().any(|note| note.contains(what) && note.contains("line ")),
            "{:?}",
            model.notes
        );
    }
}

#[test]
fn faces_have_colours_and_texture_coordinates_of_their_own() {
    let list = "property list uchar int vertex_indices\n";
    let more = format!(
        "{list}property list uchar float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    );
    let bytes = square(&[
        (list, &more),
        ("3 0 1 2\n", "3 0 1 2 6 0 0 1 0 1 1 255 0 0\n"),
        ("3 0 2 3\n", "3 0 2 3 6 0 0 1 1 0.5 1 0 255 0\n"),
    ]);
    let mesh = mesh_of(&bytes);
    let at = |corner: usize| mesh.corners[corner] as usize;
    let uvs: Vec<[f32; 2]> = (0..6).map(|corner| mesh.uvs[at(corner)].to_array()).collect();
    assert_eq!(uvs, [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.0], [0.5, 0.0]]);
    let red = |corner: usize| mesh.colors[at(corner)].to_array();
    assert!((0..3).all(|c| red(c) == [1.0, 0.0, 0.0, 1.0]) && (3..6).all(|c| red(c) == [0.0, 1.0, 0.0, 1.0]));
    let odd = square(&[
        (list, &format!("{list}property list uchar float texcoord\n")),
        ("3 0 1 2\n", "3 0 1 2 4 0 0 1 0\n"),
        ("3 0 2 3\n", "3 0 2 3 6 0 0 1 1 nan 1\n"),
    ]);
    let model = read_bytes(&odd, Format::Ply).unwrap();
    check(&model);
    assert!(model.notes[0].contains("do not fit their face are taken as 0 (2 times"), "{:?}", model.notes);
}

#[test]
fn faces_whose_lines_are_longer_than_the_header_tells_have_no_colour() {
    let list = "property list uchar int vertex_indices\n";
    let colors = format!("{list}property uchar red\nproperty uchar green\nproperty uchar blue\n");
    let bytes = square(&[
        (list, &colors),
        ("3 0 1 2\n", "3 0 1 2 6 1 1 1 1 1 1 255 0 0 255\n"),
        ("3 0 2 3\n", "3 0 2 3 0 255 0\n"),
    ]);
    let model = read_bytes(&bytes, Format::Ply).unwrap();
    check(&model);
    let mesh = &model.meshes[0];
    let color = |corner: usize| mesh.colors[mesh.corners[corner] as usize].to_array();
    assert_eq!([color(0), color(3)], [[1.0; 4], [0.0, 1.0, 0.0, 1.0]]);
    assert!(model.notes.iter().any(|note| note.contains("have no colour, since")), "{:?}", model.notes);
}

#[test]
fn the_texture_that_a_comment_names_is_used() {
    let comment = ("element vertex", "comment TextureFile some where.png\nelement vertex");
    let list = "property list uchar int vertex_indices\n";
    let wedge = format!("{list}property list uchar float texcoord\n");
    let textured = square(&[
        comment,
        (list, &wedge),
        ("3 0 1 2\n", "3 0 1 2 6 0 0 1 0 1 1\n"),
        ("3 0 2 3\n", "3 0 2 3 6 0 0 1 1 0 1\n"),
    ]);
    let picture = crate::read::texture::tests::png(1, 1, &[10, 20, 30, 255]);
    let read = |bytes: &[u8], name: &str| {
        let files = std::collections::HashMap::from([(name.to_owned(), picture.clone())]);
        let model =
            crate::read::read_model_bytes(bytes, Format::Ply, "file", &files, &Default::default()).unwrap();
        check(&model);
        model
    };
    let model = read(&textured, "some where.png");
    assert_eq!((model.textures.len(), model.notes.len()), (1, 0));
    assert_eq!(model.materials[0].base_color.map(|map| map.texture), Some(0));
    let missing = read(&textured, "other.png");
    assert!(
        missing.textures.is_empty()
            && missing.notes[0].contains("'some where.png' is missing: it is left out (line 3)")
    );
    let bare = read(&square(&[comment]), "some where.png");
    assert!(bare.notes[0].contains("no texture coordinates"), "{:?}", bare.notes);
}

#[test]
fn more_values_in_a_line_than_the_header_tells_are_passed_over() {
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                element face 1\nproperty list uchar int vertex_indices\nend_header\n\
                0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2 255 255 255\n";
    let model = read_bytes(text.as_bytes(), Format::Ply).unwrap();
    check(&model);
    assert_eq!(model.triangle_count(), 1);
    let told = "PLY: more values in a line than the header tells are passed over (2 lines) (line 11)";
    assert!(model.notes.iter().any(|note| note == told), "{:?}", model.notes);
}
