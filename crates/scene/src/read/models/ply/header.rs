//! The header of a PLY file: what its body is made of.

use std::io::BufRead;

use glanz_color::read::{Place, ReadError, excerpt};

use super::super::lines::{Lines, rest, words};
use crate::read::notes::Notes;

/// The most elements of a file, and properties of an element.
const MAX_PARTS: usize = 1024;

/// How the body is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Little,
    Big,
}

/// A number type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a value.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// Whether a number is one of this type; floats take every number.
    pub(super) fn holds(self, value: f64) -> bool {
        let (least, most) = match self {
            Self::I8 => (f64::from(i8::MIN), f64::from(i8::MAX)),
            Self::U8 => (0.0, f64::from(u8::MAX)),
            Self::I16 => (f64::from(i16::MIN), f64::from(i16::MAX)),
            Self::U16 => (0.0, f64::from(u16::MAX)),
            Self::I32 => (f64::from(i32::MIN), f64::from(i32::MAX)),
            Self::U32 => (0.0, f64::from(u32::MAX)),
            Self::F32 | Self::F64 => return true,
        };
        (least..=most).contains(&value) && value == value.trunc()
    }

    /// The value that stands for full intensity.
    pub(super) fn one(self) -> f64 {
        match self {
            Self::I8 => f64::from(i8::MAX),
            Self::U8 => f64::from(u8::MAX),
            Self::I16 => f64::from(i16::MAX),
            Self::U16 => f64::from(u16::MAX),
            Self::I32 => f64::from(i32::MAX),
            Self::U32 => f64::from(u32::MAX),
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

/// What a property means for the mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Position(usize),
    Normal(usize),
    Color(usize),
    Uv(usize),
    Corners,
    /// Of faces: u and v of each corner.
    CornerUvs,
}

/// A property: a number, or a list of numbers with its length before it.
pub(super) struct Property {
    pub name: String,
    pub scalar: Scalar,
    /// The type of the length, for lists.
    pub list: Option<Scalar>,
    pub role: Option<Role>,
}

/// What an element means for the mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Vertex,
    Face,
    Strips,
    Other,
}

/// A sort of record in the body.
pub(super) struct Element {
    pub name: String,
    pub kind: Kind,
    pub count: u64,
    pub properties: Vec<Property>,
}

impl Element {
    fn new(name: &[u8], count: u64) -> Self {
        let kind = match name {
            b"vertex" => Kind::Vertex,
            b"face" => Kind::Face,
            b"tristrips" => Kind::Strips,
            _ => Kind::Other,
        };
        let name = String::from_utf8_lossy(&name[..name.len().min(64)]).into_owned();
        Self { name, kind, count, properties: Vec::new() }
    }

    /// The names of the properties that are read over, in elements that are not.
    pub(super) fn ignored(&self) -> impl Iterator<Item = &str> {
        let properties = if self.kind == Kind::Other { &[][..] } else { &self.properties };
        properties.iter().filter(|property| property.role.is_none()).map(|property| property.name.as_str())
    }

    fn role(&self, name: &[u8], list: bool) -> Option<Role> {
        let role = match (self.kind, name) {
            (Kind::Face | Kind::Strips, b"vertex_indices" | b"vertex_index") if list => Role::Corners,
            (Kind::Face, b"texcoord") if list => Role::CornerUvs,
            (Kind::Vertex | Kind::Face, _) if list => return None,
            (Kind::Vertex, b"x") => Role::Position(0),
            (Kind::Vertex, b"y") => Role::Position(1),
            (Kind::Vertex, b"z") => Role::Position(2),
            (Kind::Vertex, b"nx") => Role::Normal(0),
            (Kind::Vertex, b"ny") => Role::Normal(1),
            (Kind::Vertex, b"nz") => Role::Normal(2),
            (Kind::Vertex | Kind::Face, b"red" | b"r" | b"diffuse_red") => Role::Color(0),
            (Kind::Vertex | Kind::Face, b"green" | b"g" | b"diffuse_green") => Role::Color(1),
            (Kind::Vertex | Kind::Face, b"blue" | b"b" | b"diffuse_blue") => Role::Color(2),
            (Kind::Vertex | Kind::Face, b"alpha" | b"a") => Role::Color(3),
            (Kind::Vertex, b"s" | b"u" | b"texture_u") => Role::Uv(0),
            (Kind::Vertex, b"t" | b"v" | b"texture_v") => Role::Uv(1),
            _ => return None,
        };
        // A second property of the same meaning is read over.
        let taken = self.properties.iter().any(|property| property.role == Some(role));
        (!taken).then_some(role)
    }
}

/// The header.
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// The pictures that comments name (`comment TextureFile name`), with their places.
    pub textures: Vec<(String, Place)>,
}

impl Header {
    /// Whether positions are 32-bit floats, as bytes: texts have their digits whatever type they tell.
    pub(super) fn has_short_positions(&self) -> bool {
        let is_short = |property: &Property| {
            matches!(property.role, Some(Role::Position(_))) && property.scalar == Scalar::F32
        };
        self.encoding != Encoding::Text
            && self.elements.iter().flat_map(|element| &element.properties).any(is_short)
    }

    /// Reads it, and returns it with the reader behind it and the number of lines that it has.
    pub(super) fn read<R: BufRead>(
        reader: R,
        file: &str,
        notes: &mut Notes,
    ) -> Result<(Self, R, u64), ReadError> {
        let mut lines = Lines::new(reader, file);
        if !lines.advance()? || lines.line().trim_ascii() != b"ply" {
            return Err(lines.expected("'ply'"));
        }
        let mut draft = Draft::default();
        loop {
            if !lines.advance()? {
                return Err(ReadError::malformed(file, lines.place(), "'end_header'", "the end of the file"));
            }
            let words: Vec<&[u8]> = words(lines.line()).take(6).collect();
            if words == [b"end_header"] {
                break;
            }
            match words[..] {
                [b"comment", key, ..] if key.eq_ignore_ascii_case(b"TextureFile") => {
                    let text = rest(lines.line());
                    let name = text[key.len()..].trim().to_owned();
                    draft.textures.push((name, lines.place()));
                }
                [b"format" | b"element" | b"property" | b"comment" | b"obj_info", ..] | [] => {
                    draft.statement(&words).map_err(|expected| lines.expected(expected))?;
                }
                _ => {
                    let line = excerpt(lines.line());
                    notes.add_at(&format!("PLY: {line} is not understood and passed over"), lines.place());
                }
            }
        }
        let Draft { encoding, elements, textures } = draft;
        let place = lines.place();
        let encoding = encoding.ok_or_else(|| lines.expected("a line 'format' before the end"))?;
        check(&elements).map_err(|what| ReadError::malformed(file, place, what, "none"))?;
        let line = lines.count();
        Ok((Self { encoding, elements, textures }, lines.into_inner(), line))
    }
}

/// The header as far as it is read.
#[derive(Default)]
struct Draft {
    encoding: Option<Encoding>,
    elements: Vec<Element>,
    textures: Vec<(String, Place)>,
}

impl Draft {
    /// Takes a line in; errors say what was expected.
    fn statement(&mut self, words: &[&[u8]]) -> Result<(), &'static str> {
        match words {
            [] | [b"comment" | b"obj_info", ..] => {}
            [b"format", name, ..] => {
                self.encoding = Some(match *name {
                    b"ascii" => Encoding::Text,
                    b"binary_little_endian" => Encoding::Little,
                    b"binary_big_endian" => Encoding::Big,
                    _ => return Err("ascii, binary_little_endian or binary_big_endian"),
                });
            }
            [b"element", name, count] => self.element(name, count)?,
            [b"property", definition @ ..] => self.property(definition)?,
            _ => return Err("a line of a PLY header"),
        }
        Ok(())
    }

    fn element(&mut self, name: &[u8], count: &[u8]) -> Result<(), &'static str> {
        let count = std::str::from_utf8(count).ok().and_then(|count| count.parse().ok());
        let count = count.ok_or("'element', a name and a count")?;
        if self.elements.len() >= MAX_PARTS {
            return Err("at most 1024 elements");
        }
        if self.elements.iter().any(|known| known.name.as_bytes() == name) {
            return Err("each element once");
        }
        self.elements.push(Element::new(name, count));
        Ok(())
    }

    fn property(&mut self, definition: &[&[u8]]) -> Result<(), &'static str> {
        let (Some((list, scalar, name)), Some(element)) = (property(definition), self.elements.last_mut())
        else {
            return Err("'property', a type and a name, after an element");
        };
        if element.properties.len() >= MAX_PARTS {
            return Err("at most 1024 properties of an element");
        }
        let role = element.role(name, list.is_some());
        let name = String::from_utf8_lossy(&name[..name.len().min(64)]).into_owned();
        element.properties.push(Property { name, scalar, list, role });
        Ok(())
    }
}

/// The type of the length of a list, the type of its values, and the name.
fn property<'a>(words: &[&'a [u8]]) -> Option<(Option<Scalar>, Scalar, &'a [u8])> {
    match words {
        [b"list", length, scalar, name] => {
            let length = Scalar::named(length).filter(|length| length.is_integer())?;
            Some((Some(length), Scalar::named(scalar)?, name))
        }
        [scalar, name] => Some((None, Scalar::named(scalar)?, name)),
        _ => None,
    }
}

/// What is missing of what a mesh needs.
fn check(elements: &[Element]) -> Result<(), &'static str> {
    let vertex = elements.iter().find(|element| element.kind == Kind::Vertex);
    let vertex = vertex.ok_or("an element 'vertex'")?;
    let has = |role| vertex.properties.iter().any(|property| property.role == Some(role));
    if !(0..3).all(|axis| has(Role::Position(axis))) {
        return Err("properties x, y and z of 'vertex'");
    }
    let corners = |element: &Element| element.properties.iter().any(|p| p.role == Some(Role::Corners));
    let faces = elements.iter().filter(|element| matches!(element.kind, Kind::Face | Kind::Strips));
    match faces.filter(|element| element.count > 0).all(corners) {
        true => Ok(()),
        false => Err("a list 'vertex_indices' in 'face'"),
    }
}
