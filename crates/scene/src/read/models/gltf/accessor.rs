//! Accessors: arrays of numbers in buffers, with sparse corrections.

use glanz_color::read::{Place, ReadError, excerpt};

use super::json::{Accessor, Sparse, SparsePart};
use super::source::Source;

/// The type of a number in a buffer.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of_code(code: u32) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The number at the start of `bytes`, which must be long enough; normalised ones after
    /// glTF 2.0, §3.11.
    #[inline]
    fn float(self, bytes: &[u8], normalized: bool) -> f32 {
        let (value, one) = match self {
            Self::I8 => (f32::from(bytes[0] as i8), 127.0),
            Self::U8 => (f32::from(bytes[0]), 255.0),
            Self::I16 => (f32::from(i16::from_le_bytes([bytes[0], bytes[1]])), 32767.0),
            Self::U16 => (f32::from(u16::from_le_bytes([bytes[0], bytes[1]])), 65535.0),
            Self::U32 => return u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as f32,
            Self::F32 => return f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
        };
        if normalized { (value / one).max(-1.0) } else { value }
    }

    /// The unsigned whole number at the start of `bytes`.
    #[inline]
    fn index(self, bytes: &[u8]) -> u32 {
        match self {
            Self::U8 => u32::from(bytes[0]),
            Self::U16 => u32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
            _ => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
        }
    }
}

/// Replaced items: their numbers, rising, and the bytes of the new ones without gaps.
type SparseItems<'a> = (Vec<u32>, &'a [u8]);

/// Items in a buffer, checked to lie in it.
struct Items<'a> {
    /// From the first item on; `None` for zeros.
    bytes: Option<&'a [u8]>,
    stride: usize,
    count: usize,
    component: Component,
    normalized: bool,
    sparse: Option<SparseItems<'a>>,
    /// Bytes of an item.
    size: usize,
}

impl<'a> Items<'a> {
    /// The bytes of an item; `None` for zeros.
    #[inline]
    fn item(&self, index: usize) -> Option<&'a [u8]> {
        if let Some((numbers, values)) = &self.sparse
            && let Ok(at) = numbers.binary_search(&(index as u32))
        {
            return Some(&values[at * self.size..(at + 1) * self.size]);
        }
        self.bytes.map(|bytes| &bytes[index * self.stride..index * self.stride + self.size])
    }
}

impl Accessor {
    /// How many numbers an item has.
    pub(super) fn width(&self) -> usize {
        match self.kind.as_str() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "MAT4" => 16,
            _ => 4,
        }
    }
}

/// The place of an accessor.
fn place(index: usize) -> Place {
    Place::Path(format!("accessors[{index}]"))
}

impl Source<'_> {
    /// The accessor of this number, as `user` names it.
    fn accessor(&self, index: usize, user: &str) -> Result<&Accessor, ReadError> {
        self.root.accessors.get(index).ok_or_else(|| {
            let expected = format!("one of {} accessors", self.root.accessors.len());
            self.malformed(Place::Path(user.to_owned()), expected, format!("accessor {index}"))
        })
    }

    /// The number of items of an accessor.
    pub(super) fn count(&self, index: usize, user: &str) -> Result<usize, ReadError> {
        let count = self.accessor(index, user)?.count;
        if let Some((count, _)) = self.draco.numbers(index) {
            return Ok(count);
        }
        // Each item must be used by something that takes at least a byte, in a buffer or as the
        // item itself: what is more can only be a claim.
        let most = self.buffers.total().saturating_add(self.views.total()).min(u64::from(u32::MAX));
        match count {
            count if count <= most => Ok(count as usize),
            _ => Err(self.malformed(
                place(index),
                format!("a count of at most {most}, the bytes in all buffers"),
                count.to_string(),
            )),
        }
    }

    /// The items of an accessor, each of `width` numbers of one of the `kinds`.
    fn items(&self, index: usize, kinds: &[&str], user: &str) -> Result<Items<'_>, ReadError> {
        let accessor = self.accessor(index, user)?;
        if !kinds.contains(&accessor.kind.as_str()) {
            let found = excerpt(accessor.kind.as_bytes());
            return Err(self.malformed(
                place(index),
                format!("the type {} for {user}", kinds.join(" or ")),
                found,
            ));
        }
        let code = self.draco.numbers(index).map_or(accessor.component_type, |(_, code)| code);
        let component = Component::of_code(code).ok_or_else(|| {
            let expected = "a componentType of 5120, 5121, 5122, 5123, 5125 or 5126";
            self.malformed(place(index), expected, code.to_string())
        })?;
        let size = component.size() * accessor.width();
        let count = self.count(index, user)?;
        let (bytes, stride) = self.dense(accessor, size, count, index)?;
        let sparse = match &accessor.sparse {
            Some(sparse) => Some(self.sparse(sparse, size, count, index)?),
            None => None,
        };
        Ok(Items { bytes, stride, count, component, normalized: accessor.normalized, sparse, size })
    }

    /// The items of an accessor without its sparse ones, `None` for zeros, and the distance between them.
    fn dense(
        &self,
        accessor: &Accessor,
        size: usize,
        count: usize,
        index: usize,
    ) -> Result<(Option<&[u8]>, usize), ReadError> {
        let (view, bytes) = (accessor.buffer_view, self.draco.items(index));
        if let Some(bytes) = bytes {
            let bytes = bytes.map_err(|(expected, found)| self.malformed(place(index), expected, found))?;
            return Ok((Some(bytes), size));
        }
        let Some(view) = view else { return Ok((None, size)) };
        let (bytes, stride) = self.view(view)?;
        let stride = stride.unwrap_or(size);
        Ok((Some(self.slice(bytes, accessor.byte_offset, stride, size, count, index)?), stride))
    }

    /// The items, each of `size` bytes, that replace some of the `count` items of an accessor, and which.
    fn sparse(
        &self,
        sparse: &Sparse,
        size: usize,
        count: usize,
        index: usize,
    ) -> Result<SparseItems<'_>, ReadError> {
        let replaced = usize::try_from(sparse.count).ok().filter(|replaced| *replaced <= count);
        let replaced = replaced.ok_or_else(|| {
            let expected = format!("at most {count} sparse items");
            self.malformed(place(index), expected, sparse.count.to_string())
        })?;
        let (values, _) = self.view(sparse.values.buffer_view)?;
        let values = self.slice(values, sparse.values.byte_offset, size, size, replaced, index)?;
        Ok((self.sparse_indices(&sparse.indices, replaced, count, index)?, values))
    }

    /// The part of a view that holds `count` items.
    fn slice<'b>(
        &self,
        bytes: &'b [u8],
        offset: u64,
        stride: usize,
        size: usize,
        count: usize,
        index: usize,
    ) -> Result<&'b [u8], ReadError> {
        let needed = match count {
            0 => Some(0),
            _ => (count - 1).checked_mul(stride).and_then(|last| last.checked_add(size)),
        };
        let start = usize::try_from(offset).ok().filter(|start| *start <= bytes.len());
        let slice = start.zip(needed).and_then(|(start, needed)| bytes[start..].get(..needed));
        slice.ok_or_else(|| {
            let expected =
                format!("{count} items of {size} bytes, {stride} apart, from byte {offset} of the view on");
            self.malformed(place(index), expected, format!("a view of {} bytes", bytes.len()))
        })
    }

    /// The numbers of the items that a sparse accessor replaces.
    fn sparse_indices(
        &self,
        part: &SparsePart,
        replaced: usize,
        count: usize,
        index: usize,
    ) -> Result<Vec<u32>, ReadError> {
        let component = Component::of_code(part.component_type);
        let component = component.filter(|c| matches!(c, Component::U8 | Component::U16 | Component::U32));
        let component = component.ok_or_else(|| {
            let expected = "a sparse componentType of 5121, 5123 or 5125";
            self.malformed(place(index), expected, part.component_type.to_string())
        })?;
        let (bytes, _) = self.view(part.buffer_view)?;
        let size = component.size();
        let bytes = self.slice(bytes, part.byte_offset, size, size, replaced, index)?;
        let numbers: Vec<u32> = bytes.chunks_exact(size).map(|bytes| component.index(bytes)).collect();
        let rising = numbers.windows(2).all(|pair| pair[0] < pair[1]);
        let inside = numbers.last().is_none_or(|last| (*last as usize) < count);
        if !rising || !inside {
            let expected = format!("sparse indices that rise and stay below {count}");
            return Err(self.malformed(place(index), expected, "others"));
        }
        Ok(numbers)
    }

    /// Items of `N` floats: all, or those that `pick` names. Items of the file may be shorter, where
    /// `kinds` allows it; the rest is filled with ones.
    pub(super) fn floats<const N: usize>(
        &self,
        index: usize,
        kinds: &[&str],
        pick: Option<&[u32]>,
        user: &str,
    ) -> Result<Vec<[f32; N]>, ReadError> {
        let items = self.items(index, kinds, user)?;
        let width = items.size / items.component.size();
        let read = |item: usize| {
            let mut values = [1.0; N];
            match items.item(item) {
                Some(bytes) => {
                    let numbers = bytes.chunks_exact(items.component.size());
                    for (value, bytes) in values.iter_mut().zip(numbers) {
                        *value = items.component.float(bytes, items.normalized);
                    }
                }
                None => values.iter_mut().take(width).for_each(|value| *value = 0.0),
            }
            values
        };
        Ok(match pick {
            Some(pick) => pick.iter().map(|&item| read(item as usize)).collect(),
            None => (0..items.count).map(read).collect(),
        })
    }

    /// Indices of vertices, each below `vertices`.
    pub(super) fn indices(&self, index: usize, vertices: usize, user: &str) -> Result<Vec<u32>, ReadError> {
        let items = self.items(index, &["SCALAR"], user)?;
        if !matches!(items.component, Component::U8 | Component::U16 | Component::U32) {
            let found = self.accessor(index, user)?.component_type.to_string();
            return Err(self.malformed(place(index), "a componentType of 5121, 5123 or 5125", found));
        }
        let indices: Vec<u32> = (0..items.count)
            .map(|item| items.item(item).map_or(0, |bytes| items.component.index(bytes)))
            .collect();
        match indices.iter().position(|&vertex| vertex as usize >= vertices) {
            Some(bad) => {
                let found = format!("{} in item {bad}", indices[bad]);
                Err(self.malformed(place(index), format!("indices below {vertices}"), found))
            }
            None => Ok(indices),
        }
    }
}
