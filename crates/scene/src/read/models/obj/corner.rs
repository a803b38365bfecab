//! The corners of faces.

use glanz_color::read::Place;

use super::data::Data;
use crate::read::notes::Notes;

/// No texture coordinate, or no normal.
pub(super) const NONE: u32 = u32::MAX;

/// What a corner of a face names, with indices from zero.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    pub position: u32,
    /// Or `NONE`.
    pub uv: u32,
    /// Or `NONE`.
    pub normal: u32,
}

impl Corner {
    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`. Only a position that is not there is an error, which says what was expected.
    pub(super) fn parse(word: &[u8], data: &Data, place: &Place, notes: &mut Notes) -> Result<Self, String> {
        let mut fields = word.split(|byte| *byte == b'/');
        let positions = data.positions.len();
        let position = index(fields.next().unwrap_or_default(), positions)
            .ok_or_else(|| format!("the number of one of the {positions} v lines before"))?;
        let mut optional = |len, keyword| match fields.next() {
            None | Some(b"") => NONE,
            Some(field) => index(field, len).unwrap_or_else(|| {
                let note = format!(
                    "OBJ: corners name {keyword} lines that are not there: they are taken without them"
                );
                notes.add_at(&note, place.clone());
                NONE
            }),
        };
        let uv = optional(data.uvs.len(), "vt");
        let normal = optional(data.normals.len(), "vn");
        if fields.next().is_some() {
            notes.add_at("OBJ: of a corner only the first three numbers are used", place.clone());
        }
        Ok(Self { position, uv, normal })
    }
}

/// The index, from zero, that a field names: from 1 on, or from −1 backwards.
fn index(field: &[u8], len: usize) -> Option<u32> {
    let (negative, digits) = match field.strip_prefix(b"-") {
        Some(digits) => (true, digits),
        None => (false, field.strip_prefix(b"+").unwrap_or(field)),
    };
    let value = (!digits.is_empty()).then_some(()).and_then(|()| {
        digits.iter().try_fold(0usize, |value, digit| {
            let digit = digit.is_ascii_digit().then(|| usize::from(digit - b'0'))?;
            value.checked_mul(10)?.checked_add(digit)
        })
    });
    let index = match (value, negative) {
        (Some(value), false) => value.checked_sub(1),
        (Some(value @ 1..), true) => len.checked_sub(value),
        _ => None,
    };
    index.filter(|&index| index < len.min(NONE as usize)).map(|index| index as u32)
}
