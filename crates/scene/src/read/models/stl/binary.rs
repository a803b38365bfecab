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
    /// The colour of all other facets, by Materialise Magics, whose header says so.
    magics: Option<Vec3>,
    /// Facets with a colour of their own.
    colored: u64,
    /// Facets with bytes that are none.
    others: u64,
}

/// The number of the colour that the header says.
const OF_ALL: u16 = 1 << 15;

impl Colors {
    fn of(head: &[u8]) -> Self {
        const KEY: &[u8] = b"COLOR=";
        let header = &head[..80];
        let at = header.windows(KEY.len()).position(|word| word == KEY).map(|at| at + KEY.len());
        let color = at.and_then(|at| header.get(at..at + 3));
        let magics = color.map(|codes| linear([0, 1, 2].map(|channel| f32::from(codes[channel]) / 255.0)));
        Self { magics, colored: 0, others: 0 }
    }

    /// The number and the value of a facet's colour.
    fn paint(&mut self, word: u16) -> Option<(u16, Vec3)> {
        let (number, marked) = (word & !OF_ALL, word & OF_ALL != 0);
        let channels = [0, 5, 10].map(|shift| f32::from(number >> shift & 31) / 31.0);
        let own = self.magics.is_some() != marked;
        self.colored += u64::from(own);
        match self.magics {
            Some(_) if own => Some((number, linear(channels))),
            Some(color) => Some((OF_ALL, color)),
            None if own => Some((number, linear([channels[2], channels[1], channels[0]]))),
            None => {
                self.others += u64::from(word != 0);
                None
            }
        }
    }

    fn tell(&self, context: &mut Context<'_>) {
        let note = match self.magics {
            Some(_) => "STL: colours of facets are read as Magics writes them, red in the lowest bits",
            None => {
                "STL: colours of facets are read as VisCAM and SolidView write them, blue in the lowest bits"
            }
        };
        context.notes.add_times(note, self.colored);
        context.notes.add_times("STL: bytes after facets that are no colours are ignored", self.others);
    }
}

fn linear(codes: [f32; 3]) -> Vec3 {
    Vec3::from(codes.map(srgb_decode))
}
