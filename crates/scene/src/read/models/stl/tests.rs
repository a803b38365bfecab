use glam::Vec3;

use super::*;
use crate::Mesh;
use crate::read::Format;
use crate::read::tests::{check, error_of, read_bytes};

pub(crate) const TEXT: &str = "solid two words
facet normal 0 0 1
  outer loop
    vertex 0 0 0
    vertex 1 0 0
    vertex 0 1 0
  endloop
endfacet
FACET NORMAL 0 0 0
  OUTER LOOP
    VERTEX 1 0 -0
    VERTEX 1 1e0 0
    VERTEX 0 1 0
  ENDLOOP
ENDFACET
endsolid two words
";

/// The same two facets in binary, after a header that begins as text does.
pub(crate) fn binary() -> Vec<u8> {
    let mut bytes = b"solid but binary".to_vec();
    bytes.resize(80, 0);
    bytes.extend(2u32.to_le_bytes());
    for corners in
        [[0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], [1.0, 0.0, -0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]]
    {
        bytes.extend([0; 12]);
        corners.iter().for_each(|value| bytes.extend(value.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn text_and_binary_mean_the_same_and_corners_are_joined() {
    let read = |bytes: &[u8]| {
        let model = read_bytes(bytes, Format::Stl).unwrap();
        check(&model);
        model.meshes
    };
    let (text, binary) = (read(TEXT.as_bytes()), read(&binary()));
    assert_eq!(text[0].corners, [0, 1, 2, 1, 3, 2]);
    assert_eq!(text[0].positions.len(), 4);
    assert_eq!((&text[0].name[..], &binary[0].name[..]), ("two words", "solid but binary"));
    assert_eq!((&text[0].corners, &text[0].positions), (&binary[0].corners, &binary[0].positions));
}

#[test]
fn solids_become_meshes() {
    let model = read_bytes(format!("{TEXT}{TEXT}solid\nendsolid\n").as_bytes(), Format::Stl).unwrap();
    assert_eq!(model.meshes.iter().map(Mesh::face_count).collect::<Vec<_>>(), [2, 2, 0]);
}

#[test]
fn a_billion_claimed_facets_are_one_error() {
    let mut bytes = vec![0; 100];
    bytes[80..84].copy_from_slice(&1_000_000_000u32.to_le_bytes());
    let error = error_of(&bytes, Format::Stl);
    assert_eq!(
        error,
        "file: byte 80: expected 50000000084 bytes for the 1000000000 facets that are told here (read as binary, since it is no text that begins with 'solid'), found 100 bytes"
    );
}

#[test]
fn errors_name_place_and_expectation() {
    let broken = |from: &str, to: &str| error_of(TEXT.replacen(from, to, 1).as_bytes(), Format::Stl);
    assert!(broken("vertex 0 0 0", "vertex 0 0 x").contains("line 4: expected three numbers after 'vertex'"));
    assert!(broken("    vertex 0 0 0\n", "").contains("line 6: expected three or more 'vertex'"));
    assert!(broken("outer", "inner").contains("line 3: expected 'outer loop' (read as text, since"));
    assert!(error_of(&TEXT.as_bytes()[..65], Format::Stl).contains("found the end of the file"));
    let error = error_of(b"", Format::Stl);
    assert!(error.contains("a text that begins with 'solid', or a binary header of 84 bytes"), "{error}");
}

/// The two facets of `TEXT`, whatever the text looks like.
fn read_same(text: &[u8]) -> Model {
    let model = read_bytes(text, Format::Stl).unwrap_or_else(|error| panic!("{error}"));
    check(&model);
    let expected = read_bytes(TEXT.as_bytes(), Format::Stl).unwrap();
    assert_eq!(model.meshes[0].corners, expected.meshes[0].corners);
    assert_eq!(model.meshes[0].positions, expected.meshes[0].positions);
    model
}

#[test]
fn text_is_words_whatever_separates_them_and_in_any_case() {
    let dialects = [
        TEXT.to_uppercase(),
        format!("\u{feff}{TEXT}"),
        TEXT.replace('\n', " "),
        TEXT.replace('\n', "\r"),
        TEXT.replace("end", "end "),
        TEXT.replace("END", "end ").replace("outer loop", "outerloop"),
        TEXT.split_whitespace().collect::<Vec<_>>().join("\n").replacen(
            "solid\ntwo\nwords",
            "solid two words",
            1,
        ),
        format!("\n\n  {TEXT}"),
    ];
    for text in dialects {
        let model = read_same(text.as_bytes());
        assert_eq!(model.meshes.len(), 1, "{text}");
        assert!(model.meshes[0].name.eq_ignore_ascii_case("two words"), "{text}: {}", model.meshes[0].name);
    }
    let twice = format!("{TEXT}{TEXT}").replace('\n', " ");
    assert_eq!(read_same(twice.as_bytes()).meshes.len(), 2);
}

#[test]
fn what_text_has_beside_its_facets_is_remarked() {
    let has = |model: &Model, text: &str| model.notes.iter().any(|note| note.contains(text));
    let with_color = TEXT.replacen("facet normal 0", "color 0.5 0.5 0.5\nfacet normal nan", 1);
    assert!(has(
        &read_same(with_color.as_bytes()),
        "'color' is not understood: 'color 0.5 0.5 0.5' is passed over (line 2)"
    ));
    let open = TEXT.replace("endsolid two words\n", "");
    assert!(has(&read_same(open.as_bytes()), "the last solid has no 'endsolid'"));
    let bare = TEXT.replacen("solid two words\n", "", 1);
    assert!(has(&read_same(bare.as_bytes()), "does not begin with 'solid'"));
    let nan = format!(
        "solid\nfacet normal 0 0 1 outer loop vertex nan 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet{}",
        &TEXT[15..]
    );
    assert!(has(
        &read_same(nan.as_bytes()),
        "facets with positions that are no finite numbers are left out (line 2)"
    ));
}

#[test]
fn binary_facets_that_are_no_numbers_are_left_out() {
    let mut bytes = binary();
    bytes[84 + 12..84 + 16].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let model = read_bytes(&bytes, Format::Stl).unwrap();
    check(&model);
    assert_eq!(model.meshes[0].face_count(), 1);
    assert!(model.notes[0].contains("no finite numbers are left out (facet 0)"), "{:?}", model.notes);
}

/// The two facets with these words after them and this beginning.
fn colored(head: &[u8], words: [u16; 2]) -> Model {
    let mut bytes = binary();
    bytes[..head.len()].copy_from_slice(head);
    for (facet, word) in words.into_iter().enumerate() {
        bytes[84 + 50 * facet + 48..][..2].copy_from_slice(&word.to_le_bytes());
    }
    let model = read_bytes(&bytes, Format::Stl).unwrap();
    check(&model);
    model
}

#[test]
fn colours_of_facets_are_read_in_both_dialects() {
    let of = |model: &Model, facet: usize| {
        let mesh = &model.meshes[0];
        let colors = mesh.face(facet).iter().map(|&v| mesh.colors[v as usize].truncate().to_array());
        let colors: Vec<[f32; 3]> = colors.collect();
        assert!(colors.iter().all(|color| *color == colors[0]), "{colors:?}");
        colors[0]
    };
    let has = |model: &Model, text: &str| model.notes.iter().any(|note| note.contains(text));
    let magics = colored(b"COLOR=\xff\x00\xff\xff", [0x001f, 0x8000]);
    assert_eq!((of(&magics, 0), of(&magics, 1)), ([1.0, 0.0, 0.0], [1.0, 0.0, 1.0]));
    assert!(has(&magics, "colours of facets are read as Magics writes them"));
    let other = colored(b"", [0x801f, 0x03e0]);
    assert_eq!((of(&other, 0), of(&other, 1)), ([0.0, 0.0, 1.0], [1.0, 1.0, 1.0]));
    assert!(has(&other, "colours of facets are read as VisCAM and SolidView write them"));
    let vcg = colored(b"COLOR=\x00\xff\x00 MATERIAL=", [0x801f, 0x0000]);
    assert_eq!((of(&vcg, 0), of(&vcg, 1)), ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    assert!(has(&vcg, "as MeshLab writes them"));
    // Writers that know no colours: the bytes of all facets are 0, or all have the bit alone.
    for (head, words) in [
        (&b"COLOR=\x7f\x7f\x7f MATERIAL="[..], [0, 0]),
        (b"COLOR=\xff\x00\xff\xff", [0, 0]),
        (b"STLB", [0x8000, 0x8000]),
    ] {
        let plain = colored(head, words);
        assert!(plain.meshes[0].colors.is_empty() && !has(&plain, "facets are read"), "{:?}", plain.notes);
    }
    let none = colored(b"", [0x1234, 0]);
    assert!(none.meshes[0].colors.is_empty() && has(&none, "bytes after facets"));
    assert!(!colored(b"", [0, 0]).notes.iter().any(|note| note.contains("facets are read")));
}

#[test]
fn what_the_file_was_taken_for_is_told_in_errors() {
    let error = error_of(&[0xff; 60], Format::Stl);
    assert!(error.contains("or a binary header"), "{error}");
    let mut bytes = vec![0; 100];
    bytes[80] = 9;
    let error = error_of(&bytes, Format::Stl);
    assert!(error.contains("read as binary"), "{error}");
}

/// A plate of 10 by 10 with a bevel of this many degrees around its top, as STL text.
fn plate(degrees: f64) -> String {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let ring = |inset: f64, y: f64| {
        [[-5.0, -5.0], [5.0, -5.0], [5.0, 5.0], [-5.0, 5.0]]
            .map(|[x, z]: [f64; 2]| [x - inset * x.signum(), y, z - inset * z.signum()])
    };
    let (low, high) = (ring(0.0, 0.0), ring(0.5 * cos, 0.5 * sin));
    let mut triangles = vec![[high[0], high[2], high[1]], [high[0], high[3], high[2]]];
    for i in 0..4 {
        let j = (i + 1) % 4;
        triangles.push([low[i], high[i], high[j]]);
        triangles.push([low[i], high[j], low[j]]);
    }
    let mut text = "solid plate\n".to_owned();
    for triangle in triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in triangle {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid plate\n"
}

#[test]
fn large_flat_faces_stay_flat_to_their_rims() {
    for degrees in [10.0, 25.0, 45.0, 80.0] {
        let model = read_bytes(plate(degrees).as_bytes(), Format::Stl).unwrap();
        check(&model);
        let mesh = &model.meshes[0];
        for face in 0..2 {
            let normals: Vec<Vec3> = mesh.face(face).iter().map(|&v| mesh.normals[v as usize]).collect();
            assert!(normals.iter().all(|normal| normal.distance(Vec3::Y) < 1e-6), "{degrees}: {normals:?}");
        }
        // Below the crease the bevel bends towards the top, above it is flat.
        let bevel = mesh.face(2).iter().map(|&v| mesh.normals[v as usize]).collect::<Vec<_>>();
        assert_eq!(bevel[1].distance(bevel[0]) > 1e-3, degrees < 30.0, "{degrees}: {bevel:?}");
    }
}

#[test]
fn facets_at_exactly_the_crease_have_an_edge_and_finer_ones_none() {
    let drum = |sides: usize| {
        let at = |i: usize, y: f64| {
            let (sin, cos) = libm::sincos(2.0 * core::f64::consts::PI * (i % sides) as f64 / sides as f64);
            format!("vertex {cos} {y} {sin}\n")
        };
        let mut text = "solid\n".to_owned();
        for i in 0..sides {
            for corners in
                [[at(i, 0.0), at(i, 1.0), at(i + 1, 1.0)], [at(i, 0.0), at(i + 1, 1.0), at(i + 1, 0.0)]]
            {
                text += &format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", corners.concat());
            }
        }
        let model = read_bytes(format!("{text}endsolid\n").as_bytes(), Format::Stl).unwrap();
        model.meshes[0].positions.len()
    };
    assert_eq!((drum(12), drum(13)), (48, 26));
}
