//! What happened in a run, line by line.

use std::ops::Deref;
use std::sync::Arc;

use crate::lower::{Event, EventKind};
use crate::machine::Recorder;
use crate::{Place, RunError, Scalar, ValueType};

/// Most records; a shader with loops makes many.
const MOST_RECORDS: usize = 20_000;

/// What a [`Record`] tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RecordKind {
    /// A value got a name, or a variable (or a part of it) a value.
    Value,
    /// A condition: its value says which lanes take the branch.
    Branch,
    /// Lanes return, break, continue or are discarded.
    Leave,
}

/// What the source has that a run may tell of. A loop tells of it in every turn.
#[derive(Clone, Debug, PartialEq)]
pub struct TracePoint {
    /// What it tells.
    pub kind: RecordKind,
    /// Where in the source.
    pub place: Option<Place>,
    /// The variable, or `if`, `switch`, `return`, `break`, `continue`, `discard`.
    pub name: String,
    /// Type of the value.
    pub ty: ValueType,
}

/// One event of a run: that its [`TracePoint`] was passed, whose fields are there as if they were its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    point: Arc<TracePoint>,
    /// Words of the value, one row of 16 lanes per component.
    pub words: Vec<[u32; 16]>,
    /// Bit i: lane i was here.
    pub lanes: u16,
}

impl Deref for Record {
    type Target = TracePoint;

    fn deref(&self) -> &TracePoint {
        &self.point
    }
}

impl Record {
    /// The components of the value in a lane; truth values are 0 and 1.
    pub fn values(&self, lane: usize) -> Vec<f32> {
        self.words.iter().map(|row| crate::interface::number(row[lane & 15], self.ty.scalar)).collect()
    }

    /// Whether the lane was here.
    pub fn is_here(&self, lane: usize) -> bool {
        self.lanes >> (lane & 15) & 1 == 1
    }

    /// Of a branch: the lanes that took it.
    pub fn taken(&self) -> u16 {
        let Some(row) = self.words.first() else { return 0 };
        let taken = row.iter().enumerate().fold(0, |all, (lane, word)| all | u16::from(*word != 0) << lane);
        taken & self.lanes
    }

    /// The least and greatest number of the lanes that were here, NaN aside.
    pub fn extent(&self) -> Option<(f32, f32)> {
        let here = (0..16).filter(|lane| self.is_here(*lane)).flat_map(|lane| self.values(lane));
        here.filter(|x| !x.is_nan()).fold(None, |extent, x| {
            let (low, high) = extent.unwrap_or((x, x));
            Some((f32::min(low, x), f32::max(high, x)))
        })
    }

    /// The lanes that were here and in which a component is NaN.
    pub fn nan_lanes(&self) -> u16 {
        let nan = |lane: &usize| {
            self.ty.scalar == Scalar::Float
                && self.is_here(*lane)
                && self.values(*lane).iter().any(|x| x.is_nan())
        };
        (0..16).filter(nan).fold(0, |all, lane| all | 1 << lane)
    }
}

/// Every named value of a run of 16 lanes, with its line.
///
/// ```
/// use glanz_shader::{Machine, NoTextures, Row, Shader};
///
/// let program = Shader::fragment(
///     "#version 330
///      in float x;
///      out vec4 color;
///      void main() {
///          float root = sqrt(x);
///          color = vec4(root);
///      }",
/// )
/// .traced()
/// .compile()?;
/// let uniforms = program.uniforms();
/// let mut machine = Machine::<1>::new(&program, &uniforms, &NoTextures, Default::default());
/// machine.input(0, 0)[0] = Row::splat(-4.0);
/// let trace = machine.trace();
/// let root = trace.records().iter().find(|record| record.name == "root").expect("it is recorded");
/// assert!(root.values(0)[0].is_nan());
/// assert_eq!(trace.first_nan().and_then(|record| record.place.as_ref()).map(|place| place.line), Some(5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Trace {
    records: Vec<Record>,
    left_out: usize,
    end: Option<RunError>,
}

/// A point of the source with the registers that tell of it: those of its value, and of the mask of the lanes that are
/// there; all if there is none.
#[derive(Clone, Debug)]
pub(crate) struct PlacedPoint {
    point: Arc<TracePoint>,
    registers: Vec<u16>,
    mask: Option<u16>,
}

impl PlacedPoint {
    pub(crate) fn new(event: &Event<u16>, place: Option<Place>) -> Self {
        let kind = match event.kind {
            EventKind::Value => RecordKind::Value,
            EventKind::Branch => RecordKind::Branch,
            EventKind::Leave => RecordKind::Leave,
        };
        let point = TracePoint { kind, place, name: event.name.clone(), ty: event.ty };
        Self { point: Arc::new(point), registers: event.registers.clone(), mask: event.mask }
    }
}

/// What hears of a run's events.
pub(crate) struct TraceRecorder<'a> {
    points: &'a [PlacedPoint],
    trace: Trace,
}

impl<'a> TraceRecorder<'a> {
    pub(crate) fn new(points: &'a [PlacedPoint]) -> Self {
        let records = Vec::with_capacity(points.len());
        Self { points, trace: Trace { records, left_out: 0, end: None } }
    }

    /// The trace of a run that ended so.
    pub(crate) fn into_trace(self, end: Result<(), RunError>) -> Trace {
        Trace { end: end.err(), ..self.trace }
    }
}

impl Trace {
    /// What happened, in order; of loops turn by turn.
    pub fn records(&self) -> &[Record] {
        &self.records
    }

    /// How many records did not fit.
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// Why the run ended early, if it did.
    pub fn error(&self) -> Option<&RunError> {
        self.end.as_ref()
    }

    /// What happened to a lane.
    pub fn of_lane(&self, lane: usize) -> impl Iterator<Item = &Record> {
        self.records.iter().filter(move |record| record.is_here(lane))
    }

    /// The first value that is NaN or infinite in lane 0, if it was there.
    pub fn first_not_finite(&self) -> Option<&Record> {
        let is_wrong = |record: &&Record| {
            record.ty.scalar == Scalar::Float && record.values(0).iter().any(|x| !x.is_finite())
        };
        self.of_lane(0).find(is_wrong)
    }

    /// The first value that is NaN in a lane that was there.
    pub fn first_nan(&self) -> Option<&Record> {
        self.records.iter().find(|record| record.nan_lanes() != 0)
    }
}

impl Recorder for TraceRecorder<'_> {
    fn note<'a>(&mut self, event: usize, registers: &dyn Fn(u16) -> &'a [f32; 16]) {
        if self.trace.records.len() >= MOST_RECORDS {
            self.trace.left_out += 1;
            return;
        }
        let Some(PlacedPoint { point, registers: values, mask }) = self.points.get(event) else { return };
        let lanes = mask.map_or(u16::MAX, |mask| {
            let words = registers(mask).iter().enumerate();
            words.fold(0, |all, (lane, word)| all | u16::from(word.to_bits() != 0) << lane)
        });
        // A branch that no lane is in is run through where a jump is not worth it.
        if lanes == 0 {
            return;
        }
        let words = values.iter().map(|r| registers(*r).map(f32::to_bits)).collect();
        self.trace.records.push(Record { point: Arc::clone(point), words, lanes });
    }
}
