//! STL: triangles without connection, as text or binary.
//!
//! Corners at equal positions become one vertex, so that smooth normals are possible. The facet
//! normals of the file are not used: they follow from the corners, and files often leave them zero.
//! The two bytes after each binary facet, where some programs keep a colour, are ignored.

use std::collections::HashMap;
use std::io::{self, BufRead, Read};

use glam::{DMat4, Vec3};
use glanz_color::read::{Place, ReadError, excerpt};

use super::context::Context;
use super::faces::corners_fit;
use super::lines::{Lines, float, words};
use super::model::Model;
use crate::{Material, Mesh, Object};

/// The bytes of the header of a binary file, with the number of facets at its end.
const HEADER: usize = 84;
/// The bytes of a binary facet: normal, three corners, two bytes.
const FACET: usize = 50;

/// Reads a file of `len` bytes.
pub(super) fn read(
    mut reader: impl BufRead,
    len: u64,
    context: &mut Context<'_>,
) -> Result<Model, ReadError> {
    let mut head = Vec::with_capacity(HEADER);
    (&mut reader)
        .take(HEADER as u64)
        .read_to_end(&mut head)
        .map_err(|error| io_error(context.file, error))?;
    let meshes = if is_binary(&head, len) {
        vec![read_binary(reader, &head, len, context)?]
    } else {
        read_text(io::Cursor::new(head).chain(reader), context)?
    };
    context.notes.add("STL holds neither unit nor upward direction: taken as metres, +Y up");
    context.notes.add("STL holds no vertex normals: smooth ones are computed where shading asks for them");
    let objects = (0..meshes.len()).map(|mesh| Object {
        name: meshes[mesh].name.clone(),
        mesh,
        material: 0,
        transform: DMat4::IDENTITY,
        shading: None,
        interpolation: None,
        program: None,
    });
    Ok(Model {
        objects: objects.collect(),
        meshes,
        materials: vec![Material::default_gray()],
        ..Model::default()
    })
}

fn io_error(file: &str, source: io::Error) -> ReadError {
    ReadError::Io { file: file.to_owned(), place: Place::File, source }
}

/// The number of facets that the header claims.
fn claimed(head: &[u8]) -> Option<u64> {
    let count = head.get(HEADER - 4..HEADER)?;
    Some(u64::from(u32::from_le_bytes(count.try_into().ok()?)))
}

/// Whether the file is binary: its length fits the count, or it does not begin as text does.
fn is_binary(head: &[u8], len: u64) -> bool {
    let fits = claimed(head).is_some_and(|count| len == HEADER as u64 + FACET as u64 * count);
    // Some binary files begin with "solid", too; a zero byte gives them away.
    fits || !head.trim_ascii_start().starts_with(b"solid") || head.contains(&0)
}

/// Joins corners at equal positions.
#[derive(Default)]
struct Weld {
    vertices: HashMap<[u32; 3], u32>,
}

impl Weld {
    fn corner(&mut self, mesh: &mut Mesh, position: Vec3) {
        // Adding zero makes −0 the same point as 0.
        let position = position + Vec3::ZERO;
        let next = mesh.positions.len() as u32;
        let vertex = *self.vertices.entry(position.to_array().map(f32::to_bits)).or_insert(next);
        if vertex == next {
            mesh.positions.push(position);
        }
        mesh.corners.push(vertex);
    }
}

fn read_binary(
    mut reader: impl Read,
    head: &[u8],
    len: u64,
    context: &mut Context<'_>,
) -> Result<Mesh, ReadError> {
    let file = context.file;
    let count = facet_count(head, len, context)?;
    let mut mesh = Mesh { name: name_of(&head[..80]), ..Mesh::default() };
    let (mut weld, mut bytes) = (Weld::default(), [0; FACET]);
    for facet in 0..count {
        reader.read_exact(&mut bytes).map_err(|error| io_error(file, error))?;
        let malformed = |expected: &str, found: String| {
            ReadError::malformed(file, Place::Item("facet", facet), expected, found)
        };
        if !corners_fit(&mesh, 3) {
            return Err(malformed("at most 2^32 corners", "more".to_owned()));
        }
        for corner in bytes[12..48].chunks_exact(12) {
            let float =
                |i: usize| f32::from_le_bytes([corner[i], corner[i + 1], corner[i + 2], corner[i + 3]]);
            let position = Vec3::new(float(0), float(4), float(8));
            if !position.is_finite() {
                return Err(malformed("finite coordinates", position.to_string()));
            }
            weld.corner(&mut mesh, position);
        }
    }
    Ok(mesh)
}

/// How many facets a binary file of so many bytes has.
fn facet_count(head: &[u8], len: u64, context: &mut Context<'_>) -> Result<u64, ReadError> {
    let Some(count) = claimed(head) else {
        let expected = format!("'solid' or a binary header of {HEADER} bytes");
        let found = format!("{} bytes: {}", head.len(), excerpt(head));
        return Err(ReadError::malformed(context.file, Place::File, expected, found));
    };
    let needed = HEADER as u64 + FACET as u64 * count;
    if len < needed {
        let expected = format!("{needed} bytes for the {count} facets that are told here");
        return Err(ReadError::malformed(context.file, Place::Byte(80), expected, format!("{len} bytes")));
    }
    if len > needed {
        context.notes.add_times("bytes after the last facet are ignored", len - needed);
    }
    Ok(count)
}

/// The printable beginning of a header.
fn name_of(header: &[u8]) -> String {
    let text: Vec<u8> = header.iter().copied().take_while(|byte| (0x20..0x7f).contains(byte)).collect();
    String::from_utf8_lossy(text.trim_ascii()).into_owned()
}

fn read_text(reader: impl BufRead, context: &mut Context<'_>) -> Result<Vec<Mesh>, ReadError> {
    let mut lines = Lines::new(reader, context.file);
    let (mut meshes, mut mesh, mut weld) = (Vec::new(), Mesh::default(), Weld::default());
    let mut state = State::Outside;
    while lines.advance()? {
        let mut words = words(lines.line());
        let Some(keyword) = words.next() else { continue };
        state = state.after(keyword).ok_or_else(|| lines.expected(state.expects()))?;
        if keyword.eq_ignore_ascii_case(b"vertex") {
            let position = point(words).filter(|_| corners_fit(&mesh, 1));
            weld.corner(
                &mut mesh,
                position.ok_or_else(|| lines.expected("'vertex' and three finite numbers"))?,
            );
        } else if keyword.eq_ignore_ascii_case(b"solid") {
            mesh.name = name_of(lines.line().trim_ascii_start()[keyword.len()..].trim_ascii());
        } else if keyword.eq_ignore_ascii_case(b"endsolid") {
            meshes.push(std::mem::take(&mut mesh));
            weld = Weld::default();
        }
    }
    if state != State::Outside {
        return Err(ReadError::malformed(
            context.file,
            lines.place(),
            state.expects(),
            "the end of the file",
        ));
    }
    Ok(meshes)
}

/// Exactly three finite numbers.
fn point<'a>(mut words: impl Iterator<Item = &'a [u8]>) -> Option<Vec3> {
    let mut next = || words.next().and_then(float);
    let position = Vec3::new(next()?, next()?, next()?);
    words.next().is_none().then_some(position)
}

/// What has been read of a text file.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Outside,
    Solid,
    Facet,
    /// In the loop, after so many corners.
    Loop(u8),
    LoopEnded,
}

impl State {
    /// The state after a line with this keyword; `None` where it must not come.
    fn after(self, keyword: &[u8]) -> Option<Self> {
        let (expected, next): (&[u8], _) = match self {
            Self::Outside => (b"solid", Self::Solid),
            Self::Solid if keyword.eq_ignore_ascii_case(b"endsolid") => return Some(Self::Outside),
            Self::Solid => (b"facet", Self::Facet),
            Self::Facet => (b"outer", Self::Loop(0)),
            Self::Loop(3) => (b"endloop", Self::LoopEnded),
            Self::Loop(corners) => (b"vertex", Self::Loop(corners + 1)),
            Self::LoopEnded => (b"endfacet", Self::Solid),
        };
        keyword.eq_ignore_ascii_case(expected).then_some(next)
    }

    fn expects(self) -> &'static str {
        match self {
            Self::Outside => "'solid'",
            Self::Solid => "'facet' or 'endsolid'",
            Self::Facet => "'outer loop'",
            Self::Loop(3) => "'endloop'",
            Self::Loop(_) => "'vertex'",
            Self::LoopEnded => "'endfacet'",
        }
    }
}

#[cfg(test)]
pub(in crate::read) mod tests {
    use super::*;
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
            "file: byte 80: expected 50000000084 bytes for the 1000000000 facets that are told here, found 100 bytes"
        );
    }

    #[test]
    fn errors_name_place_and_expectation() {
        let broken = |from: &str, to: &str| error_of(TEXT.replacen(from, to, 1).as_bytes(), Format::Stl);
        assert!(broken("vertex 0 0 0", "vertex 0 0 nan").contains("line 4: expected 'vertex' and three"));
        assert!(broken("    vertex 0 0 0\n", "").contains("line 6: expected 'vertex', found '  endloop'"));
        assert!(broken("outer", "inner").contains("line 3: expected 'outer loop'"));
        assert!(error_of(&TEXT.as_bytes()[..65], Format::Stl).contains("found the end of the file"));
        assert!(error_of(b"", Format::Stl).contains("binary header of 84 bytes"));
        let mut bytes = binary();
        bytes[84 + 12..84 + 16].copy_from_slice(&f32::INFINITY.to_le_bytes());
        assert!(error_of(&bytes, Format::Stl).contains("facet 0: expected finite coordinates"));
    }
}
