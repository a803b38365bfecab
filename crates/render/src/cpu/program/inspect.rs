//! Looking into programs: what happened at a pixel, or a value of a line at all of them.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use fearless_simd::Simd;
use glanz_math::{Lanes, Real, Vec3};
use glanz_shader::{Machine, Pair, RecordKind, Trace};

use super::{ObjectProgram, Programs};
use crate::cpu::shading::shade_block::Shaded;

/// What to look for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Wanted {
    /// All that happened at a pixel: column and row.
    Pixel([u32; 2]),
    /// A value of a line, in place of the colour: its name and its line, the last one where there is none.
    Value { name: String, line: Option<u32> },
}

/// What a pixel without the value has in its place: the program did not come there.
pub(crate) const NOT_REACHED: f32 = f32::NEG_INFINITY;

/// A frame that is looked into.
pub(crate) struct Inspection<'a> {
    wanted: Wanted,
    /// Of each program of the scene the same, compiled for traces.
    pairs: &'a [Pair],
    /// What was found at a pixel.
    found: Mutex<Option<Inspected>>,
    /// The values of that name that were met, with their lines: components of each.
    met: Mutex<BTreeMap<(u32, String), usize>>,
}

/// What happened at a pixel.
#[derive(Clone, Debug)]
pub(crate) struct Inspected {
    pub object: usize,
    pub lane: usize,
    pub trace: Trace,
}

/// A frame that was looked into, and what was found there.
pub(crate) struct Findings {
    pub pixel: Option<Inspected>,
    /// Line and name of the values that were met, and how many numbers each has.
    pub met: BTreeMap<(u32, String), usize>,
}

impl<'a> Inspection<'a> {
    pub(crate) fn new(wanted: Wanted, pairs: &'a [Pair]) -> Self {
        Self { wanted, pairs, found: Mutex::default(), met: Mutex::default() }
    }

    pub(crate) fn into_findings(self) -> Findings {
        Findings {
            pixel: self.found.into_inner().unwrap_or_else(PoisonError::into_inner),
            met: self.met.into_inner().unwrap_or_else(PoisonError::into_inner),
        }
    }

    /// The traced program of a number.
    pub(super) fn pair(&self, program: usize) -> Option<&'a Pair> {
        self.pairs.get(program)
    }
}

/// The lane of a block that is a pixel, if one is.
fn lane_of<S: Simd>([px, py]: [Lanes<S>; 2], [x, y]: [u32; 2], bits: u32) -> Option<usize> {
    let (mut columns, mut rows) = ([0.0; 16], [0.0; 16]);
    px.store(&mut columns);
    py.store(&mut rows);
    let is_it = |lane: &usize| columns[*lane].floor() == x as f32 && rows[*lane].floor() == y as f32;
    (0..16).filter(|lane| bits >> lane & 1 == 1).find(is_it)
}

/// A block of a run that is looked into.
pub(super) struct Block<S: Simd> {
    pub place: [Lanes<S>; 2],
    pub bits: u32,
    pub object: usize,
}

/// Runs the traced program of a block, if it is wanted; in place of the colour it may give the value.
pub(super) fn look<S: Simd>(
    programs: &Programs<'_>,
    program: &ObjectProgram<'_>,
    block: &Block<S>,
    fill: &mut dyn FnMut(&mut Machine<'_, 1>),
    out: &mut Shaded<S>,
) {
    let Some(inspection) = &programs.all.inspection else { return };
    let lane = match &inspection.wanted {
        Wanted::Pixel(pixel) => match lane_of(block.place, *pixel, block.bits) {
            Some(lane) => lane,
            None => return,
        },
        Wanted::Value { .. } => 0,
    };
    let Some(pair) = inspection.pair(program.number) else { return };
    let mut machine = Machine::<1>::of(program.traced(pair), &program.fragment_textures, programs.all.level)
        .with_rows_down();
    fill(&mut machine);
    let trace = machine.trace();
    match &inspection.wanted {
        Wanted::Pixel(_) => {
            let inspected = Inspected { object: block.object, lane, trace };
            *inspection.found.lock().unwrap_or_else(PoisonError::into_inner) = Some(inspected);
        }
        Wanted::Value { name, line } => {
            note_names(inspection, &trace);
            take_value(&trace, name, *line, out);
        }
    }
}

/// Remembers which values there are.
fn note_names(inspection: &Inspection<'_>, trace: &Trace) {
    let mut met = inspection.met.lock().unwrap_or_else(PoisonError::into_inner);
    for record in trace.records().iter().filter(|record| record.kind != RecordKind::Leave) {
        let line = record.place.as_ref().map_or(0, |place| place.line);
        met.entry((line, record.name.clone())).or_insert(record.words.len());
    }
}

/// The last value of that name and line of each pixel, as up to three numbers.
fn take_value<S: Simd>(trace: &Trace, name: &str, line: Option<u32>, out: &mut Shaded<S>) {
    let mut rows = [[NOT_REACHED; 16]; 3];
    let wanted = trace.records().iter().filter(|record| {
        let own = record.place.as_ref().map(|place| place.line);
        record.name == name && line.is_none_or(|line| own == Some(line))
    });
    for record in wanted {
        for lane in (0..16).filter(|lane| record.is_here(*lane)) {
            let values = record.values(lane);
            let last = values.len().saturating_sub(1);
            for (c, row) in rows.iter_mut().enumerate() {
                // A number is grey; of two numbers the third is 0.
                let value = if values.len() == 2 && c == 2 { 0.0 } else { values[c.min(last)] };
                // What is infinitely little is shown as the least number.
                row[lane] = if value == NOT_REACHED { f32::MIN } else { value };
            }
        }
    }
    let simd = out.alpha.0.simd;
    let zero = Lanes::splat(simd, 0.0);
    out.rgb = rows.each_ref().map(|row| Lanes::load(simd, row));
    out.alpha = zero.one();
    out.normal = Vec3::new(zero, zero, zero);
}
