//! The container of RGL's files: named arrays.

use crate::ReadError;

pub(super) const MAGIC: &[u8; 12] = b"tensor_file\0";

/// An array as it is in the file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Field {
    pub(super) name: String,
    /// The code of its type.
    pub(super) kind: u8,
    pub(super) shape: Vec<usize>,
    pub(super) bytes: Vec<u8>,
}

/// Most fields of a file, and dimensions of one.
const MOST: usize = 64;

/// Bytes of a number of a type.
fn size_of(kind: u8) -> Option<usize> {
    Some(match kind {
        1 | 2 => 1,
        3 | 4 | 9 => 2,
        5 | 6 | 10 => 4,
        7 | 8 | 11 => 8,
        _ => return None,
    })
}

struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    fn take(&mut self, n: usize) -> Result<&'a [u8], ReadError> {
        let end = self.at.checked_add(n).filter(|end| *end <= self.bytes.len());
        let end = end.ok_or_else(|| ReadError::broken("the file ends within its list of fields"))?;
        let taken = &self.bytes[self.at..end];
        self.at = end;
        Ok(taken)
    }

    fn number(&mut self, n: usize) -> Result<u64, ReadError> {
        Ok(self.take(n)?.iter().rev().fold(0, |all, byte| all << 8 | u64::from(*byte)))
    }
}

/// The fields of a file.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<Field>, ReadError> {
    let mut cursor = Cursor { bytes, at: MAGIC.len() };
    let version = cursor.take(2)?;
    if version != [1, 0] {
        let message = format!("version {}.{} of tensor files is not known, only 1.0", version[0], version[1]);
        return Err(ReadError::broken(message));
    }
    let count = cursor.number(4)? as usize;
    if count > MOST {
        return Err(ReadError::broken(format!("{count} fields are more than {MOST}")));
    }
    let mut fields = Vec::with_capacity(count);
    for _ in 0..count {
        let length = cursor.number(2)? as usize;
        let name = String::from_utf8_lossy(cursor.take(length)?).into_owned();
        let dimensions = cursor.number(2)? as usize;
        let kind = cursor.number(1)? as u8;
        let offset = cursor.number(8)? as usize;
        if dimensions > MOST {
            return Err(ReadError::broken(format!("the field '{name}' has {dimensions} dimensions")));
        }
        let mut shape = Vec::with_capacity(dimensions);
        for _ in 0..dimensions {
            shape.push(cursor.number(8)? as usize);
        }
        let Some(size) = size_of(kind) else {
            return Err(ReadError::broken(format!(
                "the field '{name}' has numbers of the unknown type {kind}"
            )));
        };
        let length = shape.iter().try_fold(size, |all, n| all.checked_mul(*n));
        let end = length.and_then(|length| offset.checked_add(length)).filter(|end| *end <= bytes.len());
        let Some(end) = end else {
            return Err(ReadError::broken(format!("the field '{name}' reaches beyond the end of the file")));
        };
        fields.push(Field { name, kind, shape, bytes: bytes[offset..end].to_vec() });
    }
    Ok(fields)
}

impl Field {
    /// Its numbers as `f32`.
    pub(super) fn floats(&self) -> Result<Vec<f32>, ReadError> {
        match self.kind {
            10 => Ok(self.bytes.as_chunks::<4>().0.iter().map(|b| f32::from_le_bytes(*b)).collect()),
            11 => Ok(self.bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b) as f32).collect()),
            _ => Err(ReadError::broken(format!("the field '{}' holds no floating point numbers", self.name))),
        }
    }
}

impl Field {
    pub(super) fn of_floats(name: &str, shape: &[usize], values: &[f32]) -> Self {
        let bytes = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        Self { name: name.to_owned(), kind: 10, shape: shape.to_vec(), bytes }
    }

    pub(super) fn of_bytes(name: &str, bytes: &[u8]) -> Self {
        Self { name: name.to_owned(), kind: 1, shape: vec![bytes.len()], bytes: bytes.to_vec() }
    }
}

/// The bytes of a file with these fields, each at a multiple of eight.
pub(super) fn write(fields: &[Field]) -> Vec<u8> {
    let aligned = |at: usize| at.div_ceil(8) * 8;
    let head: usize = fields.iter().map(|field| 13 + field.name.len() + 8 * field.shape.len()).sum();
    let mut at = aligned(MAGIC.len() + 6 + head);
    let mut bytes = MAGIC.to_vec();
    bytes.extend([1, 0]);
    bytes.extend((fields.len() as u32).to_le_bytes());
    let mut offsets = Vec::with_capacity(fields.len());
    for field in fields {
        bytes.extend((field.name.len() as u16).to_le_bytes());
        bytes.extend(field.name.as_bytes());
        bytes.extend((field.shape.len() as u16).to_le_bytes());
        bytes.push(field.kind);
        bytes.extend((at as u64).to_le_bytes());
        field.shape.iter().for_each(|n| bytes.extend((*n as u64).to_le_bytes()));
        offsets.push(at);
        at = aligned(at + field.bytes.len());
    }
    for (field, offset) in fields.iter().zip(offsets) {
        bytes.resize(offset, 0);
        bytes.extend(&field.bytes);
    }
    bytes
}
