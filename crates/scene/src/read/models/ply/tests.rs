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
    let cases: [(Vec<u8>, &str); 11] = [
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
        (ascii("element vertex 1\nXYZ", "0 0 inf\n"), "line 8: expected a finite number, found 'inf'"),
        (
            ascii("element vertex 1\nXYZproperty uchar red\n", "0 0 0 256\n"),
            "line 9: expected a whole number of the type",
        ),
        (ascii("element vertex 1\nXYZ", "0 0 0 0\n"), "line 8: expected no more values"),
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
