//! Views compressed by meshoptimizer's codecs (`EXT_meshopt_compression`, `KHR_meshopt_compression`).

use std::cell::OnceCell;
use std::collections::HashSet;

use glanz_color::read::{Place, ReadError, excerpt};
use meshoptimizer_rs::codec::{
    decode_filter_color, decode_filter_exp, decode_filter_oct, decode_filter_quat, decode_index_buffer,
    decode_index_sequence, decode_vertex_buffer,
};
use meshoptimizer_rs::{Error, Limits, Workspace};
use serde::Deserialize;

use super::super::json::{Buffer, Root};
use super::super::source::Source;

/// The same extension under its two names.
#[derive(Deserialize)]
#[serde(bound = "T: Deserialize<'de>")]
pub(in super::super) struct Extensions<T> {
    #[serde(rename = "EXT_meshopt_compression")]
    ext: Option<T>,
    #[serde(rename = "KHR_meshopt_compression")]
    khr: Option<T>,
}

impl<T> Default for Extensions<T> {
    fn default() -> Self {
        Self { ext: None, khr: None }
    }
}

impl<T> Extensions<T> {
    /// The extension and its name, if it is there.
    fn get(&self) -> Option<(&T, &'static str)> {
        let khr = self.khr.as_ref().map(|khr| (khr, "KHR_meshopt_compression"));
        self.ext.as_ref().map(|ext| (ext, "EXT_meshopt_compression")).or(khr)
    }
}

/// What is said of a buffer whose views are compressed elsewhere.
#[derive(Deserialize, Default)]
#[serde(default)]
pub(in super::super) struct Fallback {
    fallback: bool,
}

/// Where the compressed bytes of a view are.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(in super::super) struct Compressed {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: u64,
    pub byte_length: u64,
    byte_stride: u64,
    count: u64,
    mode: String,
    filter: Option<String>,
}

impl Compressed {
    /// The bytes of the view once it is decompressed.
    fn size(&self) -> u64 {
        self.count.saturating_mul(self.byte_stride)
    }

    fn filter(&self) -> &str {
        self.filter.as_deref().unwrap_or("NONE")
    }

    /// The items, decompressed.
    fn decode(&self, bytes: &[u8]) -> Result<Vec<u8>, Error> {
        let size = |size: u64| usize::try_from(size).map_err(|_| Error::SizeOverflow);
        let (count, stride) = (size(self.count)?, size(self.byte_stride)?);
        // What it may take is taken off the budget of the file.
        let space = &mut Workspace::new(Limits { max_bytes: usize::MAX, ..Limits::default() });
        let mut items = match self.mode.as_str() {
            "ATTRIBUTES" => decode_vertex_buffer(count, stride, bytes, space)?,
            "TRIANGLES" => decode_index_buffer(count, stride, bytes, space)?,
            "INDICES" => decode_index_sequence(count, stride, bytes, space)?,
            _ => return Err(Error::InvalidParameter),
        };
        match self.filter() {
            "NONE" => {}
            _ if self.mode != "ATTRIBUTES" => return Err(Error::InvalidParameter),
            "OCTAHEDRAL" => decode_filter_oct(&mut items, count, stride, space)?,
            "QUATERNION" => decode_filter_quat(&mut items, count, stride, space)?,
            "EXPONENTIAL" => decode_filter_exp(&mut items, count, stride, space)?,
            "COLOR" => decode_filter_color(&mut items, count, stride, space)?,
            _ => return Err(Error::InvalidParameter),
        }
        Ok(items)
    }
}

impl Root {
    /// The buffers of the views that are compressed elsewhere.
    pub(in super::super) fn buffers_of_compressed_views(&self) -> HashSet<usize> {
        let views = self.buffer_views.iter().filter(|view| view.extensions.get().is_some());
        views.map(|view| view.buffer).collect()
    }
}

impl Buffer {
    /// Whether it is said to be for readers without the extension alone.
    pub(in super::super) fn is_fallback(&self) -> bool {
        self.extensions.get().is_some_and(|(meshopt, _)| meshopt.fallback || self.uri.is_none())
    }
}

/// The views of a file that are compressed, decompressed when they are first used.
pub(in super::super) struct Views {
    views: Vec<OnceCell<Vec<u8>>>,
    /// The bytes of all of them, by what the file says.
    total: u64,
}

impl Views {
    pub(in super::super) fn new(root: &Root) -> Self {
        let sizes = root.buffer_views.iter().filter_map(|view| view.extensions.get());
        let total = sizes.fold(0u64, |total, (view, _)| total.saturating_add(view.size()));
        Self { views: root.buffer_views.iter().map(|_| OnceCell::new()).collect(), total }
    }

    /// How many bytes there would be in all.
    pub(in super::super) fn total(&self) -> u64 {
        self.total
    }
}

impl Source<'_> {
    /// The bytes of a view, decompressed where they are compressed and the buffer of the view does not have them
    /// uncompressed, and the distance between its items, if the view tells one.
    pub(in super::super) fn view(&self, index: usize) -> Result<(&[u8], Option<usize>), ReadError> {
        let view = self.root.buffer_views.get(index).filter(|view| self.buffers.is_empty(view.buffer));
        let compressed = view.and_then(|view| view.extensions.get());
        let (Some((compressed, name)), Some(cell)) = (compressed, self.views.views.get(index)) else {
            return self.buffers.view(self.root, index, self.file);
        };
        let bytes = match cell.get() {
            Some(bytes) => bytes,
            None => {
                let bytes =
                    self.decompress(compressed, &format!("bufferViews[{index}].extensions.{name}"))?;
                cell.get_or_init(|| bytes)
            }
        };
        Ok((bytes, Some(compressed.byte_stride as usize)))
    }

    fn decompress(&self, view: &Compressed, path: &str) -> Result<Vec<u8>, ReadError> {
        let place = || Place::Path(path.to_owned());
        let bytes = self.buffers.slice(view.buffer, view.byte_offset, view.byte_length, self.file, place)?;
        self.budget.spend(view.size(), self.file, || path.to_owned())?;
        view.decode(bytes).map_err(|error| {
            let (mode, filter) = (excerpt(&view.mode), excerpt(view.filter()));
            let expected = format!(
                "{} items of {} bytes in the mode {mode} with the filter {filter}",
                view.count, view.byte_stride
            );
            self.malformed(place(), expected, format!("what cannot be decompressed ({error})"))
        })
    }
}
