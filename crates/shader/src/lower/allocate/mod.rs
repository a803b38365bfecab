//! From virtual registers to the file: products join sums, what nobody reads goes, intervals are packed.

mod dead;
mod fuse;
mod place;

use naga::Span;

use super::layout::Slot;
use super::{Event, Lowered, Lowering, Refused, Reg, VirtualOp};
use crate::machine::{Code, Op};

impl Lowering<'_> {
    /// Registers that are read beside the operands of instructions, by the looks and events among them.
    fn read_elsewhere(&self, op: &VirtualOp) -> Vec<Reg> {
        match op.code {
            Code::Texture => {
                self.state.looks.get(op.imm as usize).map(|look| look.reads()).unwrap_or_default()
            }
            Code::Note => {
                self.state.events.get(op.imm as usize).map_or_else(Vec::new, |event| {
                    event.registers.iter().chain(&event.mask).copied().collect()
                })
            }
            _ => Vec::new(),
        }
    }

    pub(super) fn allocate(
        mut self,
        inputs: Vec<Slot<Reg>>,
        outputs: Vec<Slot<Reg>>,
        discarded: Reg,
    ) -> Result<Lowered, Refused> {
        let mut kept: Vec<Reg> = outputs.iter().flat_map(|port| &port.registers).copied().collect();
        kept.push(discarded);
        self.fuse(&kept);
        self.remove_dead(&kept);
        let given: Vec<Reg> = inputs.iter().flat_map(|port| &port.registers).copied().collect();
        let (places, registers) = self.place(&given, &kept)?;
        let physical = |r: Reg| places[r as usize];
        let real = |op: &VirtualOp| {
            let operands = op.code.operands();
            let operand = |i: usize, r: Reg| if i < operands { physical(r) } else { r as u16 };
            let d = if op.written() > 0 { physical(op.d) } else { 0 };
            let (a, b, c) = (operand(0, op.a), operand(1, op.b), operand(2, op.c));
            Op { code: op.code, s: op.s, n: op.n, d, a, b, c, imm: op.imm }
        };
        let ports = |ports: Vec<Slot<Reg>>| {
            let real = |port: Slot<Reg>| Slot {
                name: port.name,
                builtin: port.builtin,
                ty: port.ty,
                location: port.location,
                registers: port.registers.into_iter().map(physical).collect(),
            };
            ports.into_iter().map(real).collect()
        };
        let discards = self.state.ops.iter().any(|op| op.written() > 0 && op.d == discarded)
            || self.state.prologue.iter().any(|op| op.d == discarded && (op.code, op.imm) != (Code::Imm, 0));
        let mut layout = std::mem::take(&mut self.layout);
        (layout.inputs, layout.outputs) = (ports(inputs), ports(outputs));
        Ok(Lowered {
            prologue: self.state.prologue.iter().map(real).collect(),
            ops: self.state.ops.iter().map(real).collect(),
            layout,
            discarded: discards.then(|| physical(discarded)),
            registers,
            looks: self.state.looks.iter().map(|look| look.map(physical)).collect(),
            events: self.state.events.iter().map(|event| physical_event(event, &physical)).collect(),
            loops: self.state.counts.iter().filter_map(|(at, span)| named_loop(*at, *span)).collect(),
        })
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
