//! Primitives compressed by Draco (`KHR_draco_mesh_compression`).

use std::collections::{BTreeMap, HashMap};

use draco_core::{
    DataType, DecodeLimits, DecoderBuffer, DracoError, Mesh, MeshDecoder, PointAttribute, PointIndex,
};
use glanz_color::read::{Place, ReadError};
use serde::Deserialize;

use super::super::json::{Accessor, Primitive};
use super::super::source::Source;
use crate::read::notes::Notes;

/// A remark.
const OTHER_COUNTS: &str = "glTF: what Draco compressed has other numbers of vertices or triangles than its accessors say; its own are taken";

const NAME: &str = "KHR_draco_mesh_compression";

/// The least memory that a triangle takes when it has become one of a mesh: three corners and half a vertex, as it is
/// decoded and as it is kept.
const FACE_BYTES: u64 = 100;

/// Where the compressed bytes of a primitive are.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(in super::super) struct Compressed {
    buffer_view: usize,
    /// The numbers that the attributes have there.
    attributes: BTreeMap<String, u32>,
}

/// What was expected and what was found instead.
type Mismatch = (String, String);

/// What a primitive holds compressed; nothing where it is not compressed.
#[derive(Default)]
pub(in super::super) struct Decoded {
    /// The vertex of each corner of its triangles.
    corners: Option<Vec<u32>>,
    /// The number of its vertices.
    points: usize,
    /// For each accessor its items without gaps, or why there are none.
    items: HashMap<usize, Result<Items, Mismatch>>,
}

/// The items of an attribute, one for each vertex, and the componentType of their numbers.
struct Items {
    bytes: Vec<u8>,
    code: u32,
}

impl Decoded {
    /// The vertex of each corner of the triangles, below the number of vertices, if the primitive is compressed.
    pub(in super::super) fn take_corners(&mut self) -> Option<Vec<u32>> {
        self.corners.take()
    }

    /// The items of an accessor, one for each vertex and as wide as it says, if they were compressed.
    pub(in super::super) fn items(&self, accessor: usize) -> Option<Result<&[u8], Mismatch>> {
        let items = self.items.get(&accessor)?.as_ref();
        Some(items.map(|items| &items.bytes[..]).map_err(Clone::clone))
    }

    /// How many items an accessor has, and the componentType of their numbers, if they were compressed.
    pub(in super::super) fn numbers(&self, accessor: usize) -> Option<(usize, u32)> {
        let items = self.items.get(&accessor)?.as_ref().ok()?;
        Some((self.points, items.code))
    }
}

impl<'a> Source<'a> {
    /// The same with what a primitive holds compressed, unless the file has that uncompressed, too.
    pub(in super::super) fn of_primitive(
        &self,
        primitive: &Primitive,
        path: &str,
        notes: &mut Notes,
    ) -> Result<Self, ReadError> {
        let draco = match &primitive.extensions.draco {
            Some(compressed) if !self.is_uncompressed(primitive, compressed) => {
                self.decode(primitive, compressed, &format!("{path}.extensions.{NAME}"), notes)?
            }
            _ => Decoded::default(),
        };
        Ok(Source { draco, ..*self })
    }

    /// Whether all that is compressed is in the file for readers without the extension, too.
    fn is_uncompressed(&self, primitive: &Primitive, compressed: &Compressed) -> bool {
        let names = compressed.attributes.keys().filter_map(|name| primitive.attributes.get(name));
        let mut accessors =
            names.chain(&primitive.indices).map(|accessor| self.root.accessors.get(*accessor));
        accessors.all(|accessor| accessor.is_some_and(|accessor| accessor.buffer_view.is_some()))
    }

    fn decode(
        &self,
        primitive: &Primitive,
        compressed: &Compressed,
        path: &str,
        notes: &mut Notes,
    ) -> Result<Decoded, ReadError> {
        let wrong =
            |(expected, found): Mismatch| self.malformed(Place::Path(path.to_owned()), expected, found);
        let accessor = |index: Option<&usize>| index.and_then(|index| self.root.accessors.get(*index));
        let position =
            primitive.attributes.get("POSITION").filter(|_| compressed.attributes.contains_key("POSITION"));
        let Some(position) = accessor(position) else {
            return Err(wrong(("the positions among its attributes".to_owned(), "none".to_owned())));
        };
        // The indices of a strip are others than those of the triangles that it is compressed as.
        let indices = primitive.indices.as_ref().filter(|_| primitive.mode.is_none_or(|mode| mode == 4));
        let triangles = accessor(indices).map(|indices| indices.count / 3);
        let expected = || match triangles {
            Some(triangles) => format!("{triangles} triangles of {} vertices", position.count),
            None => format!("triangles of {} vertices", position.count),
        };
        let (bytes, _) = self.view(compressed.buffer_view)?;
        let mesh = decode(bytes, self.budget.left()).map_err(|error| {
            wrong((expected(), format!("what cannot be decompressed ({})", error.message())))
        })?;
        let (faces, points) = (mesh.num_faces() as u64, mesh.num_points() as u64);
        if points != position.count || triangles.is_some_and(|triangles| triangles != faces) {
            // Some encoders merge vertices, or leave triangles out, and tell the accessors nothing of it.
            notes.add_at(OTHER_COUNTS, Place::Path(path.to_owned()));
        }
        self.budget.check(FACE_BYTES.saturating_mul(faces), self.file, || path.to_owned())?;
        self.budget.spend(12 * faces, self.file, || path.to_owned())?;
        let corners = Some(corners(&mesh).map_err(wrong)?);
        Ok(Decoded {
            corners,
            points: mesh.num_points(),
            items: self.items_of(&mesh, primitive, compressed, path)?,
        })
    }

    /// For each accessor its items without gaps, or why there are none.
    fn items_of(
        &self,
        mesh: &Mesh,
        primitive: &Primitive,
        compressed: &Compressed,
        path: &str,
    ) -> Result<HashMap<usize, Result<Items, Mismatch>>, ReadError> {
        let mut all = HashMap::new();
        for (name, &number) in &compressed.attributes {
            let Some(&index) = primitive.attributes.get(name) else { continue };
            let Some(accessor) = self.root.accessors.get(index) else { continue };
            let items = match checked_attribute(mesh, number, accessor) {
                Ok(attribute) => {
                    let size = mesh.num_points() as u64 * attribute.byte_stride().unsigned_abs();
                    self.budget.spend(size, self.file, || path.to_owned())?;
                    let code = code(attribute.data_type());
                    items_of(attribute, mesh.num_points()).map(|bytes| Items { bytes, code })
                }
                Err(mismatch) => Err(mismatch),
            };
            all.insert(index, items);
        }
        Ok(all)
    }
}

/// The mesh in these bytes, within so much memory.
fn decode(bytes: &[u8], memory: u64) -> Result<Mesh, DracoError> {
    let limits = DecodeLimits::default().with_max_faces(memory / FACE_BYTES).with_max_decoded_bytes(memory);
    let mut buffer = DecoderBuffer::new(bytes).with_limits(limits);
    let mut mesh = Mesh::new();
    MeshDecoder::new().decode(&mut buffer, &mut mesh)?;
    Ok(mesh)
}

fn corners(mesh: &Mesh) -> Result<Vec<u32>, Mismatch> {
    let corners: Vec<u32> = mesh.faces().iter().flatten().map(|point| point.0).collect();
    match corners.iter().find(|corner| **corner as usize >= mesh.num_points()) {
        Some(corner) => Err((format!("corners below {}", mesh.num_points()), corner.to_string())),
        None => Ok(corners),
    }
}

/// The attribute of this number, if it is as wide as the accessor says. Its numbers may be of another type: that which they were
/// compressed as is taken.
fn checked_attribute<'m>(
    mesh: &'m Mesh,
    number: u32,
    accessor: &Accessor,
) -> Result<&'m PointAttribute, Mismatch> {
    let attribute = mesh.attribute_by_unique_id(number);
    let found = attribute.map(|attribute| {
        let width = usize::from(attribute.num_components());
        (width, code(attribute.data_type()))
    });
    let expected = accessor.width();
    match (attribute, found) {
        (Some(attribute), Some((width, code))) if width == expected && code != 0 => Ok(attribute),
        _ => {
            let of = |(width, code)| format!("items of {width} numbers of the componentType {code}");
            let found = found.map_or_else(|| "none".to_owned(), of);
            Err((format!("items of {expected} numbers in the attribute {number} of {NAME}"), found))
        }
    }
}

/// The items of an attribute for each of the points.
fn items_of(attribute: &PointAttribute, points: usize) -> Result<Vec<u8>, Mismatch> {
    let (data, size) = (attribute.buffer().data(), attribute.byte_stride().unsigned_abs() as usize);
    let mut items = Vec::with_capacity(points * size);
    for point in 0..points {
        let item = attribute.mapped_index(PointIndex(point as u32)).0 as usize;
        let bytes = item.checked_mul(size).and_then(|at| data.get(at..)?.get(..size));
        let Some(bytes) = bytes else {
            return Err((format!("a value of each of {points} vertices"), format!("none of vertex {point}")));
        };
        items.extend_from_slice(bytes);
    }
    Ok(items)
}

/// The componentType of glTF; 0 for those that it does not have.
fn code(kind: DataType) -> u32 {
    match kind {
        DataType::Int8 => 5120,
        DataType::Uint8 => 5121,
        DataType::Int16 => 5122,
        DataType::Uint16 => 5123,
        DataType::Uint32 => 5125,
        DataType::Float32 => 5126,
        _ => 0,
    }
}
