//! From virtual registers to the file: products join sums, what nobody reads goes, intervals are packed.

mod dead;
mod fuse;
mod place;

use std::collections::BTreeMap;

use naga::Span;

use super::layout::Slot;
use super::{Event, Lowered, Lowering, Refused, Reg, State, VirtualOp};
use crate::machine::{Code, Look, Op};

/// A program before its registers have places: what a draw's [specialisation](crate::specialize) begins with.
#[derive(Clone, Debug, Default)]
pub(crate) struct Draft {
    pub(crate) state: State,
    /// Registers of the inputs and outputs, one per scalar.
    pub(crate) inputs: Vec<Vec<Reg>>,
    pub(crate) outputs: Vec<Vec<Reg>>,
    /// The mask of the lanes that are discarded.
    pub(crate) discarded: Reg,
}

/// A program that the machine runs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Placed {
    pub(crate) prologue: Vec<Op>,
    pub(crate) ops: Vec<Op>,
    /// Registers of the inputs and outputs, one per scalar.
    pub(crate) inputs: Vec<Vec<u16>>,
    pub(crate) outputs: Vec<Vec<u16>>,
    /// The mask of the lanes that are discarded, where any may be.
    pub(crate) discarded: Option<u16>,
    /// How many registers are used.
    pub(crate) registers: usize,
    pub(crate) looks: Vec<Look<u16>>,
    pub(crate) events: Vec<Event<u16>>,
    /// Instruction → span of the loop that counts there.
    pub(crate) loops: BTreeMap<usize, Span>,
}

impl State {
    /// Registers that are read beside the operands of instructions, by the looks and events among them.
    pub(crate) fn read_elsewhere(&self, op: &VirtualOp) -> Vec<Reg> {
        match op.code {
            Code::Texture => self.looks.get(op.imm as usize).map(|look| look.reads()).unwrap_or_default(),
            Code::Note => self
                .events
                .get(op.imm as usize)
                .map_or_else(Vec::new, |event| event.registers.iter().chain(&event.mask).copied().collect()),
            _ => Vec::new(),
        }
    }
}

impl Draft {
    /// Registers that are read at the end.
    pub(crate) fn kept(&self) -> Vec<Reg> {
        self.outputs.iter().flatten().chain([&self.discarded]).copied().collect()
    }

    /// Without what nobody reads.
    pub(crate) fn remove_dead(&mut self) {
        self.state.remove_dead(&self.kept());
    }

    /// With its registers in the file, and where each of them lies.
    pub(crate) fn place(mut self) -> Result<(Placed, Vec<u16>), Refused> {
        let kept = self.kept();
        self.state.fuse(&kept);
        self.state.remove_dead(&kept);
        let given: Vec<Reg> = self.inputs.iter().flatten().copied().collect();
        let (places, registers) = self.state.place(&given, &kept)?;
        let physical = |r: Reg| places[r as usize];
        let real = |op: &VirtualOp| {
            let operands = op.code.operands();
            let operand = |i: usize, r: Reg| if i < operands { physical(r) } else { r as u16 };
            let d = if op.written() > 0 { physical(op.d) } else { 0 };
            let (a, b, c) = (operand(0, op.a), operand(1, op.b), operand(2, op.c));
            Op { code: op.code, s: op.s, n: op.n, d, a, b, c, imm: op.imm }
        };
        let all = |ports: &[Vec<Reg>]| {
            ports.iter().map(|port| port.iter().map(|r| physical(*r)).collect()).collect()
        };
        let state = &self.state;
        let discarded = self.discarded;
        let is_zero = |op: &VirtualOp| op.d == discarded && (op.code, op.imm) == (Code::Imm, 0);
        let discards = !state.prologue.iter().any(is_zero);
        let placed = Placed {
            prologue: state.prologue.iter().map(real).collect(),
            ops: state.ops.iter().map(real).collect(),
            inputs: all(&self.inputs),
            outputs: all(&self.outputs),
            discarded: discards.then(|| physical(discarded)),
            registers,
            looks: state.looks.iter().map(|look| look.map(physical)).collect(),
            events: state.events.iter().map(|event| physical_event(event, &physical)).collect(),
            loops: state.counts.iter().filter_map(|(at, span)| named_loop(*at, *span)).collect(),
        };
        Ok((placed, places))
    }
}

impl Lowering<'_> {
    pub(super) fn allocate(
        mut self,
        inputs: Vec<Slot<Reg>>,
        outputs: Vec<Slot<Reg>>,
        discarded: Reg,
    ) -> Result<Lowered, Refused> {
        let registers =
            |ports: &[Slot<Reg>]| ports.iter().map(|port| port.registers.clone()).collect::<Vec<_>>();
        let State { prologue, ops, groups, loops, counts, looks, events, .. } = self.state;
        let state = State { prologue, ops, groups, loops, counts, looks, events, ..State::default() };
        let mut draft = Draft { state, inputs: registers(&inputs), outputs: registers(&outputs), discarded };
        draft.remove_dead();
        let (placed, places) = draft.clone().place()?;
        let ports = |ports: Vec<Slot<Reg>>| {
            ports.into_iter().map(|port| port.with_registers(|r| places[r as usize])).collect()
        };
        (self.layout.inputs, self.layout.outputs) = (ports(inputs), ports(outputs));
        // What a trace tells of must stay as it is.
        let draft = (!self.trace).then_some((draft, places));
        Ok(Lowered { placed, layout: self.layout, draft })
    }
}

fn named_loop(at: usize, span: Span) -> Option<(usize, Span)> {
    span.is_defined().then_some((at, span))
}

fn physical_event(event: &Event<Reg>, physical: &dyn Fn(Reg) -> u16) -> Event<u16> {
    Event {
        kind: event.kind,
        span: event.span,
        name: event.name.clone(),
        ty: event.ty,
        registers: event.registers.iter().map(|r| physical(*r)).collect(),
        mask: event.mask.map(physical),
    }
}
