//! Instructions whose results nobody reads.

use crate::lower::{Lowering, Reg, VirtualOp};
use crate::machine::Code;

impl Lowering<'_> {
    /// `kept`: registers that are read at the end.
    pub(super) fn remove_dead(&mut self, kept: &[Reg]) {
        let mut needed = vec![false; self.state.groups.len()];
        kept.iter().for_each(|r| needed[*r as usize] = true);
        let is_needed = |op: &VirtualOp, needed: &[bool]| {
            op.code.is_control() || (0..op.written()).any(|k| needed[(op.d + k) as usize])
        };
        // Loops carry values backwards, so until nothing is added.
        loop {
            let mut added = false;
            for op in self.state.prologue.iter().chain(&self.state.ops).rev() {
                if is_needed(op, &needed) {
                    for r in op.reads().chain(self.read_elsewhere(op)) {
                        added |= !std::mem::replace(&mut needed[r as usize], true);
                    }
                }
            }
            if !added {
                break;
            }
        }
        self.state.prologue.retain(|op| is_needed(op, &needed));
        let mut moved = vec![0u32; self.state.ops.len() + 1];
        for (i, op) in self.state.ops.iter().enumerate() {
            moved[i + 1] = moved[i] + u32::from(is_needed(op, &needed));
        }
        self.state.ops.retain(|op| is_needed(op, &needed));
        for op in &mut self.state.ops {
            if matches!(op.code, Code::Jump | Code::JumpAny | Code::JumpNone) {
                op.imm = moved[op.imm as usize];
            }
        }
        for (start, end) in &mut self.state.loops {
            (*start, *end) = (moved[*start] as usize, moved[*end] as usize);
        }
        for (at, _) in &mut self.state.counts {
            *at = moved[*at] as usize;
        }
    }
}
