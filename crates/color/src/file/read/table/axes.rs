//! The columns of wavelengths of a table.

use super::head::{Head, names_axis};
use super::{Source, bands};
use crate::file::read::error::excerpt;
use crate::file::read::named::note;
use crate::file::read::units::Scale;
use crate::file::read::{Place, ReadError};

/// A column of wavelengths.
pub(super) struct Axis {
    pub(super) column: usize,
    pub(super) scale: Scale,
}

/// Wavelengths in µm of which nothing says that they are: they lie here, and some of them are visible. In nm they were X-rays.
const LIKELY_UM: core::ops::RangeInclusive<f64> = 0.1..=30.0;
const VISIBLE_UM: core::ops::RangeInclusive<f64> = 0.38..=0.78;
/// The fewest wavelengths that are taken for µm where nothing says it.
const FEWEST_UM: usize = 3;

/// The columns of wavelengths: those whose header says so, else the first one whose numbers can be. What is assumed is told.
pub(super) fn find(
    source: &Source<'_>,
    head: &Head,
    values: &mut [Vec<f64>],
    has_unit: bool,
    notes: &mut Vec<String>,
) -> Result<Vec<Axis>, ReadError> {
    let scale = |column: usize| match said(source, head, column)? {
        Scale::Unknown if has_unit => Ok(Scale::Nanometres),
        Scale::Unknown if is_in_micrometres(&values[column]) => Ok(Scale::Micrometres),
        scale => Ok::<Scale, ReadError>(scale),
    };
    let mut named = named(head, values);
    if named.is_empty() {
        let found = (0..values.len().saturating_sub(1)).find_map(|column| {
            let scale = scale(column).ok()?;
            is_axis(&values[column], scale).then_some(column)
        });
        named.push(found.unwrap_or(0));
    }
    let mut axes = Vec::new();
    for column in named {
        let axis = Axis { column, scale: scale(column)? };
        if axis.scale == Scale::Micrometres && said(source, head, column)? == Scale::Unknown {
            note(notes, "no unit of wavelength given: taken as µm, since in nm they were X-rays");
        }
        axes.push(axis);
    }
    bands::find(&mut axes, head, values, notes);
    Ok(axes)
}

/// The columns whose header is that of wavelengths.
fn named(head: &Head, values: &[Vec<f64>]) -> Vec<usize> {
    // The energy of a lamp is a value, that of photons an axis: it rises or falls.
    let is_energy = |column: usize| head.columns[column].trim().to_lowercase().starts_with("energy");
    let is_named = |column: usize| {
        let named = head.title.is_none() && names_axis(&head.columns[column]);
        named && (column == 0 || !is_energy(column) || is_axis(&values[column], Scale::Electronvolts))
    };
    let has_values = |column: &usize| values[*column].iter().any(|value| value.is_finite());
    let mut named: Vec<usize> =
        (0..values.len()).filter(|column| is_named(*column)).filter(has_values).collect();
    if named.last() == Some(&(values.len() - 1)) {
        // A last column has no values behind it: its header names a wavelength for another reason.
        named.pop();
    }
    named
}

/// What the file, or the caller, says of the unit of a column of wavelengths.
fn said(source: &Source<'_>, head: &Head, column: usize) -> Result<Scale, ReadError> {
    if let Some(unit) = source.unit {
        return Ok(unit);
    }
    let said = Scale::of_axis(head.axis_header(column)).or_else(|unit| match head.title {
        // The brackets of a title may hold anything.
        Some(_) => Ok(Scale::Unknown),
        None => Err(unit),
    });
    let said = said.map_err(|unit| {
        let known = Scale::UNITS.map(|(name, ..)| name).join(", ");
        let expected = format!("a unit of wavelength, one of {known}");
        ReadError::malformed(source.file, Place::File, expected, excerpt(&unit))
    })?;
    Ok(if said == Scale::Unknown { head.scale } else { said })
}

/// Whether numbers can be nothing but visible wavelengths in µm, and their neighbours.
pub(super) fn is_in_micrometres(values: &[f64]) -> bool {
    let known = || values.iter().filter(|value| value.is_finite());
    let ordered =
        values.windows(2).all(|pair| pair[0] < pair[1]) || values.windows(2).all(|pair| pair[0] > pair[1]);
    known().count() >= FEWEST_UM
        && ordered
        && known().all(|value| LIKELY_UM.contains(value))
        && known().filter(|value| VISIBLE_UM.contains(*value)).count() >= FEWEST_UM
}

/// Whether numbers can be wavelengths: they only rise or only fall, and lie where wavelengths do.
fn is_axis(values: &[f64], scale: Scale) -> bool {
    let known = || values.iter().copied().filter(|value| value.is_finite());
    let pairs = || known().zip(known().skip(1));
    let ordered = pairs().all(|(a, b)| a < b) || pairs().all(|(a, b)| a > b);
    ordered && known().next().is_some() && known().all(|value| scale.is_likely(value))
}
