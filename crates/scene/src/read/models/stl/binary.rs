//! Binary files: a header, a number of facets, and 50 bytes for each.

use std::io::Read;

use glam::{DVec3, Vec3};
use glanz_color::read::{Place, ReadError, excerpt};
use glanz_color::srgb_decode;

use super::super::context::Context;
use super::weld::{Added, Weld};
use super::{FACET, HEADER, io_error, name_of};

/// The number of facets that the header claims.
pub(super) fn claimed(head: &[u8]) -> Option<u64> {
    let count = head.get(HEADER - 4..HEADER)?;
    Some(u64::from(u32::from_le_bytes(count.try_into().ok()?)))
}

/// Reads a file that begins with `head`.
pub(super) fn read(
    mut reader: impl Read,
    head: &[u8],
    len: u64,
    context: &mut Context<'_>,
) -> Result<Weld, ReadError> {
    let count = facet_count(head, len, context)?;
    let mut bytes = [0; FACET];
    reader.read_exact(&mut [0; HEADER]).map_err(|error| io_error(context.file, error))?;
    let (mut weld, mut colors) = (Weld::default(), Colors::of(head));
    for facet in 0..count {
        reader.read_exact(&mut bytes).map_err(|error| io_error(context.file, error))?;
        let float = |at: usize| {
            f64::from(f32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]))
        };
        let corners = [12, 24, 36].map(|at| DVec3::new(float(at), float(at + 4), float(at + 8)));
        let paint = colors.paint(u16::from_le_bytes([bytes[48], bytes[49]]));
        match weld.facet(&corners, paint) {
            Added::Facet => {}
            Added::NotFinite => context.notes.add_at(super::NOT_FINITE, Place::Item("facet", facet)),
            Added::Full => {
                let place = Place::Item("facet", facet);
                return Err(ReadError::malformed(context.file, place, "at most 2^32 corners", "more"));
            }
        }
    }
    colors.tell(context);
    if colors.are_none() {
        weld.mesh.colors = Vec::new();
    }
    weld.mesh.name = name_of(&head[..80]);
    Ok(weld)
}

/// How many facets a binary file of so many bytes has.
fn facet_count(head: &[u8], len: u64, context: &mut Context<'_>) -> Result<u64, ReadError> {
    let Some(count) = claimed(head) else {
        let expected = format!("a text that begins with 'solid', or a binary header of {HEADER} bytes");
        let found = format!("{} bytes: {}", head.len(), excerpt(head));
        return Err(ReadError::malformed(context.file, Place::File, expected, found));
    };
    let needed = HEADER as u64 + FACET as u64 * count;
    if len < needed {
        let expected = format!(
            "{needed} bytes for the {count} facets that are told here (read as binary, since it is no text that begins with 'solid')"
        );
        return Err(ReadError::malformed(context.file, Place::Byte(80), expected, format!("{len} bytes")));
    }
    if len > needed {
        context.notes.add_times("bytes after the last facet are ignored", len - needed);
    }
    Ok(count)
}

/// What the two bytes after each facet mean: 15 bits of colour, five for each channel, and one that tells whether they
/// are one.
struct Colors {
    writer: Writer,
    /// The bytes of the first facet, and whether those of all others are the same.
    first: Option<u16>,
    same: bool,
    /// Facets with a colour of their own.
    colored: u64,
    /// Facets with bytes that are none.
    others: u64,
}

/// Who wrote the colours, and the colour of facets that have none.
#[derive(Clone, Copy)]
enum Writer {
    /// Materialise Magics: `COLOR=` and four bytes in the header; a facet has a colour where its bit is not set.
    Magics(Vec3),
    /// The VCG library, as in MeshLab: `COLOR=`, three bytes and ` MATERIAL=`; a facet has a colour where its bit is set.
    Vcg(Vec3),
    /// VisCAM and SolidView: nothing in the header; a facet has a colour where its bit is set, blue in the lowest bits.
    VisCam,
}

/// The number of the colour that the header says.
const OF_ALL: u16 = 1 << 15;

impl Colors {
    fn of(head: &[u8]) -> Self {
        Self { writer: Writer::of(&head[..80]), first: None, same: true, colored: 0, others: 0 }
    }

    /// The number and the value of a facet's colour.
    fn paint(&mut self, word: u16) -> Option<(u16, Vec3)> {
        self.same &= *self.first.get_or_insert(word) == word;
        let (number, marked) = (word & !OF_ALL, word & OF_ALL != 0);
        let channels = [0, 5, 10].map(|shift| f32::from(number >> shift & 31) / 31.0);
        let own = marked != matches!(self.writer, Writer::Magics(_));
        self.colored += u64::from(own);
        match self.writer {
            Writer::VisCam if own => Some((number, linear([channels[2], channels[1], channels[0]]))),
            Writer::VisCam => {
                self.others += u64::from(word != 0);
                None
            }
            Writer::Magics(_) | Writer::Vcg(_) if own => Some((number, linear(channels))),
            Writer::Magics(color) | Writer::Vcg(color) => Some((OF_ALL, color)),
        }
    }

    /// Whether the bytes of all facets say nothing: all are 0, or all have the bit alone where no header has a colour.
    fn are_none(&self) -> bool {
        match (self.first, self.writer) {
            (None | Some(0), _) | (Some(OF_ALL), Writer::VisCam) => self.same,
            _ => false,
        }
    }

    fn tell(&self, context: &mut Context<'_>) {
        if self.are_none() {
            return;
        }
        let note = match self.writer {
            Writer::Magics(_) => {
                "STL: colours of facets are read as Magics writes them, red in the lowest bits"
            }
            Writer::Vcg(_) => {
                "STL: colours of facets are read as MeshLab writes them, red in the lowest bits"
            }
            Writer::VisCam => {
                "STL: colours of facets are read as VisCAM and SolidView write them, blue in the lowest bits"
            }
        };
        context.notes.add_times(note, self.colored);
        context.notes.add_times("STL: bytes after facets that are no colours are ignored", self.others);
    }
}

impl Writer {
    fn of(header: &[u8]) -> Self {
        const KEY: &[u8] = b"COLOR=";
        let at = header.windows(KEY.len()).position(|word| word == KEY).map(|at| at + KEY.len());
        let Some((codes, rest)) = at.and_then(|at| header[at..].split_first_chunk::<3>()) else {
            return Self::VisCam;
        };
        let color = linear(codes.map(|code| f32::from(code) / 255.0));
        match rest.starts_with(b" MATERIAL=") {
            true => Self::Vcg(color),
            false => Self::Magics(color),
        }
    }
}

fn linear(codes: [f32; 3]) -> Vec3 {
    Vec3::from(codes.map(srgb_decode))
}
